"""A node has a name that ROS does not allow.

What it does: it looks at the resolved `name` of nodes and tests. A slash or a leading `~` is an error, because roslaunch refuses
the file; a slash is a warning where args make the name and it takes another value than a default, and an info where a comment of the
file names that arg, as one that has to be given then. Other characters than letters, digits
and `_`, a digit at the start, and an empty name are warnings; infos where the name is made of an arg with an empty default, or of one
whose default a condition around the node tells apart, and where the program is a test in Python that makes no node, so that nobody uses it.

## Why it matters

A C++ node ends at start with an invalid-name exception when its name holds a blank or a hyphen. A Python node runs, but rosnode,
rqt and the logs may not find it. An empty name is taken, and the node is then called as its program likes, so that nothing can be
set for it by name.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="robot1/amcl"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl" ns="robot1"/>
</launch>
```

## Fix

`--unsafe-fixes` writes the name that the help proposes, or moves the namespace in it to `ns`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from launchlint.evaluate.problems import InvalidNodeName
from launchlint.finding import Finding, Fix, Severity
from launchlint.rules.edits import LOADS, add_attribute, fix, is_literal, set_value, spot
from launchlint.rules.judging.joined import led_by
from launchlint.rules.judging.left_over import left_over_in, meant_substitution
from launchlint.rules.judging.nodeless_test import makes_no_node
from launchlint.rules.rule import Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.syntax.parts import Substitution
from launchlint.syntax.ros1.substitutions import parts_of
from launchlint.syntax.tree import Element

_SOURCES = (".py", ".cpp", ".cc", ".c", ".sh")
_REQUIRED = "the arg {} has an empty default: whoever includes this file gives it"

RULE = Rule("LL302", "invalid-node-name", Severity.ERROR, roslaunch="refuses", fixable="unsafe")


def tell(problem: InvalidNodeName, view: LaunchView) -> Iterator[Finding]:
    """Speak about ``invalid-node-name`` (roslaunch.core.Node, roslaunch.xmlloader._node_tag, roscpp's this_node)."""
    if of_ros2(view):
        from launchlint.rules.judging import ros2_names as ros2_words

        yield from ros2_words.node_name(problem, RULE)
        return
    name, reason = problem.name, problem.reason
    if reason == "slash":
        namespace, _, base = name.strip("/").rpartition("/")
        literal = is_literal(problem.place, name)
        advice = f'write name="{base}" ns="{namespace}"' if namespace else f'write name="{base}"'
        told = "" if literal or not view.launch.given else _told(problem, view)
        yield RULE.at(
            problem.origin, f"the node name {name} has a slash in it", label="a node name has no namespace",
            severity=Severity.INFO if told else Severity.WARNING if view.launch.given and not literal else None,
            notes=("roslaunch stops with: node name cannot contain a namespace", *([told] if told else [])),
            help=advice if literal else f"give the arg a value without a slash, as {base}, and the namespace in ns",
            fix=_split(problem, view, name, base, namespace),
        )  # fmt: skip
    elif reason == "private":
        base = name.lstrip("~/")
        yield RULE.at(
            problem.origin, f"the node name {name} begins with ~", label="~ stands for a node's own namespace",
            notes=(f"roslaunch stops with: cannot turn [{name}] into a global name",),
            help=f'write name="{base}"' if base else "write a name",
        )  # fmt: skip
    elif reason == "empty":
        required = _left_empty(problem, view)
        yield RULE.at(
            problem.origin, "the node has an empty name", severity=Severity.INFO if required else Severity.WARNING, label="empty",
            notes=(
                "roslaunch starts it under the name its program chooses: no parameter, remap or log can be told to be its own",
                *([_REQUIRED.format(required)] if required else []),
            ),
            help="give it a name; where it does not matter which, write $(anon id)",
        )  # fmt: skip
    else:
        meant = meant_substitution(name)
        good = re.sub(r"\W", "_", name.strip(), flags=re.ASCII)
        good = good if good[:1].isalpha() else f"n{good}" if good.startswith("_") else f"n_{good}"
        own = not problem.from_test
        wanted = "is not a valid ROS name" if own else "(its test-name) is not a valid ROS name"
        required = _left_empty(problem, view)
        apart = "" if required else _told_apart(problem, view)
        idle = _test_without_a_node(problem, view)
        yield RULE.at(
            problem.origin,
            f"the node name {name!r} {wanted}",
            severity=Severity.INFO if required or apart or idle else Severity.WARNING,
            label=_fault(name),
            notes=(
                "a C++ node ends at start with an invalid-name exception, and tools such as rosnode may not find a Python one",
                *([_REQUIRED.format(required)] if required else []),
                *([f"a condition around it tells {apart} apart, which stands for no name"] if apart else []),
                *([f"{idle} makes no node, so that nobody may use the name"] if idle else []),
            ),
            help=f"write {meant}, which is replaced by what it stands for"
            if meant
            else f"use letters, digits and _, a letter first: {good}"
            if own
            else f'give the test a name as well: name="{good}"',
            fix=_rename(problem, view, name, good) if own and not meant else None,
            cause=_cause(name) if own and is_literal(problem.place, name) and not left_over_in(name, view) else "",
            shared_cause=left_over_in(name, view),
        )


def _cause(name: str) -> str:
    """What several have in common: that they are called as the source files are, or else the name."""
    return "called as its source is" if name.endswith(_SOURCES) else f"called {name}"


def together(findings: Sequence[Finding]) -> Finding:
    """What is nearly a substitution is told before the names that it spoils."""
    return led_by(findings, "LL215")


def idea(finding: Finding) -> tuple[object, ...] | None:
    """Names of one file have the same letter in them that none may have."""
    if not finding.label:
        return None
    return (finding.location.path, finding.label, finding.help.partition(":")[0].partition("=")[0], finding.fix is None)


def _told(problem: InvalidNodeName, view: LaunchView) -> str:
    """What it says where a comment of the file names the arg that the name is made of: whoever switches the node on is told to give it."""
    at = spot(view, problem.place)
    attribute = at.element.attributes.get("name") if at is not None else None
    args = {part.only for part in parts_of(attribute) if isinstance(part, Substitution)} if attribute is not None else set()
    for comment in at.document.comments if at is not None else ():
        named = next((arg for arg in sorted(args) if arg and re.search(rf"\b{re.escape(arg)}\b", comment.text)), None)
        if named is not None:
            line, _ = problem.place.source.position(comment.span.start)
            return f"the comment in line {line} speaks of the arg {named}, which whoever switches this on may be meant to give"
    return ""


def _left_empty(problem: InvalidNodeName, view: LaunchView) -> str:
    """The arg with an empty default that the name of a node of the entry file is made of; empty where there is none, or it is given."""
    at = spot(view, problem.place) if not problem.origin.chain else None
    if at is None or at.attribute is None:
        return ""
    asked = {part.only for part in parts_of(at.attribute).substitutions("arg")}
    return min(asked & view.once(_empty), default="") if asked else ""


def _told_apart(problem: InvalidNodeName, view: LaunchView) -> str:
    """The default of an arg in the name that a condition around the node compares it with: another value is meant where it holds."""
    at = spot(view, problem.place) if not problem.origin.chain else None
    if at is None or at.attribute is None:
        return ""
    asked = {part.only for part in parts_of(at.attribute).substitutions("arg")} - dict(view.launch.given).keys()
    defaults = {each.get("name"): each.get("default") or "" for each in at.document.elements if each.tag == "arg"}
    each: Element | None = at.element
    while each is not None:
        condition = f"{each.get('if') or ''} {each.get('unless') or ''}"
        for arg in sorted(asked):
            default = defaults.get(arg) or ""
            compared = f"'{default}'" in condition or f'"{default}"' in condition
            if default and compared and re.search(rf"\b{re.escape(arg)}\b", condition) is not None:
                return f"the default {default!r} of the arg {arg}"
        each = each.parent
    return ""


def _test_without_a_node(problem: InvalidNodeName, view: LaunchView) -> str:
    """The program of a ``<test>`` that makes no node: then rostest alone knows the name."""
    at = spot(view, problem.place)
    if at is None or at.element.tag != "test":
        return ""
    package, name = at.element.get("pkg") or "", at.element.get("type") or ""
    return name if makes_no_node(package, name, view) else ""


def _empty(view: LaunchView) -> frozenset[str]:
    """The args of the entry file that have an empty default and are not given."""
    given = dict(view.launch.given)
    args = (each for document in view.documents.values() if document.source.file == view.launch.entry.file for each in document.elements)
    return frozenset(each.get("name") or "" for each in args if each.tag == "arg" and each.get("default") == "") - given.keys()


def _split(problem: InvalidNodeName, view: LaunchView, name: str, base: str, namespace: str) -> Fix | None:
    """The namespace moves from the name to ``ns``, which the node has not got yet."""
    at = spot(view, problem.place)
    if at is None or not base or not namespace or not is_literal(problem.place, name) or "ns" in at.element.attributes:
        return None
    namespace = f"/{namespace}" if name.startswith("/") else namespace
    edits = (*set_value(at, base), *add_attribute(at, "ns", namespace))
    return fix(f'write name="{base}" ns="{namespace}"', edits, safe=False, changes=LOADS)


def _rename(problem: InvalidNodeName, view: LaunchView, name: str, good: str) -> Fix | None:
    if not is_literal(problem.place, name):
        return None
    return fix(f"write {good}", set_value(spot(view, problem.place), good), safe=False, changes=f"the node is {good}")


def _fault(name: str) -> str:
    if not re.match(r"[A-Za-z]", name):
        return "does not begin with a letter"
    wrong = re.search(r"\W", name, re.ASCII)
    return "invalid" if wrong is None else "has a blank in it" if wrong[0].isspace() else f"{wrong[0]} is not allowed"
