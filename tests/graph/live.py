"""Start a launch file for real, on loopback only, and read the graph that its nodes make.

The nodes are those of Debian's packages and the few of ``live_ws``. Each launch file gets a master of its own on a free port, and is ended
by killing every process that carries its mark in the environment: roslaunch puts each node into a session of its own, no group holds all.
"""

from __future__ import annotations

import contextlib
import http.client
import os
import re
import signal
import socket
import struct
import subprocess
import time
import uuid
import xmlrpc.client
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).resolve().parent
OWN_NODES = HERE / "live_ws"
SHARE, LIBRARIES = Path("/usr/share"), Path("/usr/lib")
DEBIAN = {
    "image-transport-tools": "lib/image_transport/republish",
    "joint-state-publisher": "lib/joint_state_publisher/joint_state_publisher",
    "libdiagnostic-aggregator-tools": "lib/diagnostic_aggregator/aggregator_node",
    "libimage-proc-dev": "share/image_proc/nodelet_plugins.xml",
    "libimage-rotate-dev": "share/image_rotate/nodelet_plugins.xml",
    "libnodeletlib-tools": "lib/nodelet/nodelet",
    "libopencv-apps-dev": "share/opencv_apps/nodelet_plugins.xml",
    "libstereo-image-proc-dev": "share/stereo_image_proc/nodelet_plugins.xml",
    "python3-actionlib": "lib/python3/dist-packages/actionlib",
    "python3-rosbag": "lib/rosbag/record",
    "python3-roslaunch": "bin/roslaunch",
    "python3-rostopic": "lib/rostopic/rostopic",
    "python3-rospy": "lib/python3/dist-packages/rospy",
    "python3-std-srvs": "lib/python3/dist-packages/std_srvs",
    "ros-image-proc": "lib/image_proc/image_proc",
    "ros-image-rotate": "lib/image_rotate/image_rotate",
    "ros-opencv-apps": "lib/opencv_apps/smoothing",
    "ros-robot-state-publisher": "lib/robot_state_publisher/robot_state_publisher",
    "ros-stereo-image-proc": "lib/stereo_image_proc/stereo_image_proc",
    "rosout": "lib/rosout/rosout",
    "tf-tools": "lib/tf/static_transform_publisher",
    "tf2-tools": "lib/tf2_ros/buffer_server",
    "topic-tools": "lib/topic_tools/mux",
}
"""The Debian packages whose nodes the launch files start, and what of each must be there below ``/usr``."""
IGNORED = re.compile(r"/rosout|/rosout_agg|.*/get_loggers|.*/set_logger_level")
"""What every node has."""
ANONYMOUS = re.compile(rf"_{re.sub('[.:-]', '_', socket.gethostname())}_[0-9]+_[0-9]+|_anon[0-9]+")
"""What makes a name anonymous: the host, the process and a random number (rosgraph.names.anonymous_name), or launchlint's own count."""
QUIET, PATIENCE, LIMIT = 1.5, 6.0, 40.0
"""Seconds without a change after which a graph is what it will be: where all that is expected is there, where not; and at the longest."""

Edge = tuple[str, str, str]
"""Role (publisher, subscriber, server), name on the graph, full name of the process."""


class Running(NamedTuple):
    """What was started: its master, its first process, and the file that all of it writes to."""

    master: xmlrpc.client.ServerProxy
    process: subprocess.Popen[bytes]
    log: Path
    environment: dict[str, str]
    more: list[subprocess.Popen[bytes]]

    def start(self, command: list[str], variables: dict[str, str]) -> None:
        """Start one more process with the same master and the same end."""
        self.more.append(_start(command, {**self.environment, **variables}, self.log))


class Live(NamedTuple):
    """A live graph: ``types`` of topics and services by role kind and name; ``log`` is what roslaunch and the nodes wrote."""

    edges: frozenset[Edge]
    types: dict[tuple[str, str], str]
    log: str


def missing() -> str:
    """Why no launch file can be started here, for people; empty where all that is needed is there."""
    lost = [package for package, path in DEBIAN.items() if not Path("/usr", path).exists()]
    return f"some nodes are not installed (Debian: apt-get install --no-install-recommends {' '.join(lost)})" if lost else ""


def environment(scratch: Path, mark: str, port: int) -> dict[str, str]:
    """The environment of roslaunch: nothing but what is needed, ``mark`` to know its processes by."""
    return {
        "PATH": "/usr/bin:/bin",
        "HOME": str(scratch),
        "LANG": "C.UTF-8",
        "ROS_PACKAGE_PATH": os.pathsep.join(map(str, (OWN_NODES, _overlay(scratch), SHARE))),
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_IP": "127.0.0.1",
        "ROS_HOME": str(scratch / "home"),
        "ROS_LOG_DIR": str(scratch / "log"),
        "PYTHONDONTWRITEBYTECODE": "1",
        "LAUNCHLINT_LIVE": mark,
    }


def _overlay(scratch: Path) -> Path:
    """Manifests for the packages that Debian ships without: their executables are linked beside them, where roslaunch looks."""
    overlay = scratch / "overlay"
    for executable in sorted(Path("/usr", path) for path in DEBIAN.values() if path.count("/") == 2):
        directory, name = executable.parent, executable.parent.name
        if directory.parent == LIBRARIES and not (SHARE / name / "package.xml").exists() and not (overlay / name).exists():
            (overlay / name).mkdir(parents=True)
            (overlay / name / "package.xml").write_text(f"<package><name>{name}</name><version>1.0.0</version></package>", encoding="utf-8")
            for each in directory.iterdir():
                (overlay / name / each.name).symlink_to(each)
    return overlay


def free_port() -> int:
    """A port of loopback that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextlib.contextmanager
def started(command: Callable[[int], list[str]], scratch: Path) -> Iterator[Running]:
    """Run a command that gets the port of its master; at the end nothing of it is left, whatever happens."""
    scratch.mkdir(parents=True, exist_ok=True)
    port, mark, log = free_port(), uuid.uuid4().hex, scratch / "output.txt"
    variables = environment(scratch, mark, port)
    processes = [_start(command(port), variables, log)]
    try:
        with xmlrpc.client.ServerProxy(f"http://127.0.0.1:{port}") as master:
            yield Running(master, processes[0], log, variables, processes)
    finally:
        _kill(processes, mark)


def _start(command: list[str], variables: dict[str, str], log: Path) -> subprocess.Popen[bytes]:
    with open(log, "ab") as output:
        return subprocess.Popen(
            command,
            env=variables,
            cwd=log.parent,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )


def _kill(processes: list[subprocess.Popen[bytes]], mark: str) -> None:
    for process in processes:
        process.kill()  # roslaunch before its nodes, so that it starts none anew
        process.wait()
    deadline = time.monotonic() + 10
    while (alive := list(_marked(mark))) and time.monotonic() < deadline:
        for each in alive:
            with contextlib.suppress(ProcessLookupError):
                os.kill(each, signal.SIGKILL)
        time.sleep(0.02)


def _marked(mark: str) -> Iterator[int]:
    """The processes whose environment carries ``mark``."""
    wanted = f"LAUNCHLINT_LIVE={mark}".encode()
    for entry in os.scandir("/proc"):
        if entry.name.isdecimal():
            with contextlib.suppress(OSError):
                if wanted in Path(entry.path, "environ").read_bytes().split(b"\0"):
                    yield int(entry.name)


def run(launch: Path, scratch: Path, is_complete: Callable[[frozenset[Edge]], bool]) -> Live:
    """Start ``launch`` and wait until its graph no longer changes; ``is_complete`` says of a graph whether it has all that is expected."""
    with started(lambda port: ["/usr/bin/roslaunch", "-p", str(port), str(launch)], scratch) as running:
        edges = settle(running, is_complete)
        return Live(edges, types_of(running.master) if edges else {}, running.log.read_text(encoding="utf-8", errors="replace"))


def settle(running: Running, is_complete: Callable[[frozenset[Edge]], bool]) -> frozenset[Edge]:
    """The graph once it does not change any more."""
    start = changed = time.monotonic()
    edges: frozenset[Edge] = frozenset()
    while (now := time.monotonic()) - start < LIMIT and running.process.poll() is None:
        found = state_or_nothing(running.master)
        if found != edges:
            edges, changed = found, now
        if edges and now - changed > (QUIET if is_complete(edges) else PATIENCE):
            break
        time.sleep(0.1)
    return edges


def state(master: xmlrpc.client.ServerProxy) -> frozenset[Edge]:
    """What the master knows now."""
    answer: Any = _answer(master.getSystemState("/launchlint"))
    return frozenset(
        (role, plain(name), plain(node))
        for role, listed in zip(("publisher", "subscriber", "server"), answer, strict=True)
        for name, nodes in listed
        for node in nodes
        if not IGNORED.fullmatch(name)
    )


def state_or_nothing(master: xmlrpc.client.ServerProxy) -> frozenset[Edge]:
    """What the master knows now; nothing where it does not answer yet."""
    try:
        return state(master)
    except (OSError, http.client.HTTPException, xmlrpc.client.Error):
        return frozenset()


def plain(name: str) -> str:
    """``name`` with the random parts that roslaunch or launchlint gives to anonymous names left out."""
    return ANONYMOUS.sub("_anon", name)


def types_of(master: xmlrpc.client.ServerProxy) -> dict[tuple[str, str], str]:
    """The types of topics, as the master has them from whoever said one first, and of services, as their servers say."""
    topics: Any = _answer(master.getTopicTypes("/launchlint"))
    types = {("topic", plain(name)): kind for name, kind in topics}
    services: Any = _answer(master.getSystemState("/launchlint"))
    for name, _ in services[2]:
        if not IGNORED.fullmatch(name):
            types["service", plain(name)] = service_type(str(_answer(master.lookupService("/launchlint", name))), name)
    return types


def _answer(reply: Any) -> Any:
    code, message, value = reply
    if code != 1:
        raise OSError(message)
    return value


def service_type(uri: str, name: str) -> str:
    """The type of a service, asked of its server (the header of a connection that only probes)."""
    host, port = uri.removeprefix("rosrpc://").split(":")
    fields = [f"{key}={value}".encode() for key, value in {"probe": "1", "md5sum": "*", "callerid": "/launchlint", "service": name}.items()]
    header = b"".join(struct.pack("<I", len(field)) + field for field in fields)
    with socket.create_connection((host, int(port.rstrip("/"))), timeout=5) as connection:
        connection.sendall(struct.pack("<I", len(header)) + header)
        (length,) = struct.unpack("<I", _exactly(connection, 4))
        answer = _exactly(connection, length)
    while answer:
        (size,) = struct.unpack("<I", answer[:4])
        key, _, value = answer[4 : 4 + size].partition(b"=")
        if key == b"type":
            return value.decode()
        answer = answer[4 + size :]
    return ""


def _exactly(connection: socket.socket, size: int) -> bytes:
    data = b""
    while len(data) < size:
        more = connection.recv(size - len(data))
        if not more:
            raise OSError("the connection was closed")
        data += more
    return data
