"""An arg is declared and never read.

No `$(arg …)` and no `$(eval …)` of the file reads it, in no branch, and no `<include>` with `pass_all_args` passes it on. An arg that a
misspelt substitution means, as `$arg(x)`, is not told of: LL215 says what is wrong there.
An arg that its `doc`, or a comment above a run of args, calls unused, old or deprecated is left alone: somebody keeps it on
purpose. So is one with a fixed `value` that is an `$(eval …)`, which may be there to stop roslaunch when it fails, and every arg
of a file with `<rosparam file="…" subst_value="true"/>`: the YAML file may read it.

It is an info where nobody who gives the arg a value is misled: what reads it is commented out, and may come back, or the arg has a fixed
`value`, or a comment above it or behind it says `TODO` or *not yet*, and nothing of its value, and no arg of the run below it is read; or a
comment anywhere in the file names the arg and says that it is not (to be) used. So it is where another file names this one and gives the
arg with `name:=…` (a script, a service, a document, the args of a node in another launch file): it belongs to an interface that is kept;
and where includes pass it, with others, to another launch file of the same directory as well, which reads it. It is one, too, where no
include passes the arg and nobody is likely to give it: it has no default (roslaunch asks for it only where it is read, so that such a rest
of a template is in nobody's way), or the file is a `.test`; where the file holds nothing but args, to keep the place of one that other
robots have (as MoveIt's Setup Assistant writes them); and where the package is a copy of a public one among packages of other people. All
args of one file that are never read are told as one, and so are those of the same names in several files, which mostly were copied from
each other; in files of one directory also where some of them leave unread only some of these args, two or more, or where several leave
one each that together are all of them: a file was divided.

In ROS 2 an arg is seen by all that is executed after it, passed on or not. There it is told of only where neither its file reads it
(`$(var …)`) nor any file that is included by it or executed later; not where one of these is in Python or not
here, or hangs on a condition that does not hold, or is a parameter file with substitutions. Where another launch file beside it takes and
reads the same arg, and at least half of the others, it is information: the two may have one interface.

## Why it matters

Giving the arg a value, on the command line or in an `<include>`, has no effect, and nobody says so. Often a misspelt name is
behind it: the value that was meant to use the arg uses another one. Where the file reads an arg of nearly the same name that it does not
declare, that is said.

## Example

```xml
<launch>
  <arg name="map" default="office"/>
  <arg name="use_lidar" default="true"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Use instead

```xml
<launch>
  <arg name="map" default="office"/>
  <node pkg="map_server" type="map_server" name="map_server" args="$(arg map).yaml"/>
</launch>
```

## Fix

`--unsafe-fixes` removes the arg, unless a launch file that is here passes it in an include, or another file gives it with
`name:=…`, or the file reads an arg of nearly the same name that it does not declare. It can no longer be given then.
Not while there is an error in the file: that may be what should read it.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Iterator, Sequence

from launchlint.evaluate.ros2.problems import ArgUnused
from launchlint.finding import Finding, Severity
from launchlint.late import late
from launchlint.rules.edits import fix, remove_element, spot
from launchlint.rules.judging.arg_comments import (
    ON_PURPOSE,
    SAID_NOT_USED,
    STILL_TO_BE_USED,
    not_used,
    remarks_of,
    says_later,
    says_so,
    speaks_of,
)
from launchlint.rules.judging.divided import with_parts
from launchlint.rules.judging.joined import joined, spokesman
from launchlint.rules.judging.never_declared import never_declared
from launchlint.rules.judging.one_interface import taken_beside
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, LaunchView, of_ros2
from launchlint.rules.wording import words_at, words_of
from launchlint.source import Origin, Place, Source, Span
from launchlint.spelling import closest, distance, folded, is_part
from launchlint.syntax.parts import Literal, Malformed, Parts, Substitution
from launchlint.syntax.ros1.substitutions import expression_in, parts_of
from launchlint.syntax.tree import Comment, Document, Element

_LONGEST_DECLARATION = 2_000
NO_EFFECT = "a value that is given for it has no effect"
NO_DEFAULT = "{} has no default; roslaunch asks for it only where it is read, so that the file starts without it"
NOTHING_ELSE = "the file holds nothing but args: it keeps a place, and takes what it may be given one day"
_MOST_ALIKE = 40
"""Args by which copies of a file are recognised; each finding carries them."""
_SHORT = 3
"""Names of so many letters are one letter away from many others."""
_MOST_UNDECLARED = 40
"""Names that a file reads and does not declare, with each of which an arg that it does not read is compared."""
RULE = Rule("LL206", "unused-arg", Severity.WARNING, fixable="unsafe")

# Not the grammar of substitutions: in text that stands for itself and in comments whatever looks like a read is one, closed or not.
READ = late(r"[({\[]\s*arg\s+([^\s(){}\[\]$]+)")
WORD = late(r"[^\W\d]\w*")
EVAL = late(r"\$\(eval([^\n]*)")
COMPUTED_NAME = late(r"\barg\s*\(\s*[^'\"\s]|\b(?:globals|locals|vars|dir|eval|exec)\s*\(")


def check(view: FileView) -> Iterator[Finding]:
    """Every arg that the text of this file declares and never reads; silent where the names that are read cannot be told."""
    if of_ros2(view):
        return
    document = view.document
    declared: dict[str, list[Element]] = {}
    for element in document.elements:
        if element.tag == "arg" and element.parent is not None and element.parent.tag in ("launch", "group"):
            name = element.get("name")
            if name and "$" not in name:
                declared.setdefault(name, []).append(element)
    if not declared:
        return
    read = _names_read(document)
    if read is None:
        return
    kept = {each.index for each in document.elements if each.tag == "arg" and ON_PURPOSE.search(each.get("doc") or "")}
    kept |= _spoken_of(document, says_so)
    in_comments = {name for comment in document.comments for name in _names_in(comment.text)}
    unread = {
        name: elements
        for name, elements in declared.items()
        if name not in read and not any(_is_check(element) or element.index in kept for element in elements)
    }
    undeclared = sorted(_asked_names(document) - declared.keys()) if unread else []
    meant = {name: near for name in unread if (near := _read_instead(name, undeclared))}
    nothing_else = all(each.tag in ("launch", "group", "arg") for each in document.elements)
    reasons = {name: NOTHING_ELSE if nothing_else else _why_idle(name, elements, in_comments) for name, elements in unread.items()}
    later = _kept_for_later(document, {each.index for elements in unread.values() for each in elements}) if unread else set()
    for name, elements in unread.items():
        if not reasons[name] and name not in meant and all(element.index in later for element in elements):
            reasons[name] = STILL_TO_BE_USED
    said = _said_not_used(document) if unread else set()
    reasons = {name: reason or (SAID_NOT_USED if name in said and name not in meant else "") for name, reason in reasons.items()}
    causes = {
        reason: _cause([unread[name] for name, each in reasons.items() if each == reason and name not in meant], reason, document)
        for reason in dict.fromkeys(reasons.values())
    }
    for name, elements in unread.items():
        idle = reasons[name]
        first, *others = (document.place(element.attributes["name"].value_span) for element in elements)
        yield RULE.at(
            first,
            f"the arg {name} is never read",
            severity=Severity.INFO if idle else None,
            label="unused",
            related=tuple((place, "declared here too") for place in others),
            notes=(idle or NO_EFFECT, *([NO_DEFAULT.format(name)] if _lacks_default(elements) else [])),
            cause="" if name in meant else causes[idle],
            shared_cause=never_declared(document.source.path, meant[name]) if name in meant else "",
            help=f"this file reads $(arg {meant[name]}) and declares no {meant[name]}: give both one name"
            if name in meant
            else f"remove it here and in the includes that pass it, or use it as $(arg {name})",
            fix=None
            if others or name in meant
            else fix("remove the arg", remove_element(spot(view, first)), safe=False, changes=f"{name} can no longer be given"),
        )


def tell(problem: ArgUnused, view: LaunchView) -> Iterator[Finding]:
    """The same in ROS 2, where it takes a whole launch to tell: an arg is seen by all files that are executed after its own."""
    if ON_PURPOSE.search(problem.description):
        return
    name, place = problem.name, problem.place
    written = _written(place, name)
    remarks = view.once(remarks_of)(place.source.path)
    if speaks_of(remarks, place, written, says_so):
        return
    idle = NOTHING_ELSE if problem.alone else "only a comment reads it" if _is_in_comment(place.source, name) else ""
    beside = (
        ""
        if idle
        else taken_beside(
            posixpath.abspath(place.source.file), name, view.once(_declared).get(id(place.source), frozenset()), view.packages
        )
    )
    if not idle and (_is_used_by_program(place.source.text, name) or _is_read_by_module(place.source, name, view)):
        idle = "the program reads it where it does not get to here"
    if beside:
        idle = f"{beside} beside this file takes it, too, and reads it: it may be here for those who include one or the other"
    if not idle and name in not_used(each.text for each in remarks):
        idle = SAID_NOT_USED
    if not idle and speaks_of(remarks, place, written, says_later):
        idle = STILL_TO_BE_USED
    yield RULE.at(
        Origin(written, problem.origin.step),
        f"the arg {name} is never read",
        severity=Severity.INFO if idle else None,
        label="unused",
        notes=(idle or NO_EFFECT,),
        help=f"remove it here and in the includes that pass it, or use it as {words_at(place).call('var', name)}",
        topic=name,
        cause=_cause_of_all(problem, view, idle),
    )


def _is_in_comment(source: Source, name: str) -> bool:
    """Whether what reads the arg is commented out: nothing reads it that is not."""
    if not source.path.endswith(".py"):
        return f"$(var {name})" in source.text
    return re.search(rf"""#[^\n]*\bLaunchConfiguration\(\s*(?:variable_name\s*=\s*)?["']{re.escape(name)}["']""", source.text) is not None


def _is_used_by_program(text: str, name: str) -> bool:
    """Whether a launch file in Python keeps the arg in a variable that it uses, or hands it on right where it reads it, perhaps in a loop
    or branch that is not run.
    """
    read = rf"""LaunchConfiguration\(\s*(?:variable_name\s*=\s*)?["']{re.escape(name)}["']"""
    if re.search(rf"""^(?!\s*\w+\s*=\s*{read})[^#\n]*\b{read}""", text, re.MULTILINE) is not None:
        return True
    found = re.search(rf"""\b(\w+)\s*=\s*LaunchConfiguration\(\s*["']{re.escape(name)}["']""", text)
    return found is not None and len(re.findall(rf"(?<![\w.'\"])(?:self\.)?{found[1]}(?![\w'\"])(?!\s*=[^=])", text)) > 0


def _is_read_by_module(source: Source, name: str, view: LaunchView) -> bool:
    """Whether a module that several launch files may use reads the arg that it declares, in a function that is not called here."""
    if not source.path.endswith(".py") or any(each.source.path == source.path for each in view.launch.followed):
        return False
    read = rf"""^[^#\n]*\bLaunchConfiguration\(\s*(?:variable_name\s*=\s*)?["']{re.escape(name)}["']"""
    return re.search(read, source.text, re.MULTILINE) is not None


def _cause_of_all(problem: ArgUnused, view: LaunchView, idle: str) -> str:
    """One for all that is unread in a file, and in its copies: those in which the same args are not read."""
    source = problem.place.source
    names = view.once(_unread)[id(source)]
    return "; ".join((idle, *names)) if len(names) <= _MOST_ALIKE else f"{source.path} {idle}"


def _unread(view: LaunchView) -> dict[int, list[str]]:
    """The args that are not read, by the identity of the source that declares them, sorted."""
    found: dict[int, set[str]] = {}
    for each in view.launch.noticed(ArgUnused):
        found.setdefault(id(each.place.source), set()).add(each.name)
    return {source: sorted(names) for source, names in found.items()}


def _declared(view: LaunchView) -> dict[int, frozenset[str]]:
    """The args that each source declares, by its identity."""
    found: dict[int, set[str]] = {}
    for each in view.launch.declared:
        found.setdefault(id(each.origin.place.source), set()).add(each.name)
    return {source: frozenset(names) for source, names in found.items()}


def _written(place: Place, name: str) -> Place:
    """Where in the declaration the name stands: in YAML the place is the key only."""
    text, start = place.source.text, place.span.start
    if place.source.path.endswith(".py"):
        quoted = re.compile(rf"""["']{re.escape(name)}["']""").search(text, start, start + _LONGEST_DECLARATION)
        return place if quoted is None else Place(place.source, Span(quoted.start() + 1, quoted.end() - 1))
    at = text.find(name, text.find("name", start, start + _LONGEST_DECLARATION) + 4, start + _LONGEST_DECLARATION)
    return place if at < 0 else Place(place.source, Span(at, at + len(name)))


def together(findings: Sequence[Finding]) -> Finding:
    """The args of one cause, by their names, told in a file that leaves most of them unread."""
    result = joined(findings, _where_most_are(findings))
    names = list(dict.fromkeys(name_of(finding) for finding in findings if finding.rule == RULE.id))
    if len(names) < 2:
        return result
    more = f" and {len(names) - 4} more" if len(names) > 4 else ""
    bare = sorted({name_of(finding) for finding in findings if lacks_default(finding)})
    own = next(finding for finding in findings if finding.rule == RULE.id)
    written = words_of(own.location.path).call("var", "…") if own.topic else "$(arg …)"  # those of ROS 1 have no topic
    return result._replace(
        message=f"{len(names)} args are never read: {', '.join(names[:4])}{more}",
        notes=(*result.notes[:1], *([_without_default(bare)] if bare else [])),
        help=f"remove them here and in the includes that pass them, or use them as {written}",
        about=tuple(names),
    )


def _where_most_are(findings: Sequence[Finding]) -> Finding:
    """The one that speaks for all, or where another file leaves more of the args unread, the first of that file."""
    first = spokesman(findings)
    names: dict[str, set[str]] = {}
    for finding in findings:
        if finding.rule == RULE.id and finding.severity is first.severity:
            names.setdefault(finding.location.path, set()).add(name_of(finding))
    most = max(names, key=lambda path: (len(names[path]), path == first.location.path), default="")
    if first.rule != RULE.id or most == first.location.path:
        return first
    return next(each for each in findings if each.location.path == most and each.rule == RULE.id and each.severity is first.severity)


def of_copies(findings: Sequence[Finding]) -> Iterator[Finding]:
    """One for files of one directory that leave the same args unread, or two or more of the same: one was made from the other.

    So were several that leave one each unread, of a file that leaves them all, in the same words: it was divided.
    """
    groups: list[list[Finding]] = []
    for finding in sorted(findings, key=lambda each: -len(each.about)):
        longer = next((group for group in groups if finding.about and _is_copied(finding, group[0])), None)
        if longer is None:
            groups.append([finding])
        else:
            longer.append(finding)
    for group in with_parts(groups, name_of, _kind):
        yield joined(group, group[0]) if len(group) > 1 else group[0]


def _kind(finding: Finding) -> tuple[object, ...]:
    """What is the same for findings of files of one directory that may have been made from each other."""
    return finding.severity, finding.notes[:1], posixpath.dirname(finding.location.path)


def idea(finding: Finding) -> tuple[object, ...] | None:
    """Files of one name, in several directories, leave the same args unread, which they declare alike."""
    if finding.rule != RULE.id:
        return None
    place, names = finding.location, finding.about or (name_of(finding),)
    return (posixpath.basename(place.path), place.text.strip(), *names, *finding.notes[:1])


def _is_copied(finding: Finding, longer: Finding) -> bool:
    """Whether all args of a told finding are among those of another one of its kind, which is about files of the same directory."""
    return _kind(finding) == _kind(longer) and frozenset(finding.about) <= frozenset(longer.about)


def _without_default(names: Sequence[str]) -> str:
    if len(names) == 1:
        return NO_DEFAULT.format(names[0])
    more = f" and {len(names) - 4} more" if len(names) > 4 else ""
    return (
        f"{', '.join(names[:4])}{more} have no default; roslaunch asks for them only where they are read, so that the file starts without"
    )


def lacks_default(finding: Finding) -> bool:
    """Whether the arg that a finding of this rule is about has neither default nor value."""
    return NO_DEFAULT.format(name_of(finding)) in finding.notes


def name_of(finding: Finding) -> str:
    """The arg that a finding of this rule is about: it stands at the name."""
    return finding.topic or finding.element


def _why_idle(name: str, elements: list[Element], in_comments: set[str]) -> str:
    """Why nobody who gives the arg a value is misled; empty where somebody may be."""
    if name in in_comments:
        return "only a comment reads it"
    if all(element.attributes.keys() & {"value", "default"} == {"value"} for element in elements):
        return "it has a fixed value, which nobody uses"
    return ""


def _asked_names(document: Document) -> set[str]:
    """Names that a ``$(arg …)`` of the file reads."""
    texts = (text for each in document.elements for text in (each.text, *(attribute.value for attribute in each.attributes.values())))
    return {name for text in texts if "$(arg" in text for name in READ.findall(text)}


def _read_instead(name: str, undeclared: Sequence[str]) -> str:
    """The arg that is read and not declared of which ``name`` may be the declaration; empty where there is none.

    Here one letter or digit more is a slip as well: an arg that nobody declares is no neighbour of this one.
    """
    if len(undeclared) > _MOST_UNDECLARED:
        return ""
    near = closest(name, undeclared)
    if near is None and len(name) > _SHORT:
        near = min((each for each in undeclared if distance(folded(name), folded(each), 1) <= 1), default=None)
    shorter = [each for each in undeclared if is_part(each, name)] if near is None else []
    return near or (shorter[0] if len(shorter) == 1 else "")


def _lacks_default(elements: list[Element]) -> bool:
    """Whether the arg has no value unless it is given one: what reads it would demand one (roslaunch.xmlloader, ArgException)."""
    return not any({"default", "value", "if", "unless"} & element.attributes.keys() for element in elements)


def _cause(unread: list[list[Element]], reason: str, document: Document) -> str:
    """One for all that is unread in a file, and in its copies; an arg without a default is a matter of its own file."""
    if len(unread) <= _MOST_ALIKE and all(
        any("default" in each.attributes or "value" in each.attributes for each in elements) for elements in unread
    ):
        return "; ".join((reason, *sorted(elements[0].get("name") or "" for elements in unread)))
    return f"{document.source.path} {reason}"


def _names_read(document: Document) -> set[str] | None:
    """Names that anything in the file reads; ``None`` where all args are passed on, a YAML file may read any, or a name is computed."""
    names: set[str] = set()
    for element in document.elements:
        if element.tag == "rosparam" and _is_substituted_file(element):
            return None
        for attribute in element.attributes.values():
            value = attribute.value
            if attribute.name == "pass_all_args" and (value.lower() == "true" or "$" in value):
                return None
            if "arg" in value or "$" in value:
                read = _names_in_value(parts_of(attribute))
                if read is None:
                    return None
                names |= read
        if element.texts and "arg" in element.text:
            names.update(_names_in(element.text))
    return names


def _names_in_value(parts: Parts) -> set[str] | None:
    """Names that a value reads, or means to where roslaunch does not take it so; ``None`` where it computes one."""
    code = "" if parts.expression is None else parts.expression.code
    names = {word.text for part in parts.substitutions("arg") for word in part.words[1:]}
    for part in parts.parts:
        if isinstance(part, Literal):
            names.update(READ.findall(part.text))
        elif isinstance(part, Malformed):
            names.update(word.text for word in part.words)
        if isinstance(part, (Substitution, Malformed)) and part.words and part.words[0].text == "eval":
            code = parts.text  # among other text; where it ends, nobody knows
    return None if COMPUTED_NAME.search(code) else names.union(WORD.findall(code))


def _names_in(text: str) -> set[str]:
    """Names that what looks like a substitution in ``text`` reads."""
    return {*READ.findall(text), *WORD.findall(" ".join(EVAL.findall(text)))} if "(" in text else set()


def _is_substituted_file(element: Element) -> bool:
    """Whether a ``<rosparam>`` replaces the ``$(…)`` in a file (roslaunch.xmlloader._rosparam_tag); one that hangs on an arg may."""
    subst, command = element.get("subst_value") or "", (element.get("command") or "load").strip()
    return "file" in element.attributes and ("$" in subst or subst.lower() in ("true", "1")) and (command == "load" or "$" in command)


def _is_check(element: Element) -> bool:
    """Whether the arg is computed for nobody, as people do to have roslaunch stop where something is not as it must be."""
    return expression_in(element.get("value") or "") is not None


def _spoken_of(document: Document, says: Callable[[str], bool]) -> set[int]:
    """Indices of the args of which a comment ``says`` something.

    A comment speaks of the args that end in its line; if it begins its line also of the run of args directly below it, as far as the next
    element of another kind, or the next comment behind a blank line.
    """
    speaking = [each for each in document.comments if says(each.text)]
    if not speaking:
        return set()
    args = [each for each in document.elements if each.tag == "arg"]
    source = document.source
    lines = {source.position(each.span.start).line for each in speaking}
    kept = {each.index for each in args if source.position(each.span.end).line in lines}
    things: list[Element | Comment] = sorted([*document.elements, *document.comments], key=lambda each: each.span.start)
    heard = in_run = False
    line = 0  # in which the comment or start tag before ended
    for thing in things:
        first = source.position(thing.span.start)
        last = source.position(thing.start_span.end if isinstance(thing, Element) else thing.span.end)
        if isinstance(thing, Element):
            heard = heard and thing.tag == "arg" and (in_run or first.line <= line + 1)
            in_run = heard
            if heard:
                kept.add(thing.index)
        elif first.line > line and says(thing.text):
            heard, in_run = True, False
        elif first.line > line + 1:
            heard = False
        line = last.line
    return kept


def _kept_for_later(document: Document, unread: set[int]) -> set[int]:
    """Indices of the args of which a comment says that something is still to be done, in runs of which none is read: else it heads them."""
    runs: dict[int, set[int]] = {}
    for at, index in enumerate(sorted(_spoken_of(document, says_later))):
        runs.setdefault(index - at, set()).add(index)
    return {index for run in runs.values() if run <= unread for index in run}


def _said_not_used(document: Document) -> set[str]:
    """Names of args of which a comment anywhere says that they are not used, or not to be used."""
    return not_used(comment.text for comment in document.comments)
