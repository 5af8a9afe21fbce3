"""Finding launch files below the paths a person gives."""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence

from launchlint.errors import UsageError
from launchlint.workspace.reading import stand_ins

_ENDS = (".launch", ".launch.xml")
_TEST_END = ".test"
_APPLE_DOUBLE = "._"
"""What macOS writes beside a file on other file systems, under the same name with this before it: its attributes."""
_XML_END = ".xml"
_YAML_ENDS = (".launch.yaml", ".launch.yml", "_launch.yaml", "_launch.yml")
_SAID_TO_BE = (*_ENDS, ".launch.yaml", ".launch.yml")
PYTHON_END = ".launch.py"
_PYTHON_ENDS = (PYTHON_END, "_launch.py")
_DESCRIBES = b"def generate_launch_description("
_TEST_MODULE = "test_"
_TESTS = (b"\ndef test_", b"\nclass Test")
_LAUNCHES = (_DESCRIBES, b"generate_test_description")
# Files that are never launch files, and so frequent that looking into each would be felt.
_OTHER_XML = frozenset(("package.xml", "manifest.xml", "stack.xml", "plugin_description.xml"))

# What catkin and colcon write: directories of that kind hold copies of launch files.
_BUILT_MARKERS = (".catkin", ".built_by", ".colcon_install_layout")
_BUILT_NAMES = ("build", "devel", "install", "log", "logs")
_BUILT_NAME_MARKERS = (
    *_BUILT_MARKERS,
    "CMakeCache.txt",
    "COLCON_IGNORE",
    "_setup_util.py",
    ".catkin_tools.yaml",
    "catkin_make.cache",
    "local_setup.sh",
)

# What catkin_make and catkin tools leave where they are called, and the directories that they write beside it.
_WORKSPACE_MARKERS = (".catkin_workspace", ".catkin_tools")
_BUILT_SPACES = ("build", "devel", "install")

_SNIFFED = 8 << 10
_MOST_DIRECTORIES = 100_000


def discover(paths: Sequence[str], exclude: Sequence[str] = (), base: str | None = None) -> list[str]:
    """Launch files at and below ``paths``, sorted, each once.

    Taken are files named ``*.launch`` and ``*.launch.xml``, files named ``*.test`` and ``*.xml`` that have ``<launch>`` as root, those
    named ``*.launch.yaml``, ``*_launch.yaml`` and the like that have the key ``launch``, and those in Python (:func:`is_in_python`).
    Left out are hidden directories, what macOS keeps beside a file (``._arm.launch``), and the build, devel, install and log directories
    of catkin and colcon. Links to directories are followed, but no directory is searched twice.

    Args:
        paths: files, which are always taken whatever their name, and directories.
        exclude: patterns (see :mod:`launchlint.workspace.patterns`) of files and directories below ``paths`` to leave out.
        base: the directory that patterns with a slash are relative to; the current directory where not given.

    Returns:
        Paths in the spelling of ``paths``, without ``./`` and the like.

    Raises:
        UsageError: one of ``paths`` does not exist.
    """
    root = os.path.abspath(base or os.curdir)
    found: dict[str, str] = {}
    seen: set[tuple[int, int]] = set()
    for path in paths:
        try:
            mode = os.stat(path).st_mode
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise UsageError(f"{path}: {reason}; give launch files, or directories to search for them") from error
        if not stat.S_ISDIR(mode):
            found.setdefault(os.path.abspath(path), os.path.normpath(path))
            continue
        here = os.getcwd()
        for file in _walk(os.path.normpath(path), exclude, root, seen):
            found.setdefault(absolute(file, here), file)
    return sorted(found.values())


def absolute(path: str, here: str) -> str:
    """As ``os.path.abspath`` in the directory ``here``, sooner for a path in the form that :func:`discover` gives."""
    if os.sep != "/" or path[:1] in ("", ".", "/"):
        return os.path.normpath(os.path.join(here, path))
    return f"{here}/{path}"


def is_launch_file(path: str) -> bool:
    """Whether the file at ``path`` is a launch file by its name and, where the name leaves it open, by its content.

    Of a file that is open in an editor that is the text there; if it is called a launch file in so many words it is one, whatever it holds.
    """
    if path.endswith((*_ENDS, *_PYTHON_ENDS)) and not _may_be_test_module(path):
        return True
    if not may_be_launch_file(path):
        return False
    text = stand_ins().get(os.path.abspath(path)) if stand_ins() else None
    if text is not None:
        return is_launch_text(path, text)
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except OSError:
        return False
    try:
        start = os.read(descriptor, _SNIFFED)
    except OSError:
        return False
    finally:
        os.close(descriptor)
    return is_launch_content(path, start)


def is_launch_text(path: str, text: bytes) -> bool:
    """As :func:`is_launch_file` for a file that is open in an editor and holds ``text``."""
    return path.endswith(_SAID_TO_BE) or is_launch_content(path, text)


def _may_be_test_module(path: str) -> bool:
    """Whether a file of this name may be one that pytest collects: tests of launch files are called like launch files."""
    return path.endswith(_PYTHON_ENDS) and os.path.basename(path).startswith(_TEST_MODULE)


def is_in_python(path: str) -> bool:
    """Whether a file of this name is a launch file of ROS 2 in Python."""
    return path.endswith(_PYTHON_ENDS)


def holds_python(path: str, data: bytes) -> bool:
    """Whether a launch file whose name leaves open what it is written in, ``x.launch``, holds Python, which launch tries after XML and YAML
    (launch.launch_description_sources.any_launch_file_utilities).
    """
    if _DESCRIBES not in data or path.endswith((_XML_END, ".yaml", ".yml")):
        return False
    return (data.startswith(_DESCRIBES) or b"\n" + _DESCRIBES in data) and data.lstrip()[:1] != b"<"


def is_program(path: str, data: bytes) -> bool:
    """Whether a launch file is in Python: by its name or, where that leaves it open, by what it holds."""
    return path.endswith(".py") or holds_python(path, data)


def may_be_launch_file(path: str) -> bool:
    """Whether a file of this name can be a launch file."""
    return path.endswith((*_ENDS, _TEST_END, _XML_END, *_YAML_ENDS, *_PYTHON_ENDS)) and os.path.basename(path) not in _OTHER_XML


def is_launch_content(path: str, content: bytes) -> bool:
    """Whether a file that may be a launch file by its name is one, with what it holds (its beginning is enough)."""
    if path.endswith((*_ENDS, *_PYTHON_ENDS)):
        return not _may_be_test_module(path) or not any(each in content for each in _TESTS) or any(each in content for each in _LAUNCHES)
    from launchlint.workspace.launch_root import has_launch_key, has_launch_root

    if path.endswith(_YAML_ENDS):
        return has_launch_key(content[:_SNIFFED])
    # A test file may be broken, and is then still meant to be one; an XML file with another root is simply something else.
    return has_launch_root(content[:_SNIFFED]) or (path.endswith(_TEST_END) and b"<launch" in content[:_SNIFFED])


def _walk(start: str, exclude: Sequence[str], base: str, seen: set[tuple[int, int]]) -> list[str]:
    """Launch files below the directory ``start``; real directories first, then what links lead to elsewhere."""
    from launchlint.workspace.patterns import matches_any

    found: list[str] = []
    pending = [start]
    links: list[str] = []
    visited = 0
    while pending or links:
        directory = pending.pop() if pending else links.pop(0)
        visited += 1
        if visited > _MOST_DIRECTORIES:
            break
        try:
            status = os.stat(directory)
            with os.scandir(directory) as scan:
                entries = sorted(scan, key=lambda entry: entry.name)
        except OSError:
            continue
        key = (status.st_dev, status.st_ino)
        if directory != start and key in seen:
            continue
        seen.add(key)
        names = {entry.name for entry in entries}
        if directory != start and _is_built(os.path.basename(directory), names):
            continue
        for entry in entries:
            path = entry.name if directory == os.curdir else os.path.join(directory, entry.name)
            if entry.name in _BUILT_SPACES and not names.isdisjoint(_WORKSPACE_MARKERS):
                continue
            if exclude and matches_any(exclude, _relative(path, base)):
                continue
            try:
                if not entry.is_dir():
                    if not entry.name.startswith(_APPLE_DOUBLE) and is_launch_file(path) and entry.is_file():
                        found.append(path)
                elif entry.name[0] != ".":
                    if not entry.is_symlink():
                        pending.append(path)
                    elif not _leads_up(path):
                        links.append(path)
            except OSError:
                continue
    return found


def _is_built(name: str, names: set[str]) -> bool:
    """Whether a directory of this name with these entries was written by catkin or colcon."""
    if not names.isdisjoint(_BUILT_MARKERS):
        return True
    kind = name.replace("-", "_").split("_", 1)[0]
    return kind in _BUILT_NAMES and not names.isdisjoint(_BUILT_NAME_MARKERS)


def _leads_up(link: str) -> bool:
    """Whether a link leads to a directory that it stands in, or to one above the current directory (such as ``/``)."""
    target = os.path.realpath(link)
    return any(
        (each + "/").startswith(target.rstrip("/") + "/") for each in (os.path.realpath(os.path.dirname(link)), os.path.realpath(os.curdir))
    )


def _relative(path: str, base: str) -> str:
    return os.path.relpath(os.path.abspath(path), base).replace(os.sep, "/")
