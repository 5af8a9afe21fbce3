"""The Docker engine: an image built, a container run within bounds, and nothing left behind.

Everything goes over the engine's API, so an engine on another machine (``DOCKER_HOST``) works the same: no directory of this machine is
mounted.
"""

from __future__ import annotations

import io
import tarfile
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager

from launchlint.errors import LaunchlintError, UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.probe.configuration import Limits
from launchlint.probe.words import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO, Any

LABEL = "launchlint.probe"
"""Marks every image, container and volume of the probe; its value is the id of the run."""
REPOSITORY = "launchlint-probe"
USER = "launchlint"
ENGINE_SECONDS = 120
"""An engine that does not answer a question for so long is given up."""
BUILD_MEMORY = 8 * 2**30
"""Bytes that the building of packages may take at least: compilers want more than nodes."""
BUILD_SECONDS = 6 * 3600
"""So is one whose build says nothing for so long."""
LOG_LINES = 60
"""Lines of a failed build that are shown."""
LAST_WORDS = 300
"""Bytes of a container's standard error that are kept."""


class BuildError(LaunchlintError):
    """The image cannot be built. ``lines`` are what the build said last."""

    def __init__(self, message: str, lines: list[str]) -> None:
        super().__init__(message)
        self.lines = lines


class Image(NamedTuple):
    """A built image: its id, and what it is called."""

    id: str
    tag: str


class Engine:
    """A connection to a Docker engine. ``run`` is the id that everything made here is labelled with."""

    def __init__(self, client: Any, run: str) -> None:
        self._client = client
        self.run = run

    def build(self, context: IO[bytes], tag: str, base: str, network: str, limits: Limits, tell: Callable[[str], None]) -> Image:
        """Build the image.

        Twice over the same archive: first, with a network, up to what the packages need; then the rest, which is other people's code,
        without one. The second build finds all layers of the first one in the cache.

        Args:
            context: the archive that :func:`launchlint.probe.context.write_context` wrote.
            tag: what the image is called, besides its repository.
            base: the image to build upon.
            network: of the first build: ``default`` or ``host``.
            limits: for the time and memory of building a package.
            tell: is called with each line that the build prints.

        Raises:
            BuildError: a step fails.
            UsageError: the engine does not answer as it should.
        """
        name = f"{REPOSITORY}:{tag}"
        with _spoken():
            self._build(context, f"{name}-dependencies", "dependencies", base, None if network == "default" else network, None, tell)
            return Image(self._build(context, name, "workspace", base, "none", limits, tell), name)

    def _build(
        self, context: IO[bytes], name: str, target: str, base: str, network: str | None, limits: Limits | None, tell: Callable[[str], None]
    ) -> str:
        context.seek(0)
        events = self._client.api.build(
            fileobj=context,
            custom_context=True,
            encoding=None,
            tag=name,
            target=target,
            buildargs={"BASE": base, **({"BUILD_LIMIT": f"{limits.build:.0f}"} if limits else {})},
            labels={LABEL: "image"},
            network_mode=network,
            timeout=BUILD_SECONDS,
            rm=True,
            forcerm=True,
            decode=True,
            container_limits={"memory": max(limits.bytes, BUILD_MEMORY)} if limits else None,
        )
        last: list[str] = []
        for event in events:
            error = event.get("error")
            if error:
                raise BuildError(f"the image cannot be built: {plain(str(error))}", last)
            for line in str(event.get("stream") or event.get("status") or "")[:100_000].splitlines():
                text = plain(line)
                if text:
                    last.append(text)
                    del last[:-LOG_LINES]
                    tell(text)
        return str(self._client.images.get(name).id)

    @contextmanager
    def container(self, image: Image, job: bytes, limits: Limits) -> Iterator[Container]:
        """A container of ``image`` with ``job`` in it, not started; gone, with all its processes, when the block ends, however it ends."""
        volume = container = None
        try:
            with _spoken():
                volume = self._client.volumes.create(labels={LABEL: self.run})
                container = self._client.containers.create(image.id, **_bounds(limits, volume.name, self.run))
                container.put_archive("/job", _archive(job))
            yield Container(container)
        finally:
            self.clean()

    def clean(self) -> None:
        """Remove every container and volume of this run: by label, so that also what an interruption left half made goes."""
        import docker
        import requests

        with _undisturbed():
            for _ in range(3):
                try:
                    for container in self._client.containers.list(all=True, filters={"label": f"{LABEL}={self.run}"}):
                        container.remove(force=True, v=True)
                    for volume in self._client.volumes.list(filters={"label": f"{LABEL}={self.run}"}):
                        volume.remove(force=True)
                    return
                except (docker.errors.DockerException, requests.exceptions.RequestException, OSError):  # noqa: PERF203 (tried again)
                    continue

    def close(self) -> None:
        """Clean up and hang up."""
        self.clean()
        self._client.close()


class Container:
    """A container that has been created."""

    def __init__(self, container: Any) -> None:
        self._container = container
        self._words = b""
        self._stream: Any = None
        self.timed_out = False

    def output(self, seconds: float) -> Iterator[bytes]:
        """Start it; its standard output as it comes. After ``seconds`` it is killed, and ``timed_out`` says so."""
        with _spoken():
            self._stream = stream = self._container.attach(stdout=True, stderr=True, stream=True, logs=False, demux=True)
            timer = threading.Timer(seconds, self._expire)
            timer.daemon = True
            timer.start()
            try:
                self._container.start()
                for said, complained in stream:
                    if complained:
                        self._words = (self._words + complained)[-LAST_WORDS:]
                    if said:
                        yield said
            finally:
                timer.cancel()
                self._hang_up()

    def _hang_up(self) -> None:
        """Stop listening: the engine cannot end a container whose output nobody takes and nobody refuses."""
        try:
            if self._stream is not None:
                self._stream.close()
        except (OSError, ValueError):  # it has been closed already
            return

    def _expire(self) -> None:
        self.timed_out = True
        self.kill()

    def kill(self) -> None:
        """End it at once."""
        import docker
        import requests

        self._hang_up()
        try:
            self._container.kill()
        except (docker.errors.DockerException, requests.exceptions.RequestException, OSError):
            return

    def last_words(self) -> str:
        """What it wrote to its standard error last."""
        return plain(self._words.decode("utf-8", "replace"))

    def died_of_memory(self) -> bool:
        """Whether the kernel ended it because it wanted more memory than it may have."""
        with _spoken():
            self._container.reload()
            return bool(self._container.attrs.get("State", {}).get("OOMKilled"))


@contextmanager
def _undisturbed() -> Iterator[None]:
    """A second Ctrl-C does not stop the cleaning up after the first."""
    import signal

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def connect(run: str) -> Engine:
    """The engine that ``DOCKER_HOST`` names, else this machine's.

    Raises:
        UsageError: there is none, or it does not let us in; the message says what to do.
    """
    try:
        import docker
    except ImportError:
        raise UsageError(
            "the Python package docker is missing: install it (pip install docker), or probe the ROS of this machine with --local"
        ) from None
    with _spoken():
        client = docker.from_env(timeout=ENGINE_SECONDS)
        client.ping()
    return Engine(client, run)


@contextmanager
def _spoken() -> Iterator[None]:
    """Errors of the SDK as one clear message each."""
    import docker
    import requests

    try:
        yield
    except docker.errors.ImageNotFound as error:
        raise UsageError(f"Docker has no such image: {plain(str(error.explanation))}") from None
    except docker.errors.APIError as error:
        raise UsageError(f"Docker refuses: {plain(str(error.explanation or error))}") from None
    except (docker.errors.DockerException, requests.exceptions.RequestException) as error:
        raise UsageError(_why(error)) from None


def _why(error: BaseException) -> str:
    """Why there is no engine to talk to, and what to do."""
    import os

    where = os.environ.get("DOCKER_HOST", "")
    place = f"DOCKER_HOST={plain(where)}" if where else "/var/run/docker.sock"
    local = "or probe the ROS of this machine with --local"
    causes = list(_causes(error))
    if any(isinstance(cause, PermissionError) for cause in causes):
        advice = "add the user to the group docker and log in again, or use rootless Docker"
        return f"Docker does not let this user in ({place}): {advice}, {local}"
    if any(isinstance(cause, FileNotFoundError) for cause in causes):
        advice = "install and start Docker, or name another engine by DOCKER_HOST"
        return f"there is no Docker engine here ({place} does not exist): {advice}, {local}"
    if any(isinstance(cause, (ConnectionRefusedError, ConnectionResetError)) for cause in causes):
        return f"no Docker engine answers ({place}): start it (sudo systemctl start docker), {local}"
    return f"the Docker engine cannot be used ({place}): {plain(str(error))}; check it with `docker version`, {local}"


def _causes(error: BaseException | None) -> Iterator[BaseException]:
    """An error and all that led to it, also what urllib3 keeps in the arguments of its errors."""
    waiting: list[object] = [error]
    for _ in range(50):
        if not waiting:
            return
        cause = waiting.pop(0)
        if isinstance(cause, BaseException):
            yield cause
            waiting += [cause.__cause__, cause.__context__, getattr(cause, "reason", None), *cause.args]


def _bounds(limits: Limits, volume: str, run: str) -> Mapping[str, Any]:
    """How a container is locked in: no network, nothing to write but memory, no privileges, bounded memory and processes, no log on
    disk.
    """
    memory = limits.bytes
    return {
        "labels": {LABEL: run},
        "network_mode": "none",
        "read_only": True,
        "tmpfs": {"/tmp": f"rw,nosuid,nodev,exec,size={memory // 2},mode=1777", "/run": "rw,nosuid,nodev,size=16m,mode=1777"},
        "volumes": {volume: {"bind": "/job", "mode": "rw"}},
        "user": USER,
        "cap_drop": ["ALL"],
        "security_opt": ["no-new-privileges"],
        "pids_limit": limits.pids,
        "mem_limit": memory,
        "memswap_limit": memory,
        "shm_size": "64m",
        "ipc_mode": "private",
        "stdin_open": False,
        "tty": False,
        "log_config": {"Type": "none", "Config": {}},
        "stop_signal": "SIGKILL",
        "detach": True,
    }


def _archive(job: bytes) -> bytes:
    file = io.BytesIO()
    with tarfile.open(fileobj=file, mode="w") as archive:
        info = tarfile.TarInfo("job.json")
        info.size, info.mode = len(job), 0o644
        archive.addfile(info, io.BytesIO(job))
    return file.getvalue()
