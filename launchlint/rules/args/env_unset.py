"""A `$(env …)` reads an environment variable that is not set here.

Variables that every login or ROS installation sets are not told of, nor those that an env-hook of a package in the workspace sets
(`catkin_add_env_hooks`, `env-hooks/*.sh`), or one of a public package that the launch file, another that it reaches, or its own
`package.xml` needs. Others may be set on the robot and not where this check runs; `env:` in `.launchlint.yaml` gives them a value for the
check. The variables of a file are told of together. It is an info where the workspace itself sets or reads the variable elsewhere (a shell
file, a Dockerfile, a service, `os.environ` or `getenv`), where a document of it or a comment of the launch file names the variable (then
people are told to set it), where it is a secret by its name (`DB_PASSWORD`, `API_TOKEN`), or tells one robot from the others (`ROBOT_IP`,
`UAV_NAME`, `LIDAR_PORT`), where a public package sets it that nothing here names, where three or more launch files read it, or two and
none of all has a default for it, or one without a default does at two places, and where the launch files read three or more variables of
one first word (`SITE_MAP`, `SITE_DOCK` …), none with a default: it is the project's own. It is one, too, where the variable is the default
of an arg, or chooses one of several files of a directory (`$(find site)/maps/$(env SITE).yaml`): then it is an input of whoever starts the
file.

## Why it matters

Where the variable is not set roslaunch refuses the file. `$(optenv NAME default)` works everywhere.

## Example

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(env SITE_MAP)"/>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="map_server" type="map_server" name="map_server" args="$(optenv SITE_MAP /maps/office.yaml)"/>
</launch>
```
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from launchlint.evaluate.problems import EnvUnset
from launchlint.finding import Finding, Severity
from launchlint.rules.edits import spot
from launchlint.rules.judging.first_of_file import all_but_first
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.other_file import root_of, shown
from launchlint.rules.judging.secret_names import is_secret
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import LaunchView, of_ros2
from launchlint.spelling import one_slip
from launchlint.syntax.parts import Literal, Parts, Substitution
from launchlint.syntax.ros1.substitutions import parts_of
from launchlint.syntax.tree import Document
from launchlint.workspace.looking import names
from launchlint.workspace.public_variables import public_setters

RULE = Rule("LL209", "env-unset", Severity.WARNING, roslaunch="refuses")
MOST_NAMED = 6
USUAL = (
    *("HOME", "LANG", "LOGNAME", "PATH", "PWD", "SHELL", "USER"),
    *("ROS_DISTRO", "ROS_ETC_DIR", "ROS_MASTER_URI", "ROS_PACKAGE_PATH", "ROS_PYTHON_VERSION", "ROS_ROOT", "ROS_VERSION"),
    *("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "PKG_CONFIG_PATH", "PYTHONPATH"),
)
"""Set by every login shell, or by the set-up file of every ROS installation."""
OPTIONAL = ("ROS_HOME", "ROS_HOSTNAME", "ROS_IP", "ROS_LOG_DIR", "ROS_NAMESPACE")


_WHICH = re.compile(r"[A-Z]\w*_(?:IP|HOST|HOSTNAME|ADDRESS|ADDR|PORT|URI|URL|MAC|SERIAL|DEVICE|NAME|NAMESPACE|NS|ID|NUMBER)")
"""What no file can say that is the same on all robots: how to reach a device, and which of several this one is."""
_SET_BY = "the public package"
_SEVERAL = 2
OF_A_SITE = "the launch files read"
OF_ONE_ROBOT = "by its name it tells one robot from the others, so that it is set on each"
SECRET = "it holds a secret, by its name: it belongs into no file, and without it nothing is to start"


def check(view: LaunchView) -> Iterator[Fine]:
    """Tell of each variable once in a file."""
    return all_but_first(RULE, ((each, each.variable) for each in view.launch.noticed(EnvUnset)))


def tell(problem: EnvUnset, view: LaunchView) -> Iterator[Finding]:
    """Suggest a default."""
    name = problem.variable
    if _is_set(name, view):
        return
    slip = slip_of(name)
    reason = "" if slip is not None else _reason(name, problem, view)
    if of_ros2(view):
        from launchlint.rules.judging import ros2_args as ros2_words

        yield from ros2_words.environment(problem, RULE, view, reason, slip)
        return
    given = f"write $(optenv {name} DEFAULT), or give it a value under env: in .launchlint.yaml if it is always set"
    if reason == SECRET:
        given = "set it before roslaunch is called; give it any value under env: in .launchlint.yaml for the check"
    yield RULE.at(
        problem.origin,
        f"the environment variable {name} is not set here",
        severity=Severity.INFO if reason else None,
        notes=(f"where it is not set roslaunch stops with: environment variable '{name}' is not set", *([reason] if reason else [])),
        help=given if slip is None else f"did you mean {slip}?",
        topic=name,
        cause=reason if reason.startswith(_SET_BY) else name if reason or slip is not None else " ".join(_like(problem, view)),
    )


def together(findings: Sequence[Finding]) -> Finding:
    """The variables of one file, and of files that read the same ones."""
    whole = joined(findings)
    told = list(dict.fromkeys(finding.topic for finding in sorted(findings, key=lambda finding: finding.location)))
    if len(told) < 2:
        return whole
    more = f" and {len(told) - MOST_NAMED} more" if len(told) > MOST_NAMED else ""
    if whole.launcher != "roslaunch":
        return whole
    return whole._replace(
        message=f"{len(told)} environment variables are not set here: {', '.join(told[:MOST_NAMED])}{more}",
        notes=("where one of them is not set roslaunch stops", *(note for note in whole.notes if note.startswith((_SET_BY, OF_A_SITE)))),
        help="write $(optenv NAME DEFAULT), or give them values under env: in .launchlint.yaml if they are always set",
    )


def _is_set(name: str, view: LaunchView) -> bool:
    """Whether it is set wherever the launch can run: always, or by the hook of a package that it needs."""
    return name in USUAL or name in view.packages.hook_variables() or any(_needs(package, view) for package in public_setters(name))


def _needs(package: str, view: LaunchView) -> bool:
    """Whether a launch file that was reached names the package in ``pkg`` or ``$(find …)``, or the package of the entry declares it."""
    home = view.packages.package_of(view.launch.entry.file)
    return (home is not None and package in home.run_dependencies) or any(
        package in document.source.text and _names(package, document) for document in view.documents.values()
    )


def _names(package: str, document: Document) -> bool:
    return any(
        attribute.value == package if attribute.name == "pkg" else package in parts_of(attribute).names("find")
        for element in document.elements
        for attribute in element.attributes.values()
    )


@lru_cache(maxsize=512)
def slip_of(name: str) -> str | None:
    """The well-known variable that ``name`` is a slip of the pen for; ``None`` where there is none."""
    return one_slip(name, (*USUAL, *OPTIONAL))


def _reason(name: str, problem: EnvUnset, view: LaunchView) -> str:
    """Why it is no wonder that the variable is not set here; empty where nothing says so."""
    if is_secret(name, variable=True):
        return SECRET
    setters = public_setters(name)
    told = f"{_SET_BY} {setters[0]} sets it wherever that is installed" if setters else _elsewhere(name, problem, view)
    return told or (OF_ONE_ROBOT if _WHICH.fullmatch(name) else "" if of_ros2(view) else _as_input(problem, view))


def _as_input(problem: EnvUnset, view: LaunchView) -> str:
    """What shows that whoever starts the file is to choose: it is the default of an arg, or says which of several files to take."""
    at = spot(view, problem.place)
    if at is None or at.attribute is None:
        return ""
    if at.element.tag == "arg" and at.attribute.name == "default":
        return "it is the default of an arg: an input of whoever starts this"
    package, directory = _directory_before(parts_of(at.attribute))
    found = view.packages.get(package, view.launch.entry.file) if directory else None
    if found is None or len(names(posixpath.join(found.directory, directory))) < _SEVERAL:
        return ""
    return f"it chooses one of what is in {directory} of {package}: an input of whoever starts this"


def _directory_before(parts: Parts) -> tuple[str, str]:
    """The package and, below it, the directory of ``$(find package)/directory/name$(env …``; the latter is empty for any other value."""
    variable = next(parts.substitutions("env"), None)
    before = [] if variable is None else [part for part in parts.parts if part.end <= variable.start]
    path, package = (before.pop(), before.pop()) if len(before) > 1 else (None, None)
    if not isinstance(path, Literal) or not path.text.startswith("/") or not isinstance(package, Substitution) or package.command != "find":
        return "", ""
    return package.only, posixpath.dirname(path.text[1:])


def _elsewhere(name: str, problem: EnvUnset, view: LaunchView) -> str:
    """Where the project itself sets or reads the variable, for people; empty where it does not. Launch files are not looked at here."""
    own = view.packages.variable_in(name)
    if own is not None and own == problem.place.source.file:
        return "this program asks for it, and has no default: it is an input of whoever starts this"
    if own is not None:
        return f"{shown(own, root_of(problem.place.source))} sets or reads it, too"
    if _in_comment(name, problem, view):
        return "a comment of this file names it: it is an input of whoever starts this"
    told = view.packages.documented_in(name)
    return "" if told is None else f"{shown(told, root_of(problem.place.source))} names it: it is an input of whoever starts this"


def _in_comment(name: str, problem: EnvUnset, view: LaunchView) -> bool:
    """Whether a comment of the file speaks of the variable as such; what is commented out reads it, and tells nothing."""
    written = (each.comments for each in view.documents.values() if each.source.path == problem.place.source.path)
    naming = [comment.text for comments in written for comment in comments if name in comment.text]
    if not naming:
        return False
    word = re.compile(rf"(?<![\w.-])(?<!env ){re.escape(name)}(?![\w-])")
    return any(word.search(text) is not None for text in naming)


def _like(problem: EnvUnset, view: LaunchView) -> list[str]:
    """The variables of the same file that nothing says are set."""
    path = problem.place.source.path
    read = {each.variable for each in view.launch.noticed(EnvUnset) if each.place.source.path == path}
    return sorted(name for name in read if not _is_set(name, view) and slip_of(name) is None and not _reason(name, problem, view))
