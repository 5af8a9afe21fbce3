"""What a rule is, and how it says something.

A rule module has a docstring (the published page: *What it does*, *Why it matters*, *Example*, *Use instead*, and *Fix* where it has one),
a constant ``RULE`` and one function:

* ``tell(problem, view)`` where the registry holds the kinds of problem it speaks about: ``problem`` is typed with these classes, or
* ``check(view)`` where it looks at a whole view.

Both yield :class:`~launchlint.finding.Finding`, made with :meth:`Rule.at`. A ``check`` function may also yield :class:`Fine`: "this place
is in order here". A finding of the same rule at a place that is in order in any configuration of any entry file is dropped.
"""

from __future__ import annotations

from launchlint.finding import Finding, Fix, Location, Related, Severity
from launchlint.named_tuple import NamedTuple
from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

_LONGEST_WORDS = 1_000
_LONGEST_EDITS = 20_000
_ELEMENT_LOOKED_AT = 4_000


def shortened(text: str) -> str:
    """``text``, without its middle where it is far too long to read: names and values of a hostile file may have megabytes."""
    return text if len(text) <= _LONGEST_WORDS else f"{text[: _LONGEST_WORDS - 300]} … {text[-200:]}"


def _bounded(fix: Fix | None) -> Fix | None:
    """``fix`` with words that can be read; none where it would write more than anybody would look at."""
    if fix is None or sum(len(edit.text) for edit in fix.edits) > _LONGEST_EDITS:
        return None
    return fix._replace(message=shortened(fix.message), changes=shortened(fix.changes))


class Fine(NamedTuple):
    """The place where rule ``rule`` has looked and found nothing wrong, although it may in other configurations.

    With a ``topic`` that holds for what it says of that one only, and in entry files that are parts of the one where it is in order.
    """

    rule: str
    path: str
    start: int
    topic: str = ""


class Rule(NamedTuple):
    """The declaration of a rule.

    ``roslaunch`` says who tells people today: roslaunch ``refuses`` the file, roslaunch-check ``reports`` it, or ``nobody``.
    ``fixable`` says whether ``--fix`` can repair it: ``safe`` (at least some of what it finds), ``unsafe`` or ``never``.
    ``default`` is false for rules that are off until selected.
    """

    id: str
    name: str
    severity: Severity
    roslaunch: Literal["refuses", "reports", "nobody"] = "nobody"
    fixable: Literal["safe", "unsafe", "never"] = "never"
    default: bool = True

    def at(
        self,
        where: Origin | Place,
        message: str,
        *,
        severity: Severity | None = None,
        label: str = "",
        related: tuple[tuple[Place, str], ...] = (),
        notes: tuple[str, ...] = (),
        help: str = "",
        fix: Fix | None = None,
        topic: str = "",
        cause: str = "",
        shared_cause: str = "",
        about: tuple[str, ...] = (),
    ) -> Finding:
        """Make the finding of this rule at ``where``. ``message`` and ``help`` are single lines without a full stop.

        ``topic`` tells apart several findings of this rule at one place. Findings of this rule with the same ``cause`` are told as one,
        and so are findings of several rules with the same ``shared_cause``; ``about`` is what :attr:`Finding.about` says.
        """
        origin = where if isinstance(where, Origin) else Origin(where)
        source, span = origin.place
        finding = self.at_location(
            Location.of(origin.place),
            message,
            severity=severity,
            label=label,
            notes=notes,
            help=help,
            fix=fix,
            topic=topic,
            cause=cause,
            shared_cause=shared_cause,
            about=about,
        )
        return finding._replace(
            related=tuple(Related(Location.of(place), shortened(text)) for place, text in related),
            chain=tuple(Location.of(place) for place in origin.chain),
            element=" ".join(source.text[span.start : min(span.end, span.start + _ELEMENT_LOOKED_AT)].split())[:200],
        )

    def at_location(
        self,
        location: Location,
        message: str,
        *,
        severity: Severity | None = None,
        label: str = "",
        notes: tuple[str, ...] = (),
        help: str = "",
        fix: Fix | None = None,
        topic: str = "",
        cause: str = "",
        shared_cause: str = "",
        about: tuple[str, ...] = (),
        element: str = "",
    ) -> Finding:
        """As :meth:`at`, where the place is no longer at hand; ``element`` is what the fingerprint is made from."""
        return Finding(
            self.id,
            self.name,
            self.severity if severity is None else severity,
            location,
            shortened(message),
            label=shortened(label),
            notes=tuple(shortened(note) for note in notes),
            help=shortened(help),
            element=element,
            fix=_bounded(fix),
            topic=topic,
            cause=shared_cause or (cause and f"{self.id} {cause}"),
            about=tuple(shortened(each) for each in about),
        )

    def fine(self, where: Origin | Place, topic: str = "") -> Fine:
        """Say that ``where`` is in order in this configuration."""
        place = where.place if isinstance(where, Origin) else where
        return Fine(self.id, place.source.path, place.span.start, topic)
