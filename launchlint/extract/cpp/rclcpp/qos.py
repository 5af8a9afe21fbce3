"""Quality of service: rclcpp::QoS and rmw_qos_profile_t as objects whose policies are followed (rclcpp/qos.hpp, rmw/qos_profiles.h)."""

from __future__ import annotations

from collections.abc import Callable as Does
from collections.abc import Sequence

from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Cell, Number, Text, Thing, Value, choices
from launchlint.extract.fact import Qos

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.extract.cpp.calls import Call

QOS = Type("rclcpp::QoS")
"""The type of all profiles here, whatever they are called."""
_POLICY = Type("rmw_qos_policy_t")
_DURATION = Type("rclcpp::Duration")
_MOST = 1_000_000

_DEFAULT = Qos("reliable", "volatile", "keep_last", 10)
_SENSOR_DATA = Qos("best_effort", "volatile", "keep_last", 5)
_PARAMETERS = Qos("reliable", "volatile", "keep_last", 1000)
_ROSOUT = Qos("reliable", "transient_local", "keep_last", 1000)
_SYSTEM = Qos("system_default", "system_default", "system_default", None, liveliness="system_default")
_BEST_AVAILABLE = Qos("best_available", "best_available", "keep_last", 10, liveliness="best_available")

PROFILES: dict[str, Qos] = {
    "rmw_qos_profile_default": _DEFAULT,
    "rmw_qos_profile_services_default": _DEFAULT,
    "rmw_qos_profile_sensor_data": _SENSOR_DATA,
    "rmw_qos_profile_parameters": _PARAMETERS,
    "rmw_qos_profile_parameter_events": _PARAMETERS,
    "rmw_qos_profile_rosout_default": _ROSOUT,
    "rmw_qos_profile_system_default": _SYSTEM,
    "rmw_qos_profile_unknown": Qos(),
    "rmw_qos_profile_best_available": _BEST_AVAILABLE,
}
_CLASSES: dict[str, Qos] = {
    "SensorDataQoS": _SENSOR_DATA,
    "ParametersQoS": _PARAMETERS,
    "ServicesQoS": _DEFAULT,
    "ParameterEventsQoS": _PARAMETERS,
    "RosoutQoS": _ROSOUT,
    "SystemDefaultsQoS": _SYSTEM,
    "BestAvailableQoS": _BEST_AVAILABLE,
    "ClockQoS": Qos("best_effort", "volatile", "keep_last", 1),
}
_POLICIES: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "reliability": ("RELIABILITY", "ReliabilityPolicy", ("reliable", "best_effort", "system_default", "best_available")),
    "durability": ("DURABILITY", "DurabilityPolicy", ("volatile", "transient_local", "system_default", "best_available")),
    "history": ("HISTORY", "HistoryPolicy", ("keep_last", "keep_all", "system_default")),
    "liveliness": ("LIVELINESS", "LivelinessPolicy", ("automatic", "manual_by_topic", "system_default", "best_available")),
}
_NUMBERS: dict[str, tuple[str, ...]] = {
    "reliability": ("system_default", "reliable", "best_effort", "unknown", "best_available"),
    "durability": ("system_default", "transient_local", "volatile", "unknown", "best_available"),
    "history": ("system_default", "keep_last", "keep_all", "unknown"),
    "liveliness": ("system_default", "automatic", "manual_by_node", "manual_by_topic", "unknown", "best_available"),
}
"""The policies in the order of their enumerators (rmw/types.h)."""
_SETS: dict[str, tuple[str, str]] = {
    "reliable": ("reliability", "reliable"),
    "best_effort": ("reliability", "best_effort"),
    "reliability_best_available": ("reliability", "best_available"),
    "durability_volatile": ("durability", "volatile"),
    "transient_local": ("durability", "transient_local"),
    "durability_best_available": ("durability", "best_available"),
    "keep_all": ("history", "keep_all"),
    "liveliness_best_available": ("liveliness", "best_available"),
}
_TAKES = {
    "reliability": "reliability",
    "durability": "durability",
    "history": "history",
    "liveliness": "liveliness",
    "deadline": "deadline",
    "lifespan": "lifespan",
    "liveliness_lease_duration": "lease",
}


def profile(qos: Qos) -> Thing:
    """An object with the policies of a profile."""
    thing = Thing(QOS, None, 0)
    for key, value in zip(qos._fields, qos, strict=True):
        if value is not None and key != "overrides":
            thing.fields[key] = Cell(Number(value) if isinstance(value, (int, float)) else _policy(Text(value), _number(key, value)))
    return thing


def _policy(word: Value, number: int | None = None) -> Thing:
    """A policy, by its word and the number that it is in C++."""
    thing = Thing(_POLICY, None, 0)
    thing.fields["<word>"] = Cell(word)
    if number is not None:
        thing.fields["<number>"] = Cell(Number(number))
    return thing


def _number(key: str, word: str) -> int | None:
    numbers = _NUMBERS.get(key, ())
    return numbers.index(word) if word in numbers else None


def as_number(value: Value) -> Value:
    """A policy as the number that it is where somebody takes it for one; other values are what they are."""
    if isinstance(value, Thing) and value.type == _POLICY:
        return value.fields["<number>"].value if "<number>" in value.fields else UNKNOWN
    return value


def copied(thing: Thing) -> Thing:
    """Another object with the same policies: profiles are values."""
    other = Thing(thing.type, None, thing.serial)
    other.fields.update({key: Cell(cell.value, cell.type) for key, cell in thing.fields.items()})
    return other


def is_profile(value: Value) -> bool:
    """Whether a value is a profile."""
    return isinstance(value, Thing) and value.type.name == QOS.name


def made(asked: Call) -> Value:
    """``QoS(10)``, ``QoS(KeepLast(10), profile)``, ``QoS(other)``, ``QoS(HistoryPolicy, depth)``, ``QoSInitialization(history, depth)``."""
    values = [each.value for each in asked.arguments]
    if not values:
        return profile(Qos())
    profiles = [each for each in values if isinstance(each, Thing) and is_profile(each)]
    if profiles:
        thing = copied(profiles[-1])
        if len(profiles) > 1 or "reliability" not in thing.fields:
            base = thing if "reliability" in thing.fields else profile(_DEFAULT)
            _start(base, [profiles[0]])
            return base
        return thing
    thing = profile(_DEFAULT)
    if asked.name.endswith("QoSInitialization"):
        thing.fields.pop("reliability"), thing.fields.pop("durability")
    _start(thing, values)
    return thing


def _start(thing: Thing, values: Sequence[Value]) -> None:
    """The history and depth that a profile is made with."""
    first = values[0]
    if isinstance(first, Thing):
        for key in ("history", "depth"):
            thing.fields[key] = Cell(first.fields[key].value) if key in first.fields else Cell(UNKNOWN)
        return
    thing.fields["depth"] = Cell(values[-1])
    if len(values) > 1:
        thing.fields["history"] = Cell(first)


def _keep_last(asked: Call) -> Value:
    thing = profile(Qos(history="keep_last"))
    _start(thing, [asked.value(0)])
    return thing


def _keep_all(asked: Call) -> Value:
    return profile(Qos(history="keep_all", depth=0))


def _of_class(name: str) -> Does[[Call], Value]:
    def make(asked: Call) -> Value:
        thing = profile(_CLASSES[name])
        if asked.arguments:
            _start(thing, [asked.value(0)])
        return thing

    return make


def _set(name: str) -> Does[[Thing, Call], Value]:
    key, word = _SETS[name]

    def method(this: Thing, asked: Call) -> Value:
        _write(this, asked, key, _policy(Text(word)))
        return this

    return method


def _take(name: str) -> Does[[Thing, Call], Value]:
    def method(this: Thing, asked: Call) -> Value:
        if not asked.arguments:
            cell = this.fields.get(_TAKES[name])
            return UNKNOWN if cell is None else cell.value
        _write(this, asked, _TAKES[name], asked.value(0))
        return this

    return method


def _keep(this: Thing, asked: Call) -> Value:
    """``keep_last(depth)``."""
    _write(this, asked, "history", _policy(Text("keep_last")))
    _write(this, asked, "depth", asked.value(0))
    return this


def _same(this: Thing, asked: Call) -> Value:
    return this


def _write(this: Thing, asked: Call, key: str, value: Value) -> None:
    cell = this.fields.get(key)
    if cell is None:
        cell = this.fields[key] = asked.machine.cell(UNKNOWN)
    asked.machine.write(cell, value)


def _from_rmw(asked: Call) -> Value:
    first = asked.value(0)
    return copied(first) if isinstance(first, Thing) and is_profile(first) else profile(Qos())


def _word(asked: Call) -> Value:
    """``rmw_qos_reliability_policy_from_str(text)``: the policy that the text calls by its name."""
    return _policy(asked.value(0))


# -- times ----------------------------------------------------------------------------------------------------------------


def _duration(scale: float) -> Does[[Call], Value]:
    def make(asked: Call) -> Value:
        first, second = asked.value(0), asked.value(1)
        if isinstance(first, Thing) and first.type == _DURATION:
            return first
        thing = Thing(_DURATION, None, 0)
        if isinstance(first, Number) and (len(asked.arguments) == 1 or isinstance(second, Number)):
            rest = second.value * 1e-9 if isinstance(second, Number) else 0.0
            thing.fields["<seconds>"] = asked.machine.cell(Number(float(first.value) * (scale if len(asked.arguments) == 1 else 1) + rest))
        return thing

    return make


# -- what facts say -------------------------------------------------------------------------------------------------------


def qos_of(value: Value) -> Qos | None:
    """The quality of service that an argument stands for: a depth alone is the default one with that depth; None where nothing is known."""
    found = [_one(each) for _, each in choices(value)]
    if not found or None in found:
        return None
    known = [each for each in found if each is not None]
    first = known[0]
    differing: dict[str, Any] = {key: None for at, key in enumerate(Qos._fields[:-1]) if any(each[at] != first[at] for each in known)}
    merged = first._replace(**differing)
    return merged if any(each is not None for each in merged[:-1]) else None


def _one(value: Value) -> Qos | None:
    depth = _amount(value)
    if depth is not None:
        return _DEFAULT._replace(depth=depth)
    if not isinstance(value, Thing) or not is_profile(value):
        return None
    known = {key: _said(key, cell.value) for key, cell in value.fields.items() if key in Qos._fields}
    qos = Qos(**{key: each for key, each in known.items() if each is not None})  # type: ignore[arg-type]
    return qos._replace(depth=None) if qos.history in ("keep_all", "system_default") else qos


def _said(key: str, value: Value) -> str | int | float | None:
    if key == "depth":
        return _amount(value)
    if key in ("deadline", "lifespan", "lease"):
        seconds = value.fields.get("<seconds>") if isinstance(value, Thing) else None
        return seconds.value.value if seconds is not None and isinstance(seconds.value, Number) else None
    word = value.fields.get("<word>") if isinstance(value, Thing) and value.type == _POLICY else None
    if word is None or not isinstance(word.value, Text):
        return None
    return word.value.template if word.value.template in _POLICIES[key][2] or word.value.param else None


def _amount(value: Value) -> int | str | None:
    if isinstance(value, Number) and not isinstance(value.value, bool) and 0 <= value.value < _MOST:
        return int(value.value)
    return value.template if isinstance(value, Text) and value.param and "{any}" not in value.template else None


# -- tables ---------------------------------------------------------------------------------------------------------------

_SPACES = ("rclcpp", "rclcpp::qos")

MAKERS: dict[str, Does[[Call], Value]] = {
    "rclcpp::QoS": made,
    "rclcpp::QoSInitialization": made,
    "rmw_qos_profile_t": made,
    "rclcpp::KeepLast": _keep_last,
    "rclcpp::KeepAll": _keep_all,
    **{f"rclcpp::{name}": _of_class(name) for name in _CLASSES},
    "rclcpp::Duration": _duration(1e-9),
    "std::chrono::seconds": _duration(1.0),
    "std::chrono::milliseconds": _duration(1e-3),
    "std::chrono::microseconds": _duration(1e-6),
    "std::chrono::nanoseconds": _duration(1e-9),
}
METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    **{("rclcpp::QoS", name): _set(name) for name in _SETS},
    **{("rclcpp::QoS", name): _take(name) for name in _TAKES},
    ("rclcpp::QoS", "keep_last"): _keep,
    **dict.fromkeys(
        (("rclcpp::QoS", name) for name in ("get_rmw_qos_profile", "avoid_ros_namespace_conventions", "get_qos")),
        _same,
    ),
}
FUNCTIONS: dict[str, Does[[Call], Value | None]] = {
    "rclcpp::QoSInitialization::from_rmw": _from_rmw,
    "rclcpp::Duration::from_seconds": _duration(1.0),
    "rclcpp::Duration::from_nanoseconds": _duration(1e-9),
    **{f"rmw_qos_{name}_policy_from_str": _word for name in _POLICIES},
}


def _constants() -> dict[str, Does[[], Value]]:
    found: dict[str, Does[[], Value]] = {name: (lambda qos=qos: profile(qos)) for name, qos in PROFILES.items()}  # type: ignore[misc]
    for key, (macro, class_, words) in _POLICIES.items():
        for word in words:
            camel = "".join(part.title() for part in word.split("_"))
            number = _number(key, word)
            for name in (f"RMW_QOS_POLICY_{macro}_{word.upper()}", f"rclcpp::{class_}::{camel}"):
                found[name] = lambda word=word, number=number: _policy(Text(word), number)  # type: ignore[misc]
    return found


VALUES: dict[str, Does[[], Value]] = _constants()
