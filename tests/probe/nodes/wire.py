"""A ROS node in a few lines, without ROS: it speaks to the master over XML-RPC, as rospy does. For programs that shall do one odd thing."""

import os
import sys
import threading
import xmlrpc.client
from xmlrpc.server import SimpleXMLRPCServer


class Node:
    def __init__(self):
        names = dict(word.split(":=", 1) for word in sys.argv if ":=" in word)
        self.namespace = os.environ.get("ROS_NAMESPACE", "/")
        self.name = "{}/{}".format(self.namespace.rstrip("/"), names.get("__name", "node"))
        self.master = xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"])
        self._server = SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False, allow_none=True)
        self._server.register_function(lambda *words: [1, "", 0], "publisherUpdate")
        self._server.register_function(lambda *words: [0, "no", 0], "requestTopic")
        self.api = "http://127.0.0.1:{}/".format(self._server.server_address[1])
        thread = threading.Thread(target=self._server.serve_forever)
        thread.daemon = True
        thread.start()

    def resolve(self, name):
        if name.startswith("/"):
            return name
        if name.startswith("~"):
            return "{}/{}".format(self.name, name[1:])
        return "{}/{}".format(self.namespace.rstrip("/"), name)

    def publish(self, name, kind="std_msgs/String"):
        self.master.registerPublisher(self.name, self.resolve(name), kind, self.api)

    def subscribe(self, name, kind="std_msgs/String"):
        self.master.registerSubscriber(self.name, self.resolve(name), kind, self.api)

    def find_service(self, name):
        return self.master.lookupService(self.name, self.resolve(name))

    def param(self, name):
        return self.master.getParam(self.name, self.resolve(name))


def spin():
    threading.Event().wait()
