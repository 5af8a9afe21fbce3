"""A parameter is set twice to the same value in one file.

Told are two settings of which the second happens whenever the first does: two `<param>` in one node, in one scope, or in
one file, and parameters in the YAML text of a `<rosparam>`. YAML files, included files, and values or names that are the
same only for some args do not count. Two values that differ are told of by LL504.

## Why it matters

Nothing is wrong until somebody changes the value in one of the two places: if it is the first, the change has no
effect.

## Example

```xml
<launch>
  <param name="use_sim_time" value="true"/>
  <node pkg="map_server" type="map_server" name="map_server" args="office.yaml"/>
  <param name="/use_sim_time" value="true"/>
</launch>
```

## Use instead

```xml
<launch>
  <param name="use_sim_time" value="true"/>
  <node pkg="map_server" type="map_server" name="map_server" args="office.yaml"/>
</launch>
```

## Fix

`--fix` removes the element with the first of the two, unless it sets another parameter too. The parameters are the same as before, which is
proved before it is done.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.named_tuple import NamedTuple
from launchlint.rules.edits import begun_before, fix, remove_element, spot
from launchlint.rules.judging.param_values import is_same, shown
from launchlint.rules.judging.set_again import SetAgain, set_again
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place
from launchlint.syntax.ros1.substitutions import opens
from launchlint.syntax.tree import Element

RULE = Rule("LL514", "param-repeated", Severity.INFO, fixable="safe")

_MOST_NAMES = 3


class _Twice(NamedTuple):
    """Two elements that set the same parameters, ``names``; the first of these, and the ``element`` that it is set by first."""

    again: SetAgain
    element: Element
    names: list[str]


def check(view: LaunchView) -> Iterator[Finding]:
    """Look at every parameter that is set again to the value that it has, in the same file."""
    found: dict[tuple[str, int, int], _Twice] = {}
    for again in set_again(view.launch):
        first, second = again.first.place, again.second.place
        if first.source is not second.source or not is_same(again.old, again.new) or again.first.chain != again.second.chain:
            continue
        one, other = _element(view, first), _element(view, second)
        if one is None or other is None or one is other:
            continue
        key = (first.source.path, one.index, other.index)
        if key in found:
            found[key].names.append(again.name)
        elif _is_always_so(one, other, included=again.first.step is not None):
            found[key] = _Twice(again, one, [again.name])
    starts = _starts(view) if found else {}
    yield from (_finding(twice, view, starts) for twice in found.values())


def _element(view: LaunchView, place: Place) -> Element | None:
    """The element that sets the parameter; None where it stands in no launch file."""
    document = view.documents.get(place.source.path)
    return begun_before(document, place.span.start) if document is not None and document.source is place.source else None


def _is_always_so(first: Element, second: Element, *, included: bool) -> bool:
    """Whether the two set the same for all args, and, in a file that is ``included``, in all namespaces."""
    if first.parent is second.parent and _written(first) == _written(second):
        return True
    if included and _is_global(first) != _is_global(second):
        return False
    around: dict[int, str] = {}
    for element in (first, second):
        outer = element.parent
        while outer is not None:
            around[outer.index] = "".join(outer.attributes[name].value for name in ("ns", "name") if name in outer.attributes)
            outer = outer.parent
    return not any(opens(text) for text in (*_written(first), *_written(second), *around.values()))


def _written(element: Element) -> list[str]:
    """What says which parameters are set, and to what; it does not matter under which condition."""
    return [*sorted(f"{each.name}={each.value}" for each in element.attributes.values() if each.name not in ("if", "unless")), element.text]


def _is_global(element: Element) -> bool:
    return any((element.get(name) or "").strip().startswith("/") for name in ("name", "param", "ns"))


def _starts(view: LaunchView) -> dict[str, list[int]]:
    """By file, where it sets parameters; sorted, and once for each parameter."""
    found: dict[str, set[tuple[int, str]]] = {}
    for each in view.launch.parameter_settings:
        source, span = each.origin.place
        found.setdefault(source.path, set()).add((span.start, each.name))
    return {path: sorted(start for start, _ in settings) for path, settings in found.items()}


def _finding(twice: _Twice, view: LaunchView, starts: dict[str, list[int]]) -> Finding:
    again, element, names = twice
    first = again.first.place
    if len(names) == 1:
        message = f"{again.name} is set to {shown(again.new)} twice"
    else:
        more = f" and {len(names) - _MOST_NAMES} more" if len(names) > _MOST_NAMES else ""
        message = f"{', '.join(names[:_MOST_NAMES])}{more} are set again, to the values they have"
    own = starts.get(first.source.path, [])
    removal = None
    if again.settings is None or bisect_left(own, element.span.end) - bisect_left(own, element.span.start) == len(names):
        removal = fix("remove the first", remove_element(spot(view, Place(first.source, element.start_span))), safe=True)
    return RULE.at(
        again.second,
        message,
        label="once more",
        related=((first, "the first one"),),
        help="remove one of the two",
        fix=removal,
        topic=again.name.rsplit("/", 1)[-1],
    )
