"""Classes that generate_parameter_library makes of a YAML file for Python: each param is declared, and read as an attribute.

The module is made by the build, and named in ``setup.py`` or ``CMakeLists.txt``; that of the package whose only mapping is called as the
class is the one.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from launchlint.extract.described_params import Description, read
from launchlint.extract.python.arguments import Call
from launchlint.extract.python.ros2 import nodes
from launchlint.extract.python.ros2.names import NodeParam
from launchlint.python.text import ANY, joined, template
from launchlint.python.values import MISSING, UNKNOWN, Handle, Seq, Value
from launchlint.workspace import looking

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.python.ros2.run import Ros2Run

LISTENER = ".ParamListener"
_MAKES = b"generate_parameter_module"
_MOST_DIRECTORIES = 300


def listener(made: Call) -> Value:
    """``space.ParamListener(node, prefix='')``."""
    parts = made.name.split(".")
    description = _description(made, parts[0], parts[-2]) if len(parts) > 2 else None
    if description is None:
        made.doubt(f"it declares the params of {'.'.join(parts[:-1])}, whose description was not found", ("params",))
        return UNKNOWN
    start = template(made.get(1, "prefix", ""))
    start = f"{start.rstrip('.')}." if start else ""
    for key in nodes.keys(made, made.get(0, "node")):
        for each in description.params:
            made.fact(
                "params",
                _spelled(start, each.name),
                default=each.default,
                value_type=each.type,
                declared=True,
                descriptor=each.descriptor,
                node=key,
            )
    if not description.whole:
        made.doubt("it declares too many params to list them all", ("params",))
    return Handle("listener", {"params": _struct(description, start)})


def params_of(receiver: Handle, made: Call) -> Value:
    """``listener.get_params()``."""
    params: Value = receiver.state["params"]
    return params


def _spelled(start: str, name: str) -> Value:
    return joined([start if ANY not in start else UNKNOWN, *_parts(name)])


def _parts(name: str) -> Iterator[Value]:
    """A name with what is not known of it."""
    first, *others = name.split(ANY)
    yield first
    for each in others:
        yield UNKNOWN
        yield each


def _struct(description: Description, start: str) -> Handle:
    top = Handle("params", {})
    for each in description.params:
        *spaces, last = each.name.split(".")
        here = top
        for part in spaces:
            inner = here.state.setdefault(("attribute", part), Handle("params", {}))
            here = inner if isinstance(inner, Handle) else Handle("params", {})
        default: Value = MISSING if each.default is None else Seq(each.default) if isinstance(each.default, list) else each.default
        here.state["attribute", last] = UNKNOWN if ANY in each.name or ANY in start else NodeParam(f"~{start}{each.name}", default)
    return top


def _description(made: Call, package: str, space: str) -> Description | None:
    """What the package has for the class called ``space``, looked for once."""
    run: Ros2Run = made.run  # type: ignore[assignment]
    key = (package, space)
    if key not in run.descriptions:
        run.descriptions[key] = _found(run, package, space)
    return run.descriptions[key]


def _found(run: Ros2Run, package: str, space: str) -> Description | None:
    for directory, name in run.finder.packages.items():
        if name != package or not any(
            _MAKES in (looking.content(os.path.join(directory, each)) or b"") for each in ("setup.py", "CMakeLists.txt")
        ):
            continue
        for place, names in looking.walk(directory, _MOST_DIRECTORIES):
            for file in sorted(names):
                found = read(os.path.join(place, file)) if file.endswith((".yaml", ".yml")) else None
                if found is not None and found.space == space and found.params:
                    return found
    return None
