"""Sources that nobody would write, except to bring the reader down: each is answered within seconds, without an exception."""

from __future__ import annotations

import builtins
import os
import time
from pathlib import Path
from typing import Any

import pytest

from launchlint.errors import UsageError
from launchlint.extract.cpp import cpp_program, syntax
from tests.extract.cpp.following import program, spelled

HOSTILE = {
    "nothing": "",
    "no C++": "\x00\xff{{{{<<<>>>",
    "parentheses": "int main() { int a = " + "(" * 30_000 + "1" + ")" * 30_000 + "; }",
    "blocks": "int main() " + "{" * 20_000 + "}" * 20_000,
    "else if": "int main() { if (a) {} " + "else if (b) {} " * 5_000 + "}",
    "a long sum": "int main() { std::string s = " + " + ".join(['"a"'] * 20_000) + "; }",
    "templates": "int main() { " + "A<" * 5_000 + "int" + ">" * 5_000 + " a; }",
    "namespaces": "".join(f"namespace n{number} {{" for number in range(3_000)) + "}" * 3_000,
    "pointers": "int main() { int " + "*" * 20_000 + "a; }",
    "function calls itself": "void f() { f(); f(); }\nint main() { f(); }",
    "calls without end": "".join(f"void f{n}() {{ f{n + 1}(); f{n + 1}(); }}\n" for n in range(300)) + "int main() { f0(); }",
    "class is its own base": "class A : public A { A() { b(); } };\nint main() { A a; a.b(); }",
    "classes are each other's base": "class A : public B {}; class B : public A {};\nint main() { A a; a.b(); }",
    "class has itself": "class A { A a; B b; }; class B { A a; A c; };\nint main() { A a; }",
    "type is called by itself": "typedef A B; typedef B A; using C = C;\nint main() { C c; ros::NodeHandle nh; nh.advertise<B>(x, 1); }",
    "type grows": "template <class T> struct A { typedef A<A<T> > Next; Next next; };\nint main() { A<int> a; a.next.next.next.f(); }",
    "macro is itself": "#define A B\n#define B A\n#define F(x) F(x) F(x)\nint main() { std::string s = A; F(1); }",
    "text doubles": 'int main() { std::string s = "ab"; '
    + "s = s + s; " * 200
    + "ros::NodeHandle nh; nh.advertise<std_msgs::Bool>(s, 1); }",
    "loops": "int main() { " + "for (int i = 0; i < 30; i++) " * 30 + "f(); }",
    "loop without end": "int main() { for (int i = 0; i < 10; i--) { f(); } for (;;) {} while (true) {} }",
    "branches": "int main() { std::string s;\n" + "\n".join(f'if (a{n}) s = s + "{n}";' for n in range(200)) + "\nros::NodeHandle nh(s); }",
    "large numbers": "int main() { long a = 9" + "9" * 5_000 + "; int b = 1 << 100000; double c = 1e308 * 1e308; int d = 2 / 0; }",
    "lambda calls itself": "int main() { auto f = [&](auto g) { g(g); }; f(f); }",
    "callbacks make callbacks": "ros::NodeHandle nh; void f(int a) { nh.createTimer(a, boost::bind(f, a + 1)); }\nint main() { f(1); }",
    "long condition": "int main() { ros::NodeHandle nh; if (" + "a && " * 5_000 + 'b) nh.advertise<std_msgs::Bool>("a", 1); }',
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_source_is_answered(tmp_path: Path, name: str) -> None:
    begin = time.process_time()
    facts, doubts = program(tmp_path, HOSTILE[name])
    assert time.process_time() - begin < 20
    assert len(facts) < 20
    assert all(len(fact.name) < 5_000 and len(fact.condition) < 500 for fact in facts)
    assert all(doubt.reason.isprintable() and len(doubt.reason) < 500 for doubt in doubts)


def test_hostile_configuration_is_answered(tmp_path: Path) -> None:
    source = "int main() { dynamic_reconfigure::Server<demo::AConfig> server; }"
    for text in (
        "(" * 10_000,
        "x = " + "-" * 10_000 + "1",
        "gen.add(" * 90,
        "\x00",
        "gen.add('a', double_t, 0, '', " + "1 + " * 3_000 + "1)",
    ):
        facts, doubts = program(tmp_path, {"main.cpp": source, "cfg/A.cfg": text})
        assert {fact.category for fact in facts} <= {"publishers", "services", "params"}
        assert len(doubts) <= 1


def test_files_that_cannot_be_read_are_doubts(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.cpp")
    (tmp_path / "large.cpp").write_text(" " * ((1 << 20) + 1))
    sources = [str(tmp_path / name) for name in ("pipe.cpp", "large.cpp", "none.cpp")]
    facts, doubts, _ = cpp_program(sources, [], str(tmp_path), None)
    assert facts == ()
    assert sorted({doubt.reason for doubt in doubts}) == [
        "large.cpp cannot be read: it is larger than 1048576 bytes",
        "no main() was found in these sources",
        "none.cpp cannot be read: No such file or directory",
        "pipe.cpp cannot be read: it is not a plain file",
    ]


def test_headers_outside_the_given_directories_are_not_read(tmp_path: Path) -> None:
    (tmp_path / "secret.h").write_text('void f() { ros::NodeHandle nh; nh.advertise<std_msgs::Bool>("secret", 1); }')
    (tmp_path / "package").mkdir()
    source = tmp_path / "package" / "main.cpp"
    source.write_text(f'#include "{tmp_path}/secret.h"\n#include <secret.h>\nint main() {{ f(); }}')
    assert cpp_program([str(source)], [str(tmp_path / "package")], str(tmp_path / "package"), None) == ((), (), ())


def test_the_same_sources_give_the_same_facts_in_the_same_order(tmp_path: Path) -> None:
    source = """
    class Node {
     public:
      Node() { for (auto n : {"b", "a"}) nh.advertise<std_msgs::Bool>(n, 1); if (x) nh.subscribe("s", 1, &Node::heard, this); }
      void heard(const std_msgs::BoolConstPtr& m) { nh.serviceClient<std_srvs::Empty>(name()); }
      ros::NodeHandle nh;
    };
    int main() { Node one; Node two; }
    """
    first = program(tmp_path, source)
    syntax.parse_expression.cache_clear()
    assert first == program(tmp_path, source)
    assert [spelled(fact) for fact in first[0]] == [
        "clients {any} std_srvs/Empty 5 when=message if x",
        "publishers a std_msgs/Bool 4 queue=1",
        "publishers b std_msgs/Bool 4 queue=1",
        "subscribers s std_msgs/Bool 4 queue=1 if x",
    ]


def test_without_tree_sitter_there_is_one_clear_message(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = builtins.__import__

    def missing(name: str, *more: Any, **others: Any) -> Any:
        if name.startswith("tree_sitter"):
            raise ModuleNotFoundError(name)
        return found(name, *more, **others)

    syntax._parser.cache_clear()
    monkeypatch.setattr(builtins, "__import__", missing)
    with pytest.raises(UsageError, match="pip install tree-sitter tree-sitter-cpp"):
        program(tmp_path, "int main() { int unread_before; }")
    syntax._parser.cache_clear()
