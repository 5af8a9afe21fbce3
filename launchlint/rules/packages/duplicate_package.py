"""Two packages of one workspace have the same name.

What it does: it compares the names of all packages in each workspace: those that catkin builds among each other, and those that
are built for ROS 2 only (ament). Directories with a `CATKIN_IGNORE` are passed over, those with a `COLCON_IGNORE` too, and so are
copies below different `src` directories, which are workspaces of their own.

## Why it matters

Which of them `$(find …)` and `pkg` mean hangs on the order in which the file system lists directories: it can be another one on
another machine. catkin refuses to build such a workspace, and so does colcon: "Duplicate package names not supported".

## Example

```xml
<launch>
  <node pkg="my_robot" type="drive.py" name="drive"/>
</launch>
```

```xml first/package.xml
<package format="2">
  <name>my_robot</name>
</package>
```

```xml second/package.xml
<package format="2">
  <name>my_robot</name>
</package>
```

## Use instead

```xml
<launch>
  <node pkg="my_robot" type="drive.py" name="drive"/>
</launch>
```

```xml first/package.xml
<package format="2">
  <name>my_robot</name>
</package>
```

```xml second/package.xml
<package format="2">
  <name>my_second_robot</name>
</package>
```
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.judging.copies import built_together, built_together_by_colcon
from launchlint.rules.judging.other_file import line_of, shown
from launchlint.rules.rule import Rule
from launchlint.rules.view import RunView
from launchlint.source import Place, Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.workspace.package import Package

RULE = Rule("LL703", "duplicate-package", Severity.WARNING)

_MOST_SHOWN = 6
_REFUSED = "colcon refuses to build such a workspace: Duplicate package names not supported"


def check(view: RunView) -> Iterator[Finding]:
    """Yield one finding for each name that several packages bear (rospkg.rospack.list_by_path keeps the one it meets first).

    ``colcon build`` stops before it builds anything.
    """
    for name, copies in view.packages.duplicates().items():
        for built in built_together(copies):
            if _is_asked(view, built):
                note = f"whether $(find {name}) means the one or the other hangs on the order of the file system"
                yield _finding(name, built, view.root, note, "CATKIN_IGNORE")
    for name, copies in view.packages.duplicates().items():
        if any(_is_asked(view, built) for built in built_together_by_colcon(copies)):  # only then it is worth to look as colcon does
            for built in built_together_by_colcon(view.packages.colcon.duplicates().get(name, ())):
                if _is_asked(view, built):
                    yield _finding(name, built, view.root, _REFUSED, "COLCON_IGNORE")


def _is_asked(view: RunView, built: list[Package]) -> bool:
    return len(built) > 1 and any(view.is_asked(copy.directory) for copy in built)


def _finding(name: str, built: list[Package], root: str, note: str, ignored_by: str) -> Finding:
    places = [_place(copy, root) for copy in built[:_MOST_SHOWN]]
    more = (f"there are {len(built)} of them",) if len(built) > 2 else ()
    return RULE.at(
        places[1],
        f"{len(built)} packages are named {name}",
        label="the second one",
        related=((places[0], "the first one"), *((place, "another one") for place in places[2:])),
        notes=(*more, note),
        help=f"rename one, remove it, or put a {ignored_by} file into {shown(built[1].directory, root)}",
        topic=name,
        cause=_copied(built),
    )


def _copied(built: list[Package]) -> str:
    """The directories that hold one each, where they do: with one of them all packages in it were copied."""
    around = {posixpath.dirname(copy.directory) for copy in built}
    return " ".join(sorted(around)) if len(around) == len(built) else ""


def _place(package: Package, root: str) -> Place:
    manifest = package.manifest
    if manifest is None or manifest.name_span is None:
        return line_of(package.manifest_path, root)
    return Place(Source(shown(package.manifest_path, root), manifest.source.text, package.manifest_path), manifest.name_span)
