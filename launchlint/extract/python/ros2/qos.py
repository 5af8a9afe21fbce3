"""Quality of service as rclpy's profiles say it.

Sources: rclpy.qos, and rmw/qos_profiles.h for the profiles that have a name. Every policy of a profile that the source names is known; one
that nobody can tell is not.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from launchlint.extract.fact import Qos
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.outside import NAMESPACE, NODE
from launchlint.python.text import ANY, template
from launchlint.python.values import MISSING, UNKNOWN, Choice, External, Handle, Outside, Text, Value, alternatives

_DEFAULT = Qos("reliable", "volatile", "keep_last", 10)
_SYSTEM = Qos("system_default", "system_default", "system_default")
_PROFILES: Mapping[str, Qos] = {
    "default": _DEFAULT,
    "system_default": _SYSTEM,
    "sensor_data": Qos("best_effort", "volatile", "keep_last", 5),
    "services_default": _DEFAULT,
    "parameters": Qos("reliable", "volatile", "keep_last", 1000),
    "parameter_events": Qos("reliable", "volatile", "keep_last", 1000),
    "best_available": Qos("best_available", "best_available", "keep_last", 10, liveliness="best_available"),
    "action_status_default": Qos("reliable", "transient_local", "keep_last", 1),
}
_WORDS: Mapping[str, tuple[str, ...]] = {
    "reliability": ("system_default", "reliable", "best_effort", "", "best_available"),
    "durability": ("system_default", "transient_local", "volatile", "", "best_available"),
    "history": ("system_default", "keep_last", "keep_all"),
    "liveliness": ("system_default", "automatic", "", "manual_by_topic", "", "best_available"),
}
"""The policies that are words, by the number that each word has in rmw/types.h."""
_POLICIES = ("history", "depth", "reliability", "durability", "lifespan", "deadline", "liveliness", "liveliness_lease_duration")
"""The arguments of ``QoSProfile`` in order."""
_PROFILE = re.compile(r"rclpy\.qos\.(?:qos_profile_(\w+)|QoSPresetProfiles\.([A-Z_]+))")
_LONG = re.compile(r"rmw_qos_policy_(?:reliability|durability|history|liveliness)_")
_FOREVER = ("rclpy.duration.Infinite", "rclpy.qos.INFINITE")


def profile(made: Call) -> Value:
    """``rclpy.qos.QoSProfile``: what is not given is as in the default profile, and the history keeps the last ones."""
    given: dict[object, Value] = {}
    for at, policy in enumerate(_POLICIES):
        value = made.get(at, policy)
        given["attribute", policy] = _GIVEN_NONE.get(policy) if value is None or value is MISSING else value
    return Handle("qos", given)


_GIVEN_NONE: Mapping[str, Value] = {"reliability": "reliable", "durability": "volatile", "history": "keep_last", "depth": 10}


def named(name: str) -> Handle | None:
    """The profile that ``rclpy.qos`` gives out under a full name: ``qos_profile_sensor_data``, ``QoSPresetProfiles.SENSOR_DATA.value``."""
    match = _PROFILE.fullmatch(name)
    known = None if match is None else _PROFILES.get((match[1] or match[2]).lower())
    if known is None:
        return None
    return Handle("qos", {("attribute", policy): getattr(known, policy, None) for policy in _POLICIES})


def by_short_key(made: Call) -> Value:
    """``QoSPresetProfiles.get_from_short_key('sensor_data')``."""
    name = made.get(0, "name", UNKNOWN)
    return External(f"rclpy.qos.QoSPresetProfiles.{name.upper()}") if isinstance(name, str) and name.isidentifier() else UNKNOWN


def duration(made: Call) -> Value:
    """``rclpy.duration.Duration(seconds=…, nanoseconds=…)``."""
    parts = [(made.keywords.get(name, 0), unit) for name, unit in (("seconds", 1.0), ("nanoseconds", 1e-9))]
    known = all(isinstance(part, (int, float)) and abs(part) < 1e12 for part, _ in parts)
    return Handle("duration", {"seconds": sum(part * unit for part, unit in parts)} if known else {})


def qos_of(value: Value, overrides: Value = None) -> Qos | None:
    """What is known of a profile, or of a number: its depth; of one of several profiles what they have in common.

    Args:
        value: what is given for the profile.
        overrides: what is given as ``qos_overriding_options``: whether params may change it.
    """
    first, *others = (_of(each) for _, each in alternatives(value))
    apart: dict[str, Any] = {name: None for name in Qos._fields if any(getattr(each, name) != getattr(first, name) for each in others)}
    known = first._replace(**{**apart, "overrides": not (overrides is None or overrides is MISSING)})
    return None if known == Qos() else known


def _of(value: Value) -> Qos:
    if isinstance(value, External):
        value = named(value.name)
    if isinstance(value, Handle):
        return _of_profile(value) if value.kind == "qos" else Qos()
    depth = _depth(value)
    return Qos() if depth is None else Qos("reliable", "volatile", "keep_last", depth)


def _of_profile(value: Handle) -> Qos:
    given = {policy: value.state.get(("attribute", policy), MISSING) for policy in _POLICIES}
    history = _word("history", given["history"])
    return Qos(
        reliability=_word("reliability", given["reliability"]),
        durability=_word("durability", given["durability"]),
        history=history,
        depth=_depth(given["depth"]) if history == "keep_last" else None,
        deadline=_time(given["deadline"]),
        lifespan=_time(given["lifespan"]),
        liveliness=_word("liveliness", given["liveliness"]),
        lease=_time(given["liveliness_lease_duration"]),
    )


def _word(policy: str, value: Value) -> str | None:
    words = _WORDS[policy]
    if isinstance(value, str):
        return value if value in words else None
    if isinstance(value, int) and not isinstance(value, bool):
        return words[value] or None if 0 <= value < len(words) else None
    if not isinstance(value, External) or not value.name.startswith("rclpy.qos."):
        return None
    word = _LONG.sub("", value.name.removesuffix(".value").rpartition(".")[2].lower())
    return word if word in words else None


def _depth(value: Value) -> int | str | None:
    if isinstance(value, int):
        return value if not isinstance(value, bool) and 0 <= value < 1 << 31 else None
    if not isinstance(value, (Text, Outside)) or isinstance(value, Choice):
        return None
    spelled = template(value)
    return None if ANY in spelled or NODE in spelled or NAMESPACE in spelled else spelled


def _time(value: Value) -> float | str | None:
    if isinstance(value, External) and value.name in _FOREVER:
        return "infinite"
    seconds = value.state.get("seconds") if isinstance(value, Handle) and value.kind == "duration" else None
    return None if seconds is None or seconds < 0 else float(seconds)
