"""Small workspaces of one package, evaluated: for the tests of what ROS 2 launch executes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from launchlint.evaluate.ros2.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.model import Launch, Node
from launchlint.workspace.packages import Packages

PACKAGE = "<package format='3'><name>pk</name><version>0.0.0</version><description>d</description></package>"
ENVIRONMENT = {"HOME": "/home/somebody", "USER": "somebody"}


class Workspace:
    """A package ``pk`` whose launch files are ``main`` (in a ``<launch>``) and those of ``others``, by their names."""

    def __init__(self, directory: Path, main: str, others: Mapping[str, str] | None = None) -> None:
        self.directory = directory
        self.launch_files = directory / "pk/launch"
        self.launch_files.mkdir(parents=True)
        (directory / "pk/package.xml").write_text(PACKAGE)
        for name, text in {"main.launch.xml": main, **(others or {})}.items():
            whole = f"<launch>{text}</launch>" if name.endswith(".xml") and not text.startswith("<launch") else text
            (self.launch_files / name).parent.mkdir(parents=True, exist_ok=True)
            (self.launch_files / name).write_text(whole)

    def session(self, distro: str = "jazzy", environment: Mapping[str, str] | None = None) -> Session:
        variables = ENVIRONMENT if environment is None else environment
        return Session(Packages([str(self.directory)], variables, explicit=True), variables, str(self.directory), distro=distro)

    def launch(self, *given: str, distro: str = "jazzy", environment: Mapping[str, str] | None = None) -> Launch:
        pairs = tuple((name, value) for name, _, value in (each.partition(":=") for each in given))
        return evaluate(self.session(distro, environment), str(self.launch_files / "main.launch.xml"), pairs).launch


def loaded(launch: Launch) -> Launch:
    """The launch, which must not be refused."""
    assert launch.refused is None, launch.refused
    return launch


def refusal(launch: Launch) -> str:
    """The kind of problem for which launch refuses the file, and where it is."""
    assert launch.refused is not None
    place = launch.refused.place
    return f"{launch.refused.kind} {place.source.path.rpartition('/')[2]}:{place.source.position(place.span.start).line}"


def named(launch: Launch) -> list[str]:
    """The nodes by their names, with the namespace where launch gives one."""
    return [node.full_name if node.has_namespace else node.name for node in launch.nodes]


def only(launch: Launch) -> Node:
    """The one node."""
    (node,) = loaded(launch).nodes
    return node
