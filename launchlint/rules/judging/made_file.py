"""A file that is not here, and what makes it: the build, a template that somebody fills in, a node, or the robot."""

from __future__ import annotations

import posixpath

from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.other_file import shown
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.view import LaunchView
from launchlint.workspace.looking import Looked, content, exists, is_file, names, note, watched
from launchlint.workspace.packages import Packages


class Made(NamedTuple):
    """``why`` it can be told that the file is made (one line), and the ``help``."""

    why: str
    help: str


_DEEPEST = 60
_KEEPERS = (".gitkeep", ".keep", ".gitignore", ".gitattributes", ".placeholder", ".empty", "empty", "placeholder", "readme")
_MAP_ENDS = (".yaml", ".pgm", ".png")
_LAUNCH_ENDS = (".launch", ".xml", ".test")


def cause_of(path: str, maker: Made | None) -> str:
    """What several rules tell once: that the file at ``path`` (absolute) is not here, or the outermost directory that is not."""
    for _ in range(_DEEPEST):
        parent = posixpath.dirname(path)
        if parent == path or exists(parent):
            break
        path = parent
    return f"missing {path}" if maker is None else f"made {path}"


def malformed(file: str) -> str:
    """What LL101 tells of together with the includes that lead there: that ``file`` cannot be read. All empty files are alike."""
    text = content(file) if is_file(file) else None
    if text is not None and not text.strip():
        return "malformed, since it is empty"
    return f"malformed {posixpath.abspath(file)}"


def made(path: str, view: LaunchView, root: str) -> Made | None:
    """What makes the file at ``path`` (absolute), which is not here; ``None`` where nothing is known to.

    That is a submodule of git, a command of the package's CMake files, people who save a map, else a template beside it, else whatever
    makes what ``.gitignore`` names, else who fills a directory that is kept empty, else a node, else one of another launch file of the
    package.
    """
    known = view.packages.once(_told)
    key = path, root  # of all configurations alike
    if key not in known:
        known[key] = watched(lambda: _made_outside(path, view.packages, root))
    maker, looked = known[key]
    note(looked)
    if maker is not None:
        return maker
    from launchlint.rules.judging.made_by_node import maker_of

    node = maker_of(path, view)
    if node is None:
        return _made_before(path, view, root)
    place = f"{shown(node.file, root)}, line {node.line}"
    return Made(f"made by {node.program}, which is given {node.given} ({place})", f"let {node.program} make it before this is started")


def _made_before(path: str, view: LaunchView, root: str) -> Made | None:
    """As :func:`made`, by what other launch files of the package write."""
    from launchlint.rules.judging.made_by_launch import written_by

    step = written_by(path, view.launch.entry.file, view.packages)
    if step is None:
        return None
    file = shown(step.file, root)
    why = f"it is written by {file}: line {step.line} gives {step.program} the directory, and the name is given there, too"
    return Made(why, f"start {file} before this")


def _told(packages: Packages) -> dict[tuple[str, str], tuple[Made | None, Looked]]:
    """The answers given so far, and what they hang on."""
    return {}


def _made_outside(path: str, packages: Packages, root: str) -> Made | None:
    """As :func:`made`, but for what the launch files say."""
    from launchlint.workspace.ignored import ignored_by
    from launchlint.workspace.submodules import missing_submodule
    from launchlint.workspace.templates import template_of

    module = missing_submodule(path)
    if module is not None:
        name = shown(module, root)
        return Made(f"it is in the git submodule {name}, which is not checked out", f"git submodule update --init {name}")
    package = packages.package_of(path)
    how = None if package is None else contents(packages).made(package).by(path)
    if how is not None:
        return Made(f"the build makes it: {how}", "build the package before this is started")
    saved = _saved(path, packages)
    if saved is not None:
        return Made(f"people are told to make it with map_saver ({shown(saved, root)})", "make a map before this is started")
    template = template_of(path)
    if template is not None:
        name = shown(template, root)
        return Made(f"{name} lies beside it: a template from which it may be made", f"make it from {name} before this is started")
    ignore = ignored_by(path, packages.workspaces)
    if ignore is None:
        kept = _kept_empty(path)
        if kept is None:
            return None
        why = f"{shown(kept, root)} is all that its directory holds: what belongs there is put there on each machine"
        return Made(why, "see that it is there before this is started")
    why = f"git ignores it ({ignore.pattern} in {shown(ignore.file, root)}), so that it is made, or put there, on each machine"
    return Made(why, "see that it is there before this is started")


def _saved(path: str, packages: Packages) -> str | None:
    """The document that tells people to save a map under the name of ``path``."""
    stem, end = posixpath.splitext(posixpath.basename(path))
    return packages.map_saved_in(stem) if end in _MAP_ENDS else None


def _kept_empty(path: str) -> str | None:
    """The file that keeps the directory of ``path`` under version control, where it is all that is in there; launch files are no data."""
    directory, name = posixpath.split(path)
    if name.endswith(_LAUNCH_ENDS):
        return None
    listed = names(directory)
    return posixpath.join(directory, listed[0]) if 0 < len(listed) <= len(_KEEPERS) and all(map(_keeps, listed)) else None


def _keeps(name: str) -> bool:
    return posixpath.splitext(name)[0].lower() in _KEEPERS
