"""The params for a node stand under a name in a file, and the launch file does not give the node that name.

What it does: it looks for a parameter file with names only, no `/**`, that is given to a node without `name`, or with one of `$(anon …)`.
It is a warning where no key can be that of the node, because the name is made up for each start or no key is in the node's namespace.
Else it is information: they reach the node as long as its program calls itself so, and nothing is said where that is what the program
is called. Where several programs are given the file it is, too: it may be for a node that one of them makes beside its own.

## Why it matters

The node starts with the defaults of its program, and nobody says so: at once, or when its author calls it something else.

## Example

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="$(anon talker)">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
talker:
  ros__parameters:
    rate: 5
```

## Use instead

```xml talk.launch.xml
<launch>
  <node pkg="demo_nodes_cpp" exec="talker" name="$(anon talker)">
    <param from="$(dirname)/talker.yaml"/>
  </node>
</launch>
```

```yaml talker.yaml
/**:
  ros__parameters:
    rate: 5
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.evaluate.ros2.parameter_problems import NamedForUnnamed
from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.wording import SHARED, words_at

RULE = Rule("LL944", "anonymous-gets-named-params", Severity.WARNING)


def tell(problem: NamedForUnnamed, view: object) -> Iterator[Finding]:
    """Say under which key they would reach it. That a program calls itself as it is called itself, everybody may expect."""
    if not (problem.anonymous or problem.certain) and any(key.rpartition("/")[2] == problem.program for key in problem.keys):
        return
    file, keys = problem.file.rpartition("/")[2], ", ".join(problem.keys)
    words = words_at(problem.origin)
    if problem.anonymous:
        message, note = f"nothing in {file} reaches this node: its name is made up for each start", f"the keys of the file: {keys}"
        advice = f"write /** as the key, or give the node a name without {words.call('anon', '…')}"
    elif problem.certain:
        message = f"nothing in {file} reaches {problem.program}: no key is in its namespace {problem.namespace}"
        note = f"the keys of the file: {keys}"
        advice = f"write /** as the key, or the full name, which begins with {problem.namespace.rstrip('/')}/"
    else:
        message = f"{file} reaches {problem.program} only if it calls itself {keys}: the launch file does not say its name"
        note = "a node without a name here has the one that its program gives it"
        advice = f"say it here, too: {words.set_to('name', problem.keys[0].rpartition('/')[2])}"
    others = (SHARED,) if problem.shared else ()
    yield RULE.at(
        problem.origin,
        message,
        severity=None if (problem.anonymous or problem.certain) and not problem.shared else Severity.INFO,
        label="params under names",
        notes=(note, *others),
        help=advice,
        cause=f"{problem.file} {problem.anonymous} {problem.certain}",
    )
