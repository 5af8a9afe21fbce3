"""What is said where there is no Docker engine to talk to, and what a lost container costs."""

from __future__ import annotations

import gc
import io
import json
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from launchlint.errors import UsageError
from launchlint.probe import engine
from launchlint.probe.configuration import Limits, ProbeConfiguration
from launchlint.probe.journal import Journal
from launchlint.probe.run import _Collector, job_of

# A client of the SDK that found no engine leaves its socket to the garbage collector.
pytestmark = pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")


@pytest.fixture(autouse=True)
def _collect_in_time() -> Iterator[None]:
    yield
    gc.collect()


LOCAL = "or probe the ROS of this machine with --local"


def why(monkeypatch: pytest.MonkeyPatch, host: str) -> str:
    monkeypatch.setenv("DOCKER_HOST", host)
    with pytest.raises(UsageError) as caught:
        engine.connect("run")
    return str(caught.value)


def test_no_engine(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    host = f"unix://{tmp_path}/docker.sock"
    assert why(monkeypatch, host) == (
        f"there is no Docker engine here (DOCKER_HOST={host} does not exist): install and start Docker, "
        f"or name another engine by DOCKER_HOST, {LOCAL}"
    )


def test_an_engine_that_does_not_answer(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    path = tmp_path / "docker.sock"
    with socket.socket(socket.AF_UNIX) as sock:
        sock.bind(str(path))
    host = f"unix://{path}"
    assert why(monkeypatch, host) == f"no Docker engine answers (DOCKER_HOST={host}): start it (sudo systemctl start docker), {LOCAL}"


def test_an_engine_that_does_not_let_us_in(monkeypatch: pytest.MonkeyPatch) -> None:
    import docker

    def refuse(**_: Any) -> None:
        try:
            raise ConnectionError("('Connection aborted.', ...)", PermissionError(13, "Permission denied"))
        except ConnectionError as error:
            raise docker.errors.DockerException("Error while fetching server API version") from error

    monkeypatch.setattr(docker, "from_env", refuse)
    monkeypatch.delenv("DOCKER_HOST", raising=False)
    with pytest.raises(UsageError) as caught:
        engine.connect("run")
    assert str(caught.value) == (
        "Docker does not let this user in (/var/run/docker.sock): add the user to the group docker and log in again, "
        f"or use rootless Docker, {LOCAL}"
    )


def test_something_else_that_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    said = why(monkeypatch, "nonsense://x")
    assert said.startswith("the Docker engine cannot be used (DOCKER_HOST=nonsense://x): ")
    assert said.endswith(f"; check it with `docker version`, {LOCAL}")


def test_no_docker_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "docker", None)
    with pytest.raises(UsageError, match=r"^the Python package docker is missing: install it \(pip install docker\)"):
        engine.connect("run")


def test_the_command_says_it_in_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DOCKER_HOST", f"unix://{tmp_path}/docker.sock")
    (tmp_path / "probe.yaml").write_text("")
    words = [sys.executable, "-m", "launchlint", "probe", str(tmp_path / "probe.yaml"), "-o", str(tmp_path / "library.json")]
    done = subprocess.run(words, capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith("launchlint: there is no Docker engine here")


def test_a_container_is_locked_in() -> None:
    assert engine._bounds(Limits(memory="512m", pids=99), "volume", "run") == {
        "labels": {"launchlint.probe": "run"},
        "network_mode": "none",
        "read_only": True,
        "tmpfs": {"/tmp": f"rw,nosuid,nodev,exec,size={256 * 2**20},mode=1777", "/run": "rw,nosuid,nodev,size=16m,mode=1777"},
        "volumes": {"volume": {"bind": "/job", "mode": "rw"}},
        "user": "launchlint",
        "cap_drop": ["ALL"],
        "security_opt": ["no-new-privileges"],
        "pids_limit": 99,
        "mem_limit": 512 * 2**20,
        "memswap_limit": 512 * 2**20,
        "shm_size": "64m",
        "ipc_mode": "private",
        "stdin_open": False,
        "tty": False,
        "log_config": {"Type": "none", "Config": {}},
        "stop_signal": "SIGKILL",
        "detach": True,
    }


class Builder:
    """Stands for the SDK's client: a build that says what it is told to say."""

    def __init__(self, *events: dict[str, str]) -> None:
        self.events = events
        self.api = self.images = self
        self.id = "built"
        self.builds: list[tuple[str, str | None]] = []

    def build(self, target: str, network_mode: str | None, **_: Any) -> Iterator[dict[str, str]]:
        self.builds.append((target, network_mode))
        yield from self.events

    def get(self, _: str) -> Builder:
        return self


def test_other_peoples_code_is_built_without_a_network() -> None:
    client = Builder()
    engine.Engine(client, "run").build(io.BytesIO(), "tag", "base", "host", Limits(), lambda _: None)
    assert client.builds == [("dependencies", "host"), ("workspace", "none")]


class Complaining:
    """Stands for the SDK's container: one that says its last words on standard error."""

    def attach(self, **_: Any) -> Complaining:
        return self

    def __iter__(self) -> Iterator[tuple[bytes, bytes]]:
        yield b"", b"early " * 1000
        yield b"out", b"\x1b]0;owned\x07\nlast"

    def start(self) -> None:
        """It runs."""

    def close(self) -> None:
        """Nobody listens any more."""


def test_the_last_words_of_a_container_are_bounded_and_harmless(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "LAST_WORDS", 20)
    container = engine.Container(Complaining())
    assert list(container.output(60)) == [b"out"]
    assert container.last_words() == "arly ]0;owned last"


def test_what_a_build_prints_is_made_harmless() -> None:
    said: list[str] = []
    client = Builder(
        {"stream": "Step 1/2 : \x1b]0;owned\x07FROM x\r\nfine\n"},
        {"status": "\u202egnorw"},
        {"stream": "x" * 1000},
        {"error": "it failed\x1b[2J\nhere"},
    )
    with pytest.raises(engine.BuildError) as caught:
        engine.Engine(client, "run").build(io.BytesIO(), "tag", "base", "default", Limits(), said.append)
    assert said == ["Step 1/2 : ]0;owned FROM x", "fine", "gnorw", "x" * 300 + "…"]
    assert (str(caught.value), caught.value.lines) == ("the image cannot be built: it failed [2J here", said)


class Silent:
    def says(self, line: str) -> None:
        """Nothing to see."""

    def moves(self, done: int, total: int, label: str) -> None:
        """Nothing to see."""


class Lost:
    """A program that dies whenever it runs the node ``killer``."""

    timed_out = False

    def __init__(self, job: dict[str, Any]) -> None:
        self.job = job

    def output(self, seconds: float) -> Iterator[bytes]:
        frames = {
            name: {
                "kind": "node",
                "package": "p",
                "name": name,
                "program": "rospy",
                "variant": "default",
                "label": f"p/{name}",
                "hash": 2 * (name.encode().hex() + "00000000"),
            }
            for name in ("a", "killer", "z")
        }
        wanted = [
            frame
            for frame in frames.values()
            if frame["hash"] not in self.job["done"] and frame["hash"] in self.job.get("only", [frame["hash"]])
        ]
        yield json.dumps({"kind": "plan", "count": len(wanted), "all": 3}).encode() + b"\n"
        for frame in wanted:
            yield json.dumps({"kind": "start", "label": frame["label"], "hash": frame["hash"], "frame": frame}).encode() + b"\n"
            if frame["name"] == "killer":
                return
            yield json.dumps({**frame, "status": "ok", "interface": {}, "problems": [], "seconds": 1, "left": []}).encode() + b"\n"
        yield b'{"kind": "end", "left": 0}\n'

    def kill(self) -> None:
        """It is dead."""

    def died_of_memory(self) -> bool:
        return True

    def last_words(self) -> str:
        return ""


def test_the_node_that_takes_the_container_down_is_found_and_the_rest_is_probed(tmp_path: Path) -> None:
    @contextmanager
    def start(data: bytes) -> Iterator[Lost]:
        yield Lost(json.loads(data))

    configuration = ProbeConfiguration()
    journal = Journal(str(tmp_path / "library.json"), resume=False)
    outcome = _Collector(start, job_of(configuration, None), configuration, journal, Silent()).run((), {})
    assert [(record.label, record.status, [tuple(problem) for problem in record.problems]) for record in outcome.records] == [
        ("p/a", "ok", []),
        ("p/killer", "failed", [("broke-the-container", "it wanted more memory than it may have (`memory` in `limits`)")]),
        ("p/z", "ok", []),
    ]
    assert outcome.lost == ""
    journal.close(complete=True)
