"""Unit tests: functions that a macro makes (``TEST(suite, name) { … }``), and that nothing in the sources calls by name.

``RUN_ALL_TESTS()`` of gtest runs them all, as do the libraries of Catch and Boost.Test, which bring ``main()`` with them. A test of a
fixture (``TEST_F``) is a member of a class below it, whose ``SetUp()`` runs first.
"""

from __future__ import annotations

import re

from launchlint.extract.cpp import classes
from launchlint.extract.cpp.declarations import Function
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.syntax import Node
from launchlint.extract.cpp.values import Thing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.machine import Machine

_OF_FIXTURES = re.compile(r"\w{0,200}(?:TEST_[FP]|FIXTURE_TEST_CASE\w*|TEST_CASE_METHOD)")


def follow(machine: Machine) -> bool:
    """Follow all tests of the program; whether it has any."""
    for test in machine.declarations.tests:
        if any(each.type.name.startswith("DISABLED_") for each in test.parameters):
            continue  # gtest leaves it out
        machine.when, machine.conditions = "start", []
        machine.call(test, _fixture(machine, test), [])
    return bool(machine.declarations.tests)


def _fixture(machine: Machine, test: Function) -> Thing | None:
    """The object that a test of a fixture is a member of, set up."""
    frame = Frame(test.path, test.scope, None, {})
    for parameter in test.parameters if _OF_FIXTURES.fullmatch(test.last) else ():
        resolved = machine.names.resolve(parameter.type, frame)
        declared = machine.names.declared(resolved)
        thing = None if declared is None else classes.make(machine, declared, resolved, [], Node("declaration", b"", 0, 0), frame)
        if declared is not None and isinstance(thing, Thing):
            test.owner = test.scope = declared.name
            for function in classes.methods(machine, thing, "SetUp")[-1:]:
                machine.call(function, thing, [])
            return thing
    return None
