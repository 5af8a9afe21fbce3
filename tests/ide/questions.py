"""A view of a file of a workspace that is looked at here and now, and all that can be asked of it."""

from __future__ import annotations

from pathlib import Path

from launchlint.ide import calls, completion, drawing, hints, hover, navigation, outline, repair
from launchlint.ide.view import Snapshot, View
from launchlint.project.workspace import OpenWorkspace
from launchlint.source import Span


def snapshot_of(workspace: OpenWorkspace) -> Snapshot:
    """What is known once everything has been checked."""
    workspace.settle()
    return Snapshot(
        workspace.checker.session, workspace.checker.library, workspace.options.style, workspace.understood(), workspace.including(),
        dict(workspace.broken),
    )  # fmt: skip


def view_of(workspace: OpenWorkspace, file: Path, text: str) -> View:
    """A file that holds ``text``."""
    workspace.hold({str(file): text.encode()})
    return View(snapshot_of(workspace), str(file), text)


def ask_what_is_shown(view: View, offset: int) -> None:
    """Ask what editors ask at every keystroke, without being told to."""
    end = len(view.text)
    spans = [each.span for each in completion.completion(view, offset)]
    spans += [Span(each.offset, each.offset) for each in hints.hints(view, 0, end)]
    spans += [each.span for each in hints.lenses(view)]
    spans += _of_symbols(outline.symbols(view))
    spans += [each.target.span for each in navigation.highlights(view, offset)]
    drawing.shown_at(view, offset)
    assert all(0 <= start <= last <= end for start, last in spans), [each for each in spans if not 0 <= each.start <= each.end <= end]


def ask_everything(view: View, offset: int) -> None:
    """Ask all that can be asked at ``offset``: nothing may fail, and every stretch must lie in the text."""
    end = len(view.text)
    spans: list[Span] = []
    said = hover.hover(view, offset)
    spans += [] if said is None else [said.span]
    spans += [each.span for each in completion.completion(view, offset)]
    targets = [
        *navigation.definition(view, offset),
        *navigation.references(view, offset),
        *(each.target for each in navigation.highlights(view, offset)),
    ]
    spans += [each.span for each in targets if each.file == view.file]
    renamable = navigation.renamable(view, offset)
    spans += [] if renamable is None else [renamable]
    spans += [each.span for each in navigation.links(view)]
    spans += [span for span, _ in outline.folding(view)]
    spans += outline.selections(view, offset)
    spans += list(outline.tag_names(view, offset) or ())
    spans += _of_symbols(outline.symbols(view))
    spans += [Span(each.offset, each.offset) for each in hints.hints(view, 0, end)]
    spans += [each.span for each in hints.lenses(view)]
    spans += [each.span for each in repair.format_edits(view)]
    outline.workspace_symbols(view.snapshot, "t")
    calls.incoming(view.snapshot, view.file)
    calls.outgoing(view.snapshot, view.file)
    assert all(0 <= start <= last <= end for start, last in spans), [each for each in spans if not 0 <= each.start <= each.end <= end]


def _of_symbols(symbols: list[outline.Symbol] | tuple[outline.Symbol, ...]) -> list[Span]:
    found: list[Span] = []
    for each in symbols:
        assert each.whole.start <= each.name_span.start <= each.name_span.end <= each.whole.end
        found += [each.whole, each.name_span, *_of_symbols(each.children)]
    return found
