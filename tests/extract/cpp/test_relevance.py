"""Which functions are worth following, and that the others are passed over without loss."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

from launchlint.extract.cpp import syntax
from launchlint.extract.cpp.declarations import Declarations
from launchlint.extract.cpp.machine import Machine
from launchlint.extract.cpp.naming import Names
from launchlint.extract.cpp.relevance import Relevance
from launchlint.extract.cpp.ros.roscpp import ROSCPP
from tests.extract.cpp.following import program, spelled

WORDS = frozenset(("advertise", "param", "NodeHandle", "TransformListener", "SimpleActionClient", "thread"))
TABLES = ROSCPP._replace(words=WORDS)

SOURCES = {
    "what calls the interface": ("void f() { nh.advertise<A>(t, 1); } void g() { f(); } void h() { k(); }", {"f", "g"}),
    "a variable of that name": ("void f() { double param = 1; if (param < 0) g(param); }", set()),
    "a comment, a text": ('void f() { /* thread */ g("advertise("); } // advertise()\n', set()),
    "a function template": ("void f() { x = nh.param<std::string>(t, u); }", {"f"}),
    "an address": ("void f() { g(&ros::NodeHandle::advertise); }", {"f"}),
    "a member of a list": (
        "struct Map { void clear() { nh.advertise(t); } }; void f() { std::vector<int> v; v.clear(); }",
        {"Map::clear"},
    ),
    "a member of a field": (
        (
            "struct Map { void clear() { nh.advertise(t); } }; struct A { Map* map_; std::list<int> l_; void f() { l_.clear(); }"
            " void g() { map_->clear(); } };"
        ),
        {"Map::clear", "A::g"},
    ),
    "a member of a smart pointer, and of what it points to": (
        (
            "struct Map { void reset() { nh.advertise(t); } }; struct A { MapPtr map_; void f() { map_.reset(); }"
            " void g() { map_->reset(); } }; void h(Both both) { both.first.map_.reset(); }"
        ),
        {"Map::reset", "A::g"},
    ),
    "a member of nobody knows what": (
        "struct Map { void clear() { nh.advertise(t); } }; void f() { auto m = all(); m->clear(); } void g() { all()[0].clear(); }",
        {"Map::clear", "f", "g"},
    ),
    "a member of a parameter, by its base class": (
        (
            "struct Base {}; struct Map : Base { void clear() { nh.advertise(t); } }; struct Other {};"
            " void f(Base& b) { b.clear(); } void g(Other& o) { o.clear(); }"
        ),
        {"Map::clear", "f"},
    ),
    "a member of a template's argument": (
        "struct Map { void clear() { nh.advertise(t); } }; template <typename T> void f(T& b) { b.clear(); }",
        {"Map::clear", "f"},
    ),
    "a function of another class": (
        "struct A { void start() { nh.advertise(t); } }; struct B { void start() {} void f() { start(); } void g() { B::start(); } };",
        {"A::start"},
    ),
    "a callback": (
        "struct A { void start() { nh.advertise(t); } void f() { later(boost::bind(&A::start, this)); } };",
        {"A::start", "A::f"},
    ),
    "an object that is made": (
        (
            "struct A { void start() { nh.advertise(t); } }; void f() { keep(new A); } void g() { keep(std::make_shared<A>()); }"
            " void h(A* a) { keep(static_cast<A*>(a)); std::vector<A*> all; A::Kind k; }"
        ),
        {"A::start", "f", "g"},
    ),
    "another name of a class": (
        (
            "typedef actionlib::SimpleActionClient<X> Client; void f() { Client client(t); } struct A { void s() { nh.advertise(t); } };"
            " using B = A; void g() { B b; }"
        ),
        {"f", "A::s", "g"},
    ),
    "a member that is made with its owner": (
        "struct A { tf::TransformListener tf_; A() { n = 1; } int n; }; void f() { A a; } struct B { ros::NodeHandle nh_; B() {} };",
        {"A::A", "f"},
    ),
    "a derived class": (
        "struct A { A() { nh.advertise(t); } }; struct B : A { int n; }; void f() { B b; } void g(B* b) {}",
        {"A::A", "f"},
    ),
    "a class that is only named": (
        "struct A { A() { nh.advertise(t); } static int n() { return 1; } int g() { return A::n(); } }; int f(A& a) { return A::n(); }",
        {"A::A"},
    ),
    "a member that is called like one of ROS": (
        (
            "struct A { int param() { return 1; } int f() { return param() + this->param(); } }; int g(A& a) { return a.param(); }"
            " int h() { return nh.param(t, 1); }"
        ),
        {"h"},
    ),
    "a member that is called like one of ROS, and asks it": (
        "struct A { ros::NodeHandle nh_; int param(T t) { return nh_.param(t, 1); } int f() { return param(t); } };",
        {"A::param", "A::f"},
    ),
    "a node handle that is handed on": (
        (
            "struct A { ros::NodeHandle nh_; void f() { other(nh_, 1); } void g() { n = nh_.ok(); } };"
            " void h(ros::NodeHandle& node) { other(node); } void k(const ros::NodeHandle* node) { node->ok(); }"
        ),
        {"A::f", "h"},
    ),
    "a macro": ("#define ASK(n) nh.param(#n, n, 1)\nvoid f() { ASK(x); } void g() { TELL(x); }", {"f"}),
    "a header that is not here": ("void f() { octomap_server::Server s; } void g() { octomap::Tree t; }", {"f"}),
}


@pytest.mark.parametrize("name", SOURCES)
def test_relevant(name: str) -> None:
    source, expected = SOURCES[name]

    def others(words: Iterable[str]) -> set[str]:
        return {"octomap_server"} & set(words)

    declarations = Declarations()
    declarations.read(syntax.parse(source.encode()), "main.cpp")
    declarations.finish()
    Relevance(declarations, Names(declarations), TABLES, others)
    assert {each.name for found in declarations.functions.values() for each in found if each.relevant} == expected


def test_what_is_declared_with_ros_at_hand_and_not_here() -> None:
    declarations = Declarations()
    declarations.read(syntax.parse(b'#include "ros/ros.h"\nvoid setUp(); void f() { setUp(); } void g() { other(); }'), "main.cpp")
    declarations.finish()
    Relevance(declarations, Names(declarations), TABLES, lambda words: set())
    assert [each.name for found in declarations.functions.values() for each in found if each.relevant] == ["f"]


def test_a_long_program_is_followed_to_its_end(tmp_path: Path) -> None:
    # Each of these calls the next one many times, and would be followed for ever if `clear` were that of the map.
    steps = "\n".join(f"void f{n}() {{ std::vector<int> v; {f'v.clear(); f{n - 1}(); ' * 100} }}" for n in range(1, 5))
    map_ = 'struct Map { void clear() { ros::NodeHandle nh; nh.advertise<std_msgs::Bool>("map", 1); } };'
    source = f'{map_} void f0() {{}}\n{steps}\nint main() {{ ros::NodeHandle nh; f4();\nnh.advertise<std_msgs::Bool>("after", 1); }}\n'
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [f"publishers after std_msgs/Bool {source.count(chr(10))} queue=1"]
    assert doubts == ()


def test_lines_in_bodies_that_are_read_late(tmp_path: Path) -> None:
    function = 'void g(ros::NodeHandle& nh) {\n  if (a) {\n    nh.advertise<std_msgs::Bool>(\n      "x", 1);\n  }\n}\n'
    source = f"{function}int main() {{ ros::NodeHandle n; g(n); }}\n"
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["publishers x std_msgs/Bool 3 queue=1 if a"]
    body = syntax.parse(source.encode()).children[0].fields.get("body")
    assert body is not None
    assert [(each.kind, each.line) for each in body.walk()][:3] == [("compound_statement", 1), ("if_statement", 2), ("condition_clause", 2)]


def test_a_class_of_another_library_that_is_called_like_one_of_ros() -> None:
    declarations = Declarations()
    source = b"void f(const srdf::Model& m) { g(m.groups()); srdf::Model n; } void h() { urdf::Model m; } void k() { Model m; }"
    declarations.read(syntax.parse(source), "main.cpp")
    declarations.finish()
    Relevance(declarations, Names(declarations), ROSCPP, lambda words: set())
    assert [each.name for found in declarations.functions.values() for each in found if each.relevant] == ["h", "k"]


def test_what_stands_before_many_dots_is_followed_once(tmp_path: Path) -> None:
    dots = ".".join(["first"] * 40)
    used = f"use(all.{dots}, all.{dots}.value());"
    source = f'int main() {{ ros::NodeHandle nh; auto all = other();\n{used}\nnh.advertise<std_msgs::Bool>("after", 1); }}\n'
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["publishers after std_msgs/Bool 3 queue=1"]
    assert doubts == ()


def test_functions_that_have_nothing_to_do_with_names_are_followed_for_a_while(tmp_path: Path) -> None:
    calls = "\n".join(f"void f{n}() {{ {f'f{n - 1}(); ' * 12} }}" for n in range(1, 8))
    source = f'void f0() {{ n = 1; }}\n{calls}\nint main() {{ ros::NodeHandle nh; f7();\nnh.advertise<std_msgs::Bool>("after", 1); }}\n'
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [f"publishers after std_msgs/Bool {source.count(chr(10))} queue=1"]
    assert doubts == ()


LONG = "\n".join(f"total = total * {number} + offset({number});" for number in range(90))
"""Source that has nothing to do with names, and more of it than is followed where that is so."""

CALLED = {
    "a test": (f'TEST(Suite, long) {{ {LONG} ros::NodeHandle("~").advertise<A>("x", 1); }}', "publishers ~x - 90 queue=1"),
    "a param by its full name": (
        f'void read() {{ {LONG} int x; ros::param::get("~x", x); }}\nint main() {{ read(); }}',
        "params ~x int 90",
    ),
    "a service by its full name": (
        f'void read() {{ {LONG} ros::service::call("~x", y); }}\nint main() {{ read(); }}',
        "clients ~x - 90",
    ),
    "a function that is given": (
        (
            f"void each(boost::function<void()> f) {{ {LONG[:1000].rpartition(chr(10))[0]}\nf(); }}\n"
            'struct Maker { void operator()() { ros::NodeHandle("~").advertise<A>("x", 1); } };\nint main() { Maker make; each(make); }'
        ),
        "publishers ~x - 32 queue=1",
    ),
}


@pytest.mark.parametrize("kind", CALLED)
def test_long_functions_that_make_names_are_followed(tmp_path: Path, kind: str) -> None:
    source, expected = CALLED[kind]
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [expected]


TABLES_FILLED = """
int main() {
  int sum = 0;
  for (int i = 0; i < 30; i++) table[i] = 97 * (i - 1) / 251;
  for (int i = 0; i < 30; i++) sum += i;
  ros::NodeHandle nh;
  for (int i = 0; i < 3; i++) { if (i == 2) nh.advertise<A>("late", 1); }
  std::vector<std::string> names;
  for (int i = 0; i < 2; i++) names.push_back("cam" + std::to_string(i));
  for (int i = 0; i < names.size(); i++) nh.advertise<A>(names[i], 1);
}
"""


def test_turns_of_a_loop_that_tell_nothing_are_not_all_followed(tmp_path: Path) -> None:
    facts, _ = program(tmp_path, TABLES_FILLED)
    assert [(fact.name, fact.condition) for fact in facts] == [("cam0", ""), ("cam1", ""), ("late", "")]


def test_objects_that_a_loop_makes_are_of_any_turn(tmp_path: Path) -> None:
    source = """
        struct Camera {
          Camera(int number) : number_(number) {}
          void start() { nh_.advertise<A>("cam" + std::to_string(number_), 1); }
          int number_;
          ros::NodeHandle nh_;
        };
        int main() {
          Camera* last;
          int number = 0;
          while (more()) { last = new Camera(number); number++; }
          last->start();
        }
        """
    facts, _ = program(tmp_path, source)
    assert "cam{any}" in [fact.name for fact in facts]


def test_a_table_costs_the_same_however_long_it_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    steps: list[int] = []
    finish = Machine.finish
    monkeypatch.setattr(Machine, "finish", lambda machine: (finish(machine), steps.append(machine.steps)))
    for length in (6, 1_000_000):
        program(tmp_path, f"int main() {{ for (int i = 0; i < {length}; i++) table[i] = 97 * (i - 1) / 251; }}")
    assert steps[0] == steps[1]
