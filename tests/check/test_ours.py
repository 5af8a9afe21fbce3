"""Findings in installed files are told at the include that leads there, or not at all."""

from __future__ import annotations

from launchlint.check.options import Options
from launchlint.check.ours import Ours
from launchlint.finding import Finding, Location, Related, Severity

OPTIONS = Options(frozenset(), ("/ws/src",), True, {}, "/home/me/robot")


def at(path: str, line: int = 1) -> Location:
    return Location(path, line, 1, line, 5, 0, 4, "text")


def finding(path: str, severity: Severity, *chain: Location) -> Finding:
    return Finding("LL201", "undeclared-arg", severity, at(path, 7), "the arg x is not declared", label="no such arg", chain=chain)


def test_files_of_ones_own_are_left_as_they_are() -> None:
    mine = [finding(path, Severity.INFO) for path in ("launch/a.launch", "/ws/src/other/b.launch", "/elsewhere/c.launch")]
    assert list(Ours(OPTIONS, ("/elsewhere/c.launch",)).brought_home(mine)) == mine


def test_an_error_in_an_installed_file_is_told_at_the_include() -> None:
    outer, inner = at("launch/a.launch", 3), at("/usr/share/p/b.launch", 5)
    broken = finding("/usr/share/p/c.launch", Severity.ERROR, outer, inner)
    (told,) = Ours(OPTIONS).brought_home([broken])
    assert told == broken._replace(
        location=outer,
        label="in what this includes",
        chain=(),
        related=(Related(broken.location, "no such arg"),),
        topic="/usr/share/p/c.launch:0:",
    )


def test_what_does_not_stop_roslaunch_there_is_nobodys_business_here() -> None:
    outer = at("launch/a.launch", 3)
    installed = [finding("/usr/share/p/c.launch", Severity.WARNING, outer), finding("/usr/share/p/c.launch", Severity.ERROR)]
    assert list(Ours(OPTIONS).brought_home(installed)) == []
