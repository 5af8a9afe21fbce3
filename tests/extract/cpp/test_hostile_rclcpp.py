"""Sources of ROS 2 that are made to take for ever, or to break: they are read in time, and nothing is promised of what was not followed."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from launchlint.extract.cpp import cpp_program
from launchlint.extract.cpp.rclcpp.generated import read
from launchlint.extract.entries import ROS2, variant_of

HEAD = '#include "rclcpp/rclcpp.hpp"\n'
LONGEST = 20.0
"""Seconds of processor time; what is not bounded takes minutes."""


def _node(body: str) -> str:
    made = "int main() { std::make_shared<A>(); }\n"
    return f'{HEAD}class A : public rclcpp::Node {{ public: A() : Node("a") {{ {body} }} void f() {{}} }};\n{made}'


def _chain(length: int) -> str:
    classes = "".join(f"struct C{n} : C{n - 1} {{ C{n}() : C{n - 1}() {{}} }};\n" for n in range(1, length))
    return f'{HEAD}struct C0 : rclcpp::Node {{ C0() : Node("deep") {{}} }};\n{classes}int main() {{ C{length - 1} c; }}\n'


HOSTILE = {
    "a long chain of a profile": _node(f'create_publisher<std_msgs::msg::String>("a", rclcpp::QoS(1){".reliable()" * 3_000});'),
    "a profile that is copied again and again": _node("rclcpp::QoS q(1);" + "auto r = q; q = r;" * 2_000 + "create_publisher<X>(t, q);"),
    "many nodes": f"{HEAD}int main() {{" + "".join(f'rclcpp::Node n{n}("n{n}");' for n in range(3_000)) + "}",
    "nodes in a loop": f'{HEAD}int main() {{ for (;;) {{ for (;;) {{ std::make_shared<rclcpp::Node>("n" + std::to_string(i++)); }} }} }}',
    "a node that makes itself": f'{HEAD}struct A : rclcpp::Node {{ A() : Node("a") {{ std::make_shared<A>(); }}void f() {{ A a; f(); }}}};'
    "int main() { A a; }",
    "sub-nodes of sub-nodes": _node(
        'auto n = create_sub_node("x");' + 'n = n->create_sub_node("xxxxxxxxxx");' * 2_000 + 'n->create_client<T>("y");'
    ),
    "many base classes": _chain(400),
    "a class that is its own base": f'{HEAD}struct A : A, rclcpp::Node {{ A() : Node("a") {{}} }}; int main() {{ A a; }}',
    "many params": _node("".join(f'declare_parameter("p{n}", {n});' for n in range(6_000))),
    "a lifecycle node that never ends": f'{HEAD}struct A : rclcpp_lifecycle::LifecycleNode {{ A() : LifecycleNode("a") {{}}'
    " CallbackReturn on_configure(const State & s) override { for (;;) { on_configure(s); on_activate(s); } }"
    " CallbackReturn on_activate(const State & s) override { return on_configure(s); } }; int main() { A a; }",
    "braces that are filled with braces": _node(
        'auto s = fmt::format("{}{}{}{}", "{}", "{}", "{}", "{}");' + "s = fmt::format(s, s, s, s);" * 200
    ),
    "a param that is its own default": _node(
        'auto p = declare_parameter("p", "x");' + 'p = declare_parameter("p", p + p);' * 60 + "create_client<T>(p);"
    ),
    "options that hold themselves": _node(
        'rclcpp::NodeOptions o; o.arguments(o.arguments()); o.arguments({o, o}); rclcpp::Node n("b", o);'
    ),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_sources(name: str, tmp_path: Path) -> None:
    (tmp_path / "main.cpp").write_text(HOSTILE[name])
    started = time.process_time()
    facts, doubts, nodes = cpp_program([str(tmp_path / "main.cpp")], [], str(tmp_path), None, client="rclcpp")
    variant, _ = variant_of(facts, doubts, "", ROS2, nodes)
    assert time.process_time() - started < LONGEST
    assert len(nodes) <= 200
    assert all(len(entry["name"]) <= 1_000 for category in ("publishers", "clients", "params") for entry in variant.get(category, ()))


@pytest.mark.parametrize(
    "text",
    [
        "a: &a {b: *a}",
        "a: " + "{b: " * 3_000 + "1" + "}" * 3_000,
        "a: {" + ", ".join(f"p{n}: {{type: int}}" for n in range(30_000)) + "}",
        "a: {p: {type: [1], default_value: {}}}",
        "a: {p: {type: int, default_value: 1e999, validation: {bounds<>: x}}}",
        "- 1",
        "\0",
    ],
    ids=["alias", "deep", "long", "types", "values", "list", "nul"],
)
def test_hostile_descriptions_of_params(text: str, tmp_path: Path) -> None:
    path = tmp_path / "params.yaml"
    path.write_text(text)
    started = time.process_time()
    found = read(str(path))
    assert time.process_time() - started < LONGEST
    assert found is None or len(found.params) <= 2_000
