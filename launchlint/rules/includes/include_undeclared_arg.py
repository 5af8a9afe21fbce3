"""An `<include>` passes an arg that the included file does not declare.

What it does: it compares the `<arg>` children of every include with the args that the included file declares at its top level, in
this configuration. An arg that is declared only in a group, or under a condition that is false, does not count. All such args of an
include are told together.

## Why it matters

roslaunch refuses the whole launch. It is also how a mistyped arg shows.

## Example

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="frame_rat" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/camera.launch">
    <arg name="frame_rate" value="15"/>
  </include>
</launch>
```

```xml camera.launch
<launch>
  <arg name="frame_rate" default="30"/>
  <node pkg="usb_cam" type="usb_cam_node" name="camera">
    <param name="framerate" value="$(arg frame_rate)"/>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` passes the most similar arg that the included file declares, where it is not passed yet.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import islice

from launchlint.evaluate.problems import IncludeUndeclaredArg, UndeclaredArg
from launchlint.finding import Finding, Severity
from launchlint.plural import listed
from launchlint.rules.edits import LOADS, passed_under, spot
from launchlint.rules.judging.broken_call import MOVE, undeclared_call
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.spelling import closest, did_you_mean

RULE = Rule("LL403", "include-undeclared-arg", Severity.ERROR, roslaunch="refuses", fixable="unsafe")

_TO_THE_TOP = "to the top level of the included file, without a condition"
_DOES_NOT_COUNT = "declared in a group or under a false condition: that does not count"
_REMOVE = "remove it here, or declare it there"
_REMOVE_ALL = "remove them here, or declare them there"
_MOST_NAMED = 8
_MOST_LISTED = 40
"""Names of args that are taken, and of args that are not, in one finding: more than anybody writes by hand."""
_STOPS = "roslaunch stops with"
_near = lru_cache(maxsize=256)(closest)  # the same is asked in every configuration


def tell(problem: IncludeUndeclaredArg, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``include-undeclared-arg`` (roslaunch.loader.LoaderContext, ``post_process_include_args``)."""
    name, file, known = problem.name, problem.file, problem.known
    undeclared: tuple[str, ...] = problem.undeclared
    several = len(undeclared) > 1
    if name not in undeclared[:_MOST_LISTED]:
        return  # told with the others
    declared = view.once(_Declared).anywhere(file)
    elsewhere = {each: declared[each] for each in undeclared if each in declared}
    has = ", ".join(known[:_MOST_NAMED]) + (" …" if len(known) > _MOST_NAMED else "")
    names = listed(undeclared, _MOST_LISTED)
    notes = [f"roslaunch stops with: unused args [{names}] for include of [{file}]"]
    unset = _unset_in(problem.place, view)
    if unset:
        notes = [f"roslaunch stops even before that, since {unset} is not declared either; once it is, with{notes[0].removeprefix(_STOPS)}"]
    notes.append(f"{file} takes: {has}" if known else f"{file} takes no args")
    yield RULE.at(
        problem.origin,
        f"{file} does not declare the {'args' if several else 'arg'} {names}",
        label=f"{name} is passed here" if several else "passed here",
        shared_cause=undeclared_call(file, undeclared, known),
        related=tuple((place, _DOES_NOT_COUNT) for place in islice(elsewhere.values(), _MOST_LISTED)),
        notes=tuple(notes),
        help=_help(undeclared, known, tuple(elsewhere)),
        fix=None if name in elsewhere else passed_under(view, problem.place, name, _near(name, known), "" if several else f"{LOADS}, and "),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for the same args that one file passes, in the same words, to several files that do not declare them."""
    for several in alike(findings, lambda each: (each.location.path, each.location.text.strip(), each.help)):
        yield joined(several) if len(several) > 1 else several[0]


def idea(finding: Finding) -> tuple[object, ...] | None:
    """One file passes the same arg, in the same words, to several files that do not declare it, be it with others that one does not."""
    return (finding.location.path, finding.location.text.strip()) if finding.help in (_REMOVE, _REMOVE_ALL) else None


def _unset_in(place: Place, view: LaunchView) -> str:
    """The arg without a declaration that the include with the arg at ``place`` reads; empty where it reads none."""
    at = spot(view, place)
    if at is None or at.element.parent is None:
        return ""
    read = view.once(_undeclared_reads)
    return next((read[key] for each in at.element.parent.children if (key := (place.source.path, each.index)) in read), "")


def _undeclared_reads(view: LaunchView) -> dict[tuple[str, int], str]:
    """The args that are read and not declared, by the element that reads them."""
    found: dict[tuple[str, int], str] = {}
    for problem in view.launch.noticed(UndeclaredArg):
        at = spot(view, problem.place)
        if at is not None:
            found.setdefault((problem.place.source.path, at.element.index), problem.name)
    return found


def _help(undeclared: tuple[str, ...], known: tuple[str, ...], elsewhere: tuple[str, ...]) -> str:
    """What to do about each of the args, of which some are declared ``elsewhere`` in the file."""
    if len(undeclared) == 1:
        if elsewhere:
            return f"{MOVE}its declaration {_TO_THE_TOP}"
        return did_you_mean(undeclared[0], known) or _REMOVE
    unknown = (name for name in undeclared if name not in elsewhere)
    near = {name: other for name in islice(unknown, _MOST_LISTED) if (other := _near(name, known)) is not None}
    advice = [f"{MOVE}the declarations of {listed(elsewhere, _MOST_LISTED)} {_TO_THE_TOP}"] if elsewhere else []
    advice += [f"is {other} meant by {name}?" for name, other in near.items()]
    if len(elsewhere) + len(near) < len(undeclared):
        advice.append("remove the others here, or declare them there" if advice else _REMOVE_ALL)
    return "; ".join(advice).replace("?;", "?")


class _Declared:
    """Where the files of a launch hold an ``<arg>`` that no include passes, wherever in the file it stands."""

    def __init__(self, view: LaunchView) -> None:
        self._documents = view.documents
        self._places: dict[str, dict[str, Place]] = {}

    def anywhere(self, file: str) -> Mapping[str, Place]:
        """The first ``<arg>`` of each name."""
        if file not in self._places:
            found = self._places[file] = {}
            document = self._documents.get(file)
            for each in () if document is None else document.elements:
                named = each.attributes.get("name") if each.tag == "arg" else None
                if document is not None and named is not None and each.parent is not None and each.parent.tag.lower() != "include":
                    found.setdefault(named.value, document.place(named.value_span))
        return self._places[file]
