"""Directories for what is no longer used: `old`, `graveyard`, `deprecated`, or where the manifest was renamed."""

from __future__ import annotations

import re

from launchlint.late import late
from launchlint.spelling import switched_off
from launchlint.workspace.looking import names as names_in

_ASIDE = late(
    r"(?:.*[_. -])?(?:deprecated|discontinued|obsolete|outdated|unused|not_?used|archives?|archived|backups?|bak|bkp|old|attic|trash"
    r"|graveyard)"
    r"|(?:deprecated|discontinued|obsolete|outdated|unused|archived|old|not|do_not)[_. -].*"
    r"|(?:backups?|bak|bkp)[_. -](?:.*[_. -])?(?:packages|pkgs?|files?|launch(?:es)?|scripts?|code|src|configs?|workspace|ws|\d+)",
    re.IGNORECASE,
)
"""Names of directories for what is no longer used: `backup_packages`, too; `backup_camera` and `archive_tools` are none."""
_FILE_ASIDE = late(
    r".*[_. (-](?:deprecated|discontinued|obsolete|outdated|unused|not_?used|backup|bak|bkp|old)\)?(?:\.launch)?(?:\.\w+)?"
    r"|(?:deprecated|discontinued|obsolete|outdated|unused|not_?used|old)[_-].*",
    re.IGNORECASE,
)
"""Names of launch files that are not used any longer: `arm_old.launch`, `old_arm.launch`, `arm(bak).launch`, `arm.bak.launch`."""
_ENDS = (".launch", ".xml", ".test", ".launch.py", ".launch.yaml")

_MANIFESTS = ("package.xml", "manifest.xml")


def put_aside(path: str) -> str:
    """The directory on the way to ``path`` (with ``/``) that says so, or the launch file itself; empty where none does."""
    *parts, name = path.split("/")
    number = next((number for number, part in enumerate(parts, 1) if _ASIDE.fullmatch(part)), 0)
    return path if not number and name.endswith(_ENDS) and _FILE_ASIDE.fullmatch(name) else "/".join(parts[:number])


def renamed_manifest(directory: str) -> str:
    """The file in ``directory`` that was its manifest (``unusedmanifest.xml``, ``package.xml~``); empty where it has one, or none was."""
    listed = names_in(directory)
    if any(each in _MANIFESTS for each in listed):
        return ""
    renamed = next((each for each in listed if switched_off(each, _MANIFESTS)), "")
    return renamed or next((each for each in listed if each.rstrip("~") in _MANIFESTS), "")


def is_out_of_use(path: str, near: str) -> bool:
    """Whether ``path`` lies in such a directory that does not hold ``near`` too: nobody who writes of ``near`` means it any more."""
    parts, beside = path.split("/")[:-1], near.split("/")[:-1]
    shared = next((at for at, (one, other) in enumerate(zip(parts, beside, strict=False)) if one != other), min(len(parts), len(beside)))
    return any(_ASIDE.fullmatch(part) for part in parts[shared:])
