"""What MoveIt's Setup Assistant writes into every package it makes: switches that nobody gives, what is set twice, and the panda.

The assistant keeps what it was told in a file ``.setup_assistant`` at the top of the package, which is lost where only what is seen is
copied: for an arg that nothing reads the launch files that it always writes will do. Its launch files offer choices (a fake
execution, a database) whether or not the files behind them were written, too; and some set a param twice, which it would write again.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from launchlint.check.given_together import BOOLEANS
from launchlint.check.known import Known
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.workspace.looking import is_file, names

NOTE = "MoveIt's Setup Assistant writes this switch into every package, and no launch file here gives {}"
AGAIN = "MoveIt's Setup Assistant writes this file so, and would again"
_NAMED = frozenset(("LL401", "LL411", "LL502"))
_ARGS = frozenset(
    """
    db debug execution_type fake_execution fake_execution_type info load_robot_description moveit_controller_manager
    moveit_manage_controllers pipeline rviz_tutorial start_state_max_bounds_error
    """.split()
)
"""Args that it declares in files for the taking, whatever is done with them there."""
_FILES = late(
    r"(?:demo|demo_gazebo|move_group|moveit_rviz|planning_context|default_warehouse_db)\.launch"
    r"|[\w-]*(?:controller_manager|planning_pipeline|trajectory_execution|sensor_manager|warehouse|warehouse_settings)\.launch\.xml"
)
_ALWAYS = frozenset(("move_group.launch", "planning_context.launch", "planning_pipeline.launch.xml", "trajectory_execution.launch.xml"))
"""What it writes into every package, in the directory of the launch files."""
_OF_PANDA = "ompl-chomp_planning_pipeline.launch.xml"
"""What it writes for any robot as it is for the panda, whose files it names."""
_DEMOS = frozenset(("demo.launch", "demo_gazebo.launch"))
"""The launch files of the assistant's that set params of nodes."""


def judged_by_assistant(findings: Iterable[Finding], known: Known) -> Iterator[Finding]:
    """``findings``, those as information that only a switch of the assistant's shows which nothing here gives, or that it made itself."""
    for finding in findings:
        if finding.severity is Severity.ERROR and finding.rule in _NAMED and finding.key not in known.by_default and finding.arguments:
            entry, uses = known.file(finding.entry), known.packages.arg_uses()
            switches = all(value.lower() in BOOLEANS and not uses.is_passed(entry, name) for name, value in finding.arguments)
            if switches and _is_made(finding, known):
                given = " ".join(f"{name}:={value}" for name, value in finding.arguments)
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, NOTE.format(given)))
        elif finding.severity is Severity.WARNING and _would_be_written_again(finding) and _is_made(finding, known):
            finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, AGAIN), cause=f"{finding.cause}; {AGAIN}")
        elif finding.rule == "LL206" and finding.severity is Severity.WARNING and _is_in_file_of_assistant(finding):
            from launchlint.rules.args.unused_arg import name_of

            name = name_of(finding)
            if name in _ARGS and (_is_made(finding, known) or _is_beside_its_files(finding, known)):
                note = f"MoveIt's Setup Assistant declares {name} in such a file"
                finding = finding._replace(severity=Severity.INFO, notes=(*finding.notes, note), cause=f"{finding.cause}; {note}")
        yield finding


def _is_in_file_of_assistant(finding: Finding) -> bool:
    return _FILES.fullmatch(finding.location.path.rpartition("/")[2]) is not None


def _would_be_written_again(finding: Finding) -> bool:
    name = finding.location.path.rpartition("/")[2]
    return (finding.rule == "LL504" and name in _DEMOS) or (finding.rule == "LL701" and name == _OF_PANDA)


def _is_made(finding: Finding, known: Known) -> bool:
    """Whether the assistant made the package that holds the file of ``finding``."""
    package = known.packages.package_of(known.file(finding.location.path))
    return package is not None and is_file(os.path.join(package.directory, ".setup_assistant"))


def _is_beside_its_files(finding: Finding, known: Known) -> bool:
    """Whether all launch files that the assistant always writes are in the directory of ``finding``."""
    return _ALWAYS.issubset(names(os.path.dirname(known.file(finding.location.path))))
