"""The bundled ROS 2 example as a repository, with the packages that it needs."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

from tests.cli.running import PACKAGE, ROOT, Ran, run
from tests.workspace.repositories import Repository

NEEDED = ("turtlesim", "joy", "teleop_twist_joy")
LAUNCH = "ferry_bringup/launch"
GOOD, BROKEN, HELM = f"{LAUNCH}/ferry.launch.xml", f"{LAUNCH}/ferry_broken.launch.xml", f"{LAUNCH}/helm.launch.yaml"
SEA, SEA_BROKEN = "ferry_bringup/config/sea.yaml", "ferry_bringup/config/sea_broken.yaml"

TOLD = [
    f"{SEA_BROKEN}:1:1: warning LL901 params-for-nobody",
    f"{BROKEN}:9:7: error LL947 remap-kills-node",
    f"{BROKEN}:11:81: error LL214 condition-not-boolean",
    f"{BROKEN}:14:27: error LL112 wrong-dialect",
]
"""What is wrong with the example, and where."""


class Ferry(Repository):
    """The example, committed; all packages that it names are there, without programs."""

    def __init__(self, directory: Path) -> None:
        super().__init__(directory)
        shutil.copytree(ROOT / "examples/ferry/ferry_bringup", directory / "ferry_bringup")
        self.write(**{f"others/{name}/package.xml": PACKAGE.format(name=name) for name in NEEDED})
        (directory / "ferry_bringup/.launchlint.yaml").rename(directory / ".launchlint.yaml")
        self.write(**{".launchlint.yaml": "library: [ferry_bringup/library.json]\n"})
        self.commit()

    def run(self, *words: str, stdin: str = "", **variables: str) -> Ran:
        """Run ``launchlint WORDS`` in it."""
        return run(self.directory, *words, stdin=stdin, environment=variables)

    def told(self, *words: str, stdin: str = "", **variables: str) -> list[str]:
        """Places, levels and rules of all findings but infos."""
        ran = self.run("check", "--format", "concise", *words, stdin=stdin, **variables)
        assert ran.status in (0, 1), ran.errors
        return [": ".join(line.split(": ", 2)[:2]) for line in ran.output.splitlines()]

    def text(self, name: str) -> str:
        """What a file holds."""
        return (self.directory / name).read_text(encoding="utf-8")

    def change(self, name: str, old: str, new: str) -> None:
        """Write ``new`` for ``old``, which must be in the file."""
        text = self.text(name)
        assert old in text
        self.write(**{name: text.replace(old, new)})

    def loaded(self, *words: str) -> Any:
        """What ``launchlint WORDS`` prints as JSON."""
        return json.loads(self.run(*words).output)
