"""A launch file uses a package that its own package's `package.xml` does not declare.

What it does: for every launch file it collects the packages of its nodes and tests, and those in `$(find …)`, as far as their names are
written out, and compares them with the run dependencies (`<exec_depend>`, `<depend>`, `<run_depend>`) in the `package.xml` above it. Test
dependencies count for tests. What a declared package or metapackage itself declares counts too, as far as it can be seen here or is known
of much used ones (a plugin of RViz brings RViz along), and so does what roslaunch itself needs. Names that nobody knows are LL210 and
LL303, and a file with placeholders such as `$(find [PACKAGE])` is a template that is never launched. A dependency that stands in a comment
of the `package.xml` was left out on purpose. Where only files are asked of another package of the same kind (`arm_moveit_config`), and the
own package has all of them at the same paths, its own name was meant; where a package of the workspace is one slip away (`controls`,
`control`) and has what is asked for, that one was. Everything that one `package.xml` lacks is told at once, with the
first use of each package; where two lack the same three, as those do that were made one after the other, what both lack; where three
packages or more lack something, all that they lack.

It is an info where all that is missing lies in the same workspace, and the package is none that was released: whoever has the one has the
other; where it is part of every `ros_base`, the smallest installation, and the package is none that was released; where only launch files
need it by which people try something out (`demo.launch`, `test_arm.launch`, beside more that are called otherwise; not tests that machines
run), or it is turtlesim, with which ROS is learned; and where only files need it that MoveIt's Setup Assistant writes beside those that
drive the robot (benchmarks, the warehouse, a simulation and the controllers that nothing else of the package starts, the assistant
itself), in a package with its `.setup_assistant`. It is one, without a fix, where a comment of the launch file or a README tells people to
install the package themselves, where one of the `package.xml` names it and says that it is left out, not listed or optional, where only
launch files need it that were put aside (in a directory `old`, `deprecated`, `attic` …), where the launch file lies among the tests and
nothing starts it (no `add_rostest`, no `roslaunch_add_file_check`, no other launch file, no script that calls roslaunch), and where the
package is a copy of a public one, with its `CHANGELOG.rst` or the `<url>` of its repository, or part of a project with a README and a
licence of its own, among packages of other people. Packages below a `CATKIN_IGNORE` are passed over, and launch files that an `EXCLUDE` of
`install(DIRECTORY …)` leaves out. Of several packages of one name, of which LL703 tells, the first is told of. Beside a `manifest.xml` of
rosbuild it is the `package.xml` that counts; where there is no other, it is an info: rosbuild installs nothing.

In packages for ROS 2 these are the packages of nodes and components and those in `$(find-pkg-share …)`; in Python those of `Node` and
`FindPackageShare`. Launch files that are called tests, or lie in a directory or a package that is, may have theirs among the test
dependencies.

## Why it matters

On the developer's machine the package happens to be there. Where only the declared dependencies are installed (rosdep, the build
farm, a fresh robot) the launch fails, unless something else brings the package along.

## Example

```xml robot.launch
<launch>
  <node pkg="robot_state_publisher" type="robot_state_publisher" name="robot_state_publisher"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
</package>
```

## Use instead

```xml robot.launch
<launch>
  <node pkg="robot_state_publisher" type="robot_state_publisher" name="robot_state_publisher"/>
</launch>
```

```xml package.xml
<package format="2">
  <name>my_robot</name>
  <version>1.0.0</version>
  <description>Drives a robot.</description>
  <maintainer email="robot@example.com">Robot</maintainer>
  <license>Apache-2.0</license>
  <exec_depend>robot_state_publisher</exec_depend>
</package>
```

## Fix

`--fix` adds the line to `package.xml`, below the last dependency, and proves that nothing else changes in it. What is declared for tests
only is left alone, and so is what needs this package itself to be built: the dependency would close a ring, and catkin would build nothing
any more. Where two packages would only need each other to run, catkin has no objection; no fix makes such a ring either, since the file may
belong into the other package. A fix is not called safe where it names a package of the workspace whose launch files lead back here, over
packages that they use and do not declare: that one's fix could close the ring from the other side. Nor is it where one of the distributions
that the workspace, or a condition in the `package.xml`, names has never had the package (where none is named: none since Kinetic): rosdep
would not find it. In ROS 2 the dependency is then written with a `condition` for those that have had it. What the fix leaves out is said,
with the reason.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping, Sequence

from launchlint.finding import Edit, Finding, Fix, Severity
from launchlint.late import late
from launchlint.plural import listed
from launchlint.rules.judging.copies import first_of_name
from launchlint.rules.judging.metapackages import members, why_together
from launchlint.rules.judging.missing_package import is_placeholder
from launchlint.rules.judging.other_file import is_inside, root_of, shown
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.judging.projects import is_published
from launchlint.rules.judging.released import Lacking, lacking
from launchlint.rules.judging.stale_package import own_by_a_slip, own_files_instead, own_instead
from launchlint.rules.judging.template import is_among_templates
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, of_ros2
from launchlint.source import Place, Source, Span
from launchlint.syntax.parts import Parts
from launchlint.syntax.ros1.substitutions import parts_of
from launchlint.syntax.tree import Document, Element
from launchlint.workspace.looking import is_file, question
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.registered_tests import registering

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.build_order import Way
    from launchlint.workspace.manifest import Manifest
    from launchlint.workspace.package import Package
    from launchlint.workspace.packages import Packages

ELSEWHERE = "it works only where something else brings {} along"
LEFT_OUT = "it may do without: "
MOST_NAMED = 12
_EXERCISE = "turtlesim"
"""What ROS is learned with; no robot needs it."""
BUILT_ONLY = "for building only"
TRIED = "only launch files that seem to be there to try something out need {}"
SETTING_UP = "only files need it that MoveIt's Setup Assistant writes beside those that drive the robot"
_LATER = "once {} {} what {} own launch files use, to declare {} here would close a ring"
_MOVE = "move {} to a package that starts both, such as a bringup package"
# What MoveIt's Setup Assistant writes into every package and what nobody needs to drive the robot; it declares none of this itself.
_GENERATED_EXTRA = late(
    r"(?:setup_assistant|joystick_control|run_benchmark_\w+|(?:default_)?warehouse(?:_db|_settings)?|(?:demo_)?gazebo)\.launch(?:\.xml)?"
)
_CONTROLLERS = "ros_controllers.launch"

RULE = Rule("LL701", "missing-exec-depend", Severity.WARNING, roslaunch="reports", fixable="safe")

_TESTS = "runs a test"
_OF_TESTS = late(r"(?:^|[/_.-])tests?(?:[/_.-]|$)")
_FIND = late(r"\bfind\(\s*['\"]([^'\"]*)['\"]\s*\)")
"""As an expression asks for a package."""
_NOT_IN_COLCON = ("AMENT_IGNORE", "COLCON_IGNORE")


def check(view: FileView) -> Iterator[Finding]:
    """Yield one finding for each undeclared package of one launch file (roslaunch.depends, roslaunch.rlutil.check_roslaunch)."""
    ros2 = of_ros2(view)
    document, packages = view.document, view.packages.colcon if ros2 else view.packages
    file = document.source.file
    home = _home(packages, file)
    if home is None or home.broken or home.is_metapackage or not home.name or not is_inside(home.manifest_path, packages.workspaces):
        return
    manifest = home.manifest
    if manifest is None or manifest.is_ament != ros2:
        return
    uses = _uses_of_ros2(view) if ros2 else _uses(document)
    wanted = sorted(name for name in uses if name != home.name)
    if not wanted:
        return
    declared = set(home.run_dependencies)
    is_test = _is_test_of_ros2(document, home) if ros2 else _is_test(document, home)
    for_tests = {name for name in wanted if is_test or uses[name][1].startswith(_TESTS)}
    declared |= home.test_dependencies if is_test else set()
    fine = declared | (home.test_dependencies & for_tests)
    missing = [name for name in wanted if name not in fine and not _is_commented_out(name, manifest)]
    if not missing:
        return
    declared = _with_what_they_declare(declared | ({"ros2launch", "launch", "launch_ros"} if ros2 else {"roslaunch"}), packages, file)
    missing = [name for name in missing if name not in declared and (packages.has(name) or name in public_names())]
    if not missing or packages.is_hidden(home.directory) or first_of_name(home, packages).directory != home.directory:
        return
    if _is_not_built(home, packages) or is_among_templates(shown(home.directory, root_of(document.source))):
        return
    if contents(packages).installs(home).leaves_out(posixpath.abspath(file)):
        return
    from launchlint.rules.judging.idle_test import why_idle
    from launchlint.rules.judging.left_out import SETUP_ASSISTANT, is_trial, why_left_out

    missing = [name for name in missing if own_instead(name, document.source.text, packages, file) is None]  # LL210 and LL303 tell
    place = _place(manifest, root_of(document.source))
    extra = is_file(posixpath.join(home.directory, SETUP_ASSISTANT)) and _is_extra(file, home, packages)
    here = any(_is_beside(name, packages, file) for name in missing)
    ways, later = packages.answer(_ways, home.name) if here else ({}, {})
    idle = why_idle(file, home, packages)
    for name in missing:
        where, how = uses[name]
        instead = _instead(name, where, document, home, packages)
        if instead is not None:
            yield instead
            continue
        manifest_path = shown(home.manifest_path, root_of(document.source))
        tested = name in home.test_dependencies
        tags = ("test_depend",) if tested else ("build_depend", "buildtool_depend")
        written = [each for each in manifest.dependencies if each.name == name and each.tag in tags]
        at = written[0].span if written else None
        only = "for tests only" if tested else BUILT_ONLY if written else ""
        says = f"declares {name} {only}" if only else f"does not declare {name}"
        without = lacking(name, manifest, packages)
        line = _line(name, manifest.format, is_test=name in for_tests, condition=without.condition)
        way = None if tested else ways.get(name)
        closes = way is not None and (way.built or is_test or ros2)
        beside = not tested and not is_published(home) and _is_beside(name, packages, file)
        reason = "" if tested else SETTING_UP if extra else why_left_out(name, document, home, packages) or idle
        reason = reason or (why_together(home.name, name, packages) if way else "")
        tried = not (tested or reason) and (name == _EXERCISE or is_trial(file, home))
        yield RULE.at(
            place if at is None else place._replace(span=at),
            f"{manifest_path} {says}, {'and' if only else 'which'} {document.source.path} {how} {'it' if only else ''}".rstrip(),
            severity=Severity.INFO if beside or reason or tried or manifest.format == 0 else RULE.severity,
            label=only or f"no {name} here",
            related=((where, "used here"),),
            notes=(
                f"{name} lies in this workspace; whoever has only this package lacks it" if beside else ELSEWHERE.format(name),
                *([f"{LEFT_OUT}{reason}"] if reason else []),
                *([TRIED.format(name)] if tried else []),
                *([] if way is None else [_ring(way, "colcon" if ros2 else "catkin", closes=closes)]),
                *([] if tested or reason or way is not None else _doubts(name, later, without)),
            ),
            help=_MOVE.format(document.source.path) if way is not None else f"{'change it to' if tested else 'add'} {line}",
            topic=name,
            cause="" if tested else manifest_path,
            fix=None
            if tested or (reason and not extra) or way is not None
            else _fix(place, manifest, line, safe=not _doubts(name, later, without)),
        )


def _is_extra(file: str, home: Package, packages: Packages) -> bool:
    """Whether it is a file of the assistant that does not drive the robot; the controllers do, unless only the simulation starts them."""
    name = posixpath.basename(file)
    if name != _CONTROLLERS:
        return _GENERATED_EXTRA.fullmatch(name) is not None
    from launchlint.rules.judging.idle_test import naming

    return all(_GENERATED_EXTRA.fullmatch(posixpath.basename(each)) for each in naming(name, home, packages))


def _is_not_built(home: Package, packages: Packages) -> bool:
    """Whether nobody builds the package: a workspace of ROS 2 keeps it and ignores it, or it lies below another package."""
    directory = home.directory
    while is_inside(directory, packages.workspaces):
        if any(is_file(posixpath.join(directory, name)) for name in _NOT_IN_COLCON):
            return True
        directory = posixpath.dirname(directory)
        if is_inside(f"{directory}/package.xml", packages.workspaces) and is_file(f"{directory}/package.xml"):
            return True
    return False


def _instead(name: str, where: Place, document: Document, home: Package, packages: Packages) -> Finding | None:
    """What to say where a package that is here has what is asked of another one: it is the name that is wrong, and nothing is missing."""
    text, file = document.source.text, document.source.file
    files = own_files_instead(name, text, home, file)
    if files:
        have = "has it, too, at the same path" if len(files) == 1 else "has all of them, too, at the same paths"
        message = f"{home.name} asks {name} for {listed(files, MOST_NAMED)}, and {have}"
        meant, why = f"$(find {home.name})", f"{name} is not declared in package.xml, so that it is probably left over from a template"
    else:
        slip = None if home.manifest is None or home.manifest.is_ament else own_by_a_slip(name, text, packages, file)
        if slip is None:
            return None
        message = f"{document.source.path} asks the public package {name}, and {slip.name} lies in this workspace"
        meant, why = slip.name, f"no package.xml here declares {name}, and the two names are one slip apart"
    return RULE.at(where, message, label=f"is {meant} meant?", notes=(why,), help=f"write {meant}", topic=name)


def _doubts(name: str, later: Mapping[str, Way], without: Lacking) -> list[str]:
    """Why a fix that declares the package is not safe; nothing where it is."""
    doubts = [_LATER.format(name, "declares", "its", "it")] if name in later else []
    return [*doubts, without.why(name)] if without.distributions else doubts


def _home(packages: Packages, file: str) -> Package | None:
    """The package of ``file``; where a ``package.xml`` lies beside a ``manifest.xml`` of rosbuild, it is the former that counts."""
    home = packages.package_of(file)
    modern = None if home is None else packages.get(home.name, file)
    return home if home is None or modern is None or modern.directory != home.directory else modern


@question
def _ways(packages: Packages, name: str) -> tuple[dict[str, Way], dict[str, Way]]:
    """Who needs package ``name``: now, and perhaps once other packages declare what their launch files use, too."""
    from launchlint.workspace.build_order import ways_to

    return ways_to(name, packages), ways_to(name, packages, lacking=True)


def together(findings: Sequence[Finding]) -> Finding:
    """One finding for all that one ``package.xml`` lacks, with the first use of each package, and one fix."""
    findings = list({finding.topic: finding for finding in reversed(findings)}.values())[::-1]
    needed = [finding for finding in findings if not any(note.startswith(LEFT_OUT) for note in finding.notes)]
    findings = needed or findings  # what may be left out is not told beside what may not
    first = findings[0]
    if len(findings) == 1:
        return first
    names = [finding.topic for finding in findings]
    passing = {TRIED.format(name) for name in names if first.severity > Severity.INFO}
    later = [finding.topic for finding in findings if _LATER.format(finding.topic, "declares", "its", "it") in finding.notes]
    if len(later) > 1:  # one line for all of them
        passing |= {_LATER.format(name, "declares", "its", "it") for name in later}
    fixes = [finding.fix for finding in findings if finding.fix is not None]
    fixes = [fix for fix in fixes if fix.safe] or fixes  # what is not safe is told again when it is alone
    help = next((finding.help for finding in findings if finding.fix in fixes), first.help)
    edits = [edit for fix in fixes for edit in fix.edits]
    fix = None
    if len({edit[:3] for edit in edits}) == 1:  # all at one place: they are one insertion
        whole = edits[0]._replace(text="".join(edit.text for edit in edits))
        added = [finding.topic for finding in findings if finding.fix in fixes]
        message = f"add {len(fixes)} dependencies" if len(fixes) == len(findings) else f"add {listed(added, MOST_NAMED)}, not the others"
        fix = Fix(message, fixes[0].safe, (whole,))
    lacks = f"{'for running ' if any(each.label == BUILT_ONLY for each in findings) else ''}{len(names)} packages"
    return first._replace(
        message=f"{first.location.path} does not declare {lacks} that its launch files use: {listed(names, MOST_NAMED)}",
        label="not declared here",
        related=tuple(related._replace(label=f"{finding.topic} is used here") for finding in findings for related in finding.related),
        notes=(
            ELSEWHERE.format("them")
            if any(finding.notes[:1] == (ELSEWHERE.format(finding.topic),) for finding in findings)
            else "they lie in this workspace; whoever has only this package lacks them",
            *list(dict.fromkeys(note for finding in findings for note in finding.notes[1:] if note not in passing))[:MOST_NAMED],
            *([_LATER.format(listed(later, MOST_NAMED), "declare", "their", "them")] if len(later) > 1 else []),
        ),
        help=f"{help}, and so on" if help.startswith("add ") else help,
        fix=fix,
        topic="",
        about=(lacks, listed(names, MOST_NAMED), *names),
    )


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for packages that lack the same, and for those that are kept twice."""
    from launchlint.rules.judging.kept_twice import told_of_copies

    return told_of_copies(findings)


def idea(finding: Finding) -> tuple[object, ...] | None:
    """Several packages lack one package, and nothing else, that a file of one name uses in each: one was made from the other."""
    if not finding.related or finding.severity is Severity.INFO or finding.label != f"no {finding.topic} here":
        return None
    return (finding.topic, posixpath.basename(finding.related[0].location.path), finding.fix is None)


def _is_beside(name: str, packages: Packages, near: str) -> bool:
    """Whether the package lies in one of the workspaces, and not only in an installation."""
    package = packages.get(name, near)
    return package is not None and is_inside(package.directory, packages.workspaces)


def _ring(way: Way, builder: str, *, closes: bool) -> str:
    """What a dependency would come to on a package that needs this one already."""
    over = "" if len(way.names) == 2 else f" ({' → '.join(way.names)})"
    already = f"{way.names[0]} needs {way.names[-1]} to {'be built' if way.built else 'run'}{over}"
    if closes:
        return f"{already}: to declare it here would close a ring, and {builder} would build nothing any more"
    return f"{already}: to declare it here makes a ring; catkin allows it, since they need each other only to run"


def _fix(place: Place, manifest: Manifest, line: str, *, safe: bool) -> Fix | None:
    """The line goes below the last dependency, or else below the name, indented as that is."""
    source, span = place
    if manifest.last_dependency is None and manifest.name_span is None:
        return None
    number = source.position(span.start).line
    start = source.line(number)
    indent = start[: len(start) - len(start.lstrip())]
    alone = source.with_lines(span) != span
    newline = "\r\n" if "\r\n" in source.text else "\n"
    return Fix(f"add {line}", safe, (Edit(source.path, span.end, span.end, f"{newline}{indent}{line}" if alone else line),))


def _line(name: str, format_: int, *, is_test: bool, condition: str) -> str:
    """The element that declares ``name``: for a test, where there is one for tests (from ``package.xml`` format 1 on), that one."""
    if format_ == 0:
        return f'<depend package="{name}"/>'
    tag = "test_depend" if is_test else "run_depend" if format_ == 1 else "exec_depend"
    return f'<{tag} condition="{condition}">{name}</{tag}>' if condition else f"<{tag}>{name}</{tag}>"


def _is_commented_out(name: str, manifest: Manifest) -> bool:
    """Whether the dependency stands in a comment of the manifest: somebody took it out and meant to."""
    element = re.compile(rf"depend(?:\s[^<>]{{0,200}})?>\s*{re.escape(name)}\s*<|<depend\s+package\s*=\s*[\"']{re.escape(name)}[\"']")
    return any(element.search(comment) is not None for comment in manifest.comments)


def _uses(document: Document) -> dict[str, tuple[Place, str]]:
    """Package → the first place that uses it, and how; nothing for a template. What only tests use stands behind the rest."""
    found: dict[str, tuple[Place, str]] = {}
    for element in sorted(document.elements, key=lambda each: each.tag == "test"):
        if _is_template(element):
            return {}
        if _is_off(element):
            continue
        if element.tag in ("node", "test"):
            package = element.attributes.get("pkg")
            if package is not None and not is_placeholder(package.value):
                found.setdefault(package.value, (document.place(package.shown_span), _started(element)))
        for attribute in element.attributes.values():
            if "find" in attribute.value:
                for name, start, end in _found(parts_of(attribute)):
                    how = {"include": "includes a file of", "test": f"{_TESTS} with files of"}.get(element.tag, "uses files of")
                    found.setdefault(name, (document.place(attribute.span_of(start, end)), how))
    return found


def _uses_of_ros2(view: FileView) -> dict[str, tuple[Place, str]]:
    """The same of a launch file of ROS 2."""
    from launchlint.rules.judging.ros2_written import packages_used

    found: dict[str, tuple[Place, str]] = {}
    if any(problem.refused for problem in view.document.problems):
        return found  # not yet a launch file of ROS 2, or not any more
    for name, place, how in packages_used(view):
        if is_placeholder(name):
            return {}
        found.setdefault(name, (place, how))
    return found


def _found(parts: Parts) -> Iterator[tuple[str, int, int]]:
    """The packages that a value asks for, and where it does."""
    if parts.expression is None:
        asked = [(part.only, part.start, part.end) for part in parts.substitutions("find")]
    else:
        at = parts.expression.code_start
        asked = [(match[1], at + match.start(), at + match.end()) for match in _FIND.finditer(parts.expression.code)]
    return (each for each in asked if not is_placeholder(each[0]))


def _is_template(element: Element) -> bool:
    """Whether the element names a package by a placeholder, to be filled in before anybody launches the file."""
    return any(
        is_placeholder(name)
        for attribute in element.attributes.values()
        if "find" in attribute.value
        for name in parts_of(attribute).names("find")
    )


def _is_off(element: Element) -> bool:
    """Whether a condition written out as false stands on the element or around it."""
    each: Element | None = element
    while each is not None:
        if (each.get("if") or "").strip().lower() in ("false", "0") or (each.get("unless") or "").strip().lower() in ("true", "1"):
            return True
        each = each.parent
    return False


def _started(element: Element) -> str:
    return f"{_TESTS} of" if element.tag == "test" else "starts a node of"


def _is_test(document: Document, home: Package) -> bool:
    """Whether only tests load the file. A directory above the package says nothing of it: packages for tests may stand together."""
    inside = posixpath.relpath(document.source.file, home.directory)
    if inside.endswith((".test", ".test.xml")) or re.search(r"/tests?/", f"/{inside}") is not None:
        return True
    tests, nodes = (sum(each.tag == tag for each in document.elements) for tag in ("test", "node"))
    given = (each.names_it and "rostest" in each.command for each in registering(home.directory, inside))
    # With fewer tests than nodes it may start a robot all the same: roslaunch passes a <test> over.
    return tests > 0 and (tests >= nodes or _OF_TESTS.search(inside) is not None or any(given))


def _is_test_of_ros2(document: Document, home: Package) -> bool:
    """Whether only tests load the file: by its name, that of a directory or of its package, or since it runs tests itself."""
    path = f"{home.name}/{posixpath.relpath(document.source.file, home.directory)}"
    return _OF_TESTS.search(path) is not None or "launch_testing" in document.source.text


def _with_what_they_declare(names: set[str], packages: Packages, near: str) -> set[str]:
    """``names``, and all that they need to run, as far as they can be seen here; of well-known metapackages the members."""
    reached: set[str] = set()
    waiting = sorted(names)
    while waiting:
        name = waiting.pop()
        if name in reached:
            continue
        reached.add(name)
        waiting += members(name)
        package = packages.get(name, near) or packages.with_manifest(packages.answer(_metapackage, name))
        if package is not None:
            waiting += sorted(package.run_dependencies)
    return reached


@question
def _metapackage(packages: Packages, name: str) -> str:
    """The manifest of the last metapackage of the workspaces that is called so; empty where there is none."""
    here = [each for place in packages.places[: len(packages.workspaces)] for each in place.everything]
    return next((each.manifest_path for each in reversed(here) if each.is_metapackage and each.name == name), "")


def _place(manifest: Manifest, root: str) -> Place:
    """The last dependency of the manifest, after which the missing one can be written; else its name, else its start."""
    source = Source(shown(manifest.source.file, root), manifest.source.text, manifest.source.file)
    last = manifest.last_dependency
    span = last.span if last is not None else manifest.name_span
    return Place(source, span or Span(0, 0))
