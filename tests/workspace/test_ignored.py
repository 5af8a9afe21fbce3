"""What git ignores, as git says it, too."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.ignored import ignored_by

Grow = Callable[[Mapping[str, str | None]], Path]

# Case → (files, path → the pattern that ignores it, or "").
RULES: dict[str, tuple[Mapping[str, str | None], dict[str, str]]] = {
    "a name": ({".gitignore": "a.yaml\n"}, {"a.yaml": "a.yaml", "x/a.yaml": "a.yaml", "a.yml": "", "a.yaml/b": "a.yaml"}),
    "an ending": ({".gitignore": "# maps\n\n*.pgm\r\n"}, {"maps/a.pgm": "*.pgm", "maps/a.yaml": ""}),
    "anchored": ({".gitignore": "/a.yaml\nx/b.yaml"}, {"a.yaml": "/a.yaml", "x/a.yaml": "", "x/b.yaml": "x/b.yaml", "y/x/b.yaml": ""}),
    "a directory": ({".gitignore": "maps/"}, {"maps/a.yaml": "maps/", "x/maps/y/a.yaml": "maps/", "maps": ""}),
    "taken back": ({".gitignore": "*.yaml\n!a.yaml"}, {"a.yaml": "", "b.yaml": "*.yaml", "x/a.yaml": ""}),
    "not taken back below a directory": ({".gitignore": "maps/\n!maps/a.yaml"}, {"maps/a.yaml": "maps/"}),
    "all but some": ({".gitignore": "*\n!*/\n!*.launch"}, {"x/a.yaml": "*", "x/a.launch": "", "a.yaml": "*"}),
    "all below": ({".gitignore": "maps/*\n!maps/a.yaml"}, {"maps/a.yaml": "", "maps/b.yaml": "maps/*", "maps/x/a.yaml": "maps/*"}),
    "any depth": (
        {".gitignore": "x/**/a.yaml\n**/gen/*.launch"},
        {"x/a.yaml": "x/**/a.yaml", "x/y/z/a.yaml": "x/**/a.yaml", "gen/a.launch": "**/gen/*.launch", "p/gen/a.launch": "**/gen/*.launch"},
    ),
    "below": (
        {"x/.gitignore": "a.yaml\n/b.yaml\ny/c.yaml\nz/"},
        {
            "x/a.yaml": "a.yaml",
            "x/y/a.yaml": "a.yaml",
            "a.yaml": "",
            "x/b.yaml": "/b.yaml",
            "x/y/b.yaml": "",
            "x/y/c.yaml": "y/c.yaml",
            "y/c.yaml": "",
            "x/q/z/d": "z/",
        },
    ),
    "the deeper file wins": (
        {".gitignore": "*.yaml", "x/.gitignore": "!a.yaml"},
        {"x/a.yaml": "", "a.yaml": "*.yaml", "x/b.yaml": "*.yaml"},
    ),
    "escaped": ({".gitignore": "\\#a\n\\!b\n#c", "x/.gitignore": "\\!b\n\\#a"}, {"#a": "\\#a", "!b": "\\!b", "#c": "", "x/!b": "\\!b"}),
    "odd directories": ({"a b[1]/.gitignore": "*.yaml"}, {"a b[1]/x.yaml": "*.yaml", "a b1/x.yaml": ""}),
    "no patterns": ({".gitignore": "!\n[z-a]\n/\n\\\nok.yaml"}, {"a": "", "ok.yaml": "ok.yaml"}),
    "the clone's own": ({".git/info/exclude": "a.yaml\nb.yaml", ".gitignore": "!b.yaml"}, {"a.yaml": "a.yaml", "b.yaml": ""}),
    "nothing": ({".gitignore": None}, {"a": ""}),
}


@pytest.mark.parametrize("case", RULES)
def test_rules(case: str, grow: Grow) -> None:
    files, expected = RULES[case]
    root = grow({".git": None, **files})
    found = {path: ignored_by(f"{root}/{path}") for path in expected}
    assert {path: "" if ignore is None else ignore.pattern for path, ignore in found.items()} == expected


@pytest.mark.parametrize("case", RULES)
def test_git_ignores_the_same(case: str, grow: Grow) -> None:
    files, expected = RULES[case]
    root = grow({name: text for name, text in files.items() if not name.startswith(".git/")})
    subprocess.run(["git", "init", "-q", str(root)], check=True)
    grow({name: text for name, text in files.items() if name.startswith(".git/")})
    asked = subprocess.run(
        ["git", "-C", str(root), "-c", "core.excludesFile=/dev/null", "check-ignore", "--no-index", "-z", "--stdin"],
        input="\0".join(expected).encode(), capture_output=True,
    )  # fmt: skip
    assert asked.returncode in (0, 1), asked.stderr
    assert set(asked.stdout.decode().split("\0")) - {""} == {path for path, pattern in expected.items() if pattern}


def test_what_is_above_the_repository_does_not_count(grow: Grow) -> None:
    root = grow({".gitignore": "*.yaml", "repository/.git": None})
    assert ignored_by(f"{root}/repository/a.yaml") is None


@pytest.mark.parametrize("pattern", ["*a" * 40 + "b", "**/a" * 30 + "/b", "[" * 299, "*" * 3000, "a**" * 50])
def test_patterns_take_bounded_time(pattern: str, grow: Grow) -> None:
    root = grow({".git": None, ".gitignore": f"{pattern}\n" * 100})
    begin = time.process_time()
    ignored_by(f"{root}/" + "a/" * 30 + "a" * 250)
    assert time.process_time() - begin < 5
