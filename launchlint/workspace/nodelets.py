"""Nodelet plugin descriptions: which classes a package exports to nodelet managers.

Facts from pluginlib: ``<library path="…"><class name="pkg/Name" type="pkg::Name" base_class_type="nodelet::Nodelet">``, several libraries
inside ``<class_libraries>``; a class is looked up by its ``name``, or by its ``type`` where it has no name.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pyexpat import ExpatError, ParserCreate

from launchlint.late import late
from launchlint.named_tuple import NamedTuple
from launchlint.workspace.looking import read_bytes
from launchlint.workspace.package import Package

_DECLARATION = late(r"\A\s*<\?xml[^>]*\?>")


class NodeletClass(NamedTuple):
    """One class of a plugin description: its lookup name, its C++ type, its base class, the file that says so, and its library there."""

    name: str
    type: str
    base: str
    path: str
    library: str = ""


def read_nodelet_classes(package: Package) -> tuple[Mapping[str, NodeletClass], list[str]]:
    """The nodelet classes that ``package`` exports, sorted by name, and the reasons why there may be more. Never raises."""
    found: dict[str, NodeletClass] = {}
    reasons: list[str] = []
    if package.kind.is_broken:
        reasons.append(f"{os.path.basename(package.manifest_path)} cannot be used: {package.broken}")
    for path in package.nodelet_plugin_files:
        classes, reason = plugin_classes(path)
        for each in classes:
            found.setdefault(each.name, each)
        if reason:
            reasons.append(f"{os.path.relpath(path, package.directory)} {reason}")
    return dict(sorted(found.items())), reasons


def plugin_classes(path: str) -> tuple[list[NodeletClass], str]:
    """The classes of one description, and why it cannot be used (else empty)."""
    if not path.endswith(".xml"):  # the result cache knows plugin descriptions by their names
        return [], "is not called *.xml"
    try:
        return _parsed(read_bytes(path), path), ""
    except OSError as error:
        return [], f"cannot be read: {error.strerror or error}"
    except (ExpatError, ValueError, LookupError) as error:
        return [], f"is not well-formed XML: {error}"


def _parsed(data: bytes, path: str) -> list[NodeletClass]:
    # TinyXML, which pluginlib reads it with, takes several <library> elements in a row; so one element is put around them all.
    text = _DECLARATION.sub("", data.decode("utf-8-sig", "replace"), count=1)
    parser = ParserCreate("utf-8")
    found: list[NodeletClass] = []

    library = ""

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal library
        if tag == "library":
            library = attributes.get("path", "")
        elif tag == "class":
            name = attributes.get("name") or attributes.get("type", "")
            if name:
                found.append(NodeletClass(name, attributes.get("type", ""), attributes.get("base_class_type", ""), path, library))

    def declaration(*_: object) -> None:
        raise ValueError("it declares XML entities")

    parser.StartElementHandler = start
    parser.EntityDeclHandler = declaration
    parser.Parse(f"<class_libraries>{text}</class_libraries>", True)
    return found
