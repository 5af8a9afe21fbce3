"""The value of a parameter does not fit its `type`, or roslaunch does not know the type.

roslaunch knows the types `str` (or `string`), `int`, `double`, `bool` (or `boolean`), `yaml` and `auto`, which is
also what it takes where there is no `type`. The value is checked as it is after substitution. It is an info where the value plainly
asks to be filled in (`your app id here`, `<id>`, `CHANGEME`): roslaunch refuses the file until somebody does. In ROS 2 it is a warning
where the value is one that was tried for an arg to see what stands under a condition.

## Why it matters

roslaunch refuses the file.

## Example

```xml
<launch>
  <node pkg="camera" type="driver" name="driver">
    <param name="fps" type="int" value="29.97"/>
    <param name="exposure" type="float" value="0.02"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="camera" type="driver" name="driver">
    <param name="fps" type="double" value="29.97"/>
    <param name="exposure" type="double" value="0.02"/>
  </node>
</launch>
```

## Fix

`--fix` writes the type that is meant by a word of other formats (`integer`, `float`), or the only one that is one slip away, and `true` or
`false` for `yes`, `no`, `on` and `off`. A type that is further off takes `--unsafe-fixes`. roslaunch loads the file then.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.evaluate.problems import ParamValueType
from launchlint.evaluate.ros2.parameter_problems import ParameterValueType
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, fix, is_literal, set_value, spot
from launchlint.rules.judging.template import is_to_fill_in
from launchlint.rules.rule import Rule
from launchlint.spelling import closest, surely

RULE = Rule("LL501", "param-value-type", Severity.ERROR, roslaunch="refuses", fixable="safe")

TYPES = ("str", "string", "int", "double", "bool", "boolean", "yaml", "auto")
WORDS = {"yes": "true", "on": "true", "no": "false", "off": "false"}
ALSO_KNOWN_AS = {
    "integer": "int", "long": "int", "unsigned": "int", "uint": "int", "int32": "int", "uint32": "int", "int64": "int",
    "float": "double", "float32": "double", "float64": "double", "number": "double", "real": "double", "decimal": "double",
    "text": "string", "std::string": "string", "std_string": "string", "char": "string",
    "list": "yaml", "array": "yaml", "dict": "yaml", "dictionary": "yaml", "map": "yaml", "vector": "yaml", "struct": "yaml",
}  # fmt: skip


def tell(problem: ParamValueType | ParameterValueType, view: object) -> Iterator[Finding]:
    """Say which type it would fit."""
    if isinstance(problem, ParameterValueType):
        yield _ros2(problem)
        return
    value, type_, reason = problem.value, problem.type, problem.reason
    if not problem.known:
        instead = ALSO_KNOWN_AS.get(type_) or closest(type_, TYPES)
        yield RULE.at(
            problem.origin,
            f"{type_!r} is no parameter type" if type_ else "the type is empty",
            label="no such type",
            related=problem.related,
            notes=(f"roslaunch stops with: Unknown type '{type_}'",),
            help=f"write type={instead!r}" if instead else f"the types are {', '.join(TYPES)}",
            fix=None
            if instead is None
            else _fix_type(problem, view, instead, sure=instead == ALSO_KNOWN_AS.get(type_, surely(type_, TYPES))),
        )
        return
    placeholder = is_to_fill_in(value)
    yield RULE.at(
        problem.origin,
        reason,
        severity=Severity.INFO if placeholder else None,
        label="to be filled in" if placeholder else f"no {type_}",
        related=problem.related,
        notes=("roslaunch refuses the file until the value is filled in" if placeholder else "roslaunch refuses the file",),
        help="fill this in before the file is started, or make it an arg without a default"
        if placeholder
        else _instead(value.strip(), type_),
        fix=_fix_boolean(problem, view, value) if type_ in ("bool", "boolean") else None,
    )


def _ros2(problem: ParameterValueType) -> Finding:
    name, type_ = problem.name, problem.type
    return RULE.at(
        problem.origin,
        f"the value of {name} cannot be used: {problem.reason}",
        label=f"no {type_}" if type_ else "no value of a parameter",
        related=problem.related,
        notes=(f"the value is {problem.value!r} here, and ros2 launch stops{' where it is' if problem.assumed else ''}",),
        help="" if type_ else 'type="str" takes any text as it is',
    )


def _fix_type(problem: ParamValueType, view: object, type_: str, *, sure: bool) -> Fix | None:
    at = spot(view, problem.place)
    attribute = None if at is None else at.element.attributes.get("type")
    if at is None or attribute is None or "$" in attribute.raw:
        return None
    return fix(f"write type={type_!r}", set_value(at, type_, attribute), safe=sure, changes=LOADS)


def _fix_boolean(problem: ParamValueType, view: object, value: str) -> Fix | None:
    meant = WORDS.get(value.strip().lower())
    if meant is None or not is_literal(problem.place, value):
        return None
    return fix(f"write {meant}", set_value(spot(view, problem.place), meant), safe=True, changes=LOADS)


def _instead(value: str, type_: str) -> str:
    """What was probably meant."""
    if type_ in ("bool", "boolean"):
        meant = WORDS.get(value.lower())
        meant = meant or (closest(value.lower(), ("true", "false")) if len(value) > 2 else None)
        return f"write {meant}" if meant else "write true or false"
    if re.fullmatch(r"[-+]?\d*,\d+", value):
        return f"write the decimal comma as a point: {value.replace(',', '.')}" + (", and type='double'" if type_ == "int" else "")
    if type_ == "int":
        try:
            number = float(value)
        except ValueError:
            pass
        else:
            return f"write {int(number)}" if number.is_integer() and abs(number) < 1e15 else "take type='double', or round it"
        if re.fullmatch(r"[-+]?0[xX][0-9a-fA-F]{1,15}", value):
            return f"roslaunch reads no hexadecimal numbers: write {int(value, 16)}"
    if type_ == "yaml":
        return "mend the YAML, or take type='string' if the text is meant as it is"
    return "mend the value, or take type='string' if the text is meant as it is"
