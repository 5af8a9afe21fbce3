"""Where a person must act to change a name on the graph, and how that name came about."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.finding import Finding, Location, Related
from launchlint.graph.connections import Endpoint, Instance
from launchlint.graph.names import Applied, absolute, kind
from launchlint.library.template import Slot, is_template, parse
from launchlint.library.terms import READ_FROM
from launchlint.model import Remap
from launchlint.rules.view import GraphView
from launchlint.rules.wording import words_at
from launchlint.source import Origin

Owners = Mapping[int, Instance]
"""The node of each endpoint, by the ``id`` of the endpoint: full names need not be unique."""

TALKS = {
    "publisher": "publishes",
    "subscriber": "subscribes to",
    "server": "serves",
    "client": "calls",
    "action server": "serves",
    "action client": "uses",
}
"""What a node of each role does with a name."""


def owners(view: GraphView) -> Owners:
    """The node of each endpoint; to be asked for through :meth:`~launchlint.rules.view.GraphView.once`."""
    return {id(endpoint): instance for instance in view.graph.instances for endpoint in instance.endpoints}


def is_known_to_act(endpoint: Endpoint) -> bool:
    """Whether a person said what ``endpoint`` does. Source that was read, and a run, tell of a name, not when somebody speaks on it."""
    evidence = endpoint.declaration.evidence
    return not evidence or any(each["by"] == "manual" for each in evidence)


def is_inside(remap: Remap, instance: Instance) -> bool:
    """Whether a ``<remap>`` stands inside the ``<node>``: those of scopes around it stand before it, or in another file."""
    at, home = remap.origin.place, instance.node.origin.place
    return at.source is home.source and at.span.start > home.span.start and remap.origin.step is instance.node.origin.step


def node_origin(instance: Instance) -> Origin:
    """The place of a node's name."""
    node = instance.node
    return Origin(node.places.get("name", node.origin.place), node.origin.step)


def remap_origin(endpoint: Endpoint) -> Origin | None:
    """The ``<remap>`` that acted last on the name, if any did."""
    for applied in reversed(endpoint.applied):
        if applied.rule.remap is not None:
            return applied.rule.remap.origin
    return None


def asked_for(endpoint: Endpoint, instance: Instance) -> Applied | None:
    """The remapping whose target the node's code looks up and makes the name of, as ``image_view`` does; None where it says the name.

    A further remap of the name that comes out would have to be found by its code, too: remappings do not chain.
    """
    template = endpoint.declaration.name
    if endpoint.applied or not is_template(template):
        return None
    for part in parse(template):
        if isinstance(part, Slot) and part.kind == "remap":
            found = instance.namer.remappings.get(absolute(part.key, instance.namer.namespace, instance.namer.node))
            if found is not None and f"{endpoint.name}/".startswith(f"{found.target}/"):
                return found
    return None


def acting_origin(endpoint: Endpoint, instance: Instance) -> Origin:
    """Where the name is made: the last remap, ``args`` where it stands there, else the node."""
    remap = remap_origin(endpoint)
    if remap is not None:
        return remap
    asked = asked_for(endpoint, instance)
    if asked is not None and asked.rule.remap is not None:
        return asked.rule.remap.origin
    written = instance.node.places.get("arguments")
    if (endpoint.applied or asked is not None) and written is not None:
        return Origin(written, instance.node.origin.step)
    return node_origin(instance)


def how(endpoint: Endpoint, instance: Instance) -> str:
    """How the name came about, in words; empty where the code says it just so."""
    effective = [each.rule for each in endpoint.applied if each.rule.source != each.rule.target]
    if effective:
        rule = effective[-1]
        return f"{instance.name} says {endpoint.declared}; the remap of {rule.source} to {rule.target} makes it {endpoint.name}"
    asked = asked_for(endpoint, instance)
    if asked is not None:
        return f"{instance.name} makes {endpoint.name} of what {asked.rule.source} is remapped to, {asked.rule.target}"
    way = kind(endpoint.declared)
    if way == "global":
        return f"{instance.name} says {endpoint.declared}, a global name that no namespace changes"
    if way == "relative" and instance.namer.namespace.strip("/") and not instance.namer.home.strip("/"):
        return f"{instance.name} says {endpoint.declared}; a nodelet in no namespace says its names in that of its manager: {endpoint.name}"
    if way == "relative" and instance.namer.namespace.strip("/"):
        return f"{instance.name} says {endpoint.declared}; its namespace makes it {endpoint.name}"
    return ""


def with_sources(finding: Finding, *endpoints: Endpoint) -> Finding:
    """The finding with the places in the sources of the checked packages at which these names were read."""
    related = list(finding.related)
    for endpoint in endpoints:
        for evidence in endpoint.declaration.evidence:
            path, _, line = evidence.get("at", "").rpartition(":")
            if "here" in evidence and line.isdecimal():
                place = Location(path, int(line), 1, int(line), 1, 0, 0, "")
                related.append(Related(place, f"{READ_FROM}{path}:{line}: {endpoint.node} {TALKS[endpoint.role]} {endpoint.declared}"))
                break
    return finding._replace(related=tuple(related))


def new_remap(endpoint: Endpoint, instance: Instance, target: str) -> tuple[str, str]:
    """The two sides of a remap that gives ``endpoint``, on which none acts, the name ``target``."""
    namespace = instance.namer.home.strip("/")
    prefix = f"/{namespace}/" if namespace else "/"
    says = absolute(endpoint.declared, namespace, instance.namer.node)
    source = endpoint.declared if says == endpoint.unremapped else endpoint.unremapped
    inside = target[len(prefix) :] if not source.startswith("/") and target.startswith(prefix) else ""
    return source, inside if inside[:1].isalpha() else target  # roscpp refuses a relative name with a digit at its start


def write_remap(endpoint: Endpoint, instance: Instance, target: str) -> str:
    """What to write so that ``endpoint`` gets the name ``target``."""
    asked = asked_for(endpoint, instance)
    if endpoint.applied or asked is not None:
        rule = endpoint.applied[-1].rule if asked is None else asked.rule
        remap = rule.remap
        source = rule.source if remap is None else remap.source
        if asked is not None:
            tail = endpoint.name[len(asked.target) :]
            if not target.endswith(tail):
                return f"remap {source} so that {target} comes out"
            target = target[: len(target) - len(tail)]
        elif endpoint.unremapped == target:
            return f"take the remap of {source} away"
        namespace = instance.namer.home.strip("/")
        prefix = f"/{namespace}/" if namespace else "/"
        shown = target[len(prefix) :] if not rule.target.startswith(("/", "~")) and target.startswith(prefix) else target
        if remap is None:
            return f"write {source}:={shown} in the args of {instance.name}"
        return f'let the remap of {source} lead to="{shown}"' if is_of_ros1(instance) else f"let the remap of {source} lead to {shown}"
    return f"{put_remap(instance, *new_remap(endpoint, instance, target))} of {instance.name}"


def is_of_ros1(instance: Instance) -> bool:
    """Whether it is a node of ROS 1: whose actions are topics."""
    return instance.namer.has_action_topics


def put_remap(instance: Instance, source: str, target: str) -> str:
    """What to write so that the node is remapped, in the words of its launch file, up to where the node is to be named."""
    words = words_at(instance.node.origin)
    if is_of_ros1(instance):
        return f'put <remap from="{source}" to="{target}"/> into the <node>'
    source, target = (f"~/{each[1:].lstrip('/')}" if each.startswith("~") else each for each in (source, target))
    said = words.written("remap", {"from": source, "to": target}, f"('{source}', '{target}')")
    return f"put {said} into the {'remappings' if words.language == 'python' else words.tag('node')}"


def in_namespace(instance: Instance, namespace: str) -> str:
    """A group that puts a namespace around what is in it, in the words of the launch file of a node."""
    if is_of_ros1(instance):
        return f'<group ns="{namespace}">'
    words = words_at(instance.node.origin)
    pushed = words.written("push_ros_namespace", {"namespace": namespace}, f"PushRosNamespace('{namespace}')")
    return f"{words.tag('group')} with {pushed}"
