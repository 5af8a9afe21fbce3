"""Sources that the build makes of a template: ``configure_file(node.cpp.in node.cpp)``, read as CMake would write them.

Such a source keeps the path and the lines of its template, so that each fact is found where someone wrote it. A template in which a
variable is not known is no source: what would stand there is not invented.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.cmake_targets import Generated
from launchlint.workspace.looking import read_bytes

_LARGEST = 1 << 18
_PLACE = re.compile(r"@([A-Za-z_][\w./+-]{0,99})@|\$\{([A-Za-z_][\w./+-]{0,99})\}")
_ONLY_AT = re.compile(r"@([A-Za-z_][\w./+-]{0,99})@")
_DEFINES = re.compile(r"^[ \t]*#[ \t]*cmakedefine", re.MULTILINE)


class Template(NamedTuple):
    """A source file with what is put into it: pairs of what stands there (``@NAME@``) and its text."""

    path: str
    values: tuple[tuple[str, str], ...]

    def fill(self, text: str) -> str:
        """The text of the template with all that is known put in."""
        for place, value in self.values:
            text = text.replace(place, value)
        return text


def template_of(generated: Generated) -> Template | None:
    """What a ``configure_file`` makes; None where that cannot be known."""
    try:
        text = read_bytes(generated.template, _LARGEST).decode("utf-8", "replace")
    except OSError:
        return None
    if generated.literal:
        return Template(generated.template, ())
    values: dict[str, str] = {}
    length = len(text)
    for found in (_ONLY_AT if generated.only_at else _PLACE).finditer(text):
        value = generated.variables.get(found[found.lastindex or 1])
        length += len(value or "")
        if value is None or not value.isprintable() or "@" in value or "${" in value or length > _LARGEST:
            return None
        values[found[0]] = value
    return None if _DEFINES.search(text) else Template(generated.template, tuple(values.items()))


def filled(text: str, path: str, templates: Sequence[Template]) -> str:
    """The text of a file, which may be one of the templates."""
    return next((each.fill(text) for each in templates if each.path == path), text)
