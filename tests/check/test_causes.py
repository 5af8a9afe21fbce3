"""One cause, one finding."""

from __future__ import annotations

from launchlint.check.causes import told_once, told_with_theirs
from launchlint.finding import Edit, Finding, Fix, Location, Related, Severity


def _finding(line: int, *, cause: str = "", severity: Severity = Severity.WARNING, fix: Fix | None = None, rule: str = "LL702") -> Finding:
    location = Location("a.launch", line, 1, line, 5, line * 10, line * 10 + 4, "text")
    return Finding(rule, "name", severity, location, f"message {line}", label=f"label {line}", fix=fix, cause=cause)


def test_findings_without_a_cause_stay_single() -> None:
    findings = (_finding(1), _finding(2), _finding(3, cause="x"), _finding(4, cause="y"), _finding(5))
    assert told_once(findings) == findings


def test_the_worst_then_the_first_speaks_for_all() -> None:
    told = told_once([_finding(3, cause="x"), _finding(2, cause="x", severity=Severity.ERROR), _finding(1, cause="x"), _finding(9)])
    assert [(each.location.line, each.severity, each.message) for each in told] == [
        (2, Severity.ERROR, "message 2 (and at 2 more places)"),
        (9, Severity.WARNING, "message 9"),
    ]
    assert [(each.location.line, each.label) for each in told[0].related] == [(1, "label 1"), (3, "label 3")]


def test_the_finding_that_shows_most_speaks_for_those_of_other_rules() -> None:
    calls = [_finding(line, cause="x") for line in (1, 2)]
    target = _finding(9, cause="x", rule="LL703")._replace(related=tuple(Related(each.location, "breaks here") for each in calls))
    assert told_once([*calls, target]) == (target,)


def test_a_place_that_is_named_already_is_not_named_again() -> None:
    second = _finding(2, cause="x")
    first = _finding(1, cause="x")._replace(related=(Related(second.location, "label 2"),))
    assert told_once([first, second])[0].related == (Related(second.location, "label 2"),)


def _insert(line: int, *, start: int, end: int, safe: bool = True) -> Finding:
    return _finding(line, cause="x", fix=Fix(f"mend {line}", safe, (Edit("a.launch", start, end, "new"),), ""))


def test_fixes_are_joined_where_they_do_not_meet() -> None:
    (told,) = told_once([_insert(1, start=10, end=12), _insert(2, start=12, end=14, safe=False)])
    assert told.fix == Fix("mend 1, and the others alike", False, (Edit("a.launch", 10, 12, "new"), Edit("a.launch", 12, 14, "new")), "")


def test_there_is_no_joined_fix_where_one_lacks_it_or_two_meet() -> None:
    assert told_once([_insert(1, start=10, end=12), _finding(2, cause="x")])[0].fix is None
    assert told_once([_insert(1, start=10, end=13), _insert(2, start=12, end=14)])[0].fix is None
    assert told_once([_insert(1, start=10, end=10), _insert(2, start=10, end=10)._replace(message="m")])[0].fix is not None


def test_each_finding_stands_in_one_that_is_told() -> None:
    """Also where a rule joins what was joined: the home directory of one person, by two causes, and a path of another one."""
    homes = [
        _finding(line, cause=cause, rule="LL406")._replace(message=f"/home/{who}/a{line} is a path of one machine")
        for line, cause, who in ((1, "x", "ann"), (2, "x", "ann"), (3, "y", "ann"), (4, "z", "bob"))
    ]
    told = told_with_theirs([*homes, _finding(9), _finding(8, severity=Severity.INFO)])
    assert [sorted(each.location.line for each in one.of) for one in told] == [[1, 2, 3], [4], [8], [9]]
    assert [one.finding for one in told] == list(told_once([*homes, _finding(9), _finding(8, severity=Severity.INFO)]))


def _at(path: str, line: int, message: str, text: str, rule: str = "LL901") -> Finding:
    finding = _finding(line, rule=rule)
    return finding._replace(location=finding.location._replace(path=path, text=text), message=message)


def test_files_under_another_number_or_side_are_one() -> None:
    """What one of them shows several of is paired, and not joined."""
    numbered = [
        _at(f"config/robot{robot}.yaml", line, f"/robot{robot}/sensor{line} is nobody", f"/robot{robot}/sensor{line}:")
        for robot in (1, 2)
        for line in (1, 2)
    ]
    sides = [_at(f"config/{side}.yaml", 1, f"/{side}/arm is nobody", f"/{side}/arm:") for side in ("left", "right")]
    other = _at("config/robot3.yaml", 1, "/robot3/camera1 is nobody", "/robot3/camera1:")
    told = told_with_theirs([*numbered, *sides, other])
    assert [{each.location.path for each in one.of} for one in told] == [
        {"config/left.yaml", "config/right.yaml"},
        {"config/robot1.yaml", "config/robot2.yaml"},
        {"config/robot1.yaml", "config/robot2.yaml"},
        {"config/robot3.yaml"},
    ]
    assert told[0].finding.message == "/left/arm is nobody (and at 1 more place)"


def test_packages_of_other_names_are_one_where_a_long_line_was_copied() -> None:
    def of(package: str, text: str) -> Finding:
        return _at(f"{package}_config/launch/demo.launch", 3, f"{package}_config/launch/demo.launch does not exist", text)

    long = [of(name, f'<include file="$(find {name}_config)/launch/demo.launch"/>') for name in ("ant", "bee")]
    short = [of(name, f'<include file="{name}"/>') for name in ("ant", "bee")]
    assert len(told_once(long)) == 1
    assert told_once(short) == tuple(short)


def test_a_rule_that_knows_copies_joins_them_itself() -> None:
    several = [_at(f"robot{number}/package.xml", 1, f"robot{number} lacks rviz", "<package>", rule="LL701") for number in (1, 2)]
    assert [each.message for each in told_once(several)] != ["robot1 lacks rviz (and at 1 more place)"]


def test_the_same_line_at_the_same_place_of_files_of_one_name_is_one() -> None:
    """Whatever package each of them names; a short one may be chance."""

    def of(package: str, line: int, text: str) -> Finding:
        return _at(f"{package}_detect/launch/node.launch.py", line, f"{package}_drive has no executable driver", text)

    copied = [of(name, 8, "executable='depthai_driver',") for name in ("ant", "bee")]
    elsewhere = of("cow", 9, "executable='depthai_driver',")
    short = [of(name, 10, "exec='driver',") for name in ("dog", "eel")]
    told = told_with_theirs([*copied, elsewhere, *short])
    assert [[each.location.line for each in one.of] for one in told] == [[8, 8], [9], [10], [10]]


def test_one_sentence_about_one_other_thing_is_one() -> None:
    """What names nothing beside its own line, or says another thing to do, is a mistake of its own."""

    def of(line: int, arg: str, what: str, path: str = "main.launch") -> Finding:
        return _at(path, line, f"the arg {arg} {what}", f'<arg name="{arg}" value="1"/>', rule="LL212")._replace(label="refused")

    fixed = [of(line, arg, "is fixed by part.launch") for line, arg in ((1, "low"), (2, "high"))]
    others = [of(3, "low", "is fixed by other.launch"), of(4, "rate", "is unknown"), of(5, "size", "is unknown")]
    helped = of(6, "near", "is fixed by part.launch")._replace(help="did you mean far?")
    elsewhere = of(7, "low", "is fixed by part.launch", path="second.launch")
    told = told_with_theirs([*fixed, *others, helped, elsewhere])
    assert [[each.location.line for each in one.of] for one in told] == [[1, 2], [3], [4], [5], [6], [7]]
    assert told[0].finding.message == "the arg low is fixed by part.launch (and at 1 more place)"
