"""What all evaluations of one run share: files read once, packages, the environment, and blocks worked out before.

Everything that is looked at outside of the program passes through here, so that the result cache knows what a result depends on.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from launchlint.evaluate.by_text import ByText
from launchlint.source import Source, Span
from launchlint.syntax.parse import parse
from launchlint.workspace.discovery import holds_python
from launchlint.workspace.looking import Looked, exists, note, watched
from launchlint.workspace.packages import Packages
from launchlint.workspace.ros2_distributions import Meant, distribution, set_up

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, TypeVar

    from launchlint.evaluate.block import Block, Effect
    from launchlint.evaluate.ros1.arg_uses import ArgUses
    from launchlint.evaluate.ros1.kept_values import KeptValues
    from launchlint.model import Argument
    from launchlint.syntax.ros2.live import LiveContext
    from launchlint.syntax.ros2.reading import Reading
    from launchlint.syntax.tree import Attribute, Document, Element

    Given = TypeVar("Given")
    Made = TypeVar("Made")

LARGEST_FILE = 64 * 1024 * 1024
"""Files of more bytes than this are not read: it bounds memory on hostile input."""
WRITTEN = "/tmp/launchlint_written_"  # only the beginning of names: nothing is written there
"""How the names of files begin that a launch would write, and that only a session holds."""


class Stopped(BaseException):
    """Nobody waits any more for what is being worked out; no mistake, so that nothing takes it for one."""


def _go_on() -> None:
    """Nobody ever gives up."""


class Read:
    """The outcome of reading one file: its ``data``, or the ``reason`` why there is none, in plain words."""

    __slots__ = ("_digest", "data", "reason")

    def __init__(self, data: bytes | None, reason: str) -> None:
        self.data = data
        self.reason = reason
        self._digest: str | None = None

    @property
    def digest(self) -> str:
        """Equal for equal outcomes: SHA-1 of the data in hexadecimal, or the reason why there is none."""
        if self._digest is None:
            from hashlib import sha1

            self._digest = self.reason if self.data is None else sha1(self.data, usedforsecurity=False).hexdigest()
        return self._digest


class Session:
    """One run over one set of workspaces.

    ``overlay`` maps the name of a file to content that is judged in its place (standard input, ``as:`` in an entries file, the git index).
    ``fresh``, which the evaluation of ROS 2 sets, gives the context of a launch in which nothing has been executed; ``arguments``, which
    it sets, too, are those that launch is given: programs may ask for its command line.
    ``checkpoint`` is called every now and then while something is evaluated: who gives up waiting for that lets it raise :class:`Stopped`.
    ``root`` is the directory to which shown paths are relative. ``distro`` is the distribution of ROS 2 that somebody asks for.
    """

    def __init__(
        self,
        packages: Packages,
        environment: Mapping[str, str],
        root: str | None = None,
        overlay: Mapping[str, bytes] | None = None,
        distro: str = "",
    ) -> None:
        self.packages = packages
        self.environment = environment
        self.root = os.getcwd() if root is None else root
        self.asked_distro = distro
        self.fresh: Callable[[Session, str], LiveContext] | None = None
        self.checkpoint: Callable[[], None] = _go_on
        self._meant: tuple[Meant, Looked] | None = None
        self.arguments: tuple[tuple[str, str], ...] = ()
        self._asking: set[str] = set()
        self._in_python: dict[tuple[str, tuple[tuple[str, str], ...]], tuple[Reading | None, Looked, frozenset[str]]] = {}
        self.overlay = {os.path.abspath(name): data for name, data in (overlay or {}).items()}
        self.blocks: dict[Any, Block] = {}
        self.variants: dict[Any, Block] = {}
        self.loaded: dict[str, Any] = {}
        self.by_text = ByText()
        self.settings: dict[Any, list[Effect]] = {}
        self.uses: dict[Document, ArgUses] = {}
        self.words: dict[Document, Mapping[str, frozenset[str]]] = {}
        self.deciding: dict[tuple[Document, Span, bool], frozenset[str] | None] = {}
        self.plain_arguments: dict[Element, Argument] = {}
        self.values: dict[Attribute, KeptValues] = {}
        self.sources: dict[str, Source] = {}
        self.touched: set[str] = set()
        self.variables: set[str] = set()
        self._reads: dict[str, Read] = {}
        self._documents: dict[str, Document | Read] = {}
        self._readings: dict[str, Reading | Read] = {}
        self._made: dict[tuple[int, object], tuple[object, Any]] = {}

    def with_text(self, file: str, data: bytes) -> Session:
        """A session in which ``file`` holds ``data``; see :meth:`with_texts`."""
        return self.with_texts({file: data})

    def with_texts(self, texts: Mapping[str, bytes | None]) -> Session:
        """A session in which files hold ``texts``, or again (None) what is on disk.

        What has been read of other files is shared, and blocks that were made without these. It may be made while another thread works
        with this one: what it shares is copied in one go each.
        """
        changed = {os.path.abspath(file): data for file, data in texts.items()}
        session = Session(self.packages, self.environment, self.root, distro=self.asked_distro)
        names = frozenset(changed)
        overlay = {**self.overlay, **changed}
        session.overlay = {name: data for name, data in overlay.items() if data is not None}
        session._meant = self._meant
        session._reads = {name: read for name, read in list(self._reads.items()) if name not in changed}
        session._documents = {name: known for name, known in list(self._documents.items()) if name not in changed}
        session._readings = {name: known for name, known in list(self._readings.items()) if name not in changed}
        session.blocks = {key: block for key, block in list(self.blocks.items()) if not block.is_made_of(names)}
        session.checkpoint = self.checkpoint
        return session

    def with_reading(self, file: str, reading: Reading) -> Session:
        """A session in which ``file`` describes something else than it does."""
        session = self.with_text(file, self.read(file).data or b"")
        session._readings[os.path.abspath(file)] = reading
        return session

    def begin_entry(self) -> None:
        """Forget which files and variables were looked at, and the blocks with other defaults than are written: a new entry file starts."""
        self.variants = {}
        self.touched = set()
        self.variables = set()

    def shown(self, file: str) -> str:
        """The path people see for ``file``: relative to the root where it lies inside, with ``/``."""
        absolute = os.path.abspath(file)
        inside = self.root.rstrip(os.sep) + os.sep
        path = absolute.removeprefix(inside)
        return path.replace(os.sep, "/")

    def named(self, shown: str) -> str:
        """The absolute name of the file that people see as ``shown``, as in :attr:`touched`."""
        return os.path.abspath(os.path.join(self.root, shown))

    def read(self, file: str) -> Read:
        """Read ``file`` once. Never raises: a missing, unreadable or too large file has a reason instead of data."""
        absolute = os.path.abspath(file) if file else ""
        self.touched.add(absolute)
        known = self._reads.get(absolute)
        if known is None:
            known = self._reads[absolute] = self._read(absolute, file)
        return known

    def write(self, data: bytes) -> str:
        """Keep what a launch would write to a file of its own, and where that is: on no disk, under a name that its content has."""
        from hashlib import sha256

        file = f"{WRITTEN}{sha256(data).hexdigest()[:16]}"
        self._reads[file] = Read(data, "")
        return file

    def _read(self, absolute: str, file: str) -> Read:
        if absolute in self.overlay:
            return Read(self.overlay[absolute], "")
        if not file or "\0" in file:
            return Read(None, "the file name is empty" if not file else "the file name holds a NUL character")
        try:
            if os.path.isdir(file):
                return Read(None, "it is a directory")
            if not os.path.isfile(file):
                dangling = os.path.islink(file)
                return Read(None, "it is a symbolic link to nothing" if dangling else "there is no such file")
            if os.path.getsize(file) > LARGEST_FILE:
                return Read(None, f"it is larger than {LARGEST_FILE // (1024 * 1024)} MiB")
            with open(file, "rb") as stream:
                return Read(stream.read(), "")
        except OSError as error:
            return Read(None, (error.strerror or "it cannot be read").lower())

    def exists(self, file: str) -> bool:
        """Whether ``file`` is a regular file that can be read."""
        return self.read(file).data is not None

    def placed(self, file: str) -> str:
        """What stands at ``file``, which lies in the sources of a package, if these are taken for what is installed of it.

        That is ``file`` where there is anything, else the file or directory of the package that is installed to this place, else ``file``.
        """
        if exists(file):
            return file
        from launchlint.workspace.ament.shares import installed_source

        return installed_source(self.packages, file) or file

    @property
    def distro(self) -> str:
        """The distribution of ROS 2 that launch files of it are read for."""
        return self.meant.name

    @property
    def named_by(self) -> str:
        """The file that names the distribution, as people see it; empty where it was not taken from one."""
        return self.shown(self.meant.file) if self.meant.file else ""

    @property
    def meant(self) -> Meant:
        """The distribution of ROS 2 that launch files of it are for, and where it was taken from."""
        if self._meant is None:
            self._meant = watched(lambda: distribution(self.asked_distro, self.environment, self._named_distributions))
        found, looked = self._meant
        note(looked)
        return found

    def _named_distributions(self) -> Mapping[str, str]:
        from launchlint.workspace.named_distributions import named_in

        return self.packages.answer(named_in, "")

    def document(self, file: str) -> Document | Read:
        """Parse ``file`` of ROS 1 once; the failed :class:`Read` where it cannot be read."""
        absolute = os.path.abspath(file) if file else ""
        self.touched.add(absolute)
        known = self._documents.get(absolute)
        if known is None:
            content = self.read(file)
            known = content if content.data is None else parse(content.data, self.shown(file), file)
            self._documents[absolute] = known
        return known

    def reading(self, file: str) -> Reading | Read:
        """Read ``file`` of ROS 2, in XML, YAML or Python, once; the failed :class:`Read` where it cannot be read."""
        absolute = os.path.abspath(file) if file else ""
        self.touched.add(absolute)
        known = self._readings.get(absolute) or self.in_python(file)
        if known is None:
            from launchlint.syntax.ros2.reading import read

            content = self.read(file)
            parsed = self._documents.get(absolute)
            parsed = None if isinstance(parsed, Read) else parsed
            known = content if content.data is None else read(content.data, self.shown(file), file, self.distro, parsed)
            self._readings[absolute] = known
        return known

    def in_python(self, file: str) -> Reading | None:
        """A launch file of ROS 2 that is a program, as far as what it describes can be told without running it; None where it is none."""
        if not file.endswith(".py") and not holds_python(file, self.read(file).data or b""):
            return None
        absolute = os.path.abspath(file)
        key = (absolute, self.arguments if absolute in self._asking else ())
        if key not in self._in_python:
            variables: set[str] = set()
            reading, looked = watched(lambda: self._understood(absolute, variables))
            key = (absolute, self.arguments if absolute in self._asking else ())
            self._in_python[key] = reading, looked, frozenset(variables)
        reading, looked, asked = self._in_python[key]
        note(looked)
        self.variables |= asked
        return reading

    def hangs_on_arguments(self, file: str) -> bool:
        """Whether a launch file in Python has looked at the command line: it describes something else when other args are given."""
        return os.path.abspath(file) in self._asking

    def _understood(self, file: str, variables: set[str]) -> Reading | None:
        """What a launch file in Python describes; the names of the ``variables`` that it asks for are added to these."""
        from launchlint.syntax.ros2.python.reading import read
        from launchlint.syntax.ros2.python.recogniser import Outside
        from launchlint.workspace.ament.shares import installed_source, may_be_installed

        content = self.read(file)
        if content.data is None:
            return None
        package = self.packages.package_of(file)
        colcon = self.packages.colcon

        def inside(path: str) -> bool:
            return self.packages.package_of(path) is not None

        def arguments() -> tuple[tuple[str, str], ...]:
            self._asking.add(file)
            return self.arguments

        outside = Outside(
            self.meant,
            lambda name: colcon.find(name, file),
            {**set_up(self.meant), **self.environment},
            variables.add,
            inside,
            lambda: self._fresh(file),
            arguments,
            lambda path: installed_source(self.packages, path),
            lambda path: bool(may_be_installed(self.packages, path)),
            self.shown,
        )
        return read(content.data, self.shown(file), file, outside, "" if package is None else package.directory)

    def _fresh(self, file: str) -> LiveContext | None:
        """The context of a launch in which nothing has been executed."""
        return None if self.fresh is None else self.fresh(self, file)

    def is_launch_file(self, file: str) -> bool:
        """Whether ``file`` has been read as a launch file of ROS 2 in XML or YAML."""
        return os.path.abspath(file) in self._readings

    def once(self, of: Given, work: Callable[[Given], Made]) -> Made:
        """What ``work`` makes of something that was read, and is kept for all evaluations."""
        known = self._made.get((id(of), work))
        if known is None:
            known = self._made[id(of), work] = (of, work(of))
        made: Made = known[1]
        return made

    def find_package(self, name: str, near: str) -> str | None:
        """Directory of package ``name`` as seen from the entry file ``near``; None where it is not here."""
        return self.packages.find(name, near)

    def ros2_variable(self, name: str) -> str | None:
        """Value of the environment variable ``name``, if it is set where launch files of ROS 2 are started."""
        found = self.variable(name)
        return set_up(self.meant).get(name) if found is None and name.startswith("ROS_") else found

    def variable(self, name: str) -> str | None:
        """Value of the environment variable ``name``, if it is set."""
        self.variables.add(name)
        return self.environment.get(name)
