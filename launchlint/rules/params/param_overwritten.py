"""A parameter is set twice, and the first value has no effect.

Told is what nobody writes on purpose: the same parameter set again to another value in the same file, by a file that
is included afterwards, or by a YAML file that is loaded afterwards. Silent are the usual ways to override a value: a
YAML file and single parameters after it, several YAML files from the general to the special, a parameter set after
the include whose value it replaces, a `~param` of a group that a node sets again, and a second setting under a
condition. It is an info where both are written alike, and only one of them is a text, and where an arg chooses the file
that is included afterwards: what stands in front of it is for all of these files, and the chosen one says what is special.

What two tests of one name set, LL313 tells. Two included files that disagree about a parameter are told as an info. Three or more values
of one parameter are one finding. The same two values of the same parameter in several files, which were copied with the mistake in them,
are told as one.

## Why it matters

The last setting wins silently, so that the value one reads is not the value the robot runs with.

## Example

```xml
<launch>
  <param name="robot/max_speed" value="0.5"/>
  <param name="robot/frame" value="base_link"/>
  <param name="robot/max_speed" value="1.5"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="fast" default="false"/>
  <param name="robot/max_speed" value="0.5"/>
  <param name="robot/frame" value="base_link"/>
  <param name="robot/max_speed" value="1.5" if="$(arg fast)"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rules.edits import spot
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.param_values import is_same, shown
from launchlint.rules.judging.set_again import SetAgain, set_again
from launchlint.rules.nodes import test_shadows_node
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

RULE = Rule("LL504", "param-overwritten", Severity.WARNING)
_NUMBER = late(r"\d+")


def check(view: LaunchView) -> Iterator[Finding]:
    """Compare each setting with the one before it of the same name."""
    launch = view.launch
    values: dict[tuple[str, object], str] = {}
    tests = {test.full_name for _, test in test_shadows_node.twins(launch)}
    launch_files = {id(launch.entry)} | {id(include.source) for include in launch.includes if include.source is not None}
    for again in set_again(launch):
        if is_same(again.old, again.new):
            continue
        if again.settings is None:
            yield _of_many(again, _finding(again, Severity.INFO if _is_written_alike(again) else Severity.WARNING), values)
            continue
        if id(again.first.place.source) not in launch_files or _is_from_file(again.first, view):
            continue  # a YAML file: what comes after it is meant to override it
        single = id(again.second.place.source) in launch_files and not _is_from_file(again.second, view)
        severity = _severity(again.first, again.second, view, single=single)
        if severity is not None:
            found = _finding(again, Severity.INFO if _is_written_alike(again) else severity)
            if not single:
                found = found._replace(help="put the <param> behind the <rosparam> that loads the file, or remove it")
            earlier, later = again.settings
            if earlier.tag == "rosparam" and later.node is not None:
                found = found._replace(notes=("in a node, <param> counts over <rosparam>, whichever comes first",))
            twin = next((each for each in tests if again.name.startswith(f"{each}/")), None)
            yield _of_many(again, found, values) if twin is None else found._replace(cause=test_shadows_node.named(twin))


def together(findings: Sequence[Finding]) -> Finding:
    """Where two tests of one name set private parameters, that name is what is wrong."""
    return led_by(findings, test_shadows_node.RULE.id)


def idea(finding: Finding) -> tuple[object, ...] | None:
    """The params of one node are set twice in the same files: a block of them was pasted, or stands in both."""
    namespace, name = finding.about[:2] if finding.about[1:] else ("", "/")
    if not finding.related or not (namespace or "/" not in name):  # a private one of a node whose name is not known has no slash
        return None
    return (finding.location.path, finding.related[0].location.path, finding.help, namespace)


def _of_many(again: SetAgain, found: Finding, values: dict[tuple[str, object], str]) -> Finding:
    """``found``, of one cause with the one about the value before it, where a parameter has three or more in one launch."""
    cause = values.setdefault((again.name, again.first.place.key), found.cause)
    values[again.name, again.second.place.key] = cause
    return found._replace(cause=cause)


def _is_written_alike(again: SetAgain) -> bool:
    """Whether one of the two is the text that the other one is written as: ``"true"`` and true differ in their type alone."""
    return isinstance(again.old, str) != isinstance(again.new, str) and shown(again.old).strip('"') == shown(again.new).strip('"')


def _is_from_file(origin: Origin, view: LaunchView) -> bool:
    """Whether it stands at a ``<rosparam>`` that loads a YAML file: with ``subst_value`` what is read has no place in that file."""
    at = spot(view, origin.place)
    return at is not None and at.element.tag == "rosparam" and "file" in at.element.attributes


def _is_chosen(include: Place, view: LaunchView) -> bool:
    """Whether an arg says which file is included there."""
    at = spot(view, include)
    file = "" if at is None else at.element.get("file") or ""
    return "$(arg " in file or "$(eval " in file


def _severity(earlier: Origin, later: Origin, view: LaunchView, *, single: bool) -> Severity | None:
    """How sure it is that nobody meant it; None where overriding is what people do. ``single``: the later one is no YAML file."""
    outer, inner = earlier.chain, later.chain
    if inner[: len(outer)] == outer:  # in the same file, or in one that it includes afterwards
        return Severity.INFO if any(_is_chosen(place, view) for place in inner[len(outer) :]) else Severity.WARNING
    if outer[: len(inner)] == inner:
        return None  # set again after the include
    return Severity.INFO if single else None


def _finding(again: SetAgain, severity: Severity) -> Finding:
    last = again.name.rsplit("/", 1)[-1]
    behind = again.first.place.source is not again.second.place.source
    return RULE.at(
        again.first,
        f"{again.name} is set to {shown(again.old)} here, and to {shown(again.new)} afterwards: the last value counts",
        severity=severity,
        label="has no effect",
        related=((again.second.place, "set again here"),),
        help="set it once; to override a value of an included file, set it behind the <include>, or pass an arg"
        if behind
        else "remove one of the two, or put a condition on the second",
        topic=last,
        cause=f"{_NUMBER.sub('#', last)} {_unnumbered(again.old)} {_unnumbered(again.new) if behind else ''}",
        about=(again.name.rpartition("/")[0], again.name),
    )


def _unnumbered(value: object) -> str:
    """The value for people, a text without its numbers: what is written for each of several robots is one."""
    return _NUMBER.sub("#", shown(value)) if isinstance(value, str) else shown(value)
