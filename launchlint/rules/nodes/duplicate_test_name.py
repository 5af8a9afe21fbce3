"""Two tests of one launch have the same `test-name`.

What it does: it compares the `test-name` of all tests that rostest would run together, includes counted in. All that share one name are
told as one.

## Why it matters

rostest tells tests apart by their `test-name` alone. Where two share one it runs neither of them, and reports a failure instead.

## Example

```xml example.test
<launch>
  <test pkg="rostest" type="hztest" test-name="rate" name="scan_rate"/>
  <test pkg="rostest" type="hztest" test-name="rate" name="image_rate"/>
</launch>
```

## Use instead

```xml example.test
<launch>
  <test pkg="rostest" type="hztest" test-name="scan_rate" name="scan_rate"/>
  <test pkg="rostest" type="hztest" test-name="image_rate" name="image_rate"/>
</launch>
```

## Fix

`--unsafe-fixes` gives each test but the first its `name` as `test-name` where these differ, and else a number behind it: rostest runs them
all then.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Node
from launchlint.rules.edits import Edits, fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin, Place

RULE = Rule("LL311", "duplicate-test-name", Severity.WARNING, fixable="unsafe")
MOST_NAMED = 4


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each test-name that several tests have, at the second of them (rostest.runner.createUnitTest)."""
    known: dict[str, list[Node]] = {}
    for test in view.launch.tests:
        name = test.test_name
        if name and test.knows("test_name") and not any(condition.assumed for condition in test.conditions):
            known.setdefault(name, []).append(test)
    for name, tests in known.items():
        if len(tests) > 1:
            yield _finding(name, tests, view)


def _finding(name: str, tests: Sequence[Node], view: LaunchView) -> Finding:
    first, second, *_ = tests
    here = _place(second)
    words = {_place(test): "another one" for test in tests[2:]} | {_place(first): "the first one"}
    words.pop(here, None)
    return RULE.at(
        Origin(here, second.origin.step),
        f"{'two' if len(tests) == 2 else len(tests)} tests have the test-name {name}",
        label="its file is included twice" if here == _place(first) else "the second one",
        related=tuple(sorted(words.items(), key=lambda item: item[1], reverse=True)),
        notes=(f"rostest runs none of them and fails with: Duplicate tests named [{name}] in rostest suite",),
        help="give each test a test-name of its own",
        fix=_fix(name, tests, view),
    )


def _place(test: Node) -> Place:
    return test.places.get("test_name", test.origin.place)


def _fix(name: str, tests: Sequence[Node], view: LaunchView) -> Fix | None:
    """All but the first get other test-names; none where one element stands for two of them, or its test-name is computed."""
    places = [_place(test) for test in tests]
    if len(set(places)) < len(places) or not all(is_literal(place, name) for place in places[1:]):
        return None
    taken = {each.test_name for each in view.launch.tests}
    new = [test.name for test in tests[1:]]
    if not all(new) or len({tests[0].name, *new}) < len(tests) or taken.intersection(new):
        numbered = (f"{name}_{number}" for number in range(2, len(taken) + len(tests) + 2))
        free = (each for each in numbered if each not in taken)
        new = [next(free) for _ in tests[1:]]
    changed: list[Edits] = [set_value(spot(view, place), each) for place, each in zip(places[1:], new, strict=True)]
    if not all(changed):
        return None
    listed = ", ".join(new[:MOST_NAMED]) + (" …" if len(new) > MOST_NAMED else "")
    who = "the second" if len(tests) == 2 else "the others"
    edits = tuple(edit for each in changed for edit in each)
    return fix(f"call {who} {listed}", edits, safe=False, changes=f"rostest runs all of them, {who} as {listed}")
