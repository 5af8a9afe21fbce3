"""One program of C++: its files are read, and it is followed from its start."""

from __future__ import annotations

import re
from collections.abc import Collection, Hashable, Sequence

from launchlint.extract.cpp import nodelet, unit_tests
from launchlint.extract.cpp.declarations import Declarations
from launchlint.extract.cpp.files import File, Trees, read_files
from launchlint.extract.cpp.foreign import Foreign
from launchlint.extract.cpp.machine import Machine
from launchlint.extract.cpp.naming import ANY, UNKNOWN_SPACE, finished
from launchlint.extract.cpp.rclcpp import component
from launchlint.extract.cpp.rclcpp.generated import with_classes
from launchlint.extract.cpp.rclcpp.running import doubt_nodes
from launchlint.extract.cpp.rclcpp.tables import RCLCPP
from launchlint.extract.cpp.ros.roscpp import ROSCPP
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Argument, Thing
from launchlint.extract.fact import Doubt, Fact, Made, Plugin, key_of
from launchlint.extract.template import Template

_MAKES = re.compile(
    r"(?:\.|->)\s*(?:advertise\w*|subscribe\w*|serviceClient|getParam|param)\s*[<(]"
    r"|\b(?:create_(?:publisher|subscription|service|client)|declare_parameter)\s*[<(]"
)
# A node may well publish /clock, or hear /rosout: which of their ends every node has is told where all languages meet.
_EVERYWHERE = frozenset(
    (
        "/use_sim_time",
        "use_sim_time",
        "~get_loggers",
        "~set_logger_level",
        "/statistics",
        "/tcp_keepalive",
        "/rosdistro",
    )
)


def cpp_program(
    sources: Sequence[str],
    include_directories: Sequence[str],
    root: str,
    entry: str | None,
    plugins: Sequence[Plugin] = (),
    templates: Sequence[Template] = (),
    packages: Collection[str] = (),
    trees: Trees | None = None,
    client: str = "roscpp",
    parameters: Sequence[str] = (),
) -> tuple[tuple[Fact, ...], tuple[Doubt, ...], tuple[Made, ...]]:
    """What a program says, found by following its source code; nothing is run.

    Args:
        sources: the C++ files that are linked into the executable or library.
        include_directories: where headers of the package are; others are not read.
        root: what the paths of facts are relative to.
        entry: the class whose constructor, and ``onInit`` of a nodelet, are the start (``image_proc::RectifyNodelet``); ``main()`` if None.
        plugins: classes that can be loaded and whose sources are among these.
        templates: those of the sources that the build fills in.
        packages: names of ROS packages, beside those that are public.
        trees: what is kept of files that several programs read.
        client: what the program is in a library: ``roscpp``, ``nodelet``, ``rclcpp`` or ``component``.
        parameters: the YAML files that generate_parameter_library makes classes of.

    Returns:
        Facts, sorted by category, name and place; doubts, why there may be more than these; and the nodes of ROS 2 that it makes.

    Raises:
        UsageError: tree-sitter is not installed.
    """
    files, problems, missing = read_files(sources, include_directories, root, templates, trees or Trees())
    declarations = Declarations()
    for file in files:
        declarations.read(file.root, file.path)
    declarations.finish()
    of_ros2 = client in ("rclcpp", "component")
    tables = with_classes(RCLCPP, parameters, root) if of_ros2 else ROSCPP
    machine = Machine(declarations, tables, root, plugins, Foreign(missing, packages))
    first = files[-1].path if files else "."
    for problem in problems:
        machine.doubt_all(problem, first, 1)
    try:
        machine.is_loaded = entry is not None and not of_ros2
        if entry is None:
            _main(machine, first)
        else:
            (component if of_ros2 else nodelet).start(machine, entry, first)
        machine.finish()
        doubt_nodes(machine)
    except RecursionError:
        machine.doubt_all("the program is nested too deeply to be followed to its end", first, 1)
    for file in files:
        _doubt_torn(machine, file)
    return *_settled(list(machine.facts.values()), list(machine.doubts)), tuple(machine.nodes.values())


def _doubt_torn(machine: Machine, file: File) -> None:
    """Note where a part of a file is not understood, and makes names that were not found."""
    if not file.root.errors:
        return
    told = {fact.line for fact in machine.facts.values() if fact.path == file.path}
    for first, text in file.root.errors:
        for match in _MAKES.finditer(text):
            line = first + text.count("\n", 0, match.start())
            if told.isdisjoint(range(line - 2, line + 3)):
                machine.doubt_all("a part of the source is not understood", file.path, line)
                return


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
        if not unit_tests.follow(machine):
            machine.doubt_all("no main() was found in these sources", path, 1)
        return
    found.sort(key=lambda each: each.path.endswith((".h", ".hpp", ".hh", ".hxx")))
    machine.serial += 1
    command_line = Thing(Type("<argv>"), None, machine.serial)
    machine.call(found[0], None, [Argument(UNKNOWN), Argument(command_line)])
    unit_tests.follow(machine)


def _sorted(facts: Sequence[Fact]) -> tuple[Fact, ...]:
    """Facts without those that every node has, and without conditional ones where the same is said without condition."""
    certain = {_key(each): each for each in facts if not each.condition and each.when == "start"}
    unconditional = {_key(each) for each in facts if not each.condition}
    found: dict[Hashable, Fact] = {}
    for each in facts:
        if each.name in _EVERYWHERE or not each.name:
            continue
        key = _key(each)
        if key in certain and (each.condition or each.when != "start"):
            continue
        if key in unconditional and each.condition:
            continue
        found.setdefault(key_of(each), each)
    return tuple(
        sorted(found.values(), key=lambda each: (each.category, each.name, each.path, each.line, each.role, each.condition, repr(each)))
    )


def _key(fact: Fact) -> tuple[str, ...]:
    return (fact.category, fact.name, fact.type, fact.role, fact.path, str(fact.line))
