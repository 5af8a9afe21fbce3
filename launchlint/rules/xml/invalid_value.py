"""An attribute has a value that it does not take.

Checked are booleans (`respawn`, `required`, `clear_params`, `pass_all_args` and `subst_value` take `true` or `false`
only, not `1`), numbers, and the attributes that take one of a few words: `output`, `cwd`, `type`, `command` and
`default` of a machine. Values made by substitutions are checked as they come out. Quotes in `args` and
`launch-prefix` must be balanced. (For `if` and `unless` see LL214.)

In ROS 2, the types of params are `str`, `bool`, `int`, `float` and lists of these (`list_of_int`), and their values must fit: a value such
as `a: b` or `null`, and a list of several types, are refused. In YAML, params, remaps and args are a list of mappings.

## Why it matters

roslaunch refuses the file. Unbalanced quotes are worse: it loads the file, starts the first nodes, and then shuts
everything down.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" output="scren"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="10" type="double"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" output="screen"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="10" type="float"/>
  </node>
</launch>
```

## Fix

`--fix` writes the value that is meant by a word of other formats (`1`, `yes`, `integer`), or the only one that is one slip away; a value
that is further off takes `--unsafe-fixes`. Values made by substitutions are left alone. roslaunch loads the file then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.problems import UnbalancedQuotes
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import of_ros2
from launchlint.spelling import closest, surely
from launchlint.syntax.problems import InvalidValue
from launchlint.syntax.ros1.dialect import TAGS
from launchlint.syntax.ros2.problems import NegativeValue, OpenQuote, WrongValue, YamlForm

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.problems import ChoiceRefused, UnsplittablePrefix

RULE = Rule("LL109", "invalid-value", Severity.ERROR, roslaunch="refuses", fixable="safe")

MEANT = {"1": "true", "yes": "true", "on": "true", "0": "false", "no": "false", "off": "false", "integer": "int", "float": "double"}
"""Words of other formats, and what is meant where the attribute takes that."""


def tell(
    problem: InvalidValue | UnbalancedQuotes | WrongValue | NegativeValue | OpenQuote | YamlForm | ChoiceRefused | UnsplittablePrefix,
    view: object,
) -> Iterator[Finding]:
    """Name what the attribute takes. Conditions belong to LL214 and LL114."""
    if not isinstance(problem, (InvalidValue, UnbalancedQuotes)):
        if isinstance(problem, (WrongValue, NegativeValue, OpenQuote, YamlForm)):
            from launchlint.rules.judging.ros2_values import tell as tell_ros2

            yield from tell_ros2(problem, RULE)
            return
        from launchlint.rules.judging.ros2_names import value as tell_value

        yield from tell_value(problem, RULE)
        return
    if of_ros2(view) and isinstance(problem, InvalidValue):
        from launchlint.rules.judging.ros2_names import value as tell_value

        yield from tell_value(problem, RULE)
        return
    severity = Severity.ERROR if problem.refused else Severity.WARNING
    name = problem.attribute
    if isinstance(problem, UnbalancedQuotes):
        yield RULE.at(
            problem.origin,
            f"the quotes in {name} do not match ({problem.reason})",
            severity=severity,
            notes=(f"roslaunch splits {name} as a shell does; it fails on this when it starts the node, and then stops all others",),
            help="close the quote; write \\' or \\\" for a quote that is meant as such",
        )
        return
    if name in ("if", "unless"):
        return
    value = problem.value
    rule = TAGS[problem.tag.lower()].attribute(name)
    expected, choices = (problem.expected, ()) if rule is None else (rule.domain.expected, rule.domain.choices)
    meant = next((each for each in choices if MEANT.get(value.strip().lower()) == each), None) or surely(value.strip(), choices)
    near = meant or closest(value.strip(), choices)
    problem_text = f"{name} is empty" if not value else f"{name}={value[:60]!r} is not {expected}"
    yield RULE.at(
        problem.origin,
        problem_text,
        severity=severity,
        label=f"must be {expected}",
        help=f"did you mean {near}?" if near is not None else f"write {expected}" if choices else f"{name} takes {expected}",
        fix=None if near is None else _fix(problem, view, near, sure=near == meant),
    )


def _fix(problem: InvalidValue, view: object, near: str, *, sure: bool) -> Fix | None:
    if not is_literal(problem.place, problem.value):
        return None
    at = spot(view, problem.place)
    return fix(f"write {near}", set_value(at, near), safe=sure, changes=LOADS)
