"""Paths: ``os.path`` and ``pathlib`` as far as they look at nothing, and what there is below the workspace."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping

from launchlint.python.failures import failure
from launchlint.python.plain import NotPlain, plain, value_of
from launchlint.python.values import MISSING, UNKNOWN, Choice, Handle, Map, Seq, Value
from launchlint.syntax.ros2.python.directories import fitting, split
from launchlint.workspace import looking

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.python.following import Following

PATH = "Path"
LONGEST = 4096
_PURE = ("basename", "dirname", "normpath", "split", "splitext", "isabs", "commonpath", "commonprefix", "relpath")


def path(text: str) -> Handle:
    """A ``pathlib.Path``."""
    return Handle(PATH, {"text": text})


def is_path(value: Value) -> bool:
    """Whether a value is a ``pathlib.Path``."""
    return isinstance(value, Handle) and value.kind == PATH


def spelled(value: Value) -> Value:
    """The string that a path is; anything else as it is (os.fspath)."""
    return value.state["text"] if is_path(value) else value


class Paths:
    """What one launch file asks of paths.

    ``inside`` says whether one lies in the workspace, ``installed`` which file a build puts there, if that is known, and ``may_be_built``
    whether one may, whatever it is.
    """

    def __init__(
        self,
        run: Following,
        inside: Callable[[str], bool],
        environment: Map,
        installed: Callable[[str], str | None],
        may_be_built: Callable[[str], bool],
    ) -> None:
        self._run = run
        self._inside = inside
        self._environment = environment
        self._installed = installed
        self.may_be_built = may_be_built

    def within(self, file: Value) -> str | None:
        """A path below the workspace; None for all others, and what is not known."""
        if not isinstance(file, str) or not file.startswith("/") or "\0" in file or len(file) > LONGEST:
            return None
        file = posixpath.normpath(file)
        if not self._inside(file):
            return None
        return file if looking.exists(file) else self._installed(file) or file

    def of_os(self, name: str, given: list[Value]) -> Value:
        """A function of ``os.path``; MISSING where another one may know of it."""
        given = [spelled(each) for each in given]
        if any(isinstance(each, Choice) for each in given):
            return MISSING
        first = given[0] if given else UNKNOWN
        if name in _PURE or (name == "join" and all(isinstance(each, str) for each in given)):
            try:
                words = [plain(each) for each in given]
                if name == "relpath" and (len(words) < 2 or not all(each.startswith("/") for each in words)):
                    return UNKNOWN
                return value_of(getattr(posixpath, name)(*words))
            except NotPlain:
                return MISSING
            except (TypeError, ValueError, AttributeError) as error:
                raise failure(type(error).__name__, str(error)) from None
        if name in ("abspath", "realpath") and isinstance(first, str):
            return posixpath.normpath(first) if first.startswith("/") else UNKNOWN
        if name in ("expanduser", "expandvars") and isinstance(first, str):
            return self._expanded(first) if name == "expanduser" else (first if "$" not in first else UNKNOWN)
        if name in ("exists", "isfile", "isdir", "lexists"):
            return self.there(first, name)
        return MISSING

    def _expanded(self, text: str) -> Value:
        if not text.startswith("~"):
            return text
        home = self._environment.entries.get("HOME")
        return home.rstrip("/") + text[1:] if isinstance(home, str) and text[1:2] in ("", "/") else UNKNOWN

    def there(self, file: Value, name: str) -> Value:
        """Whether there is a file or directory at a path below the workspace."""
        where = self.within(file)
        if where is None:
            return self._run.unknown()
        look = {"isfile": looking.is_file, "isdir": looking.is_directory}.get(name, looking.exists)
        return look(where)

    def listed(self, directory: Value) -> Value:
        """``os.listdir``: the order is nobody's."""
        where = self.within(spelled(directory))
        if where is None:
            return self._run.unknown()
        if not looking.is_directory(where):
            raise failure("FileNotFoundError", 2, "No such file or directory")
        return _in_any_order(sorted(looking.names(where)))

    def globbed(self, pattern: Value, keywords: Mapping[str, Value]) -> Value:
        """``glob.glob``; MISSING where it is not known."""
        pattern = spelled(pattern)
        recursive = keywords.get("recursive", False)
        if not isinstance(pattern, str) or not isinstance(recursive, bool) or keywords.keys() - {"recursive"}:
            return MISSING
        directory, rest = split(pattern)
        if not directory:
            there = self.there(pattern, "exists")
            return Seq([pattern] if there else []) if isinstance(there, bool) else MISSING
        where = self.within(directory)
        found = None if where is None or ".." in rest else fitting(where, rest, hidden=False, recursive=recursive)
        return MISSING if found is None else _in_any_order(list(found))

    def _below(self, text: str, pattern: Value, *, recursive: bool) -> Value:
        """``path.glob`` and ``path.iterdir``; MISSING where it is not known."""
        where = self.within(text)
        if where is None or not isinstance(pattern, str) or not pattern or pattern.startswith("/") or ".." in pattern:
            return MISSING
        found = fitting(where, f"**/{pattern}" if recursive else pattern, hidden=True, recursive=True)
        return MISSING if found is None else _in_any_order([path(each) for each in found if each != where], "iterator")

    # -- pathlib ------------------------------------------------------------------------------------------------------

    def made(self, given: list[Value]) -> Value:
        """``Path(…)``."""
        words = [spelled(each) for each in given]
        if not all(isinstance(each, str) for each in words):
            return MISSING
        return path(_clean(posixpath.join("", *words)))

    def attribute(self, receiver: Handle, name: str) -> Value:
        """An attribute of a path; MISSING for a method."""
        text: str = receiver.state["text"]
        if name == "parent":
            return path(posixpath.dirname(text) or (text if text.startswith("/") else "."))
        if name in ("name", "stem", "suffix"):
            last = posixpath.basename(text) if text != "." else ""
            stem, suffix = posixpath.splitext(last)
            return {"name": last, "stem": stem, "suffix": suffix}[name]
        if name == "parents":
            found = []
            while text not in ("/", "", "."):
                text = posixpath.dirname(text)
                found.append(path(text or "."))
            return Seq(list(found), is_tuple=True)
        if name == "parts":
            return Seq([*(["/"] if text.startswith("/") else []), *(each for each in text.split("/") if each)], is_tuple=True)
        return MISSING

    def method(self, receiver: Handle, name: str, given: list[Value]) -> Value:
        """The value of a call of a method of a path; MISSING where nothing is known of it."""
        text: str = receiver.state["text"]
        words = [spelled(each) for each in given]
        if not all(isinstance(each, (str, Seq, Map)) for each in words):
            return MISSING
        if name in ("joinpath", "__truediv__") and all(isinstance(each, str) for each in words):
            return path(_clean(posixpath.join(text, *words)))
        if name in ("as_posix", "__str__", "__fspath__"):
            return text
        if name in ("resolve", "absolute"):
            return path(posixpath.normpath(text)) if text.startswith("/") else MISSING
        if name == "expanduser":
            made = self._expanded(text)
            return path(made) if isinstance(made, str) else MISSING
        if name == "is_absolute":
            return text.startswith("/")
        if name in ("glob", "rglob") and len(words) == 1:
            return self._below(text, words[0], recursive=name == "rglob")
        if name == "iterdir" and not words:
            where = self.within(text)
            if where is not None and not looking.is_directory(where):
                raise failure("FileNotFoundError", f"No such file or directory: {text!r}")
            return self._below(text, "*", recursive=False)
        if name == "is_relative_to" and len(words) == 1 and isinstance(words[0], str):
            return text == words[0] or text.startswith(words[0].rstrip("/") + "/")
        if name in ("exists", "is_file", "is_dir"):
            return self.there(text, {"is_file": "isfile", "is_dir": "isdir"}.get(name, name))
        if name == "with_suffix" and len(words) == 1 and isinstance(words[0], str):
            return path(posixpath.splitext(text)[0] + words[0])
        if name == "with_name" and len(words) == 1 and isinstance(words[0], str):
            return path(posixpath.join(posixpath.dirname(text), words[0]))
        return MISSING


def _in_any_order(items: list[Value], kind: str = "list") -> Seq:
    """What the machine lists: in an order that is nobody's."""
    return Seq(items, kind=kind if len(items) < 2 else "listing")


def _clean(text: str) -> str:
    """As pathlib spells it: no double slashes, no single points; double points stay."""
    parts = [each for each in text.split("/") if each not in ("", ".")]
    return ("/" if text.startswith("/") else "") + "/".join(parts) or "."
