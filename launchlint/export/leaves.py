"""The tags that do something by themselves: nodes and tests, params, rosparam steps, machines; and the settings that act on nodes."""

from __future__ import annotations

from collections.abc import Callable

from launchlint.evaluate.names import canonical
from launchlint.evaluate.ros1.scope import Context
from launchlint.export.frame import Frame
from launchlint.export.names import below, open_namespace
from launchlint.export.tree import Note, Out, Piece
from launchlint.export.written import Condition, Fixed, Setting, Written
from launchlint.syntax.ros1.dialect import PARAM_SOURCES, TAGS
from launchlint.syntax.ros1.domains import parse_flag
from launchlint.syntax.ros1.substitutions import parse
from launchlint.syntax.tree import Comment, Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import TypeAlias

    Test: TypeAlias = Callable[[Frame, Element], tuple[Condition | None, bool]]

CONDITIONS = ("if", "unless")


def in_order(frame: Frame, parent: Element) -> list[Element | Comment]:
    """The children of ``parent`` and the comments in it, as they stand."""
    both: list[Element | Comment] = [*parent.children, *frame.plan.comments_in(frame.evaluation.document, parent)]
    return sorted(both, key=lambda piece: piece.span.start)


def line_ends(frame: Frame, end: int, piece: Element | Comment) -> int:
    """How many line ends stand between the offset ``end`` and ``piece``."""
    return frame.evaluation.document.source.text.count("\n", end, piece.span.start)


def flag(frame: Frame, element: Element, name: str) -> bool:
    """A true/false attribute that has to be decided now. Raises Fixed where it is open."""
    attribute = element.attributes.get(name)
    if attribute is None:
        return False
    written = frame.written(attribute.value)
    if written.sources:
        raise Fixed(written.sources, f"it decides the {name} of an element")
    try:
        return parse_flag(written.known)
    except ValueError:
        return False


def machine(frame: Frame, element: Element, condition: Condition | None) -> None:
    """A ``<machine>``: as it is, since it acts beyond its scope anyway. Names that ``$(anon)`` makes up in it are known there only."""
    frame.out.append(Out("machine", _attributes(frame, element, (), Context("/", frame.context)), condition))
    _count(frame)


def setting(frame: Frame, element: Element, condition: Condition | None, context: Context | None = None) -> Setting:
    """A ``remap`` or ``env``, wherever it stands."""
    first = "from" if element.tag.lower() == "remap" else "name"
    second = "to" if first == "from" else "value"
    key, value = (frame.written(element.get(name) or "", context) for name in (first, second))
    if context is None:  # it acts on several nodes, which all have the same name of it
        key, value = frame.settled("name", key), frame.settled("value", value)
    spelling = "" if key.sources or key.anonymous else canonical(key.known)
    return Setting(element.tag.lower(), ((first, key.text), (second, value.text)), spelling, condition)


def param(frame: Frame, element: Element, condition: Condition | None) -> Setting | None:
    """A ``<param>`` outside nodes; a ``~param`` is returned, to be put into the nodes that follow."""
    name = frame.written((element.get("name") or "").strip())
    attributes = _attributes(frame, element, ("name",))
    if not name.known.startswith("~"):
        frame.out.append(Out("param", {"name": below(frame.namespace, name), **attributes}, condition))
        _count(frame)
        return None
    for source in PARAM_SOURCES:
        if source in attributes and any(parse(attributes[source]).substitutions("anon")):
            attributes[source] = frame.settled("value", frame.written(element.get(source) or "")).text
    pairs = tuple({"name": name.text.removeprefix("~"), **attributes}.items())
    return Setting("param", pairs, "" if name.sources else canonical(name.known), condition)


def node(frame: Frame, element: Element, condition: Condition | None, test: Test) -> None:
    """A ``<node>`` or ``<test>`` with everything that acts on it; ``test`` tells whether a child is evaluated."""
    out = Out(element.tag, _attributes(frame, element, ("ns",)), condition)
    block = None
    namespace = frame.namespace
    attribute = element.attributes.get("ns")
    if attribute is not None:
        written = frame.written(attribute.value)
        if written.sources and namespace:
            block, namespace = open_namespace(namespace), written.text
        else:
            namespace = below(namespace, written)
    if namespace:
        out.attributes["ns"] = namespace.rstrip("/") or "/"
    context = frame.context
    own = _own(frame, element, test, Context("/", context))
    last = {(each.tag, each.key) for each in own if isinstance(each, Setting) and each.key and each.condition is None}
    private = [each for each in frame.inherited if not each.key or all(each.key != mine.key or mine.condition for mine in frame.private)]
    for each in (*frame.environment, *frame.remaps, *private, *frame.private):
        if each.tag == "env" or (each.tag, each.key.removeprefix("~")) not in last:
            out.children.append(_repeated(each))
    out.children += [_repeated(each) if isinstance(each, Setting) else each for each in own]
    for piece in out.children:
        frame.plan.spend(" ".join(piece.attributes.values()) if isinstance(piece, Out) else piece.text)
    if block is not None:
        block.children, out = [out], block
    frame.out.append(out)
    _count(frame)


def _own(frame: Frame, element: Element, test: Test, values: Context) -> list[Setting | Piece]:
    """The children of a node, in order. Names that ``$(anon)`` makes up in params, or in env, are known there only."""
    found: list[Setting | Piece] = []
    inside = Context("/", frame.context)
    end, shown = element.start_span.end, True
    for piece in in_order(frame, element):
        lines, end = line_ends(frame, end, piece), piece.span.end
        if isinstance(piece, Comment):
            if lines or shown:
                found.append(Note(piece.text, beside=not lines and bool(found)))
            continue
        shown = False
        tag = piece.tag.lower()
        if tag not in ("remap", "param", "rosparam", "env"):
            continue
        frame.evaluation.look_at(piece)
        own, met = test(frame, piece)
        if own is None and not met:
            while found and isinstance(found[-1], Note) and not found[-1].beside:
                found.pop()
            continue
        shown = True
        outer = frame.doubt
        if own is not None and not own.taken:
            frame.doubt = outer | own.written.sources
        try:
            if tag == "param":
                name = frame.written((piece.get("name") or "").strip(), values)
                attributes = {"name": name.text, **_attributes(frame, piece, ("name",), values)}
                key = "" if name.sources or name.anonymous else canonical(name.known)
                found.append(Setting("param", tuple(attributes.items()), key, own))
            elif tag == "rosparam":
                made = _rosparam(frame, piece, own, values, "")
                if made is not None:
                    found.append(made)
            else:
                found.append(setting(frame, piece, own, inside if tag == "env" else frame.context))
        finally:
            frame.doubt = outer
    return found


def _repeated(each: Setting) -> Out:
    return Out(each.tag, dict(each.attributes), each.condition)


def _attributes(frame: Frame, element: Element, without: tuple[str, ...], context: Context | None = None) -> dict[str, str]:
    """The attributes that mean something to roslaunch, as they are written in the exported file."""
    known = TAGS[element.tag.lower()].known
    found = {}
    for name, attribute in element.attributes.items():
        if name in known and name not in without and name not in CONDITIONS:
            literal = name == "type" and element.tag.lower() == "param"  # roslaunch resolves nothing in it
            found[name] = attribute.value if literal else frame.written(attribute.value, context).text
            frame.plan.spend(found[name])
    return found


def rosparam(frame: Frame, element: Element, condition: Condition | None) -> None:
    """A ``<rosparam>`` outside nodes."""
    made = _rosparam(frame, element, condition, None, frame.namespace)
    if made is not None:
        frame.out.append(made)
        _count(frame)


def _rosparam(frame: Frame, element: Element, condition: Condition | None, context: Context | None, namespace: str) -> Out | None:
    """The parameters of its file, or its own, as text in the element; dump and delete steps as they are."""
    values = {name: frame.written(element.get(name) or "", context) for name in ("command", "ns", "param", "file")}
    command = values["command"]
    if command.sources:
        raise Fixed(command.sources, "it decides what a rosparam does")
    name, ns = values["param"], values["ns"]
    if ns.text and name.text:
        name = Written(below(ns.text, name), below(ns.known, Written(name.known, name.known)))
    inner = name if name.text else ns
    full = below(namespace, inner) if inner.text else namespace.rstrip("/") or namespace[:1]
    attributes = {"param": full} if full else {}
    if command.known in ("dump", "delete"):
        if not name.text and full and not full.endswith(("/", "~")):
            attributes["param"] = full + "/"  # as roslaunch joins a namespace with no name
        file = {"file": values["file"].text} if "file" in element.attributes else {}
        return Out("rosparam", {"command": command.known, **file, **attributes}, condition)
    if not inner.text and full == "/":
        attributes = {}
    if values["file"].sources:
        subst = {name: "true" for name in ("subst_value",) if flag(frame, element, name)}
        if subst:
            raise Fixed(values["file"].sources, f"{element.get('file')} decides which parameters are loaded")
        return Out("rosparam", {"command": "load", "file": values["file"].text, **attributes}, condition)
    text = _yaml(frame, element, values["file"].known)
    if flag(frame, element, "subst_value"):
        written = frame.written(text, context)
        text = written.text
        if parse(text).computed:
            attributes["subst_value"] = "true"
    if not text.strip() and frame.plan.angles:
        return None
    frame.plan.angles = True
    frame.plan.spend(text)
    out = Out("rosparam", attributes, condition)
    out.text = text
    return out


def _yaml(frame: Frame, element: Element, file: str) -> str:
    if "file" not in element.attributes:
        return element.text
    content = frame.plan.session.read(file)
    try:
        if content.data is not None:
            return content.data.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError:
        pass
    raise Fixed(frame.doubt, f"{frame.plan.session.shown(file)} cannot be read, and only the side that is not taken needs it")


def _count(frame: Frame) -> None:
    """An element has been exported: take note of the anonymous names in it."""
    for identity in frame.plan.touched:
        frame.plan.made[identity] = frame.plan.made.get(identity, 0) + 1
    frame.plan.touched.clear()
