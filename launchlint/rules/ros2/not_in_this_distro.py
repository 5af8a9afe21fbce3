"""A tag, attribute or substitution is not there in the distribution of ROS 2 that the file is launched with.

`$(if …)`, `$(equals …)`, `$(file-content …)`, `on_exit`, `emulate_tty` and others came with Jazzy; `<lifecycle_node>` and `$(path-join …)`
are newer than that. What an update of the distribution may have brought (`on_exit` in Humble, what is new in Rolling) is a warning.
The distribution is that of `--distro` or the configuration, else the one whose environment is set up, else the newest of those that the
repository's own README, images, workflows and source lists name (a warning then), else Jazzy.

## Why it matters

ros2 launch refuses the file, also where the action stands under a condition that is false.

## Example

```xml robot.launch.xml
<launch>
  <arg name="sim" default="false"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="$(string-join _ robot talker)"/>
</launch>
```

## Use instead

```xml robot.launch.xml
<launch>
  <arg name="sim" default="false"/>
  <node pkg="demo_nodes_cpp" exec="talker" name="robot_talker"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.ros2_instead import instead_of
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, LaunchView
from launchlint.rules.wording import Words, words_at
from launchlint.syntax.ros2.problems import NotInDistribution
from launchlint.syntax.ros2.python.problems import KeywordNotInDistribution
from launchlint.workspace.ros2_distributions import DISTRIBUTIONS

RULE = Rule("LL934", "not-in-this-distro", Severity.ERROR, roslaunch="refuses")
_LATER = "later"

_TAGS = {
    "lifecycle_node": "node",
    "log_info": "log",
}
"""Tags that do the same, or nearly so, in all distributions."""


def tell(problem: NotInDistribution | KeywordNotInDistribution, view: object) -> Iterator[Finding]:
    """Name the distribution that has it."""
    finding = _keyword(problem) if isinstance(problem, KeywordNotInDistribution) else _word(problem)
    file = view.launch.named_by if isinstance(view, LaunchView) else view.named_by if isinstance(view, FileView) else ""
    if file and problem.distro == DISTRIBUTIONS[-1]:
        return  # it goes on growing
    if file:
        note = f"{file} names {problem.distro.capitalize()}, and nothing here a newer one"
        severity = min(finding.severity, Severity.WARNING)
        finding = finding._replace(severity=severity, notes=(*finding.notes, note), cause=f"{problem.place.source.path} {problem.distro}")
    yield finding


def _word(problem: NotInDistribution) -> Finding:
    """A tag, attribute or substitution."""
    name, distro = problem.name, problem.distro.capitalize()
    subject = {
        "tag": f"the tag {name}",
        "attribute": f"the attribute {name} of {problem.tag}",
        "substitution": f"$({name} …)",
        "words": f"a second word of $({name} …)",
    }[problem.what]
    since = (
        "it came after all distributions that launchlint knows" if problem.since == _LATER else f"it came with {problem.since.capitalize()}"
    )
    instead = _tag_instead(name, words_at(problem.origin)) if problem.what == "tag" else ""
    if problem.what in ("substitution", "words"):
        instead = instead_of(name, problem.words, problem.place)
    advice = "remove it" if problem.what == "attribute" else "do without it"
    return RULE.at(
        problem.origin,
        f"{subject} is not there in {distro}",
        severity=Severity.ERROR if problem.sure else Severity.WARNING,
        label=f"not in {distro}",
        notes=(f"{since}; ros2 launch refuses the file" + ("" if problem.sure else f", unless an update of {distro} has brought it"),),
        help=f"write {instead}, or set distro: if another one is meant" if instead else f"{advice}, or set distro: if another one is meant",
        cause=f"{problem.place.source.path} {problem.what} {problem.tag if problem.what == 'attribute' else ''} {name}",
    )


def _tag_instead(name: str, words: Words) -> str:
    if name == "set_ros_log_dir":
        return words.written("set_env", {"name": "ROS_LOG_DIR", "value": "…"}, "")
    return words.tag(_TAGS[name]) if name in _TAGS else ""


def _keyword(problem: KeywordNotInDistribution) -> Finding:
    """A launch file in Python makes an object with a keyword that came later."""
    distro = problem.distro.capitalize()
    came = "after all distributions that launchlint knows" if problem.since == _LATER else f"with {problem.since.capitalize()}"
    return RULE.at(
        problem.origin,
        f"the keyword {problem.keyword} of {problem.callee} is not there in {distro}",
        severity=Severity.ERROR if problem.sure and not problem.assumed else Severity.WARNING,
        label=f"not in {distro}",
        notes=(f"it came {came}; ros2 launch stops with a TypeError" + ("" if problem.sure else f", unless an update of {distro} has it"),),
        help="take it out, or set distro: if another one is meant",
        cause=f"{problem.place.source.path} keyword {problem.callee} {problem.keyword}",
    )
