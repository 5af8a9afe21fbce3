"""Whether a class of launch is made with arguments that its constructor takes: names and numbers of them, not yet values."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from launchlint.problem import Problem
from launchlint.python.values import MORE, UNKNOWN, Value
from launchlint.source import Origin, Place, Span
from launchlint.syntax.ros2.python.problems import KeywordNotInDistribution, MissingArgument, TooManyPositional, UnknownKeyword
from launchlint.syntax.ros2.python.tables import Signature, newer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from launchlint.workspace.ros2_distributions import Meant

_NODE = {"node_executable": "executable", "node_name": "name", "node_namespace": "namespace"}
_REPLACED = {
    "Node": _NODE,
    "LifecycleNode": _NODE,
    "ComposableNodeContainer": _NODE,
    "ComposableNode": {"node_plugin": "plugin", "node_name": "name", "node_namespace": "namespace"},
}
"""Keywords of Foxy that later distributions do not take any more, and what they take instead (launch_ros 0.11)."""
_REMOVED_SINCE = "galactic"
_SLIPS = {
    "DeclareLaunchArgument": {"default": "default_value"},
    "EnvironmentVariable": {"default": "default_value"},
    "LaunchConfiguration": {"default_value": "default"},
    "Node": {"exec": "executable", "pkg": "package", "ns": "namespace", "args": "arguments", "params": "parameters"},
    "IncludeLaunchDescription": {"arguments": "launch_arguments", "launch_args": "launch_arguments"},
}
"""What is written in their place where another class, or the XML of the same, has another name for it."""


class Given:
    """The arguments of a call as they are given: values by name, and where each of them stands."""

    def __init__(
        self,
        known: Signature,
        positional: Sequence[Value],
        keywords: dict[str, Value],
        node: ast.AST,
        place: Callable[[ast.AST], Place],
    ) -> None:
        self.known = known
        self.count = len(positional)
        self.open = MORE in keywords or any(each is UNKNOWN for each in positional[known.positional :])
        self.keywords = {name: value for name, value in keywords.items() if name != MORE}
        self.values: dict[str, Value] = {**dict(zip(known.arguments[: known.positional], positional, strict=False)), **self.keywords}
        self._written: dict[str, str] = {}
        self.call = node if isinstance(node, ast.Call) else None
        self.whole = place(node)
        self._place = place

    @property
    def callee(self) -> str:
        """The name of the class."""
        return self.known.name.rpartition(".")[2]

    @property
    def at(self) -> Place:
        """Where the class is named."""
        return self.whole if self.call is None else self._place(self.call.func)

    def positional_at(self, number: int) -> Place:
        """Where a value without a name stands."""
        plain = [] if self.call is None else self.call.args
        if number < len(plain) and not any(isinstance(each, ast.Starred) for each in plain):
            return self._place(plain[number])
        return self.at

    def expression(self, name: str) -> ast.expr | None:
        """What is written for an argument, where that can be told."""
        if self.call is None:
            return None
        written = self._written.get(name, name)
        for keyword in self.call.keywords:
            if keyword.arg == written:
                return keyword.value
        plain = self.call.args
        index = self.known.arguments.index(name) if name in self.known.arguments[: self.known.positional] else len(plain)
        return plain[index] if index < len(plain) and not any(isinstance(each, ast.Starred) for each in plain) else None

    def where(self, name: str) -> Place:
        """Where the value of an argument stands; the class itself where that cannot be told (``**arguments``)."""
        found = self.expression(name)
        return self.at if found is None else self._place(found)

    def place(self, node: ast.expr) -> Place:
        """Where an expression of the same file stands."""
        return self._place(node)

    def rename(self, old: str, new: str) -> None:
        """Take the value of the keyword ``old`` for that of ``new``."""
        self.values[new] = self.values.pop(old)
        self._written[new] = old

    def keyword_at(self, name: str) -> Place:
        """Where the name of a keyword stands."""
        for keyword in [] if self.call is None else self.call.keywords:
            if keyword.arg == name:
                source, span = self._place(keyword)
                return Place(source, Span(span.start, span.start + len(name)))
        return self.at


def wrong_shape(given: Given, meant: Meant) -> Iterator[Problem]:
    """What is wrong with the names and the number of the arguments, in the order of importance."""
    distro = meant.name
    known = given.known
    stray = [name for name in given.keywords if name not in known.arguments]
    replacements = {name: _replacement(given, name) for name in stray}
    free = tuple(name for name in known.arguments if name not in given.values)
    instead = {replacement for replacement, _ in replacements.values()}
    lacking = [name for name in known.arguments if name in known.required and name not in given.values and name not in instead]
    unknown = [name for name in stray if not any(replacements[name]) and newer(known.name, name, distro) is None]
    alone = len(unknown) == len(lacking) == 1 and given.count <= known.positional and not given.open
    for name in stray:
        origin = Origin(given.keyword_at(name))
        since = newer(known.name, name, distro)
        if since is not None:
            yield KeywordNotInDistribution(
                origin=origin, refused=True, callee=given.callee, keyword=name, distro=distro, since=since[0], sure=since[1]
            )
            continue
        replacement, removed = replacements[name]
        still = meant.before(removed) if removed else ()
        refused = not still or still != meant.named
        yield UnknownKeyword(
            origin=origin,
            refused=refused,
            callee=given.callee,
            keyword=name,
            replacement=replacement,
            since=removed,
            known=free,
            still=still,
            missing=lacking[0] if alone and name in unknown else "",
        )
        if replacement and not refused:
            given.rename(name, replacement)
    if given.count > known.positional:
        extra = tuple(given.positional_at(number) for number in range(known.positional, given.count))
        named = [name for name in lacking if name in known.arguments[known.positional :]]
        names = tuple(named or (name for name in known.arguments[known.positional :] if name not in given.values))
        listed = known.positional == 1 and given.callee in ("PathJoinSubstitution", "PythonExpression", "LaunchDescription", "GroupAction")
        yield TooManyPositional(
            origin=Origin(extra[0]),
            refused=True,
            callee=given.callee,
            count=given.count,
            most=known.positional,
            extra=extra,
            names=names[: len(extra)],
            listed=listed,
            related=((given.positional_at(0), "the first of them"),) if listed else (),
        )
        lacking = lacking[len(extra) :]
    if given.open or alone:
        return
    for name in lacking:
        yield MissingArgument(origin=Origin(given.at), refused=True, callee=given.callee, argument=name)


def _replacement(given: Given, keyword: str) -> tuple[str, str]:
    """What is to be written instead of a keyword, and since when; empty where nobody knows."""
    old = _REPLACED.get(given.callee, {}).get(keyword, "")
    if old:
        return ("", _REMOVED_SINCE) if old in given.values else (old, _REMOVED_SINCE)
    meant = _SLIPS.get(given.callee, {}).get(keyword, "")
    return ("", "") if meant in given.values else (meant, "")
