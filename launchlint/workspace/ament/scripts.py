"""Programs written in Python that an installation makes: entry points, and where ``setup.cfg`` has them put."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from configparser import ConfigParser, Error

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import content, is_file

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.cmake_scope import Value

SETUP_CFG = "setup.cfg"

_ENTRY = late(r"\s*([^=\s\[#;](?:[^=]*[^=\s])?)\s*=\s*([\w.]+)\s*(?::\s*([\w.]+)\s*)?(?:\[.*\]\s*)?")
_MOST_LINES = 5_000
"""A longer file is not read: the parser tells the mistakes of all lines in one text, which it writes anew for each."""
_BASES = ("$base/", "$platbase/", "$prefix/", "$userbase/")


class Script(NamedTuple):
    """A program: its name, the files (absolute) it is known to be made from, the directory below the prefix; ``None`` if not known.

    ``entry`` is the ``module:function`` that an entry point names.
    """

    name: str
    sources: tuple[str, ...]
    destination: Value
    entry: str = ""


class SetupCfg(NamedTuple):
    """What ``setup.cfg`` says.

    ``destination`` is the directory below the prefix that programs are installed to; ``None`` where it is not known. ``scripts`` are the
    lines of ``console_scripts``. ``more`` says that it describes files or programs in a way that is not read here.
    """

    destination: Value
    scripts: tuple[str, ...]
    more: bool


def read_setup_cfg(path: str) -> SetupCfg | None:
    """The ``setup.cfg`` at ``path``; ``None`` where it is there and cannot be read."""
    if not is_file(path):
        return SetupCfg("bin", (), False)
    data = content(path)
    if data is not None and data.count(b"\n") > _MOST_LINES:
        return None
    parser = ConfigParser(interpolation=None, strict=False)
    parser.optionxform = str  # type: ignore[method-assign, assignment]
    try:
        parser.read_string((data or b"").decode("utf-8"))
    except (Error, UnicodeDecodeError):
        return None
    if data is None:
        return None
    sections = {section: {key.replace("-", "_"): value for key, value in parser.items(section)} for section in parser.sections()}
    install, develop = sections.get("install", {}), sections.get("develop", {})
    given = install.get("install_scripts")
    if given is None:
        # An installation with links reads [develop], one without reads [install]: with one of them only it depends.
        destination: Value = None if "script_dir" in develop or "prefix" in install else "bin"
    else:
        base = next((each for each in _BASES if given.startswith(each)), None)
        destination = None if base is None or "$" in given[len(base) :] else given[len(base) :].strip().rstrip("/")
    points = sections.get("options.entry_points", {})
    lines = [each for group in ("console_scripts", "gui_scripts") for each in points.get(group, "").splitlines() if each.strip()]
    more = "options.data_files" in sections or "scripts" in sections.get("options", {}) or "files" in sections
    return SetupCfg(destination, tuple(lines), more)


def entry_points(lines: Iterable[object], directory: str, destination: Value) -> list[Script]:
    """Programs of ``name = module:function`` lines.

    Raises:
        ValueError: one of them is not of that form.
    """
    found: list[Script] = []
    for line in lines:
        match = _ENTRY.fullmatch(line) if isinstance(line, str) else None
        if match is None:
            raise ValueError(f"the entry point {str(line)[:100]!r} is not understood")
        found.append(Script(match[1], tuple(_module(match[2], directory)), destination, f"{match[2]}:{match[3] or ''}"))
    return found


def _module(dotted: str, directory: str) -> Iterator[str]:
    stem = os.path.join(directory, *dotted.split("."))
    for path in (f"{stem}.py", os.path.join(stem, "__init__.py")):
        if is_file(path):
            yield path
            return
