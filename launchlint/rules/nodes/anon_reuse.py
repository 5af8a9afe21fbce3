"""An `$(anon id)` is used again in another scope, where it stands for another name.

What it does: it follows every `$(anon id)` of a file through its groups. One id stands for one name in the scope where it is
first used and in the groups opened after that; in a sibling group it stands for a new one. It speaks where an id names a node in
one scope and is used in another to mean that node. (Two nodes that get one name from one id are LL301.)

## Why it matters

The parameter, argument or remap goes to a name that no node has, and roslaunch says nothing.

## Example

```xml
<launch>
  <group>
    <node pkg="usb_cam" type="usb_cam_node" name="$(anon camera)"/>
  </group>
  <param name="$(anon camera)/framerate" value="15"/>
</launch>
```

## Use instead

```xml
<launch>
  <group>
    <node pkg="usb_cam" type="usb_cam_node" name="$(anon camera)"/>
    <param name="$(anon camera)/framerate" value="15"/>
  </group>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.source import Place, Span
from launchlint.syntax.ros1.substitutions import parts_of
from launchlint.syntax.tree import Element

RULE = Rule("LL312", "anon-reuse", Severity.WARNING)

_DEEPEST = 200


def check(view: FileView) -> Iterator[Finding]:
    """Yield one finding for each use of an id that names a node elsewhere only (roslaunch.substitution_args._anon)."""
    document = view.document
    if document.launch is None or "anon" not in document.source.text:
        return
    walk = _Walk()
    walk.children(document.launch, {}, 0)
    for name, (identity, span) in ((name, use) for name, uses in walk.uses.items() for use in uses):
        nodes = walk.nodes.get(name, {})
        if not nodes or identity in nodes:
            continue
        related = tuple((Place(document.source, where), "the node of that id") for where in list(nodes.values())[:3])
        yield RULE.at(
            Place(document.source, span),
            f"$(anon {name}) stands for another name here than for the node",
            label="a new name, which no node has",
            related=related,
            notes=("an anon id stands for one name in the scope that uses it first, and for new ones in scopes beside that",),
            help=f"use $(anon {name}) before the groups, or put both into one group",
        )


class _Walk:
    """Gives every $(anon id) the identity it would have: ids seen so far are passed down into groups, and not back."""

    def __init__(self) -> None:
        self.nodes: dict[str, dict[int, Span]] = {}
        self.uses: dict[str, list[tuple[int, Span]]] = {}
        self._count = 0

    def children(self, parent: Element, known: dict[str, int], depth: int) -> None:
        """Look at all that stands in ``parent``, where the ids ``known`` have a name already."""
        if depth > _DEEPEST:
            return
        for element in parent.children:
            tag = element.tag.lower()
            # What a param or an include's arg makes new stays inside of it.
            inner = dict(known) if (tag == "param" and parent.tag.lower() in ("node", "test")) or parent.tag.lower() == "include" else known
            self._attributes(element, tag, inner)
            if element.children:
                self.children(element, dict(inner) if tag == "group" else inner, depth + 1)

    def _attributes(self, element: Element, tag: str, known: dict[str, int]) -> None:
        for attribute in element.attributes.values():
            for part in parts_of(attribute).substitutions("anon") if "anon" in attribute.value else ():
                name = part.only
                if name not in known:
                    self._count += 1
                    known[name] = self._count
                identity, span = known[name], attribute.span_of(part.start, part.end)
                if tag in ("node", "test") and attribute.name == "name":
                    self.nodes.setdefault(name, {}).setdefault(identity, span)
                else:
                    self.uses.setdefault(name, []).append((identity, span))
