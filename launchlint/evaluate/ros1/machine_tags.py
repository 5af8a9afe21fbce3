"""``<machine>`` (roslaunch.xmlloader._machine_tag)."""

from __future__ import annotations

from launchlint.evaluate.block import Value
from launchlint.evaluate.ros1.file import FileEvaluation
from launchlint.evaluate.ros1.scope import Context
from launchlint.model import Machine, Unknown
from launchlint.source import Origin
from launchlint.syntax.ros1.problems import deprecated_construct
from launchlint.syntax.tree import Element

PRE_FUERTE = ("ros-root", "ros-package-path", "ros-ip", "ros-hostname")
DEFAULTS = {"true": (True, True), "false": (True, False), "never": (False, False)}
"""Value of ``default`` → (nodes may be assigned to it, it is the default machine from here on)."""


def machine(file: FileEvaluation, element: Element, context: Context) -> str | None:
    """Evaluate a ``<machine>``. Returns its name where it becomes the default machine."""
    context = Context(context.namespace, context)  # as roslaunch: what $(anon) makes up here is not known outside
    for name in PRE_FUERTE:
        if file.optional(element, name, context):
            span = element.attributes[name].name_span
            file.record(deprecated_construct(file.document, span, f"machine {name}", "env-loader", refused=True))
    name_value, address = file.required(element, "name", context), file.required(element, "address", context)
    loader, user, password = (file.optional(element, attribute, context) for attribute in ("env-loader", "user", "password"))
    port = _port(file, element, context)
    default = file.optional(element, "default", context) or "false"
    assignable, is_default = True, False
    if isinstance(default, str):
        if default.lower() in DEFAULTS:
            assignable, is_default = DEFAULTS[default.lower()]
        else:
            file.invalid(element, "default", default, "true, false or never")
    for child in element.children:
        if child.tag == "env":
            file.record(deprecated_construct(file.document, child.name_span, "machine env", "env-loader", refused=True))
    timeout = _timeout(file, element, context)
    if isinstance(name_value, Unknown):
        file.block.unknown_machines.add("")
        return None
    if isinstance(address, Unknown):
        file.block.unknown_machines.add(name_value)
        return name_value if is_default else None
    if not name_value:
        # The empty name is that of the machine roslaunch runs on (roslaunch.core.local_machine), which no definition is equal to.
        file.invalid(element, "name", "", "a name")
        return None
    distribution = file.session.variable("ROS_DISTRO") or "noetic"
    file.effect(
        Machine(
            name_value,
            address,
            _text(loader) or f"/opt/ros/{distribution}/env.sh",
            port,
            _text(user) or None,
            None if password is None else _text(password),
            assignable,
            timeout or 10.0,
            Origin(file.place(element.start_span)),
        )
    )
    return name_value if is_default else None


def _text(value: Value | None) -> str:
    return value if isinstance(value, str) else "" if value is None else value.text


def _port(file: FileEvaluation, element: Element, context: Context) -> int:
    value = file.optional(element, "ssh-port", context)
    if not isinstance(value, str) or not value:
        return 22
    try:
        return int(value)
    except ValueError:
        file.invalid(element, "ssh-port", value, "a whole number")
        return 22


def _timeout(file: FileEvaluation, element: Element, context: Context) -> float | None:
    value = file.optional(element, "timeout", context)
    if not isinstance(value, str):
        return None
    try:
        seconds = float(value)
    except ValueError:
        file.invalid(element, "timeout", value, "a number of seconds above 0")
        return None
    if seconds <= 0:
        file.invalid(element, "timeout", value, "a number of seconds above 0")
        return None
    return seconds
