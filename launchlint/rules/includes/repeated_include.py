"""The same file is included twice, in the same way, in one scope.

What it does: it looks for two `<include>` tags beside each other in one `<launch>` or `<group>` that are written with the same
attributes and the same args. It looks at launch files of ROS 1: in ROS 2 the second include starts its nodes once more, which LL301
tells.

## Why it matters

The second one starts nothing new. If the file has nodes, roslaunch refuses the second copy of each; if it only sets
parameters, it sets them again. Mostly a line was copied and one word in it was to be changed.

## Example

```xml
<launch>
  <include file="$(dirname)/calibration.launch"><arg name="side" value="left"/></include>
  <include file="$(dirname)/calibration.launch"><arg name="side" value="left"/></include>
</launch>
```

```xml calibration.launch
<launch>
  <arg name="side"/>
  <param name="calibrated/$(arg side)" value="true"/>
</launch>
```

## Use instead

```xml
<launch>
  <include file="$(dirname)/calibration.launch"><arg name="side" value="left"/></include>
  <include file="$(dirname)/calibration.launch"><arg name="side" value="right"/></include>
</launch>
```

```xml calibration.launch
<launch>
  <arg name="side"/>
  <param name="calibrated/$(arg side)" value="true"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.syntax.ros1.substitutions import parts_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.tree import Element

RULE = Rule("LL410", "repeated-include", Severity.WARNING)


def check(view: FileView) -> Iterator[Finding]:
    """Yield a finding for each repeated include. One with ``$(anon …)`` in it makes a new name each time and is in order."""
    first: dict[tuple[object, ...], Element] = {}
    document = view.document
    for element in document.elements:
        if element.tag != "include" or element.parent is None or not element.get("file"):
            continue
        written = _written(element)
        known = first.setdefault((element.parent.index, written), element)
        if known is not element and not _makes_up_names(element):
            yield RULE.at(
                document.place(element.start_span),
                f"{element.get('file')} is included a second time in the same way",
                label="again",
                related=((document.place(known.start_span), "the first one"),),
                notes=("the second one can only start nodes that are there already, or set again what is set",),
                help="remove it, or change what was to be different",
            )


def _written(element: Element) -> tuple[object, ...]:
    attributes = tuple(sorted((name, attribute.value) for name, attribute in element.attributes.items()))
    return (element.tag, attributes, tuple(_written(child) for child in element.children))


def _makes_up_names(element: Element) -> bool:
    own = any(any(parts_of(attribute).substitutions("anon")) for attribute in element.attributes.values())
    return own or any(map(_makes_up_names, element.children))
