"""Attributes of an element contradict each other.

A node cannot be both `respawn` and `required`; a `<param>` has exactly one of `value`, `textfile`, `binfile` and
`command`; `ns` cannot be empty; `clear_params` on a group or include needs an `ns` that says what to clear;
`command="delete"` of a `<rosparam>` takes no `file`. (What a `<test>` may not have is told by LL310.)

In ROS 2, a `<param>` has either `from`, with or without `allow_substs`, or `name` with exactly one of `value` and params inside.

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn="true" required="true"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="10"><param name="low" value="1"/></param>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" respawn="true"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate"><param name="low" value="1"/></param>
  </node>
</launch>
```

## Fix

`--unsafe-fixes` removes an `ns=""`. Which of two other attributes is meant, only the author can tell. roslaunch loads the file then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, MOST_ATTRIBUTES, fix, remove_attribute, spot
from launchlint.rules.rule import Rule
from launchlint.spelling import closest
from launchlint.syntax.problems import ConflictingAttributes
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros1.substitutions import parse
from launchlint.syntax.ros2.problems import ParameterForm
from launchlint.syntax.tree import Element

RULE = Rule("LL110", "conflicting-attributes", Severity.ERROR, roslaunch="refuses", fixable="unsafe")

_VALUES = frozenset(("value", "textfile", "binfile", "command"))
"""What gives a `<param>` its value."""

# Reason → message, what roslaunch prints, help.
WORDS = {
    "respawn-and-required": (
        "a node cannot be both respawn and required",
        "respawn and required cannot both be set to true",
        "keep respawn to have it started again, or required to have everything stop when it ends",
    ),
    "empty-ns": ("<{tag}> has an empty ns", "<{tag}> tag has an empty 'ns' attribute", 'remove ns, or write ns="/" for the root'),
    "clear-params-without-ns": (
        "clear_params on <{tag}> needs ns",
        "'ns' attribute must be set in order to use 'clear_params'",
        'add ns="…", the namespace whose parameters are deleted, or remove clear_params',
    ),
    "clear-params-without-name": (
        "clear_params needs the node to have a name",
        "<node> tag must have a 'name' attribute to use 'clear_params' attribute",
        'add name="…", or remove clear_params',
    ),
    "delete-with-file": (
        '<rosparam command="delete"> takes no file',
        "'file' attribute is invalid with 'delete' command.",
        "name the parameters to delete with param or ns, or remove command to load the file",
    ),
}


FORMS = {
    "from-and-name": ("a param has both from and name", "keep from to load a file, or name with a value"),
    "neither": ("a param needs a name, or from", 'add name="…", or from="…" for a file'),
    "substs-without-from": ("allow_substs goes with from only", "remove allow_substs: substitutions in a value need no permission"),
    "value-and-nested": ("a param has both a value and params inside", "keep one of them"),
    "type-and-nested": ("a param with params inside takes no type", "remove type, or give the inner params types"),
    "empty": ("a param has no value", 'add value="…", or params inside'),
}
"""Form of a param in ROS 2 → message and help."""


def tell(problem: ConflictingAttributes | ParameterForm, view: object) -> Iterator[Finding]:
    """Say which attributes exclude each other. ``test-attribute`` is LL310's."""
    if isinstance(problem, ParameterForm):
        message, advice = FORMS[problem.form]
        yield RULE.at(problem.origin, message, notes=("ros2 launch refuses the file",), help=advice, topic=problem.form)
        return
    reason, tag = problem.reason, problem.tag
    attributes: tuple[str, ...] = problem.attributes
    if reason == "test-attribute":
        return
    if reason == "param-sources":
        names = " and ".join(attributes) if len(attributes) < 3 else f"{', '.join(attributes[:-1])} and {attributes[-1]}"
        message = f"<param> has {names}: one value too many" if attributes else "<param> has no value"
        stops = "<param> tag must have one and only one of value/textfile/binfile."
        advice = "keep one of them" if attributes else 'add value="…" (or textfile, binfile, command)'
    else:
        message, stops, advice = (words.format(tag=tag) for words in WORDS[reason])
    at = spot(view, problem.place)
    instead = None if at is None or reason != "param-sources" or attributes else instead_of_value(at.element)
    slip = "" if at is None or reason != "param-sources" or attributes else misspelt_value(at.element)
    if slip:
        advice = "did you mean value?"
    if instead is not None:
        owner = ", which only <arg> has" if instead == "default" else ": <param> has no such attribute"
        advice = f'write value="…" instead of {instead}="…"{owner}'
    args = list(parse(problem.place.text).names("arg")) if reason == "empty-ns" else []
    if args:
        names = args[0] if len(args) == 1 else f"{', '.join(args[:-1])} or {args[-1]}"
        advice = f"give the arg {names} a value, also by default, that is not empty (/ stands for the root)"
    notes: tuple[str, ...] = (f"roslaunch stops with: {stops}",)
    from_environment = problem.environment
    if from_environment:  # whoever starts it has the variable
        notes = ("it is made from an environment variable that is not set here", *notes)
        advice = "give $(optenv …) a default, or the variable a value under env: in .launchlint.yaml if it is always set"
    yield RULE.at(
        problem.origin,
        message,
        severity=Severity.INFO if from_environment else Severity.ERROR if problem.refused else Severity.WARNING,
        related=problem.related,
        notes=notes,
        help=advice,
        topic=reason,
        cause=f"{problem.place.source.path} {advice}" if reason == "param-sources" and not attributes else "",
        shared_cause=f"{problem.place.source.path} {slip}" if slip else "",
        fix=_fix(problem, view),
    )


def instead_of_value(element: Element) -> str | None:
    """The attribute that a ``<param>`` without a value has in its place; ``None`` where it has none that only stands for that."""
    if element.tag != "param" or not _VALUES.isdisjoint(element.attributes) or len(element.attributes) > MOST_ATTRIBUTES:
        return None
    known = TAGS["param"].known
    strange = [each for each in element.attributes if each not in known]
    return strange[0] if len(strange) == 1 and closest(strange[0], known) is None else None


def misspelt_value(element: Element) -> str:
    """The cause that LL104 and LL110 share: one slip in the name of a `<param>`'s only value; empty where it is none."""
    if element.tag != "param" or not _VALUES.isdisjoint(element.attributes) or len(element.attributes) > MOST_ATTRIBUTES:
        return ""
    known = TAGS["param"].known
    strange = [each for each in element.attributes if each not in known]
    return f"value of {element.start_span.start}" if len(strange) == 1 and closest(strange[0], known) in _VALUES else ""


def _fix(problem: ConflictingAttributes, view: object) -> Fix | None:
    """An ``ns`` with nothing in it goes; what else excludes each other, only its author can tell."""
    at = spot(view, problem.place)
    if problem.reason != "empty-ns" or at is None or at.attribute is None or at.attribute.raw:
        return None
    return fix("remove ns", remove_attribute(at), safe=False, changes=LOADS)
