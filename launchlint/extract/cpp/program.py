"""One program of C++: its files are read, and it is followed from its start."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.declarations import Class, Declarations, Function
from launchlint.extract.cpp.files import read_files
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.machine import Argument, Machine
from launchlint.extract.cpp.naming import ANY, UNKNOWN_SPACE, finished
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import UNKNOWN, Handle, Thing, Value
from launchlint.extract.fact import Doubt, Fact

_EVERYWHERE = frozenset(
    (
        "/rosout",
        "/clock",
        "/use_sim_time",
        "use_sim_time",
        "~get_loggers",
        "~set_logger_level",
        "/statistics",
        "/tcp_keepalive",
        "/rosdistro",
    )
)
_LAZY_PARAMS: tuple[tuple[str, bool | float | None, str], ...] = (
    ("~lazy", True, "bool"),
    ("~verbose_connection", False, "bool"),
    ("verbose_connection", False, "bool"),
    ("~duration_to_warn_no_connection", 5.0, "double"),
)
_STARTS = ("onInit", "init", "initialize", "onInitialize", "Load", "initRT", "initPlugin")


def cpp_program(
    sources: Sequence[str], include_directories: Sequence[str], root: str, entry: str | None
) -> tuple[tuple[Fact, ...], tuple[Doubt, ...]]:
    """What a program says, found by following its source code; nothing is run.

    Args:
        sources: the C++ files that are linked into the executable or library.
        include_directories: where headers of the package are; others are not read.
        root: what the paths of facts are relative to.
        entry: the class whose constructor and ``onInit`` are the start (``image_proc::RectifyNodelet``); ``main()`` if None.

    Returns:
        Facts, sorted by category, name and place; and doubts, why there may be more than these.

    Raises:
        UsageError: tree-sitter is not installed.
    """
    files, problems = read_files(sources, include_directories, root)
    declarations = Declarations()
    for file in files:
        declarations.read(file.root, file.path)
    declarations.finish()
    machine = Machine(declarations, root)
    first = files[-1].path if files else "."
    for problem in problems:
        machine.doubt_all(problem, first, 1)
    try:
        if entry is None:
            _main(machine, first)
        else:
            _class(machine, entry, first)
        machine.finish()
    except RecursionError:
        machine.doubt_all("the program is nested too deeply to be followed to its end", first, 1)
    return _settled(list(machine.facts.values()), list(machine.doubts))


def _settled(facts: Sequence[Fact], doubts: Sequence[Doubt]) -> tuple[tuple[Fact, ...], tuple[Doubt, ...]]:
    """Names of a node handle that nothing is known of are told only where nothing better is known of that place."""
    places = {(each.category, each.path, each.line) for each in facts if UNKNOWN_SPACE not in each.name}
    kept = [each for each in facts if UNKNOWN_SPACE not in each.name or (each.category, each.path, each.line) not in places]
    named = [each._replace(name=finished(each.name.replace(UNKNOWN_SPACE, ANY))) for each in kept]
    told: dict[Doubt, None] = {}
    for doubt in doubts:
        if not doubt.reason.startswith(UNKNOWN_SPACE):
            told[doubt] = None
        elif (doubt.category, doubt.path, doubt.line) not in places:
            told[doubt._replace(reason=doubt.reason.removeprefix(UNKNOWN_SPACE))] = None
    return _sorted(named), tuple(sorted(told, key=lambda each: (each.category, each.path, each.line, each.reason)))


def _main(machine: Machine, path: str) -> None:
    found = [each for each in machine.declarations.functions.get("main", []) if each.body is not None and not each.owner]
    if not found:
        machine.doubt_all("no main() was found in these sources", path, 1)
        return
    found.sort(key=lambda each: each.path.endswith((".h", ".hpp", ".hh", ".hxx")))
    machine.serial += 1
    command_line = Thing(Type("<argv>"), None, machine.serial)
    machine.call(found[0], None, [Argument(UNKNOWN), Argument(command_line)])


def _class(machine: Machine, entry: str, path: str) -> None:
    name = entry.removeprefix("::")
    frame = Frame(path, "", None, {})
    resolved = machine.names.resolve(Type(name), frame)
    declared = machine.names.declared(resolved)
    if declared is None:
        machine.doubt_all(f"the class {name[:200]} was not found in these sources", path, 1)
        return
    node = Node("declaration", 1, b"", 0, 0)
    thing = classes.make(machine, declared, resolved, [], node, frame)
    if not isinstance(thing, Thing):
        return
    for start in _STARTS:
        functions = classes.methods(machine, thing, start)
        if functions:
            chosen = functions[-1]
            machine.call(chosen, thing, _given(chosen))
            break
    else:
        _without_start(machine, declared, path)
        return
    if _is_lazy(machine, declared):
        _lazy_params(machine, declared, chosen)
        for name in ("subscribe", "unsubscribe"):
            for function in classes.methods(machine, thing, name):
                if not function.parameters:
                    machine.when = "subscriber"
                    machine.call(function, thing, [])
                    machine.when = "start"


def _is_lazy(machine: Machine, declared: Class) -> bool:
    """Whether its subscriptions are made and ended by the base class, as there are listeners."""
    known = [declared, *machine.names.bases(declared.name)]
    return any("azy" in base.name or base.last in classes.LAZY for each in known for base in each.bases)


def _lazy_params(machine: Machine, declared: Class, function: Function) -> None:
    """Params that nodelet_topic_tools::NodeletLazy reads."""
    bases = [base for each in [declared, *machine.names.bases(declared.name)] for base in each.bases]
    if any(base.name == "nodelet_topic_tools::NodeletLazy" and base.name not in machine.declarations.classes for base in bases):
        for name, default, kind in _LAZY_PARAMS:
            machine.note(Fact("params", name, function.path, function.line, default=default, value_type=kind))


def _without_start(machine: Machine, declared: Class, path: str) -> None:
    machine.doubt_all(f"{declared.name} has no onInit() in these sources", path, 1)


def _given(function: Function) -> list[Argument]:
    """What a framework gives to an init function: node handles, the second one private; the rest is not known."""
    handles: list[Value] = [Handle(UNKNOWN_SPACE), Handle(UNKNOWN_SPACE)]
    given: list[Argument] = []
    for parameter in function.parameters:
        is_handle = parameter.type.last == "NodeHandle"
        given.append(Argument(handles.pop(0) if is_handle and handles else UNKNOWN))
    return given


def _sorted(facts: Sequence[Fact]) -> tuple[Fact, ...]:
    """Facts without those that every node has, and without conditional ones where the same is said without condition."""
    certain = {_key(each): each for each in facts if not each.condition and each.when == "start"}
    unconditional = {_key(each) for each in facts if not each.condition}
    found: dict[str, Fact] = {}
    for each in facts:
        if each.name in _EVERYWHERE or not each.name:
            continue
        key = _key(each)
        if key in certain and (each.condition or each.when != "start"):
            continue
        if key in unconditional and each.condition:
            continue
        found.setdefault(repr(each), each)
    return tuple(
        sorted(found.values(), key=lambda each: (each.category, each.name, each.path, each.line, each.role, each.condition, repr(each)))
    )


def _key(fact: Fact) -> tuple[str, ...]:
    return (fact.category, fact.name, fact.type, fact.role, fact.path, str(fact.line))
