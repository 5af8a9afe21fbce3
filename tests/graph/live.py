"""Start a launch file for real, on loopback only, and read the graph that its nodes make.

The nodes are those of Debian's packages and the few of ``live_ws``. Each launch file gets a master of its own on a free port, and is ended
by killing every process that carries its mark in the environment: roslaunch puts each node into a session of its own, so no group holds all.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
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
PACKAGES = """
actionlib diagnostic_aggregator image_proc image_rotate image_transport joint_state_publisher nodelet opencv_apps robot_state_publisher
rosbag rostopic stereo_image_proc tf tf2_ros topic_tools
""".split()
"""The packages with nodes that the launch files use."""
APT = """
image-transport-tools joint-state-publisher libdiagnostic-aggregator-tools libimage-proc-dev libnodeletlib-tools libopencv-apps-dev
libimage-rotate-dev libstereo-image-proc-dev python3-actionlib python3-rosbag python3-rostopic python3-std-srvs ros-image-proc ros-image-rotate ros-opencv-apps
ros-robot-state-publisher ros-stereo-image-proc rosout tf-tools tf2-tools topic-tools
""".split()
"""The Debian packages that have them."""
IGNORED = re.compile(r"/rosout|/rosout_agg|.*/get_loggers|.*/set_logger_level")
"""What every node has."""
ANONYMOUS = re.compile(rf"_{re.sub('[.:-]', '_', socket.gethostname())}_[0-9]+_[0-9]+|_anon[0-9]+")
"""What makes a name anonymous: the host, the process and a random number (rosgraph.names.anonymous_name), or launchlint's own count."""
QUIET, PATIENCE, LIMIT = 1.5, 6.0, 40.0
"""Seconds without a change after which a graph is what it will be: where all that is expected is there, where not; and at the longest."""

Edge = tuple[str, str, str]
"""Role (publisher, subscriber, server), name on the graph, full name of the process."""


class Live(NamedTuple):
    """A live graph: ``types`` of topics and services by role kind and name; ``log`` is what roslaunch and the nodes wrote."""

    edges: frozenset[Edge]
    types: dict[tuple[str, str], str]
    log: str


def missing() -> str:
    """Why no launch file can be started here, for people; empty where all that is needed is there."""
    lost = [name for name in PACKAGES if not (LIBRARIES / name).is_dir() and not (SHARE / name).is_dir()]
    if shutil.which("roslaunch", path="/usr/bin") is None:
        lost.insert(0, "roslaunch")
    return f"not installed: {' '.join(lost)} (Debian: apt-get install --no-install-recommends {' '.join(APT)})" if lost else ""


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
    for name in PACKAGES:
        if (SHARE / name / "package.xml").exists():
            continue
        (overlay / name).mkdir(parents=True, exist_ok=True)
        (overlay / name / "package.xml").write_text(f"<package><name>{name}</name><version>1.0.0</version></package>", encoding="utf-8")
        for executable in sorted((LIBRARIES / name).iterdir()) if (LIBRARIES / name).is_dir() else ():
            link = overlay / name / executable.name
            if not link.is_symlink():
                link.symlink_to(executable)
    return overlay


def free_port() -> int:
    """A port of loopback that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextlib.contextmanager
def started(command: Callable[[int], list[str]], scratch: Path) -> Iterator[tuple[xmlrpc.client.ServerProxy, subprocess.Popen[bytes], Path]]:
    """Run a command that gets the port of its master; at the end nothing of it is left, whatever happens."""
    scratch.mkdir(parents=True, exist_ok=True)
    port, mark, log = free_port(), uuid.uuid4().hex, scratch / "output.txt"
    with open(log, "wb") as output:
        process = subprocess.Popen(
            command(port),
            env=environment(scratch, mark, port),
            cwd=scratch,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    try:
        yield xmlrpc.client.ServerProxy(f"http://127.0.0.1:{port}"), process, log
    finally:
        _kill(process, mark)


def _kill(process: subprocess.Popen[bytes], mark: str) -> None:
    process.kill()  # first, so that it starts no node anew
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


def run(launch: Path, arguments: dict[str, str], scratch: Path, expected: frozenset[Edge], packages: Path | None = None) -> Live:
    """Start ``launch`` and wait until its graph no longer changes; ``expected`` is what to wait for."""
    words = [f"{name}:={value}" for name, value in arguments.items()]
    with started(lambda port: ["/usr/bin/roslaunch", "-p", str(port), str(launch), *words], scratch) as (master, process, log):
        edges = settle(master, process, expected)
        topics: Any = _answer(master.getTopicTypes("/launchlint")) if edges else []
        types = {("topic", plain(name)): kind for name, kind in topics if not IGNORED.fullmatch(name)}
        for role, name, _ in edges:
            if role == "server":
                types["service", name] = service_type(str(_answer(master.lookupService("/launchlint", name))), name)
        return Live(edges, types, log.read_text(encoding="utf-8", errors="replace"))


def settle(master: xmlrpc.client.ServerProxy, process: subprocess.Popen[bytes], expected: frozenset[Edge]) -> frozenset[Edge]:
    """The graph once it does not change any more."""
    start = changed = time.monotonic()
    edges: frozenset[Edge] = frozenset()
    while (now := time.monotonic()) - start < LIMIT and process.poll() is None:
        with contextlib.suppress(OSError, xmlrpc.client.Error):
            found = state(master)
            if found != edges:
                edges, changed = found, now
        if edges and now - changed > (QUIET if expected <= edges else PATIENCE):
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


def plain(name: str) -> str:
    """``name`` with the random parts that roslaunch or launchlint gives to anonymous names left out."""
    return ANONYMOUS.sub("_anon", name)


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
