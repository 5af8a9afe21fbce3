"""Text stands where roslaunch ignores it.

Only `<rosparam>` has a text that means anything, and only where it loads YAML that is written there: not beside
`file=` and not with `command="delete"` or `"dump"`. Everywhere else text between tags is skipped. Text that begins with `#` or
`//`, as comments do elsewhere, is an info, and so is in a `<![CDATA[…]]>` a whole comment, or a tag without its `<`: somebody switched it
off. The same text in several places is told once. Text that reads like attributes (`output="screen">`) shows a `>` too early in the tag
before it. In ROS 2, no tag has a text that is read.

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

## Fix

`--fix` makes a comment of a line that begins with `#` or `//`. `--unsafe-fixes` removes other text, unless it stands in a tag that takes
a value. Nothing changes for roslaunch, which is proved before it is done.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.rules.judging.template import has_placeholder
from launchlint.rules.rule import Rule
from launchlint.source import Place
from launchlint.syntax.problems import StrayText
from launchlint.syntax.ros2.problems import UnreadText

RULE = Rule("LL107", "stray-text", Severity.WARNING, fixable="safe")

_ATTRIBUTES = re.compile(r"""(?:[A-Za-z][\w-]*\s?=\s?(?:"[^"<>]*"|'[^'<>]*')\s?)+/?>?""")
_SWITCHED_OFF = re.compile(r"(?:arg|env|group|include|machine|node|param|remap|rosparam|test) [A-Za-z][\w-]* ?= ?[\"']")
"""How a tag begins that has lost its ``<``."""
_QUOTES = ('"', "'")


def tell(problem: StrayText | UnreadText, view: object) -> Iterator[Finding]:
    """Show the text, unless it is the placeholder of a template."""
    ros2 = isinstance(problem, UnreadText)
    text, parent, because = problem.text, problem.parent, "tag" if isinstance(problem, UnreadText) else problem.because
    words = " ".join(text.split())
    if has_placeholder(words):
        return
    shown = words if len(words) <= 40 else f"{words[:37]}..."
    if because == "tag":
        reason = "roslaunch reads text in <rosparam> only, and says nothing about this"
        reason = "launch reads no text between tags, and says nothing about this" if ros2 else reason
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
    whole = because == "tag" and words.startswith("<!--") and words.endswith("-->") and words.count("-->") == 1
    if whole:
        advice = "a comment needs no <![CDATA[…]]> around it"
    switched_off = because == "tag" and _SWITCHED_OFF.match(words) is not None and _is_in_cdata(problem.place)
    if switched_off:
        advice = "to switch a tag off, make it a comment: <!-- <…> -->"
    of_a_value = because == "tag" and parent in ("param", "env", "arg")
    message = f"this text has no effect: {shown}"
    attributes = because == "tag" and _ATTRIBUTES.fullmatch(words) is not None
    if attributes:
        who = "launch" if ros2 else "roslaunch"
        reason = f"the > before it has ended the start tag of <{parent}>, so that these attributes are text, which {who} ignores"
        advice = "remove that > if they belong to the tag; else remove them"
    if words in _QUOTES and problem.behind_tag:
        message, advice = f"a stray quote stands behind the tag: {words}", "remove it"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.INFO if comment or whole or switched_off else None,
        label="ignored",
        notes=(reason,),
        help=advice,
        fix=None if attributes else _fix(problem.place, words, comment=comment, of_a_value=of_a_value),
        cause=f"{because} {of_a_value} {parent if attributes else ''} {words}",
    )


def _is_in_cdata(place: Place) -> bool:
    return place.source.text.endswith("<![CDATA[", 0, place.span.start)


def _fix(place: Place, words: str, *, comment: bool, of_a_value: bool) -> Fix | None:
    """A line that begins as comments do elsewhere becomes a comment; other text goes, unless it may be a value."""
    if "&" in place.text or "]]>" in place.text:
        return None
    source, span = place
    if comment and "--" not in words and not words.endswith("-") and "\n" not in place.text:
        text = words.lstrip("#/").strip()
        return Fix("make it a comment", True, (Edit(source.path, *span, f"<!-- {text} -->"),))
    if of_a_value or _is_in_cdata(place):
        return None
    whole = source.with_lines(span)
    start = whole.start if whole != span else len(source.text[: span.start].rstrip(" \t"))
    return Fix("remove the text", False, (Edit(source.path, start, whole.end, ""),))
