"""The words and bounds of the library format that every check needs; :mod:`.format` has the rest."""

from __future__ import annotations

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
"""The kinds of names a node has, in the order in which they are written."""

FRAMES = "frames"
"""The coordinate frames of a node: no names on the graph, and listed behind them."""

LISTS = (*CATEGORIES, FRAMES)
"""All that a variant lists, in the order in which it is written."""

KINDS = {"executables": "executable", "nodelets": "nodelet class"}
"""The tables of programs in a package, with what one of each is called."""

DEEPEST_CONDITION = 8
"""Levels of ``not``, ``all`` and ``any`` in a condition, and of templates in templates."""
