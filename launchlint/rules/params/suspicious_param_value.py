"""The value of a parameter without `type` becomes a text, although it looks like a number, a boolean or a list.

Without `type` roslaunch makes a number of `10` and `1.5`, a boolean of `true` and `false` (in any letter case), and a
text of all else. So `1,5`, `1e-3` (there is no point in it), `flase` and `[1, 2, 3]` are texts.

## Why it matters

A node that asks for a number gets its default instead, and does not say so.

## Example

```xml
<launch>
  <node pkg="robot_localization" type="ekf_localization_node" name="ekf">
    <param name="two_d_mode" value="ture"/>
    <param name="sensor_timeout" value="1e-1"/>
    <param name="initial_state" value="[0, 0, 1.5]"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="robot_localization" type="ekf_localization_node" name="ekf">
    <param name="two_d_mode" value="true"/>
    <param name="sensor_timeout" value="1.0e-1"/>
    <rosparam param="initial_state">[0, 0, 1.5]</rosparam>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.params.values import is_certain
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Place, Span
from launchlint.spelling import distance

RULE = Rule("LL512", "suspicious-param-value", Severity.WARNING)

_TYPE = r"""(?i)\btype\s*=\s*["']\s*(?!auto\s*["']|["'])"""
_VALUE = r"""\bvalue\s*=\s*(?:"([^"]*)"|'([^']*)')"""
_COMMA = r"[-+]?\d+,\d+"
_EXPONENT = r"[-+]?\d+[eE][-+]?\d+"
_WORD = r"[A-Za-z]{3,6}"
_WORDS = frozenset(("tree", "trie", "tru", "rue", "falsi"))
_SCALAR = r"\s*(?:[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|true|false)\s*"
_LIST = rf"(?i)\[{_SCALAR}(?:,{_SCALAR})*\]"
_SEVERAL = r"(?i)s$|list|size|range|resolution|pair|point|pose|position|shape|dim|channel|ids?$|xy|index|indices|glob"
_SWITCH = r"(?i)(?:^|_)(?:use|enable|enabled|disable|is|has|publish|subscribe|allow|show|with|auto|debug|verbose)(?:_|$)"
_SWITCHES = {"yes": "true", "on": "true", "no": "false", "off": "false"}
LONGEST = 200


def check(view: LaunchView) -> Iterator[Finding]:
    """Look at every text that comes from ``<param value=…>`` without a type."""
    for setting in view.launch.parameter_settings:
        value = setting.value
        if setting.tag != "param" or not isinstance(value, str) or not 1 < len(value) <= LONGEST or not is_certain(setting):
            continue
        said = _suspicion(setting.name.rpartition("/")[2], value)
        if said is None:
            continue
        place = setting.origin.place
        written = re.search(_VALUE, place.text)
        if written is None or re.search(_TYPE, place.text) is not None:
            continue
        start, end = written.span(1 if written[1] is not None else 2)
        at = setting.origin._replace(place=Place(place.source, Span(place.span.start + start, place.span.start + end)))
        message, help_ = said
        yield RULE.at(at, message, label="a text", help=help_)


def _suspicion(name: str, value: str) -> tuple[str, str] | None:
    """Message and help; None where the value may well be meant as a text."""
    if re.fullmatch(_COMMA, value) is not None:
        if re.search(_SEVERAL, name) is not None:
            return None
        return (
            f"{value} is a text and no number: decimals have a point",
            f'write {value.replace(",", ".")}, or type="string" if the text is meant',
        )
    if re.fullmatch(_EXPONENT, value) is not None:
        mantissa, exponent = re.split("[eE]", value)
        return (
            f"{value} is a text and no number: roslaunch takes only numbers with a point in them for floating point",
            f'write {mantissa}.0e{exponent}, or type="double"',
        )
    if re.fullmatch(_LIST, value) is not None:
        return (
            f"{value} is a text and no list",
            f'write <rosparam param="{name}">{value}</rosparam>, or type="yaml"; type="string" if the text is meant',
        )
    lower = value.lower()
    if lower in _SWITCHES and re.search(_SWITCH, name) is not None:
        return f"{value} is a text and no boolean", f'write {_SWITCHES[lower]}, or type="string" if the text is meant'
    if re.fullmatch(_WORD, value) is not None and lower not in _WORDS and lower not in _SWITCHES:
        near = next((word for word in ("true", "false") if distance(lower, word, 1) == 1), None)
        if near is not None:
            return f"{value} is a text and no boolean", f"did you mean {near}?"
    return None
