"""Reading CMake without running it."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.cmake import Argument, CMakeError, commands
from launchlint.workspace.cmake_facts import read_cmake

Grow = Callable[[Mapping[str, str | None]], Path]


def _plain(text: str) -> list[tuple[str, list[str]]]:
    return [(command.name, [each.text for each in command.arguments]) for command in commands(text)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", []),
        ("# nothing\n", []),
        ("project(a)", [("project", ["a"])]),
        ("PROJECT ( a\n b # c ) d\n e )", [("project", ["a", "b", "e"])]),
        ('set(a "b c;d" e;f)', [("set", ["a", "b c;d", "e", "f"])]),
        ('set(a "b\\"c" d\\ e)', [("set", ["a", 'b\\"c', "d\\ e"])]),
        ("set(a [[b]c]] [=[ ]] ]=])", [("set", ["a", "b]c", " ]] "])]),
        ("#[[ all\nof this ]] set(a)", [("set", ["a"])]),
        ("#[==[ a ]] ]==]\nset(a) #x", [("set", ["a"])]),
        ("if((a) AND b)\nendif()", [("if", ["(", "a", ")", "AND", "b"]), ("endif", [])]),
        ('set(a -Dx="y z")', [("set", ["a", '-Dx="y z"'])]),
        ("set(a $<a:b>)", [("set", ["a", "$<a:b>"])]),
    ],
)
def test_commands(text: str, expected: list[tuple[str, list[str]]]) -> None:
    assert _plain(text) == expected


def test_kinds_of_arguments_and_lines() -> None:
    found = commands('a(x "y"\n [[z]])\n\nb()')
    assert found[0].arguments == (Argument("x", False, False), Argument("y", True, False), Argument("z", True, True))
    assert [each.line for each in found] == [1, 4]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a(", "line 1: the command is not closed"),
        ("a()\nb", "line 2: ( was expected after b"),
        ('a("b', "line 1: the command is not closed"),
        ("<xml/>", "line 1: a command name was expected"),
        ("a([[b)", "a bracket argument is not closed"),
        ("a(\0)", "it is not a text file"),
    ],
)
def test_what_is_no_cmake(text: str, message: str) -> None:
    with pytest.raises(CMakeError) as caught:
        commands(text)
    assert str(caught.value) == message


def _read(root: Path) -> tuple[dict[str, str], list[str], list[str]]:
    files = [os.path.relpath(os.path.join(at, name), root) for at, _, names in os.walk(root) for name in names]
    facts = read_cmake(str(root), lambda: sorted(files))
    return facts.executables, facts.executables_reasons, facts.installs_reasons


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("add_executable(a a.cpp)", ["a"]),
        ("project(p)\nadd_executable(${PROJECT_NAME}_node a.cpp)", ["p_node"]),
        ("set(N x)\nset(M N)\nadd_executable(${${M}}_y a.cpp)", ["x_y"]),
        ("foreach(n a b)\nadd_executable(${n}_node ${n}.cpp)\nendforeach()", ["a_node", "b_node"]),
        ("set(L a b)\nlist(APPEND L c)\nforeach(n IN LISTS L ITEMS d)\nadd_executable(${n} x)\nendforeach(n)", ["a", "b", "c", "d"]),
        ("foreach(a 1 2)\nforeach(b x y)\nadd_executable(n${a}${b} s)\nendforeach()\nendforeach()", ["n1x", "n1y", "n2x", "n2y"]),
        ("if(A)\nadd_executable(a x)\nelseif(B)\nadd_executable(b x)\nelse()\nadd_executable(c x)\nendif()", ["a", "b", "c"]),
        ("if(FALSE)\nadd_executable(a x)\nelse()\nadd_executable(c x)\nendif()", ["c"]),
        ("set(C false)\nif(C)\nadd_executable(a x)\nelse()\nadd_executable(c x)\nendif()", ["c"]),
        ("set(C ON)\nif(NOT C)\nadd_executable(a x)\nelseif(C)\nadd_executable(b x)\nelse()\nadd_executable(c x)\nendif()", ["b"]),
        ("set(C ON CACHE BOOL c)\nif(C)\nadd_executable(a x)\nelse()\nadd_executable(c x)\nendif()", ["a", "c"]),
        ("if(A)\nset(C ON)\nendif()\nif(C)\nadd_executable(a x)\nelse()\nadd_executable(c x)\nendif()", ["a", "c"]),
        ("set(C OFF)\nif(A)\nset(C ON)\nendif()\nif(C)\nadd_executable(a x)\nelse()\nadd_executable(c x)\nendif()", ["a", "c"]),
        ("set(CUDA_FOUND OFF)\nfind_package(CUDA)\nif(CUDA_FOUND)\nadd_executable(a x)\nendif()", ["a"]),
        ("if(A)\nset(N a)\nelse()\nset(N a)\nendif()\nadd_executable(${N} x)", ["a"]),
        ("function(f)\nadd_executable(a x)\nendfunction()\nadd_executable(b x)", ["b"]),
        ("catkin_add_gtest(t t.cpp)\nadd_rostest_gtest(u u.test u.cpp)\ncatkin_add_gmock(v v.cpp)", ["t", "u", "v"]),
        ("cuda_add_executable(a x)\ncs_add_executable(b x)\nrosbuild_add_executable(c x)", ["a", "b", "c"]),
        ("add_executable(a ALIAS b)\nadd_executable(c IMPORTED)\nadd_executable(d x)", ["d"]),
        ("add_executable(a x)\nset_target_properties(a PROPERTIES OUTPUT_NAME b PREFIX c)", ["b"]),
        ("install(PROGRAMS scripts/a.py b DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})", ["a.py", "b"]),
        ("install(PROGRAMS scripts/a.py DESTINATION x RENAME a)", ["a"]),
        ("catkin_install_python(PROGRAMS s/a.py\n  s/b.py DESTINATION x)", ["a.py", "b.py"]),
        ("file(GLOB S RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} s/*.py)\ninstall(PROGRAMS ${S} DESTINATION x)", ["one.py", "two.py"]),
        ("file(GLOB_RECURSE S *.py)\ninstall(PROGRAMS ${S} DESTINATION x)", ["one.py", "two.py", "deep.py"]),
        ("configure_file(a.in ${CMAKE_CURRENT_SOURCE_DIR}/a.sh)", ["a.sh"]),
        ("add_subdirectory(sub)\nadd_executable(a x)", ["sub_node", "a"]),
        ("include(cmake/extra.cmake)\ninclude(CTest)", ["extra"]),
        ("macro(m)\nset(N 1)\nmessage(x)\nendmacro()\nm()\nadd_executable(a x)", ["a"]),
        ("add_gtest_coverage(x)\ncheck_cxx_compiler_flag(x y)\nqt5_wrap_ui(x y)", []),
        ("return()", []),
    ],
)
def test_executables_that_are_all_known(text: str, names: list[str], grow: Grow) -> None:
    root = grow(
        {
            "CMakeLists.txt": text,
            "s/one.py": "",
            "s/two.py": "",
            "s/x/deep.py": "",
            "sub/CMakeLists.txt": "add_executable(sub_node x)",
            "cmake/extra.cmake": "add_executable(extra x)",
        }
    )
    executables, reasons, _ = _read(root)
    assert (list(executables), reasons) == (names, [])


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("add_executable(${N} x)", "add_executable with a name that is not known"),
        ("add_executable($<x:y> x)", "add_executable with a name that is not known"),
        ("add_executable($ENV{N} x)", "add_executable with a name that is not known"),
        ("add_executable(${PROJECT_NAME} x)", "add_executable with a name that is not known"),
        ("if(A)\nset(N a)\nelse()\nset(N b)\nendif()\nadd_executable(${N} x)", "add_executable with a name that is not known"),
        ("set(N a)\nif(A)\nset(N b)\nendif()\nadd_executable(${N} x)", "add_executable with a name that is not known"),
        ("set(N a)\nstring(TOUPPER ${N} N)\nadd_executable(${N} x)", "add_executable with a name that is not known"),
        ("foreach(n ${LATER})\nadd_executable(${n} x)\nendforeach()", "add_executable with a name that is not known"),
        ("set(i 0)\nwhile(i LESS 3)\nadd_executable(a${i} x)\nmath(EXPR i x)\nendwhile()", "add_executable with a name that is not known"),
        ("add_robot_nodes(x)", "the command add_robot_nodes (line 1) is not known"),
        ("function(f n)\nadd_executable(${n} x)\nendfunction()\nf(a)", "the command f (line 4) uses add_executable"),
        ("macro(g)\nf()\nendmacro()\nmacro(f)\ninstall(x)\nendmacro()\ng()", "the command g (line 7) uses install"),
        ("install(PROGRAMS ${S} DESTINATION x)", "install with a file that is not known"),
        ("install(CODE x)", "install(CODE) runs code"),
        ("add_subdirectory(${D})", "add_subdirectory with a directory that is not known"),
        ("add_subdirectory(nowhere)", "nowhere/CMakeLists.txt cannot be read: No such file or directory"),
        ("add_subdirectory(../other)", "a file outside the package is not read"),
        ("include(/etc/passwd)", "/etc/passwd is not read, since it is not called *.cmake"),
        ("include(/etc/other.cmake)", "a file outside the package is not read"),
        ("include(${D})", "include of a file that is not known"),
        ("include(again.cmake)", "again.cmake is not read"),
        ("add_executable(a x)\nset_target_properties(a PROPERTIES OUTPUT_NAME ${N})", "OUTPUT_NAME is not known"),
        ("add_custom_target(a ALL COMMAND cp x y)", "add_custom_target makes a file whose name is not known"),
        ("add_custom_command(OUTPUT test/.made\n COMMAND make -C test/)", "add_custom_command makes a file whose name is not known"),
        ("execute_process(COMMAND /usr/bin/make -C test/)", "execute_process makes a file whose name is not known"),
        ("file(COPY a DESTINATION b)", "file(COPY) makes a file whose name is not known"),
        ("add_executable(", "CMakeLists.txt, line 1: the command is not closed"),
    ],
)
def test_why_executables_may_be_missing(text: str, reason: str, grow: Grow) -> None:
    root = grow({"CMakeLists.txt": text, "again.cmake": "include(again.cmake)"})
    _, reasons, _ = _read(root)
    assert reasons[:1] == [reason]


def test_a_package_without_cmake(tmp_path: Path) -> None:
    executables, reasons, installs = _read(tmp_path)
    assert executables == {}
    assert reasons == installs == ["CMakeLists.txt cannot be read: No such file or directory"]


@pytest.mark.parametrize(
    "text",
    [
        "if(A)\n" * 5_000,
        "foreach(a 1 2 3 4 5 6 7 8 9)\n" * 40 + "add_executable(x${a} y)\n" + "endforeach()\n" * 40,
        "set(A x)\n" + 'set(A "${A}${A}")\n' * 200 + "add_executable(${A} x)",
        "set(L " + "x " * 60_000 + ")\nforeach(a ${L})\nforeach(b ${L})\nendforeach()\nendforeach()",
        "add_" * 100_000 + "()",
        "a(" + "(" * 300_000,
        "${" * 200_000,
        "set(A " + "${" * 200_000 + ")",
        "\n".join(f"set(V{number} {number})\nif(x)\nendif()" for number in range(5_000)),
        "file(GLOB X " + "*a" * 5_000 + "b)\n" * 1,
        '"' * 400_000,
        "#[[" * 100_000,
    ],
)
def test_hostile_cmake_ends_soon(text: str, grow: Grow) -> None:
    root = grow({"CMakeLists.txt": text, **{f"{'a' * 60}{number}": "" for number in range(50)}})
    start = time.process_time()
    _, reasons, _ = _read(root)
    assert time.process_time() - start < 5
    assert all(len(each) < 300 for each in reasons)
