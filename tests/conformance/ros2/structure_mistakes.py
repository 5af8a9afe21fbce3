"""Mistakes in the structure of a file, XML or YAML: see :mod:`.mutations`."""

from __future__ import annotations

from random import Random

from tests.conformance.ros2.elements import Document, Element
from tests.conformance.ros2.mutations import (
    cut,
    kind,
    misspelt,
    with_attribute,
    with_raw,
    without,
)

Made = str | tuple[str, str] | None

# -- structure


@kind("structure")
def tag_misspelt(document: Document, element: Element, random: Random) -> Made:
    if element.parent is None:
        return None
    word = misspelt(element.tag, random)
    text = document.text
    if element.end_name_at is not None:
        text = cut(text, element.end_name_at, word)
    return cut(text, element.name_at, word)


@kind("structure")
def attribute_misspelt(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    attribute = random.choice(list(element.attributes.values()))
    name = document.text[slice(*attribute.name_at)]
    return cut(document.text, attribute.name_at, misspelt(name, random))


@kind("structure")
def attribute_lost(document: Document, element: Element, random: Random) -> Made:
    return without(document, element, random.choice(list(element.attributes))) if element.attributes else None


@kind("structure", "node", "include", "param", "group")
def attribute_of_ros1(document: Document, element: Element, random: Random) -> Made:
    name, value = random.choice(
        (("type", "talker"), ("ns", "robot"), ("required", "true"), ("clear_params", "true"), ("pass_all_args", "true"))
    )
    return None if name in element.attributes else with_attribute(document, element, name, value)


@kind("structure", "node")
def exec_called_type(document: Document, element: Element, random: Random) -> Made:
    attribute = element.attributes.get("exec")
    return None if attribute is None else cut(document.text, attribute.name_at, "type")


@kind("structure", "launch", dialect="xml")
def tag_of_ros1(document: Document, element: Element, random: Random) -> Made:
    tag = random.choice(
        ('<rosparam command="load" file="x.yaml"/>', '<machine name="m" address="h"/>', '<test test-name="t" pkg="p" type="t"/>')
    )
    return cut(document.text, (element.end_name_at[0] - 2,) * 2, f"{tag}\n") if element.end_name_at else None


@kind("structure", dialect="xml")
def end_tag_lost(document: Document, element: Element, random: Random) -> Made:
    return None if element.end_name_at is None else cut(document.text, (element.end_name_at[0] - 2, element.at[1]))


@kind("structure", dialect="xml")
def slash_lost(document: Document, element: Element, random: Random) -> Made:
    return None if element.end_name_at is not None else cut(document.text, (element.at[1] - 2, element.at[1]), ">")


@kind("structure", dialect="xml")
def quote_lost(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    attribute = random.choice(list(element.attributes.values()))
    return cut(document.text, (attribute.value_at[1] - 1, attribute.value_at[1]))


@kind("structure", dialect="xml")
def bare_sign(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    attribute = random.choice(list(element.attributes.values()))
    return cut(document.text, (attribute.value_at[1] - 1,) * 2, random.choice((" && true", "<", "&")))


@kind("structure", dialect="xml")
def attribute_twice(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    attribute = random.choice(list(element.attributes.values()))
    return cut(document.text, (element.head_end,) * 2, document.text[slice(*attribute.at)])


@kind("structure", "launch", dialect="xml")
def comment_never_ends(document: Document, element: Element, random: Random) -> Made:
    return cut(document.text, (element.head_end + 1,) * 2, "<!-- -- todo -->")


@kind("structure", "launch")
def root_misspelt(document: Document, element: Element, random: Random) -> Made:
    text = document.text if element.end_name_at is None else cut(document.text, element.end_name_at, "lauch")
    return cut(text, element.name_at, "lauch")


@kind("structure", "launch", dialect="xml")
def more_behind_root(document: Document, element: Element, random: Random) -> Made:
    return cut(document.text, (element.at[1],) * 2, '\n<arg name="late" default="1"/>\n')


@kind("structure", "param", "remap", "env", "composable_node", "choice", "extra_arg", dialect="xml")
def child_outside(document: Document, element: Element, random: Random) -> Made:
    """Moved behind its parent."""
    parent = element.parent
    if parent is None or parent.parent is None:
        return None
    text = document.text
    return text[: element.at[0]] + text[element.at[1] : parent.at[1]] + text[slice(*element.at)] + text[parent.at[1] :]


@kind("structure", "node", "include", "let", "arg", "set_remap", dialect="xml")
def action_in_node(document: Document, element: Element, random: Random) -> Made:
    """Moved into a node."""
    if element.parent is None or element.parent.tag not in ("launch", "group"):
        return None
    holder = next((each for each in document.elements if each.tag == "node" and each.end_name_at and each.at[0] > element.at[1]), None)
    if holder is None or holder.end_name_at is None:
        return None
    text, end = document.text, holder.end_name_at[0] - 2
    return text[: element.at[0]] + text[element.at[1] : end] + text[slice(*element.at)] + text[end:], "name"


@kind("structure", "node", "group", "include", "arg")
def if_and_unless(document: Document, element: Element, random: Random) -> Made:
    text = with_attribute(document, element, "if", "true")
    if text is None or "if" in element.attributes or "unless" in element.attributes:
        return None
    if not document.yaml:
        return cut(document.text, (element.head_end,) * 2, ' if="true" unless="false"')
    return (
        text.replace('if: "true"', 'unless: "false", if: "true"' if 'if: "true",' in text else 'if: "true"', 1)
        if 'if: "true",' in text
        else None
    )


@kind("structure", dialect="yaml")
def indented_more(document: Document, element: Element, random: Random) -> Made:
    lines = document.text.splitlines(keepends=True)
    at = random.choice([number for number, line in enumerate(lines) if line.strip() and not line.lstrip().startswith("#")])
    return "".join((*lines[:at], " " + lines[at], *lines[at + 1 :])), lines[at].strip()


@kind("structure", dialect="yaml")
def indented_less(document: Document, element: Element, random: Random) -> Made:
    lines = document.text.splitlines(keepends=True)
    indented = [number for number, line in enumerate(lines) if line.startswith("  ") and not line.lstrip().startswith("#")]
    if not indented:
        return None
    at = random.choice(indented)
    return "".join((*lines[:at], lines[at][2:], *lines[at + 1 :])), lines[at].strip()


@kind("structure", dialect="yaml")
def dash_lost(document: Document, element: Element, random: Random) -> Made:
    return None if element.parent is None else cut(document.text, (element.at[0], element.at[0] + 1), " ")


@kind("structure", dialect="yaml")
def tab_indents(document: Document, element: Element, random: Random) -> Made:
    line = document.text.rfind("\n", 0, element.at[0]) + 1
    return None if line == element.at[0] else cut(document.text, (line, element.at[0]), "\t")


@kind("structure", dialect="yaml")
def colon_lost(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    end = random.choice(list(element.attributes.values())).name_at[1]
    return cut(document.text, (end, end + 1))


@kind("structure", dialect="yaml")
def blank_after_colon_lost(document: Document, element: Element, random: Random) -> Made:
    if not element.attributes:
        return None
    end = random.choice(list(element.attributes.values())).name_at[1]
    return cut(document.text, (end + 1, end + 2))


@kind("structure", dialect="yaml")
def quote_lost_in_yaml(document: Document, element: Element, random: Random) -> Made:
    quoted = [each for each in element.attributes.values() if document.text[each.value_at[0]] in "\"'"]
    return cut(document.text, ((end := random.choice(quoted).value_at[1]) - 1, end)) if quoted else None


@kind("structure", "launch", dialect="yaml")
def second_root(document: Document, element: Element, random: Random) -> Made:
    return document.text.rstrip("\n") + "\nversion: 1\n"


@kind("structure", "node", "include", "composable_node", "node_container", dialect="yaml")
def key_twice(document: Document, element: Element, random: Random) -> Made:
    name = random.choice(list(element.attributes))
    return with_raw(document, element, name, "other")


@kind("structure", "node", "arg", "let", "include", "param", "timer", dialect="yaml")
def number_or_boolean(document: Document, element: Element, random: Random) -> Made:
    names = [each for each in element.attributes if each != "value" or element.tag != "param"]
    if not names:
        return None
    return cut(
        document.text, element.attributes[random.choice(names)].value_at, random.choice(("5", "true", "1.5", "~", "[a, b]", "{a: b}"))
    )


@kind("structure", "param", "remap", "env", dialect="yaml")
def list_is_mapping(document: Document, element: Element, random: Random) -> Made:
    """The list of children becomes one mapping."""
    if element.parent is None or len([each for each in element.parent.children if each.tag == element.tag]) != 1:
        return None
    return cut(document.text, (element.at[0], element.at[0] + 1), " ")
