"""Where sources are from, told from the files of git alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.extract.origin import Origin, origin_of

COMMIT = "0123456789abcdef0123456789abcdef01234567"


def repository(root: Path, files: dict[str, str]) -> Path:
    (root / "repo" / "pkg").mkdir(parents=True)
    for name, text in files.items():
        path = root / "repo" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root / "repo"


@pytest.mark.parametrize(
    ("url", "expected"),
    [
        ("https://github.com/owner/name.git", "https://github.com/owner/name"),
        ("git@github.com:owner/name.git", "https://github.com/owner/name"),
        ("ssh://git@github.com:22/owner/name", "https://github.com/owner/name"),
        ("https://user:secret@github.com/owner/name", "https://github.com/owner/name"),
    ],
)
def test_a_clone(url: str, expected: str, tmp_path: Path) -> None:
    root = repository(
        tmp_path,
        {
            ".git/HEAD": "ref: refs/heads/main\n",
            ".git/refs/heads/main": COMMIT + "\n",
            ".git/config": f'[core]\n\tbare = false\n[remote "origin"]\n\turl = {url}\n\tfetch = x\n[branch "main"]\n',
        },
    )
    assert origin_of(str(root / "pkg"), str(root)) == Origin(str(root), "owner/name@0123456789ab", expected, "main", COMMIT)


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        pytest.param({".git/HEAD": COMMIT}, ("repo@0123456789ab", "file:repo", "", COMMIT), id="detached, without a remote"),
        pytest.param(
            {".git/HEAD": "ref: refs/heads/a/b", ".git/packed-refs": f"# pack-refs\n{COMMIT} refs/heads/a/b\n"},
            ("repo@0123456789ab", "file:repo", "a/b", COMMIT),
            id="packed",
        ),
        pytest.param(
            {".git": "gitdir: ../git/worktrees/x", "../git/worktrees/x/HEAD": "ref: refs/heads/w", "../git/worktrees/x/commondir": "../..",
             "../git/refs/heads/w": COMMIT, "../git/config": '[remote "origin"]\nurl = https://example.org/a/b/c\n'},
            ("b/c@0123456789ab", "https://example.org/a/b/c", "w", COMMIT),
            id="a worktree",
        ),
        pytest.param({".git/HEAD": "ref: refs/heads/../../../secret", "../secret": COMMIT}, ("repo", "file:repo", "", ""), id="a way out"),
        pytest.param({".git/HEAD": "\x1b[31m" * 100}, ("repo", "file:repo", "", ""), id="rubbish"),
        pytest.param({".git/x": ""}, ("repo", "file:repo", "", ""), id="nothing"),
        pytest.param({}, ("given", "file:given", "", ""), id="no repository"),
    ],
)  # fmt: skip
def test_others(files: dict[str, str], expected: tuple[str, str, str, str], tmp_path: Path) -> None:
    root = repository(tmp_path, files)
    assert origin_of(str(root / "pkg"), str(tmp_path / "given"))[1:] == expected
