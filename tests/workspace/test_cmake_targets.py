"""Which targets CMake files make, and of which sources."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.cmake_facts import read_cmake

Grow = Callable[[Mapping[str, str | None]], Path]

FILES = {
    "src/one_node.cpp": "",
    "src/two_node.cpp": "",
    "src/part.cpp": "",
    "src/part_test.cpp": "",
    "node.cpp.in": "",
    "sub/CMakeLists.txt": "add_executable(below below.cpp)\nconfigure_file(../node.cpp.in below.cpp)\n",
}


def targets(root: Path) -> list[str]:
    """Each target on one line: what it is called, its sources, ``<`` the template of one, ``?`` where there may be more."""
    files = sorted(os.path.relpath(os.path.join(at, name), root) for at, _, names in os.walk(root) for name in names)
    found = []
    for target in read_cmake(str(root), lambda: files).targets.values():
        words = [f"{'library ' if target.is_library else ''}{target.output}:"]
        for source in target.sources:
            words.append(os.path.relpath(source, root))
            if source in target.generated:
                made = target.generated[source]
                words += ["<", os.path.relpath(made.template, root), f"N={made.variables.get('N')}"]
        words += ["as well as", *target.libraries] if target.libraries else []
        words += ["assumed"] if target.assumed else []
        found.append(" ".join(words + ["?"] * (not target.complete)))
    return found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "file(GLOB F src/*_node.cpp)\nforeach(f ${F})\nget_filename_component(n ${f} NAME_WE)\nadd_executable(${n} ${f})\nendforeach()",
            ["one_node: src/one_node.cpp", "two_node: src/two_node.cpp"],
        ),
        (
            'foreach(f one_node.cpp two_node.cpp)\nstring(REPLACE .cpp "" n ${f})\nadd_executable(${n} src/${f})\nendforeach()',
            ["one_node: src/one_node.cpp", "two_node: src/two_node.cpp"],
        ),
        (
            "get_filename_component(d s/a/b.tar.gz DIRECTORY)\nget_filename_component(n s/a/b.tar.gz NAME)\nadd_executable(x ${d} ${n})",
            ["x: s/a b.tar.gz"],
        ),
        ("get_filename_component(d x.cpp EXT)\nadd_executable(x ${d})", ["x: ?"]),
        (
            "set(L one)\nif(WITH_TWO)\nlist(APPEND L two)\nendif()\nforeach(n ${L})\nadd_executable(${n} src/${n}_node.cpp)\nendforeach()",
            ["one: src/one_node.cpp", "two: src/two_node.cpp"],
        ),
        (
            "set(L one)\nif(A)\nlist(APPEND L two)\nendif()\nforeach(n IN LISTS L)\nadd_executable(${n} src/${n}_node.cpp)\nendforeach()",
            ["one: src/one_node.cpp", "two: src/two_node.cpp"],
        ),
        (
            "file(GLOB S src/part*.cpp)\nfile(GLOB T src/*_test.cpp)\nlist(REMOVE_ITEM S ${T})\nlist(PREPEND S a.cpp)\nadd_library(l ${S})",
            ["library l: a.cpp src/part.cpp"],
        ),
        (
            "aux_source_directory(src S)\nlist(REMOVE_ITEM S src/part_test.cpp)\nadd_library(l ${S})",
            ["library l: src/one_node.cpp src/part.cpp src/two_node.cpp"],
        ),
        (
            "aux_source_directory(src/. S)\nlist(GET S 0 F)\nadd_executable(x ${F} ${S})",
            ["x: src/one_node.cpp src/part.cpp src/part_test.cpp src/two_node.cpp ?"],
        ),
        ("set(S a.cpp b.cpp)\nlist(REMOVE_ITEM S ${T})\nadd_library(l ${S})", ["library l: ?"]),
        (
            (
                'function(f n)\ncmake_parse_arguments(A "" "KIND" "SRCS;LIBS" ${ARGN})\nadd_executable(${n} ${A_SRCS})\n'
                "target_link_libraries(${n} ${A_LIBS})\nendfunction()\nf(x SRCS a.cpp b.cpp KIND any LIBS l)\nf(y LIBS m SRCS c.cpp)"
            ),
            ["x: a.cpp b.cpp as well as l", "y: c.cpp as well as m"],
        ),
        (
            'function(f)\ncmake_parse_arguments(PARSE_ARGV 1 A "" "" "S")\nadd_executable(${ARGV0} ${A_S})\nendfunction()\nf(x S a.cpp)',
            ["x: a.cpp"],
        ),
        ("far_binary(x SRCS a.cc a.h DEPENDS ${L} l)", ["x: a.cc as well as l assumed ?"]),
        ("catch_add_rostest_node(x src/a_test.cpp)\ntarget_link_libraries(x l)", ["x: src/a_test.cpp as well as l"]),
        ("robot_add_node(x src/a.cpp b.cpp)", ["x: src/a.cpp b.cpp assumed ?"]),
        ("add_node_test(x a.cpp)\nadd_node_plugin(y a.cpp)\nadd_things(z a.cpp)\nadd_nodes(a b)\nadd_node(${N} a.cpp)\nadd_node()", []),
        ("set(N one)\nconfigure_file(node.cpp.in x.cpp)\nadd_executable(x x.cpp)", ["x: x.cpp < node.cpp.in N=one"]),
        (
            (
                "macro(m N)\nset(N ${N})\nconfigure_file(node.cpp.in ${N}.cpp @ONLY)\nadd_executable(${N}_exe ${N}.cpp)\n"
                "set_target_properties(${N}_exe PROPERTIES OUTPUT_NAME ${N})\nendmacro()\nm(one)\nm(two)"
            ),
            ["one: one.cpp < node.cpp.in N=one", "two: two.cpp < node.cpp.in N=two"],
        ),
        (
            "set(F ${CMAKE_CURRENT_BINARY_DIR}/gen/x.cpp)\nconfigure_file(node.cpp.in ${F} COPYONLY)\nadd_executable(x ${F} src/part.cpp)",
            ["x: <build>/gen/x.cpp < node.cpp.in N=None src/part.cpp"],
        ),
        ("add_subdirectory(sub)", ["below: sub/below.cpp < node.cpp.in N=None"]),
        (
            (
                "if(A)\nset(D ${ELSEWHERE})\nelseif(B)\nset(D ${CMAKE_SOURCE_DIR})\nelse()\nset(D nowhere)\nendif()\n"
                "configure_file(${D}/node.cpp.in x.cpp)\nadd_executable(x x.cpp)"
            ),
            ["x: x.cpp < node.cpp.in N=None"],
        ),
        ("configure_file(node.cpp.in src/part.cpp)\nadd_executable(x src/part.cpp)", ["x: src/part.cpp"]),
        ("configure_file(none.in x.cpp)\nconfigure_file(/etc/passwd y.cpp)\nadd_executable(x x.cpp y.cpp)", ["x: x.cpp y.cpp"]),
        ("configure_file(node.cpp.in)\nconfigure_file()\nconfigure_file(node.cpp.in ${X})\nadd_executable(x x.cpp)", ["x: x.cpp"]),
    ],
)
def test_targets(text: str, expected: list[str], grow: Grow) -> None:
    assert targets(grow({"CMakeLists.txt": text, **FILES})) == expected


def test_where_headers_are(grow: Grow) -> None:
    text = (
        "catkin_package(\n  INCLUDE_DIRS include\n  LIBRARIES p\n  CATKIN_DEPENDS roscpp)\ninclude_directories(. /usr/include)\n"
        "add_library(p a.cpp)\n"
        "target_include_directories(p PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/parts> $<INSTALL_INTERFACE:installed>)\n"
    )
    root = grow({"CMakeLists.txt": text})
    assert [os.path.relpath(each, root) for each in read_cmake(str(root), list).include_directories] == ["include", ".", "parts"]


@pytest.mark.parametrize(
    "text",
    [
        "set(A a)\n" + "string(REPLACE a aaaaaaaaaaaaaaaaaaaaaaaaa A ${A})\n" * 100 + "add_executable(${A} x)",
        "set(N n)\n" * 900 + "foreach(a 1 2 3 4 5 6 7 8 9)\n" * 3 + "configure_file(node.cpp.in ${a}.cpp)\n" + "endforeach()\n" * 3,
        "cmake_parse_arguments(" + "A " * 50_000 + ")",
        "cmake_parse_arguments(PARSE_ARGV 999999999999 a b c d)\ncmake_parse_arguments(PARSE_ARGV)",
        "x_node(" + "A SRCS a.cc " * 20_000 + ")",
        "string(REPLACE a b c)\nstring(REPLACE)\nget_filename_component()\nget_filename_component(a)\nlist(REMOVE_ITEM)\nlist(PREPEND a)",
        "catkin_package(INCLUDE_DIRS)\nconfigure_file(${A${B}} ${C)\n",
    ],
)
def test_hostile_targets_end_soon(text: str, grow: Grow) -> None:
    root = grow({"CMakeLists.txt": text, **FILES})
    start = time.process_time()
    found = targets(root)
    assert time.process_time() - start < 5
    assert all(len(each) < 1_000_000 for each in found)
