"""A package that is not here: is that a mistake, or only this machine?

A checkout in CI holds its own packages and not what is installed on the robot, so that "not found" alone says little. What decides is
whether the picture is complete, and whether anybody has ever heard of the name. LL210 and LL303 both ask here.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence

from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.library.shipped import Bundled, is_in_library
from launchlint.named_tuple import NamedTuple
from launchlint.plural import listed
from launchlint.rules.judging.joined import joined
from launchlint.rules.judging.stale_package import holds_some, lacks_all, own_instead, programs_asked
from launchlint.rules.judging.template import is_among_templates
from launchlint.spelling import closest, distance, folded, one_slip
from launchlint.workspace.base_paths import leads_below, read_base_paths
from launchlint.workspace.crawl import COLCON
from launchlint.workspace.looking import Looked, question, remembered
from launchlint.workspace.package import Package
from launchlint.workspace.packages import Packages
from launchlint.workspace.place import Hidden
from launchlint.workspace.public_packages import public_names
from launchlint.workspace.source_lists import GITMODULES

_MOST_NAMED = 6
_SHORT = 2
"""Letters of a word that another letter makes another word of: abbreviations."""
SHORTEST_SLIP = 6
"""Below this many letters most names are one slip away from some other name."""
LETTERS_FOR_A_SLIP = 8
"""Of several slips there is one in so many letters at most."""


_NUMBER = late(r"[_-]v?\d+")
_LEGAL = late(r"[A-Za-z][\w-]*")


def is_placeholder(name: str) -> bool:
    """Whether no package can bear this name (REP 127), as ``[PACKAGE_NAME]`` or ``@name@`` in a template that is filled in later."""
    return _LEGAL.fullmatch(name.strip()) is None


class Judgement(NamedTuple):
    """How bad it is that a package is not here, ``why`` that can be said (one line), the ``help``, and which package it proposes.

    ``beginning`` is a package here with whose name the missing one begins; ``reason`` is one that holds for other missing packages, too.
    """

    severity: Severity
    why: str
    help: str
    meant: str = ""
    beginning: str = ""
    reason: str = ""


def judge(name: str, packages: Packages, near: str, text: str) -> Judgement | None:
    """What to say of package ``name``, which a launch file at ``near`` with ``text`` uses; ``None`` where there is nothing to say.

    Error: a metapackage, any name where the picture is complete (``Packages.complete``), and a name that is one slip away from a package
    that is here or that a ``package.xml`` declares. Nothing: a package that is here, one of the public index or of the library that
    launchlint ships, one that a ``package.xml`` of the workspaces declares, one whose repository a ``.gitmodules``, ``*.rosinstall`` or
    ``*.repos`` names, one whose ``package.xml`` is here and broken (LL704 tells of that), and a placeholder.
    Warning: a name that is much like one that is here, declared or public, or that is one that is here with a number or with its end twice
    (``arm_2``, ``arm_config_config``). Info: any other, also one that begins like one that is here: it may well lie in another
    repository of the same people, or of this project.
    One slip from a public package is help and no more: no list holds all packages. A package is proposed only where it has a file that
    is asked for by ``$(find name)/…``, if any is; a public one of another maker only where it is known to have a program that is asked for.
    """
    if packages.has(name) or is_placeholder(name):
        return None
    key = (name, near, text)  # of all configurations of a file alike
    told = packages.once(_told)
    return remembered(told, key, lambda: _judge_in(name, packages, near, text))


def _told(packages: Packages) -> dict[tuple[str, str, str], tuple[Judgement | None, Looked]]:
    """The answers given so far, by the missing name and the file that uses it, and what they hang on."""
    return {}


def _judge_in(name: str, packages: Packages, near: str, text: str) -> Judgement | None:
    home = packages.package_of(near)
    own = None if packages.complete else own_instead(name, text, packages, near)
    if own is not None and packages.listed_in(name) is None:
        why = f"what this file asks of it lies in {own.name}, its own package: {name} may be a former name"
        return Judgement(Severity.WARNING, why, _did_you_mean(own.name))
    answer = packages.answer(_judged, f"{name}\0{'' if home is None else home.manifest_path}")
    return answer if answer is None else _held_against_files(answer, name, text, packages, near)


def _held_against_files(answer: Judgement, name: str, text: str, packages: Packages, near: str) -> Judgement:
    """``answer`` without the package that it proposes where that has none of the files which ``text`` asks of ``name``."""
    begun = packages.get(answer.beginning, near) if answer.beginning else None
    if begun is not None and holds_some(begun, name, text):
        why = f"what this file asks of it lies in {begun.name}, with whose name it begins"
        return Judgement(Severity.WARNING, why, _did_you_mean(begun.name), begun.name)
    meant = packages.get(answer.meant, near) if answer.meant else None
    if meant is None and _is_of_another_maker(answer.meant, name, packages) and not _starts_one_of(answer.meant, name, text):
        return answer._replace(severity=min(answer.severity, Severity.INFO), help=_add(name), meant="")  # then nothing is like it
    if meant is None or not (lacking := lacks_all(meant, name, text)):
        return answer
    if packages.complete:
        return answer._replace(help=_add(name), meant="")
    why = f"{answer.meant} is here, and has no {lacking}: another package seems to be meant, which no list here knows"
    return Judgement(min(answer.severity, Severity.WARNING), why, _add(name))


def _is_of_another_maker(meant: str, name: str, packages: Packages) -> bool:
    """Whether ``meant`` is known only from the public index, and its first word, that of the maker or robot, is not that of ``name``."""
    if not meant or meant not in public_names() or meant in packages.once(_declared_here):
        return False
    return folded(meant).partition("_")[0] != folded(name).partition("_")[0]


def _starts_one_of(meant: str, name: str, text: str) -> bool:
    """Whether the library knows in ``meant`` a program that ``text`` asks of ``name``."""
    known = Bundled().package(meant) or {}
    return not programs_asked(name, text).isdisjoint(known.get("executables", ()))


def cause(name: str, severity: Severity, judgement: Judgement) -> str:
    """What LL210 and LL303 tell of together: that package ``name`` is not here, over all files, and not who needs it.

    And all packages that are missing for one reason.
    """
    return f"no package {judgement.reason or name} {severity.word}"


def told_of_all(findings: Sequence[Finding]) -> Finding:
    """One for all, with the names of the packages (:attr:`Finding.about`), where they are several."""
    told = joined(findings)
    named = list(dict.fromkeys(each.about[0] for each in findings if each.about))
    return told if len(named) < 2 else told._replace(message=f"{len(named)} packages are not known: {listed(named, _MOST_NAMED)}")


@question
def _judged(packages: Packages, about: str) -> Judgement | None:
    """What is to be said of a missing name in the package with a manifest, or in none."""
    name, _, manifest_path = about.partition("\0")
    return _judge(name, packages, packages.with_manifest(manifest_path) if manifest_path else None)


def _judge(name: str, packages: Packages, home: Package | None) -> Judgement | None:
    local = [package for place in packages.places[: len(packages.workspaces)] for package in place.everything]
    for package in local:
        if package.broken and name in (package.name, package.directory.rpartition("/")[2]):
            return None
        if package.is_metapackage and package.name == name:
            why = f"{name} is a metapackage: it only lists others, and rospack finds nothing under its name"
            return Judgement(Severity.ERROR, why, "name the package of it that holds the file or node")
    public = public_names()
    hidden = packages.hidden(name) if packages.complete or name not in public else None
    if hidden is not None:
        return _say_hidden(hidden, packages, home)
    if home is not None and home.name == name and name not in public:
        outer = packages.package_of(posixpath.dirname(home.directory))
        if outer is not None and not outer.is_metapackage:
            if packages.way is COLCON and leads_below(outer.directory, home.directory, packages.survey(read_base_paths)):
                return None
            inner = _shown(home.directory, packages)
            finder = "colcon" if packages.way is COLCON else "rospack"
            why = f"it is this file's own package, and {inner} lies in another one, {outer.name}: {finder} does not look below a package"
            if is_among_templates(inner):
                return Judgement(Severity.INFO, f"{why}; as a template it becomes a package where it is copied to", "")
            severity = Severity.ERROR if packages.complete else Severity.WARNING
            advice = f"move {inner} out of {outer.name}, or take its files from the package {outer.name}"
            return Judgement(severity, why, advice, reason=f"below {outer.name}")
    declared = packages.once(_declared_here) | _declared([] if home is None else [home])
    if packages.complete:
        here = packages.names()
        near = closest(name, here)
        listed = packages.listed_in(name)
        if listed is not None:
            get = "git submodule update --init" if listed.endswith(GITMODULES) else "get what it lists"
            return Judgement(Severity.ERROR, f"{_shown(listed, packages)} names it, and it is not checked out here", get)
        if name in public and near is None:
            return Judgement(
                Severity.ERROR,
                "every package that exists here is known",
                f"install it: rosdep install {name}, or your system's package of it",
            )
        return Judgement(Severity.ERROR, "every package that exists here is known", _did_you_mean(near) or _add(name), near or "")
    if name in public or name in declared or is_in_library(name) or packages.listed_in(name) is not None:
        return None
    unlisted = f"it is not in the list of {len(public):,} public packages that launchlint ships"
    known = [*packages.names(), *declared]
    slip = _one_slip(name, known)
    if slip is not None:
        where = "here" if packages.has(slip) else "declared in a package.xml"
        return Judgement(Severity.ERROR, f"{slip} is {where}, and {unlisted}", _did_you_mean(slip), slip)
    near = _near(name, known) or _one_slip(name, public.about_as_long(name))
    document = packages.documented_in(name)
    if document is not None:
        why = f"{_shown(document, packages)} names it, and {unlisted}"
        return Judgement(Severity.INFO, why, f"declare {name} in package.xml, or list its repository in a .rosinstall or .repos")
    why = f"no package.xml here declares it, and {unlisted}"
    if near is not None:
        return Judgement(Severity.WARNING, why, _did_you_mean(near), near)
    ends = [(each, name.removeprefix(each)) for each in packages.names() if name.startswith(each)]
    slipped = any(_NUMBER.fullmatch(end) is not None or (end[:1] == "_" and each.endswith(end)) for each, end in ends)
    beginning = max((each for each, _ in ends), key=len, default="")
    return Judgement(Severity.WARNING if slipped else Severity.INFO, why, _add(name), beginning="" if slipped else beginning)


def _say_hidden(hidden: Hidden, packages: Packages, home: Package | None) -> Judgement:
    """A package of the workspace that is switched off; a launch file that is switched off with it is not likely to be started."""
    marker = _shown(hidden.marker, packages)
    finders = "colcon" if packages.way is COLCON else "catkin and rospack"
    why = f"the package lies in {_shown(hidden.directory, packages)}, and {marker} hides it from {finders}"
    off = home is not None and packages.is_hidden(home.directory)
    severity = Severity.INFO if off else Severity.ERROR if packages.complete else Severity.WARNING
    return Judgement(severity, why, f"remove {marker}, or leave out what uses {hidden.name}", reason=f"hidden by {marker}")


def _shown(path: str, packages: Packages) -> str:
    inside = [path[len(each) + 1 :] for each in packages.workspaces if path.startswith(f"{each}/")]
    return min(inside, key=len, default=path)


def _local(packages: Packages) -> list[Package]:
    """The packages of the workspaces."""
    return [package for place in packages.places[: len(packages.workspaces)] for package in place.everything]


def _declared_here(packages: Packages) -> set[str]:
    """What the packages of the workspaces declare."""
    return _declared(_local(packages))


def _declared(packages: Iterable[Package]) -> set[str]:
    """Everything that the manifests of ``packages`` depend on: somebody does know those names."""
    return {name for package in packages if package.manifest is not None for name in package.manifest.depends()}


def _one_slip(name: str, names: Sequence[str]) -> str | None:
    """The one existing name that ``name`` must be a slip for.

    Names that differ in a digit, or in a final ``s`` only, are neighbours in every workspace (``arm_2``, ``ur5``) and no slips.
    """
    if len(name) < SHORTEST_SLIP:
        return None
    wanted = folded(name)
    half = (len(wanted) - 2) // 2
    start, end = wanted[:half], wanted[-half:]
    # One slip leaves one of the halves as it is: that spares comparing with thousands of names.
    alike = ((other, folded(other)) for other in names if abs(len(other) - len(name)) <= 1)
    similar = [other for other, bare in alike if bare.startswith(start) or bare.endswith(end)]
    slip = one_slip(name, similar)
    if slip is None or slip.rstrip("s") == name.rstrip("s") or _differ_in_a_short_word(name, slip):
        return None
    return slip


def _differ_in_a_short_word(name: str, other: str) -> bool:
    """Whether one word of two letters at most stands where the other name has another one: ``velodyne_hl``, ``velodyne_ll``."""
    words, others = name.split("_"), other.split("_")
    different = [(one, two) for one, two in zip(words, others, strict=False) if one != two]
    return len(words) == len(others) and any(max(len(one), len(two)) <= _SHORT for one, two in different)


def _near(name: str, names: Iterable[str]) -> str | None:
    """The most similar name, if that is much alike: packages of one maker share most of their letters and are no slips for each other.

    The first word names the maker or the robot: another one (``hero_description``, ``hsrb_description``) is no slip either.
    """
    near = closest(name, names)
    if near is None or distance(folded(name), folded(near)) > max(1, len(name) // LETTERS_FOR_A_SLIP):
        return None
    first, other = folded(name).partition("_")[0], folded(near).partition("_")[0]
    return near if distance(first, other, 1) <= 1 else None


def _did_you_mean(name: str | None) -> str:
    return "" if name is None else f"did you mean {name}?"


def _add(name: str) -> str:
    return f"correct the name; or, if {name} exists elsewhere, declare it in package.xml, or show where it is with --workspace"
