"""What the templates and conditions of a library see of a node that is started."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.graph.command_line import CommandLine, split_options
from launchlint.graph.names import Namer
from launchlint.graph.parameters import Parameters
from launchlint.library.template import UNKNOWN

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Start:
    """One node as it is started (:class:`launchlint.library.template.Situation`).

    ``looked_up`` collects the names that were resolved for a template: names of the node's code, too. Each maps its place on the graph
    before remapping to what the code says. ``skip`` arguments are not the program's own; ``named``: the node's name is known, and so are
    its private params; ``placed``: its namespace is known.
    """

    def __init__(
        self,
        namer: Namer,
        line: CommandLine,
        parameters: Parameters,
        options: Mapping[str, int] | None,
        skip: int = 0,
        *,
        named: bool = True,
        placed: bool = True,
    ) -> None:
        self.node: Any = namer.graph_name.rpartition("/")[2] if named else UNKNOWN
        self._named = named
        self._placed = placed
        self.looked_up: dict[str, str] = {}
        self._namer = namer
        self._parameters = parameters
        self._own = line.params
        self._known = line.known
        self._words, self._options = split_options(line.words[skip:], options)

    def argument(self, position: int) -> Any:
        """The positional argument, counted from 1 or from -1; None where there is none."""
        if position < 0 and not self._known:
            return UNKNOWN
        index = position - 1 if position > 0 else len(self._words) + position
        return self._words[index] if 0 <= index < len(self._words) else None if self._known else UNKNOWN

    def arguments_from(self, position: int) -> Any:
        """All positional arguments from one on."""
        return list(self._words[position - 1 :]) if self._known else UNKNOWN

    def option(self, name: str) -> Any:
        """The value of an option; None where it is not given."""
        value = self._options.get(name, None if self._known else UNKNOWN)
        return UNKNOWN if value == [] and not self._known else value

    def param(self, name: str) -> Any:
        """The value of a param: from the command line (``_x:=5``), else as the launch file sets it."""
        if name.startswith("~") and name[1:] in self._own:
            return self._own[name[1:]]
        if (name.startswith("~") and not self._named) or not (self._placed or name.startswith("/")):
            return UNKNOWN
        return self._parameters.read(name, self._namer)

    def resolved(self, name: str) -> str:
        """A name, resolved and remapped."""
        found = self._namer.resolve(name)
        self.looked_up[found.unremapped] = name
        return found.name

    def is_remapped(self, name: str) -> bool:
        """Whether a remapping acts on the name."""
        found = self._namer.resolve(name)
        self.looked_up[found.unremapped] = name
        return bool(found.applied)
