"""How one node is run."""

import shlex
from typing import Any, Dict, List, Optional, Tuple

from launchlint_probe.bounds import Bounds

PLACE = "{}"
"""Stands in arguments and params for a word that the probe makes up, to find it again in names."""


class Plan:
    """How one node is run; times in seconds.

    Args:
        label: ``package/executable`` or so, for the record.
        command: the program and its own arguments.
        params: private (``~x``), relative or global names of params → values, set before it starts.
        remap: names → names.
        environment: further variables.
        files: name → text of files put into its working directory.
        quiet: this long nothing new must come before it is taken to be ready.
        limit: it is stopped after this.
        with_name: whether it is given a name.
        with_namespace: whether it is given a namespace; in ROS 1 it always is.
        many: whether it starts nodes rather than being one (a launch file).
        component: package and class, where the command is a container that this is to be loaded into.
        bounds: what it may take.

    ``tokens`` are the words put where arguments and params say ``{}``, each with the template that stands for it.
    """

    def __init__(
        self,
        label: str,
        command: List[str],
        params: Optional[Dict[str, Any]] = None,
        remap: Optional[Dict[str, str]] = None,
        environment: Optional[Dict[str, str]] = None,
        files: Optional[Dict[str, str]] = None,
        quiet: float = 1.0,
        limit: float = 15.0,
        with_name: bool = True,
        with_namespace: bool = True,
        arguments: str = "",
        many: bool = False,
        component: Optional[Tuple[str, str]] = None,
        bounds: Optional[Bounds] = None,
    ) -> None:
        self.bounds = bounds or Bounds()
        self.label = label
        self.tokens: Dict[str, str] = {}
        words = shlex.split(arguments)
        for number, word in enumerate(words, 1):
            if PLACE in word:
                words[number - 1] = self._token("arg", number, word, "{{arg:{}}}".format(number))
        self.command = command + words
        self.params = dict(params or {})
        for number, (name, value) in enumerate(sorted(self.params.items()), 1):
            if isinstance(value, str) and PLACE in value:
                self.params[name] = self._token("param", number, value, "{{param:{}}}".format(name))
        self.many = many
        self.component = component
        self.remap = remap or {}
        self.environment = environment or {}
        self.files = files or {}
        self.quiet = quiet
        self.limit = limit
        self.with_name = with_name
        self.with_namespace = with_namespace

    def _token(self, kind: str, number: int, text: str, template: str) -> str:
        made = text.replace(PLACE, "launchlint_{}_{}_".format(kind, number))
        self.tokens[made.strip("/~")] = template
        return made
