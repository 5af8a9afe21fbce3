"""What all tests share: the update flag, and the markers of tests that need something a machine may not have."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

# A busy machine makes no test fail: what is measured in seconds is measured elsewhere (tests/bench), and as a ratio.
settings.register_profile("launchlint", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("launchlint")

ROOT = Path(__file__).resolve().parent.parent


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="rewrite the expected output that tests keep in files and in README.md")


@pytest.fixture
def update(request: pytest.FixtureRequest) -> bool:
    """Whether expected output kept in files is to be rewritten."""
    return bool(request.config.getoption("--update"))


@pytest.fixture
def snapshot(request: pytest.FixtureRequest, update: bool) -> Callable[[str, str], None]:
    """A function (name, text): ``text`` must be what the file ``snapshots/NAME`` next to the test holds; ``--update`` writes it."""

    def compare(name: str, text: str) -> None:
        file = request.path.parent / "snapshots" / name
        if update:
            file.parent.mkdir(exist_ok=True)
            file.write_bytes(text.encode("utf-8"))
        assert file.is_file(), f"there is no {file.name} yet: look at the output, then run pytest --update\n{text}"
        assert text == file.read_bytes().decode("utf-8")

    return compare


@pytest.fixture
def root() -> Path:
    """The root of this repository."""
    return ROOT


def _answers(command: list[str]) -> bool:
    """Whether ``command`` ends well within a few seconds."""
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=20, check=False).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


@cache
def find_ros_python() -> str | None:
    """A Python that can import roslaunch, whichever that is on this machine."""
    for name in ("/usr/bin/python3", "python3", "python"):
        interpreter = shutil.which(name)
        if interpreter and _answers([interpreter, "-c", "import roslaunch"]):
            return interpreter
    return None


@cache
def find_docker() -> str | None:
    """The docker client, where an engine answers it."""
    docker = shutil.which("docker")
    return docker if docker and _answers([docker, "info"]) else None


@cache
def find_chromium() -> str | None:
    """A Chromium or Chrome that runs headless."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@cache
def find_firefox() -> str | None:
    """Firefox, of whichever channel."""
    return shutil.which("firefox-esr") or shutil.which("firefox")


@cache
def find_sarif_multitool() -> str | None:
    """The command of npm's @microsoft/sarif-multitool."""
    return shutil.which(os.environ.get("SARIF_MULTITOOL", "sarif-multitool"))


@cache
def find_node() -> str | None:
    """Node.js that knows ``--test``."""
    node = shutil.which("node")
    return node if node and _answers([node, "--test", "--version"]) else None


@cache
def find_mermaid() -> str | None:
    """A directory whose node_modules have npm's mermaid and jsdom; Node.js must be there, too."""
    directory = os.environ.get("MERMAID", "")
    packages = [Path(directory, "node_modules", name) for name in ("mermaid", "jsdom")]
    return directory if directory and shutil.which("node") and all(each.is_dir() for each in packages) else None


@cache
def find_axe_core() -> str | None:
    """A directory whose node_modules have npm's axe-core."""
    directory = os.environ.get("AXE_CORE", "")
    return directory if directory and Path(directory, "node_modules", "axe-core").is_dir() else None


@cache
def find_dot() -> str | None:
    """The command of Graphviz."""
    return shutil.which("dot")


@cache
def find_neovim() -> str | None:
    """The command of Neovim."""
    return shutil.which("nvim")


@cache
def find_emacs() -> str | None:
    """The command of Emacs, where it has eglot."""
    emacs = shutil.which("emacs")
    has_eglot = ["--batch", "--eval", "(progn (require 'package) (package-initialize) (require 'eglot))"]
    return emacs if emacs and _answers([emacs, *has_eglot]) else None


@cache
def find_strace() -> str | None:
    """The command of strace, where it may watch a process."""
    strace = shutil.which("strace")
    return strace if strace and _answers([strace, "-qq", "-o", os.devnull, "true"]) else None


@cache
def find_corpus() -> str | None:
    """A directory with public launch files (``ros1/…``)."""
    corpus = os.environ.get("LAUNCHLINT_CORPUS", "")
    return corpus if corpus and Path(corpus, "ros1").is_dir() else None


@cache
def find_package_index() -> str | None:
    """The command that installs Python packages, where an index answers it."""
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--disable-pip-version-check"]
    with tempfile.TemporaryDirectory() as directory:
        return sys.executable if _answers([*pip, "--dest", directory, "click"]) else None


NEEDS: dict[str, tuple[Callable[[], str | None], str]] = {
    "ros": (find_ros_python, "no Python on this machine can import roslaunch (Debian: apt-get install python3-roslaunch)"),
    "docker": (find_docker, "no Docker engine answers"),
    "chromium": (find_chromium, "Chromium is not installed (Debian: apt-get install chromium)"),
    "firefox": (find_firefox, "Firefox is not installed (Debian: apt-get install firefox-esr)"),
    "pypi": (find_package_index, "pip finds no package index to install from"),
    "npm": (
        find_sarif_multitool,
        "sarif-multitool is not installed (npm install @microsoft/sarif-multitool, then set SARIF_MULTITOOL to its command)",
    ),
    "node": (find_node, "Node.js 18 or newer is not installed"),
    "mermaid": (
        find_mermaid,
        "MERMAID does not name a directory with Mermaid (npm install --prefix DIRECTORY mermaid jsdom), or there is no Node.js",
    ),
    "axe": (find_axe_core, "AXE_CORE does not name a directory with axe-core (npm install --prefix DIRECTORY axe-core)"),
    "graphviz": (find_dot, "Graphviz is not installed (Debian: apt-get install graphviz)"),
    "strace": (find_strace, "strace is not installed, or may not watch a process here (Debian: apt-get install strace)"),
    "neovim": (find_neovim, "Neovim is not installed (Debian: apt-get install neovim)"),
    "emacs": (find_emacs, "Emacs with eglot is not installed (Debian: apt-get install emacs-nox elpa-eglot)"),
    "corpus": (find_corpus, "LAUNCHLINT_CORPUS does not name a directory with a ros1 folder of public launch files"),
}


SLOW = (
    "tests/action", "tests/check", "tests/cli", "tests/conformance", "tests/evaluate", "tests/export", "tests/extract", "tests/fix/format",
    "tests/fix/test_rule_fixes.py", "tests/growth", "tests/hook", "tests/ide", "tests/knowledge", "tests/library/test_bundled_script.py",
    "tests/project", "tests/server",
    "tests/library/test_grow_script.py", "tests/library/test_hostile.py", "tests/packaging", "tests/probe", "tests/report",
    "tests/rules/test_pages.py", "tests/syntax", "tests/test_architecture.py", "tests/test_example.py", "tests/test_guides.py",
    "tests/test_hostile.py", "tests/test_hostile_ros2.py", "tests/test_readme.py", "tests/test_startup.py", "tests/test_workflows.py",
)  # fmt: skip
"""Folders and files whose tests start processes, or try thousands of texts; a single test elsewhere carries the marker ``slow``."""

PROGRAMS_FOR_OUTPUT = ("chromium", "firefox", "axe", "node", "mermaid", "npm", "graphviz")
"""Programs for what launchlint writes: their tests are one lane of the workflow that tests pull requests."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    slow = tuple(str(ROOT / each) for each in SLOW)
    for item in items:
        if str(item.path).startswith(slow):
            item.add_marker("slow")
        if any(item.get_closest_marker(each) for each in PROGRAMS_FOR_OUTPUT):
            item.add_marker("browser")
        elif not any(item.get_closest_marker(each) for each in ("slow", *NEEDS)):
            item.add_marker("fast")
        for marker, (find, reason) in NEEDS.items():
            if item.get_closest_marker(marker) and find() is None:
                item.add_marker(pytest.mark.skip(reason=reason))


def _needed(marker: str) -> str:
    find, reason = NEEDS[marker]
    found = find()
    if found is None:
        pytest.skip(reason)
    return found


@pytest.fixture
def ros_python() -> str:
    """Command of a Python that can import roslaunch; the test carries the marker ``ros``."""
    return _needed("ros")


@pytest.fixture
def chromium() -> str:
    """Command of a headless browser; the test carries the marker ``chromium``."""
    return _needed("chromium")


@pytest.fixture
def sarif_multitool() -> str:
    """Command of the SARIF validator; the test carries the marker ``npm``."""
    return _needed("npm")


@pytest.fixture
def mermaid_directory() -> str:
    """Directory in which scripts find npm's mermaid and jsdom; the test carries the marker ``mermaid``."""
    return _needed("mermaid")


@pytest.fixture
def axe_core() -> str:
    """Directory in which axe-core lies; the test carries the marker ``axe``."""
    return _needed("axe")


@pytest.fixture
def dot_command() -> str:
    """Command of Graphviz; the test carries the marker ``graphviz``."""
    return _needed("graphviz")


@pytest.fixture
def neovim() -> str:
    """Command of Neovim; the test carries the marker ``neovim``."""
    return _needed("neovim")


@pytest.fixture
def emacs() -> str:
    """Command of Emacs with eglot; the test carries the marker ``emacs``."""
    return _needed("emacs")


@pytest.fixture
def corpus() -> Path:
    """Directory of the corpus; the test carries the marker ``corpus``."""
    return Path(_needed("corpus"))
