"""Lines of JSON from the program beside the nodes → records. Whatever runs in the container can write them: none is believed before it
is checked.

What a record may hold is written here as data; everything else is dropped, cut or refused.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping

from launchlint.library.format import CATEGORIES, FORMAT, VERSION, VERSION_2
from launchlint.library.validate import faults
from launchlint.model import ROS1, ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.probe.words import is_a, is_package, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MOST_ENTRIES = 5_000
"""Names of one kind in one record."""
MOST_PROBLEMS = 20
LONGEST_DETAIL = 300
STATUSES = ("ok", "failed", "not-a-node")
PROGRAMS: Mapping[str, str] = {
    "roscpp": ROS1,
    "rospy": ROS1,
    "nodelet": ROS1,
    "rclcpp": ROS2,
    "rclpy": ROS2,
    "component": ROS2,
    "none": ROS1,
}
"""Kinds of programs, and the middleware by whose format their interface is checked; what is no node has none."""
LOADED = ("nodelet", "component")
"""Those that are classes."""
TRAITS = ("node", "namespace", "lifecycle", "undeclared")
"""Keys of a variant that a record may have besides its interface."""
RESULTS = ("ok", "partial", "failed")

_CODE = re.compile(r"[a-z][a-z-]{0,39}")
_HASH = re.compile(r"[0-9a-f]{8,64}")
_TYPE = re.compile(r"[A-Za-z]\w{0,99}/[A-Za-z]\w{0,99}", re.ASCII)
_MD5 = re.compile(r"[0-9a-f]{32}")
_CLASS = re.compile(r"[A-Za-z_]\w{0,199}(?:(?:/|::)\w{1,199}){0,5}", re.ASCII)


class Problem(NamedTuple):
    """Why a node did not run, or not wholly: a code for programs, and words for people."""

    code: str
    detail: str


class NodeRecord(NamedTuple):
    """One run of one program. ``interface`` is a variant of the library format without evidence, ``traits`` are its other keys; ``line``
    is the record as one line of JSON.
    ``hash`` changes with whatever may change the result of a run, ``digest`` with the program's file.
    """

    label: str
    package: str
    name: str
    program: str
    variant: str
    hash: str
    digest: str
    status: str
    interface: Mapping[str, Any]
    traits: Mapping[str, Any]
    messages: Mapping[str, Mapping[str, str]]
    problems: tuple[Problem, ...]
    seconds: float
    left: int
    line: str


class LaunchRecord(NamedTuple):
    """One run of a launch file: its nodes with what they publish, subscribe and serve, and the params that are set."""

    label: str
    package: str
    file: str
    args: Mapping[str, str]
    hash: str
    status: str
    nodes: tuple[Mapping[str, Any], ...]
    params: tuple[str, ...]
    problems: tuple[Problem, ...]
    seconds: float
    left: int
    line: str


class Note(NamedTuple):
    """Any other record: ``kind`` is environment, build, dependency, package, unknown, plan, start or end; ``facts`` are checked texts
    and numbers.
    """

    kind: str
    facts: Mapping[str, Any]


Record = NodeRecord | LaunchRecord | Note


class Refused(Exception):
    """A line is no record; ``str(error)`` says why."""


def parse(line: str) -> Record:
    """The record in a line.

    Raises:
        Refused: it is none.
    """
    try:
        data = json.loads(line, parse_constant=_no_number, parse_int=_whole)
    except (ValueError, RecursionError) as error:
        raise Refused("it is no JSON") from error
    if not isinstance(data, dict):
        raise Refused("it is no mapping")
    kind = data.get("kind")
    if kind == "node":
        return _node(data)
    if kind == "launch":
        return _launch(data)
    known = _NOTES.get(kind) if isinstance(kind, str) else None
    if known is None:
        raise Refused("it is of no known kind")
    return Note(str(kind), {key: read(data.get(key)) for key, read in known.items()})


def _whole(word: str) -> int:
    if len(word) > 20:
        raise ValueError(word[:20])
    return int(word)


def _no_number(word: str) -> float:
    raise ValueError(word)


def _text(value: Any) -> str:
    return plain(value, LONGEST_DETAIL) if isinstance(value, str) else ""


def _count(value: Any) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 10**9 else 0


def _texts(value: Any) -> list[str]:
    return [_text(each) for each in value[:MOST_PROBLEMS]] if isinstance(value, list) else []


def _package(value: Any) -> str:
    if not isinstance(value, str) or not is_package(value):
        raise Refused("its package has a name that no package can have")
    return value


def _result(value: Any) -> str:
    return value if value in RESULTS else "failed"


def _hash(value: Any) -> str:
    return value if isinstance(value, str) and _HASH.fullmatch(value) else ""


def _middleware(value: Any) -> str:
    return ROS2 if value == ROS2 else ROS1


def _frame(value: Any) -> dict[str, Any]:
    """What names a run; it is checked when a record is made of it."""
    return value if isinstance(value, dict) else {}


_NOTES: Mapping[str, Mapping[str, Any]] = {
    "environment": {"distro": _text, "base": _text, "middleware": _middleware},
    "build": {"package": _package, "result": _result, "errors": _texts, "log": _texts},
    "dependency": {"name": _text, "needed_by": _texts, "detail": _text},
    "package": {"package": _package, "status": _text, "version": _text},
    "unknown": {"label": _text},
    "plan": {"count": _count, "all": _count},
    "start": {"label": _text, "hash": _hash, "frame": _frame},
    "end": {"left": _count},
}


def _node(data: Mapping[str, Any]) -> NodeRecord:
    package, name, program, variant = _package(data.get("package")), data.get("name"), data.get("program"), data.get("variant")
    if not isinstance(program, str) or program not in PROGRAMS:
        raise Refused("its program is of no known kind")
    if not isinstance(name, str) or not (_CLASS.fullmatch(name) if program in LOADED else is_a("file", name)):
        raise Refused("its program has a name that no program can have")
    if not isinstance(variant, str) or not is_a("variant", variant):
        raise Refused("its variant has a name that no variant can have")
    interface, odd = _interface(data.get("interface"), PROGRAMS[program])
    traits = _traits(data.get("traits"), PROGRAMS[program])
    problems = _problems(data.get("problems"))
    if odd:
        problems = (*problems, Problem("odd-names", f"{odd} names that no node can have were left out"))
    status = _status(data)
    label = name if program in LOADED else f"{package}/{name}"
    record = NodeRecord(
        label,
        package,
        name,
        program,
        variant,
        _hash(data.get("hash")),
        _hash(data.get("digest")),
        status,
        interface,
        traits,
        _messages(data.get("messages")),
        problems,
        _seconds(data),
        _left(data),
        "",
    )
    return record._replace(line=_line("node", record))


def _status(data: Mapping[str, Any]) -> str:
    status = data.get("status")
    if status not in STATUSES:
        raise Refused("its status is none that there is")
    return str(status)


def _seconds(data: Mapping[str, Any]) -> float:
    value = data.get("seconds")
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value < 10**6 else 0.0


def _left(data: Mapping[str, Any]) -> int:
    value = data.get("left")
    return len(value) if isinstance(value, list) else _count(value)


def _problems(value: Any) -> tuple[Problem, ...]:
    found = []
    for each in value[:MOST_PROBLEMS] if isinstance(value, list) else ():
        code = each.get("code") if isinstance(each, dict) else None
        if isinstance(code, str) and _CODE.fullmatch(code):
            found.append(Problem(code, _text(each.get("detail"))))
    return tuple(found)


def _interface(value: Any, middleware: str) -> tuple[dict[str, Any], int]:
    """The interface as far as the library format allows it, and how many entries it does not."""
    if not isinstance(value, dict):
        return {}, 0
    kept: dict[str, Any] = {}
    odd = 0
    for category in CATEGORIES:
        entries = value.get(category, [])
        if not isinstance(entries, list):
            continue
        plain_entries = [{key: item for key, item in entry.items() if key != "evidence"} for entry in entries if isinstance(entry, dict)]
        good = [entry for entry in plain_entries[:MOST_ENTRIES] if not _is_odd({category: [entry]}, middleware)]
        odd += len(entries) - len(good)
        if good:
            kept[category] = good
    return kept, odd


def _traits(value: Any, middleware: str) -> dict[str, Any]:
    known = value if isinstance(value, dict) else {}
    return {key: known[key] for key in TRAITS if key in known and not _is_odd({key: known[key]}, middleware)}


def _is_odd(variant: Mapping[str, Any], middleware: str = ROS1) -> bool:
    package = {"executables": {"e": {"variants": {"default": variant}}}}
    if middleware == ROS2:
        return bool(faults({"format": FORMAT, "version": VERSION_2, "packages": {"p": {"middleware": ROS2, **package}}}))
    return bool(faults({"format": FORMAT, "version": VERSION, "packages": {"p": package}}))


def _messages(value: Any) -> dict[str, dict[str, str]]:
    found = {}
    for kind, message in list(value.items())[:MOST_ENTRIES] if isinstance(value, dict) else ():
        md5 = message.get("md5") if isinstance(message, dict) else None
        text = message.get("text") if isinstance(message, dict) else None
        if _TYPE.fullmatch(kind) and isinstance(md5, str) and _MD5.fullmatch(md5):
            known = {"md5": md5}
            if isinstance(text, str) and len(text) < 50_000:
                known["text"] = "".join(character for character in text if character.isprintable() or character == "\n")
            found[kind] = known
    return found


def _launch(data: Mapping[str, Any]) -> LaunchRecord:
    package, file = _package(data.get("package")), data.get("file")
    if not isinstance(file, str) or not is_a("launch", f"{package}/{file}"):
        raise Refused("its file has a name that no launch file can have")
    given = data.get("args")
    args = {key: _text(value) for key, value in given.items() if is_a("arg", key)} if isinstance(given, dict) else {}
    found = data.get("interface")
    seen: Mapping[str, Any] = found if isinstance(found, dict) else {}
    nodes = []
    listed = seen.get("nodes")
    for node in listed[:MOST_ENTRIES] if isinstance(listed, list) else ():
        if not isinstance(node, dict) or _is_odd({"services": [{"name": node.get("name")}]}):
            continue
        interface, _ = _interface({key: node.get(key, []) for key in ("publishers", "subscribers", "services")}, ROS1)
        nodes.append({"name": node["name"], **interface})
    names = seen.get("params")
    params = tuple(name for name in names[:MOST_ENTRIES] if not _is_odd({"params": [{"name": name}]})) if isinstance(names, list) else ()
    record = LaunchRecord(
        f"{package}/{file}",
        package,
        file,
        args,
        _hash(data.get("hash")),
        _status(data),
        tuple(nodes),
        params,
        _problems(data.get("problems")),
        _seconds(data),
        _left(data),
        "",
    )
    return record._replace(line=_line("launch", record))


def _line(kind: str, record: NodeRecord | LaunchRecord) -> str:
    """The record in one line, as :func:`parse` reads it again."""
    data = record._asdict()
    del data["line"]
    data["problems"] = [problem._asdict() for problem in record.problems]
    if isinstance(record, LaunchRecord):
        data["interface"] = {"nodes": list(data.pop("nodes")), "params": list(data.pop("params"))}
    return json.dumps({"kind": kind, **data}, sort_keys=True)
