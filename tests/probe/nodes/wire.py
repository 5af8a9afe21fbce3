"""A ROS node in a few lines, without ROS: it speaks to the master over XML-RPC and to other nodes over TCPROS, as rospy does. For programs
that shall do one odd thing.
"""

import os
import socket
import struct
import sys
import threading
import xmlrpc.client
from urllib.parse import urlparse
from xmlrpc.server import SimpleXMLRPCServer


class Node:
    def __init__(self):
        names = dict(word.split(":=", 1) for word in sys.argv if ":=" in word)
        self.namespace = os.environ.get("ROS_NAMESPACE", "/")
        self.name = "{}/{}".format(self.namespace.rstrip("/"), names.get("__name", "node"))
        self.master = xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"])
        self._heard = {}
        self._listener = socket.socket()
        self._listener.bind(("127.0.0.1", 0))
        self._listener.listen(8)
        self._server = SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False, allow_none=True)
        self._server.register_function(self._update, "publisherUpdate")
        self._server.register_function(lambda *words: [1, "", ["TCPROS", *self._listener.getsockname()]], "requestTopic")
        self.api = "http://127.0.0.1:{}/".format(self._server.server_address[1])
        self.publishers = {}
        in_background(self._server.serve_forever)
        in_background(self._accept)

    def resolve(self, name):
        if name.startswith("/"):
            return name
        if name.startswith("~"):
            return "{}/{}".format(self.name, name[1:])
        return "{}/{}".format(self.namespace.rstrip("/"), name)

    def publish(self, name, kind="std_msgs/String", message=None):
        """``message``, if any, is sent to everybody who subscribes."""
        self.publishers[self.resolve(name)] = (kind, message)
        self.master.registerPublisher(self.name, self.resolve(name), kind, self.api)

    def subscribe(self, name, kind="std_msgs/String", call=lambda message: None):
        self._heard[self.resolve(name)] = (kind, call)
        publishers = self.master.registerSubscriber(self.name, self.resolve(name), kind, self.api)[2]
        self._update("", self.resolve(name), publishers)

    def wait_for_message(self, name, kind="std_msgs/String"):
        came = threading.Event()
        found = []
        self.subscribe(name, kind, lambda message: (found.append(message), came.set()))
        came.wait()
        return found[0]

    def find_service(self, name):
        return self.master.lookupService(self.name, self.resolve(name))

    def call(self, name, md5):
        """The answer of a service to an empty request; None where it refuses."""
        where = urlparse(self.find_service(name)[2])
        with socket.create_connection((where.hostname, where.port)) as connection:
            connection.sendall(header(service=self.resolve(name), md5sum=md5, callerid=self.name))
            block(connection)
            connection.sendall(struct.pack("<I", 0))
            good = exactly(connection, 1) == b"\1"
            answer = block(connection)
            return answer if good else None

    def param(self, name):
        return self.master.getParam(self.name, self.resolve(name))

    def _update(self, caller, topic, publishers):
        for api in publishers:
            in_background(self._listen, api, topic)
        return [1, "", 0]

    def _listen(self, api, topic):
        kind, call = self._heard[topic]
        _, host, port = xmlrpc.client.ServerProxy(api).requestTopic(self.name, topic, [["TCPROS"]])[2]
        with socket.create_connection((host, port)) as connection:
            connection.sendall(header(callerid=self.name, topic=topic, type=kind, md5sum="*"))
            block(connection)
            while True:
                call(block(connection))

    def _accept(self):
        while True:
            in_background(self._send, self._listener.accept()[0])

    def _send(self, connection):
        asked = dict(line.split("=", 1) for line in lines(block(connection)))
        kind, message = self.publishers[asked["topic"]]
        connection.sendall(header(callerid=self.name, topic=asked["topic"], type=kind, md5sum="*", latching="0"))
        if message is not None:
            connection.sendall(struct.pack("<I", len(message)) + message)
        connection.recv(1)


def header(**fields):
    body = b"".join(struct.pack("<I", len(key) + len(value) + 1) + "{}={}".format(key, value).encode() for key, value in fields.items())
    return struct.pack("<I", len(body)) + body


def lines(body):
    while body:
        length = struct.unpack("<I", body[:4])[0]
        yield body[4 : 4 + length].decode()
        body = body[4 + length :]


def exactly(connection, length):
    data = b""
    while len(data) < length:
        part = connection.recv(length - len(data))
        if not part:
            raise EOFError
        data += part
    return data


def block(connection):
    return exactly(connection, struct.unpack("<I", exactly(connection, 4))[0])


def in_background(function, *words):
    def run():
        try:
            function(*words)
        except Exception:
            pass

    thread = threading.Thread(target=run)
    thread.daemon = True
    thread.start()


def spin():
    threading.Event().wait()
