"""Callbacks: the type of message or service that their parameters tell."""

from __future__ import annotations

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.declarations import Function, Parameter
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Callable, Closure, Thing, Value, choices

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call
    from launchlint.extract.cpp.machine import Machine


def callback_of(asked: Call, start: int) -> Value:
    """The first function among the arguments from ``start`` on, with the object behind it that it is called on."""
    for position in range(start, len(asked.arguments)):
        value = asked.value(position)
        for _, each in choices(value):
            if isinstance(each, Closure):
                return each
            if isinstance(each, Callable):
                following = choices(asked.value(position + 1))[0][1]
                if each.this is None and each.bound is None and isinstance(following, Thing):
                    return each._replace(this=following)
                return each
    return UNKNOWN


def message_type(machine: Machine, callback: Value, frame: Frame, service: bool = False) -> str:
    """``pkg/Type`` of the first parameter that is a message (or a service's request); empty where that is not known."""
    if isinstance(callback, Closure):
        return _of_parameters(machine, machine.parameters(callback), callback.frame, service, None)
    if not isinstance(callback, Callable):
        return ""
    for function in sorted(callback.functions, key=lambda each: _is_service(each) is not service):
        owner = machine.declarations.classes.get(function.owner)
        known = dict(classes.bindings_in(machine, callback.this, owner)) if callback.this is not None else {}
        inner = Frame(function.path, function.scope, callback.this, known)
        found = _of_parameters(machine, function.parameters, inner, service, callback.bound)
        if found:
            return found
    return ""


def _is_service(function: Function) -> bool:
    """Whether the parameters of an overload are those of a service."""
    return any(each.type.last in ("Request", "Response") or each.type.name.endswith("Request") for each in function.parameters)


def _of_parameters(
    machine: Machine, parameters: tuple[Parameter, ...], frame: Frame, service: bool, bound: tuple[int | Value, ...] | None
) -> str:
    positions = [0] if bound is None else [at for at, each in enumerate(bound) if each == 0 and isinstance(each, int)]
    for position in positions:
        if position < len(parameters):
            found = machine.names.message(parameters[position].type, frame, service)
            if found:
                return found
    return ""


def explicit(asked: Call, position: int = 0, service: bool = False) -> str:
    """``pkg/Type`` of a template argument."""
    if position >= len(asked.types):
        return ""
    return asked.machine.names.message(asked.types[position], asked.frame, service)


def action_type(asked: Call) -> str:
    """``pkg/NameAction`` of the template argument of an action server or client."""
    return asked.machine.names.message(asked.types[0] if asked.types else Type(""), asked.frame)
