"""A `$(…)` is not one that roslaunch can resolve.

It has a command that does not exist, too few or too many words, or another substitution or parenthesis inside it. The
commands are `find`, `env`, `optenv`, `dirname`, `anon` and `arg`; `$(eval …)` must be the whole value. The same mistake is told once in a
file. It is an info where it holds what a tool fills in before anybody launches the file (`{{ robot }}`).

In ROS 2 there are others (`var`, `find-pkg-share`, `env`, `eval` …), they may stand in each other, and exactly one blank stands between
their words. What is wrong with one is found when the file is read, also under a condition that is false.

## Why it matters

roslaunch refuses the file when it gets to the value.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(dir)/office.yaml"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="$(eval $(var rate) * 2)"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(dirname)/office.yaml"/>
</launch>
```

```xml ros2.launch.xml
<launch>
  <arg name="rate" default="10"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="talker">
    <param name="rate" value="$(eval '$(var rate) * 2')"/>
  </node>
</launch>
```

## Fix

`--fix` writes the command that the name is one slip away from: `$(args x)` becomes `$(arg x)`. What asks for a package as in a shell,
`$(rospack find x)`, becomes `$(find x)`. `--unsafe-fixes` closes a `$(eval …` that lacks its last parenthesis.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import BadSubstitution
from launchlint.finding import Finding, Fix, Severity
from launchlint.late import late
from launchlint.rules.edits import LOADS, Spot, fix, replace, set_value, spot
from launchlint.rules.judging.template import FILLED_IN, has_placeholder
from launchlint.rules.rule import Rule
from launchlint.spelling import closest, surely
from launchlint.syntax.parts import Malformed, Substitution, Word
from launchlint.syntax.ros1.dialect import ROS2_SUBSTITUTIONS
from launchlint.syntax.ros1.substitutions import COMMANDS, parse_again
from launchlint.syntax.ros2.problems import SubstitutionArity, UnknownSubstitution, UnreadableSubstitution

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.ros2.problems import CommandOption, NoDirectory, ParameterNotSet

RULE = Rule("LL207", "bad-substitution", Severity.ERROR, roslaunch="refuses", fixable="safe")
MOST_WORDS = 3
_ASKING = frozenset(("find", "package", "pkg"))
_PART = late(r"[^a-z]+")
_NAME = late(r"[A-Za-z][\w-]*")
_OPEN_EVAL = "close it with ): the last character of the value must be the ) of $(eval"
EVAL_ALONE = "$(eval …) must be the whole value: write the text around it as strings in the expression"


def tell(
    problem: BadSubstitution | UnreadableSubstitution | UnknownSubstitution | SubstitutionArity | CommandOption
    | NoDirectory | ParameterNotSet,
    view: object,
) -> Iterator[Finding]:  # fmt: skip
    """Say what is wrong with it. What the other dialect has is LL112's."""
    if not isinstance(problem, BadSubstitution):
        if isinstance(problem, (UnreadableSubstitution, UnknownSubstitution, SubstitutionArity)):
            from launchlint.rules.judging.ros2_substitutions import tell as tell_ros2

            yield from tell_ros2(problem, RULE)
            return
        from launchlint.rules.judging.ros2_names import substitution

        yield from substitution(problem, RULE)
        return
    reason, text = problem.reason, problem.text
    words = [word.text for word in _words(text)]
    command = words[0] if words else ""
    if command in ROS2_SUBSTITUTIONS:
        return
    at = spot(view, problem.place)
    open_eval = command == "eval" and at is not None and at.attribute is not None and _lacks_its_end(at.attribute.value)
    if open_eval:
        reason = "its last ) is missing"
    unknown = bool(command) and command not in (*COMMANDS, "eval") and "inside" not in reason
    template = has_placeholder(text)
    yield RULE.at(
        problem.origin,
        f"{text[:60]}{'' if text.endswith(')') else '…'} cannot be resolved: {reason}",
        severity=Severity.INFO if template else Severity.ERROR if problem.refused else Severity.WARNING,
        notes=("roslaunch stops when it gets here", *((FILLED_IN,) if template else ())),
        help="" if template else _OPEN_EVAL if open_eval else _advice(reason, command, words),
        fix=_closed(at) if open_eval else _fix(problem, view, command, words) if unknown and not template else None,
        label="not a command" if unknown else "",
        cause=f"{problem.place.source.path} {FILLED_IN}"
        if template
        else f"{f'{problem.place.source.path} {command}' if unknown else text} {reason} {problem.refused}",
    )


def _words(text: str) -> Sequence[Word]:
    first = parse_again(text).parts[0]
    return first.words if isinstance(first, (Substitution, Malformed)) else ()


def _lacks_its_end(value: str) -> bool:
    """Whether all of ``value`` is one ``$(eval`` whose own parenthesis is not there: roslaunch wants it as the last character."""
    return value.startswith("$(eval ") and value.count("(") == value.count(")") + 1


def _closed(at: Spot | None) -> Fix | None:
    value = "" if at is None or at.attribute is None else at.attribute.value
    return fix("close it with )", set_value(at, f"{value})"), safe=False, changes=LOADS)


def _fix(problem: BadSubstitution, view: object, command: str, words: list[str]) -> Fix | None:
    """A misspelt command becomes the only one that it is a slip for, and a shell's way to find a package that of roslaunch."""
    meant = surely(command, COMMANDS)
    text = problem.place.text
    package = _package(words)
    if package and text.startswith("$(") and text.endswith(")"):
        found = f"$(find {package})"
        return fix(f"write {found}", replace(spot(view, problem.place), problem.place, found), safe=True, changes=LOADS)
    if meant is None or not text.startswith("$(") or text.count(command) != 1:
        return None
    return fix(f"write {meant}", replace(spot(view, problem.place), problem.place, text.replace(command, meant)), safe=True, changes=LOADS)


def _package(words: list[str]) -> str:
    """The package that is asked for in other words than ``$(find X)``: ``rospack find X``, ``find-package X``; empty where none is."""
    parts = {part for word in words[:-1] for part in _PART.split(word.lower())}
    asks = len(words) > 1 and words[0] not in COMMANDS and not parts.isdisjoint(_ASKING)
    return words[-1] if asks and len(words) <= MOST_WORDS and _NAME.fullmatch(words[-1]) else ""


def _advice(reason: str, command: str, words: list[str]) -> str:
    if command == "eval":
        return EVAL_ALONE
    if "inside" in reason:
        if "$" in reason or "substitution cannot" in reason:
            return "make the inner one an <arg> of its own, or write the whole as $(eval …) with arg('…') and find('…')"
        return "write it without the parenthesis"
    if command in COMMANDS:
        if len(words) < 3:
            return f"write $({command} name)"
        return f"{command} takes a single name: is there a ) missing before {words[2]}?"
    if package := _package(words):
        return f"write $(find {package})"
    glued = next((known for known in COMMANDS if command.startswith(known) and known != "dirname"), None)
    if glued is not None and len(words) == 1:
        return f"did you mean $({glued} {command.removeprefix(glued).strip()})?"
    near = closest(command, COMMANDS) or next((known for known in COMMANDS if len(command) > 2 and known.startswith(command)), None)
    if near is not None:
        return f"did you mean {near}?"
    return f"the commands are {', '.join(COMMANDS)}, and eval for the whole value"
