"""The counterpart of a node of ROS 1: a master that records, a subscriber to all it publishes, a stand-in for all it waits for."""

import os
from typing import Any, Dict, List, Set, Tuple

from launchlint_probe.answering import Answers
from launchlint_probe.counterpart import Counterpart, Known, Name, Seen
from launchlint_probe.interface import FULL, NAMESPACE, NODE, Harvest, interface, is_infrastructure, per_node, spelled
from launchlint_probe.messages import Definitions
from launchlint_probe.plan import Plan
from launchlint_probe.recorder import Recorder
from launchlint_probe.tcpros import Subscription, reconfigure_description, service_header

MOST_WOKEN = 500
"""Publishers that are connected to."""
ASKED_OFTEN = 8
"""A node that asks so often for a param that is not set waits for it."""
ROBOT = '<robot name="launchlint"><link name="base_link"/></robot>'
"""What a node finds as ``robot_description``, where the plan sets none: nodes that need one go no further without."""


def full_name(name: str) -> str:
    """Where a param of the configuration is set: ``~x`` is private to the node, ``x`` in its namespace."""
    if name.startswith("/"):
        return name
    return "{}/{}".format(FULL, name[1:]) if name.startswith("~") else "{}/{}".format(NAMESPACE, name)


class Master(Counterpart):
    """See the module. A launch file is not given anything: what it starts shall find what it starts."""

    def __init__(self, plan: Plan, definitions: Definitions) -> None:
        self.plan = plan
        self.given = {full_name(name): value for name, value in plan.params.items()}
        robot = dict.fromkeys(("/robot_description", NAMESPACE + "/robot_description"), ROBOT)
        self.recorder = Recorder({**({} if plan.many else robot), **self.given})
        self.answers = None if plan.many else Answers(self.recorder, definitions)
        self.subscriptions: Dict[Tuple[str, str], Subscription] = {}
        self._headers: Dict[str, Dict[str, str]] = {}

    def close(self) -> None:
        for each in self.subscriptions.values():
            each.close()
        if self.answers is not None:
            self.answers.close()
        self.recorder.close()

    # -- what the node does ------------------------------------------------------------------------------------

    def news(self) -> float:
        return self.recorder.facts.changed

    def touch(self) -> None:
        self.recorder.facts.touch()

    def names(self) -> Set[Name]:
        facts = self.recorder.facts
        tables = (("publishers", facts.publishers), ("subscribers", facts.subscribers), ("services", facts.services))
        return {(category, name) for category, table in tables for _, name in list(table)}

    def is_there(self) -> bool:
        return bool(self.recorder.facts.nodes or self.recorder.facts.lookups)

    def has_registered(self) -> bool:
        return any(not is_infrastructure(name) for _, name in self.names())

    def asks(self) -> bool:
        return bool(self.recorder.facts.lookups)

    def overflows(self) -> bool:
        return self.recorder.facts.overflow

    # -- what it is given --------------------------------------------------------------------------------------

    def has_unheard(self) -> bool:
        return len(self.subscriptions) < MOST_WOKEN and bool(self._unheard())

    def _unheard(self) -> List[Tuple[str, str]]:
        """The publishers that have not been listened to. To /rosout nobody needs to listen."""
        return [
            (api, name)
            for (_, name), (_, api) in list(self.recorder.facts.publishers.copy().items())
            if (api, name) not in self.subscriptions and not name.startswith("/rosout")
        ]

    def listen(self) -> bool:
        new = self._unheard()[: MOST_WOKEN - len(self.subscriptions)]
        for api, name in new:
            self.subscriptions[(api, name)] = Subscription(api, name)
        return bool(new)

    def is_settled(self) -> bool:
        return all(each.is_settled for each in list(self.subscriptions.values()))

    def serve(self) -> bool:
        if self.answers is None or not (self.answers.needs_serving() or self.answers.finish_goals(self.subscriptions)):
            return False
        self.answers.serve()
        return True

    def send(self) -> bool:
        if self.answers is None or not self.answers.needs_sending():
            return False
        self.answers.send()
        return True

    # -- what is made of it ------------------------------------------------------------------------------------

    def environment(self, directory: str) -> Dict[str, str]:
        return {
            "ROS_MASTER_URI": self.recorder.uri,
            "ROS_NAMESPACE": NAMESPACE,
            "ROS_IP": "127.0.0.1",
        }

    def command(self, directory: str) -> List[str]:
        words = list(self.plan.command) + ["{}:={}".format(name, target) for name, target in sorted(self.plan.remap.items())]
        if self.plan.with_name:
            words += ["__name:={}".format(NODE), "__log:={}".format(os.path.join(directory, ".log"))]
        return words

    def harvest(self, seen: Seen) -> None:
        if seen.reached:
            return
        for (_, name), (api, _) in list(self.recorder.facts.services.copy().items())[:MOST_WOKEN]:
            if not is_infrastructure(name):
                self._headers[name] = service_header(api, name)

    def interface(self, seen: Seen) -> Dict[str, Any]:
        facts = self.recorder.facts
        if self.plan.many:
            return {"interface": {"nodes": per_node(facts), "params": self._set_params()}}
        headers = {name: each.header for (_, name), each in self.subscriptions.items() if each.header}
        clients = {} if self.answers is None else self.answers.clients
        upon = self._upon(seen)
        found = Harvest(headers, self._headers, upon, _reconfigure(self.subscriptions), self.given, self.plan.tokens, clients)
        return {"interface": interface(facts, found)}

    def _set_params(self) -> List[str]:
        """The names of the params that a launch file sets."""
        return sorted({spelled(name) for name in list(self.recorder.facts.writes) if not is_infrastructure(name)})

    def _upon(self, seen: Seen) -> Dict[str, str]:
        """Name → what it appeared upon (``subscriber``, ``message``), of those that were not there from the start.

        What came when a service, an action or the clock was there belongs to the start: on a robot all that is there.
        """
        if seen.start is None:
            return {}
        found = {name: "subscriber" for _, name in (seen.woken or set()) - seen.start}
        if seen.served is not None:
            found.update({name: "message" for _, name in self.names() - seen.served})
        return found

    def known(self) -> Known:
        facts = self.recorder.facts
        tables = (facts.publishers, facts.subscribers, facts.services)
        untold = self.answers.untold() if self.answers is not None else []
        missed = sorted(name for name, count in facts.missed.items() if count >= ASKED_OFTEN and not is_infrastructure(name))
        return Known(
            contacted=bool(facts.nodes or facts.reads or facts.lookups or facts.searches),
            registered=bool(facts.nodes),
            has_names=any(not is_infrastructure(name) for table in tables for _, name in list(table)) or bool(facts.lookups),
            count=sum(map(len, tables)),
            overflow=facts.overflow,
            unanswered=[spelled(name) for name in self._unanswered()],
            untold=[spelled(name) for name in untold if not is_infrastructure(name)],
            missed=[spelled(name) for name in missed],
            silence="it never contacted the master",
            misses_nothing=True,
        )

    def _unanswered(self) -> List[str]:
        """The services that the node looked for and that nobody could answer."""
        facts = self.recorder.facts
        own = {name for _, name in list(facts.services)}
        served = set() if self.answers is None else set(self.recorder.served) - self.answers.refused
        return sorted(name for name in list(facts.lookups) if name not in own and name not in served)


def _reconfigure(subscriptions: Dict[Tuple[str, str], Subscription]) -> Dict[str, Dict[str, Any]]:
    found: Dict[str, Dict[str, Any]] = {}
    for (_, name), each in subscriptions.items():
        if each.header.get("type") == "dynamic_reconfigure/ConfigDescription" and each.message:
            base = name.rpartition("/")[0]
            for param, known in reconfigure_description(each.message).items():
                found["{}/{}".format(base, param)] = known
    return found
