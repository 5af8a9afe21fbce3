"""The recorded answers of rcl, where they are at hand."""

from __future__ import annotations

import json
import lzma
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Answers = Callable[[str], list[dict[str, Any]]]


@pytest.fixture
def answers() -> Answers:
    """A function that reads one file of answers; what it is asked for is skipped where there are none."""

    def read(name: str) -> list[dict[str, Any]]:
        file = Path(os.environ.get("LAUNCHLINT_ORACLE", "")) / "ros2" / name
        if not file.is_file():
            pytest.skip("LAUNCHLINT_ORACLE does not name a directory with recorded answers of ROS 2")
        with lzma.open(file, "rt", encoding="utf-8") as lines:
            return [json.loads(line) for line in lines]

    return read
