"""A param has a value of another type than the one its node reads.

What it does: where the library says with which type a node reads a param, it compares that with the value. roscpp takes a whole number for
a double and rounds a double to an int, and nothing else: text is no number, and 1 is no bool. rospy takes any value; there only a list or
a mapping instead of a single value is told, and the reverse. Values in one YAML file that are wrong in the same way are told as one, also
where the file was copied, and so is the same value of the same param in several files, or all numbers that params of one program round, or
what one file gives to a param of several nodes of one program, each time a value of the same wrong type. An empty text is an info: it is a
way to say that the param is not set. So is a value that says the same as the default that the node falls back to: `1e-3`, a text for YAML,
where the default is 0.001, `pi / 2` where it is 1.5708, or `none` where it is false; and 0 for a bool of which no default is known.

In ROS 2 a node takes no other type than the one it declares a param with: that is an error, and so is a value beyond the range that it
declares, or none of those that it allows. An integer for a double is told by LL906. A placeholder that a tool replaces, `__RATE__`, is an
info, once for its file.

## Why it matters

A roscpp node that asks for a bool and finds an int behaves as if the param were not set, without a word: it runs with its default. A node
of ROS 2 dies when it declares the param.

## Example

```xml
<launch>
  <node pkg="joy" type="joy_node" name="joy">
    <param name="sticky_buttons" value="1"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="joy" type="joy_node" name="joy">
    <param name="sticky_buttons" value="true"/>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import ceil, floor, isclose, pi, prod

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Instance, Reading
from launchlint.late import late
from launchlint.model import ROS2, Launch, ParameterSetting
from launchlint.plural import listed
from launchlint.rules.judging.joined import alike, joined
from launchlint.rules.judging.param_values import is_certain, is_known, shown
from launchlint.rules.judging.template import has_placeholder
from launchlint.rules.rule import Rule
from launchlint.rules.view import GraphView
from launchlint.syntax.ros1.substitutions import opens

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

RULE = Rule("LL508", "param-wrong-type", Severity.WARNING)

_TAKES = {"bool": ("bool",), "int": ("int", "double"), "double": ("double", "int"), "str": ("str",), "list": ("list",), "dict": ("dict",)}
"""The types of values that ros::param::get takes for the type asked for."""
_WORDS = {"bool": "a bool", "int": "an int", "double": "a double", "str": "a string", "list": "a list", "dict": "a mapping"}
_CONTAINERS = ("list", "dict")
_FILLED = "it looks like what a tool replaces before anybody launches the file"
_ROUNDED = "is rounded"
_REFUSED = "refused"
_MOST_NAMED = 6
_SWITCHES = ("true", "false")
_NOTHING = ("", "~", "none", "null", "nil", "off", "no", "n", "disabled", "false", "0")
_ON = ("on", "yes", "y", "enabled", "true", "1")
_EXPONENT = late(r"([-+]?[0-9]+)(\.[0-9]*)?[eE]([-+]?)([0-9]+)")
"""A number with an exponent. roslaunch wants a point in it (roslaunch.loader.convert_value), PyYAML a point and a sign."""


_PRODUCT = late(r"\s*(?:[\d.]+|pi)(?:\s*[*/]\s*(?:[\d.]+|pi)){1,8}\s*", re.IGNORECASE)
_LIST = late(r"\[[^\[\]]*\]")
_FACTOR = late(r"([*/])\s*([\d.]+|pi)", re.IGNORECASE)


def check(view: GraphView) -> Iterator[Finding]:
    """Compare the value of each param with the types it is read with (ros::param::get)."""
    if view.dialect.name == ROS2:
        yield from _refused(view)
        return
    graph = view.graph
    instances = {instance.name: instance for instance in graph.instances}
    found: list[tuple[ParameterSetting, Finding]] = []
    for name, readings in graph.readers.items():
        setting = graph.parameters.setting(name)
        if setting is None or not is_known(setting.value) or not is_certain(setting) or _is_tried(setting, graph.launch):
            continue
        by_node: dict[str, list[Reading]] = {}
        for reading in readings:
            by_node.setdefault(reading.node, []).append(reading)
        for node, own in by_node.items():
            finding = _judge(setting, instances[node], own, view)
            if finding is not None:
                found.append((setting, finding))
    yield from _with_causes(found)


def _refused(view: GraphView) -> Iterator[Finding]:
    """In ROS 2: values that a node refuses when it declares the param (rclcpp::Node::declare_parameter)."""
    from launchlint.rules.judging.ros2_params import WORDS, beyond, fate, given, is_integer_for_double, is_of_old, is_refused

    about: tuple[str, ...]
    for each in given(view):
        name, program = each.instance.name, each.instance.program
        allowed = beyond(each)
        if allowed:
            said, label, advice = f"{name} takes {allowed} for {each.name}, and is given {shown(each.value)}", _REFUSED, ""
            about = ()
        elif is_refused(each) and not is_integer_for_double(each):
            wanted = WORDS[each.wanted[0].type]
            about, label = (name, wanted, WORDS[each.type]), WORDS[each.type]
            said, advice = _declared(name, each.name, wanted, label), f"give it {wanted}"
        else:
            continue
        template = isinstance(each.value, str) and has_placeholder(each.value)
        yield RULE.at(
            each.origin,
            said,
            severity=Severity.INFO if template or is_of_old(each, view) else Severity.ERROR,
            label=label,
            notes=(_FILLED if template else fate(each.instance),),
            help=advice,
            topic=f"{program} {each.name}",
            cause=f"{each.origin.place.source.path} {_FILLED}" if template else f"{program} {each.name} {shown(each.value)}",
            about=about,
        )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for the params that one file gives to the nodes of a program (two cameras), each time with a value of the same wrong type; of
    one node they are named.
    """

    def node(finding: Finding) -> tuple[object, ...]:
        place = (finding.location.path, finding.about[0]) if finding.about else finding.location
        return (place, finding.label, finding.help, finding.topic.partition(" ")[0])

    def program(finding: Finding) -> tuple[object, ...]:
        said = (finding.location.path, finding.topic.partition(" ")[0], finding.label, finding.help.partition(" ")[0])
        return finding.key if finding.label == _REFUSED else said

    at_once = [_at_once(several) for several in alike(findings, node)]
    for several in alike(at_once, program):
        told = joined(several) if len(several) > 1 else several[0]
        yield told if len({each.help for each in several}) == 1 else told._replace(help=f"{told.help}, and the others alike")


def _at_once(findings: Sequence[Finding]) -> Finding:
    """One for ``findings`` about one node at one place, with the names of its params."""
    names = list(dict.fromkeys(each.topic.partition(" ")[2] for each in findings))
    told = joined(findings) if len(findings) > 1 else findings[0]
    if len(names) < 2 or not told.about:
        return told
    node, wanted, value = told.about
    return told._replace(message=f"{_declared(node, f'{len(names)} params', wanted, value)}: {listed(names, _MOST_NAMED)}")


def _declared(node: str, what: str, wanted: str, value: str) -> str:
    return f"{node} declares {what} as {wanted}, and is given {value}"


def _with_causes(found: list[tuple[ParameterSetting, Finding]]) -> Iterator[Finding]:
    """The findings about one file share a cause, also with those about a copy of it: all params in it that are wrong in the same way.

    So do those of one program to which numbers are given that are no whole ones: whoever did so took its params for doubles; and all
    products and quotients, which whoever writes one expects roslaunch to compute; and all lists that a package is given by `<param>`.
    """
    in_file: dict[tuple[str, str], set[str]] = {}
    for setting, finding in found:
        if setting.tag == "rosparam":
            in_file.setdefault(_file(setting, finding), set()).add(_mistake(setting, finding))
    causes = {file: f"{', '.join(sorted(mistakes))} in a file" for file, mistakes in in_file.items() if len(mistakes) > 1}
    for setting, finding in found:
        of_file = causes.get(_file(setting, finding)) if setting.tag == "rosparam" else None
        of_value = f"{finding.topic.partition(' ')[0]} {_ROUNDED}" if finding.label == _ROUNDED else ""
        if isinstance(setting.value, str) and _PRODUCT.fullmatch(setting.value):
            of_value = f"{finding.label}: a calculation, which nobody makes"
        elif setting.tag == "param" and isinstance(setting.value, str) and _LIST.fullmatch(setting.value.strip()):
            of_value = f"{finding.topic.partition('/')[0]} {finding.label}: a list, of which <param> makes a text"
        yield finding._replace(cause=of_file or of_value or f"{setting.tag} {finding.topic} {_mistake(setting, finding)}")


def _file(setting: ParameterSetting, finding: Finding) -> tuple[str, str]:
    return setting.origin.place.source.path, finding.label


def _mistake(setting: ParameterSetting, finding: Finding) -> str:
    """What is wrong, without the program: several may read one file."""
    return f"{finding.topic.rpartition(' ')[2]} {shown(setting.value)} {finding.label}"


def _is_tried(setting: ParameterSetting, launch: Launch) -> bool:
    """Whether the value was only tried for an arg, to see the other side of a condition."""
    if not opens(setting.origin.place.text):
        return False
    steered: frozenset[str] = frozenset().union(*(branch.steered_by for branch in launch.branches))
    return str(setting.value).lower() in {value.strip().lower() for name, value in launch.given if name in steered}


def _judge(setting: ParameterSetting, instance: Instance, readings: list[Reading], view: GraphView) -> Finding | None:
    value = setting.value
    type_ = _type(value)
    wanted = {reading.declaration.type for reading in readings}
    if type_ is None or not wanted <= _TAKES.keys() or not all(reading.certain for reading in readings) or not instance.certain:
        return None
    reading = readings[0]
    if f"_{reading.declared.lstrip('~')}:=" in instance.node.arguments or any(_takes(instance, each, type_) for each in wanted):
        rounded = wanted == {"int"} and type_ == "double" and instance.client in ("roscpp", "nodelet")
        own = view.packages.get(instance.node.package, view.launch.entry.file) is not None  # whose code may be what is wrong
        return _rounded(setting, instance, reading, own=own) if rounded and value != _round(value) else None
    one = reading.declaration.type
    default = reading.declaration.default
    known = default is not None and not (isinstance(default, str) and "{" in default)
    instead = f"it runs with its default, {shown(default)}" if known else "it behaves as if the param were not set"
    if instance.client == "rospy":
        instead = f"it expects {_WORDS[one]}"
    means_default = known and (
        _plain(value) in (_plain(default), str(int(default)) if isinstance(default, bool) else "")
        or _is_number(value, default)
        or (isinstance(value, (str, int)) and str(value).strip().lower() in _words_for(default))
    )
    # What is not known to be true when it is not set is false, as the value says.
    means_default = means_default or (one == "bool" and not known and not isinstance(value, str) and value == 0)
    return RULE.at(
        setting.origin,
        f"{instance.program} reads {reading.declared} as {_WORDS[one]}, and {shown(value)} is {_WORDS[type_]}: {instead}",
        severity=Severity.INFO if means_default or value == "" else None,
        label=f"{_WORDS[type_]}, not {_WORDS[one]}",
        notes=("roscpp turns an int into a double and the reverse, nothing else, and says nothing",) if instance.client != "rospy" else (),
        help=_help(setting, one, type_, default if known and isinstance(default, str) else ""),
        topic=f"{instance.program} {reading.declared}",
    )


def _plain(value: Any) -> str:
    """The value without what tells a list from the text of one."""
    return str(value).lower().replace(" ", "").strip("[]")


def _words_for(default: Any) -> tuple[str, ...]:
    """What people write for ``default``: *none* for what is off or has nothing in it."""
    return _ON if default is True else () if default else _NOTHING


def _is_number(value: Any, default: Any) -> bool:
    """Whether ``value`` is the number ``default``, written as a text: ``1e-3`` and 0.001, ``pi / 2`` and 1.5708."""
    if not isinstance(value, str) or isinstance(default, (bool, str, list, dict)):
        return False
    factors = _FACTOR.findall(f"*{value}") if _PRODUCT.fullmatch(value) else [("*", value)]
    try:
        numbers = [(sign, pi if factor.lower() == "pi" else float(factor)) for sign, factor in factors]
        result = prod(1 / number if sign == "/" else number for sign, number in numbers)
    except (ValueError, ZeroDivisionError):
        return False
    return isclose(result, float(default))


def _looks_alike(text: str, type_: str) -> bool:
    """Whether a text that is meant as one looks like a value of ``type_``: a serial number of digits, ``false``."""
    if type_ == "bool":
        return text.lower() in _SWITCHES
    return not text.strip("0123456789.eE+-")


def _rounded(setting: ParameterSetting, instance: Instance, reading: Reading, *, own: bool) -> Finding:
    return RULE.at(
        setting.origin,
        f"{instance.program} reads {reading.declared} as an int: {shown(setting.value)} becomes {_round(setting.value)}",
        label=_ROUNDED,
        help="write a whole number, or let the node read a double" if own else "write a whole number",
        topic=f"{instance.program} {reading.declared}",
    )


def _round(value: float) -> float:
    """As ros::param::get does it for an int; what is no finite number stays as it is."""
    if value - value != 0:
        return value
    part = value - int(value)
    return floor(value) if part < 0.5 else ceil(value)


def _takes(instance: Instance, wanted: str, type_: str) -> bool:
    """Whether the node can use a value of ``type_`` where it wants another."""
    if instance.client in ("roscpp", "nodelet"):
        return type_ in _TAKES[wanted]
    return instance.client != "rospy" or (wanted in _CONTAINERS) == (type_ in _CONTAINERS)


def _type(value: Any) -> str | None:
    for kind, name in ((bool, "bool"), (int, "int"), (float, "double"), (str, "str"), (list, "list"), (dict, "dict")):
        if isinstance(value, kind):
            return name
    return None


def _help(setting: ParameterSetting, wanted: str, type_: str, default: str) -> str:
    value, in_yaml = setting.value, setting.tag == "rosparam"
    if wanted == "bool" and type_ in ("int", "str") and str(value).lower() in ("0", "1", "true", "false"):
        word = "true" if str(value).lower() in ("1", "true") else "false"
        return f"write {word}, without quotes" if in_yaml else f'write value="{word}"' + (' type="bool"' if type_ == "str" else "")
    if wanted == "str" and type_ not in _CONTAINERS:
        as_text = f'put it in quotes: "{value}"' if in_yaml else 'add type="str"'
        # The words of an enumeration are read as strings, too, and a number is none of them.
        return as_text if not default or _looks_alike(default, type_) else f'give a text such as "{default}"'
    number = _EXPONENT.fullmatch(value) if wanted == "double" and type_ == "str" else None
    if number is not None:
        whole, fraction, sign, exponent = number.groups()
        return f"{'YAML' if in_yaml else 'roslaunch'} takes {value} for text: write {whole}{fraction or '.0'}e{sign or '+'}{exponent}"
    return f"write {_WORDS[wanted]}"
