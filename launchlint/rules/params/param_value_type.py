"""The value of a parameter does not fit its `type`, or roslaunch does not know the type.

roslaunch knows the types `str` (or `string`), `int`, `double`, `bool` (or `boolean`), `yaml` and `auto`, which is
also what it takes where there is no `type`. The value is checked as it is after substitution.

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
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.problem import Problem
from launchlint.rules.rule import Rule
from launchlint.spelling import closest

RULE = Rule("LL501", "param-value-type", Severity.ERROR, roslaunch="refuses")

TYPES = ("str", "string", "int", "double", "bool", "boolean", "yaml", "auto")
ALSO_KNOWN_AS = {
    "integer": "int", "long": "int", "unsigned": "int", "uint": "int", "int32": "int", "uint32": "int", "int64": "int",
    "float": "double", "float32": "double", "float64": "double", "number": "double", "real": "double", "decimal": "double",
    "text": "string", "std::string": "string", "std_string": "string", "char": "string",
    "list": "yaml", "array": "yaml", "dict": "yaml", "dictionary": "yaml", "map": "yaml", "vector": "yaml", "struct": "yaml",
}  # fmt: skip


def tell(problem: Problem, view: object) -> Iterator[Finding]:
    """Say which type it would fit; facts: ``value``, ``type``, ``known``, ``reason``."""
    value, type_, reason = problem.facts["value"], problem.facts["type"], problem.facts["reason"]
    if not problem.facts["known"]:
        instead = ALSO_KNOWN_AS.get(type_) or closest(type_, TYPES)
        yield RULE.at(
            problem.origin,
            f"{type_!r} is no parameter type" if type_ else "the type is empty",
            label="no such type",
            related=problem.related,
            notes=(f"roslaunch stops with: Unknown type '{type_}'",),
            help=f"write type={instead!r}" if instead else f"the types are {', '.join(TYPES)}",
        )
        return
    yield RULE.at(
        problem.origin,
        reason,
        label=f"no {type_}",
        related=problem.related,
        notes=("roslaunch refuses the file",),
        help=_instead(value.strip(), type_),
    )


def _instead(value: str, type_: str) -> str:
    """What was probably meant."""
    if type_ in ("bool", "boolean"):
        meant = {"yes": "true", "on": "true", "no": "false", "off": "false"}.get(value.lower())
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
