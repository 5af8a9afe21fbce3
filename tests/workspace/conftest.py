"""Trees of small files for the tests of this room."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

Grow = Callable[[Mapping[str, str | None]], Path]


@pytest.fixture
def grow(tmp_path: Path) -> Grow:
    """A function from {path: content} to the directory that holds them.

    ``None`` makes a directory, ``"-> x"`` a link to x, ``"package NAME"`` a small package.xml of that name, and content that starts with
    ``"+x "`` an executable file.
    """

    def make(files: Mapping[str, str | None]) -> Path:
        for name, content in files.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            if content is None:
                path.mkdir(exist_ok=True)
            elif content.startswith("-> "):
                path.symlink_to(content[3:].replace("{root}", str(tmp_path)))
            elif content.startswith("package "):
                path.write_text(f"<package><name>{content[8:]}</name></package>")
            elif content.startswith("+x "):
                path.write_text(content[3:])
                path.chmod(0o755)
            else:
                path.write_text(content)
        return tmp_path

    return make
