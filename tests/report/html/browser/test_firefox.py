"""The main things in Firefox, which is driven by its own protocol: Playwright knows only builds of its own."""

from __future__ import annotations

import json
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.firefox

PATIENCE = 60
"""Seconds."""


class Firefox:
    """A headless Firefox with one page."""

    def __init__(self, command: str, profile: str) -> None:
        words = [command, "--headless", "--no-remote", "--marionette", "--profile", profile, "--width", "1440", "--height", "900"]
        Path(profile, "user.js").write_text('user_pref("marionette.port", 0);\n')
        self._process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self._socket = socket.create_connection(("127.0.0.1", self._port(Path(profile, "MarionetteActivePort"))), timeout=PATIENCE)
        self._read()
        self._number = 0
        self.ask("WebDriver:NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": False}})

    @staticmethod
    def _port(file: Path) -> int:
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if file.is_file() and (text := file.read_text().strip()):
                return int(text)
            time.sleep(0.1)
        raise TimeoutError("Firefox does not say where it listens")

    def _read(self) -> Any:
        length = b""
        while (byte := self._socket.recv(1)) != b":":
            length += byte
        text = b""
        while len(text) < int(length):
            text += self._socket.recv(int(length) - len(text))
        return json.loads(text)

    def ask(self, command: str, **parameters: object) -> Any:
        self._number += 1
        text = json.dumps([0, self._number, command, parameters]).encode()
        self._socket.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self._read()
        assert error is None, error
        return result

    def run(self, script: str) -> Any:
        return self.ask("WebDriver:ExecuteScript", script=script, args=[])["value"]

    def until(self, script: str) -> Any:
        """What a script gives, once it gives something."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if found := self.run(script):
                return found
            time.sleep(0.1)
        raise AssertionError(script)

    def open(self, url: str) -> None:
        self.ask("WebDriver:Navigate", url=url)
        self.until("return document.getElementById('drawing')?.getAttribute('aria-busy') === 'false'")

    def close(self) -> None:
        self._socket.close()
        self._process.terminate()
        self._process.wait(PATIENCE)


@pytest.fixture
def firefox() -> Iterator[Firefox]:
    command = shutil.which("firefox-esr") or shutil.which("firefox")
    assert command is not None
    with tempfile.TemporaryDirectory() as profile:
        started = Firefox(command, profile)
        yield started
        started.close()


def test_the_main_things(firefox: Firefox, reports: Callable[[str], Path]) -> None:
    page = reports("robot").as_uri()
    firefox.open(f"{page}#")
    assert firefox.until("return document.querySelectorAll('#landing .card').length") == 2

    firefox.open(f"{page}#entry=robot.launch")
    assert firefox.until("return document.querySelectorAll('#drawing > svg .box').length") > 5
    node = firefox.run("return document.querySelector('#drawing > svg .box.node').dataset.id")
    click = "dispatchEvent(new MouseEvent('click', { bubbles: true }))"
    firefox.run(f"document.querySelector('#drawing > svg [data-id=\"{node}\"]').{click}")
    assert firefox.until("return document.querySelector('#drawing > svg.selecting .box.chosen')?.dataset.id") == node
    assert firefox.until("return document.querySelector('#panel h2, #panel h1')?.textContent")
    assert firefox.until("return location.href.includes('node=')")

    before = firefox.run("return document.querySelectorAll('#drawing > svg .box').length")
    filling = "field.value = 'camera'; field.dispatchEvent(new Event('input'))"
    firefox.run(f"const field = document.querySelector('input[placeholder^=Filter]'); {filling}")
    firefox.until(f"const now = document.querySelectorAll('#drawing > svg .box').length; return now > 0 && now < {before}")

    looks = "getComputedStyle(document.querySelector('#drawing > svg .box .shape')).fill"
    light = firefox.run(f"return {looks}")
    firefox.run("for (const _ of 'ab') document.querySelector('button.theme').click()")  # light, then dark
    assert firefox.until(f"return {looks} !== '{light}'")
