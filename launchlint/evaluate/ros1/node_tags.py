"""``<node>`` and ``<test>`` (roslaunch.xmlloader._node_tag, roslaunch.core.Node and Test)."""

from __future__ import annotations

import re
from collections.abc import Mapping

from launchlint.evaluate.block import Clear, NodeEffect, PrivateParameter, Value
from launchlint.evaluate.names import as_namespace, join
from launchlint.evaluate.problems import InvalidNodeName, RemapReplaced
from launchlint.evaluate.ros1.file import FileEvaluation
from launchlint.evaluate.ros1.parameter_tags import private_param, rosparam
from launchlint.evaluate.ros1.scope import Context, PrivateParameters, overlay
from launchlint.evaluate.ros1.scope_tags import check_quotes, env, remap, scope_namespace
from launchlint.model import Condition, EnvironmentSetting, Node, Remap, Role, Unknown
from launchlint.source import Origin
from launchlint.syntax.ros1.dialect import ROLES
from launchlint.syntax.ros1.problems import conflicting_attributes
from launchlint.syntax.tree import Element

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.problems import NameFault

CHILD_TAGS = frozenset({"remap", "param", "rosparam", "env"})
TEXT_ATTRIBUTES = ("pkg", "type", "machine", "args", "launch-prefix")
CHOICES = {"output": ("log", "screen"), "cwd": ("ROS_HOME", "ros_home", "node")}


def node(file: FileEvaluation, element: Element, context: Context, default_machine: str | None, *, is_test: bool) -> None:
    """Evaluate a ``<node>`` or ``<test>`` and its children."""
    unknown: dict[Role, str] = {}
    name_value = file.optional(element, "name", context) if is_test else file.required(element, "name", context)
    test_value, time_limit, retry = _test_attributes(file, element, context) if is_test else (None, 60.0, 0)
    test_name = None if test_value is None else _known(test_value, "test_name", unknown)
    name = _known(name_value, "name", unknown) if name_value is not None else ""
    if is_test and not name and test_name:
        name = test_name
        if "test_name" in unknown:
            unknown["name"] = unknown["test_name"]
    namespace, given = scope_namespace(file, element, context)
    if given is None:
        unknown["namespace"] = "*"
    private_namespace = _private_namespace(file, element, namespace, name)
    # roslaunch copies what substitutions know before it looks at the other attributes, so a new $(anon) in a param stays in the node's
    # params.
    file.spend_on_scope(context, element.name_span)
    values = Context(private_namespace, context)
    if file.flag(element, "clear_params", context, empty_is_absent=True):
        _clear(file, element, namespace, name)
    texts: dict[str, str] = {}
    for attribute in TEXT_ATTRIBUTES:
        value = file.required(element, attribute, context) if attribute in ("pkg", "type") else file.optional(element, attribute, context)
        texts[attribute] = "" if value is None else _known(value, ROLES[attribute], unknown)
    for attribute in ("pkg", "type"):
        if ROLES[attribute] not in unknown and not texts[attribute].strip():
            file.invalid(element, attribute, texts[attribute], "a name")
    for attribute in ("args", "launch-prefix"):
        if ROLES[attribute] not in unknown:
            check_quotes(file, element, attribute, texts[attribute])
    respawn = False if is_test else file.flag(element, "respawn", context)
    required = file.flag(element, "required", context)
    delay = 0.0 if is_test else file.number(element, "respawn_delay", context, 0.0)
    if respawn and required and not is_test:
        file.record(conflicting_attributes(file.document, element, "respawn-and-required", ("respawn", "required")))
    chosen = {attribute: _choice(file, element, attribute, context) for attribute in CHOICES}
    remaps, environment, own_private = _children(file, element, context, values)
    file.spend_on_node(context, len(remaps), len(environment), element.name_span)
    _check_name(file, element, name, unknown, is_test=is_test, given=name_value)
    collapsed = re.sub("//+", "/", as_namespace(namespace))
    item = Node(
        name=name,
        namespace=collapsed,
        package=texts["pkg"],
        executable=texts["type"],
        machine=texts["machine"] or default_machine,
        arguments=texts["args"],
        remaps=tuple(remaps),
        environment=tuple(environment),
        output="log" if is_test else chosen["output"],
        respawn=respawn,
        respawn_delay=delay,
        required=required and not is_test,
        cwd="ROS_HOME" if chosen["cwd"] == "ros_home" else chosen["cwd"],
        launch_prefix=texts["launch-prefix"] or None,
        file=file.file,
        origin=Origin(file.place(element.start_span)),
        places={ROLES[key]: file.place(written.value_span) for key, written in element.attributes.items() if key in ROLES},
        scope=context.scope,
        conditions=file.conditions,
        unknown=frozenset(unknown),
        patterns=unknown,
        test_name=test_name,
        time_limit=time_limit,
        retry=retry,
    )
    file.effect(NodeEffect(item, tuple(context.private.values()), tuple(own_private), private_namespace))
    file.block.node_count += 1
    context.reach(1)
    context.nodes_above.append(item.origin.place)


def _known(value: Value, role: Role, unknown: dict[Role, str]) -> str:
    if isinstance(value, Unknown):
        unknown[role] = value.pattern
        return value.text
    return value


def _test_attributes(file: FileEvaluation, element: Element, context: Context) -> tuple[Value, float, int]:
    for attribute in ("respawn", "respawn_delay", "output"):
        if attribute in element.attributes:
            file.record(conflicting_attributes(file.document, element, "test-attribute", (attribute,)))
    name = file.required(element, "test-name", context)
    limit, retry = 60.0, 0
    limit_text = file.optional(element, "time-limit", context)
    if isinstance(limit_text, str) and limit_text:
        try:
            limit = float(limit_text)
        except ValueError:
            limit = 0.0
        if limit <= 0:
            file.invalid(element, "time-limit", limit_text, "a number of seconds above 0")
            limit = 60.0
    retry_text = file.optional(element, "retry", context)
    if isinstance(retry_text, str) and retry_text:
        try:
            retry = int(retry_text)
        except ValueError:
            file.invalid(element, "retry", retry_text, "a whole number")
    return name, limit, retry


def _private_namespace(file: FileEvaluation, element: Element, namespace: str, name: str) -> str:
    """The namespace of the node's private names (``child_ns.child(name)``)."""
    if not name:
        return namespace
    if name.startswith("~"):
        file.record(_invalid_name(file, element, name, "private"))
        return join(namespace, name[1:]) + "/"
    return as_namespace(join(namespace, name))


def _clear(file: FileEvaluation, element: Element, namespace: str, name: str) -> None:
    """``clear_params`` of a node or test: its private parameters are deleted first."""
    written = element.attributes["clear_params"]
    if name:
        file.effect(Clear(as_namespace(join(namespace, name.lstrip("~"))), Origin(file.place(written.value_span))))
    else:
        file.record(conflicting_attributes(file.document, element, "clear-params-without-name", ("clear_params",)))


def _choice(file: FileEvaluation, element: Element, attribute: str, context: Context) -> str | None:
    """``output`` or ``cwd``: one of a few words, exactly."""
    if attribute == "output" and element.tag != "node":
        return None
    value = file.optional(element, attribute, context)
    if not isinstance(value, str):
        return None
    if value not in CHOICES[attribute]:
        file.invalid(element, attribute, value, " or ".join(CHOICES[attribute]))
        return None
    return value


def _children(
    file: FileEvaluation, element: Element, context: Context, values: Context
) -> tuple[list[Remap], list[EnvironmentSetting], list[PrivateParameter]]:
    own = Context(context.namespace, context)
    own.anonymous, own.arguments = context.anonymous, context.arguments
    # Names that $(anon) makes up in <env> are known to the other <env> of this node only.
    inside = Context(context.namespace, context)
    inside.arguments = context.arguments
    own_environment: list[EnvironmentSetting] = list(context.environment)
    own_private: PrivateParameters = {}
    conditions: dict[str, frozenset[Condition]] = {}
    for tag, child in file.children(element, context, CHILD_TAGS, any_case=True):
        if tag == "remap":
            rule = remap(file, child, context)
            if rule is not None:
                replaced = own.add_remap(rule)
                if replaced is not None and rule.source:
                    related = ((replaced.origin.place, "the first one"),)
                    always = conditions[rule.source].issuperset(file.conditions)
                    file.record(RemapReplaced(origin=rule.origin, related=related, key=rule.source, old=replaced.target,
                                              new=rule.target, always=always))  # fmt: skip
                conditions[rule.source] = frozenset(file.conditions)
        elif tag == "env":
            setting = env(file, child, inside)
            if setting is not None:
                own_environment.append(setting)
        elif tag == "param":
            private_param(file, child, values, own_private)
        else:
            rosparam(file, child, values, values.namespace, in_node=True)
    return overlay(context.remaps_in_force(), list(own.remaps.values())), own_environment, list(own_private.values())


def _check_name(
    file: FileEvaluation, element: Element, name: str, unknown: Mapping[Role, str], *, is_test: bool, given: Value | None
) -> None:
    if "name" in unknown or name.startswith("~"):
        return
    reason: NameFault
    if "/" in name:
        reason = "slash"
    elif not name and not is_test and given is not None:
        reason = "empty"
    elif name and re.fullmatch(r"[A-Za-z]\w*", name) is None:
        reason = "characters"
    else:
        return
    file.record(_invalid_name(file, element, name, reason))


def _invalid_name(file: FileEvaluation, element: Element, name: str, reason: NameFault) -> InvalidNodeName:
    own, of_test = element.attributes.get("name"), element.attributes.get("test-name")
    written = own or of_test
    return InvalidNodeName(
        origin=file.at(element.name_span if written is None else written.value_or_name_span),
        refused=reason in ("private", "slash"),
        name=name,
        from_test=own is None and of_test is not None,
        reason=reason,
    )
