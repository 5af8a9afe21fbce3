"""What git ignores: a file that is not here and that ``.gitignore`` names is made, or put there, on each machine.

The rules are git's (gitignore(5)): the files of all directories from the repository's top down, the later pattern first, and nothing can be
taken back below a directory that is ignored as a whole. ``.git/info/exclude`` counts too, a person's own ``core.excludesFile`` does not.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from functools import lru_cache

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import content, note_question
from launchlint.workspace.repository import repository_root

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec

GITIGNORE = ".gitignore"
_EXCLUDE = os.path.join(".git", "info", "exclude")

# Bounds against hostile patterns: a wildcard may take each number of characters of a path.
_MOST_LINES = 2_000
_LONGEST_PATTERN = 300
_DEEPEST = 40
_LONGEST_PATH = 1_000
_MOST_WORK = 20_000_000


class Ignore(NamedTuple):
    """Why git ignores a path: the ``pattern`` as written in ``file`` (absolute)."""

    file: str
    pattern: str


class _Pattern(NamedTuple):
    """One line of ``file``, which stands ``depth`` directories below the top; ``glob`` has no ``!`` and no slash at its end."""

    file: str
    depth: int
    written: str
    glob: str
    negated: bool
    directories_only: bool

    def matches(self, parts: list[str], *, is_directory: bool) -> bool:
        """Whether it is about the file or directory with the path ``parts``; not whether it is about one above."""
        if self.directories_only and not is_directory:
            return False
        if "/" not in self.glob:
            return _matches(self.glob, parts[-1])
        inside = parts[self.depth :]
        names = self.glob.removeprefix("/").split("/")
        if "**" not in names and len(names) != len(inside):
            return False
        return _matches(f"/{self.glob.removeprefix('/')}", "/".join(inside)) and (names[-1] == "**" or _matches(names[-1], parts[-1]))


def ignored_by(path: str, workspaces: Sequence[str] = ()) -> Ignore | None:
    """Why git ignores a file at ``path`` (absolute, whether or not it is there); ``None`` where it does not. Never raises.

    A copy without ``.git`` is taken to begin where the outermost of ``workspaces`` (absolute) does that the file lies in.
    """
    note_question("rospack", "repository", os.path.dirname(path))
    root = repository_root(os.path.dirname(path))
    if not os.path.exists(os.path.join(root, ".git")):
        root = min((each for each in workspaces if f"{root}/".startswith(f"{each.rstrip('/')}/")), key=len, default=root)
    relative = os.path.relpath(path, root).replace(os.sep, "/")
    parts = relative.split("/")
    if parts[0] == ".." or len(relative) > _LONGEST_PATH or len(parts) > _DEEPEST or "\0" in relative:
        return None
    patterns = _patterns(root, parts)
    for end in range(1, len(parts) + 1):
        for pattern in reversed(patterns):
            if pattern.matches(parts[:end], is_directory=end < len(parts)):
                if not pattern.negated:
                    return Ignore(pattern.file, pattern.written)
                break
    return None


def _patterns(root: str, parts: list[str]) -> list[_Pattern]:
    """The patterns of all files that count for a path, those of the deepest directory last."""
    work = 0
    found: list[_Pattern] = []
    for depth in range(-1, len(parts)):
        file = os.path.join(root, _EXCLUDE) if depth < 0 else os.path.join(root, *parts[:depth], GITIGNORE)
        for line in (content(file) or b"").decode("utf-8", "replace").removeprefix("\ufeff").splitlines()[:_MOST_LINES]:
            pattern = _pattern(file, max(depth, 0), line)
            if pattern is not None:
                work += _work(pattern.glob, parts)
                if work > _MOST_WORK:
                    return found
                found.append(pattern)
    return found


def _pattern(file: str, depth: int, line: str) -> _Pattern | None:
    """What a line says; ``None`` for a blank, a comment and one that is too long."""
    text = line.rstrip() + (" " if line.rstrip(" ").endswith("\\") else "")
    glob = text.removeprefix("!").removesuffix("/")
    if not glob or line.startswith("#") or len(text) > _LONGEST_PATTERN:
        return None
    return _Pattern(file, depth, text, glob, text.startswith("!"), text.endswith("/"))


def _work(glob: str, parts: list[str]) -> int:
    """How many ways there are, at most, to spread the wildcards of a pattern over a path."""
    deep = glob.count("**")
    ways = 1
    for count, each in ((deep, sum(map(len, parts))), (glob.count("*") - 2 * deep, max(map(len, parts)))):
        for number in range(1, count + 1):
            ways = ways * max(each, number) // number
            if ways > _MOST_WORK:
                return ways
    return ways


def _matches(glob: str, path: str) -> bool:
    spec = _spec(glob)
    return spec is not None and spec.match_file(path)


@lru_cache(maxsize=4_096)
def _spec(glob: str) -> GitIgnoreSpec | None:
    """The pattern compiled; ``None`` where it is none: git passes over that."""
    import warnings

    from pathspec import GitIgnoreSpec

    with warnings.catch_warnings():
        warnings.simplefilter("error", FutureWarning)  # "possible nested set": a class such as [[:alpha:]], which it does not know
        try:
            return GitIgnoreSpec.from_lines([glob])
        except (ValueError, re.error, FutureWarning):
            return None
