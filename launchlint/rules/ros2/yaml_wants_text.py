"""YAML gives a number or a boolean where launch takes only a text, or an integer where it takes only a number with a point.

launch converts nothing that stands in YAML: an unquoted `5`, `1.0`, `true`, `yes` or `on` is no text. What takes text is nearly everything:
`name`, `default`, `if`, `unless`, `respawn`, `value` of a `let`, an `arg` or an `env`. (`value` of a `param` takes each type.) `period` and
`respawn_delay` want a number with a point.

## Why it matters

ros2 launch refuses the file with a `TypeError`, which names the attribute, and not the line.

## Example

```yaml robot.launch.yaml
launch:
- arg:
    name: rate
    default: 10
```

## Use instead

```yaml robot.launch.yaml
launch:
- arg:
    name: rate
    default: "10"
```

## Fix

`--fix` puts quotes around the value, or `.0` behind the number; for `yes`, `no`, `on` and `off`, which may be meant as words or as true and
false, `--unsafe-fixes` does. ros2 launch does not stop there then.
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.late import late
from launchlint.rules.edits import LOADS2
from launchlint.rules.rule import Rule
from launchlint.syntax.ros2.problems import WantsFraction, WantsText

RULE = Rule("LL933", "yaml-wants-text", Severity.ERROR, roslaunch="refuses", fixable="safe")
_PLAIN = late(r"[\w.+-]+")
_CONDITIONS = {"yes": "true", "on": "true", "no": "false", "off": "false"}


def tell(problem: WantsText | WantsFraction, view: object) -> Iterator[Finding]:
    """Name the attribute and what stands there."""
    name, written = problem.attribute, problem.place.text
    shown = written if len(written) <= 40 else f"{written[:37]}…"
    if isinstance(problem, WantsFraction):
        message = f"{name} of {problem.tag} takes a number with a point, and {shown} is an integer"
        meant, notes = f"{written}.0", ("ros2 launch stops with a TypeError: it expected a float",)
    else:
        message = f"{name} of {problem.tag} takes a text, and {shown} is {problem.found} in YAML"
        word = _CONDITIONS.get(written.lower(), written) if name in ("if", "unless") else written
        meant, notes = f'"{word}"', ("ros2 launch stops with a TypeError: it expected a str",)
    yield RULE.at(
        problem.origin,
        message,
        label="write it in quotes" if isinstance(problem, WantsText) else "write it with a point",
        notes=notes,
        help=f"write {meant}",
        fix=_fix(problem, meant) if _PLAIN.fullmatch(written) is not None else None,
    )


def _fix(problem: WantsText | WantsFraction, meant: str) -> Fix:
    place = problem.place
    # What off stands for as a default, false or the word, only its author knows.
    safe = place.text.lower() not in _CONDITIONS or problem.attribute in ("if", "unless")
    return Fix(f"write {meant}", safe, (Edit(place.source.path, *place.span, meant),), LOADS2)
