"""What may be written at a place: told from the text in front of it, which need not be well-formed, and from what was known last."""

from __future__ import annotations

import os
import re

from launchlint.ide.args import declared
from launchlint.ide.context import Context, context_at
from launchlint.ide.files import package_of, resolved
from launchlint.ide.hover import instance_of
from launchlint.ide.ros2.context import XML_NAMES, keywords, python_context, yaml_context
from launchlint.ide.tables import Tables
from launchlint.ide.view import View
from launchlint.model import ROS1
from launchlint.named_tuple import NamedTuple
from launchlint.source import Span
from launchlint.workspace.discovery import may_be_launch_file
from launchlint.workspace.executables import ExecutableIndex
from launchlint.workspace.listing import files_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from typing import Literal

    from launchlint.graph.connections import Endpoint
    from launchlint.model import Node

    What = Literal["tag", "attribute", "value", "package", "executable", "file", "arg", "substitution", "name", "param"]

MOST_FILES = 400


class Choice(NamedTuple):
    """Something that may be written at ``span``: ``text``, where ``snippet`` with places to fill in; ``rank`` says what comes first."""

    label: str
    what: What
    span: Span
    text: str
    detail: str = ""
    snippet: bool = False
    rank: int = 5


def completion(view: View, offset: int) -> list[Choice]:
    """What may be written at ``offset``, in order."""
    found = dict.fromkeys(_choices(view, context_in(view, offset)))
    return sorted(found, key=lambda each: (each.rank, each.label))


def context_in(view: View, offset: int) -> Context:
    """What is being written at ``offset``, whatever the file is written in."""
    if view.file.endswith((".yaml", ".yml")):
        return yaml_context(view.text, offset)
    return python_context(view.text, offset, view.session.distro) if view.file.endswith(".py") else context_at(view.text, offset)


def _choices(view: View, context: Context) -> Iterator[Choice]:
    if context.command is not None:
        yield from _substitution(view, context)
    elif context.kind == "tag":
        yield from _tags(view, context)
    elif context.kind == "close":
        yield Choice(f"/{context.parent}", "tag", context.span, f"/{context.parent}>", rank=0)
    elif context.kind == "attribute":
        yield from _attributes(view, context)
    elif context.kind == "value":
        yield from _values(view, context)


# -- $(…) --------------------------------------------------------------------------------------------------------


def _substitution(view: View, context: Context) -> Iterator[Choice]:
    command = context.command or ""
    if not command:
        for word in _commands(view):
            yield Choice(word, "substitution", context.span, word if word == "dirname" else f"{word} ", detail=f"$({word} …)")
        return
    if command in ("arg", "var"):
        for name, required, said in declared(view, view.file):
            yield Choice(name, "arg", context.span, name, detail="required" if required else said, rank=1)
        element_args = {each.name for each in view.mentions if each.kind == "arg" and each.role == "declares"}
        for name in sorted(element_args - {each[0] for each in declared(view, view.file)}):
            yield Choice(name, "arg", context.span, name, rank=2)
    elif command.startswith("find"):
        yield from _packages(view, context.span)


def _commands(view: View) -> Iterable[str]:
    if view.dialect.name == ROS1:
        from launchlint.ide.ros1.tables import commands

        return commands()
    from launchlint.ide.ros2.tables import commands as commands_of_ros2

    return commands_of_ros2(view.session.distro)


# -- markup ------------------------------------------------------------------------------------------------------


def _tags(view: View, context: Context) -> Iterator[Choice]:
    if view.file.endswith((".yaml", ".yml")):
        for name, attributes, _ in _table(view).tags(context.parent):
            lines = "".join(f"\n    {each}: ${number}" for number, each in enumerate(attributes, 1))
            yield Choice(name, "tag", context.span, f"{name}:{lines}" if lines else f"{name}:\n    ", detail=f"{name}:", snippet=True)
        return
    for name, attributes, holds in _table(view).tags(context.parent):
        places = " ".join(f'{each}="${number}"' for number, each in enumerate(attributes, 1))
        last = len(attributes) + 1
        head = f"{name} {places}" if places else name
        body = f"{head}>${last}</{name}>" if holds else f"{head}/>"
        yield Choice(name, "tag", context.span, body, detail=f"<{name}>", snippet=True)
    if context.parent:
        yield Choice(f"/{context.parent}", "tag", context.span, f"/{context.parent}>", rank=9)


def _attributes(view: View, context: Context) -> Iterator[Choice]:
    if view.file.endswith(".py"):
        for name, needed in keywords(context.tag, view.session.distro).items():
            if name not in context.attributes and XML_NAMES.get(name, name) not in context.attributes:
                first = needed or name in XML_NAMES
                yield Choice(name, "attribute", context.span, f"{name}=", detail="required" if needed else "", rank=1 if first else 5)
        return
    if view.file.endswith((".yaml", ".yml")):
        table = _table(view)
        for name, required, expected in table.attributes(context.tag, context.parent):
            if name not in context.attributes:
                said = ("required, " if required else "") + expected
                yield Choice(name, "attribute", context.span, f"{name}: ", detail=said, rank=1 if required else 5)
        for name, attributes, _ in table.tags(context.tag):
            leading = attributes[0] if attributes else "name"
            yield Choice(name, "tag", context.span, f"{name}:\n    - {leading}: $1", detail=f"{name}: several", snippet=True, rank=6)
        return
    for name, required, expected in _table(view).attributes(context.tag, context.parent):
        if name not in context.attributes:
            yield Choice(
                name, "attribute", context.span, f'{name}="$1"', detail=("required, " if required else "") + expected, snippet=True,
                rank=1 if required else 5,
            )  # fmt: skip


def _table(view: View) -> Tables:
    if view.dialect.name == ROS1:
        from launchlint.ide.ros1.tables import TABLES

        return TABLES
    from launchlint.ide.ros2.tables import TablesOfRos2

    return TablesOfRos2(view.session.distro)


# -- values ------------------------------------------------------------------------------------------------------


def _values(view: View, context: Context) -> Iterator[Choice]:
    tag, attribute, span = context.tag, context.attribute, context.span
    for value in _table(view).values(tag, attribute):
        yield Choice(value, "value", span, value, rank=1)
    if attribute in ("pkg", "package"):
        yield from _packages(view, span)
    elif attribute in ("type", "exec", "plugin") and context.attributes.get("pkg"):
        yield from _executables(view, context.attributes["pkg"], span, loaded=attribute == "plugin")
    elif attribute in ("file", "from", "textfile") and tag in ("include", "rosparam", "param"):
        yield from _files(view, span, launch=tag == "include")
    elif tag == "arg" and attribute == "name" and context.parent == "include":
        file = _included(view, context)
        if file is not None:
            passed = set(context.siblings)
            for name, required, said in declared(view, file):
                if name not in passed:
                    yield Choice(name, "arg", span, name, detail="required" if required else said, rank=0 if required else 5)
    elif tag == "remap" and attribute in ("from", "to"):
        yield from _names(view, context)
    elif tag == "param" and attribute == "name":
        yield from _params(view, context)
    elif (tag == "var" and attribute == "variable_name") or (tag == "let" and attribute == "name"):
        for name, required, said in declared(view, view.file):
            yield Choice(name, "arg", span, name, detail="required" if required else said, rank=1)
    elif attribute in ("if", "unless"):
        command = "arg" if view.dialect.name == ROS1 else "var"
        for name, _, said in declared(view, view.file):
            yield Choice(f"$({command} {name})", "arg", span, f"$({command} {name})", detail=said)


def _packages(view: View, span: Span) -> Iterator[Choice]:
    packages = view.snapshot.packages if view.dialect.name == ROS1 else view.snapshot.packages.colcon
    own = packages.package_of(view.file)
    here = set(packages.names())
    for name in sorted(here | set(view.snapshot.library.of_launch(view.dialect.name).packages())):
        rank = 0 if own is not None and own.name == name else 2 if name in here else 6
        yield Choice(name, "package", span, name, rank=rank)


def _executables(view: View, package: str, span: Span, *, loaded: bool) -> Iterator[Choice]:
    home = package_of(view, package)
    if home is not None:
        found = view.snapshot.packages.once(ExecutableIndex).executables(home)
        for name in found.nodelet_classes if loaded else found.programs:
            yield Choice(name, "executable", span, name, detail=package, rank=1)
    library = view.snapshot.library.of_launch(view.dialect.name)
    for name in library.nodelets(package) if loaded else library.executables(package):
        yield Choice(name, "executable", span, name, detail=package, rank=2)


def _files(view: View, span: Span, *, launch: bool) -> Iterator[Choice]:
    """Files of the file's own package and of those in the workspace, as they are named in it."""
    packages = view.snapshot.packages if view.dialect.name == ROS1 else view.snapshot.packages.colcon
    own = packages.package_of(view.file)
    find = "find" if view.dialect.name == ROS1 else "find-pkg-share"
    for place in packages.places[: len(packages.workspaces)]:
        for package in place.everything:
            for path in _listed(package.directory, launch=launch):
                text = f"$({find} {package.name})/{path}"
                yield Choice(text, "file", span, text, rank=1 if own is not None and own.name == package.name else 4)


def _listed(directory: str, *, launch: bool) -> Iterator[str]:
    files, _ = files_of(directory)
    found = 0
    for name in files:
        path = name.replace(os.sep, "/")
        wanted = may_be_launch_file(path) if launch else path.endswith((".yaml", ".yml", ".urdf", ".xacro", ".json", ".txt"))
        if wanted and found < MOST_FILES:
            found += 1
            yield path


def _included(view: View, context: Context) -> str | None:
    """The file that the ``<include>`` around the place names."""
    text = context.outer.get("file", "")
    return resolved(view, text) if text else None


def _node_around(view: View, context: Context) -> Node | None:
    name = context.outer.get("name")
    return next((node for node in view.nodes if node.name == name), None) if name else None


def _names(view: View, context: Context) -> Iterator[Choice]:
    """In ``from`` the names of the node; in ``to`` those on the graph, of a fitting type first."""
    node = _node_around(view, context)
    found = None if node is None else instance_of(view, node)
    if context.attribute == "from":
        for endpoint in () if found is None else found[1].endpoints:
            if not endpoint.is_plumbing:
                yield Choice(endpoint.declared, "name", context.span, endpoint.declared, detail=f"{endpoint.role} {endpoint.type}", rank=1)
        return
    source = context.attributes.get("from", "")
    mine = [] if found is None else [each for each in found[1].endpoints if source in (each.declared, each.declared.lstrip("~/"))]
    for configuration in view.configurations:
        graph = configuration.graph
        for channel in () if graph is None else graph.channels.values():
            if not channel.is_plumbing:
                ends = (*channel.offers, *channel.uses)
                type_ = next((each.type for each in ends if each.type not in ("", "*")), "")
                rank = 1 if any(_fits(each, channel.kind, type_) for each in mine) else 5
                name = channel.name
                yield Choice(name, "name", context.span, name, detail=f"{channel.kind} {type_}", rank=rank)


def _fits(endpoint: Endpoint, kind: str, type_: str) -> bool:
    return endpoint.kind == kind and (endpoint.type in ("", "*") or endpoint.type == type_)


def _params(view: View, context: Context) -> Iterator[Choice]:
    node = _node_around(view, context)
    found = None if node is None else instance_of(view, node)
    for reading in () if found is None else found[1].readings:
        declaration = reading.declaration
        said = " ".join(filter(None, (declaration.type, "" if declaration.default is None else f"default {declaration.default}")))
        name = re.sub(r"^~", "", reading.declared)
        yield Choice(name, "param", context.span, name, detail=said, rank=1)
