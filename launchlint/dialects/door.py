"""The door: which dialect a launch file is in, and what it starts in that."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.dialects.record import Dialect
from launchlint.dialects.ros1 import DIALECT as ROS1_DIALECT
from launchlint.model import ROS1, ROS2

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.dialects.record import Pairs
    from launchlint.evaluate.assemble import Evaluation
    from launchlint.evaluate.session import Session
    from launchlint.model import DialectName
    from launchlint.workspace.packages import Packages

_YAML_ENDS = (".yaml", ".yml")


def named(name: DialectName) -> Dialect:
    """The dialect of this name."""
    if name == ROS1:
        return ROS1_DIALECT
    from launchlint.dialects.ros2 import DIALECT

    return DIALECT


def dialect_of(session: Session, file: str) -> Dialect:
    """The dialect of an entry file: by its name, what stands in it, its package, and the environment. What it includes is in the same."""
    return named(_told(session, file))


def _told(session: Session, file: str) -> DialectName:
    if file.endswith((*_YAML_ENDS, ".py")):
        return ROS2
    data = session.read(file).data
    expected = _expected(session, file)
    if data is None:
        return expected or ROS1
    if not data[:3].removeprefix(b"\xef\xbb\xbf").startswith(b"<") and b"<launch" not in data:
        from launchlint.workspace.discovery import holds_python
        from launchlint.workspace.launch_root import has_launch_key

        if has_launch_key(data) or holds_python(file, data):
            return ROS2
    from launchlint.evaluate.session import Read
    from launchlint.syntax.dialect import OF_ROS1, told

    document = session.document(file)
    if isinstance(document, Read):
        return expected or ROS1
    from launchlint.workspace.other_ros import built_for_ros2

    of_ros2_only = expected == ROS2 and file.endswith(OF_ROS1) and built_for_ros2(file, session.packages) is not None
    return told(document, expected, only_where_equal=_is_built_for_both(file, session.packages), of_ros2_only=of_ros2_only)


def _expected(session: Session, file: str) -> DialectName | None:
    """The ROS that the package of ``file`` is built for, where that is one only; else what was asked for, or the environment says."""
    from launchlint.workspace.ros2_distributions import environment_is_for

    built_for = _built_for(file, session.packages)
    if built_for is not None:
        return built_for
    return ROS2 if session.asked_distro else environment_is_for(session.environment)


def _is_built_for_both(file: str, packages: Packages) -> bool:
    """Whether the package of ``file`` says so: then each of its launch files is for one of them, whatever this machine has."""
    package = packages.package_of(file)
    manifest = None if package is None else package.manifest
    return manifest is not None and manifest.is_catkin and any(each.startswith("ament") for each in manifest.build_types)


def _built_for(file: str, packages: Packages) -> DialectName | None:
    package = packages.package_of(file)
    manifest = None if package is None else package.manifest
    if manifest is None or _is_built_for_both(file, packages):
        return None
    if not manifest.build_types and "catkin" not in manifest.depends():
        return None  # it says nothing; that catkin would build it is no more than the default
    return ROS2 if manifest.is_ament else ROS1 if manifest.is_catkin else None


def evaluate(session: Session, file: str, given: Pairs = ()) -> Evaluation:
    """What its launcher would start for an entry file with the args ``given``. Never raises for anything the file holds."""
    return dialect_of(session, file).evaluate(session, file, given)


def configurations(session: Session, file: str, given: Pairs = ()) -> Iterator[Evaluation]:
    """As :func:`evaluate`, in every configuration that matters: first as given, then what shows something new."""
    return dialect_of(session, file).configurations(session, file, given)
