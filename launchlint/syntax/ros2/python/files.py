"""Files that a launch file opens: those below the workspace are read, through the room that looks at the disk; nothing is written."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from launchlint.model import StandIn
from launchlint.python.failures import Raised, failure
from launchlint.python.plain import LARGEST_TEXT, NotPlain, plain, value_of
from launchlint.python.values import MISSING, UNKNOWN, External, Failure, Handle, Map, Seq, Unknown, Value
from launchlint.source import Place
from launchlint.syntax.ros2.python.paths import Paths, spelled
from launchlint.workspace import looking
from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.python.following import Following

FILE, XACRO = "file", "xacro"
_TEMPORARY = ("tempfile.NamedTemporaryFile", "tempfile.TemporaryFile", "tempfile.mkstemp")
_LOADING = ("yaml.safe_load", "yaml.load", "yaml.full_load", "yaml.unsafe_load")


class Files:
    """What one launch file asks of files. ``stand_in`` makes a string of what is known and not worked out."""

    def __init__(self, run: Following, paths: Paths, load: Callable[[str], Any], stand_in: Callable[[StandIn], Value]) -> None:
        self._run = run
        self._paths = paths
        self._load = load
        self._stand_in = stand_in
        self._loaded: dict[str, Any] = {}

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], place: Place) -> Value:
        """What a function that opens or reads files gives; MISSING for all others."""
        first = positional[0] if positional else UNKNOWN
        if name in ("builtins.open", "io.open"):
            mode = positional[1] if len(positional) > 1 else keywords.get("mode", "r")
            return self.opened(positional[0] if positional else keywords.get("file", UNKNOWN), mode)
        if name in _LOADING:
            return self._of_yaml(first if positional else keywords.get("stream", UNKNOWN))
        if name in ("json.load", "json.loads"):
            return self._of_json(self._text(first))
        if name == "json.dumps" and not keywords.keys() - {"indent"}:
            try:
                return value_of(json.dumps(plain(first), **{key: plain(value) for key, value in keywords.items()}))
            except (NotPlain, TypeError, ValueError):
                return UNKNOWN
        if name in _TEMPORARY:
            return Handle(FILE, {"text": MISSING, "name": Unknown("it is a file that is made when it is run", place)})
        if name in ("xacro.process_file", "xacro.process"):
            return self._xacro(name, positional, keywords)
        return MISSING

    def opened(self, file: Value, mode: Value = "r") -> Handle:
        """``open(file, mode)``. Raises Raised where there is no such file."""
        file = spelled(file)
        if not isinstance(mode, str) or any(each in mode for each in "wax+"):
            return Handle(FILE, {"text": MISSING, "name": file})
        where = self._paths.within(file)
        if where is None:
            self._run.risks += 1
            return Handle(FILE, {"text": MISSING, "name": file})
        if not looking.is_file(where):
            if self._paths.may_be_built(where):
                self._run.risks += 1
                return Handle(FILE, {"text": MISSING, "name": file})
            raise failure(
                "IsADirectoryError" if looking.is_directory(where) else "FileNotFoundError", f"No such file or directory: {file!r}"
            )
        data = looking.content(where)
        if data is None or "b" in mode or len(data) > LARGEST_TEXT:
            return Handle(FILE, {"text": MISSING, "name": file})
        self._run.spend(len(data) // 16)
        return Handle(FILE, {"text": data.decode("utf-8", "replace").replace("\r\n", "\n"), "name": file})

    def method(self, receiver: Handle, name: str, given: list[Value]) -> Value:
        """A method of an open file, or of what xacro makes; MISSING where nothing is known of it."""
        if receiver.kind == XACRO:
            return receiver.state["text"] if name in ("toxml", "toprettyxml") else MISSING
        text = receiver.state["text"]
        if name in ("close", "write", "flush", "writelines", "seek"):
            return None
        if text is MISSING:
            return self._run.unknown() if name in ("read", "readlines", "readline") else MISSING
        if name == "read" and not given:
            self._run.store(receiver.state, "text", "")
            return text
        if name == "readlines" and not given:
            self._run.store(receiver.state, "text", "")
            return Seq(list(text.splitlines(keepends=True)))
        return MISSING

    def lines(self, receiver: Handle) -> tuple[list[Value], bool]:
        """What a loop over an open file takes."""
        text = receiver.state["text"]
        if not isinstance(text, str):
            self._run.risks += 1
            return [UNKNOWN], False
        self._run.store(receiver.state, "text", "")
        return list(text.splitlines(keepends=True)), True

    def _text(self, stream: Value) -> Value:
        if isinstance(stream, Handle) and stream.kind == FILE:
            text = stream.state["text"]
            return UNKNOWN if text is MISSING else text
        return stream

    def _of_yaml(self, stream: Value) -> Value:
        text = self._text(stream)
        if not isinstance(text, str):
            return self._run.unknown()
        self._run.spend(len(text) // 4)
        try:
            if text not in self._loaded:
                self._loaded[text] = self._load(text)
            return value_of(self._loaded[text])
        except YamlError as error:
            raise Raised(Failure(External("yaml.YAMLError"), (error.message,))) from None
        except (YamlBeyond, NotPlain):
            return self._run.unknown()

    def _of_json(self, text: Value) -> Value:
        if not isinstance(text, str):
            return self._run.unknown()
        try:
            return value_of(json.loads(text))
        except NotPlain:
            return self._run.unknown()
        except (ValueError, RecursionError) as error:
            raise Raised(Failure(External("json.JSONDecodeError"), (str(error),))) from None

    def _xacro(self, name: str, positional: list[Value], keywords: dict[str, Value]) -> Value:
        """Known, and not run."""
        file = spelled(positional[0] if positional else keywords.get("input_file_name", UNKNOWN))
        where = self._paths.within(file)
        if where is not None and not looking.is_file(where):
            raise failure("FileNotFoundError", f"No such file or directory: {file!r}")
        if not isinstance(file, str):
            return self._run.unknown()
        mappings = keywords.get("mappings", positional[1] if len(positional) > 1 else None)
        words = (
            [f"{key}:={value if isinstance(value, str) else '?'}" for key, value in mappings.entries.items()]
            if isinstance(mappings, Map)
            else []
        )
        text = self._stand_in(StandIn(f"$(xacro {' '.join([file, *words])})", "it is what xacro makes of a file, which is not run"))
        return text if name == "xacro.process" else Handle(XACRO, {"text": text})
