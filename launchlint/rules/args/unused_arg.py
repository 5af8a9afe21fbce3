"""An arg is declared and never read.

No `$(arg …)` and no `$(eval …)` of the file reads it, in no branch, and no `<include>` with `pass_all_args` passes it on.
An arg that a comment or its `doc` calls unused, ignored or deprecated is left alone: somebody keeps it on purpose. So is one
with a fixed `value` that is an `$(eval …)`, which may be there to stop roslaunch when it fails.

## Why it matters

Giving the arg a value, on the command line or in an `<include>`, has no effect, and nobody says so. Often a misspelt name is
behind it: the value that was meant to use the arg uses another one.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <arg name="use_lidar" default="true"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView
from launchlint.syntax.tree import Document, Element

RULE = Rule("LL206", "unused-arg", Severity.WARNING)

# Whatever looks like a read counts as one, closed or not: what is wrong with it is told by other rules.
READ = re.compile(r"[({\[]\s*arg\s+([^\s(){}\[\]$]+)")
WORD = re.compile(r"[^\W\d]\w*")
COMPUTED_NAME = re.compile(r"\barg\s*\(\s*[^'\"\s]|\b(?:globals|locals|vars|dir|eval|exec)\s*\(")
ON_PURPOSE = re.compile(r"unused|not used|no longer|deprecat|obsolete|compat|ignored|legacy|dummy|placeholder|interface", re.IGNORECASE)


def check(view: FileView) -> Iterator[Finding]:
    """Every arg that the text of this file declares and never reads; silent where the names that are read cannot be told."""
    document = view.document
    declared: dict[str, list[Element]] = {}
    for element in document.elements:
        if element.tag == "arg" and element.parent is not None and element.parent.tag in ("launch", "group"):
            name = element.get("name")
            if name and "$" not in name:
                declared.setdefault(name, []).append(element)
    if not declared:
        return
    read = _names_read(document)
    if read is None:
        return
    for name, elements in declared.items():
        if name in read or any(_is_check(element) or _on_purpose(document, element) for element in elements):
            continue
        first, *others = (document.place(element.attributes["name"].value_span) for element in elements)
        commented = any(name in READ.findall(comment.text) for comment in document.comments)
        yield RULE.at(
            first,
            f"the arg {name} is never read",
            label="unused",
            related=tuple((place, "declared here too") for place in others),
            notes=("only a comment reads it",) if commented else ("a value that is given for it has no effect",),
            help=f"remove it, or use it as $(arg {name})",
        )


def _names_read(document: Document) -> set[str] | None:
    """Names that anything in the file reads; ``None`` where all args are passed on or a name is computed."""
    names: set[str] = set()
    for element in document.elements:
        for attribute in element.attributes.values():
            value = attribute.value
            if attribute.name == "pass_all_args" and (value.lower() == "true" or "$" in value):
                return None
            if "arg" in value or "$" in value:
                names.update(READ.findall(value))
            start = value.find("$(eval")
            if start >= 0:
                expression = value[start + 6 :]
                if COMPUTED_NAME.search(expression):
                    return None
                names.update(WORD.findall(expression))
        if element.texts and "arg" in element.text:
            names.update(READ.findall(element.text))
            names.update(WORD.findall("".join(re.findall(r"\$\(eval([^\n]*)", element.text))))
    return names


def _is_check(element: Element) -> bool:
    """Whether the arg is computed for nobody, as people do to have roslaunch stop where something is not as it must be."""
    return (element.get("value") or "").startswith("$(eval ")


def _on_purpose(document: Document, element: Element) -> bool:
    """Whether the ``doc`` of the arg, or a comment right before or behind it, says that it is not meant to be read."""
    if ON_PURPOSE.search(element.get("doc") or ""):
        return True
    source = document.source
    first, last = source.position(element.span.start).line, source.position(element.span.end).line
    for comment in document.comments:
        begins, ends = source.position(comment.span.start).line, source.position(comment.span.end).line
        if (ends in (first - 1, first) or begins == last) and ON_PURPOSE.search(comment.text):
            return True
    return False
