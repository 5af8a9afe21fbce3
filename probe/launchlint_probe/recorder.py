"""A ROS master and parameter server that records what a node asks of it.

The node is started with this server as its ``ROS_MASTER_URI``. Every call is answered as rosmaster would (the XML-RPC APIs "Master" and
"Parameter Server" of ROS 1) and kept as a fact. A fresh one for each node starts within milliseconds and leaves nothing behind.
"""

import socketserver
import threading
import time
import xmlrpc.client
from typing import Any, Dict, List, Optional, Tuple
from xmlrpc.server import SimpleXMLRPCDispatcher, SimpleXMLRPCRequestHandler, SimpleXMLRPCServer

SUCCESS, ERROR = 1, -1
MOST_FACTS = 5000
"""Facts of one node; a node that makes up names for ever is stopped by this."""
LONGEST_BODY = 64 * 1024 * 1024
"""Bytes of one request: a robot_description may be large, what is larger is no request of a node."""

Answer = Tuple[int, str, Any]


class Facts:
    """What one node has done. ``changed`` is when something new was learnt last, in seconds of the monotonic clock; ``missed`` counts how
    often a param was asked for that is not set.
    """

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.changed = time.monotonic()
        self.publishers: Dict[Tuple[str, str], Tuple[str, str]] = {}
        self.subscribers: Dict[Tuple[str, str], Tuple[str, str]] = {}
        self.services: Dict[Tuple[str, str], Tuple[str, str]] = {}
        self.lookups: Dict[str, str] = {}
        self.reads: Dict[str, Tuple[str, bool]] = {}
        self.searches: Dict[str, str] = {}
        self.writes: Dict[str, Any] = {}
        self.nodes: Dict[str, str] = {}
        self.missed: Dict[str, int] = {}
        self.overflow = False

    def add(self, table: Dict[Any, Any], key: Any, value: Any) -> None:
        """Keep a fact, and when it was new."""
        with self.lock:
            known = key in table
            if not known and len(table) >= MOST_FACTS:
                self.overflow = True
                return
            if not known:
                self.changed = time.monotonic()
            table[key] = value

    def touch(self) -> None:
        """The node was given something: whatever follows from that is new."""
        self.changed = time.monotonic()


class Handler(SimpleXMLRPCRequestHandler):
    """Requests at ``/`` and ``/RPC2``, kept alive as rosmaster does."""

    rpc_paths = ()
    protocol_version = "HTTP/1.1"

    def log_message(self, format: str, *args: Any) -> None:
        """Say nothing."""

    def do_POST(self) -> None:
        """Refuse what is too long before it is read."""
        if int(self.headers.get("content-length") or 0) > LONGEST_BODY:
            self.send_error(413)
            return
        super().do_POST()


class Server(socketserver.ThreadingMixIn, SimpleXMLRPCServer):
    """An XML-RPC server with a thread for each connection, which ends when the program does."""

    daemon_threads = True
    block_on_close = False
    request_queue_size = 64

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Nodes die in the middle of a call, and may send anything: that is no news."""


class Recorder:
    """The server. ``uri`` is what ``ROS_MASTER_URI`` must say; ``parameters`` are set before the node starts.

    ``served`` and ``offered`` are services and topics that are not the node's, with their API: what the probe gives it.
    """

    def __init__(self, parameters: Optional[Dict[str, Any]] = None, host: str = "127.0.0.1") -> None:
        self.facts = Facts()
        self.served: Dict[str, str] = {}
        self.offered: Dict[str, str] = {}
        self._parameters: Dict[str, Any] = {}
        for name, value in (parameters or {}).items():
            self._store(name, value)
        self._server = Server((host, 0), Handler, logRequests=False, allow_none=True)
        self._server.register_instance(_Api(self))
        self._server.register_multicall_functions()
        self.uri = "http://{}:{}/".format(host, self._server.server_address[1])
        self._thread = threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.05})
        self._thread.daemon = True
        self._thread.start()

    def close(self) -> None:
        """Stop answering."""
        self._server.shutdown()
        self._server.server_close()

    def offer(self, topic: str, api: str) -> None:
        """Say to all who hear a topic, now and later, that somebody publishes it."""
        self.offered[topic] = api
        publishers = self.publishers(topic)
        for listener in sorted({known for (_, name), (_, known) in list(self.facts.subscribers.copy().items()) if name == topic}):
            _in_background(_update, listener, topic, publishers)

    def publishers(self, topic: str) -> List[str]:
        """The APIs of those who publish a topic."""
        own = {api for (_, name), (_, api) in list(self.facts.publishers.copy().items()) if name == topic}
        return sorted(own | ({self.offered[topic]} if topic in self.offered else set()))

    # -- parameters ---------------------------------------------------------------------------------------------

    def _store(self, name: str, value: Any) -> None:
        steps = [step for step in name.split("/") if step]
        if not steps:
            if isinstance(value, dict):
                self._parameters = value
            return
        inside = self._parameters
        for step in steps[:-1]:
            below = inside.get(step)
            if not isinstance(below, dict):
                below = inside[step] = {}
            inside = below
        inside[steps[-1]] = value

    def _find(self, name: str) -> Tuple[bool, Any]:
        value: Any = self._parameters
        for step in name.split("/"):
            if step:
                if not isinstance(value, dict) or step not in value:
                    return False, None
                value = value[step]
        return True, value

    def parameter(self, name: str) -> Tuple[bool, Any]:
        """Whether a param is set, and its value."""
        with self.facts.lock:
            return self._find(name)

    def store(self, name: str, value: Any) -> None:
        """Set a param."""
        with self.facts.lock:
            self._store(name, value)

    def delete(self, name: str) -> bool:
        """Delete a param; whether it was there."""
        steps = [step for step in name.split("/") if step]
        with self.facts.lock:
            found, _ = self._find(name)
            if found and steps:
                outer = self._find("/".join(steps[:-1]))[1]
                del outer[steps[-1]]
            return found

    def names(self) -> List[str]:
        """The names of all params that hold a value."""
        found: List[str] = []
        with self.facts.lock:
            waiting: List[Tuple[str, Any]] = [("", self._parameters)]
            while waiting:
                name, value = waiting.pop()
                if isinstance(value, dict) and (value or not name):
                    waiting.extend(("{}/{}".format(name, key), inner) for key, inner in value.items())
                else:
                    found.append(name)
        return sorted(found)


def absolute(name: str, caller: str) -> str:
    """A name as client libraries send it, made global: they resolve names themselves, but not all of them do."""
    if name.startswith("/"):
        return name
    if name.startswith("~"):
        return "{}/{}".format(caller, name[1:])
    return "{}/{}".format(caller.rpartition("/")[0], name)


class _Api(SimpleXMLRPCDispatcher):
    """The calls of the master and parameter server APIs, each with the caller's name first."""

    def __init__(self, recorder: Recorder) -> None:
        super().__init__(allow_none=True)
        self._recorder = recorder
        self._facts = recorder.facts

    def _dispatch(self, method: str, params: Any) -> Any:
        """Call a method by its name in the API."""
        call = _CALLS.get(method)
        if call is None:
            return [ERROR, "unknown method {}".format(str(method)[:100]), 0]
        try:
            return list(call(self, *params))
        except TypeError as error:
            return [ERROR, str(error)[:200], 0]

    def _add(self, table: Dict[Any, Any], caller: str, name: str, kind: str, api: str) -> None:
        self._facts.add(table, (caller, name), (kind, api))
        self._facts.add(self._facts.nodes, caller, api)

    def register_publisher(self, caller: str, topic: str, kind: str, api: str) -> Answer:
        """Record a publisher; subscribers are told, as the master does."""
        topic = absolute(topic, caller)
        self._add(self._facts.publishers, caller, topic, kind, api)
        listeners = [known for (_, name), (_, known) in list(self._facts.subscribers.copy().items()) if name == topic]
        publishers = self._recorder.publishers(topic)
        for listener in listeners:
            _in_background(_update, listener, topic, publishers)
        return SUCCESS, "registered", listeners

    def unregister_publisher(self, caller: str, topic: str, api: str) -> Answer:
        """What was there stays a fact."""
        return SUCCESS, "unregistered", 1

    def register_subscriber(self, caller: str, topic: str, kind: str, api: str) -> Answer:
        """Record a subscriber."""
        topic = absolute(topic, caller)
        self._add(self._facts.subscribers, caller, topic, kind, api)
        return SUCCESS, "registered", self._recorder.publishers(topic)

    def register_service(self, caller: str, service: str, service_api: str, api: str) -> Answer:
        """Record a service."""
        self._add(self._facts.services, caller, absolute(service, caller), service_api, api)
        return SUCCESS, "registered", 1

    def look_up_service(self, caller: str, service: str) -> Answer:
        """Record that somebody wants to call a service."""
        service = absolute(service, caller)
        self._facts.add(self._facts.lookups, service, caller)
        for (_, name), (service_api, _) in list(self._facts.services.copy().items()):
            if name == service:
                return SUCCESS, "found", service_api
        if service in self._recorder.served:
            return SUCCESS, "found", self._recorder.served[service]
        return ERROR, "no provider", ""

    def look_up_node(self, caller: str, name: str) -> Answer:
        """The API of a node."""
        api = self._facts.nodes.get(name)
        return (SUCCESS, "found", api) if api else (ERROR, "unknown node", "")

    def published_topics(self, caller: str, subgraph: str = "") -> Answer:
        """Topics and their types."""
        listed = {(name, kind) for (_, name), (kind, _) in list(self._facts.publishers.copy().items())}
        listed |= {(name, kind) for (_, name), (kind, _) in list(self._facts.subscribers.copy().items()) if name in self._recorder.offered}
        return SUCCESS, "current topics", [list(each) for each in sorted(listed)]

    def topic_types(self, caller: str) -> Answer:
        """As published_topics, with what is only subscribed."""
        listed = {
            name: kind
            for (_, name), (kind, _) in [*list(self._facts.subscribers.copy().items()), *list(self._facts.publishers.copy().items())]
        }
        return SUCCESS, "current types", [[name, listed[name]] for name in sorted(listed)]

    def system_state(self, caller: str) -> Answer:
        """Publishers, subscribers, services."""
        state = []
        for table in (self._facts.publishers, self._facts.subscribers, self._facts.services):
            grouped: Dict[str, List[str]] = {}
            for node, name in list(table):
                grouped.setdefault(name, []).append(node)
            state.append([[name, grouped[name]] for name in sorted(grouped)])
        return SUCCESS, "current state", state

    def uri(self, caller: str) -> Answer:
        """Where this master is."""
        return SUCCESS, "", self._recorder.uri

    def process(self, caller: str) -> Answer:
        """A process id: of nobody in particular."""
        return SUCCESS, "", 1

    def _read(self, name: str, caller: str, found: bool) -> None:
        self._facts.add(self._facts.reads, name, (caller, found))
        with self._facts.lock:
            if found:
                self._facts.missed.pop(name, None)
            elif name in self._facts.reads:
                self._facts.missed[name] = self._facts.missed.get(name, 0) + 1

    def get_parameter(self, caller: str, name: str) -> Answer:
        """Record that a param is read."""
        name = absolute(name, caller)
        found, value = self._recorder.parameter(name)
        self._read(name, caller, found)
        return (SUCCESS, "param {}".format(name), value) if found else (ERROR, "param {} is not set".format(name), 0)

    def has_parameter(self, caller: str, name: str) -> Answer:
        """Record that a param is asked for."""
        name = absolute(name, caller)
        found, _ = self._recorder.parameter(name)
        self._read(name, caller, found)
        return SUCCESS, name, found

    def subscribe_parameter(self, caller: str, api: str, name: str) -> Answer:
        """Record that a param is read and watched (ros::param::getCached)."""
        name = absolute(name, caller)
        found, value = self._recorder.parameter(name)
        self._facts.add(self._facts.reads, name, (caller, found))
        return SUCCESS, "subscribed", value if found else {}

    def unsubscribe_parameter(self, caller: str, api: str, name: str) -> Answer:
        """Nothing is watched in earnest."""
        return SUCCESS, "unsubscribed", 1

    def search_parameter(self, caller: str, name: str) -> Answer:
        """Look for a param here and in the namespaces above; record what is looked for."""
        if name.startswith("/"):
            found, _ = self._recorder.parameter(name)
            self._facts.add(self._facts.reads, name, (caller, found))
            return (SUCCESS, "found", name) if found else (ERROR, "not found", "")
        self._facts.add(self._facts.searches, name, caller)
        first = name.split("/")[0]
        namespace = caller
        while True:
            if self._recorder.parameter("{}/{}".format(namespace, first))[0]:
                return SUCCESS, "found", "{}/{}".format(namespace, name)
            if not namespace:
                return ERROR, "not found", ""
            namespace = namespace.rpartition("/")[0]

    def set_parameter(self, caller: str, name: str, value: Any) -> Answer:
        """Record that a node sets a param."""
        name = absolute(name, caller)
        self._recorder.store(name, value)
        self._facts.add(self._facts.writes, name, value)
        return SUCCESS, "set", 0

    def delete_parameter(self, caller: str, name: str) -> Answer:
        """Delete a param."""
        return (SUCCESS, "deleted", 0) if self._recorder.delete(absolute(name, caller)) else (ERROR, "not set", 0)

    def parameter_names(self, caller: str) -> Answer:
        """All names."""
        return SUCCESS, "names", self._recorder.names()


_CALLS: Dict[str, Any] = {
    "registerPublisher": _Api.register_publisher,
    "unregisterPublisher": _Api.unregister_publisher,
    "registerSubscriber": _Api.register_subscriber,
    "unregisterSubscriber": _Api.unregister_publisher,
    "registerService": _Api.register_service,
    "unregisterService": _Api.unregister_publisher,
    "lookupService": _Api.look_up_service,
    "lookupNode": _Api.look_up_node,
    "getPublishedTopics": _Api.published_topics,
    "getTopicTypes": _Api.topic_types,
    "getSystemState": _Api.system_state,
    "getUri": _Api.uri,
    "getPid": _Api.process,
    "getParam": _Api.get_parameter,
    "hasParam": _Api.has_parameter,
    "subscribeParam": _Api.subscribe_parameter,
    "unsubscribeParam": _Api.unsubscribe_parameter,
    "searchParam": _Api.search_parameter,
    "setParam": _Api.set_parameter,
    "deleteParam": _Api.delete_parameter,
    "getParamNames": _Api.parameter_names,
}


def _in_background(function: Any, *arguments: Any) -> None:
    thread = threading.Thread(target=function, args=arguments)
    thread.daemon = True
    thread.start()


def _update(api: str, topic: str, publishers: List[str]) -> None:
    """Tell a subscriber who publishes (``publisherUpdate`` of the slave API)."""
    try:
        xmlrpc.client.ServerProxy(api).publisherUpdate("/master", topic, publishers)
    except Exception:  # a node may end at any moment, and may answer anything
        return
