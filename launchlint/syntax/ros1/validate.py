"""One walk over the tree of a launch file: everything that can be told from one element and its parent alone.

Elements with a false ``if`` are looked at too, which roslaunch does not do: what is wrong there is found on the day
somebody switches it on. Where the condition is literally false, ``refused`` is not set. (With an ``if`` that depends on an
arg it is: whether roslaunch gets there is the evaluator's to say.)
"""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.late import late
from launchlint.problem import Problem
from launchlint.source import Span
from launchlint.syntax.parts import Malformed, Substitution
from launchlint.syntax.problems import (
    ArgValueAndDefault,
    ConflictingAttributes,
    DeprecatedConstruct,
    IfAndUnless,
    IneffectiveAttribute,
    InvalidValue,
    MisplacedTag,
    MissingAttribute,
    StrayText,
    UnknownAttribute,
    UnknownTag,
    WrongDialect,
)
from launchlint.syntax.ros1.dialect import (
    PARAM_SOURCES,
    ROS2_ATTRIBUTES,
    ROS2_SUBSTITUTIONS,
    ROS2_TAGS,
    TAGS,
    AttributeRule,
    TagRule,
    tag_for,
)
from launchlint.syntax.ros1.domains import CONDITION, PARAM_TYPE, TEXT, Domain, parse_condition, parse_flag, parse_number
from launchlint.syntax.ros1.problems import (
    arg_value_and_default,
    conflicting_attributes,
    deprecated_construct,
    if_and_unless,
    ineffective_attribute,
    invalid_value,
    misplaced_tag,
    missing_attribute,
    stray_text,
    unknown_attribute,
    unknown_tag,
    wrong_dialect,
)
from launchlint.syntax.ros1.substitutions import opens, parts_of
from launchlint.syntax.tree import Attribute, Document, Element

__all__ = ["KINDS", "validate"]

KINDS = (
    UnknownTag,
    UnknownAttribute,
    MissingAttribute,
    MisplacedTag,
    StrayText,
    IfAndUnless,
    InvalidValue,
    ConflictingAttributes,
    ArgValueAndDefault,
    IneffectiveAttribute,
    DeprecatedConstruct,
    WrongDialect,
)
"""Every kind of problem :func:`validate` can make."""

_XACRO = late(r"(?<![\w.-])xacro\.py(?![\w.-])")
_NO_DOLLAR = Domain("fixed-condition", "true, false, 1 or 0 (no $(…) on <launch>)", parse_condition, CONDITION.choices)


def validate(document: Document) -> list[Problem]:
    """The problems of ``document.launch`` and all below it, in document order.

    They are of the :data:`KINDS`.
    """
    launch = document.launch
    if launch is None:
        return []
    return _Validator(document).walk(launch)


class _Validator:
    __slots__ = ("_document", "_problems")

    def __init__(self, document: Document) -> None:
        self._document = document
        self._problems: list[Problem] = []

    def walk(self, launch: Element) -> list[Problem]:
        stack: list[tuple[Element, TagRule, bool]] = [(launch, TAGS["launch"], False)]
        problems = self._problems
        while stack:
            element, rule, dead = stack.pop()
            before = len(problems)
            dead = dead or (rule.tag != "launch" and _literally_off(element))
            self._element(element, rule)
            if element.texts:
                self._texts(element, rule)
            below: list[tuple[Element, TagRule, bool]] = []
            for child in element.children:
                child_rule = self._child(child, element, rule)
                if child_rule is not None:
                    below.append((child, child_rule, dead))
            below.reverse()
            stack.extend(below)
            if dead:
                problems[before:] = [problem.but(refused=False) for problem in problems[before:]]
        problems.sort(key=lambda problem: problem.origin.place.span)
        return problems

    # ---- tags

    def _child(self, child: Element, parent: Element, parent_rule: TagRule) -> TagRule | None:
        """The rule for ``child``; ``None``, with a problem recorded, where it does not belong."""
        rule = tag_for(child.tag, parent_rule)
        document = self._document
        if rule is not None and rule.tag in parent_rule.children:
            if rule.status != "defunct":
                return rule
            self._problems.append(deprecated_construct(document, child.name_span, f"<{rule.tag}>", rule.instead))
        elif parent_rule.tag == "machine" and child.tag == "env":
            self._problems.append(deprecated_construct(document, child.name_span, "machine env", "env-loader", refused=True))
        elif rule is not None:
            self._problems.append(misplaced_tag(document, child, parent_rule.tag, parent_rule.children_noticed))
        elif child.tag in ROS2_TAGS:
            self._problems.append(wrong_dialect(document, child, child.name_span, "tag", child.tag, ROS2_TAGS[child.tag]))
        else:
            self._problems.append(unknown_tag(document, child, parent_rule.tag, parent_rule.children, not parent_rule.children_noticed))
        return None

    # ---- text

    def _texts(self, element: Element, rule: TagRule) -> None:
        because = "tag"
        if rule.text:
            command = element.get("command") or "load"
            because = command if command in ("dump", "delete") else "file" if element.get("file") else ""
            if not because:
                return
        for text in element.texts:
            value = text.value.strip()
            if value:
                raw, start = text.raw, text.span.start
                lead = len(raw) - len(raw.lstrip())
                self._problems.append(stray_text(self._document, Span(start + lead, start + len(raw.rstrip())), value, rule.tag, because))

    # ---- attributes

    def _element(self, element: Element, rule: TagRule) -> None:
        attributes = element.attributes
        problems = self._problems
        document = self._document
        foreign = ROS2_ATTRIBUTES.get(rule.tag, {})
        ros2 = False
        for name, attribute in attributes.items():
            known = rule.attribute(name)
            if known is None:
                if name in foreign:
                    ros2 = True
                    problems.append(wrong_dialect(document, element, attribute.name_span, "attribute", name, foreign[name]))
                elif not (rule.tag == "launch" and _is_foreign(name, attributes)):
                    problems.append(unknown_attribute(document, element, rule, name))
                continue
            self._attribute(element, rule, known, attribute)
        if "if" in attributes and "unless" in attributes:
            problems.append(if_and_unless(document, element))
        foreign_node = ros2 and ("exec" in attributes or rule.tag == "param")
        if foreign_node:
            # roslaunch misses the attributes that ROS 2 spells differently: that is said already.
            at, foreigner = next((index, each) for index, each in reversed([*enumerate(problems)])
                                 if isinstance(each, WrongDialect) and each.construct in ("exec", "from"))  # fmt: skip
            problems[at] = foreigner.but(refused=True)
            return
        for name in rule.required:
            if name not in attributes:
                problems.append(missing_attribute(document, element, name))
        self._together(element, rule)

    def _attribute(self, element: Element, rule: TagRule, known: AttributeRule, attribute: Attribute) -> None:
        problems = self._problems
        document = self._document
        value = attribute.value
        if opens(value):
            self._substitutions(element, attribute)
        if known.domain is not TEXT:
            domain = known.domain
            if rule.tag == "launch":
                # The condition of <launch> is read without a context: any $ is an AttributeError (XmlLoader._launch_tag).
                if "$" in value or domain.problem(value) is not None:
                    problems.append(invalid_value(document, element, known.name, value, _NO_DOLLAR))
                else:
                    problems.append(ineffective_attribute(document, element, "condition-on-launch", known.name))
            elif domain is PARAM_TYPE:
                # Not substituted, and not looked at for a binfile.
                if domain.problem(value) is not None and "binfile" not in element.attributes:
                    problems.append(invalid_value(document, element, known.name, value, domain))
            elif not opens(value) and domain.problem(value) is not None:
                problems.append(invalid_value(document, element, known.name, value, domain))
        if known.status == "refused":
            if rule.tag == "test":
                problems.append(conflicting_attributes(document, element, "test-attribute", (known.name,)))
            else:
                construct = f"{rule.tag} {known.name}"
                problems.append(deprecated_construct(document, attribute.name_span, construct, known.instead, refused=bool(value)))
        elif known.status == "deprecated":
            problems.append(deprecated_construct(document, attribute.name_span, f"{rule.tag} {known.name}", known.instead))
        elif known.status == "ineffective" and rule.tag == "test":
            problems.append(ineffective_attribute(document, element, "required-on-test", known.name))
        if "xacro.py" in value and rule.tag in ("param", "arg"):
            for match in _XACRO.finditer(value):
                span = attribute.span_of(*match.span())
                problems.append(deprecated_construct(document, span, "xacro.py", "xacro (ROS Noetic has no xacro.py any more)"))

    def _substitutions(self, element: Element, attribute: Attribute) -> None:
        parts = parts_of(attribute)
        for part in parts.parts:
            if not isinstance(part, (Substitution, Malformed)) or not part.words:
                continue
            command = part.words[0].text
            if command in ROS2_SUBSTITUTIONS:
                span = attribute.span_of(part.start, part.end)
                construct, instead = f"$({command} …)", ROS2_SUBSTITUTIONS[command]
                self._problems.append(wrong_dialect(self._document, element, span, "substitution", construct, instead, refused=True))
            if part is parts.refused:
                return  # what follows stands inside of it

    def _together(self, element: Element, rule: TagRule) -> None:
        """What depends on several attributes or on the content."""
        attributes = element.attributes
        problems = self._problems
        document = self._document
        tag = rule.tag
        if tag in ("group", "node", "test", "include"):
            if element.get("ns") == "":
                problems.append(conflicting_attributes(document, element, "empty-ns", ("ns",)))
            elif tag in ("group", "include") and "ns" not in attributes and _flag(element, "clear_params"):
                problems.append(conflicting_attributes(document, element, "clear-params-without-ns", ("clear_params",)))
        if tag == "node":
            if _flag(element, "respawn") and _flag(element, "required"):
                problems.append(conflicting_attributes(document, element, "respawn-and-required", ("respawn", "required")))
            if "respawn_delay" in attributes:
                if _flag(element, "respawn") is False:
                    problems.append(ineffective_attribute(document, element, "respawn-delay-without-respawn", "respawn_delay"))
                elif _negative(attributes["respawn_delay"].value):
                    problems.append(ineffective_attribute(document, element, "negative-respawn-delay", "respawn_delay"))
        elif tag == "param":
            sources = tuple(name for name in PARAM_SOURCES if name in attributes)
            if len(sources) != 1:
                problems.append(conflicting_attributes(document, element, "param-sources", sources))
        elif tag == "arg":
            if "value" in attributes and "default" in attributes:
                problems.append(arg_value_and_default(document, element))
        elif tag == "rosparam":
            self._rosparam(element)
        elif tag == "group" and not element.children and "clear_params" not in attributes:
            problems.append(ineffective_attribute(document, element, "empty-group", ""))

    def _rosparam(self, element: Element) -> None:
        command = element.get("command") or "load"
        if command == "delete" and "file" in element.attributes:
            self._problems.append(conflicting_attributes(self._document, element, "delete-with-file", ("command", "file")))
        elif command == "dump" and "file" not in element.attributes:
            # Loads, and fails when the rosparam step is run.
            self._problems.append(missing_attribute(self._document, element, "file", refused=False))
        elif command == "load" and "file" not in element.attributes and not element.text.strip():
            self._problems.append(ineffective_attribute(self._document, element, "empty-rosparam", ""))


def _is_foreign(name: str, attributes: Mapping[str, Attribute]) -> bool:
    """Whether an attribute of ``<launch>`` belongs to another vocabulary, such as ``xsi:noNamespaceSchemaLocation``, or declares one."""
    prefix, colon, _ = name.partition(":")
    return prefix == "xmlns" or (bool(colon) and f"xmlns:{prefix}" in attributes)


def _literally_off(element: Element) -> bool:
    """Is the condition a literal that switches the element off? Of two conditions roslaunch takes neither: it stops."""
    if "if" in element.attributes and "unless" in element.attributes:
        return False
    for name, off in (("if", False), ("unless", True)):
        value = element.get(name)
        if value is not None and not opens(value):
            try:
                if parse_condition(value) is off:
                    return True
            except ValueError:
                pass  # reported as invalid-value
    return False


def _flag(element: Element, name: str) -> bool | None:
    """A literal flag; false where it is not given, ``None`` where it cannot be told."""
    value = element.get(name)
    if value is None:
        return False
    try:
        return parse_flag(value)
    except ValueError:
        return None


def _negative(value: str) -> bool:
    try:
        return parse_number(value) < 0
    except ValueError:
        return False
