"""``<param>`` and ``<rosparam>`` of a node of ROS 1 as params of a node of ROS 2."""

from __future__ import annotations

from launchlint.evaluate.expression.errors import UnknownValue
from launchlint.evaluate.ros1.rosparam import YamlError, YamlUnknown, load
from launchlint.evaluate.ros1.typed_values import convert_value
from launchlint.evaluate.ros2.parameters import LETTERS
from launchlint.evaluate.ros2.typed import TypeFault, convert
from launchlint.export.from_ros1.frame import Account
from launchlint.export.from_ros1.values import Values
from launchlint.export.ros2.losses import Left
from launchlint.syntax.ros2.description import Parameter, ParameterFile, ParameterSource, Substitution, Text, TypedValue
from launchlint.yaml.tree import YamlBeyond

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.source import Place
    from launchlint.syntax.tree import Element

_TYPES = {"str": "str", "string": "str", "int": "int", "double": "float", "bool": "bool", "boolean": "bool"}
_LARGEST = 1 << 63
FILE_HAS_NO_NODE = "has to say in ROS 2 whose params these are: put /**: and ros__parameters: above what stands in it"


class Params:
    """Makes the params of one file."""

    def __init__(self, values: Values, account: Account) -> None:
        self._values = values
        self._account = account

    def param(self, element: Element, name: str) -> ParameterSource:
        """A ``<param>`` that is the param ``name`` of a node. Raises Left."""
        place = self._values.place(element)
        attributes = element.attributes
        if "binfile" in attributes:
            raise Left(place, "binfile has no counterpart")
        if "textfile" in attributes:
            file = self._values.of(attributes["textfile"])
            return _named(name, TypedValue(Text((Substitution("file-content", (file,), place),), place), "str"), place)
        if "command" in attributes:
            line = self._values.of(attributes["command"])
            return _named(name, TypedValue(Text((Substitution("command", (line,), place),), place), "str"), place)
        if "value" not in attributes:
            raise Left(place, "it has no value")
        text = self._values.of(attributes["value"])
        type_ = attributes["type"].value.lower() if "type" in attributes else "auto"
        if text.literal is None:
            if type_ == "yaml":
                return _named(name, TypedValue(text), place)
            return _named(name, TypedValue(text, _TYPES.get(type_) or _guarded(self._values.set_to(element))), place)
        try:
            value = convert_value(text.literal.strip(), type_)
        except (ValueError, UnknownValue):
            raise Left(place, "its value is not of its type") from None
        return _named(name, _plain(value, place), place) if not isinstance(value, dict) else self._nested(name, value, place)

    def rosparam(self, element: Element, prefix: str) -> list[ParameterSource]:
        """A ``<rosparam>`` in a node; ``prefix`` is what goes before the names in it, with a point at its end. Raises Left."""
        place = self._values.place(element)
        attributes = element.attributes
        command = attributes["command"].value if "command" in attributes else "load"
        if command != "load":
            raise Left(place, f"command={command} has no counterpart")
        substitutes = "subst_value" in attributes and attributes["subst_value"].value.lower() == "true"
        if "file" in attributes:
            file = self._values.of(attributes["file"])
            words = attributes["file"].value
            under = "" if not prefix else f", and {prefix[:-1].replace('.', ': ')}: below these"
            ros1 = "; the substitutions in it are those of ROS 1" if substitutes else ""
            self._account.remark(place, f"{words} {FILE_HAS_NO_NODE}{under}{ros1}")
            self._account.dropped.append(self._values.whole(element))
            return [ParameterFile(file, substitutes, place)]
        try:
            data = load(element.text).data
        except (YamlError, YamlUnknown):
            raise Left(place, "its YAML is not understood") from None
        if data is None:
            return []
        if not isinstance(data, dict):
            if not prefix:
                raise Left(place, "it holds no mapping")
            if isinstance(data, str) and substitutes and not self._values.is_set(element):
                raise Left(place, "it sets nothing as this is exported")
            return [_named(prefix[:-1], self._value(data, place, substitutes), place)]
        before = len(self._account.lost)
        found = [each for key, value in data.items() for each in self._entry(f"{prefix}{_key(key, place)}", value, place, substitutes)]
        if len(self._account.lost) > before:
            self._account.dropped.append(self._values.whole(element))
        return list(found)

    def _nested(self, name: str, data: dict[Any, Any], place: Place) -> ParameterSource:
        inner = [each for key, value in data.items() for each in self._entry(_key(key, place), value, place, False)]
        if not inner:
            raise Left(place, "it holds nothing")
        return Parameter(Text((name,), place), None, tuple(inner), place)

    def _entry(self, name: str, value: Any, place: Place, substitutes: bool) -> list[Parameter]:
        """One entry of a mapping; what cannot be a param of ROS 2 is lost."""
        try:
            if isinstance(value, dict):
                inner = [each for key, item in value.items() for each in self._entry(_key(key, place), item, place, substitutes)]
                return [Parameter(Text((name,), place), None, tuple(inner), place)] if inner else []
            return [_named(name, self._value(value, place, substitutes), place)]
        except Left as left:
            self._account.lose(left.place, f"the param {name}", left.why)
            return []

    def _value(self, value: Any, place: Place, substitutes: bool) -> TypedValue:
        if isinstance(value, str) and substitutes and "$(" in value:
            return TypedValue(self._values.text(value, place))
        return _plain(value, place)


def _guarded(value: object) -> str | None:
    """The type that has to be said, since YAML would make something else of what roslaunch takes for a text, or a number."""
    if isinstance(value, str):
        try:
            return None if isinstance(convert(value, None), str) else "str"
        except (TypeFault, YamlBeyond):
            return "str"
    return "float" if isinstance(value, float) else None


def _named(name: str, value: TypedValue, place: Place) -> Parameter:
    return Parameter(Text((name,), place), value, (), place)


def _key(key: object, place: Place) -> str:
    if not isinstance(key, str) or not key:
        raise Left(place, f"the key {key!r} is no name")
    return dotted(key)


def dotted(name: str) -> str:
    """The name of a param below a node: ROS 2 has points where ROS 1 has slashes."""
    return ".".join(part for part in name.removeprefix("~").split("/") if part)


def _plain(value: Any, place: Place) -> TypedValue:
    """A value that is known. Raises Left."""
    if isinstance(value, list):
        if not value:
            raise Left(place, "a list without items has no type in ROS 2")
        kinds = {type(each) for each in value}
        if kinds == {int, float}:
            value = [float(each) for each in value]
        elif len(kinds) != 1 or not isinstance(value[0], (bool, int, float, str)):
            raise Left(place, "ROS 2 has lists of values of one type only")
        return TypedValue(tuple(_text(_checked(each, place), place) for each in value), None, tuple(value))
    return TypedValue(_text(_checked(value, place), place), None, value)


def _checked(value: Any, place: Place) -> Any:
    if not isinstance(value, (bool, int, float, str)):
        raise Left(place, "ROS 2 has no such values")
    if isinstance(value, str) and _is_read_again(value):
        raise Left(place, f"the text {value} would be read again, as something else")
    if isinstance(value, int) and abs(value) >= _LARGEST:
        raise Left(place, "it is too large a number")
    return value


def _is_read_again(text: str) -> bool:
    """Whether launch writes a text without quotes that rcl then takes for a number, or for true or false."""
    if text in LETTERS:
        return True
    try:
        float(text)
        return isinstance(convert(text, None), str)
    except (ValueError, TypeFault, YamlBeyond):
        return False


def _text(value: object, place: Place) -> Text:
    return Text((str(value),) if value != "" else (), place)
