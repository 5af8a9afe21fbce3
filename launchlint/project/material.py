"""What the page of ``launchlint report`` is made from, beside findings and graphs: texts, addresses, programs, another revision."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence

from launchlint.check.causes import Told
from launchlint.check.entry import EntryChecker, EntryResult
from launchlint.check.graphs import Revision, graphs_of
from launchlint.check.losses import with_losses_since
from launchlint.check.options import EntryRequest, Options
from launchlint.check.survey import Surveyed, Surveyor, reached, shown_in
from launchlint.graph.topology import Topology, topology
from launchlint.library.catalogue import Entry as KnownProgram
from launchlint.library.catalogue import known
from launchlint.library.lookup import Library, open_libraries
from launchlint.project.asked import EntryOptions
from launchlint.report.html.links import checked_prefix
from launchlint.report.html.material import EntryMaterial
from launchlint.source import Source
from launchlint.verdict import LOADS
from launchlint.workspace.packages import Packages

MOST_PROGRAMS = 1_000
"""Programs of the given libraries that are shown although nothing on the page runs them."""


def source_prefix(given: str | None, variables: Mapping[str, str] = os.environ) -> str:
    """What the address of a file begins with, for paths relative to the current directory; empty where nothing says it.

    ``given`` is the address of the repository's root. Where it is None, GitHub's runners say it, if what is checked out here is the commit
    they speak of. Raises UsageError for what is no http(s) address.
    """
    from launchlint.workspace.repository import repository_root

    here = os.path.realpath(os.curdir)
    repository = repository_root(here)
    if given is None:
        server, name, commit = (variables.get(f"GITHUB_{each}", "") for each in ("SERVER_URL", "REPOSITORY", "SHA"))
        if not (server and name and commit) or _head(repository) != commit:
            return ""
        prefix = checked_prefix(f"{server.rstrip('/')}/{name}/blob/{commit}", "GITHUB_SERVER_URL")
    else:
        prefix = checked_prefix(given)
    inner = os.path.relpath(here, repository).replace(os.sep, "/")
    if inner == ".":
        return prefix
    from urllib.parse import quote

    return f"{prefix}{quote(inner)}/"


def _head(repository: str) -> str:
    from launchlint.errors import UsageError
    from launchlint.workspace.revision import resolve

    try:
        return resolve(repository, "HEAD")
    except UsageError:
        return ""


def usual_title(entry: EntryOptions) -> str:
    """The only path that is given, or the directory of the repository."""
    from launchlint.workspace.repository import repository_root

    if entry.standard_input is not None:
        return entry.standard_input
    if entry.entries is not None:
        return os.path.basename(entry.entries)
    path = os.path.realpath(entry.paths[0])
    return os.path.basename(path if len(entry.paths) == 1 else repository_root(path)) or "launch files"


def roots(options: Options, old: Revision | None) -> list[tuple[str, str]]:
    """The directories of this machine that must not show, and what is shown instead."""
    named = [options.root, *options.workspaces]
    found = {each: os.path.relpath(each, options.root) for root in named for each in (root, os.path.realpath(root))}
    if old is not None:
        found.update((old.place(root), shown) for root, shown in list(found.items()))
    return list(found.items())


def reader(checker: EntryChecker) -> Callable[[str], Source | None]:
    """A function that gives the text of a file by its shown path."""
    from launchlint.syntax.decode import decode

    def read(path: str) -> Source | None:
        content = checker.session.read(os.path.join(checker.options.root, path))
        return None if content.data is None else Source(path, decode(content.data).text)

    return read


def entry_materials(told: Sequence[Told], pairs: Sequence[tuple[Surveyed, Topology | None]], packages: Packages) -> list[EntryMaterial]:
    """What the page shows of each entry file and what it connected at the revision, if any, with the findings ``told`` that concern it."""
    concerned = reached(told, [each for each, _ in pairs])
    return [
        EntryMaterial(
            each.result.path,
            each.result.outcome,
            each.topology,
            before,
            each.extents,
            findings,
            each.result.summary.included,
            each.details,
            each.result.sight,
            probe_command([each.result.path]),
            shown_in=shown_in([told[index] for index in findings], each),
            given=each.given,
            whole=each.whole,
            command=start_command(each.result, packages),
        )
        for (each, before), findings in zip(pairs, concerned, strict=True)
    ]


def known_programs(entries: Iterable[EntryMaterial], library: Library, options: Options) -> tuple[list[KnownProgram], int]:
    """What is known of every program that runs, and of those that the given libraries have; then how many of the latter are left out."""
    running = {node.program for entry in entries for side in (entry.topology, entry.before) if side is not None for node in side.nodes}
    programs = known(library, running)
    if not options.library:
        return programs, 0
    given = open_libraries(options.library, options.library_cache, bundled=False)
    listed = known(given, given.packages())
    shown = {(each.package, each.table, each.name) for each in programs}
    others = [each for each in listed if (each.package, each.table, each.name) not in shown]
    return sorted([*programs, *others[:MOST_PROGRAMS]], key=lambda each: each[:3]), max(0, len(others) - MOST_PROGRAMS)


def learnable(entries: Iterable[EntryMaterial], packages: Packages) -> dict[str, str]:
    """Program that is not known → what makes it known: ``probe`` where its package is here, ``sources`` where they would help."""
    from launchlint.probe.unknown import package_here
    from launchlint.probe.words import is_a, is_package

    unknown = {
        node.program for entry in entries for node in (entry.topology.nodes if entry.topology else ()) if node.knowledge == "unknown"
    }
    found = {}
    for program in unknown:
        if is_a("program", program):
            package = program.partition("/")[0].partition("::")[0]
            if package_here(program, packages) is not None:
                found[program] = "probe"
            elif is_package(package):
                found[program] = "sources"
    return found


def probe_command(paths: Iterable[str]) -> str:
    """What to type to have probed what the launch files at ``paths`` start and nobody knows."""
    import shlex

    named = [path for path in paths if path not in ("", os.curdir)]
    if not all(path.isprintable() and not path.startswith("-") for path in named):
        named = []  # such a path can be read, but not typed
    return " ".join(["launchlint probe --unknown", *map(shlex.quote, named)])


def start_command(result: EntryResult, packages: Packages) -> str:
    """What starts an entry file: ``roslaunch demo nav.launch``; its path where it lies in no package; empty where it cannot be typed."""
    import shlex

    path = result.path
    package = packages.package_of(os.path.abspath(result.request.at))
    where = [package.name, os.path.basename(path)] if package is not None else [path]
    words = [*result.outcome.launcher.split(), *where, *(f"{name}:={value}" for name, value in result.request.arguments)]
    return shlex.join(words) if all(word.isprintable() and not word.startswith("-") for word in words) else ""


def beside_base(surveyed: Sequence[Surveyed], surveyor: Surveyor, old: Revision, base: str) -> tuple[list[Surveyed], list[Topology | None]]:
    """Each entry file with what it has lost since the revision, and what it connected there; None where it was not there."""
    rules = [rule for rule in surveyor.rules if rule.view == "base"]
    found: list[Surveyed] = []
    befores: list[Topology | None] = []
    for each in surveyed:
        result = with_losses_since(each.result, surveyor, old, base, rules) if rules else each.result
        found.append(each._replace(result=result))
        request = old.request(result.request)
        if request is None:
            befores.append(None)
        elif each.topology is None or not old.differs(surveyor.options.root, result.launch_files):
            befores.append(each.topology)
        else:
            befores.append(_at_home(topology(graphs_of(old.checker, request)), old))
    return found, befores


def _at_home(before: Topology, old: Revision) -> Topology:
    """The topology with values and labels as they would be in the working tree: that the revision lies elsewhere is no change."""
    params = tuple(each._replace(value=old.at_home(each.value)) for each in before.params)
    return before._replace(params=params, containers=tuple(each._replace(label=old.at_home(each.label)) for each in before.containers))


def base_only(entry: EntryOptions, requests: Sequence[EntryRequest], old: Revision) -> list[tuple[EntryMaterial, EntryRequest]]:
    """The entry files that were there at the revision and are no more, each with how it is asked for there."""
    if entry.standard_input is not None or entry.entries is not None:
        return []
    from launchlint.check.dialects import sort_out

    now = {os.path.abspath(request.at) for request in requests}
    gone = {path: request for path, request in entry.requests_below(old.place, old.back).items() if os.path.abspath(path) not in now}
    kept = sort_out(list(gone.values()), frozenset(), old.checker.session).kept
    wanted = {request.at for request in kept}
    found: dict[str, tuple[Topology, EntryRequest]] = {}
    included: set[str] = set()
    for path, request in gone.items():
        if request.at in wanted and not os.path.exists(path):
            graphs = graphs_of(old.checker, request)
            found[path] = _at_home(topology(graphs), old), request
            included.update(each.source.path for graph in graphs for each in graph.launch.includes if each.source is not None)
    return [
        (EntryMaterial(each.entry, LOADS, None, each, {}, ()), request) for each, request in found.values() if each.entry not in included
    ]
