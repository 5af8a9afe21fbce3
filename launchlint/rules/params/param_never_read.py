"""A node is given a param that it does not read.

What it does: where the library knows every param that a node reads, it compares them with those set in the node's private namespace:
inside the `<node>`, by a `<rosparam>` there, or from outside by their full names. It is a warning where the name is nearly that of a
param which the node reads and which is not set, and where the node reads a param of this name in its namespace instead of its private
one; else it is an info: a param may have been removed from the node since, or be there for others to look at.

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

from collections.abc import Iterator

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.graph.connections import ConnectionGraph, Instance
from launchlint.library.lookup import Library
from launchlint.model import ParameterSetting
from launchlint.rules.edits import Edits, fix, set_value, spot
from launchlint.rules.params.reads import UNIVERSAL, Declared, declared_by
from launchlint.rules.params.values import is_certain
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.spelling import closest

RULE = Rule("LL507", "param-never-read", Severity.WARNING, fixable="unsafe")


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every param that is private to a node."""
    graph = view.graph
    instances = {instance.name: instance for instance in graph.instances}
    reads = _Reads(graph, view.library)
    for setting in graph.launch.parameters.values():
        owner = _owner(setting.name, instances)
        if owner is None:
            continue
        if not is_certain(setting) or not _is_known(owner) or reads.any_of(setting.name, owner):
            yield RULE.fine(setting.origin)
            continue
        yield _finding(setting, owner, reads.declared(owner), view)


def _owner(name: str, instances: dict[str, Instance]) -> Instance | None:
    """The node in whose private namespace ``name`` lies."""
    outer = name.rpartition("/")[0]
    while outer:
        if outer in instances:
            return instances[outer]
        outer = outer.rpartition("/")[0]
    return None


def _is_known(instance: Instance) -> bool:
    """Whether every param that the node reads is known."""
    return not instance.may_have_more("params") and instance.client not in ("", "none", "other") and instance.certain


class _Reads:
    """What is read in one launch."""

    def __init__(self, graph: ConnectionGraph, library: Library) -> None:
        self._graph = graph
        self._library = library
        self._declared: dict[str, Declared] = {}
        self._around: set[str] = set()
        for name in graph.readers:
            self._around.add(name)
            outer = name.rpartition("/")[0]
            while outer and outer not in self._around:
                self._around.add(outer)
                outer = outer.rpartition("/")[0]
        self._channels = {name for _, name in graph.channels}

    def declared(self, instance: Instance) -> Declared:
        """What the code of a node may read."""
        if instance.name not in self._declared:
            self._declared[instance.name] = declared_by(instance, self._library)
        return self._declared[instance.name]

    def any_of(self, name: str, owner: Instance) -> bool:
        """Whether somebody may read ``name``, which is private to ``owner``, something around it or something below it."""
        if name.rpartition("/")[2] in UNIVERSAL or name in self._around:
            return True
        outer = name.rpartition("/")[0]
        while outer:  # a mapping that is read as a whole; params of image_transport and actionlib lie below their topics
            if outer in self._graph.readers or (outer != owner.name and outer in self._channels):
                return True
            outer = outer.rpartition("/")[0]
        if self.declared(owner).may_be(name):
            return True
        return any(doubt.may_be(name) for doubt, _ in self._graph.missing["params"].doubts)


def _finding(setting: ParameterSetting, owner: Instance, declared: Declared, view: GraphView) -> Finding:
    inner = setting.name[len(owner.name) + 1 :]
    private = {name[len(owner.name) + 1 :]: name for name in declared.names if name.startswith(f"{owner.name}/")}
    elsewhere = next((name for name in sorted(declared.names) if declared.names[name].lstrip("/") == inner), None)
    candidates = _near(inner, [name for name, full in private.items() if not view.graph.parameters.is_set(full)])
    near = closest(inner, candidates)
    if elsewhere is not None:
        help_ = f"{owner.program} reads {elsewhere}, not a private param: set it outside the <node>"
    elif near is not None:
        help_ = f"did you mean {near}?"
    else:
        help_ = "remove it, unless somebody else looks at it"
    return RULE.at(
        setting.origin,
        f"{owner.program} does not read the param {inner}, which is set for {owner.name}",
        severity=Severity.WARNING if elsewhere is not None or near is not None else Severity.INFO,
        label="never read",
        notes=(_reads(private),),
        help=help_,
        topic=inner,
        fix=_fix(setting, owner, inner, candidates[0], view) if elsewhere is None and len(candidates) == 1 else None,
    )


def _fix(setting: ParameterSetting, owner: Instance, inner: str, near: str, view: GraphView) -> Fix | None:
    """The name ``near`` in place of ``inner``, both private to ``owner``."""
    edits = _in_name(setting, inner, near, view) if setting.tag == "param" else _in_yaml(setting, inner, near, view)
    return fix(f"write {near}", edits, safe=False, changes=f"{owner.name} reads {near} from the launch file")


def _in_name(setting: ParameterSetting, inner: str, near: str, view: GraphView) -> Edits:
    """In the ``name`` of the ``<param>``, which may say more than ``inner``, or less where it stands in a ``<group>``."""
    at = spot(view, setting.origin.place)
    name = at.element.attributes.get("name") if at is not None else None
    if name is None or name.raw != name.value or "$(" in name.value or "~" in name.value:
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
    parts = name.split("/")
    candidates: list[str] = []
    for other in names:
        others = other.split("/")
        apart = [at for at in range(len(parts)) if parts[at] != others[at]] if len(others) == len(parts) else []
        if len(apart) == 1 and closest(parts[apart[0]], [others[apart[0]]]) is not None and _digits(other) == _digits(name):
            candidates.append(other)
    return [other for other in candidates if closest(name, [other]) is not None]


def _reads(private: dict[str, str]) -> str:
    """What the node reads, for people who look for the right name."""
    return f"it reads {', '.join(sorted(private)[:8])}{' …' if len(private) > 8 else ''}" if private else "it reads no private params"


def _digits(name: str) -> str:
    return "".join(filter(str.isdigit, name))
