"""The quality of service of an endpoint of ROS 2, as far as it can be known, and which offers satisfy which requests.

Params may change it where the program lets them (``rclcpp::QosOverridingOptions``, ``rclpy.qos_overriding_options``): they are called
``qos_overrides./topic.publisher.reliability``, with the topic as it is on the graph.
"""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.library.template import fill, is_template, parse
from launchlint.named_tuple import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.library.program import Declaration
    from launchlint.library.template import Situation

    Qos = Mapping[str, str | float]
    Own = Mapping[str, tuple[str, Any]] | None

NO_QOS: Mapping[str, str | float] = {}
INFINITE = "infinite"
_NUMBERS = ("depth", "deadline", "lifespan", "lease")
_DEFAULT_OVERRIDES = ("history", "depth", "reliability")
"""What may be changed where a program lets params change the QoS and does not say what of it."""
_OTHERWISE = {"liveliness_lease_duration": "lease"}
"""Policies that params call by another name."""
_ELSEWHERE = ("system_default", "best_available")
"""Values that say that another one decides."""
_SIDES = {"publishers": "publisher", "subscribers": "subscription"}


def qos_of(declaration: Declaration, topic: str, start: Situation, own: Own) -> Qos:
    """What is known of the QoS of an endpoint on ``topic``: policy to value, without those that are not known.

    ``own`` are the params of its node, None where they are not known.
    """
    found: dict[str, str | float] = {}
    for policy, said in (declaration.qos or {}).items():
        value = _filled(said, start)
        if policy in _NUMBERS and isinstance(value, str) and value != INFINITE:
            value = _number(value)
        if value is not None and value not in _ELSEWHERE:
            found[policy] = value
    return _overridden(found, declaration.category, topic, own) if declaration.overrides else found


def _filled(said: Any, start: Situation) -> Any:
    """A value with its templates filled in; None where that cannot be known."""
    if not isinstance(said, str) or not is_template(said):
        return said
    value = fill(parse(said), start)
    return value.lower() if isinstance(value, str) else None


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return int(value) if value.is_integer() else value if value - value == 0 else None


def _overridden(found: dict[str, str | float], category: str, topic: str, own: Own) -> Qos:
    """``found`` after what the params of the node say: of policies that only some programs let them change nothing is known then."""
    if own is None:
        return NO_QOS
    side = f"qos_overrides.{topic}.{_SIDES[category]}"
    for name, (_, value) in own.items():
        if not name.startswith(side):
            continue
        policy = name[len(side) + 1 :]
        if name[len(side) : len(side) + 1] == "." and policy in _DEFAULT_OVERRIDES and isinstance(value, (str, int)):
            found[policy] = value
        else:  # of a publisher with an id of its own, or a policy that may be left alone
            last = policy.rpartition(".")[2]
            found.pop(_OTHERWISE.get(last, last), None)
    return {policy: value for policy, value in found.items() if value not in _ELSEWHERE}


class Clash(NamedTuple):
    """A policy of which less is offered than is requested."""

    policy: str
    offered: str | float
    requested: str | float


_ORDERS = {
    "reliability": ("best_effort", "reliable"),
    "durability": ("volatile", "transient_local"),
    "liveliness": ("automatic", "manual_by_topic"),
}
"""The values of policies, the weakest first: what is offered must be at least as strong as what is requested."""


def clashes(offered: Qos, requested: Qos) -> tuple[Clash, ...]:
    """The policies for which a publisher and a subscriber do not connect (``rmw_dds_common``'s and DDS's rules); those that are known."""
    found = []
    for policy, order in _ORDERS.items():
        left, right = offered.get(policy), requested.get(policy)
        if left in order and right in order and order.index(str(left)) < order.index(str(right)):
            found.append(Clash(policy, str(left), str(right)))
    for policy in ("deadline", "lease"):
        left, right = offered.get(policy), requested.get(policy)
        if left is not None and right is not None and _seconds(left) > _seconds(right):
            found.append(Clash(policy, left, right))
    return tuple(found)


def _seconds(value: str | float) -> float:
    return float("inf") if isinstance(value, str) or value == 0 else value


def qos_text(qos: Mapping[str, Any]) -> str:
    """A QoS profile for people, as far as it is known: *reliable, transient_local, keep_last 1*."""
    said = [str(qos[each]) for each in ("reliability", "durability") if each in qos]
    history = " ".join(str(qos[each]) for each in ("history", "depth") if each in qos)
    times = [f"{each} {qos[each]}" for each in ("deadline", "lifespan", "liveliness", "lease") if each in qos]
    return ", ".join([*said, *([history if "history" in qos else f"depth {history}"] if history else []), *times])
