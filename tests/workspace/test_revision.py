"""The files of a git revision in a directory: what comes out, what does not, and that nothing is run."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from launchlint.errors import UsageError
from launchlint.workspace import revision
from tests.workspace import repositories


class Repository(repositories.Repository):
    """One whose revisions are unpacked."""

    def unpacked(self, name: str, to: Path) -> dict[str, bytes | str]:
        """Path → content (or the goal of a link, as text) of all that is unpacked."""
        to.mkdir(parents=True, exist_ok=True)
        revision.unpack(str(self.directory), name, str(to))
        found: dict[str, bytes | str] = {}
        for place, _, files in os.walk(to):
            for file in files:
                path = Path(place, file)
                found[str(path.relative_to(to))] = os.readlink(path) if path.is_symlink() else path.read_bytes()
            for directory in [each for each in os.listdir(place) if Path(place, each).is_symlink() and Path(place, each).is_dir()]:
                found[str(Path(place, directory).relative_to(to))] = os.readlink(Path(place, directory))
        return found


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    return Repository(tmp_path / "repository")


@pytest.fixture
def out(tmp_path: Path) -> Path:
    return tmp_path / "out"


def test_files_as_they_were(repository: Repository, out: Path) -> None:
    repository.write_bytes("a/one.launch", b"<launch/>\r\n")
    repository.write_bytes("script.py", b"#!/usr/bin/env python3\n")
    (repository.directory / "script.py").chmod(0o755)
    repository.commit()
    repository.git("tag", "v1")
    repository.write(**{"a/one.launch": "changed", "new.launch": "new"})
    (repository.directory / "untracked.launch").write_text("x", encoding="utf-8")
    assert repository.unpacked("v1", out) == {"a/one.launch": b"<launch/>\r\n", "script.py": b"#!/usr/bin/env python3\n"}
    assert os.access(out / "script.py", os.X_OK)
    assert not os.access(out / "a/one.launch", os.X_OK)


@pytest.mark.parametrize("name", ["HEAD~1", "main~1", "@~1", "HEAD^", ":/first", "v1", "--odd"])
def test_names_of_revisions(repository: Repository, out: Path, name: str) -> None:
    repository.write(f="1")
    first = repository.commit("first")
    repository.git("tag", "v1")
    repository.git("update-ref", "refs/heads/--odd", first)
    repository.write(f="2")
    repository.commit("second")
    assert repository.unpacked(name, out) == {"f": b"1"}
    assert revision.is_revision(str(repository.directory), name)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("nothing", "git knows no such commit, branch or tag; a shallow clone"),
        ("-x", "git knows no such commit"),
        ("--upload-pack=touch x", "git knows no such commit"),
        ("", "git knows no such commit"),
        ("HEAD~7", "git knows no such commit"),
        ("HEAD:f", "it is a file or directory, not a commit"),
        ("v1..main", "that is a range; give its ends as two words: v1 main"),
        ("..main", "that is a range; give its ends as two words: HEAD main"),
        ("v1...", "that is a range; give its ends as two words: v1 HEAD"),
    ],
)
def test_names_of_none(repository: Repository, name: str, reason: str) -> None:
    repository.write(f="1")
    repository.commit()
    with pytest.raises(UsageError) as told:
        revision.resolve(str(repository.directory), name)
    assert str(told.value).startswith(f"{name} is no revision of the git repository {repository.directory}: {reason}")
    assert "\n" not in str(told.value)
    assert not revision.is_revision(str(repository.directory), name)


def test_no_repository(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="is not in a git repository: there is no revision HEAD of it to compare with"):
        revision.resolve(str(tmp_path), "HEAD")


def test_a_repository_without_a_commit(repository: Repository) -> None:
    assert not revision.is_revision(str(repository.directory), "HEAD")


def test_no_git(repository: Repository, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(UsageError, match=r"git cannot be run: .*; install it, or do without what asks for it"):
        revision.resolve(str(repository.directory), "HEAD")


def test_a_shallow_clone_lacks_what_was_before(repository: Repository, tmp_path: Path, out: Path) -> None:
    repository.write(f="1")
    first = repository.commit()
    repository.write(f="2")
    repository.commit()
    shallow = Repository(tmp_path / "shallow")
    shallow.git("fetch", "-q", "--depth=1", f"file://{repository.directory}", "main")
    shallow.git("checkout", "-q", "FETCH_HEAD")
    assert shallow.unpacked("HEAD", out) == {"f": b"2"}
    for name in (first, "HEAD~1"):
        with pytest.raises(UsageError, match="a shallow clone"):
            revision.resolve(str(shallow.directory), name)


def test_a_worktree(repository: Repository, tmp_path: Path, out: Path) -> None:
    repository.write(f="1")
    repository.commit()
    repository.git("worktree", "add", "-q", str(tmp_path / "tree"), "-b", "other")
    tree = Repository.__new__(Repository)
    tree.directory = tmp_path / "tree"
    tree.write(f="2")
    tree.commit()
    assert tree.unpacked("HEAD", out / "1") == {"f": b"2"}
    assert tree.unpacked("main", out / "2") == {"f": b"1"}


def test_what_git_tells_its_hooks_does_not_count(
    repository: Repository, tmp_path: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    repository.write(f="1")
    repository.commit()
    other = Repository(tmp_path / "other")
    for name, value in {"GIT_DIR": other.directory / ".git", "GIT_WORK_TREE": other.directory, "GIT_INDEX_FILE": "nowhere"}.items():
        monkeypatch.setenv(name, str(value))
    revision.unpack(str(repository.directory), "HEAD", str(out))
    assert (out / "f").read_bytes() == b"1"


def test_filters_attributes_and_hooks_are_not_run(repository: Repository, tmp_path: Path, out: Path) -> None:
    traps = []

    def trap(name: str) -> str:
        script = tmp_path / name
        script.write_text(f"#!/bin/sh\ntouch {tmp_path / 'sprung'}.{name}\ncat\n", encoding="utf-8")
        script.chmod(0o755)
        traps.append(name)
        return str(script)

    repository.write(**{"f.launch": "text $Id$\n", "g.xml": "x\n"})
    repository.commit()
    repository.write(**{".gitattributes": "*.launch filter=evil diff=evil eol=crlf ident export-ignore working-tree-encoding=UTF-16\n"})
    repository.git("add", ".gitattributes")
    repository.git("commit", "-q", "-m", "attributes")
    for key in ("filter.evil.smudge", "filter.evil.process", "filter.evil.clean", "diff.evil.textconv", "core.fsmonitor", "core.pager",
                "core.sshCommand", "core.hooksPath", "uploadpack.packObjectsHook", "core.alternateRefsCommand"):  # fmt: skip
        repository.git("config", key, trap(key))
    repository.git("config", "protocol.ext.allow", "always")
    repository.git("config", "pager.rev-parse", "true")
    assert repository.unpacked("HEAD", out)["f.launch"] == b"text $Id$\n"
    assert list(tmp_path.glob("sprung*")) == []


def test_a_partial_clone_fetches_nothing(repository: Repository, tmp_path: Path, out: Path) -> None:
    repository.git("config", "uploadpack.allowFilter", "true")
    repository.write(f="1")
    repository.commit()
    partial = tmp_path / "partial"
    Repository(tmp_path).git("clone", "-q", "--no-checkout", "--filter=blob:none", f"file://{repository.directory}", str(partial))
    script = tmp_path / "fetch"
    script.write_text(f"#!/bin/sh\ntouch {tmp_path / 'sprung'}\n", encoding="utf-8")
    script.chmod(0o755)
    subprocess.run(["git", "-C", str(partial), "config", "remote.origin.uploadpack", str(script)], check=True)
    out.mkdir()
    with pytest.raises(UsageError, match=r"git cannot read the object|git cannot list"):
        revision.unpack(str(partial), "HEAD", str(out))
    assert not (tmp_path / "sprung").exists()


def test_links_that_stay_inside_are_kept_and_others_are_not(repository: Repository, out: Path) -> None:
    repository.write(**{"a/b/c/f": "1", "e/g": "2"})
    links = {
        "good": "a/b/c/f",
        "a/up": "../e",
        "dangling": "nowhere",
        "absolute": "/etc/passwd",
        "out": "../../etc/passwd",
        "just_out": "..",
        "loop": "loop",
        "one": "two",
        "two": "one",
        "a/b/c/top": "../../../e",
        # One that leads out only through another one: below a/b/c/top, .. is the root.
        "sly": "a/b/c/top/../../../../../etc/passwd",
        "sly_too": "a/b/c/top/../..",
    }
    for name, goal in links.items():
        os.symlink(goal, repository.directory / name)
    repository.commit()
    found = repository.unpacked("HEAD", out)
    kept = {name: goal for name, goal in found.items() if isinstance(goal, str)}
    assert kept == {name: links[name] for name in ("good", "a/up", "dangling", "loop", "one", "two", "a/b/c/top")}
    root = os.path.realpath(out)
    assert all(os.path.realpath(out / name).startswith(root + os.sep) for name in kept)


def test_submodules_are_unpacked_from_their_own_repositories(repository: Repository, tmp_path: Path, out: Path) -> None:
    inner = Repository(tmp_path / "inner")
    inner.write(**{"nested.launch": "1"})
    inner.commit()
    repository.git("submodule", "-q", "add", str(inner.directory), "third party/inner")
    repository.commit()
    inside = Repository.__new__(Repository)
    inside.directory = repository.directory / "third party/inner"
    inside.write(**{"nested.launch": "2"})
    inside.commit()
    repository.commit()
    assert repository.unpacked("HEAD~1", out / "1")["third party/inner/nested.launch"] == b"1"
    assert repository.unpacked("HEAD", out / "2")["third party/inner/nested.launch"] == b"2"
    (inside.directory / ".git").unlink()
    assert list(repository.unpacked("HEAD", out / "3")) == [".gitmodules"]


def test_large_and_binary_files_are_there_but_empty(repository: Repository, out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(revision, "LARGEST_FILE", 1000)
    repository.write_bytes("large.yaml", b"x" * 1001)
    repository.write_bytes("map.PGM", b"P5")
    repository.write_bytes("small.yaml", b"x" * 1000)
    repository.commit()
    assert repository.unpacked("HEAD", out) == {"large.yaml": b"", "map.PGM": b"", "small.yaml": b"x" * 1000}


def test_in_all_no_more_than_so_many_bytes_and_files(repository: Repository, out: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    repository.write(a="1" * 60, b="2" * 60)
    repository.commit()
    monkeypatch.setattr(revision, "MOST_BYTES", 100)
    assert repository.unpacked("HEAD", out) == {"a": b"1" * 60, "b": b""}
    monkeypatch.setattr(revision, "MOST_FILES", 1)
    with pytest.raises(UsageError, match="HEAD has more than 1 files, too many to compare with"):
        revision.unpack(str(repository.directory), "HEAD", str(out))


def test_names_that_are_no_text(repository: Repository, out: Path) -> None:
    names = [b"caf\xe9.launch", b"new\nline.launch", b'quote".launch', b"tab\t.launch", "ü.launch".encode()]
    for name in names:
        Path(os.fsdecode(os.fsencode(repository.directory) + b"/" + name)).write_bytes(name)
    repository.commit()
    assert repository.unpacked("HEAD", out) == {os.fsdecode(name): name for name in names}


def test_trees_made_by_hand(repository: Repository, out: Path) -> None:
    """Git itself would not make them; a hostile server may send them."""
    repository.write(f="1")
    repository.commit()
    blob = repository.git("rev-parse", "HEAD:f")

    def tree(*entries: tuple[str, str, str]) -> str:
        raw = b"".join(f"{mode} {name}\0".encode() + bytes.fromhex(name_of) for mode, name, name_of in entries)
        command = ["git", "hash-object", "-t", "tree", "-w", "--stdin", "--literally"]
        return subprocess.run(command, cwd=repository.directory, input=raw, capture_output=True, check=True).stdout.decode().strip()

    goal = subprocess.run(
        ["git", "hash-object", "-w", "--stdin"], cwd=repository.directory, input=b"/tmp", capture_output=True, check=True
    ).stdout.decode().strip()  # fmt: skip
    inner = tree(("100644", "inside", blob))
    evil = tree(
        ("40000", "..", inner),
        ("40000", ".git", inner),
        ("40000", ".GIT", inner),
        ("120000", "clash", goal),
        ("40000", "clash", inner),
        ("100644", "twice", blob),
        ("40000", "twice", inner),
        ("100644", "fine", blob),
        ("100644", "n" * 300, blob),
    )
    commit = repository.git("commit-tree", evil, "-m", "evil")
    found = repository.unpacked(commit, out)
    assert found.pop("twice", b"1") == b"1"
    assert found.pop("twice/inside", b"1") == b"1"
    assert found == {"clash/inside": b"1", "fine": b"1"}
    assert sorted(os.listdir(out.parent)) == ["out", "repository"]
