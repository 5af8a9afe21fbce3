"""The page of one launch file as it is in an editor: what ``launchlint report`` would write of these texts."""

from __future__ import annotations

import os

from launchlint import __version__
from launchlint.check.causes import told_with_theirs
from launchlint.check.merge import merge
from launchlint.check.survey import Surveyor
from launchlint.fingerprint import fingerprints
from launchlint.project.drawing import Wanted
from launchlint.project.material import entry_materials, known_programs, learnable, probe_command, reader, roots
from launchlint.report.html.cards import groups
from launchlint.report.html.data import in_order, report_data
from launchlint.report.html.material import Material
from launchlint.report.html.page import render
from launchlint.workspace.reading import standing_in


def page_of(wanted: Wanted) -> str:
    """The page, in HTML. It shares nothing with whatever else is being worked on, so that any thread may make it.

    Raises LaunchlintError where a library of the workspace cannot be used.
    """
    request, options = wanted.request, wanted.options
    with standing_in(wanted.texts):
        surveyor = Surveyor(options, wanted.texts)
        surveyed = surveyor.survey(request)
        outcome = merge([surveyed.result], options, surveyor.packages, wanted.per_file, workspace=False, alone=True)
        told = told_with_theirs(outcome.findings)
        outcome = outcome._replace(findings=tuple(each.finding for each in told))
        entries = entry_materials(told, [(surveyed, None)], surveyor.packages)
        programs, left_out = known_programs(entries, surveyor.library, options)
        material = Material(
            title=os.path.basename(request.at),
            version=__version__,
            roots=roots(options, None),
            source_url="",
            base="",
            findings=fingerprints(outcome.findings),
            entries=entries,
            source=reader(surveyor),
            base_source=reader(surveyor),
            programs=programs,
            learn=learnable(entries, surveyor.packages),
            left_out=left_out,
            sight=outcome.sight,
            probe=probe_command([surveyed.result.path]),
        )
        data = report_data(material)
        return render(data, groups(data, in_order(material))).html
