"""Where source code is from: the git repository around a directory, its commit and address, read from plain files. git is not run."""

from __future__ import annotations

import os
import re

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.reading import read_bytes

_LARGEST = 4 << 20
_COMMIT = re.compile(r"[0-9a-f]{40}")
_REFERENCE = re.compile(r"refs/[\w./+@-]{1,200}")
_ORIGIN = re.compile(r'^[ \t]*\[remote "origin"\][ \t]*$(?P<body>(?:\n(?![ \t]*\[).*)*)', re.MULTILINE)
_URL = re.compile(r"^[ \t]*url[ \t]*=[ \t]*(\S+)[ \t]*$", re.MULTILINE)
_SSH = re.compile(r"(?:ssh://)?(?:[\w.-]+@)?([\w.-]+\.[a-z]+)(?::|/)(?!//)(?:\d+/)?([\w./-]+)")
_HTTP = re.compile(r"(https?)://(?:[^/@\s]*@)?([\w.-]+(?::\d+)?)/([\w./~+-]+)")


class Origin(NamedTuple):
    """A place that source code is from.

    Args:
        root: the directory that paths are told relative to.
        id: ``owner/name@commit``, or what is known of it.
        url: where others find it.
        ref: branch, where one is checked out.
        commit: the whole commit; empty where it is not known.
    """

    root: str
    id: str
    url: str
    ref: str
    commit: str


def origin_of(directory: str, given: str) -> Origin:
    """Where the package at ``directory`` is from; the directory ``given`` by the user stands in where it lies in no git repository."""
    here = os.path.abspath(directory)
    for _ in range(100):
        if os.path.lexists(os.path.join(here, ".git")):
            return _repository(here)
        parent = os.path.dirname(here)
        if parent == here:
            break
        here = parent
    given = os.path.abspath(given)
    name = os.path.basename(given) or "source"
    return Origin(given, _printable(name), f"file:{_printable(name)}", "", "")


def _repository(root: str) -> Origin:
    git = _git_directory(root)
    head = _text(os.path.join(git, "HEAD")).strip()
    ref = ""
    commit = head if _COMMIT.fullmatch(head) else ""
    if head.startswith("ref: ") and _REFERENCE.fullmatch(head[5:]) and ".." not in head:
        ref = head[5:]
        commit = _commit(git, ref)
    url, name = _address(_text(os.path.join(_shared(git), "config")))
    name = name or _printable(os.path.basename(root)) or "source"
    return Origin(root, f"{name}@{commit[:12]}" if commit else name, url or f"file:{name}", ref.removeprefix("refs/heads/"), commit)


def _git_directory(root: str) -> str:
    """The directory with HEAD: ``.git``, or where a file of that name leads (worktrees, submodules)."""
    path = os.path.join(root, ".git")
    if os.path.isdir(path):
        return path
    match = re.match(r"gitdir: (.+)", _text(path))
    return os.path.normpath(os.path.join(root, match[1].strip())) if match is not None else path


def _shared(git: str) -> str:
    """The directory with what all worktrees share."""
    common = _text(os.path.join(git, "commondir")).strip()
    return os.path.normpath(os.path.join(git, common)) if common and "\n" not in common else git


def _commit(git: str, ref: str) -> str:
    for directory in dict.fromkeys((git, _shared(git))):
        loose = _text(os.path.join(directory, ref)).strip()
        if _COMMIT.fullmatch(loose):
            return loose
        for line in _text(os.path.join(directory, "packed-refs")).splitlines():
            if line.endswith(f" {ref}") and _COMMIT.fullmatch(line[:40]):
                return line[:40]
    return ""


def _address(configuration: str) -> tuple[str, str]:
    """Address and ``owner/name`` of the remote ``origin``, without user names and passwords."""
    body = _ORIGIN.search(configuration)
    url = _URL.search(body["body"]) if body is not None else None
    if url is None or len(url[1]) > 500:
        return "", ""
    http, ssh = _HTTP.fullmatch(url[1]), _SSH.fullmatch(url[1])
    if http is not None:
        scheme, host, path = http[1], http[2], http[3]
    elif ssh is not None:
        scheme, host, path = "https", ssh[1], ssh[2]
    else:
        return "", ""
    path = path.strip("/").removesuffix(".git")
    return f"{scheme}://{host}/{path}", "/".join(path.split("/")[-2:])


def _text(path: str) -> str:
    try:
        return read_bytes(path, _LARGEST).decode("utf-8", "replace")
    except OSError:
        return ""


def _printable(name: str) -> str:
    return "".join(char if char.isprintable() and char != ":" else "_" for char in name)[:200]
