"""One program after another read from the sources of its package; each package is looked at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

from launchlint.extract.assembly import Workspace
from launchlint.extract.origin import Origin
from launchlint.extract.package_reader import PackageReader
from launchlint.extract.plan import reader_of
from launchlint.extract.reading import ProgramReader
from launchlint.extract.task import Task
from launchlint.knowledge.checked import checked
from launchlint.knowledge.entry import Key, Known, looks_at
from launchlint.model import ROS1, ROS2
from launchlint.workspace import looking
from launchlint.workspace.package import Package
from launchlint.workspace.reading import stand_ins, standing_in
from launchlint.workspace.states import States

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

T = TypeVar("T")


class SourceReader:
    """Reads programs of ``packages``; no source outside of ``limits`` (directories) is one."""

    def __init__(self, packages: Iterable[Package], limits: Iterable[str], states: States) -> None:
        listed = list(packages)
        self._workspace = Workspace(listed, limits)
        self._programs = ProgramReader({package.directory: package.name for package in listed})
        self._states = states
        self._readers: dict[str, tuple[PackageReader, looking.Looked]] = {}

    def read(self, key: Key, package: Package, root: str) -> Known:
        """What the sources of ``package`` say of a program of it. Never raises; paths are told relative to ``root``."""
        (program, reason), looked = _in_own_thread(lambda: looking.watched(lambda: self._read(key, package, root)))
        looking.note(looked)
        return Known(program, reason, looks_at(looked.all(), root, self._states))

    def _read(self, key: Key, package: Package, root: str) -> tuple[Mapping[str, Any] | None, str]:
        try:
            task = self._reader(package, root).one(key[1], key[2])
            if task is None:
                return None, "its package has no source of it"
            if not isinstance(task, Task):
                return None, task.reason
            found = self._programs.read(task)
        except Exception as error:  # a mistake of launchlint itself: one program must never take the run down
            return None, f"launchlint failed to read it: {type(error).__name__}: {error}"
        if found.program is None:
            return None, f"{task.sources[0][len(root) :].lstrip('/')} {found.problem}"
        return checked(found.program, key[1], ROS2 if task.is_of_ros2 else ROS1)

    def _reader(self, package: Package, root: str) -> PackageReader:
        if package.directory not in self._readers:
            origin = Origin(root, "", "", "", "")
            self._readers[package.directory] = looking.watched(lambda: reader_of(package, origin, self._workspace))
        reader, looked = self._readers[package.directory]
        looking.note(looked)
        return reader


def _in_own_thread(work: Callable[[], T]) -> T:
    """What ``work`` gives, called at the bottom of a stack: how deep it may go must not depend on who asks."""
    from threading import Thread

    results: list[T] = []
    texts = stand_ins()

    def run() -> None:
        with standing_in(texts):
            results.append(work())

    thread = Thread(target=run, daemon=True)
    thread.start()
    thread.join()
    return results[0]
