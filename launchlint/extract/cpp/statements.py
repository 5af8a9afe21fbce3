"""Statements: what is reached, in which order, under which conditions."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from launchlint.extract.cpp import classes, places, turns
from launchlint.extract.cpp.declarators import function_declarator, is_pointer, name_of
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.spelled_type import TEXTS, UNTYPED, Type, parse_type
from launchlint.extract.cpp.syntax import Node, parse_expression, shortened
from launchlint.extract.cpp.values import UNKNOWN, Cell, Items, Number, Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_MOST_TURNS = 40
_MOST_SILENT_TURNS = 4
"""Turns of a loop, one after the other, that make no names: a table is filled, or something summed up, and the rest will be like it."""
_MOST_STATEMENTS = 400
_NOT_FOLLOWED = frozenset(
    (
        "using_declaration",
        "static_assert_declaration",
        "preproc_include",
        "preproc_call",
        "goto_statement",
        "comment",
        "function_definition",
    )
)


def execute(machine: Machine, node: Node, frame: Frame) -> str:
    """Follow one statement; says where control goes instead of to the next one."""
    kind = node.kind
    if kind in ("compound_statement", "case_statement", "labeled_statement", "else_clause", "ERROR", "preproc_else", "declaration_list"):
        return sequence(machine, node.children, frame)
    if kind == "expression_statement":
        for each in node.children:
            machine.evaluate(each, frame)
        return "return" if _ends_program(node) else ""
    if kind == "declaration":
        declare(machine, node, frame)
        return ""
    if kind == "if_statement":
        return _if(machine, node, frame)
    if kind in ("return_statement", "co_return_statement"):
        value = machine.evaluate(node.children[0], frame) if node.children else UNKNOWN
        frame.returns.append((" and ".join(machine.conditions[-1:]), value))
        return "return"
    if kind == "throw_statement":
        return "return"
    if kind in ("break_statement", "continue_statement"):
        return kind.partition("_")[0]
    if kind == "for_range_loop":
        return _for_each(machine, node, frame)
    if kind == "for_statement":
        return _for(machine, node, frame)
    if kind in ("while_statement", "do_statement"):
        return _while(machine, node, frame)
    if kind == "switch_statement":
        return _switch(machine, node, frame)
    if kind == "try_statement":
        return _try(machine, node, frame)
    if kind in ("preproc_if", "preproc_ifdef", "preproc_elif", "preproc_elifdef"):
        return _preprocessor(machine, node, frame)
    if kind in ("type_definition", "alias_declaration"):
        _alias(node, frame)
        return ""
    if kind == "using_declaration":
        if machine.declarations.using(node, ""):
            machine.names.forget()
        return ""
    if kind in _NOT_FOLLOWED:
        return ""
    machine.evaluate(node, frame)
    return ""


def sequence(machine: Machine, nodes: Sequence[Node], frame: Frame) -> str:
    """Statements one after the other."""
    for position, node in enumerate(nodes):
        if (
            node.kind == "expression_statement"
            and _is_torn(node)
            and position + 1 < len(nodes)
            and _declare_torn(machine, node, nodes[position + 1], frame)
        ):
            continue
        signal = machine.execute(node, frame)
        if signal:
            return signal
    return ""


def _is_torn(node: Node) -> bool:
    """Whether it is the type of a declaration that the grammar took for a statement of its own: ``ns::Type`` without a semicolon."""
    return len(node.children) == 1 and node.children[0].size == node.size


def _declare_torn(machine: Machine, named: Node, rest: Node, frame: Frame) -> bool:
    """``ns::Type`` and ``name(a, b);`` as the one declaration that they are; whether they are one."""
    call = rest.child("call_expression") if rest.kind == "expression_statement" else None
    function = call.fields.get("function") if call else None
    if call is None or function is None or function.kind != "identifier" or named.children[0].kind != "qualified_identifier":
        return False
    type_ = parse_type(named.text)
    value = classes.construct(machine, type_, classes.arguments(machine, call.fields.get("arguments"), frame), rest, frame)
    frame.variables[function.text] = machine.cell(value, type_)
    return True


def _ends_program(node: Node) -> bool:
    if not node.children or node.children[0].kind != "call_expression":
        return False
    named = node.children[0].fields.get("function")
    return named is not None and named.text in ("exit", "std::exit", "::exit", "abort", "std::abort", "_exit", "usage_exit")


def declare(machine: Machine, node: Node, frame: Frame) -> Value:
    """Local variables; the value of the last one."""
    named = node.fields.get("type")
    type_ = parse_type(named.text) if named and named.kind not in ("class_specifier", "struct_specifier", "enum_specifier") else UNTYPED
    constant = any(each.kind == "type_qualifier" and each.text in ("const", "constexpr") for each in node.children)
    value: Value = UNKNOWN
    for declarator in node.every("declarator"):
        initial = declarator.fields.get("value") if declarator.kind == "init_declarator" else node.fields.get("value")
        name = name_of(declarator)
        if not name:
            continue
        function = function_declarator(declarator)
        if function is not None and declarator.kind != "init_declarator":
            if not _is_construction(machine, function, type_, frame):
                continue
            parameters = function.fields.get("parameters")
            spelled = [parse_expression(each.text) for each in parameters.children] if parameters else []
            arguments = [machine.argument(each, frame) for each in spelled if each is not None]
            value = classes.construct(machine, type_, arguments, node, frame)
        elif initial is not None and is_pointer(declarator) and _is_reference(declarator):
            cell = machine_cell(machine, initial, frame)
            if cell is not None:
                frame.variables[name] = cell
                value = cell.value
                continue
            value = machine.evaluate(initial, frame)
        elif initial is not None:
            value = _initial(machine, type_, initial, is_pointer(declarator), node, frame)
        elif is_pointer(declarator):
            value = UNKNOWN
        else:
            value = classes.default(machine, type_, node, frame)
        if declarator.fields.get("parameters") is None and _is_array(declarator) and initial is None:
            classes.contain(machine, Type("", (type_,)), frame)
            value = UNKNOWN
        frame.variables[name] = machine.cell(value, type_, constant)
    return value


def machine_cell(machine: Machine, node: Node, frame: Frame) -> Cell | None:
    """The variable that an expression names."""
    return places.cell_of(machine, node, frame)


def _initial(machine: Machine, type_: Type, initial: Node, pointer: bool, node: Node, frame: Frame) -> Value:
    if initial.kind in ("argument_list", "initializer_list") and not pointer and type_.name:
        if initial.kind == "initializer_list" and classes.is_list(machine, type_, frame):
            return machine.evaluate(initial, frame)
        return classes.construct(machine, type_, classes.arguments(machine, initial, frame), node, frame)
    if initial.kind == "argument_list":
        return machine.evaluate(initial.children[0], frame) if initial.children else UNKNOWN
    value = machine.evaluate(initial, frame)
    return value if pointer else classes.converted(machine, value, type_, frame, node)


def _is_reference(declarator: Node) -> bool:
    inner = declarator.fields.get("declarator") if declarator.kind == "init_declarator" else declarator
    return inner is not None and inner.kind == "reference_declarator"


def _is_array(declarator: Node) -> bool:
    return declarator.kind == "array_declarator"


def _is_construction(machine: Machine, function: Node, type_: Type, frame: Frame) -> bool:
    """Whether ``Foo f(a, b);``, which reads as a function, makes a variable: all it is given are variables."""
    parameters = function.fields.get("parameters")
    if parameters is None or not type_.name or not parameters.children:
        return False
    for each in parameters.children:
        named, declarator = each.fields.get("type"), each.fields.get("declarator")
        if named is None:
            return False
        if declarator is not None:
            if declarator.kind not in ("abstract_function_declarator", "abstract_array_declarator"):
                return False
            if declarator.kind == "abstract_function_declarator":
                continue
        if named.kind == "primitive_type" or (declarator is None and _is_type(machine, named, frame)):
            return False
    return True


def _is_type(machine: Machine, named: Node, frame: Frame) -> bool:
    """Whether a name that may be a variable or a type is a type."""
    if frame.variable(named.text) is not None or classes.member(machine, frame.this, named.text) is not None:
        return False
    resolved = machine.names.resolve(parse_type(named.text), frame)
    return resolved.name != named.text or machine.names.declared(resolved) is not None or resolved.name in TEXTS


def condition_text(node: Node | None) -> str:
    """The source of a condition, without the parentheses around it."""
    if node is None:
        return ""
    text = node.text.strip()
    if node.kind in ("condition_clause", "parenthesized_expression") and text.startswith("(") and text.endswith(")"):
        text = text[1:-1]
    return shortened(text)


def negated(text: str) -> str:
    """``not (text)``, without a double negation of a single word."""
    bare = text.removeprefix("!")
    return bare if text.startswith("!") and bare.replace("_", "").replace(".", "").isalnum() else f"!({text})"


def decided(machine: Machine, node: Node | None, frame: Frame) -> bool | None:
    """Whether a condition is certainly true or false."""
    before, machine.touched = machine.touched, False
    inner = node.fields.get("value") if node is not None and node.kind == "condition_clause" else node
    is_declaration = inner is not None and inner.kind == "declaration"
    value = declare(machine, inner, frame) if inner is not None and is_declaration else machine.evaluate(inner, frame)
    touched, machine.touched = machine.touched, before
    if touched:
        return None
    if isinstance(value, Number):
        return bool(value.value)
    return None


def _if(machine: Machine, node: Node, frame: Frame) -> str:
    condition = node.fields.get("condition")
    known = decided(machine, condition, frame)
    consequence, alternative = node.fields.get("consequence"), node.fields.get("alternative")
    if known is not None:
        taken = consequence if known else alternative
        return machine.execute(taken, frame) if taken else ""
    text = condition_text(condition)

    def then() -> str:
        return machine.execute(consequence, frame) if consequence else ""

    def otherwise() -> str:
        return machine.execute(alternative, frame) if alternative else ""

    if text.replace(" ", "") in machine.tables.running:
        return machine.execute(consequence, frame) if consequence else ""
    return machine.branch([(text, then), (negated(text), otherwise)])


def _for_each(machine: Machine, node: Node, frame: Frame) -> str:
    before, machine.touched = machine.touched, False
    right = machine.evaluate(node.fields.get("right"), frame)
    touched, machine.touched = machine.touched, before
    declarator, named, body = node.fields.get("declarator"), node.fields.get("type"), node.fields.get("body")
    name = name_of(declarator)
    type_ = parse_type(named.text) if named else UNTYPED
    if body is None:
        return ""
    if isinstance(right, Items) and 0 < len(right.items) <= _MOST_TURNS:
        if touched:
            machine.conditions.append(f"{name} is one of {condition_text(node.fields.get('right'))}")
        for item in right.items:
            frame.variables[name] = machine.cell(item, type_)
            if machine.execute(body, frame) in ("break", "return"):
                break
        if touched:
            machine.conditions.pop()
        return ""

    item = machine.tables.each(right)

    def turn() -> str:
        frame.variables[name] = machine.cell(item, type_)
        return machine.execute(body, frame)

    turns.once_or_more(machine, turn, f"{name} is one of {condition_text(node.fields.get('right'))}")
    return ""


def _for(machine: Machine, node: Node, frame: Frame) -> str:
    initial, condition, update, body = (node.fields.get(each) for each in ("initializer", "condition", "update", "body"))
    if initial is not None:
        machine.execute(initial, frame)
    if body is None:
        return ""
    followed = silent = 0
    while condition is not None and followed < _MOST_TURNS:
        known = decided(machine, condition, frame)
        if known is False:
            return ""
        if known is None:
            break
        before = machine.steps
        signal, tells = turns.telling(machine, lambda: machine.execute(body, frame))
        if signal in ("break", "return"):
            return ""
        machine.evaluate(update, frame)
        followed += 1
        silent = 0 if tells else silent + 1
        if machine.steps == before or silent == _MOST_SILENT_TURNS:
            break

    def turn() -> str:
        signal = machine.execute(body, frame)
        machine.evaluate(update, frame)
        return signal

    turns.once_or_more(machine, turn, condition_text(condition))
    return ""


def _while(machine: Machine, node: Node, frame: Frame) -> str:
    body, condition = node.fields.get("body"), node.fields.get("condition")
    if node.kind == "while_statement" and decided(machine, condition, frame) is False:
        return ""
    if body is not None:
        turns.once_or_more(machine, lambda: machine.execute(body, frame), condition_text(condition))
    if node.kind == "do_statement":
        machine.evaluate(condition, frame)
    return ""


def _switch(machine: Machine, node: Node, frame: Frame) -> str:
    condition, body = node.fields.get("condition"), node.fields.get("body")
    text = condition_text(condition)
    subject = condition.fields.get("value") if condition and condition.kind == "condition_clause" else condition
    value = machine.evaluate(subject, frame)
    if body is None:
        return ""
    cases = [each for each in body.children if each.kind == "case_statement"]
    runs: list[tuple[str, Callable[[], str]]] = []
    labels: list[str] = []
    possible = False
    for position, case in enumerate(cases):
        label = case.fields.get("value")
        labels.append(f"{text} == {condition_text(label)}" if label is not None else f"no case of {text}")
        possible = possible or _may_be(machine, value, label, frame)
        own = [each for each in case.children if each is not label]
        if not own and position + 1 < len(cases):
            continue  # several labels of the same statements
        described = shortened(" or ".join(labels))
        labels = []
        taken, possible = possible, False
        if not taken:
            continue
        for following in cases[position + 1 :]:
            if len(own) > _MOST_STATEMENTS or _leaves(own):
                break
            own = own + [each for each in following.children if each is not following.fields.get("value")]

        def run(own: list[Node] = own) -> str:
            signal = sequence(machine, own, frame)
            return "" if signal == "break" else signal

        runs.append((described, run))
    if not any(case.fields.get("value") is None for case in cases):
        runs.append(("", lambda: ""))
    return machine.branch(runs)


def _may_be(machine: Machine, value: Value, label: Node | None, frame: Frame) -> bool:
    """Whether a case may be the one that is taken."""
    if not isinstance(value, Number) or label is None or machine.touched:
        return True
    known = machine.evaluate(label, frame)
    return not isinstance(known, Number) or known.value == value.value


def _leaves(statements: list[Node]) -> bool:
    """Whether a case does not go on into the next one."""
    kinds = ("break_statement", "return_statement", "throw_statement", "continue_statement")
    return any(
        each.kind in kinds or (each.kind == "compound_statement" and any(inner.kind in kinds for inner in each.children))
        for each in statements
    )


def _try(machine: Machine, node: Node, frame: Frame) -> str:
    body = node.fields.get("body")
    signal = machine.execute(body, frame) if body else ""
    for clause in node.children:
        inner = clause.fields.get("body") if clause.kind == "catch_clause" else None
        if inner is not None:
            parameters = clause.fields.get("parameters")
            text = f"catch {condition_text(parameters)}" if parameters else "catch"

            def run(inner: Node = inner) -> str:
                return machine.execute(inner, frame)

            machine.branch([("", lambda: ""), (text, run)])
    return signal


def _preprocessor(machine: Machine, node: Node, frame: Frame) -> str:
    condition = node.fields.get("condition") or node.fields.get("name")
    alternative = node.fields.get("alternative")
    text = shortened(condition.text) if condition else ""
    if node.kind in ("preproc_ifdef", "preproc_elifdef"):
        text = f"#{'ifndef' if node.text.startswith('#ifndef') else 'ifdef'} {text}"
    else:
        text = f"#if {text}"
    inner = [each for each in node.children if each is not condition and each is not alternative]
    if text in ("#if 0", "#if false"):
        return machine.execute(alternative, frame) if alternative else ""
    if text in ("#if 1", "#if true"):
        return sequence(machine, inner, frame)
    return machine.branch(
        [
            (text, lambda: sequence(machine, inner, frame)),
            (f"not {text}", lambda: machine.execute(alternative, frame) if alternative else ""),
        ]
    )


def _alias(node: Node, frame: Frame) -> None:
    named = node.fields.get("type")
    declarator = node.fields.get("declarator") or node.fields.get("name")
    if named and declarator and name_of(declarator):
        type_ = parse_type(named.text)
        if type_.name != name_of(declarator):
            frame.aliases[name_of(declarator)] = type_
