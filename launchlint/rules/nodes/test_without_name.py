"""A `<test>` lacks its `test-name`, or has an attribute that only a `<node>` may have.

What it does: a test must have a `test-name`, and must not have `output`, `respawn` or `respawn_delay`.

## Why it matters

roslaunch and rostest refuse the file, so that none of its tests run. The output of a test always goes to its result file, and a
test that ends is done, not to be restarted: `retry` repeats a failed one.

## Example

```xml example.test
<launch>
  <test pkg="rostest" type="hztest" name="scan_rate"/>
</launch>
```

## Use instead

```xml example.test
<launch>
  <test pkg="rostest" type="hztest" name="scan_rate" test-name="scan_rate"/>
</launch>
```

## Fix

`--fix` removes `output`, `respawn` and `respawn_delay` from a test. roslaunch loads the file then. A `test-name` has to be thought of.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.edits import LOADS, fix, remove_attribute, spot
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, LaunchView
from launchlint.syntax.problems import ConflictingAttributes, MissingAttribute

RULE = Rule("LL310", "test-without-name", Severity.ERROR, roslaunch="refuses", fixable="safe")


def tell(problem: MissingAttribute | ConflictingAttributes, view: FileView | LaunchView) -> Iterator[Finding]:
    """Speak about ``missing-attribute`` and ``conflicting-attributes`` of tests (roslaunch.xmlloader._node_tag)."""
    if isinstance(problem, MissingAttribute):
        if problem.tag == "test" and problem.attribute == "test-name":
            yield RULE.at(
                problem.origin, "the test has no test-name", label="test-name is missing",
                notes=("roslaunch stops with: <test> tag is missing required attribute: 'test-name'",),
                help='add test-name="…": its results are filed under that name',
            )  # fmt: skip
    elif problem.reason == "test-attribute":
        name = problem.attributes[-1]
        yield RULE.at(
            problem.origin, f"a test cannot have {name}", label="not allowed here",
            notes=(f"roslaunch stops with: <test> tags cannot have '{name}' attribute",),
            help="remove it; rostest --text shows the output of tests" if name == "output" else "remove it; retry repeats a failed test",
            fix=fix(f"remove {name}", remove_attribute(spot(view, problem.place)), safe=True, changes=LOADS),
        )  # fmt: skip
