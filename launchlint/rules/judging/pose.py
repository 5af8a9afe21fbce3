"""Where one frame is in another: as a static_transform_publisher is told, and as a URDF says."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, isfinite, sin

Pose = tuple[float, ...]
"""Place, and rotation as a quaternion: x y z qx qy qz qw."""

_NEAR = 1e-3
"""Metres, and radians: pi is often cut off after two places behind the point."""
_POSE, _QUATERNION = 6, 7


def pose_of_joint(origin: Sequence[str]) -> Pose | None:
    """The pose of a URDF joint: x y z roll pitch yaw (urdfdom, parsePose); None where it is not written in numbers."""
    numbers = _numbers(origin)
    return None if numbers is None or len(numbers) != _POSE else (*numbers[:3], *_quaternion(*numbers[3:]))


def pose_of_words(words: Sequence[str]) -> Pose | None:
    """The pose that a static_transform_publisher gets: x y z yaw pitch roll, or x y z qx qy qz qw; None for anything else."""
    numbers = _numbers(words)
    if numbers is None or len(numbers) not in (_POSE, _QUATERNION):
        return None
    if len(numbers) == _QUATERNION:
        return tuple(numbers)
    x, y, z, yaw, pitch, roll = numbers
    return (x, y, z, *_quaternion(roll, pitch, yaw))


def are_alike(one: Pose | None, other: Pose | None) -> bool:
    """Whether two poses are known and the same, but for the places behind the point that nobody sees."""
    if one is None or other is None:
        return False
    turned = 2 * (1 - abs(sum(a * b for a, b in zip(one[3:], other[3:], strict=True))))
    return all(abs(a - b) <= _NEAR for a, b in zip(one[:3], other[:3], strict=True)) and abs(turned) <= _NEAR**2


def _numbers(words: Sequence[str]) -> list[float] | None:
    try:
        found = [float(word) for word in words]
    except ValueError:
        return None
    return found if all(map(isfinite, found)) else None


def _quaternion(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """As tf2::Quaternion::setRPY."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(angle / 2), cos(angle / 2)) for angle in (roll, pitch, yaw))
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)
