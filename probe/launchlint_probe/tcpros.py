"""Talking to a node as another node would (TCPROS): to wake lazy publishers, and to learn types and MD5 sums from connection headers."""

import socket
import struct
import threading
import time
import xmlrpc.client
from typing import Any, Dict, List, Optional, Tuple
from urllib.parse import urlparse

CALLER = "/launchlint_probe"
TIMEOUT = 2.0
"""Seconds for one connection."""
ATTEMPTS = 3
PAUSE = 0.1
"""Seconds before a publisher that did not answer is asked again; twice as many the next time."""
LATCHED = 0.4
"""Seconds until a publisher that latches has sent what it has: not all of them have published anything yet."""
LONGEST_HEADER = 1024 * 1024
LONGEST_MESSAGE = 4 * 1024 * 1024

Header = Dict[str, str]


def packed(fields: Header) -> bytes:
    """A connection header as it goes over the wire, with its length first."""
    lines = [("{}={}".format(key, value)).encode("utf-8") for key, value in fields.items()]
    body = b"".join(struct.pack("<I", len(line)) + line for line in lines)
    return struct.pack("<I", len(body)) + body


def _receive(connection: socket.socket, length: int) -> bytes:
    parts: List[bytes] = []
    while length:
        part = connection.recv(min(length, 65536))
        if not part:
            raise OSError("the connection was closed")
        parts.append(part)
        length -= len(part)
    return b"".join(parts)


def block(connection: socket.socket, longest: int) -> bytes:
    """What comes next on a connection: a length, and so many bytes. Raises OSError where it is longer than ``longest``."""
    length = struct.unpack("<I", _receive(connection, 4))[0]
    if length > longest:
        raise OSError("the answer is too long")
    return _receive(connection, length)


def unpacked(data: bytes) -> Header:
    """The fields of a connection header. Raises struct.error where it is none."""
    fields: Header = {}
    at = 0
    while at + 4 <= len(data):
        length = struct.unpack_from("<I", data, at)[0]
        key, _, value = data[at + 4 : at + 4 + length].decode("utf-8", "replace").partition("=")
        fields[key] = value
        at += 4 + length
    return fields


def service_header(service_api: str, service: str) -> Header:
    """The header with which a service answers a probe: ``type`` and ``md5sum``. Empty where it does not answer."""
    where = urlparse(service_api)
    if where.scheme != "rosrpc" or not where.hostname or not where.port:
        return {}
    try:
        with socket.create_connection((where.hostname, where.port), TIMEOUT) as connection:
            connection.settimeout(TIMEOUT)
            connection.sendall(packed({"probe": "1", "md5sum": "*", "callerid": CALLER, "service": service}))
            return unpacked(block(connection, LONGEST_HEADER))
    except (OSError, struct.error, ValueError):
        return {}


class Subscription:
    """A connection to one publisher: it makes lazy nodes work, and its header says type and MD5 sum.

    ``header`` is empty until the publisher has answered; ``message`` is the first message, once there is one.
    """

    def __init__(self, api: str, topic: str) -> None:
        self.header: Header = {}
        self.message = b""
        self._failed = False
        self._answered = 0.0
        self._connection: Optional[socket.socket] = None
        self._closed = False
        thread = threading.Thread(target=self._run, args=(api, topic))
        thread.daemon = True
        thread.start()

    @property
    def is_settled(self) -> bool:
        """Whether nothing more is to come soon: it has answered, and sent what it has latched, or it does not answer at all."""
        sends_nothing = self.header.get("latching") != "1" or time.monotonic() - self._answered > LATCHED
        return self._failed or bool(self.message) or (bool(self.header) and sends_nothing)

    def _run(self, api: str, topic: str) -> None:
        for attempt in range(ATTEMPTS):
            try:
                self._listen(api, topic)
            except Exception:  # whatever a node answers, it says nothing more, or not now: some are asked before they are ready
                if self._closed or self.header:
                    break
                time.sleep(PAUSE * (attempt + 1))
        self._failed = True

    def _listen(self, api: str, topic: str) -> None:
        answer = xmlrpc.client.ServerProxy(api, transport=Transport()).requestTopic(CALLER, topic, [["TCPROS"]])
        host, port = _address(answer)
        with socket.create_connection((host, port), TIMEOUT) as connection:
            self._connection = connection
            connection.settimeout(TIMEOUT)
            connection.sendall(packed({"callerid": CALLER, "topic": topic, "type": "*", "md5sum": "*", "tcp_nodelay": "1"}))
            header = unpacked(block(connection, LONGEST_HEADER))
            if "error" in header:
                raise OSError(header["error"])
            self._answered = time.monotonic()
            self.header = header
            connection.settimeout(None)
            while not self._closed:
                message = block(connection, LONGEST_MESSAGE)
                self.message = self.message or message

    def close(self) -> None:
        """Hang up."""
        self._closed = True
        if self._connection is not None:
            try:
                self._connection.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            self._connection.close()


class Transport(xmlrpc.client.Transport):
    """Calls that do not wait for ever."""

    def make_connection(self, host: Any) -> Any:
        """As usual, with a time limit."""
        connection = super().make_connection(host)
        connection.timeout = TIMEOUT
        return connection


def _address(answer: Any) -> Tuple[str, int]:
    """Host and port of a ``requestTopic`` answer."""
    code, _, protocol = answer
    if code != 1 or not isinstance(protocol, list) or len(protocol) < 3 or protocol[0] != "TCPROS":
        raise OSError("it does not talk TCPROS")
    return str(protocol[1]), int(protocol[2])


class _Reader:
    """Reads the fields of a serialised message one after another (little endian, strings and arrays with their length first)."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def number(self, format: str) -> Any:
        value = struct.unpack_from("<" + format, self._data, self._at)[0]
        self._at += struct.calcsize("<" + format)
        return value

    def text(self) -> str:
        length = self.number("I")
        if self._at + length > len(self._data):
            raise struct.error("a string is longer than the message")
        value = self._data[self._at : self._at + length]
        self._at += length
        return value.decode("utf-8", "replace")

    def count(self) -> int:
        length = int(self.number("I"))
        if length > len(self._data):
            raise struct.error("an array is longer than the message")
        return length


def reconfigure_description(message: bytes) -> Dict[str, Dict[str, Any]]:
    """The params of a ``dynamic_reconfigure/ConfigDescription``: name → type, default, min, max. Empty where it cannot be read."""
    try:
        reader = _Reader(message)
        params: Dict[str, Dict[str, Any]] = {}
        for _ in range(reader.count()):
            reader.text(), reader.text()
            for _ in range(reader.count()):
                name, kind = reader.text(), reader.text()
                reader.number("I")
                reader.text(), reader.text()
                params[name] = {"type": kind}
            reader.number("i"), reader.number("i")
        for limit in ("max", "min", "default"):
            for name, value in _config(reader).items():
                if name in params:
                    params[name][limit] = value
        return params
    except struct.error:
        return {}


def _config(reader: _Reader) -> Dict[str, Any]:
    """A ``dynamic_reconfigure/Config``: its values by name."""
    values: Dict[str, Any] = {}
    for read in (lambda: bool(reader.number("B")), lambda: reader.number("i"), reader.text, lambda: reader.number("d")):
        for _ in range(reader.count()):
            name = reader.text()
            values[name] = read()
    for _ in range(reader.count()):
        reader.text(), reader.number("B"), reader.number("i"), reader.number("i")
    return values
