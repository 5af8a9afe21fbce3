"""Text stands where roslaunch ignores it.

Only `<rosparam>` has a text that means anything, and only where it loads YAML that is written there: not beside
`file=` and not with `command="delete"` or `"dump"`. Everywhere else text between tags is skipped. Text that begins with `#` or
`//`, as comments do elsewhere, is an info.

## Why it matters

Text in a launch file is nearly always the rest of something: half a comment, a bracket too many, a value that belongs
into an attribute. roslaunch says nothing about it.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/> -->
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.rules.template import has_placeholder

RULE = Rule("LL107", "stray-text", Severity.WARNING)


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Show the text, unless it is the placeholder of a template.

    Facts: ``text``, ``parent``, ``because`` (``tag``, or what makes a rosparam ignore its text).
    """
    text, parent, because = problem.facts["text"], problem.facts["parent"], problem.facts["because"]
    words = " ".join(text.split())
    if has_placeholder(words):
        return
    shown = words if len(words) <= 40 else f"{words[:37]}..."
    if because == "tag":
        reason = "roslaunch reads text in <rosparam> only, and says nothing about this"
        advice = "remove it, or make it a comment: <!-- … -->"
        if parent in ("param", "env", "arg"):
            advice = 'a value goes into the attribute value="…"'
        elif "--" in words:
            advice = "it looks like a piece of a comment: comment it out as a whole, or remove it"
    elif because == "file":
        reason = "with file=… roslaunch loads the file and ignores the text"
        advice = "remove the text, or write a second <rosparam> without file"
    else:
        reason = f'with command="{because}" roslaunch ignores the text'
        advice = "remove the text"
    comment = because == "tag" and words.startswith(("#", "//")) and "<" not in words
    yield RULE.at(
        problem.origin,
        f"this text has no effect: {shown}",
        severity=Severity.INFO if comment else None,
        label="ignored",
        notes=(reason,),
        help=advice,
    )
