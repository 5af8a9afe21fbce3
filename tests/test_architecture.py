"""The house plan, checked: who may import whom, how modules are called, how long they are, what is imported when."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

PACKAGE = Path(__file__).resolve().parent.parent / "launchlint"

# From the top of the house to its foundation. Rooms on one line are neighbours and may import each other; all else points downward.
FLOORS = (
    ("__main__", "action"),
    ("cli",),
    ("server",),
    ("ide",),
    ("project",),
    ("report",),
    ("probe",),
    ("check", "baseline"),
    ("export",),
    ("rules",),
    ("suppression",),
    ("fix",),
    ("graph",),
    ("knowledge",),
    ("library",),
    ("extract",),
    ("dialects",),
    ("evaluate",),
    ("syntax",),
    ("python",),
    ("workspace",),
    ("rcl",),
    ("atomic", "fingerprint", "garbage", "late", "machinery", "order", "pool", "spelling", "words", "yaml"),
    ("model",),
    ("finding", "problem", "source", "errors", "plural", "sight", "verdict"),
    ("named_tuple",),
    ("launchlint",),  # launchlint/__init__.py: the version, nothing else
)
FLOOR = {room: len(FLOORS) - number for number, rooms in enumerate(FLOORS) for room in rooms}

# What a room must not know although it lies below: "what it must not know" of the house plan.
UNKNOWN_TO = {
    "report": {"check", "suppression", "baseline", "fix", "evaluate", "syntax", "workspace", "extract", "probe"},
    "fix": {"rules"},
    "graph": {"workspace", "syntax"},
    "ide": {"cli", "server", "rules"},
    "library": {"evaluate", "syntax", "knowledge", "extract"},
    "knowledge": {"evaluate", "syntax"},
    "extract": {"evaluate", "syntax"},
    "python": {"rcl", "yaml"},
}

# Libraries that a room must not know at all. Rules look at files only through the workspace room, which keeps account of it for the cache.
FOREIGN_TO = {
    "fix": {"click"},
    "rules": {"click", "json", "lxml", "os", "pathlib", "xml"},
    "report": {"click"},
    "ide": {"click", "pygls", "lsprotocol"},
    "project": {"click", "pygls", "lsprotocol"},
}

SAYS_NOTHING = {"utils", "util", "helpers", "helper", "common", "misc", "manager", "base"}

# Too heavy for the start of `launchlint check`: imported in the function that needs them.
LAZY = {
    "attr",
    "attrs",
    "asyncio",
    "concurrent",
    "docker",
    "jinja2",
    "lxml",
    "multiprocessing",
    "networkx",
    "sarif_om",
    "tree_sitter",
    "yaml",
}

# What a module may fill or change while it runs; all else is kept by what it is about: Packages.once, a view's cached_property, an object.
KEPT_BY_A_MODULE = {
    ("launchlint.pool", "_here"),  # a pool hands its processes functions of modules, and nothing that lives from item to item
    ("launchlint.workspace.looking", "_account"),  # of what a thread looked at, for whoever asks last
}
FILLING = {
    *("add", "append", "appendleft", "clear", "discard", "extend", "insert", "move_to_end", "pop", "popitem", "remove", "setdefault"),
    "update",
}
PLAIN = {"str", "bytes", "int", "bool", "float"}


class Import(NamedTuple):
    """One imported module: where, which, and whether it happens when the importing module is loaded or only for type checkers."""

    module: str
    line: int
    target: str
    at_load: bool
    for_types: bool


def module_name(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


COMPILED = PACKAGE / "report" / "html" / "compiled"  # templates of the page, as jinja2 writes them
MODULES = {module_name(path): path for path in sorted(PACKAGE.rglob("*.py")) if COMPILED not in path.parents}


def room(module: str) -> str:
    """`launchlint.rules.registry` → `rules`; the package itself is its own room."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else parts[0]


def floor(module: str) -> int:
    """How high above the foundation a module stands; what is not on the plan has a test of its own."""
    return FLOOR.get(room(module), 0)


def targets(node: ast.Import | ast.ImportFrom, module: str) -> Iterator[str]:
    """The modules an import statement names: `from launchlint import errors` names `launchlint.errors`."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
        return
    source = node.module or ""
    if node.level:
        package = module.split(".") if MODULES[module].name == "__init__.py" else module.split(".")[:-1]
        source = ".".join([*package[: len(package) - node.level + 1], *filter(None, [source])])
    for alias in node.names:
        inner = f"{source}.{alias.name}"
        yield inner if inner in MODULES else source


def is_type_checking(test: ast.expr) -> bool:
    return (test.id if isinstance(test, ast.Name) else getattr(test, "attr", "")) == "TYPE_CHECKING"


def walk(nodes: list[ast.AST], module: str, at_load: bool, for_types: bool) -> Iterator[Import]:
    for node in nodes:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield from (Import(module, node.lineno, target, at_load, for_types) for target in targets(node, module))
        elif isinstance(node, ast.If) and is_type_checking(node.test):
            yield from walk(list(node.body), module, at_load=False, for_types=True)
            yield from walk(list(node.orelse), module, at_load, for_types)
        else:
            inside_function = isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
            yield from walk(list(ast.iter_child_nodes(node)), module, at_load and not inside_function, for_types)


@cache
def imports() -> tuple[Import, ...]:
    """Every import of the package, those inside functions included."""
    found: list[Import] = []
    for module, path in MODULES.items():
        found += walk([ast.parse(path.read_text(encoding="utf-8"))], module, at_load=True, for_types=False)
    return tuple(found)


def inner_imports() -> list[Import]:
    return [entry for entry in imports() if entry.target.split(".")[0] == "launchlint"]


def test_every_room_is_on_the_plan() -> None:
    strangers = sorted({room(module) for module in MODULES} - FLOOR.keys())
    assert strangers == [], f"say in FLOORS where these belong: {strangers}"


def test_imports_point_downward() -> None:
    upward = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in inner_imports()
        if room(entry.module) != room(entry.target) and floor(entry.target) > floor(entry.module)
    ]
    assert upward == []


MAY_GO_IN_CIRCLES = ("launchlint.extract.cpp",)
"""An interpreter: what a call does and what an expression is need each other. They are imported inside functions there."""


def _in_circles(reached: Mapping[str, set[str]]) -> Iterator[list[str]]:
    """The modules that reach each other: in each circle, all that stand on it."""
    beyond = {module: _all_behind(module, reached) for module in reached}
    seen: set[str] = set()
    for module in sorted(reached):
        circle = sorted(each for each in beyond[module] if module in beyond.get(each, ()))
        if circle and module not in seen:
            seen.update(circle)
            yield circle


def _all_behind(module: str, reached: Mapping[str, set[str]]) -> set[str]:
    found: set[str] = set()
    waiting = [module]
    while waiting:
        new = reached.get(waiting.pop(), set()) - found
        found |= new
        waiting.extend(new)
    return found


def test_modules_of_a_room_do_not_import_each_other_in_circles() -> None:
    """Nor inside functions: whoever reads one of them would have to read them all."""
    reached: dict[str, set[str]] = {}
    for entry in inner_imports():
        if not entry.for_types and entry.target != entry.module:
            reached.setdefault(entry.module, set()).add(entry.target)
    assert [circle for circle in _in_circles(reached) if not circle[0].startswith(MAY_GO_IN_CIRCLES)] == []


def test_how_circles_are_found() -> None:
    assert list(_in_circles({"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}})) == [["b", "c"]]


def test_rooms_do_not_know_what_is_none_of_their_business() -> None:
    """Naming a type for a type checker is not knowing: views hand rules objects that other rooms made."""
    curious = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in inner_imports()
        if room(entry.target) in UNKNOWN_TO.get(room(entry.module), set()) and not entry.for_types
    ]
    assert curious == []


OF_ONE_DIALECT = (
    "launchlint.check.empty_defaults",  # what only roslaunch makes of an empty default
    "launchlint.check.empty_reach",
    "launchlint.check.overridden",
    "launchlint.cli.schema",  # of launch files of ROS 1
    "launchlint.export",  # flattens launch files of ROS 1
    "launchlint.fix.format",  # its tables hold both
    "launchlint.ide.ros1",  # what words mean, and what may stand where
    "launchlint.ide.ros2",
    "launchlint.rules",  # each says of which dialects it speaks, see the registry
)
"""What may know the rooms of a dialect; all else goes through the door."""


def test_all_else_comes_to_a_dialect_through_the_door() -> None:
    rooms = tuple(f"launchlint.{room}.{dialect}" for room in ("syntax", "evaluate") for dialect in ("ros1", "ros2"))
    above = {name for names in FLOORS[: FLOORS.index(("dialects",))] for name in names}
    found = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in inner_imports()
        if room(entry.module) in above
        and entry.target.startswith(rooms)
        and not entry.module.startswith(OF_ONE_DIALECT)
        and not entry.for_types
    ]
    assert found == []


def test_rooms_keep_away_from_foreign_libraries() -> None:
    foreign = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in imports()
        if entry.target.split(".")[0] in FOREIGN_TO.get(room(entry.module), ())
    ]
    assert foreign == []


def test_only_the_graph_room_knows_networkx() -> None:
    users = sorted({room(entry.module) for entry in imports() if entry.target.split(".")[0] == "networkx"})
    assert users in ([], ["graph"])


def test_heavy_libraries_are_imported_where_they_are_needed() -> None:
    eager = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in imports()
        if entry.at_load and entry.target.split(".")[0] in LAZY and room(entry.module) != "server"  # which lives for hours
    ]
    assert eager == [], "import these inside the function that needs them"


def test_nothing_of_a_checked_repository_can_be_executed() -> None:
    """No import machinery pointed at files, and no shell: what is checked is never run (the probe room starts containers on purpose)."""
    dangerous = {"runpy", "code", "codeop", "ctypes", "pickle", "shelve", "marshal", "socket", "urllib.request", "http.client"}
    found = [
        f"{entry.module}:{entry.line} imports {entry.target}"
        for entry in imports()
        if entry.target in dangerous and room(entry.module) != "probe"
    ]
    assert found == []


def test_groups_of_rules_hold_rules_only() -> None:
    """A newcomer finds a rule by its group, and what several rules ask in ``judging``, which knows none of them."""
    groups = {path.parent for path in (PACKAGE / "rules").glob("*/*.py")} - {PACKAGE / "rules" / "judging"}
    modules = [path for group in sorted(groups) for path in sorted(group.glob("*.py")) if path.stem != "__init__"]
    assert len(modules) >= 100
    assert [path.name for path in modules if "\nRULE = Rule(" not in path.read_text(encoding="utf-8")] == []
    known = tuple(f"launchlint.rules.{group.name}." for group in groups)
    judging = [entry for entry in inner_imports() if entry.module.startswith("launchlint.rules.judging")]
    assert [f"{entry.module} imports {entry.target}" for entry in judging if entry.target.startswith(known)] == []


_TAKE_OUT = frozenset({"partition", "rpartition", "removeprefix", "removesuffix", "split", "rsplit", "replace", "find", "index"})


def test_no_rule_takes_text_out_of_a_message() -> None:
    """What is said of several findings is made of :attr:`Finding.about`."""
    found = [
        f"{path.relative_to(PACKAGE)}:{node.lineno}"
        for room in ("rules", "check")
        for path in sorted((PACKAGE / room).rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute)
        and node.attr in _TAKE_OUT
        and isinstance(node.value, ast.Attribute)
        and node.value.attr == "message"
    ]
    assert found == []


@pytest.mark.parametrize("path", MODULES.values(), ids=MODULES.keys())
def test_module_is_one_room_with_a_name_that_says_something(path: Path) -> None:
    assert path.stem not in SAYS_NOTHING
    assert not SAYS_NOTHING.intersection(path.relative_to(PACKAGE).parts[:-1])
    length = len(path.read_text(encoding="utf-8").splitlines())
    assert length <= 500, f"{length} lines: two rooms in one"


@pytest.mark.parametrize("path", MODULES.values(), ids=MODULES.keys())
def test_module_postpones_its_annotations(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    statements = [node for node in tree.body if not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))]
    if any(isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.AnnAssign)) for node in statements):
        first = statements[0]
        assert isinstance(first, ast.ImportFrom)
        assert (first.module, [alias.name for alias in first.names]) == ("__future__", ["annotations"])


def _filled(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Names of the module that one of its functions fills, changes or sets anew, with the line."""
    assigned = [node for node in tree.body if isinstance(node, (ast.Assign, ast.AnnAssign))]
    names = {each.id for node in assigned for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)}
    for function in ast.walk(tree):
        if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
            continue
        inside = list(ast.walk(function))
        own = {node.arg for node in inside if isinstance(node, ast.arg)}
        own |= {node.id for node in inside if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
        for node in inside:
            changed: ast.AST | None = None
            if isinstance(node, ast.Global):
                yield from ((name, node.lineno) for name in node.names)
            elif isinstance(node, ast.Subscript) and isinstance(node.ctx, (ast.Store, ast.Del)):
                changed = node.value
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in FILLING:
                changed = node.func.value
            while isinstance(changed, (ast.Subscript, ast.Attribute)):
                changed = changed.value
            if isinstance(changed, ast.Name) and changed.id in names - own:
                yield changed.id, changed.lineno


def test_no_module_keeps_what_it_found() -> None:
    """A cache belongs to what it is about: it then ends with it, and two runs in one process cannot see each other's answers."""
    found = {
        (module, name): f"{module}:{line} fills {name}"
        for module, path in MODULES.items()
        for name, line in _filled(ast.parse(path.read_text(encoding="utf-8")))
    }
    assert [where for name, where in found.items() if name not in KEPT_BY_A_MODULE] == []
    assert found.keys() >= KEPT_BY_A_MODULE, "the list above names what is no longer there"


@pytest.mark.parametrize(
    ("code", "names"),
    [
        ("_kept: dict[str, int] = {}\ndef f(a):\n    _kept[a] = 1", ["_kept"]),
        ("_kept = []\ndef f(a):\n    _kept.append(a)", ["_kept"]),
        ("_kept = None\ndef f(a):\n    global _kept\n    _kept = a", ["_kept"]),
        ("_kept = {}\ndef f(a):\n    _kept.setdefault(a, []).append(1)", ["_kept"]),
        ("_table = {1: 2}\ndef f(a):\n    return _table[a]", []),
        ("found = []\ndef f(a):\n    found = []\n    found.append(a)\n    return found", []),
    ],
)
def test_how_that_is_found(code: str, names: list[str]) -> None:
    assert sorted({name for name, _ in _filled(ast.parse(code))}) == names


def _unbounded(tree: ast.Module) -> Iterator[str]:
    """Functions that remember without bound, or by something that is no plain value."""
    for function in ast.walk(tree):
        if not isinstance(function, ast.FunctionDef):
            continue
        for decorator in function.decorator_list:
            word = ast.unparse(decorator)
            arguments = [*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs]
            kinds = {"" if each.annotation is None else ast.unparse(each.annotation) for each in arguments}
            if (word == "cache" and arguments) or word in ("lru_cache", "lru_cache()", "lru_cache(maxsize=None)"):
                yield f"{function.name} remembers without bound"
            elif word.startswith("lru_cache") and kinds - PLAIN:
                yield f"{function.name} remembers by {', '.join(sorted(kinds - PLAIN))}"


def test_functions_that_remember_do_so_within_bounds_and_by_plain_values() -> None:
    found = [f"{module}: {each}" for module, path in MODULES.items() for each in _unbounded(ast.parse(path.read_text(encoding="utf-8")))]
    assert found == []


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("@cache\ndef f(a: str): ...", ["f remembers without bound"]),
        ("@lru_cache\ndef f(a: str): ...", ["f remembers without bound"]),
        ("@lru_cache(maxsize=4)\ndef f(a: Packages): ...", ["f remembers by Packages"]),
        ("@lru_cache(maxsize=4)\ndef f(a: str, *, b: int): ...", []),
        ("@cache\ndef f(): ...", []),
    ],
)
def test_how_those_are_found(code: str, said: list[str]) -> None:
    assert list(_unbounded(ast.parse(code))) == said
