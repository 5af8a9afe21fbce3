"""The value domains take exactly what roslaunch takes."""

from __future__ import annotations

import pytest

from launchlint.syntax.ros1 import domains
from launchlint.syntax.ros1.domains import Domain

TABLE: list[tuple[Domain, dict[str, object], dict[str, str]]] = [
    (
        domains.CONDITION,
        {"true": True, " True\t": True, "1": True, "FALSE": False, "0": False},
        {
            "yes": "must be true, false, 1 or 0, not 'yes'",
            "": "must be true, false, 1 or 0, not empty",
            "2": "must be true, false, 1 or 0, not '2'",
        },
    ),
    (
        domains.FLAG,
        {"true": True, "TRUE": True, "False": False},
        {"1": "must be true or false, not '1'", " true": "must be true or false, not ' true'", "": "must be true or false, not empty"},
    ),
    (domains.OPTIONAL_FLAG, {"": False, "tRue": True}, {"0": "must be true or false, not '0'"}),
    (
        domains.NUMBER,
        {"1": 1.0, "-1.5": -1.5, " 2 ": 2.0, "1e3": 1000.0, "1_0": 10.0, "inf": float("inf")},
        {"": "must be a number, not empty", "1,5": "must be a number, not '1,5'"},
    ),
    (
        domains.TIMEOUT,
        {"0.1": 0.1},
        {"0": "must be greater than 0, not '0'", "": "must be a number, not empty", "x": "must be a number, not 'x'"},
    ),
    (domains.TIME_LIMIT, {"": None, "60": 60.0}, {"-1": "must be greater than 0, not '-1'"}),
    (domains.INTEGER, {"": None, "22": 22, " 3 ": 3, "-1": -1}, {"1.5": "must be a whole number, not '1.5'"}),
    (
        domains.OUTPUT,
        {"log": "log", "screen": "screen"},
        {"Screen": "must be log or screen, not 'Screen'", "": "must be log or screen, not empty"},
    ),
    (domains.CWD, {"ROS_HOME": "ROS_HOME", "ros_home": "ROS_HOME", "node": "node"}, {"Node": "must be ROS_HOME or node, not 'Node'"}),
    (domains.COMMAND, {"": "load", "dump": "dump"}, {"Load": "must be load, dump or delete, not 'Load'"}),
    (domains.MACHINE_DEFAULT, {"": "false", "TRUE": "true", "never": "never"}, {"1": "must be true, false or never, not '1'"}),
    (
        domains.PARAM_TYPE,
        {"": "auto", " Int ": "int", "boolean": "boolean", "YAML": "yaml"},
        {
            " ": "must be auto, str, string, int, double, bool, boolean or yaml, not empty",
            "float": "must be auto, str, string, int, double, bool, boolean or yaml, not 'float'",
        },
    ),
    (domains.FILLED, {"a": "a"}, {" ": "must not be empty"}),
    (domains.NONEMPTY, {" ": " "}, {"": "must not be empty"}),
    (domains.TEXT, {"": "", "x": "x"}, {}),
]


@pytest.mark.parametrize(("domain", "good", "bad"), TABLE, ids=[row[0].name for row in TABLE])
def test_domain(domain: Domain, good: dict[str, object], bad: dict[str, str]) -> None:
    assert {value: domain.parse(value) for value in good} == good
    assert {value: domain.problem(value) for value in good} == dict.fromkeys(good)
    assert {value: domain.problem(value) for value in bad} == bad
