"""What the files of a program declare: classes, functions, variables, names of types, macros and included messages."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from launchlint.extract.cpp.declarators import (
    function_declarator,
    function_name,
    is_array,
    is_pointer,
    is_pointer_to_function,
    name_of,
    without_arguments,
)
from launchlint.extract.cpp.spelled_type import UNTYPED, Type, parse_type
from launchlint.extract.cpp.syntax import Node
from launchlint.named_tuple import NamedTuple

_SCOPES = frozenset(
    """translation_unit declaration_list linkage_specification preproc_if preproc_ifdef preproc_else preproc_elif preproc_elifdef ERROR
    access_specifier field_declaration_list friend_declaration""".split()
)
_DEEPEST = 60
_ASSIGNED = re.compile(
    r"\b([A-Za-z_]\w*)\s*(?:=(?!=)|\+\+|--|[-+*/|&]=)|(?:\+\+|--)\s*([A-Za-z_]\w*)"
    r"|[(,]\s*&\s*(?:[A-Za-z_]\w*(?:->|\.))*([A-Za-z_]\w*)\s*(?=[,)])"
)
"""By itself, or through its address, which is given to a function."""
_MESSAGE = re.compile(r"(\w+)/(\w+)\.h|(\w+)/(msg|srv|action)/(?:detail/)?(\w+?)(?:__\w+)?\.hpp")
_MADE = re.compile(r"(?:=\s*(?:0|default|delete)|\{\s*\})\s*(?:;\s*)?$")
_VIRTUAL = re.compile(r"\b(?:virtual|override|final)\b")
_OF_CONSTANT = re.compile(r"\)\s*const\b")
_TEST = re.compile(r"(?:TYPED_)?TEST(?:_[FP])?|TYPED_TEST_P|BOOST_\w{0,200}TEST_CASE\w*|TEST_CASE\w*|SCENARIO\w*")
_OF_ROS = re.compile(r"(?:ros|nodelet|tf|tf2_ros|actionlib|image_transport|rclcpp|rclcpp_\w+|\w+_msgs|\w+_srvs)/")
_QUALIFIED = re.compile(r"(?:::)?[A-Za-z_]\w{0,100}(?:::[A-Za-z_]\w{0,100}){1,8}")


class Parameter(NamedTuple):
    """A parameter of a function; ``shared`` says that it is a reference or a pointer."""

    name: str
    type: Type
    shared: bool
    default: Node | None


class Signature(NamedTuple):
    """What the source says of a function, whatever else its program has; the fields are those of :class:`Function`."""

    name: str
    parameters: tuple[Parameter, ...]
    returns: Type
    body: Node | None
    initialisers: Node | None
    absent: bool
    overrides: bool
    of_constant: bool
    line: int


class Function:
    """A function with its body, or without one where only its prototype is known.

    ``name`` is qualified, ``last`` is what it is called without the scope; ``scope`` is the namespace or class that names in it are looked
    up from. ``absent`` is a prototype whose body stands elsewhere, other than of a pure virtual function or one that the compiler makes.
    ``overrides``: it is virtual, or overrides one. ``of_constant``: it is a member function of a constant object.
    """

    __slots__ = (
        "absent", "body", "initialisers", "last", "line", "name", "of_constant", "overrides", "owner", "parameters", "path", "relevant",
        "returns", "scope", "template",
    )  # fmt: skip

    def __init__(self, name: str, scope: str, signature: Signature, path: str, template: tuple[str, ...]) -> None:
        self.name = name
        self.last = name.rpartition("::")[2]
        self.scope = scope
        _, self.parameters, self.returns, self.body, self.initialisers, self.absent, self.overrides, self.of_constant, self.line = signature
        self.path = path
        self.template = template
        self.owner = ""
        self.relevant: bool | None = None

    @property
    def text(self) -> str:
        """The source of its body, and of its list of initialisers."""
        own = self.body.text if self.body is not None else ""
        return own if self.initialisers is None else own + self.initialisers.text

    def __repr__(self) -> str:
        return f"Function({self.name}, {self.path}:{self.line})"


class Field(NamedTuple):
    """A member variable, or a variable of a namespace."""

    type: Type
    initial: Node | None
    scope: str
    path: str
    constant: bool
    array: bool = False
    pointer: bool = False


class Class:
    """A class or struct."""

    __slots__ = ("bases", "fields", "name", "path", "scope", "template")

    def __init__(self, name: str, scope: str, bases: tuple[Type, ...], template: tuple[str, ...], path: str) -> None:
        self.name = name
        self.scope = scope
        self.bases = bases
        self.template = template
        self.fields: dict[str, Field] = {}
        self.path = path


class Declarations:
    """Everything that the files of one program declare, by qualified name (``ns::Class::member``)."""

    def __init__(self) -> None:
        self.classes: dict[str, Class] = {}
        self.functions: dict[str, list[Function]] = {}
        self.variables: dict[str, Field] = {}
        self.aliases: dict[str, tuple[Type, str]] = {}
        self.alias_templates: dict[str, tuple[str, ...]] = {}
        self.namespaces: dict[str, str] = {}
        self.used: dict[str, None] = {}
        self.macros: dict[str, str] = {}
        self.calls: dict[str, tuple[tuple[str, ...], str]] = {}
        self.constants: dict[str, tuple[Node | None, int]] = {}
        self.messages: dict[str, None] = {}
        self.opened: dict[str, list[str]] = {}
        """Namespaces that are declared, with those that using directives in them name."""
        self.invocations: list[tuple[Node, str]] = []
        self.tests: list[Function] = []
        """Macros that are called outside of functions, with the files that they stand in."""
        self.of_ros: set[str] = set()
        """Files that include headers of ROS."""
        self._owned: list[Function] = []
        self._unnamed = 0  # namespaces without a name around what is being read
        self._local: set[str] = set()  # classes in those: nothing of another file belongs to them
        self._strange: set[tuple[str, str]] = set()  # second classes of a name, of which one is local, with their files
        self._assigned: set[str] | None = None
        self._members: dict[str, list[tuple[str, list[Function]]]] | None = None

    # -- reading ------------------------------------------------------------------------------------------------------

    def read(self, root: Node, path: str) -> None:
        """Add what a file declares."""
        self._scope(root.children, "", path, (), 0)

    def _scope(self, nodes: Iterable[Node], scope: str, path: str, template: tuple[str, ...], depth: int) -> None:
        if depth > _DEEPEST:
            return
        for node in nodes:
            self._declaration(node, scope, path, template, depth)

    def _declaration(self, node: Node, scope: str, path: str, template: tuple[str, ...], depth: int) -> None:
        kind = node.kind
        if kind == "function_definition" or kind == "inline_method_definition":
            self._types_in(node, scope, path, depth)
            self._function(node, node.fields.get("declarator"), scope, path, template)
        elif kind in ("declaration", "field_declaration"):
            self._types_in(node, scope, path, depth, template)
            self._variables(node, scope, path, template)
        elif kind in ("class_specifier", "struct_specifier", "union_specifier"):
            self._class(node, scope, path, template, depth)
        elif kind == "namespace_definition":
            name = node.fields.get("name")
            body = node.fields.get("body")
            inner = joined(scope, _spelled(name).replace(" ", "")) if name else scope
            if body:
                self.opened.setdefault(inner, [])
                self._unnamed += name is None
                self._scope(body.children, inner, path, (), depth + 1)
                self._unnamed -= name is None
        elif kind == "template_declaration":
            names = _template(node.fields.get("parameters"))
            self._scope(
                [each for each in node.children if each.kind != "template_parameter_list"], scope, path, template + names, depth + 1
            )
        elif kind == "type_definition":
            self._types_in(node, scope, path, depth)
            named = node.fields.get("type")
            for declarator in node.every("declarator"):
                called = name_of(declarator)
                if named and called and joined(scope, called) not in self.classes:
                    self.aliases.setdefault(joined(scope, called), (parse_type(_type_text(named)), scope))
        elif kind == "alias_declaration":
            name, named = node.fields.get("name"), node.fields.get("type")
            if name and named and joined(scope, name.text) not in self.aliases:
                self.aliases[joined(scope, name.text)] = (parse_type(named.text), scope)
                if template:
                    self.alias_templates[joined(scope, name.text)] = template
        elif kind == "using_declaration":
            self.using(node, scope, self.opened.get(scope))
        elif kind == "namespace_alias_definition":
            name = node.fields.get("name")
            others = [each for each in node.children if each is not name]
            if name and others:
                self.namespaces.setdefault(joined(scope, name.text), others[-1].text.removeprefix("::"))
        elif kind == "enum_specifier":
            self._enum(node, scope)
        elif kind == "preproc_def":
            name, value = node.fields.get("name"), node.fields.get("value")
            if name and value:
                text = value.text.strip()
                self.macros.setdefault(name.text, text)
                if _QUALIFIED.fullmatch(text):
                    self.aliases.setdefault(name.text, (parse_type(text), ""))  # it may stand for a class
        elif kind == "preproc_function_def":
            name, value, parameters = node.fields.get("name"), node.fields.get("value"), node.fields.get("parameters")
            if name and value and parameters:
                self.calls.setdefault(name.text, (tuple(each.text for each in parameters.children), value.text.replace("\\\n", " ")))
        elif kind == "preproc_include":
            where = node.fields.get("path")
            match = _MESSAGE.fullmatch(where.text.strip('<>"')) if where else None
            if where is not None and _OF_ROS.match(where.text.strip('<>"')):
                self.of_ros.add(path)
            if match:
                self.messages[f"{match[1]}/{match[2]}" if match[1] else f"{match[3]}/{match[4]}/{match[5]}"] = None
        elif kind == "expression_statement":
            self.invocations += [(each, path) for each in node.children if each.kind == "call_expression"]
        elif kind in _SCOPES:
            if kind == "preproc_if" and _is_zero(node.fields.get("condition")):
                rest = node.fields.get("alternative")
                self._scope([rest] if rest else [], scope, path, template, depth + 1)
            else:
                self._scope(node.children, scope, path, template, depth + 1)

    def _types_in(self, node: Node, scope: str, path: str, depth: int, template: tuple[str, ...] = ()) -> None:
        named = node.fields.get("type")
        if named and named.kind in ("class_specifier", "struct_specifier", "enum_specifier", "union_specifier"):
            if named.fields.get("name") is None and named.kind != "enum_specifier":
                declarator = node.fields.get("declarator")
                name = name_of(declarator) if declarator else ""
                # A struct without a name is called by what is declared with it.
                self._class(named, scope, path, template, depth, name)
            else:
                self._declaration(named, scope, path, template, depth + 1)

    def _class(self, node: Node, scope: str, path: str, template: tuple[str, ...], depth: int, called: str = "") -> None:
        name, body = node.fields.get("name"), node.fields.get("body")
        if body is None or (name is None and not called):
            return
        plain = without_arguments(name.text) if name else called
        qualified = joined(scope, plain)
        clause = node.child("base_class_clause")
        kinds = ("type_identifier", "qualified_identifier", "template_type")
        bases = [parse_type(each.text) for each in (clause.children if clause else ()) if each.kind in kinds]
        before = self.classes.get(qualified)
        if before is not None and before.path != path and (self._unnamed or qualified in self._local):
            self._strange.add((qualified, path))
            return
        if self._unnamed:
            self._local.add(qualified)
        found = self.classes.setdefault(qualified, Class(qualified, scope, tuple(bases), template, path))
        if bases and not found.bases:
            found.bases = tuple(bases)
        self._scope(body.children, qualified, path, (), depth + 1)

    def _enum(self, node: Node, scope: str) -> None:
        """Enumerators: each is the last one that is given a value, and how many it stands behind that."""
        name, body = node.fields.get("name"), node.fields.get("body")
        last: Node | None = None
        behind = 0
        for each in body.children if body else ():
            named, value = each.fields.get("name"), each.fields.get("value")
            if named is None:
                continue
            last, behind = (value, 0) if value is not None else (last, behind)
            self.constants.setdefault(joined(scope, named.text), (last, behind))
            if name:
                self.constants.setdefault(joined(joined(scope, name.text), named.text), (last, behind))
            behind += 1

    def using(self, node: Node, scope: str, opened: list[str] | None = None) -> bool:
        """A using declaration or directive, and whether it is a new one; ``opened`` are those of the namespace that it stands in."""
        named = node.children[-1] if node.children else None
        if named is None:
            return False
        text = named.text.removeprefix("::")
        last = text.rpartition("::")[2]
        if last == text.rpartition("::")[0].rpartition("::")[2]:
            return False  # the constructors of a base class are inherited
        known = len(self.used) + len(self.aliases)
        if "namespace" in node.text.split(named.text)[0].split():
            self.used[text] = None
            if opened is not None:
                opened.append(text)
        else:
            self.aliases.setdefault(joined(scope, last), (Type(text), ""))
        return len(self.used) + len(self.aliases) > known

    def _variables(self, node: Node, scope: str, path: str, template: tuple[str, ...]) -> None:
        named = node.fields.get("type")
        declarators = node.every("declarator")
        if not named:
            # A constructor or destructor has no type.
            for declarator in declarators:
                self._function(node, declarator, scope, path, template)
            return
        initials = node.every("default_value")
        shared = _type_text(named)
        constant = any(each.kind == "type_qualifier" and each.text in ("const", "constexpr") for each in node.children)
        for declarator in declarators:
            # The initial value of a field stands behind its declarator.
            initial = next((each for each in initials if _between(node, declarator, each)), None)
            function = function_declarator(declarator)
            if function is not None:
                if declarator.kind == "init_declarator" or is_pointer_to_function(function):
                    self._variable(declarator, parse_type(shared), initial, scope, path, constant)
                else:
                    self._function(node, declarator, scope, path, template)
                continue
            self._variable(declarator, parse_type(shared) if shared else UNTYPED, initial, scope, path, constant)

    def _variable(self, declarator: Node, type_: Type, initial: Node | None, scope: str, path: str, constant: bool) -> None:
        name = name_of(declarator)
        if declarator.kind == "init_declarator":
            initial = declarator.fields.get("value")
        if not name:
            return
        if not type_.name and not initial:
            return
        if not type_.name and joined(scope, name) in self.classes:
            type_ = Type(joined(scope, name))
        qualified = joined(scope, name)
        array = is_array(declarator)
        found = Field(type_, initial, scope, path, constant, array, is_pointer(declarator))
        owner = self.classes.get(scope)
        if owner is not None:
            owner.fields.setdefault(name, found)
        elif qualified not in self.variables or self.variables[qualified].initial is None:
            self.variables[qualified] = found

    def _function(self, node: Node, declarator: Node | None, scope: str, path: str, template: tuple[str, ...]) -> None:
        signature = None if declarator is None else _signature(node, declarator)
        if signature is None:
            return
        qualified = joined(scope, signature.name)
        found = Function(qualified, qualified.rpartition("::")[0], signature, path, template)
        if signature.returns is UNTYPED and _TEST.fullmatch(found.last):
            self.tests.append(found)
        else:
            self._owned.append(found)

    def finish(self) -> None:
        """Say which class each function belongs to, now that all classes are known."""
        for function in self._owned:
            owner = function.scope
            if owner and owner not in self.classes:
                for used in self.used:
                    if joined(used, owner) in self.classes:
                        owner = joined(used, owner)
                        break
                else:
                    owner = self._by_alias(owner)
            if (owner, function.path) in self._strange or (owner in self._local and self.classes[owner].path != function.path):
                continue
            if owner in self.classes:
                function.owner = owner
                function.scope = owner
                function.name = joined(owner, function.last)
            self.functions.setdefault(function.name, []).append(function)
        self._owned = []

    def members(self, owner: str) -> list[tuple[str, list[Function]]]:
        """The functions of a class, by name."""
        if self._members is None:
            self._members = {}
            for name, functions in self.functions.items():
                self._members.setdefault(name.rpartition("::")[0], []).append((name.rpartition("::")[2], functions))
        return self._members.get(owner, [])

    def is_assigned(self, name: str) -> bool:
        """Whether a function, other than constructors, assigns a variable of that name; told by the text alone."""
        if self._assigned is None:
            self._assigned = set()
            for functions in self.functions.values():
                for each in functions:
                    if each.body is not None and each.last != each.owner.rpartition("::")[2]:
                        self._assigned.update(_assigned_in(each.body.text))
        return name in self._assigned

    def _by_alias(self, owner: str) -> str:
        """The class that ``owner`` is another name of: ``typedef ns::Class Class``, or ``n = ns`` in front of it."""
        named, scope = self.aliases.get(owner, (UNTYPED, ""))
        for space in (scope, ""):
            if named.name and joined(space, named.name) in self.classes:
                return joined(space, named.name)
        for start, full in self.namespaces.items():
            if owner.startswith(start + "::") and full + owner[len(start) :] in self.classes:
                return full + owner[len(start) :]
        return owner


def _signature(node: Node, declarator: Node) -> Signature | None:
    """What a declarator says of the function that it declares; None where it declares none."""
    if isinstance(declarator.kept, Signature):
        return declarator.kept
    function = function_declarator(declarator)
    named = function.fields.get("declarator") if function else None
    name = function_name(named) if named is not None else ""
    if function is None or not name:
        return None
    returns, body = node.fields.get("type"), node.fields.get("body")
    head = node.until(body)
    declarator.kept = Signature(
        name.removeprefix("::"),
        parameters_of(function.fields.get("parameters")),
        parse_type(returns.text) if returns is not None else UNTYPED,
        body,
        node.child("field_initializer_list"),
        body is None and _MADE.search(node.text) is None,
        _VIRTUAL.search(head) is not None,
        _OF_CONSTANT.search(head) is not None,
        node.line,
    )
    return declarator.kept


@lru_cache(maxsize=8192)
def _assigned_in(text: str) -> frozenset[str]:
    """The names that a body assigns."""
    return frozenset(match[1] or match[2] or match[3] for match in _ASSIGNED.finditer(text))


def joined(scope: str, name: str) -> str:
    """``name`` in ``scope``."""
    return f"{scope}::{name}" if scope and name else scope or name


def parameters_of(node: Node | None) -> tuple[Parameter, ...]:
    """The parameters of a parameter list."""
    found: list[Parameter] = []
    for each in node.children if node else ():
        if each.kind not in ("parameter_declaration", "optional_parameter_declaration", "variadic_parameter_declaration"):
            continue
        named, declarator = each.fields.get("type"), each.fields.get("declarator")
        if named is None or (named.text == "void" and declarator is None):
            continue
        shared = False
        inner = declarator
        for _ in range(_DEEPEST):
            if inner is None:
                break
            shared = shared or inner.kind in (
                "pointer_declarator",
                "reference_declarator",
                "abstract_reference_declarator",
                "abstract_pointer_declarator",
            )
            last = inner.children[-1] if inner.kind == "reference_declarator" and inner.children else None
            inner = inner.fields.get("declarator") or last
        found.append(Parameter(name_of(declarator), parse_type(named.text), shared, each.fields.get("default_value")))
    return tuple(found)


def _between(node: Node, declarator: Node, initial: Node) -> bool:
    """Whether ``initial`` is the first thing behind ``declarator``."""
    children = node.children
    position = next((at for at, each in enumerate(children) if each is declarator), -1)
    return 0 <= position < len(children) - 1 and children[position + 1] is initial


def _template(node: Node | None) -> tuple[str, ...]:
    names: list[str] = []
    for each in node.children if node else ():
        name = each.fields.get("name") or each.fields.get("declarator") or (each.children[-1] if each.children else None)
        names.append(name.text if name else "")
    return tuple(names)


def _type_text(node: Node) -> str:
    if node.kind in ("class_specifier", "struct_specifier", "enum_specifier", "union_specifier"):
        name = node.fields.get("name")
        return name.text if name else ""
    return node.text


def _spelled(node: Node) -> str:
    return node.text


def _is_zero(condition: Node | None) -> bool:
    return condition is not None and condition.text.strip() in ("0", "false")
