"""What the page is made from, as the command line brings it together."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from launchlint.finding import Finding
from launchlint.graph.details import NO_DETAILS, Details
from launchlint.graph.topology import Topology
from launchlint.library.catalogue import Entry as KnownProgram
from launchlint.named_tuple import NamedTuple
from launchlint.sight import NOTHING, Sight
from launchlint.source import Source, Span
from launchlint.verdict import Verdict


class EntryMaterial(NamedTuple):
    """One entry file.

    Args:
        path: as shown to people.
        verdict: what roslaunch makes of it.
        topology: what it connects in all its configurations; None where launchlint failed on it, or where it is no more.
        before: the same at the revision that the page compares with; None where it was not there, or nothing is compared.
        extents: place of a node, param, remap, group or include → where its element begins and ends in the file.
        findings: indexes of the findings that concern it.
        includes: paths of the launch files it reads.
        details: of ``topology``.
        sight: how many of its nodes are known, as ``check`` says it.
        probe: what to type to have those of its programs probed that are not known.
        verdict_before: what roslaunch made of it at the revision; None where it was not there, or nothing is compared.
        fixed: indexes of the findings that it had at the revision and has no more.
        shown_in: for each of ``findings`` the numbers of the configurations (of ``given``) that have it; empty: all.
        given: the args of each configuration.
        whole: whether it can be told of any combination of args what it starts.
        command: what starts it, on the command line.
    """

    path: str
    verdict: Verdict
    topology: Topology | None
    before: Topology | None
    extents: Mapping[str, Span]
    findings: Sequence[int]
    includes: Sequence[str] = ()
    details: Details = NO_DETAILS
    sight: Sight = NOTHING
    probe: str = "launchlint probe --unknown"
    verdict_before: Verdict | None = None
    fixed: Sequence[int] = ()
    shown_in: Sequence[Sequence[int]] = ()
    given: Sequence[Sequence[tuple[str, str]]] = ()
    whole: bool = True
    command: str = ""


class Material(NamedTuple):
    """All that one page shows.

    Args:
        title: what it is about.
        version: of launchlint.
        roots: directories of this machine, absolute, with what is shown in their place.
        source_url: prefix of links to files, with a slash at its end; empty where there is none.
        base: the revision that is compared with; empty where there is none.
        findings: with their fingerprints, in report order.
        entries: in any order.
        source: the text of a file by its shown path; None where it cannot be read.
        base_source: the same at the revision.
        programs: what is known of each program.
        learn: package/executable of a program that is not known → what makes it known: ``probe`` (its package is here) or ``sources``.
        notices: what is told of the run as a whole.
        left_out: how many programs of the given libraries are not among ``programs``.
        sight: of all entries, as ``check`` says it.
        probe: as of an entry, for all of them.
        new: fingerprints of the findings that were not there at the revision.
        fixed: findings that were there and are no more, with their fingerprints.
    """

    title: str
    version: str
    roots: Sequence[tuple[str, str]]
    source_url: str
    base: str
    findings: Sequence[tuple[Finding, str]]
    entries: Sequence[EntryMaterial]
    source: Callable[[str], Source | None]
    base_source: Callable[[str], Source | None]
    programs: Sequence[KnownProgram]
    learn: Mapping[str, str]
    notices: Sequence[str] = ()
    left_out: int = 0
    sight: Sight = NOTHING
    probe: str = "launchlint probe --unknown"
    new: frozenset[str] = frozenset()
    fixed: Sequence[tuple[Finding, str]] = ()
