"""What a library of version 1 says, in the words of ROS 2: it does not say which middleware a package is of, and so serves both."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.library.terms import LISTS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Said = Mapping[str, Any]

_NAMESPACES = {"publishers": "msg", "subscribers": "msg", "services": "srv", "clients": "srv", "actions": "action"}
_VALUE_TYPES = {"bool": "bool", "int": "integer", "double": "double", "str": "string"}
_ONLY_ROS1 = frozenset({"md5", "latched", "queue", "removed"})


def in_ros2(package: Said) -> Said:
    """A package as one of ROS 2: nodelet classes are components, ``std_msgs/String`` is ``std_msgs/msg/String``, ``int`` is ``integer``."""
    found: dict[str, Any] = {key: value for key, value in package.items() if key not in ("executables", "nodelets", "complete")}
    found["complete"] = ["components" if table == "nodelets" else table for table in package.get("complete", ())]
    for table, other in (("executables", "executables"), ("nodelets", "components")):
        if table in package:
            found[other] = {name: _program(table, program) for name, program in package[table].items()}
    return found


def _program(table: str, program: Said) -> dict[str, Any]:
    found = {key: value for key, value in program.items() if key != "removed"}
    if table == "nodelets" and "like" in program:  # a component is named after its package there
        found["like"] = f"{program['like'].partition('/')[0]}/{program['like']}"
    if "variants" in program:
        found["variants"] = {name: _variant(variant) for name, variant in program["variants"].items()}
    return found


def _variant(variant: Said) -> dict[str, Any]:
    return {key: [_entry(key, entry) for entry in value] if key in LISTS else value for key, value in variant.items()}


def _entry(category: str, entry: Said) -> Said:
    if category == "frames":
        return entry
    found = {key: value for key, value in entry.items() if key not in _ONLY_ROS1}
    type_ = entry.get("type", "")
    if category == "params":
        found["type"] = _VALUE_TYPES.get(type_, "")
        return found if found["type"] else {key: value for key, value in found.items() if key != "type"}
    package, slash, name = type_.partition("/")
    if slash:
        found["type"] = f"{package}/{_NAMESPACES[category]}/{name.removesuffix('Action') if category == 'actions' else name}"
    return found
