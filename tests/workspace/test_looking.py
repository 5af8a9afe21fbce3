"""Looking around on disk."""

from __future__ import annotations

from pathlib import Path

from launchlint.workspace.looking import walk


def test_what_npm_and_pip_installed_is_not_walked_through(tmp_path: Path) -> None:
    for name in ("editor/node_modules/left/README.md", "env/pyvenv.cfg", "env/lib/x/README.md", ".git/config", "src/arm/package.xml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("")
    (tmp_path / "link").symlink_to(tmp_path / "src")
    walked = [(Path(directory).relative_to(tmp_path).as_posix(), names) for directory, names in walk(str(tmp_path), 100)]
    assert walked == [
        (".", [".git", "editor", "env", "link", "src"]),
        ("editor", ["node_modules"]),
        ("src", ["arm"]),
        ("src/arm", ["package.xml"]),
    ]


def test_it_ends(tmp_path: Path) -> None:
    (tmp_path / "a" / "b" / "c").mkdir(parents=True)
    assert len(list(walk(str(tmp_path), 2))) == 2
