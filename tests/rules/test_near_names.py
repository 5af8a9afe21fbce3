"""Which names on the graph may have been meant for each other."""

from __future__ import annotations

import pytest

from launchlint.rules.judging.near_names import NAMESPACE, SIBLING, SLIP, TWIN, WORDS, relation


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        ("/scan", "/scan", ""),
        ("/scan", "/front/scan", NAMESPACE),
        ("/a/b/scan", "/a/scan", NAMESPACE),
        ("/a/scan", "/b/a/scan", NAMESPACE),
        ("/front_laser/scan", "/rear_laser/scan", SIBLING),
        ("/front/scan", "/frnt/scan", SLIP),
        ("/cmd_vel", "/cmd_ve", SLIP),
        ("/cmd_vel", "/cmd-vel", SLIP),
        ("/odom", "/Odom", SLIP),
        ("/tf", "/rf", TWIN),
        ("/robot1/scan", "/robot2/scan", TWIN),
        ("/camera1/image", "/camera/image", TWIN),
        ("/robot1/cmd_vel/nav", "/robot2/cmd_vel", TWIN),
        ("/robot1/cmd_vel/nav", "/arm/cmd_vel", ""),
        ("/pos_x", "/pos_y", TWIN),
        ("/camera_l/image", "/camera_r/image", TWIN),
        ("/radius_cmd_vel", "/turtle1/cmd_vel", WORDS),
        ("/cmd_vel_radius", "/cmd_vel", WORDS),
        ("/image_raw", "/image", WORDS),
        ("/from_can_bus", "/to_can_bus", TWIN),
        ("/can/rx", "/can/tx", TWIN),
        ("/fmu/in/vehicle_odometry", "/fmu/out/vehicle_odometry", TWIN),
        ("/fmu/in/visual_odometry", "/fmu/out/vehicle_odometry", TWIN),
        ("/input/scan", "/output/scan", TWIN),
        ("/fmu/in/odometry", "/imu/out/odometry", SIBLING),
        ("/from_base", "/to_arm", ""),
        ("/a/image_raw", "/b/image", ""),
        ("/my_cmd_vel", "/cmd_vel_mux", ""),
        ("/odom", "/scan", ""),
    ],
)
def test_relation(left: str, right: str, expected: str) -> None:
    assert relation(left, right) == expected
    assert relation(right, left) == expected
