"""Which sources of a library a class needs."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from launchlint.extract import scanned
from launchlint.extract.definitions import Library, defined_names
from launchlint.extract.plan import plan
from launchlint.knowledge.reading import SourceReader
from launchlint.workspace import looking
from launchlint.workspace.packages import Packages
from launchlint.workspace.states import States
from tests.extract.test_package import MANIFEST, grow


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("void A::go(int x) { B::stop(); }", {"A"}),
        ("namespace n { A::A() : x_(1) {} A::~A() {} }", {"A"}),
        ("template <class T> void A<T>::go() {}", {"A"}),
        ("class A : public n::B { void go() {} };", {"A"}),
        ("double area(int x) { return 0; }\nint declared(int);", {"area"}),
        ("static void own() {}\nnamespace { void hidden() {} }", set()),
        ('extern "C" { void plain() {} }', {"plain"}),
        ("int A::count = 0; Thing shared;", {"A", "shared"}),
        ('namespace n { std::string topic("talk"); Shared* shared(new Shared); int many(3), own; }', {"topic", "shared", "many"}),
        ("void none(); n::A made(n::B); bool both(A& a, B* b); std::string of(std::vector<int> x);", {"made"}),
        ("namespace m = n; using namespace n; class B; typedef A C;", set()),
        ('// void A::go() {\n/* void B::go() { */ const char* text = "void C::go() {";\nvoid D::go() {}', {"D"}),
        ("PLUGINLIB_EXPORT_CLASS(n::A, nodelet::Nodelet)\nvoid B::go() {}", {"B"}),
        ("#define MAKE(x) void x::go() { \\\n }\nvoid B::go() {}", {"B"}),
    ],
)
def test_names_that_a_source_defines(text: str, names: set[str]) -> None:
    found = defined_names(text)
    assert found == names


@pytest.mark.parametrize(
    "text",
    [
        "REGISTER(A)\nvoid A::go() {}",
        "REGISTER(A);",
        "static bool known = Factory::add(1);",
        "#if X\nvoid A::go() {\n#else\nvoid A::go(int) {\n#endif\n}",
        "void A::go() { /* ",
        "}",
    ],
)
def test_a_source_of_which_that_cannot_be_told(text: str) -> None:
    assert defined_names(text) is None


def sources_of(name: str, **files: str) -> tuple[str, ...]:
    sources = [each for each in files if each.endswith("_c")]
    return Library(sources, lambda path: files[path], lambda path: [each for each in files if f"include {each}" in files[path]]).of_class(
        name
    )


def test_a_class_needs_what_its_files_and_headers_name() -> None:
    files = {
        "a_c": "#include a_h\nvoid A::go() {}",
        "a_h": "class A : public Base { Helper h_; };",
        "base_c": "void Base::start() { helped(); }",
        "helper_c": "Helper::Helper() {}",
        "helped_c": "void helped() {}",
        "other_c": "void Other::go() { A a; }",
    }
    assert sources_of("n::A", **files) == ("a_c", "base_c", "helper_c", "helped_c")
    assert sources_of("n::Other", **files) == ("a_c", "base_c", "helper_c", "helped_c", "other_c")


def test_a_class_that_stands_in_a_header_is_where_it_is_exported() -> None:
    files = {"a_c": "PLUGINLIB_EXPORT_CLASS(n::A, nodelet::Nodelet)", "other_c": "void Other::go() {}"}
    assert sources_of("n::A", **files) == ("a_c",)


def test_the_whole_library_where_nothing_is_known_of_the_class() -> None:
    files = {"a_c": "MAKE_IT(A)", "other_c": "void Other::go() {}"}
    assert sources_of("n::A", **files) == ("a_c", "other_c")
    assert sources_of("n::Other", **files) == ("a_c", "other_c")


MAIN = """#include <nodelet/loader.h>
#include "demo/shared.h"
int main(int argc, char** argv) {
  ros::init(argc, argv, "one");
  nodelet::Loader loader(false);
  loader.load(ros::this_node::getName(), "@NODELET@", nodelet::M_string(), nodelet::V_string());
}
"""
CLASS = """#include "demo/shared.h"
namespace demo { class C%d : public nodelet::Nodelet { void onInit(); };
void C%d::onInit() { getPrivateNodeHandle().advertise<std_msgs::Bool>("topic%d", 1); } }
PLUGINLIB_EXPORT_CLASS(demo::C%d, nodelet::Nodelet)
"""


def package_of(root: Path, count: int) -> str:
    """A package of many nodelets in one library, with a program for each of them."""
    described = "".join(f"<class name='demo/C{i}' type='demo::C{i}' base_class_type='nodelet::Nodelet'/>" for i in range(count))
    lines = ["project(demo)", "include_directories(include)"]
    for i in range(count):
        lines += [f"set(NODELET demo/C{i})", f"configure_file(one.cpp.in one{i}.cpp @ONLY)", f"add_executable(one{i} one{i}.cpp)"]
    lines.append(f"add_library(demo {' '.join(f'src/c{i}.cpp' for i in range(count))} src/shared.cpp)")
    files = {
        "demo/package.xml": MANIFEST.format(name="demo", more="<export><nodelet plugin='${prefix}/plugins.xml'/></export>"),
        "demo/plugins.xml": f"<library path='lib/libdemo'>{described}</library>",
        "demo/CMakeLists.txt": "\n".join(lines),
        "demo/one.cpp.in": MAIN,
        "demo/include/demo/shared.h": "void shared();",
        "demo/src/shared.cpp": '#include "demo/shared.h"\nvoid shared() {}',
    }
    return str(grow(root, {**files, **{f"demo/src/c{i}.cpp": CLASS % (i, i, i, i) for i in range(count)}}))


def reads(monkeypatch: pytest.MonkeyPatch, work: Any) -> int:
    """How often something was read or looked for."""
    count = 0
    read, found = looking.read_bytes, scanned.Headers.found

    def counted_read(*args: Any) -> bytes:
        nonlocal count
        count += 1
        return read(*args)

    def counted_header(*args: Any) -> str | None:
        nonlocal count
        count += 1
        return found(*args)

    with monkeypatch.context() as patched:
        patched.setattr("launchlint.workspace.looking.read_bytes", counted_read)
        patched.setattr("launchlint.extract.scanned.Headers.found", counted_header)
        work()
    return count


def test_what_is_planned_grows_as_the_package_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small, large = package_of(tmp_path / "small", 10), package_of(tmp_path / "large", 40)
    assert reads(monkeypatch, lambda: plan([large])) <= 4.5 * reads(monkeypatch, lambda: plan([small]))
    tasks = plan([large]).tasks
    assert len(tasks) == 80
    assert {len(each.sources) for each in tasks if each.kind == "nodelets"} == {2}
    assert {len(each.sources) for each in tasks if each.kind == "executables"} == {3}


def test_programs_that_are_read_one_by_one_share_what_is_planned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counts = []
    for number in (10, 40):
        root = package_of(tmp_path / str(number), number)
        package = Packages([root], {}, explicit=True).places[0].everything[0]
        reader = SourceReader([package], [root], States())

        def ask(reader: SourceReader = reader, root: str = root, number: int = number, package: Any = package) -> None:
            for i in range(number):
                known = reader.read(("demo", "executables", f"one{i}"), package, root)
                assert known.program is not None
                assert [each["name"] for each in known.program["variants"]["default"]["publishers"]] == [f"~topic{i}"]

        counts.append(reads(monkeypatch, ask))
    assert counts[1] <= 4.5 * counts[0]


@pytest.mark.parametrize("unit", ["/*", '"\\', 'R"(', "<", "class ", "namespace ", "a::", "PLUGINLIB_X(", "#\\\n", "{", "x(", "'"])
def test_hostile_text_takes_linear_time(unit: str) -> None:
    def cost(times: int) -> float:
        start = time.process_time()
        defined_names(unit * times)
        return time.process_time() - start

    cost(10)
    assert cost(200_000) < 20 * max(cost(20_000), 0.02)
