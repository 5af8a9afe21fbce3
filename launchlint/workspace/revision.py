"""The files of a git revision, put into a directory: to look at what was before.

Only ``git rev-parse``, ``ls-tree`` and ``cat-file`` are run: they read objects, and run neither hooks nor filters of the repository. What
git stores is written as it is stored: line ends are not converted, and files kept in LFS stay pointers.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from launchlint.errors import UsageError
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.git import FILE_MODES, contents, git, reason, sizes

LARGEST_FILE = 4 << 20
"""Bytes; a larger file is made empty: nothing that launchlint reads is so large."""
MOST_FILES = 200_000
MOST_BYTES = 1 << 30
"""Bytes that are written in all; what comes later is made empty."""
MOST_NESTED = 8
"""Submodules in submodules that are followed."""

_LINK, _MODULE = "120000", "160000"
_NEVER_READ = (
    ".3ds .7z .a .avi .bag .bin .blend .bmp .bz2 .dae .dds .db .db3 .dwg .exr .fbx .gif .glb .gltf .gz .h5 .hdf5 .hdr .ico .iv .jar .jpeg"
    " .jpg .kml .mp3 .mp4 .mtl .npy .npz .o .obj .ogg .onnx .ovf .pb .pbm .pcd .pdf .pgm .ply .png .ppm .pt .pth .so .step .stl .stp .svg"
    " .tar .tga .tgz .tif .tiff .wav .wbt .webm .webp .wrl .xz .zip"
)
_WITHOUT_CONTENT = frozenset(_NEVER_READ.split())
"""Ends of names of which it is enough to know that the file is there: meshes, maps, pictures, recordings."""


class _Entry(NamedTuple):
    mode: str
    object: str
    size: int
    path: str

    @property
    def has_content(self) -> bool:
        """Whether what is in it is needed."""
        return self.mode == _LINK or (self.size <= LARGEST_FILE and os.path.splitext(self.path)[1].lower() not in _WITHOUT_CONTENT)


def resolve(repository: str, revision: str) -> str:
    """The commit that ``revision`` names in the repository at the directory ``repository``.

    Raises:
        UsageError: there is none, or no git, or no repository.
    """
    if not os.path.exists(os.path.join(repository, ".git")):
        raise UsageError(f"{repository} is not in a git repository: there is no revision {revision} of it to compare with")
    done = git(repository, ["rev-parse", "--verify", "--quiet", "--end-of-options", revision])
    found = done.stdout.decode("ascii", "replace").strip()
    if not done.returncode and found:  # in two steps: what follows :/text belongs to the text
        done = git(repository, ["rev-parse", "--verify", "--quiet", "--end-of-options", f"{found}^{{commit}}"])
    commit = done.stdout.decode("ascii", "replace").strip()
    if done.returncode or not commit:
        raise UsageError(f"{revision} is no revision of the git repository {repository}: {_why(done.stderr, revision)}")
    return commit


def _why(errors: bytes, revision: str) -> str:
    if b"expected commit type" in errors:
        return "it is a file or directory, not a commit"
    if errors and b"^{commit}" not in errors:
        return reason(errors)
    if ".." in revision:
        first, _, second = revision.partition("..")
        return f"that is a range; give its ends as two words: {first or 'HEAD'} {second.lstrip('.') or 'HEAD'}"
    return (
        "git knows no such commit, branch or tag; a shallow clone (the default in CI) lacks most of them: git fetch --depth=1 origin BRANCH"
        " gets one, and FETCH_HEAD is its name then"
    )


def is_revision(repository: str, revision: str) -> bool:
    """Whether ``revision`` names a commit; False, too, where there is no git."""
    try:
        return bool(resolve(repository, revision))
    except UsageError:
        return False


def unpack(repository: str, revision: str, directory: str) -> None:
    """Write the files of ``revision`` below ``directory``, which is empty.

    Left out are links that lead out of it. Large files, and those whose content is never read, are there but empty. A submodule is
    unpacked from its own repository in the working tree, where there is one that has its commit.

    Raises:
        UsageError: there is no such revision, or git fails.
    """
    links: list[str] = []
    _unpack(repository, resolve(repository, revision), revision, directory, links, MOST_NESTED)
    _without_ways_out(links, directory)


def unpack_index(repository: str, directory: str) -> None:
    """Write the files of the index, as git would commit them, below ``directory``, which is empty; else as :func:`unpack`.

    Raises:
        UsageError: git fails.
    """
    listed = git(repository, ["ls-files", "--cached", "--stage", "-z"], index_of(repository))
    if listed.returncode:
        raise UsageError(f"git cannot list the files that are staged in {repository}: {reason(listed.stderr)}")
    links: list[str] = []
    _unpack_all(repository, list(_entries(_sized(repository, listed.stdout))), "the index", directory, links, MOST_NESTED)
    _without_ways_out(links, directory)


def index_of(root: str) -> dict[str, str]:
    """The index that is being committed: ``git commit FILE`` makes one of its own and tells its hooks, where it is of this repository."""
    told = os.environ.get("GIT_INDEX_FILE", "")
    if not told:
        return {}
    found = git(root, ["rev-parse", "--absolute-git-dir"])
    directory = os.path.realpath(os.fsdecode(found.stdout.rstrip(b"\n")))
    index = os.path.realpath(os.path.join(root, told))
    return {"GIT_INDEX_FILE": index} if not found.returncode and os.path.dirname(index) == directory else {}


def _sized(repository: str, listing: bytes) -> bytes:
    """The listing of an index as ``ls-tree --long`` gives that of a revision; of a file in conflict, our side of it."""
    lines: list[tuple[bytes, bytes, bytes]] = []
    for line in listing.split(b"\0"):
        facts, _, path = line.partition(b"\t")
        words = facts.split()
        if len(words) == 3 and words[2] in (b"0", b"2", b"3") and not (lines and lines[-1][2] == path):
            lines.append((words[0], words[1], path))
    lengths = iter(sizes(repository, [name.decode("ascii", "replace") for mode, name, _ in lines if mode.decode() != _MODULE]))
    return b"\0".join(
        b"%s %s %s %s\t%s" % (mode, b"blob", name, b"-" if mode.decode() == _MODULE else b"%d" % next(lengths), path)
        for mode, name, path in lines
    )


def _without_ways_out(links: list[str], directory: str) -> None:
    """Take links away that lead out of a directory."""
    root = os.path.realpath(directory)
    for link in links:
        if not os.path.realpath(link).startswith(root + os.sep):
            os.unlink(link)


def _unpack(repository: str, commit: str, revision: str, directory: str, links: list[str], depth: int) -> None:
    listed = git(repository, ["ls-tree", "-r", "-z", "--long", "--full-tree", commit])
    if listed.returncode:
        raise UsageError(f"git cannot list the files of {revision}: {reason(listed.stderr)}")
    _unpack_all(repository, list(_entries(listed.stdout)), revision, directory, links, depth)


def _unpack_all(repository: str, listed: list[_Entry], revision: str, directory: str, links: list[str], depth: int) -> None:
    entries = [entry for entry in listed if _is_harmless(entry.path)]
    if len(entries) > MOST_FILES:
        raise UsageError(f"{revision} has more than {MOST_FILES} files, too many to compare with")
    read: list[_Entry] = []
    left = MOST_BYTES
    for entry in entries:
        if entry.mode != _MODULE:
            left -= entry.size if entry.has_content else 0
            if entry.has_content and left >= 0:
                read.append(entry)
            else:
                _write(directory, entry, b"")
    for entry, content in zip(read, contents(repository, [each.object for each in read]), strict=True):
        if entry.mode != _LINK:
            _write(directory, entry, content)
        elif _link(directory, entry.path, os.fsdecode(content)):
            links.append(os.path.join(directory, entry.path))
    for entry in (each for each in entries if each.mode == _MODULE):
        module = os.path.join(repository, entry.path)
        at_home = os.path.realpath(module) == os.path.join(os.path.realpath(repository), entry.path)
        if depth and at_home and os.path.exists(os.path.join(module, ".git")):
            try:
                _unpack(module, entry.object, revision, os.path.join(directory, entry.path), links, depth - 1)
            except UsageError:
                continue  # its commit is not here: the packages in it are then not known, which makes nobody wrong


def _entries(listing: bytes) -> Iterator[_Entry]:
    """The files, links and submodules of a listing; links last, so that none of them stands in the way of a file."""
    links: list[_Entry] = []
    for line in listing.split(b"\0"):
        facts, _, path = line.partition(b"\t")
        words = facts.decode("ascii", "replace").split()
        if len(words) != 4 or words[0] not in (_LINK, _MODULE, *FILE_MODES):
            continue
        entry = _Entry(words[0], words[2], int(words[3]) if words[3].isdecimal() else 0, os.fsdecode(path))
        if entry.mode == _LINK:
            links.append(entry)
        else:
            yield entry
    yield from links


def _is_harmless(path: str) -> bool:
    """Whether a path of a tree stays below the directory it is written to, and makes no repository there."""
    parts = path.split("/")
    return not any(part in ("", ".", "..") or part.lower() == ".git" for part in parts)


def _write(directory: str, entry: _Entry, content: bytes) -> None:
    target = os.path.join(directory, entry.path)
    try:
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "wb") as file:
            file.write(content)
        if entry.mode == "100755":
            os.chmod(target, 0o755)
    except (FileExistsError, NotADirectoryError, IsADirectoryError):
        return  # a tree made by hand, with a file and a directory of one name
    except OSError as error:
        if len(os.path.basename(target)) < 256:
            raise UsageError(f"a file of the revision cannot be written to {directory}: {error.strerror}") from None


def _link(directory: str, path: str, goal: str) -> bool:
    """Make a link that leads to somewhere in ``directory``; whether that was done."""
    if os.path.isabs(goal) or "\0" in goal or not goal:
        return False
    target = os.path.join(directory, path)
    try:
        os.makedirs(os.path.dirname(target), exist_ok=True)
        os.symlink(goal, target)
    except OSError:
        return False
    return True
