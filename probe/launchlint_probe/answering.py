"""What a node waits for, given to it with empty values: messages, services, action servers, the time.

Many nodes go on only when a first message has come, a service is there, an action server answers or the clock runs. Here a stand-in says
that it publishes and serves all that (slave API and TCPROS of ROS 1); what it sends are zeros, empty texts and empty arrays. Nobody but the
probed node hears of it, and nothing that the stand-in offers is taken for the node's own.
"""

import socket
import struct
import threading
import time
from typing import Any, Dict, List, Optional, Set, Tuple

from launchlint_probe.messages import Definitions
from launchlint_probe.recorder import Handler, Recorder, Server
from launchlint_probe.tcpros import CALLER, LONGEST_HEADER, LONGEST_MESSAGE, TIMEOUT, Header, Subscription, block, packed, unpacked

CLOCK = "/clock"
TICK = 0.1
"""Seconds between two messages of the clock."""
SUCCEEDED = 3
"""Of actionlib_msgs/GoalStatus."""
MOST_CONNECTIONS = 500

_ACTION_ENDS = ("status", "feedback", "result")


class Answers:
    """The stand-in for all that a node waits for. It does nothing until :meth:`serve` and :meth:`send` are called.

    ``told`` are the topics to which an empty message has been sent; ``clients`` says of each service that was called (or asked whether it
    is there) what its client said: type and MD5 sum.
    """

    def __init__(self, recorder: Recorder, definitions: Definitions) -> None:
        self.told: Set[str] = set()
        self.clients: Dict[str, Header] = {}
        self.refused: Set[str] = set()
        self._recorder = recorder
        self._definitions = definitions
        self._open: Dict[str, List[socket.socket]] = {}
        self._lock = threading.Lock()
        self._closed = False
        self._answered: Set[bytes] = set()
        self._given: Set[str] = set()
        self._listener = socket.socket()
        self._listener.bind(("127.0.0.1", 0))
        self._listener.listen(64)
        self._port = self._listener.getsockname()[1]
        self._slave = Server(("127.0.0.1", 0), Handler, logRequests=False, allow_none=True)
        self._slave.register_function(self._request_topic, "requestTopic")
        for name in ("publisherUpdate", "paramUpdate", "shutdown"):
            self._slave.register_function(_nothing, name)
        self.api = "http://127.0.0.1:{}/".format(self._slave.server_address[1])
        for target in (self._accept, self._slave.serve_forever, self._tick):
            thread = threading.Thread(target=target)
            thread.daemon = True
            thread.start()

    def close(self) -> None:
        """Stop, and hang up."""
        self._closed = True
        self._slave.shutdown()
        self._slave.server_close()
        with self._lock:
            sockets = [self._listener] + [each for found in self._open.values() for each in found]
        for each in sockets:
            _hang_up(each)

    # -- what is offered ----------------------------------------------------------------------------------------

    def needs_serving(self) -> bool:
        """Whether the node waits, or may wait, for a service, an action server or the clock that is not offered yet."""
        return bool(self._missing_services() or self._missing_topics(self._awaited()))

    def serve(self) -> None:
        """Offer the services that the node looks for, the servers of its actions, and the clock."""
        for name in self._missing_services():
            self._recorder.served[name] = "rosrpc://127.0.0.1:{}".format(self._port)
        self._offer(self._awaited())

    def needs_sending(self) -> bool:
        """Whether there are topics that nobody publishes."""
        return bool(self._missing_topics(self._heard()))

    def send(self) -> None:
        """Publish an empty message on each topic that the node subscribes to and does not publish itself."""
        self._offer(self._heard())

    def untold(self) -> List[str]:
        """The topics on which no message could be sent: their type is not known, or the node did not take it."""
        return sorted(name for name in self._recorder.offered if name in self._heard() and name not in self.told)

    def finish_goals(self, subscriptions: Dict[Tuple[str, str], Subscription]) -> bool:
        """Answer the goals that the node has sent: each has succeeded. Returns whether there were any."""
        found = False
        for (_, name), each in list(subscriptions.copy().items()):
            base, _, last = name.rpartition("/")
            kind = each.header.get("type", "")
            if last != "goal" or not kind.endswith("ActionGoal") or not each.message or each.message in self._answered:
                continue
            self._answered.add(each.message)
            empty = self._definitions.empty(kind[: -len("ActionGoal")] + "Result")
            status = goal_status(each.message)
            if empty is not None and status is not None:
                found = True
                self._write(base + "/status", bytes(16) + struct.pack("<I", 1) + status)
                self._write(base + "/result", bytes(16) + status + empty)
        return found

    def _missing_services(self) -> List[str]:
        facts = self._recorder.facts
        own = {name for _, name in list(facts.services)}
        return [name for name in list(facts.lookups) if name not in own and name not in self._recorder.served]

    def _missing_topics(self, topics: Set[str]) -> Set[str]:
        return topics - set(self._recorder.offered)

    def _awaited(self) -> Set[str]:
        """The clock, and what the servers of the node's actions publish."""
        facts = self._recorder.facts
        heard = {name for _, name in list(facts.subscribers)}
        goals = [
            name for (_, name), (kind, _) in list(facts.publishers.copy().items()) if name.endswith("/goal") and kind.endswith("ActionGoal")
        ]
        ends = {"{}/{}".format(name.rpartition("/")[0], end) for name in goals for end in _ACTION_ENDS}
        return heard & (ends | {CLOCK})

    def _heard(self) -> Set[str]:
        facts = self._recorder.facts
        return {name for _, name in list(facts.subscribers)} - {name for _, name in list(facts.publishers)}

    def _offer(self, topics: Set[str]) -> None:
        for topic in sorted(self._missing_topics(topics)):
            self._recorder.offer(topic, self.api)

    # -- connections --------------------------------------------------------------------------------------------

    def _request_topic(self, *words: Any) -> List[Any]:
        return [1, "ready", ["TCPROS", "127.0.0.1", self._port]]

    def _accept(self) -> None:
        while not self._closed:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            with self._lock:
                many = sum(map(len, self._open.values()))
            if many >= MOST_CONNECTIONS:
                _hang_up(connection)
                continue
            thread = threading.Thread(target=self._talk, args=(connection,))
            thread.daemon = True
            thread.start()

    def _talk(self, connection: socket.socket) -> None:
        try:
            connection.settimeout(TIMEOUT)
            header = unpacked(block(connection, LONGEST_HEADER))
            if "service" in header:
                self._answer(connection, header)
            elif "topic" in header:
                self._publish(connection, header)
        except (OSError, struct.error, ValueError):  # it may end, or say anything, at any moment
            pass
        finally:
            with self._lock:
                for found in self._open.values():
                    if connection in found:
                        found.remove(connection)
            _hang_up(connection)

    def _publish(self, connection: socket.socket, header: Header) -> None:
        topic = header["topic"]
        kind = header.get("type", "*")
        if kind == "*":
            kind = next((each for (_, name), (each, _) in list(self._recorder.facts.subscribers.copy().items()) if name == topic), "*")
        md5 = header.get("md5sum", "*")
        if md5 == "*":
            md5 = self._definitions.md5(kind) or "*"
        text = self._definitions.text(kind) or ""
        connection.sendall(
            packed({"callerid": CALLER, "topic": topic, "type": kind, "md5sum": md5, "latching": "1", "message_definition": text})
        )
        empty = self._definitions.empty(kind)
        with self._lock:
            self._open.setdefault(topic, []).append(connection)
        # A type of which another version is installed here has another size, too: better nothing than that.
        if empty is not None and topic != CLOCK and self._definitions.md5(kind) == md5:
            connection.sendall(struct.pack("<I", len(empty)) + empty)
            self.told.add(topic)
            self._recorder.facts.touch()
        connection.settimeout(None)
        while not self._closed and connection.recv(4096):
            pass

    def _answer(self, connection: socket.socket, header: Header) -> None:
        service = header["service"]
        md5 = header.get("md5sum", "*")
        kind = self._definitions.service_of(md5) or ""
        if md5 != "*":
            self.clients[service] = {"md5sum": md5, "type": kind}
        connection.sendall(packed({"callerid": CALLER, "service": service, "md5sum": md5, "type": kind or "*"}))
        if header.get("probe") == "1":
            return
        empty = self._definitions.empty_answer(kind) if kind else None
        connection.settimeout(None)
        while not self._closed:
            block(connection, LONGEST_MESSAGE)
            if empty is None:
                self.refused.add(service)
                said = b"the probe does not know this type of service"
                connection.sendall(struct.pack("<BI", 0, len(said)) + said)
            else:
                connection.sendall(struct.pack("<BI", 1, len(empty)) + empty)
                if service not in self._given:
                    self._given.add(service)
                    self._recorder.facts.touch()

    def _tick(self) -> None:
        while not self._closed:
            time.sleep(TICK)
            now = time.time()
            self._write(CLOCK, struct.pack("<II", int(now), int(now % 1 * 1e9)))

    def _write(self, topic: str, message: bytes) -> None:
        with self._lock:
            connections = list(self._open.get(topic, ()))
        for each in connections:
            try:
                each.sendall(struct.pack("<I", len(message)) + message)
                self.told.add(topic)
            except OSError:  # its own thread takes it away
                continue


def goal_status(goal: bytes) -> Optional[bytes]:
    """The ``actionlib_msgs/GoalStatus`` *succeeded* of a goal as it was sent: header, then the id, which is repeated."""
    try:
        frame = struct.unpack_from("<I", goal, 12)[0]
        begin = 16 + frame
        length = struct.unpack_from("<I", goal, begin + 8)[0]
        end = begin + 12 + length
    except struct.error:
        return None
    return goal[begin:end] + struct.pack("<BI", SUCCEEDED, 0) if end <= len(goal) else None


def _nothing(*words: Any) -> List[Any]:
    return [1, "", 0]


def _hang_up(connection: socket.socket) -> None:
    try:
        connection.shutdown(socket.SHUT_RDWR)
    except OSError:
        pass
    connection.close()
