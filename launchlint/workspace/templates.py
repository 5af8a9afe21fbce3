"""Templates: files that another file is made of, told by their names."""

from __future__ import annotations

import os

from launchlint.workspace.looking import is_file, names

_ENDS = (
    *(".in", ".em", ".empy", ".template", ".tmpl", ".tpl", ".j2", ".jinja", ".jinja2", ".erb", ".mako", ".mustache", ".xacro"),
    *(".dist", ".example", ".sample", ".default"),
)
"""What is put behind the name of the file that is made: ``robot.launch.in``; or before its own ending: ``robot.in.launch``."""
_XML_ENDS = (".urdf", ".srdf", ".sdf", ".xml", ".world", ".model")
_WORDS = ("template", "example", "sample")
"""What may stand at the end of its own name: ``robot_template.yaml``. A launch file ``robot_example.launch`` shows how to use another."""
_LAUNCH_ENDS = (".launch", ".xml", ".test")


def template_of(path: str) -> str | None:
    """The file beside ``path`` (absolute, not there) that it may be made of; ``None`` where there is none."""
    directory, name = os.path.split(path)
    stem, end = os.path.splitext(name)
    wanted = [f"{name}{each}" for each in _ENDS]
    if end:
        wanted += [f"{stem}{each}{end}" for each in _ENDS]
        wanted += [f"{stem}{mark}{word}{end}" for word in _WORDS for mark in "_-" if word == "template" or end not in _LAUNCH_ENDS]
    if end in _XML_ENDS:
        wanted += [f"{stem}{each}" for each in (".xacro", ".urdf.xacro", ".xml.xacro")]
    listed = set(names(directory))
    found = next((each for each in wanted if each in listed and is_file(os.path.join(directory, each))), None)
    return None if found is None else os.path.join(directory, found)
