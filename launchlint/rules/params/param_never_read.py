"""A node is given a param that it does not read.

What it does: where the library knows every param that a node reads, it compares them with those set in the node's private namespace:
inside the `<node>`, by a `<rosparam>` there, or from outside by their full names. It is a warning where the name is nearly that of a
param which the node reads and which is not set, and where the node reads a param of this name in its namespace instead of its private
one; else it is an info: a param may have been removed from the node since, or be there for others to look at. So is a value that is the
default of the param which the node does read: nothing changes with the right name either. Names are compared part by
part, so that `global_costmap/inflation/radus` is near `global_costmap/inflation/radius`, and also where the part in the middle is one that
the node takes from a param. Of a node that may read more than is known, only a slip of one letter is told.

The infos about one YAML file and one program are told as one, and so are those about the same param in several launch files. One finding
are also all params of one program, wherever they are set, that its code reads outside of its private namespace, and the same slip in
several files, or in several names that differ in a number only.

In ROS 2 a param is the node's own, and one that the node does not declare is ignored. It is told where every param that the node
declares is known, and the node takes no others; not of what a parameter file gives to all nodes that match a pattern (`/**`).

## Why it matters

A param of a name that nobody reads is no error for ROS. The node runs with its default, and the value in the launch file does nothing.

## Example

```xml
<launch>
  <node pkg="joy" type="joy_node" name="joy">
    <param name="dead_zone" value="0.1"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="joy" type="joy_node" name="joy">
    <param name="deadzone" value="0.1"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` writes the name of the param that the node reads, where only one is so near: in the `name` of a `<param>`, or as a key of
the YAML in a `<rosparam>`. Keys in YAML files are left alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from launchlint.evaluate.problems import UndeclaredArg
from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.graph.connections import Instance
from launchlint.late import late
from launchlint.library.lookup import Library
from launchlint.model import ROS2, ParameterSetting
from launchlint.rules.edits import Edits, fix, set_value, spot
from launchlint.rules.judging.never_declared import never_declared
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.judging.params_read import UNIVERSAL, declared_by
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.spelling import closest, one_slip
from launchlint.syntax.ros1.substitutions import opens

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_NUMBER = late(r"\d+")
RULE = Rule("LL507", "param-never-read", Severity.WARNING, fixable="unsafe")
_FARTHEST = 3
"""Letters that :func:`~launchlint.spelling.closest` lets two names be apart at most."""
_SHORTEST_SLIP = 5
_SHORTEST_WORD = 3
_MOST_NAMES = 8


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every param that is private to a node."""
    if view.dialect.name == ROS2:
        from launchlint.rules.judging.ros2_params import never_declared

        yield from never_declared(RULE, view)
        return
    graph = view.graph
    instances = {instance.name: instance for instance in graph.instances}
    owners: dict[str, Instance | None] = {}
    reads = _Reads(view)
    unread: list[tuple[ParameterSetting, Instance]] = []
    in_file: Counter[tuple[str, str]] = Counter()
    for setting in graph.launch.parameters.values():
        namespace = setting.name.rpartition("/")[0]
        if namespace not in owners:
            owners[namespace] = _owner(namespace, instances)
        owner = owners[namespace]
        if owner is None:
            continue
        if not is_certain(setting) or not _has_interface(owner) or reads.any_of(setting.name, owner):
            yield RULE.fine(setting.origin)
        elif _is_known(owner) or reads.slip(_inner(setting, owner), owner) is not None:
            unread.append((setting, owner))
            in_file[_file(setting, owner)] += setting.tag == "rosparam"
        else:
            yield RULE.fine(setting.origin)
    for setting, owner in unread:
        several = setting.tag == "rosparam" and in_file[_file(setting, owner)] > 1
        yield _finding(setting, owner, reads, view, several=several)


def _inner(setting: ParameterSetting, owner: Instance) -> str:
    return setting.name[len(owner.name) + 1 :]


def _file(setting: ParameterSetting, owner: Instance) -> tuple[str, str]:
    return setting.origin.place.source.path, owner.program


def _owner(namespace: str, instances: dict[str, Instance]) -> Instance | None:
    """The node whose private namespace ``namespace`` is, or lies in."""
    outer = namespace
    while outer:
        if outer in instances:
            return instances[outer]
        outer = outer.rpartition("/")[0]
    return None


def _has_interface(instance: Instance) -> bool:
    """Whether something is known of the params that the node reads."""
    return not instance.is_unknown and instance.client not in ("", "none", "other") and instance.certain


def _is_known(instance: Instance) -> bool:
    """Whether every param that the node reads is known."""
    return not instance.may_have_more("params")


class _Own:
    """What the code of one node may read."""

    def __init__(self, instance: Instance, library: Library) -> None:
        self.declared = declared_by(instance, library)
        start = f"{instance.name}/"
        self.private = [name[len(start) :] for name in self.declared.names if name.startswith(start)]
        """The params below its own name, without that name."""
        parts = (each.pattern[len(start) :].split("/") for each in self.declared.patterns if each.pattern.startswith(start))
        self._patterns = [each for each in parts if "*" not in each[-1]]
        self._slips: dict[str, list[str]] = {}

    def like(self, inner: str, is_like: Callable[[str], bool]) -> list[str]:
        """Those that ``is_like`` holds for; where a part may be anything it is that of ``inner``."""
        found = [name for name in self.private if is_like(name)]
        parts = inner.split("/")
        for others in self._patterns:
            if len(others) == len(parts):
                full = "/".join(mine if other == "*" else other for mine, other in zip(parts, others, strict=True))
                found += [full] if "*" not in full and is_like(full) else []
        return list(dict.fromkeys(found))

    def slips(self, inner: str) -> list[str]:
        """Those that ``inner`` may be a slip for."""
        if inner not in self._slips:
            self._slips[inner] = self._found_slips(inner)
        return self._slips[inner]

    def _found_slips(self, inner: str) -> list[str]:
        if max(map(len, inner.split("/"))) < _SHORTEST_SLIP:
            return []
        half = (len(inner) - 2) // 2
        start, end = inner[:half], inner[-half:]

        def is_like(name: str) -> bool:  # one slip leaves one of the halves as it is
            return abs(len(name) - len(inner)) <= 1 and (name.startswith(start) or name.endswith(end))

        return [name for name in self.like(inner, is_like) if _is_slip(_differing(inner, name))]


class _Reads:
    """What is read in one launch."""

    def __init__(self, view: GraphView) -> None:
        self._graph = view.graph
        self._view = view
        self._around: set[str] = set()
        for name in self._graph.readers:
            self._around.add(name)
            outer = name.rpartition("/")[0]
            while outer and outer not in self._around:
                self._around.add(outer)
                outer = outer.rpartition("/")[0]
        self._channels = {name for _, name in self._graph.channels}
        self._whole: dict[tuple[str, str], bool] = {}

    def own(self, instance: Instance) -> _Own:
        """What the code of a node may read."""
        return self._view.fact(instance, _Own)

    def unset(self, inner: str, owner: Instance, is_like: Callable[[str], bool]) -> list[str]:
        """As :meth:`_Own.like`: those that are not set."""
        return self._not_set(self.own(owner).like(inner, is_like), owner)

    def slip(self, inner: str, owner: Instance) -> str | None:
        """The only name that ``inner`` must be a slip for, although the node may read more than is known."""
        near = self._not_set(self.own(owner).slips(inner), owner)
        return near[0] if len(near) == 1 else None

    def _not_set(self, names: list[str], owner: Instance) -> list[str]:
        return [name for name in names if not self._graph.parameters.is_set(f"{owner.name}/{name}")]

    def any_of(self, name: str, owner: Instance) -> bool:
        """Whether somebody may read ``name``, which is private to ``owner``, something around it or something below it."""
        if name.rpartition("/")[2] in UNIVERSAL or name in self._around:
            return True
        within = name.rpartition("/")[0], owner.name
        if within not in self._whole:
            self._whole[within] = self._is_read_whole(*within)
        if self._whole[within]:
            return True
        if self.own(owner).declared.may_be(name):
            return True
        return self._graph.unseen.has("params", name)

    def _is_read_whole(self, namespace: str, owner: str) -> bool:
        """Whether a mapping around may be read as a whole; params of image_transport and actionlib lie below their topics."""
        outer = namespace
        while outer:
            if outer in self._graph.readers or (outer != owner and outer in self._channels):
                return True
            outer = outer.rpartition("/")[0]
        return False


def _finding(setting: ParameterSetting, owner: Instance, reads: _Reads, view: GraphView, *, several: bool) -> Finding:
    inner, declared = _inner(setting, owner), reads.own(owner).declared
    if _is_known(owner):
        elsewhere = next((name for name in sorted(declared.names) if declared.names[name].lstrip("/") == inner), None)
        candidates = _near(inner, reads.unset(inner, owner, lambda name: abs(len(name) - len(inner)) <= _FARTHEST))
    else:
        slip = reads.slip(inner, owner)
        elsewhere, candidates = None, [] if slip is None else [slip]
    near = closest(inner, candidates)
    if elsewhere is not None:
        help_ = f"{owner.program} reads {elsewhere}, not a private param: set it outside the <node>"
    elif near is not None:
        help_ = f"did you mean {near}?"
    else:
        help_ = "remove it, unless somebody else looks at it"
    meant = elsewhere if elsewhere is not None else f"{owner.name}/{near}" if near is not None else ""
    as_default = bool(meant) and _is_default(setting.value, meant, owner, view)
    if as_default:
        help_ = f"remove it, since its value is the default of {elsewhere or near}, which {owner.program} reads"
    return RULE.at(
        setting.origin,
        f"{owner.program} does not read the param {inner}, which is set for {owner.name}",
        severity=Severity.WARNING if meant and not as_default else Severity.INFO,
        label="never read" if elsewhere is None else f"never read, but {elsewhere} is",
        notes=(_listed(reads.own(owner).private, everything=_is_known(owner)),),
        help=help_,
        topic=inner,
        cause=_cause(setting, owner, inner, elsewhere, near, several=several, as_default=as_default),
        shared_cause=_misspelt_arg(setting, near, view),
        fix=_fix(setting, owner, inner, candidates[0], view) if elsewhere is None and len(candidates) == 1 and not as_default else None,
    )


def _cause(
    setting: ParameterSetting, owner: Instance, inner: str, elsewhere: str | None, near: str | None, *, several: bool, as_default: bool
) -> str:
    """What several findings share: the file in which all params are private that are not, the slip that was copied, the param."""
    path, default = setting.origin.place.source.path, " as default" * as_default
    if elsewhere is not None:
        package = owner.program.partition("/")[0]
        return f"{package} reads others{default}"  # whoever thinks so of one robot, or program, thinks so of the next
    if near is not None and inner.startswith("_"):  # as on a command line, in the whole file
        return f"{path}: {owner.program} _{default}"
    if near is not None:
        wrong, right = _wrong_word(inner, near)
        return f"{owner.program} {_NUMBER.sub('#', wrong)} for {_NUMBER.sub('#', right)}{default}"  # of one that is written for each arm
    return f"{path}: {owner.program}" if several else f"{owner.program} {inner}"


def _misspelt_arg(setting: ParameterSetting, near: str | None, view: GraphView) -> str:
    """The cause that LL201 and LL206 tell where the value asks for an arg by the same slip that the name of the param has; else none."""
    name, source = setting.name.rpartition("/")[2], setting.origin.place.source
    asked = (each for each in view.launch.noticed(UndeclaredArg) if each.name == name and each.place.source is source)
    return never_declared(source.path, name) if near is not None and any(near in each.known for each in asked) else ""


def _wrong_word(inner: str, near: str) -> tuple[str, str]:
    """The only word that differs, as it is written and as it is read: several params may have it; else what the longer name has more at
    its end, be it a ``_``; else the whole names.
    """
    words, others = (each.replace("/", "_").split("_") for each in (inner, near))
    apart = [pair for pair in zip(words, others, strict=True) if pair[0] != pair[1]] if len(words) == len(others) else []
    if len(apart) == 1:
        return apart[0]
    return (
        ("…" + inner[len(near) :], "…")
        if inner.startswith(near)
        else ("…", "…" + near[len(inner) :])
        if near.startswith(inner)
        else (inner, near)
    )


def _is_default(value: Any, name: str, owner: Instance, view: GraphView) -> bool:
    """Whether ``value`` is the default of ``owner`` for the param ``name``; 10 and 10.0 are the same, 1 and true are not."""
    defaults = [each.declaration.default for each in view.graph.readers.get(name, ()) if each.node == owner.name]
    return any(each is not None and isinstance(each, bool) == isinstance(value, bool) and each == value for each in defaults)


def _fix(setting: ParameterSetting, owner: Instance, inner: str, near: str, view: GraphView) -> Fix | None:
    """The name ``near`` in place of ``inner``, both private to ``owner``."""
    edits = _in_name(setting, inner, near, view) if setting.tag == "param" else _in_yaml(setting, inner, near, view)
    return fix(f"write {near}", edits, safe=False, changes=f"{owner.name} reads {near} from the launch file")


def _in_name(setting: ParameterSetting, inner: str, near: str, view: GraphView) -> Edits:
    """In the ``name`` of the ``<param>``, which may say more than ``inner``, or less where it stands in a ``<group>``."""
    at = spot(view, setting.origin.place)
    name = at.element.attributes.get("name") if at is not None else None
    if name is None or name.raw != name.value or opens(name.value) or "~" in name.value:
        return ()
    written, wrong, right = (text.strip().split("/") for text in (name.value, inner, near))
    shared = min(len(written), len(wrong))
    if written[-shared:] != wrong[-shared:] or wrong[:-shared] != right[:-shared]:
        return ()
    return set_value(at, "/".join((*written[:-shared], *right[-shared:])), name)


def _in_yaml(setting: ParameterSetting, inner: str, near: str, view: GraphView) -> Edits:
    """As the last key in the YAML of the ``<rosparam>``."""
    source, span = setting.origin.place
    outer, _, key = inner.rpartition("/")
    outer_near, _, key_near = near.rpartition("/")
    if source.path not in view.documents or outer != outer_near or setting.origin.place.text != key:
        return ()
    if not key_near.replace("_", "a").isalnum():
        return ()  # YAML may take it for something else
    return (Edit(source.path, *span, key_near),)


def _near(name: str, names: list[str]) -> list[str]:
    """The names that ``name`` may be a slip for: one part of it differs, by a few letters, and not in its digits."""
    candidates: list[str] = []
    for other in names:
        part = _differing(name, other)
        if part is not None and closest(part[0], [part[1]]) is not None:
            candidates.append(other)
    return [other for other in candidates if closest(name, [other]) is not None]


def _is_slip(part: tuple[str, str] | None) -> bool:
    """Whether two parts of names are one letter apart, and not as siblings are: ``vel_x`` and ``vel_y``, ``topic`` and ``topics``."""
    if part is None or min(map(len, part)) < _SHORTEST_SLIP:
        return False
    one, other = part
    words = [pair for pair in zip(one.split("_"), other.split("_"), strict=False) if pair[0] != pair[1]]
    if one.rstrip("s") == other.rstrip("s") or any(max(map(len, pair)) < _SHORTEST_WORD for pair in words):
        return False
    return one_slip(one, (other,)) is not None


def _differing(name: str, other: str) -> tuple[str, str] | None:
    """The only part in which two names differ, as it is in each of them."""
    parts, others = name.split("/"), other.split("/")
    apart = [pair for pair in zip(parts, others, strict=True) if pair[0] != pair[1]] if len(others) == len(parts) else []
    return apart[0] if len(apart) == 1 else None


def _listed(private: Sequence[str], *, everything: bool) -> str:
    """What the node reads, for people who look for the right name."""
    more = len(private) > _MOST_NAMES or not everything
    return f"it reads {', '.join(sorted(private)[:_MOST_NAMES])}{' …' if more else ''}" if private else "it reads no private params"
