"""The mistakes themselves: see :mod:`.mutations`."""

from __future__ import annotations

import re
from random import Random

from tests.conformance.ros2.elements import Document, Element
from tests.conformance.ros2.mutations import (
    _VARIABLE,
    STARTED,
    _any_value,
    _has_variable,
    cut,
    kind,
    misspelt,
    of_element,
    substitution,
    table,
    with_attribute,
    with_value,
    without,
)

Made = str | tuple[str, str] | None

# -- names

table(
    "names",
    [
        ("node_name_with_slash", ("node", "node_container", "composable_node"), "name", ("front/camera", "/camera", "a.b")),
        ("node_name_with_sign", ("node", "node_container", "composable_node"), "name", ("front-camera", "my node", "camera 1", "cam#1")),
        ("node_name_with_digit", ("node", "node_container"), "name", ("1camera", "2d_lidar")),
        ("node_name_empty", ("node", "composable_node"), "name", ("",)),
        ("namespace_bad", ("node", "node_container", "composable_node", "push-ros-namespace", "push_ros_namespace"), "namespace",
         ("my-robot", "robot//arm", "1robot", "robot arm", "/robot/1", "~robot", "robot.arm")),
        ("namespace_odd", ("node", "node_container", "composable_node"), "namespace", ("", "/", "robot/", "/robot/")),
        ("package_unknown", ("node", "node_container", "composable_node"), "pkg", ("no_such_pkg_anywhere",)),
        ("package_bad", ("node", "node_container"), "pkg", ("my pkg", "", "x", "-pkg")),
        ("executable_unknown", ("node",), "exec", ("no_such_program",)),
        ("remap_bad", ("remap", "set_remap"), "to", ("", "/a//b", "my topic", "a-b", "/1a", "b/")),
        ("remap_from_bad", ("remap", "set_remap"), "from", ("", "/a//b", "my topic", "a-b", "b/")),
    ],
)  # fmt: skip


@kind("names", "node", "node_container", "composable_node")
def package_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("pkg")
    return None if attribute is None or "$" in attribute.value else with_value(document, attribute, misspelt(attribute.value, random))


@kind("names", "node", "node_container")
def executable_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("exec")
    return None if attribute is None or "$" in attribute.value else with_value(document, attribute, misspelt(attribute.value, random))


@kind("names", "include")
def included_file_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("file")
    match = attribute and re.search(r"(\w{3,})\.launch\.\w+$", attribute.value)
    return with_value(document, attribute, cut(attribute.value, match.span(1), misspelt(match[1], random))) if attribute and match else None


@kind("names", "include")
def included_file_in_wrong_folder(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("file")
    if attribute is None or "/launch/" not in attribute.value:
        return None
    return with_value(document, attribute, attribute.value.replace("/launch/", random.choice(("/", "/launch/launch/", "/lauch/"))))


@kind("names", "node")
def node_twice(document: Document, element: Element, random: Random) -> Made:
    at = of_element(document, element)
    return None if at is None or "name" not in element.attributes else cut(document.text, (at[1], at[1]), document.text[slice(*at)])


# -- substitutions

substitution("substitution_misspelt", lambda match, random: cut(match[0], (2, 2 + len(match[1])), misspelt(match[1], random)))
substitution("bracket_lost", lambda match, random: match[0][:-1])
substitution("bracket_twice", lambda match, random: "$" + match[0])
substitution("blank_after_bracket", lambda match, random: "$( " + match[0][2:])
substitution("blank_before_bracket", lambda match, random: match[0][:-1] + " )")
substitution("two_blanks", lambda match, random: match[0].replace(" ", "  ", 1))
substitution("tab_in_substitution", lambda match, random: match[0].replace(" ", "\t", 1))
substitution("blank_before_substitution", lambda match, random: "$ " + match[0][1:])
substitution("braces", lambda match, random: "${" + match[0][2:-1] + "}")
substitution("dollar_lost", lambda match, random: match[0][1:])
substitution("one_word_too_many", lambda match, random: match[0][:-1] + " one two)")
substitution("words_lost", lambda match, random: f"$({match[1]})")
substitution("find_of_ros1", lambda match, random: "$(find " + (match[2].strip() or "pkg") + ")")
substitution("arg_of_ros1", lambda match, random: "$(arg " + (match[2].strip() or "name") + ")")
substitution("env_unset", lambda match, random: "$(env NO_SUCH_VARIABLE_SET)")
substitution("optenv", lambda match, random: "$(optenv NO_SUCH_VARIABLE_SET x)")
substitution("package_not_there", lambda match, random: "$(find-pkg-share no_such_pkg_anywhere)")
substitution("eval_without_quotes", lambda match, random: "$(eval no_such_name == 1)")
substitution(
    "eval_bad",
    lambda match, random: random.choice(
        ('$(eval "1 +")', "$(eval '1 == = 2')", "$(eval 1 / 0)", "$(eval 'true')", '$(eval "$(dirname) + 1")')
    ),
)
substitution(
    "not_of_text", lambda match, random: random.choice(("$(not maybe)", "$(and true maybe)", "$(or no_one false)", "$(not $(dirname))"))
)
substitution(
    "later_substitution", lambda match, random: random.choice(("$(any true false)", "$(all true)", "$(index a 1)", "$(path-join a b)"))
)
_WRONG_ARITY = ("$(if true)", "$(equals a)", "$(exec-in-pkg a)", "$(dirname x)", "$(and true)", "$(not true false)", "$(anon)", "$(eval)")
substitution("arity_wrong", lambda match, random: random.choice(_WRONG_ARITY))
substitution("anon", lambda match, random: "$(anon x)")
substitution("param_read", lambda match, random: "$(param x)")
substitution("command_bad", lambda match, random: "$(command 'true' loud)")


@kind("substitutions")
def variable_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = _any_value(element, random, _has_variable)
    if attribute is None:
        return None
    match = random.choice(list(_VARIABLE.finditer(attribute.value)))
    return with_value(document, attribute, cut(attribute.value, match.span(1), misspelt(match[1], random)))


@kind("substitutions")
def package_in_path_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = _any_value(element, random, lambda name, value: name != "description" and "$(find-pkg-share " in value)
    match = attribute and re.search(r"\$\(find-pkg-share (\w+)\)", attribute.value)
    return with_value(document, attribute, cut(attribute.value, match.span(1), misspelt(match[1], random))) if attribute and match else None


# -- scoping


@kind("scoping", "arg")
def default_lost(document: Document, element: Element, random: Random) -> Made:
    if element.parent is None or element.parent.tag == "include":
        return None
    text = without(document, element, "default")
    return None if text is None else (text, element.attributes["name"].value)


@kind("scoping", "arg", "let")
def declaration_lost(document: Document, element: Element, random: Random) -> Made:
    at = of_element(document, element)
    if at is None or element.parent is None or "name" not in element.attributes:
        return None
    return cut(document.text, at), element.attributes["name"].value


@kind("scoping", "arg", "let")
def declaration_renamed(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("name")
    text = None if attribute is None else with_value(document, attribute, misspelt(attribute.value, random))
    return None if attribute is None or text is None else (text, attribute.value)


@kind("scoping", "arg", "let", dialect="xml")
def declared_too_late(document: Document, element: Element, random: Random) -> Made:
    root = document.elements[0]
    if element.parent is not root or root.end_name_at is None or "name" not in element.attributes:
        return None
    end = root.end_name_at[0] - 2
    text = document.text
    return text[: element.at[0]] + text[element.at[1] : end] + text[slice(*element.at)] + "\n" + text[end:], element.attributes[
        "name"
    ].value


@kind("scoping", "arg", "let", dialect="xml")
def declared_in_group(document: Document, element: Element, random: Random) -> Made:
    if element.parent is None or element.parent.tag not in ("launch", "group") or "name" not in element.attributes:
        return None
    whole = document.text[slice(*element.at)]
    return cut(document.text, element.at, f"<group>{whole}</group>"), element.attributes["name"].value


@kind("scoping", "let")
def let_is_arg(document: Document, element: Element, random: Random) -> Made:
    value = element.attributes.get("value")
    if value is None:
        return None
    first, second = sorted(((value.name_at, "default"), (element.name_at, "arg")), reverse=True)
    return cut(cut(document.text, *first), *second) if element.end_name_at is None else None


@kind("scoping", "group")
def group_not_scoped(document: Document, element: Element, random: Random) -> Made:
    return with_attribute(document, element, "scoped", "false") if not document.yaml else None


@kind("scoping", "group")
def group_not_forwarding(document: Document, element: Element, random: Random) -> Made:
    return with_attribute(document, element, "forwarding", "false") if not document.yaml else None


@kind("scoping", "group", dialect="xml")
def group_lost(document: Document, element: Element, random: Random) -> Made:
    if element.end_name_at is None:
        return None
    text = cut(document.text, (element.end_name_at[0] - 2, element.at[1]))
    return cut(text, (element.at[0], text.index(">", element.head_end) + 1))


@kind("scoping", "include", dialect="xml")
def include_in_group(document: Document, element: Element, random: Random) -> Made:
    return cut(document.text, element.at, f"<group>{document.text[slice(*element.at)]}</group>")


@kind("scoping", "arg")
def passed_arg_lost(document: Document, element: Element, random: Random) -> Made:
    at = of_element(document, element)
    if at is None or element.parent is None or element.parent.tag != "include":
        return None
    return cut(document.text, at)


@kind("scoping", "arg")
def passed_arg_misspelt(document: Document, element: Element, random: Random) -> Made:
    if element.parent is None or element.parent.tag != "include":
        return None
    return with_value(document, element.attributes["name"], misspelt(element.attributes["name"].value, random))


@kind("scoping", "arg")
def passed_arg_has_default(document: Document, element: Element, random: Random) -> Made:
    value = element.attributes.get("value")
    if element.parent is None or element.parent.tag != "include" or value is None:
        return None
    return cut(document.text, value.name_at, "default")


@kind("scoping", "arg")
def declared_with_value(document: Document, element: Element, random: Random) -> Made:
    default = element.attributes.get("default")
    if default is None or element.parent is None or element.parent.tag == "include":
        return None
    return cut(document.text, default.name_at, "value"), element.attributes["name"].value


@kind("scoping", "include", dialect="xml")
def include_called_value(document: Document, element: Element, random: Random) -> Made:
    return with_attribute(document, element, "ns", "robot")


@kind("scoping", "arg", dialect="xml")
def choice_without_default(document: Document, element: Element, random: Random) -> Made:
    if element.parent is None or element.parent.tag == "include" or element.end_name_at is not None or "default" not in element.attributes:
        return None
    return cut(document.text, (element.head_end, element.at[1]), '><choice value="this"/><choice value="that"/></arg>')


@kind("scoping", "include", dialect="xml")
def included_twice(document: Document, element: Element, random: Random) -> Made:
    return cut(document.text, (element.at[1],) * 2, document.text[slice(*element.at)])


# -- params

table(
    "params",
    [
        ("type_int", ("param",), "type", ("int",)),
        ("type_float", ("param",), "type", ("float",)),
        ("type_bool", ("param",), "type", ("bool",)),
        ("type_unknown", ("param",), "type", ("double", "string", "integer", "list", "yaml_")),
        ("type_list", ("param",), "type", ("list_of_int", "list_of_str", "list_of_bool", "list_of_float")),
        ("value_is_mapping", ("param", "set_parameter"), "value",
         ("{a: 1}", "a: b", "{}", "null", "~", "[1, a]", "[1, [2]]", "2024-01-01", "[a, true]")),
        ("value_broken_yaml", ("param", "set_parameter"), "value", ("[1, 2", "{a", "'open", '"open', "a: b: c", "@x", "%x", "`x")),
        ("value_other_type", ("param", "set_parameter"), "value", ("y", "1e3", "off", "0x1F", "010", "1_000", "inf", ".5", "1.", "12:30")),
        ("value_empty", ("param", "set_parameter", "let"), "value", ("",)),
        ("value_separator", ("param",), "value-sep", (",", ";")),
        ("substitutions_allowed", ("param",), "allow_substs", ("true", "yes", "maybe")),
        ("file_not_there", ("param",), "from", ("$(dirname)/no_such_file.yaml", "no_such_file.yaml")),
    ],
)  # fmt: skip


@kind("params", "param")
def value_lost(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, random.choice(("value", "name", "from")))


@kind("params", "param", dialect="xml")
def nested_and_value(document: Document, element: Element, random: Random) -> Made:
    if element.end_name_at is not None:
        return None
    return cut(document.text, (element.head_end, element.at[1]), '><param name="inner" value="1"/></param>')


@kind("params", "param")
def file_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("from")
    if attribute is None or "$(var" in attribute.value:
        return None
    return with_value(document, attribute, attribute.value.replace(".yaml", ".yml"))


@kind("params", "param")
def name_and_file(document: Document, element: Element, random: Random) -> Made:
    return with_attribute(document, element, "from", "$(dirname)/x.yaml") if "value" in element.attributes else None


@kind("params", "param")
def param_twice(document: Document, element: Element, random: Random) -> Made:
    at = of_element(document, element)
    return None if at is None else cut(document.text, (at[1], at[1]), document.text[slice(*at)])


# -- conditions

_CONDITIONAL = ("node", "group", "include", "arg", "let", "node_container", "executable", "composable_node", "push-ros-namespace")
table(
    "conditions",
    [
        ("condition_no_boolean", _CONDITIONAL, "if", ("yes", "on", "maybe", "", "$(dirname)", "2")),
        ("condition_undefined", _CONDITIONAL, "if", ("$(var no_such_variable)",)),
        ("condition_without_dollar", _CONDITIONAL, "unless", ("var debug", "(var debug)", "not true")),
        ("condition_eval", _CONDITIONAL, "if",
         ("$(eval 'yes')", "$(eval true)", "$(eval $(var no_such_variable) == 1)", '$(eval "\'a\' == a")')),
        ("condition_odd", _CONDITIONAL, "if", (" TRUE ", "1", "False", "0")),
        ("condition_never", ("node", "group", "include", "composable_node"), "if", ("false",)),
        ("condition_on_child", ("param", "remap", "env"), "if", ("true",)),
        ("condition_equals", _CONDITIONAL, "if", ("$(equals a)", "$(equals $(var no_such_variable) a)", "$(equals 'a b' c)")),
    ],
)  # fmt: skip


# -- timers

table(
    "timers",
    [
        ("period_no_number", ("timer", "ros_timer"), "period", ("soon", "", "5s", "1,5")),
        ("period_negative", ("timer", "ros_timer"), "period", ("-1.0",)),
        ("period_undefined", ("timer", "ros_timer"), "period", ("$(var no_such_variable)",)),
    ],
)


@kind("timers", "timer", "ros_timer")
def period_lost(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, "period")


@kind("timers", "node", "include", "group", dialect="xml")
def timed(document: Document, element: Element, random: Random) -> Made:
    period = random.choice(("period='2.0'", "delay='2.0'", "period='x'", "period='-2'", ""))
    return cut(document.text, element.at, f"<timer {period}>{document.text[slice(*element.at)]}</timer>")


# -- containers


@kind("containers", "node_container")
def container_without(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, random.choice(("namespace", "name", "pkg", "exec")))


@kind("containers", "composable_node")
def component_without(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, random.choice(("plugin", "name", "pkg")))


@kind("containers", "composable_node")
def component_is_node(document: Document, element: Element, random: Random) -> Made:
    text = document.text if element.end_name_at is None else cut(document.text, element.end_name_at, "node")
    return cut(text, element.name_at, "node")


@kind("containers", "node_container")
def container_is_node(document: Document, element: Element, random: Random) -> Made:
    text = document.text if element.end_name_at is None else cut(document.text, element.end_name_at, "node")
    return cut(text, element.name_at, "node")


@kind("containers", "load_composable_node")
def target_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("target")
    return None if attribute is None or "$" in attribute.value else with_value(document, attribute, misspelt(attribute.value, random))


@kind("containers", "load_composable_node")
def target_lost(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, "target")


@kind("containers", "load_composable_node", "node_container", dialect="xml")
def components_lost(document: Document, element: Element, random: Random) -> Made:
    if element.end_name_at is None:
        return None
    return cut(document.text, (document.text.index(">", element.head_end) + 1, element.end_name_at[0] - 2))


@kind("containers", "composable_node")
def plugin_misspelt(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("plugin")
    return None if attribute is None or "$" in attribute.value else with_value(document, attribute, misspelt(attribute.value, random))


@kind("containers", "composable_node")
def component_has_process_attribute(document: Document, element: Element, random: Random) -> Made:
    name, value = random.choice((("exec", "x"), ("output", "screen"), ("args", "--x"), ("respawn", "true"), ("launch-prefix", "gdb")))
    return with_attribute(document, element, name, value)


# -- processes

_PROCESS = ("node", "node_container", "executable")
table(
    "processes",
    [
        ("output_unknown", _PROCESS, "output", ("console", "both_", "Screen", "")),
        ("respawn_no_boolean", _PROCESS, "respawn", ("yes", "always", "maybe", "")),
        ("respawn_delay_bad", _PROCESS, "respawn_delay", ("soon", "-1", "1s", "")),
        ("on_exit_unknown", _PROCESS, "on_exit", ("respawn", "Shutdown", "")),
        ("tty_bad", _PROCESS, "emulate_tty", ("sometimes", "yes", "")),
        ("shell_bad", _PROCESS, "shell", ("sometimes", "bash")),
        ("timeout_bad", _PROCESS, "sigterm_timeout", ("-5", "long", "5s")),
        ("retries_bad", _PROCESS, "respawn_max_retries", ("1.5", "many", "")),
        ("args_unbalanced", ("node", "node_container"), "args", ("--name 'open", '--name "open', "it's", "--x \\")),
        ("ros_args_bad", ("node", "node_container"), "ros_args",
         ("--log-levl debug", "-p x", "-r a", "--log-level loud", "-p a:=[1, 2", "-r __ns:=bad ns")),
        ("prefix_unbalanced", _PROCESS, "launch-prefix", ("gdb -ex 'run", 'xterm -e "')),
        ("cwd_not_there", _PROCESS, "cwd", ("/no/such/folder",)),
    ],
)  # fmt: skip


@kind("processes", "env")
def env_without(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, random.choice(("name", "value")))


@kind("processes", *STARTED)
def attribute_upper(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    attribute = random.choice(list(element.attributes.values()))
    return cut(document.text, attribute.name_at, document.text[slice(*attribute.name_at)].upper())
