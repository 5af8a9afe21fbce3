"""The repository that pages are made of, as the current directory."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.report.html import pages


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small repository; the environment says nothing of ROS or GitHub."""
    directory = pages.repository(tmp_path / "repository")
    monkeypatch.chdir(directory)
    for name in ("ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", "ROS_DISTRO", "GITHUB_SERVER_URL", "GITHUB_REPOSITORY", "GITHUB_SHA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return directory
