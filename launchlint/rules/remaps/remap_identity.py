"""A remap gives a name its own name.

In ROS 2 it is told where no other remap of the node is for that name: of two the first counts, so that one like this takes the other out of
effect.

## Why it matters

It does nothing, unless a scope around it remaps the same name: then it takes that back for this node. Where it is
only there to show the name it can go, and where one side is a slip of the pen, the remap that was wanted is missing.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <remap from="scan" to="base_scan"/>
  </node>
</launch>
```

## Fix

`--fix` removes it. The nodes work as before, which is proved before it is done.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from launchlint.evaluate.names import canonical
from launchlint.finding import Finding, Severity
from launchlint.rules.edits import Spot, fix, remove_element
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, of_ros2
from launchlint.syntax.tree import Element

RULE = Rule("LL605", "remap-identity", Severity.INFO, fixable="safe")


def check(view: FileView) -> Iterator[Finding]:
    """Compare ``from`` and ``to`` as they are written."""
    if of_ros2(view):
        from launchlint.rules.judging.ros2_written import remapped_to_themselves

        for name, place in remapped_to_themselves(view):
            yield RULE.at(place, f"{name} is remapped to itself", label="does nothing", help="remove it, or correct one of the names")
        return
    document = view.document
    remapped: dict[int, set[str]] = {}
    for element in document.elements:
        if element.tag.lower() != "remap" or element.parent is None:
            continue
        source, target = _name(element, "from"), _name(element, "to")
        if source and source == target and not _takes_back(element, source, remapped):
            yield RULE.at(
                document.place(element.start_span),
                f"{source} is remapped to itself",
                label="does nothing",
                help="remove it, or correct one of the names",
                fix=fix("remove it", remove_element(Spot(document, element, None)), safe=True),
            )
        remapped.setdefault(element.parent.index, set()).add(source)


def _name(element: Element, attribute: str) -> str:
    return canonical((element.get(attribute) or "").strip())


def _takes_back(element: Element, source: str, remapped: Mapping[int, set[str]]) -> bool:
    """Whether an earlier remap of the same name, in this scope or one around it, is in force here: then this one takes it back."""
    scope = element.parent
    while scope is not None:
        if source in remapped.get(scope.index, ()):
            return True
        scope = scope.parent
    return False
