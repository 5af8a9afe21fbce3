"""Two tests of one launch have the same `test-name`.

What it does: it compares the `test-name` of all tests that rostest would run together, includes counted in.

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

`--unsafe-fixes` puts a number behind the second `test-name`: rostest runs both then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Fix, Severity
from launchlint.model import Node
from launchlint.rules.edits import fix, is_literal, set_value, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView
from launchlint.source import Origin

RULE = Rule("LL311", "duplicate-test-name", Severity.WARNING, fixable="unsafe")


def check(view: LaunchView) -> Iterator[Finding]:
    """Yield one finding for each test whose test-name an earlier one has (rostest.runner.createUnitTest)."""
    first_of: dict[str, Node] = {}
    for test in view.launch.tests:
        name = test.test_name
        if not name or "test-name" in test.unknown or any(condition.assumed for condition in test.conditions):
            continue
        first = first_of.setdefault(name, test)
        if first is test:
            continue
        place = test.attributes.get("test-name", test.origin.place)
        here = first.origin.place == test.origin.place
        related = () if here else ((first.attributes.get("test-name", first.origin.place), "the first one"),)
        yield RULE.at(
            Origin(place, test.origin.step),
            f"two tests have the test-name {name}",
            label="its file is included twice" if here else "the second one",
            related=related,
            notes=(f"rostest runs neither and fails with: Duplicate tests named [{name}] in rostest suite",),
            help="give each test a test-name of its own",
            fix=None if here else _fix(test, name, view),
        )


def _fix(test: Node, name: str, view: LaunchView) -> Fix | None:
    """The second test gets a number behind its test-name, the first one that no test here has."""
    place = test.attributes.get("test-name")
    if place is None or not is_literal(place, name):
        return None
    taken = {each.test_name for each in view.launch.tests}
    new = next(each for number in range(2, len(taken) + 3) if (each := f"{name}_{number}") not in taken)
    return fix(f"call the second {new}", set_value(spot(view, place), new), safe=False, changes=f"rostest runs both, the second as {new}")
