"""The first page: cards of the launch files, and all findings beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from urllib.parse import quote

from launchlint.report.html.cards import Card, Group
from launchlint.report.html.parts.markup import NOTHING, Markup, joined, markup
from launchlint.report.html.summary import Wrong, wrong
from launchlint.report.html.tables import place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def landing(data: Mapping[str, Any], groups: Sequence[Group]) -> Markup:
    """The section; ``groups`` are the cards of the launch files of ``data``."""
    return markup(
        '<section id="landing" aria-label="Overview">\n<div class="landing-cards">\n{groups}</div>\n<div class="landing-findings">\n'
        '<h2>Findings <span class="number">{number}</span></h2>\n{findings}{fixed}</div>\n</section>\n',
        groups=joined(map(_group, groups)), number=len(data["findings"]), findings=_findings(data), fixed=_fixed(data),
    )  # fmt: skip


def _group(group: Group) -> Markup:
    said = markup(' <span class="card-said">{said}</span>', said=group.said) if group.said else NOTHING
    template = (
        '<details class="card-group">\n<summary><h2>{title} <span class="number">{number}</span></h2>{said}</summary>\n'
        '<ol class="cards">\n{cards}</ol>\n</details>\n'
        if group.folded
        else '<h2 tabindex="-1">{title} <span class="number">{number}</span></h2>\n<ol class="cards{changed}">\n{cards}</ol>\n'
    )
    changed = " changed" if group.changed else ""
    return markup(template, title=group.title, number=len(group.cards), said=said, changed=changed, cards=joined(map(_card, group.cards)))


def _card(card: Card) -> Markup:
    level = markup(" {level}", level=card.level) if card.level else NOTHING
    return markup(
        '<li class="card{level}" data-entry="{entry}">\n'
        '<h3><a href="#entry={address}"><span class="card-directory">{directory}</span>{title}</a></h3>\n{picture}\n'
        '<p class="card-verdict{level}"{hint}><b>{verdict}</b>{why}</p>\n<p class="card-facts"><span>{nodes}</span>{sight}{counts}</p>\n'
        "{changes}</li>\n\n",
        level=level, entry=card.entry, address=quote(card.address), directory=card.directory, title=card.title, picture=_picture(card),
        hint=markup(' title="{why}"', why=card.why) if card.why else NOTHING, verdict=card.verdict,
        why=markup(": {why}", why=card.why) if card.why else NOTHING, nodes=card.nodes, sight=_sight(card),
        counts=joined(markup('<span class="badge {severity}">{words}</span>', **each._asdict()) for each in card.counts),
        changes=_changes(card),
    )  # fmt: skip


def _picture(card: Card) -> Markup:
    if card.picture:
        return Markup(card.picture)  # the thumbnail holds no word of anybody's
    return markup('<p class="no-picture">{said}</p>', said="no nodes known" if card.doubtful else "no nodes")


def _sight(card: Card) -> Markup:
    if not card.sight:
        return NOTHING
    return markup("<span{looks}>{sight}</span>", looks=Markup(' class="unknown"' if card.doubtful else ""), sight=card.sight)


def _changes(card: Card) -> Markup:
    if not card.changes:
        return NOTHING
    changes = joined(markup('<li class="{looks}">{words}</li>', looks=looks, words=words) for looks, words in card.changes)
    return markup('<ul class="card-changes">{changes}</ul>\n', changes=changes)


def _findings(data: Mapping[str, Any]) -> Markup:
    told = wrong(data)
    if not told:
        return Markup('<p class="empty">No rule found anything wrong.</p>\n')
    return markup('<ul class="findings">\n{findings}</ul>\n', findings=joined(_finding(data, each) for each in told))


def _finding(data: Mapping[str, Any], told: Wrong) -> Markup:
    first = told.first
    new = Markup('<span class="badge since">new</span> ') if first.get("since") else NOTHING
    times = markup(' <span class="times">{times} times</span>', times=told.times) if told.times > 1 else NOTHING
    return markup(
        '<li>{new}<span class="badge {severity}">{severity}</span> <code>{rule}</code>{times}\n<a href="#finding={id}">{message}</a>\n'
        '<span class="note"><code class="place">{place}</code></span></li>\n',
        new=new, severity=first["severity"], rule=first["rule"], times=times, id=first["id"], message=first["message"],
        place=place(data, first["place"]).text,
    )  # fmt: skip


def _fixed(data: Mapping[str, Any]) -> Markup:
    if not data["fixed"]:
        return NOTHING
    item = '<li><span class="badge since fixed">fixed</span> <code>{rule}</code> {message}</li>\n'
    return markup(
        '<h2>Fixed since {base} <span class="number">{number}</span></h2>\n<ul class="findings fixed">\n{items}</ul>\n',
        base=data["base"], number=len(data["fixed"]),
        items=joined(markup(item, rule=each["rule"], message=each["message"]) for each in data["fixed"]),
    )  # fmt: skip
