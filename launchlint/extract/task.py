"""What is to be read of packages, and what is not."""

from __future__ import annotations

from launchlint.extract.fact import Plugin
from launchlint.extract.origin import Origin
from launchlint.extract.template import Template
from launchlint.named_tuple import NamedTuple

_OF_ROS2 = frozenset(("rclpy", "rclcpp", "component", "container"))
"""The classes of programs of ROS 2."""


class Task(NamedTuple):
    """One program to be read: what a worker needs to know of it.

    ``kind`` is the table of the library that it belongs to, ``client`` its class there. ``entry`` is the class of a nodelet or
    component, or the function of a Python program that an entry point names; empty where it begins with ``main()``, or where its file does.
    ``parameters`` are the YAML files that generate_parameter_library makes classes of, for its package.
    ``plugins`` are the classes that it can load and whose sources are among its own; ``templates`` are those of its sources that the build
    fills in; ``packages`` those that its package depends on, and that are not here.
    """

    package: str
    directory: str
    kind: str
    name: str
    client: str
    sources: tuple[str, ...]
    entry: str
    includes: tuple[str, ...]
    origin: Origin
    doubts: tuple[str, ...]
    plugins: tuple[Plugin, ...] = ()
    templates: tuple[Template, ...] = ()
    packages: tuple[str, ...] = ()
    parameters: tuple[str, ...] = ()

    @property
    def is_of_ros2(self) -> bool:
        """Whether its package is one of ROS 2."""
        return self.client in _OF_ROS2


class Skipped(NamedTuple):
    """A program that is not read, and why. ``path`` is relative to the origin."""

    package: str
    name: str
    path: str
    reason: str
