"""Between a launch file and the drawing of it: what stands at a place of the text, and where what was chosen in the drawing is written."""

from __future__ import annotations

from launchlint.ide.navigation import target_of_place
from launchlint.ide.view import Target, View, is_made_by
from launchlint.named_tuple import NamedTuple


class Shown(NamedTuple):
    """Something in the drawing: of which ``kind`` (node, topic, service, action or param) what is called ``name`` there is."""

    kind: str
    name: str


def shown_at(view: View, offset: int) -> Shown | None:
    """What of the drawing is written at an offset of the text: the name that a remap makes, else the node around; None where it is none."""
    for item in view.items_at(offset):
        for configuration, node, remap in view.remaps_of(item):
            instance = None if configuration.graph is None else configuration.graph.instance(node.full_name)
            for endpoint in () if instance is None else instance.endpoints:
                if is_made_by(endpoint, remap):
                    return Shown(endpoint.kind, endpoint.name)
        for node in view.nodes_of(item):
            return Shown("node", node.full_name)
    return None


def place_of(view: View, shown: Shown) -> Target | None:
    """Where something in the drawing of this file is written; None where that is not known."""
    own = next((each for each in view.entries if each.result.request.at == view.file), None)
    for configuration in () if own is None else own.configurations:
        launch, graph = configuration.evaluation.launch, configuration.graph
        nodes = {shown.name}
        channel = None if graph is None else graph.channels.get((shown.kind, shown.name))
        if shown.kind != "node":
            nodes = set() if channel is None else {each.node for each in (*channel.offers, *channel.uses)}
        for node in (*launch.nodes, *launch.tests):
            if node.full_name in nodes:
                return target_of_place(view.snapshot, node.places.get("name", node.origin.place))
        for setting in launch.parameters.values():
            if (shown.kind, shown.name) == ("param", setting.name):
                return target_of_place(view.snapshot, setting.origin.place)
    return None
