"""The value of a parameter without `type` becomes a text, although it looks like a number, a boolean or a list.

Without `type` roslaunch makes a number of `10` and `1.5`, a boolean of `true` and `false` (in any letter case), and a
text of all else. So `1,5`, `1e-3` (there is no point in it), `flase` and `[1, 2, 3]` are texts.

A text may be just what the node reads. So it is a warning where the library says that it reads something else (of roscpp nodes that is
told by LL508), where the value is a slip for `true` or `false` or has a decimal comma, and where a list is given to no node in particular;
silence where the node reads a text, or nothing of that name; and an info where nobody knows what the node reads.

## Why it matters

A node that asks for a number gets its default instead, and does not say so.

## Example

```xml
<launch>
  <node pkg="my_filter" type="filter" name="filter">
    <param name="smooth" value="ture"/>
    <param name="timeout" value="1e-1"/>
    <param name="offsets" value="[0, 0, 1.5]"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="my_filter" type="filter" name="filter">
    <param name="smooth" value="true"/>
    <param name="timeout" value="1.0e-1"/>
    <rosparam param="offsets">[0, 0, 1.5]</rosparam>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.model import ParameterSetting
from launchlint.rules.edits import spot
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.spelling import distance

RULE = Rule("LL512", "suspicious-param-value", Severity.WARNING)

_COMMA = r"[-+]?\d+,\d+"
_EXPONENT = r"[-+]?\d+[eE][-+]?\d+"
_WORD = r"[A-Za-z]{3,6}"
_WORDS = frozenset(("tree", "trie", "tru", "rue", "falsi"))
_SCALAR = r"\s*(?:[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?|true|false)\s*"
_LIST = rf"(?i)\[{_SCALAR}(?:,{_SCALAR})*\]"
_SEVERAL = r"(?i)s$|list|size|range|resolution|pair|point|pose|position|shape|dim|channel|ids?$|xy|index|indices|glob"
_SWITCH = r"(?i)(?:^|_)(?:use|enable|enabled|disable|is|has|publish|subscribe|allow|show|with|auto|debug|verbose)(?:_|$)"
_SWITCHES = {"yes": "true", "on": "true", "no": "false", "off": "false"}
LONGEST = 200
_TEXT, _ANOTHER, _NOBODY_KNOWS = "text", "another", "nobody knows"
_SINGLE = frozenset(("bool", "int", "double"))
_NO_TEXTS = _SINGLE | {"list", "dict"}


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Look at every text that comes from ``<param value=…>`` without a type."""
    readers = _Readers(view)
    for setting in view.launch.parameter_settings:
        value = setting.value
        if setting.tag != "param" or not isinstance(value, str) or not 1 < len(value) <= LONGEST or not is_certain(setting):
            continue
        said = _suspicion(setting.name.rpartition("/")[2], value)
        if said is None:
            continue
        found = spot(view, setting.origin.place)
        written = None if found is None else found.element.attributes.get("value")
        if found is None or written is None or (found.element.get("type") or "auto").lower().strip() not in ("auto", ""):
            continue
        at = setting.origin._replace(place=found.document.place(written.value_span))
        message, help_, sure = said
        wants = readers.wanted(setting)
        if wants == _ANOTHER or (wants == _NOBODY_KNOWS and (sure or (setting.node is None and value.startswith("[")))):
            yield RULE.at(at, message, label="a text", help=help_)
        elif wants == _NOBODY_KNOWS:
            note = "which node reads it, and as what, is not known: if it takes a text, all is well"
            yield RULE.at(at, message, severity=Severity.INFO, label="a text", notes=(note,), help=help_)
        else:
            yield RULE.fine(at)


class _Readers:
    """What the nodes of a launch want of a parameter."""

    def __init__(self, view: GraphView) -> None:
        self._readers = view.graph.readers
        self._instances = {instance.name: instance for instance in view.graph.instances}

    def wanted(self, setting: ParameterSetting) -> str:
        """Of a text: ``_TEXT`` where one is wanted or no other rule leaves anything to say, ``_ANOTHER``, ``_NOBODY_KNOWS``."""
        readings = self._readers.get(setting.name, ())
        types = {reading.declaration.type for reading in readings if reading.node in self._instances}
        if not types:
            owner = self._instances.get(setting.node or "")
            known = owner is not None and owner.certain and not owner.may_have_more("params")
            return _TEXT if known else _NOBODY_KNOWS  # that it is not read is told by LL507
        if not types <= _NO_TEXTS:
            return _TEXT if "str" in types else _NOBODY_KNOWS
        rospy = all(self._instances[reading.node].client == "rospy" for reading in readings)
        return _ANOTHER if rospy and types <= _SINGLE else _TEXT  # the others are told by LL508


def _suspicion(name: str, value: str) -> tuple[str, str, bool] | None:
    """Message, help and whether nobody would write such a text; None where the value may well be meant as a text."""
    if re.fullmatch(_COMMA, value) is not None:
        if re.search(_SEVERAL, name) is not None:
            return None
        return (
            f"{value} is a text and no number: decimals have a point",
            f'write {value.replace(",", ".")}, or type="string" if the text is meant',
            True,
        )
    if re.fullmatch(_EXPONENT, value) is not None:
        mantissa, exponent = re.split("[eE]", value)
        return (
            f"{value} is a text and no number: roslaunch takes only numbers with a point in them for floating point",
            f'write {mantissa}.0e{exponent}, or type="double"',
            False,
        )
    if re.fullmatch(_LIST, value) is not None:
        return (
            f"{value} is a text and no list",
            f'write <rosparam param="{name}">{value}</rosparam>, or type="yaml"; type="string" if the text is meant',
            False,
        )
    lower = value.lower()
    if lower in _SWITCHES and re.search(_SWITCH, name) is not None:
        return f"{value} is a text and no boolean", f'write {_SWITCHES[lower]}, or type="string" if the text is meant', False
    if re.fullmatch(_WORD, value) is not None and lower not in _WORDS and lower not in _SWITCHES:
        near = next((word for word in ("true", "false") if distance(lower, word, 1) == 1), None)
        if near is not None:
            return f"{value} is a text and no boolean", f"did you mean {near}?", True
    return None
