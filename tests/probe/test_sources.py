"""Sources are packed, never checked out: nothing in a repository can act on this machine, or leave its place in the image."""

from __future__ import annotations

import io
import os
import stat
import subprocess
import tarfile
from pathlib import Path

import pytest

from launchlint.errors import UsageError
from launchlint.probe import sources
from launchlint.probe.configuration import ProbeConfiguration, Repository
from launchlint.probe.context import program_directory, write_context
from launchlint.probe.sources import Tree, fetch, local, members


def git(directory: Path, *words: str) -> str:
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1"}
    identity = ["-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false", "-c", "init.defaultBranch=main"]
    done = subprocess.run(["git", "-C", str(directory), *identity, *words], capture_output=True, text=True, env=environment, check=True)
    return done.stdout.strip()


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A repository with hooks, filters and links that would do harm if they were followed."""
    work = tmp_path / "robot"
    (work / "pkg").mkdir(parents=True)
    git(work, "init", "--quiet")
    (work / "pkg" / "package.xml").write_text("<package><name> pkg </name></package>")
    (work / "pkg" / "node").write_text("#!/bin/sh\n")
    (work / "pkg" / "node").chmod(0o755)
    (work / "pkg" / "inside").symlink_to("node")
    (work / "out").symlink_to("../../../etc/passwd")
    (work / "absolute").symlink_to("/etc/passwd")
    (work / ".gitattributes").write_text("* filter=evil\n")
    git(work, "add", "-A")
    git(work, "commit", "--quiet", "-m", "all")
    git(work, "config", "filter.evil.smudge", f"touch {tmp_path}/owned; cat")
    git(work, "config", "filter.evil.clean", f"touch {tmp_path}/owned; cat")
    git(work, "config", "core.fsmonitor", f"touch {tmp_path}/owned")
    for hook in ("post-checkout", "post-merge", "reference-transaction"):
        path = work / ".git" / "hooks" / hook
        path.write_text(f"#!/bin/sh\ntouch {tmp_path}/owned\n")
        path.chmod(0o755)
    return work


def context_of(*trees: Tree) -> tuple[tarfile.TarFile, dict[str, str], bytes]:
    file = io.BytesIO()
    origins = write_context(file, ProbeConfiguration(apt=("b-apt", "a-apt"), pip=("x==1",)), trees)
    file.seek(0)
    return tarfile.open(fileobj=file), origins, file.getvalue()


def test_a_repository_is_fetched_and_packed_and_nothing_of_it_runs(repository: Path, tmp_path: Path) -> None:
    tree = fetch(Repository(repository.as_uri(), "main"), str(tmp_path / "cache"))
    assert tree.commit == git(repository, "rev-parse", "HEAD")
    assert tree.name.startswith("robot-")
    found = {member.path: (member.runs, member.link) for member in members(tree)}
    assert found == {".gitattributes": (False, ""), "pkg/inside": (False, "node"), "pkg/node": (True, ""), "pkg/package.xml": (False, "")}
    assert not (tmp_path / "owned").exists()


def test_a_known_commit_needs_no_network(repository: Path, tmp_path: Path) -> None:
    cache = str(tmp_path / "cache")
    tree = fetch(Repository(repository.as_uri(), "main"), cache)
    repository.rename(tmp_path / "gone")
    assert fetch(Repository(repository.as_uri(), tree.commit), cache)._replace(ref="main") == tree


def test_a_ref_that_does_not_exist(repository: Path, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"git cannot fetch 'nowhere': .*couldn't find remote ref nowhere"):
        fetch(Repository(repository.as_uri(), "nowhere"), str(tmp_path / "cache"))


def test_neither_hooks_nor_programs_for_urls_run_whatever_the_user_allows(
    repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gitconfig").write_text(f'[core]\nhooksPath = {repository}/.git/hooks\n[protocol "ext"]\nallow = always\n')
    monkeypatch.setenv("GIT_CONFIG_GLOBAL", str(tmp_path / "gitconfig"))
    fetch(Repository(repository.as_uri(), "main"), str(tmp_path / "cache"))
    with pytest.raises(UsageError, match="transport 'ext' not allowed"):
        fetch(Repository(f"ext::touch {tmp_path}/owned", "main"), str(tmp_path / "cache"))
    assert not (tmp_path / "owned").exists()


def test_a_url_is_never_an_option(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"git cannot fetch 'main': fatal: strange pathname '--upload-pack=id' blocked\Z"):
        fetch(Repository("--upload-pack=id", "main"), str(tmp_path))


def test_a_local_checkout_is_taken_as_it_is(repository: Path, tmp_path: Path) -> None:
    (repository / "pkg" / "new").write_text("not committed")
    (repository / "build").mkdir()
    (repository / "build" / "CMakeCache.txt").write_text("")
    os.mkfifo(repository / "pipe")
    os.mknod(repository / "socket", stat.S_IFSOCK | 0o600)
    tree = local(str(repository), ["robot"])
    assert (tree.name, tree.commit) == ("robot-2", git(repository, "rev-parse", "HEAD"))
    found = [member.path for member in members(tree)]
    assert found == [".gitattributes", "pkg/inside", "pkg/new", "pkg/node", "pkg/package.xml"]
    assert not (tmp_path / "owned").exists()


def test_a_tree_is_called_by_plain_letters(repository: Path, tmp_path: Path) -> None:
    odd = repository.rename(tmp_path / "-a b;$(id)~")
    assert local(str(odd)).name == "a_b___id__"
    assert fetch(Repository(f"file://{odd}", "main"), str(tmp_path / "cache")).name.rpartition("-")[0] == "a_b___id__"


def test_members_of_a_hostile_archive_stay_inside(tmp_path: Path) -> None:
    path = tmp_path / "evil.tar"
    with tarfile.open(path, "w") as archive:
        for name in ("../up", "/abs", "a/../../up", "fine", "new\nline"):
            info = tarfile.TarInfo(name)
            archive.addfile(info, io.BytesIO(b""))
        for name, kind, goal in (
            ("l1", tarfile.SYMTYPE, "../x"),
            ("l2", tarfile.SYMTYPE, "/etc"),
            ("l3", tarfile.SYMTYPE, "fine"),
            ("h", tarfile.LNKTYPE, "/etc/passwd"),
        ):
            info = tarfile.TarInfo(name)
            info.type, info.linkname = kind, goal
            archive.addfile(info)
        device = tarfile.TarInfo("device")
        device.type = tarfile.CHRTYPE
        archive.addfile(device)
    assert [(member.path, member.link) for member in members(Tree("t", "u", "r", "c", str(path), ""))] == [("fine", ""), ("l3", "fine")]


@pytest.mark.parametrize(
    ("limit", "value", "message"),
    [
        ("MOST_FILES", 3, "more than 3 files or 4 GiB of source code"),
        ("LARGEST_TREE", 10, "more than 300000 files or 0 GiB of source code"),
    ],
)
def test_a_tree_without_end_is_refused(limit: str, value: int, message: str, repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sources, limit, value)
    with pytest.raises(UsageError, match=f"robot: this is {message}"):
        list(members(local(str(repository))))


def test_a_file_without_end_is_left_out(repository: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sources, "LARGEST_FILE", 16)
    for tree in (local(str(repository)), fetch(Repository(repository.as_uri(), "main"), str(tmp_path / "cache"))):
        assert [member.path for member in members(tree)] == [".gitattributes", "pkg/inside", "pkg/node"]


def test_a_package_is_called_by_plain_letters(repository: Path) -> None:
    for number, name in enumerate(("../up", "-rf", "$(id)", "a b")):
        (repository / str(number)).mkdir()
        (repository / str(number) / "package.xml").write_text(f"<package><name>{name}</name></package>")
    assert context_of(local(str(repository)))[1] == {"pkg": "robot"}


def test_the_context_is_the_same_each_time(repository: Path) -> None:
    archive, origins, data = context_of(local(str(repository)))
    assert origins == {"pkg": "robot"}
    names = archive.getnames()
    assert [name for name in names if not name.startswith(("setup/", "launchlint_probe/"))] == [
        "Dockerfile",
        "certificates",
        "manifests",
        "source",
        "source/robot/.gitattributes",
        "source/robot/pkg/inside",
        "source/robot/pkg/node",
        "manifests/robot/pkg/package.xml",
        "source/robot/pkg/package.xml",
    ]
    apt = archive.extractfile("setup/apt.txt")
    assert apt is not None
    assert apt.read() == b"a-apt\nb-apt\n"
    assert {(member.uid, member.gid, member.mtime) for member in archive} == {(0, 0, 0)}
    os.utime(repository / "pkg" / "node", (1, 1))
    assert context_of(local(str(repository)))[2] == data


def test_certificates_for_a_network_that_looks_inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "corporate.pem").write_text("PEM")
    monkeypatch.setenv("LAUNCHLINT_CA_CERTIFICATES", str(tmp_path))
    archive, _, _ = context_of()
    found = archive.extractfile("certificates/launchlint-0.crt")
    assert found is not None
    assert found.read() == b"PEM"
    monkeypatch.setenv("LAUNCHLINT_CA_CERTIFICATES", str(tmp_path / "nowhere"))
    with pytest.raises(UsageError, match=r"LAUNCHLINT_CA_CERTIFICATES: .*nowhere cannot be read"):
        context_of()


def test_the_program_is_found() -> None:
    assert Path(program_directory(), "Dockerfile").is_file()
