"""The words and bounds of the library format that every check needs; :mod:`.format` has the rest."""

from __future__ import annotations

CATEGORIES = ("publishers", "subscribers", "services", "clients", "actions", "params")
"""The kinds of names a node has, in the order in which they are written."""

KINDS = {"executables": "executable", "nodelets": "nodelet class"}
"""The tables of programs in a package, with what one of each is called."""

DEEPEST_CONDITION = 8
"""Levels of ``not``, ``all`` and ``any`` in a condition, and of templates in templates."""
