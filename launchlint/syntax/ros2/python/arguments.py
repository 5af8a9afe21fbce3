"""Whether the values that a class of launch is made with are of a kind that it takes: texts, lists of texts, remaps, params, conditions.

Only what is known for certain counts: what a value is that came from code that is not followed, nobody can say.
Source: the constructors in ``launch`` and ``launch_ros``, ``launch.utilities.normalize_to_list_of_substitutions`` and
``launch_ros.utilities.normalize_parameters`` and ``normalize_remap_rule``.
"""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Callable, Iterator, Mapping

from launchlint.problem import Problem
from launchlint.python.values import Class, External, Function, Handle, Map, Seq, Value
from launchlint.python.values import Text as Open
from launchlint.source import Origin, Place, Span
from launchlint.syntax.ros2.python.constructors import Given
from launchlint.syntax.ros2.python.problems import (
    LaunchArgumentsNotPairs,
    NotACondition,
    NotAnAction,
    NotAParameterValue,
    NotASubstitution,
    TextForList,
    WrongSourceClass,
)
from launchlint.syntax.ros2.python.tables import class_of_kind
from launchlint.syntax.ros2.python.texts import is_substitution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.python.problems import ListForm

_PROCESS = "cwd=text prefix=text sigterm_timeout=text sigkill_timeout=text env=environment additional_env=environment"
_NODE = f"""package=text executable=needed name=text namespace=text exec_name=text arguments=texts ros_arguments=texts
    remappings=remaps parameters=list-of-params {_PROCESS}"""
_TAKES = f"""
DeclareLaunchArgument name=needed default_value=text
SetLaunchConfiguration name=needed value=needed
UnsetLaunchConfiguration name=needed
SetEnvironmentVariable name=needed value=needed
UnsetEnvironmentVariable name=needed
AppendEnvironmentVariable name=needed value=needed
LogInfo msg=needed
ForLoop length=needed
ForEach input_values=needed
ExecuteProcess cmd=texts name=text {_PROCESS}
TimerAction period=period actions=actions
RosTimer period=period actions=actions
GroupAction actions=actions
LaunchDescription initial_entities=actions
IncludeLaunchDescription launch_description_source=needed launch_arguments=launch-arguments
Node {_NODE}
LifecycleNode {_NODE}
ComposableNodeContainer {_NODE}
ComposableNode package=needed plugin=needed name=text namespace=text parameters=params remappings=remaps extra_arguments=params
PushROSNamespace namespace=needed
SetRemap src=needed dst=needed
SetParametersFromFile filename=needed
IfCondition predicate_expression=needed
UnlessCondition predicate_expression=needed
PythonLaunchDescriptionSource launch_file_path=needed
AnyLaunchDescriptionSource launch_file_path=needed
FrontendLaunchDescriptionSource launch_file_path=needed
XMLLaunchDescriptionSource launch_file_path=needed
YAMLLaunchDescriptionSource launch_file_path=needed
LaunchConfiguration variable_name=needed
EnvironmentVariable name=needed default_value=text
PathJoinSubstitution substitutions=needed
PythonExpression expression=needed
Command command=needed
FindExecutable name=needed
AnonName name=needed
NotSubstitution value=needed
AndSubstitution left=needed right=needed
OrSubstitution left=needed right=needed
IfElseSubstitution condition=needed if_value=needed else_value=needed
FindPackageShare package=needed
FindPackagePrefix package=needed
ExecutableInPackage executable=needed package=needed
"""
"""Class → what each of its arguments takes: a text, which may be None (``text``) or not (``needed``), and what else the functions judge."""
_LATE = frozenset(("name", "namespace", "launch_arguments", "condition"))
"""What a process or an include looks at only when it is executed."""
_DEEPEST = 8
_FOR_PYTHON = "PythonLaunchDescriptionSource"
_RIGHT = {".xml": "XMLLaunchDescriptionSource", ".yaml": "YAMLLaunchDescriptionSource", ".yml": "YAMLLaunchDescriptionSource"}


def wrong_values(given: Given) -> Iterator[Problem]:
    """What is wrong with the values of a call."""
    takes = _TABLE.get(given.callee, {})
    conditional = given.values.get("condition") is not None
    if given.callee == "IncludeLaunchDescription":
        yield from _source(given, conditional)
    for name, value in given.values.items():
        judge = takes.get(name, _condition if name == "condition" else None)
        if judge is None:
            continue
        for problem in judge(given, name, value):
            late = conditional and name in _LATE and name != "condition" and given.callee != "ComposableNode"
            yield problem.but(refused=False, assumed=True) if late and problem.refused else problem


def spelled(value: Value) -> str:
    """In words what a value is that is no text; empty where it is one, can be gone through for texts, or is not known."""
    if value is None:
        return "None"
    if isinstance(value, bool):
        return f"{value}, a boolean"
    if isinstance(value, int):
        return f"{value}, an integer" if abs(value) < 1 << 63 else "an integer"
    if isinstance(value, float):
        return f"{value}, a number"
    if isinstance(value, Handle):
        name = class_of_kind(value.kind)
        return "" if name is None or is_substitution(value) else f"an object of {name.rpartition('.')[2]}"
    if isinstance(value, Function):
        return "a function"
    if isinstance(value, Class) or (isinstance(value, External) and class_of_kind(value.name.rpartition(".")[2]) == value.name):
        return "a class that is not called"
    return ""


def _source(given: Given, conditional: bool) -> Iterator[Problem]:
    """Whether the class of an include's source is for files with such a name: Python's executes whatever stands in a file."""
    source = given.values.get("launch_description_source")
    if not isinstance(source, Handle) or source.kind != _FOR_PYTHON:
        return
    file = _last(source.state.get("launch_file_path"))
    right = next((name for end, name in _RIGHT.items() if file.endswith(end)), "")
    if right:
        at: Place = source.state["place"]
        name = Place(at.source, Span(at.span.start, at.span.start + len(at.text.partition("(")[0].rstrip())))
        yield WrongSourceClass(
            origin=Origin(name),
            refused=not conditional,
            assumed=conditional,
            callee=source.kind,
            file=posixpath.basename(file),
            right=right,
        )


def _last(value: Value) -> str:
    """How a path ends, as far as that is written."""
    for _ in range(_DEEPEST):
        if isinstance(value, Seq):
            value = value.items[-1] if value.items and value.complete else ""
        elif isinstance(value, Handle) and value.kind in ("PathJoinSubstitution", "TextSubstitution"):
            value = value.state.get("substitutions" if value.kind == "PathJoinSubstitution" else "text")
    if isinstance(value, Open):
        return value.template.rpartition("}")[2]
    return value if isinstance(value, str) else ""


# -- texts ----------------------------------------------------------------------------------------------------------------


def _text(given: Given, name: str, value: Value) -> Iterator[Problem]:
    if value is not None:
        yield from _needed(given, name, value)


def _needed(given: Given, name: str, value: Value) -> Iterator[Problem]:
    yield from _as_text(given, name, value, given.expression(name), given.where(name))


def _as_text(given: Given, name: str, value: Value, node: ast.expr | None, place: Place, *, item: bool = False) -> Iterator[Problem]:
    """What takes a text takes a list of them, too, in pieces."""
    if name == "launch_description_source" and isinstance(value, Handle) and value.kind.endswith("LaunchDescriptionSource"):
        return
    found = spelled(value)
    if found:
        yield _no_text(given, name, value, node, place, item)
    elif isinstance(value, Seq):
        for inner, piece, where in _items(given, value, node, place):
            if spelled(piece):
                yield _no_text(given, name, piece, inner, where, item=True)


def _no_text(given: Given, name: str, value: Value, node: ast.expr | None, place: Place, item: bool) -> Problem:
    plain = isinstance(node, ast.Constant)
    declared = value.state.get("name") if isinstance(value, Handle) and value.kind == "DeclareLaunchArgument" else ""
    return NotASubstitution(
        origin=Origin(place), refused=True, callee=given.callee, argument=name, found=spelled(value), item=item,
        written=_as_written(value) if plain else "", declared=declared if isinstance(declared, str) else "",
    )  # fmt: skip


def _as_written(value: Value) -> str:
    """The text that is meant with a plain value: XML would have it so."""
    if isinstance(value, bool):
        return f"'{str(value).lower()}'"
    return f"'{value}'" if isinstance(value, (int, float)) else ""


def _items(given: Given, value: Seq, node: ast.expr | None, place: Place) -> Iterator[tuple[ast.expr | None, Value, Place]]:
    """The items of a list, each with the place where it is written, as far as that can be told."""
    for inner, item in zip(_written(node, len(value.items), sure=value.is_sure), value.items, strict=True):
        yield inner, item, place if inner is None else given.place(inner)


def _written(node: ast.expr | None, count: int, *, sure: bool) -> list[ast.expr | None]:
    """The expressions of the ``count`` items of a list, of which there may be more where it is not ``sure``; None where that is elsewhere.

    They are told from both ends of a list in brackets that takes in others (``[first, *others, last]``, ``others + [last]``).
    """
    nowhere: list[ast.expr | None] = [None] * count
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add) and isinstance(node.right, (ast.List, ast.Tuple)) and sure:
        last = node.right.elts
        if len(last) > count or any(isinstance(each, ast.Starred) for each in last):
            return nowhere
        return [*_written(node.left, count - len(last), sure=sure), *last]
    if not isinstance(node, (ast.List, ast.Tuple)):
        return nowhere
    starred = [number for number, each in enumerate(node.elts) if isinstance(each, ast.Starred)]
    if not starred:
        return list(node.elts) if len(node.elts) == count else nowhere
    first, last = node.elts[: starred[0]], node.elts[starred[-1] + 1 :]
    between = count - len(first) - len(last)
    return [*first, *nowhere[:between], *last] if sure and between >= 0 else nowhere


def _texts(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """``arguments``, ``cmd``: a list of texts."""
    place = given.where(name)
    if isinstance(value, (str, Open)):
        yield _form(given, name, place, "letters", refused=name == "ros_arguments")
    elif isinstance(value, Handle) and is_substitution(value):
        yield _form(given, name, place, "one")
    elif spelled(value) and not (value is None and name != "cmd"):
        yield _no_text(given, name, value, given.expression(name), place, item=False)
    elif isinstance(value, Seq):
        if name == "ros_arguments" and value.is_tuple:
            yield _form(given, name, place, "tuple")
        for inner, item, where in _items(given, value, given.expression(name), place):
            yield from _as_text(given, name, item, inner, where, item=True)


def _form(given: Given, name: str, place: Place, form: ListForm, *, refused: bool = True) -> Problem:
    return TextForList(origin=Origin(place), refused=refused, callee=given.callee, argument=name, form=form)


def _environment(given: Given, name: str, value: Value) -> Iterator[Problem]:
    if not isinstance(value, Map):
        return
    node = given.expression(name)
    for key, each in value.entries.items():
        yield from _as_text(given, name, each, *_entry(given, node, key, given.where(name)), item=True)


def _entry(given: Given, node: ast.expr | None, key: Value, place: Place) -> tuple[ast.expr | None, Place]:
    """Where the value of a key is written, if the dict is written out."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "items":
        node = node.func.value
    if isinstance(node, ast.Dict):
        for known, value in zip(node.keys, node.values, strict=True):
            if isinstance(known, ast.Constant) and known.value == key:
                return value, given.place(value)
    return None, place


def _period(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """``period`` of a timer is a number with a point."""
    if isinstance(value, int) or value is None:
        node = given.expression(name)
        plain = isinstance(node, ast.Constant) and not isinstance(value, bool) and value is not None
        yield NotASubstitution(
            origin=Origin(given.where(name)), refused=True, callee=given.callee, argument=name, found=spelled(value), item=False,
            written=f"{value}.0" if plain else "", declared="",
        )  # fmt: skip


# -- lists ----------------------------------------------------------------------------------------------------------------


def _remaps(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """``remappings``: pairs, which have to be tuples."""
    place = given.where(name)
    refused = given.callee != "ComposableNode" or given.values.get("condition") is None
    if isinstance(value, Map) and value.entries:
        yield _form(given, name, place, "dict", refused=refused)
    elif isinstance(value, (str, Open)) and value:
        yield _form(given, name, place, "text", refused=refused)
    elif isinstance(value, Seq):
        texts = [each for each in value.items if isinstance(each, (str, Open))]
        if texts:
            yield _form(given, name, place, "flat-pair" if len(value.items) == 2 == len(texts) else "not-pair", refused=refused)
            return
        for inner, item, where in _items(given, value, given.expression(name), place):
            if isinstance(item, Seq) and not item.is_tuple and isinstance(inner, ast.List):
                yield _form(given, name, where, "list-for-pair", refused=refused)
            elif isinstance(item, Seq) and item.complete and len(item.items) != 2:
                yield _form(given, name, where, "not-two", refused=refused)
            elif isinstance(item, Map) or spelled(item):
                yield _form(given, name, where, "not-pair", refused=refused)
            elif isinstance(item, Seq):
                for at, side, there in _items(given, item, inner, where):
                    yield from _as_text(given, name, side, at, there, item=True)


def _launch_arguments(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """``launch_arguments`` of an include: pairs; a dict gives its keys, and a key is taken apart into letters."""
    place = given.where(name)
    if isinstance(value, Map):
        if value.entries:
            refused = any(not isinstance(key, str) or len(key) != 2 for key in value.entries)
            yield LaunchArgumentsNotPairs(origin=Origin(place), refused=refused, found="a dict", is_dict=True)
        return
    if not isinstance(value, Seq):
        found = spelled(value)
        if found and value is not None:
            yield LaunchArgumentsNotPairs(origin=Origin(place), refused=True, found=found, is_dict=False)
        return
    for inner, item, where in _items(given, value, given.expression(name), place):
        found = spelled(item)
        if found:
            yield LaunchArgumentsNotPairs(origin=Origin(where), refused=True, found=found, is_dict=False)
        elif isinstance(item, Seq) and item.complete and len(item.items) == 2:
            key, content = item.items
            if inner is None:
                at, there = _entry(given, given.expression(name), key, place)
                yield from _as_text(given, name, content, at, there, item=True)
            else:
                (_, _, _), (at, _, there) = _items(given, item, inner, where)
                yield from _as_text(given, name, content, at, there, item=True)


def _listed_params(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """``parameters`` of a process have to be a list."""
    if isinstance(value, Seq) and value.is_tuple and value.complete and isinstance(given.expression(name), ast.Tuple):
        yield _form(given, name, given.where(name), "tuple")
    yield from _params(given, name, value)


def _params(given: Given, name: str, value: Value) -> Iterator[Problem]:
    """Files and dicts, in a list."""
    place = given.where(name)
    if isinstance(value, Map):
        yield _form(given, name, place, "dict")
    elif isinstance(value, (str, Open)):
        yield _form(given, name, place, "text")
    elif isinstance(value, Handle) and (is_substitution(value) or value.kind in ("ParameterFile", "ParameterValue")):
        yield _form(given, name, place, "one")
    elif isinstance(value, Seq):
        for inner, item, where in _items(given, value, given.expression(name), place):
            if isinstance(item, Map):
                yield from _values(given, item, inner, where, "", 0)
            elif spelled(item) and not (isinstance(item, Handle) and item.kind in ("ParameterFile", "ParameterValue", "Parameter")):
                yield _no_text(given, name, item, None, where, item=True)


def _values(given: Given, value: Map, node: ast.expr | None, place: Place, prefix: str, depth: int) -> Iterator[Problem]:
    for key, content in value.entries.items():
        full = f"{prefix}{key}" if isinstance(key, str) else ""
        inner, where = _entry(given, node, key, place)
        if isinstance(content, Map):
            if depth < _DEEPEST:
                yield from _values(given, content, inner, where, f"{full}.", depth + 1)
            continue
        found = "" if isinstance(content, (bool, int, float)) else spelled(content)
        if isinstance(content, Handle) and content.kind in ("ParameterValue", "Parameter"):
            found = ""
        if isinstance(content, Seq) and content.complete and not content.items:
            late = given.values.get("condition") is not None
            yield NotAParameterValue(
                origin=Origin(where), refused=not late, assumed=late, callee=given.callee, name=full, found="a list without items"
            )
        elif isinstance(content, Seq):
            found = "a list with None in it" if any(each is None for each in content.items) else ""
            if not found and len({_kind(each) for each in content.items} - {""}) > 1 and all(map(_kind, content.items)):
                late = given.values.get("condition") is not None
                words = "a list of values of several kinds"
                yield NotAParameterValue(origin=Origin(where), refused=not late, assumed=late, callee=given.callee, name=full, found=words)
        if found:
            yield NotAParameterValue(origin=Origin(where), refused=True, callee=given.callee, name=full, found=found)


def _kind(value: Value) -> str:
    """The kind of a plain value, of which all in a list have to be one; empty for others."""
    if isinstance(value, bool):
        return "bool"
    return "number" if isinstance(value, (int, float)) else "text" if isinstance(value, str) else ""


# -- conditions and actions ---------------------------------------------------------------------------------------------------


def _condition(given: Given, name: str, value: Value) -> Iterator[Problem]:
    if value is None or (isinstance(value, Handle) and not is_substitution(value)):
        return
    found = spelled(value) or ("a text" if isinstance(value, str) else "a substitution" if is_substitution(value) else "")
    if found:
        text = isinstance(value, str) or is_substitution(value)
        yield NotACondition(origin=Origin(given.where(name)), refused=True, callee=given.callee, found=found, substitution=text)


def _actions(given: Given, name: str, value: Value) -> Iterator[Problem]:
    place = given.where(name)
    if not isinstance(value, Seq):
        return
    for _, item, where in _items(given, value, given.expression(name), place):
        yield from wrong_action(given.callee, item, where)


def wrong_action(holder: str, item: Value, where: Place) -> Iterator[Problem]:
    """What is wrong with one of the actions that ``holder`` is given."""
    found = "" if isinstance(item, Handle) else spelled(item)
    if isinstance(item, Seq):
        found = "a list" if not item.is_tuple else "a tuple of one item" if len(item.items) == 1 and item.is_sure else "a tuple"
    elif isinstance(item, str):
        found = "a text"
    elif isinstance(item, Handle) and (is_substitution(item) or item.kind in _NO_ACTIONS):
        found = f"an object of {item.kind}"
    if found:
        yield NotAnAction(origin=Origin(where), refused=True, holder=holder, found=found)


_NO_ACTIONS = frozenset(
    """ComposableNode ParameterValue ParameterFile IfCondition UnlessCondition PythonLaunchDescriptionSource AnyLaunchDescriptionSource
    XMLLaunchDescriptionSource YAMLLaunchDescriptionSource FrontendLaunchDescriptionSource""".split()
)
_JUDGES: Mapping[str, Callable[[Given, str, Value], Iterator[Problem]]] = {
    "text": _text,
    "needed": _needed,
    "texts": _texts,
    "environment": _environment,
    "period": _period,
    "remaps": _remaps,
    "launch-arguments": _launch_arguments,
    "list-of-params": _listed_params,
    "params": _params,
    "actions": _actions,
}
_TABLE = {
    name: {word.partition("=")[0]: _JUDGES[word.partition("=")[2]] for word in words}
    for name, *words in (line.split() for line in _TAKES.replace("\n    ", " ").strip().splitlines())
}
