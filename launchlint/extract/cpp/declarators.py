"""Declarators of C++: the name that one declares, and whether that is a function, a pointer or an array."""

from __future__ import annotations

from launchlint.extract.cpp.syntax import Node

_WRAPPERS = (
    "pointer_declarator",
    "reference_declarator",
    "parenthesized_declarator",
    "array_declarator",
    "init_declarator",
    "attributed_declarator",
)
_DEEPEST = 60


def name_of(declarator: Node | None) -> str:
    """The name that a declarator declares."""
    for _ in range(_DEEPEST):
        if declarator is None:
            return ""
        inner = declarator.fields.get("declarator")
        if inner is None and declarator.kind in _WRAPPERS and declarator.children:
            inner = declarator.children[-1]
        if inner is None:
            return without_arguments(declarator.text).replace(" ", "") if declarator.kind in _NAMES else ""
        declarator = inner
    return ""


_NAMES = (
    "identifier",
    "field_identifier",
    "type_identifier",
    "qualified_identifier",
    "destructor_name",
    "operator_name",
    "template_function",
)


def function_name(named: Node) -> str:
    """The name of a function: ``a::B::c``, ``B::operator<<``, ``B::~B``."""
    last = named
    while last.kind == "qualified_identifier" and (inner := last.fields.get("name")) is not None:
        last = inner
    if last.kind != "operator_name":
        return without_arguments(named.text).replace(" ", "")
    before = without_arguments(named.text[: len(named.text) - len(last.text)])
    return (before + last.text).replace(" ", "")


def function_declarator(declarator: Node | None) -> Node | None:
    """The part of a declarator that has parameters; None where it declares no function."""
    for _ in range(_DEEPEST):
        if declarator is None or declarator.kind == "function_declarator":
            return declarator
        if declarator.kind not in _WRAPPERS or declarator.kind == "init_declarator":
            return None
        declarator = declarator.fields.get("declarator") or (declarator.children[-1] if declarator.children else None)
    return None


def is_pointer_to_function(function: Node) -> bool:
    """Whether a function declarator declares a pointer to a function."""
    inner = function.fields.get("declarator")
    return inner is not None and inner.kind == "parenthesized_declarator"


def is_pointer(declarator: Node | None) -> bool:
    """Whether it declares a pointer or a reference."""
    for _ in range(_DEEPEST):
        if declarator is None:
            return False
        if declarator.kind in ("pointer_declarator", "reference_declarator"):
            return True
        declarator = declarator.fields.get("declarator")
    return False


def is_array(declarator: Node | None) -> bool:
    """Whether it declares an array."""
    for _ in range(_DEEPEST):
        if declarator is None:
            return False
        if declarator.kind == "array_declarator":
            return True
        declarator = declarator.fields.get("declarator")
    return False


def without_arguments(text: str) -> str:
    """``a::B<T>::c`` as ``a::B::c``."""
    if "<" not in text:
        return text
    level = 0
    kept: list[str] = []
    for char in text:
        if char == "<":
            level += 1
        elif char == ">":
            level -= 1
        elif level == 0:
            kept.append(char)
    return "".join(kept)
