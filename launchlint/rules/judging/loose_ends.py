"""Ends of connections that meet nobody, and the other end that was probably meant.

Only what is certain is looked at. Where a node that is not known could be at the other end, only two loose ends are told whose names differ
in nothing but the namespace or a slip, or for which more speaks than names (:mod:`.signs`); and not even these where something says that
such a node has one of the two names.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from launchlint.finding import Severity
from launchlint.graph.connections import HUBS, OFFERS, Channel, Endpoint, Instance
from launchlint.graph.plausible import Possible
from launchlint.late import late
from launchlint.library.shipped import is_in_library
from launchlint.model import ROS2
from launchlint.named_tuple import NamedTuple
from launchlint.rules.judging.examples import Examples
from launchlint.rules.judging.given_by_file import ToBeMet
from launchlint.rules.judging.name_places import owners
from launchlint.rules.judging.near_names import NAMESPACE, RELATIONS, SIBLING, SLIP, TWIN, WORDS, relation
from launchlint.rules.judging.one_sided import Others, Shown, given_and_taken, is_as_said, is_one_sided, signed, speak_alike, types
from launchlint.rules.judging.package_contents import contents
from launchlint.rules.judging.part_of_launch import comes_from_around
from launchlint.rules.judging.said_elsewhere import says
from launchlint.rules.judging.same_definition import STANDARD, is_known, stands_for
from launchlint.rules.judging.signs import Signs, hears_itself
from launchlint.rules.view import GraphView, tried

_MOST_CANDIDATES = 40
"""Names of one type that a loose end is compared with."""
_MOST_COMPARISONS = 50_000
"""Ends that loose ends are compared with. In a launch with more than people can read of, only the first are looked at."""
_GENERIC = ("std_msgs/", "std_srvs/")
"""Types that say nothing of what is meant."""
_TO_REMAP = late(r"\{remap:([^{}|]+)\}")
_PRIVATE = "{} lies below its own node, where others look only if a remap leads them there"
_CONNECTING_HUBS = frozenset({"/tf", "/tf_static"})


class Missed(NamedTuple):
    """A loose end and what it was probably meant for.

    ``how`` is the relation of the names, empty where only the type agrees, and ``only`` says that no other name is so related;
    ``loose`` says whether the other end is a loose one too;
    ``alike`` are all ends of the other name that are like it, itself included; ``feeding`` are those that it has on its other side.
    ``doubts`` are those who could be at the other end of one of the two, as far as can be known; ``sign`` is what else shows that they are
    meant for each other, for people. ``heard``: its own node is at the other end, by a remap.
    """

    end: Endpoint
    instance: Instance
    other: Endpoint
    partner: Instance
    how: str
    only: bool
    loose: bool
    alike: tuple[Instance, ...]
    feeding: tuple[Instance, ...]
    level: Severity
    doubts: tuple[Possible, ...] = ()
    sign: str = ""
    heard: bool = False


class LooseEnds:
    """The loose ends of one graph."""

    def __init__(self, view: GraphView) -> None:
        self._view = view
        self.graph = view.graph
        self.owners = view.once(owners)
        self._signs = Signs(self.graph, self.owners)
        self._examples = Examples(view, self.owners)
        self._by_type: dict[tuple[str, bool, str], list[Channel]] | None = None
        self._connected: dict[int, bool] = {}
        self._is_to_be_met = ToBeMet(self.owners, self.graph.parameters)
        self._programs = Counter(instance.program for instance in self.graph.instances)
        self._started = {instance.name.rpartition("/")[2] for instance in self.graph.instances}
        self._compared = 0
        self._possible: dict[tuple[int, bool], tuple[Possible, ...] | None] = {}

    def missed(self, kind: str, *, offers: bool) -> Iterator[Missed]:
        """The loose ends of a kind that give (``offers``) or take, where something says what they were meant for: one for each name."""
        for channel in self.graph.channels.values():
            if channel.kind != kind or not is_one_sided(channel, offers=offers):
                continue
            ends = [
                end
                for end in (channel.offers if offers else channel.uses)
                if self._candidates(kind, not offers, end.type) and self._is_to_be_met(end)
            ]
            if ends and (doubts := self._beside(channel, offers=offers)) is not None:
                found = [missed for end in ends if (missed := self._meant(end, doubts)) is not None]
                if found:
                    yield min(found, key=lambda each: (-each.level, *self._apart(each.instance, each.partner), each.instance.name))

    def _sleeps(self, end: Endpoint) -> bool:
        """Whether it is there only while somebody hears its node, and nothing says that somebody is to: it has the name in the code.

        A service below a name that is to be remapped, as one camera of those that a calibrator may be for, is called if it is remapped.
        """
        if end.kind != "topic" and _TO_REMAP.sub(r"\1", end.declaration.name).strip("/") == end.declared.strip(
            "/"
        ) != end.declaration.name.strip("/"):
            return True
        return end.declaration.when == "subscriber" and not end.applied and not self._signs.is_left_private(end)

    def _beside(self, channel: Channel, *, offers: bool) -> tuple[Possible, ...] | None:
        """Who could be at the other end of a name of which only one side is known; None where somebody is, by all that is known."""
        if not is_one_sided(channel, offers=offers):
            return None
        key = (id(channel), offers)
        if key not in self._possible:
            type_ = next((end.type for end in (channel.offers if offers else channel.uses) if is_known(end.type)), "")
            ends = {end.node for end in (channel.offers if offers else channel.uses)}
            found = (self.graph.may_use if offers else self.graph.may_offer)(channel.kind, channel.name, type_)
            found = tuple(each for each in found if {each.node} != ends)  # what a node says or hears is for somebody else
            self._possible[key] = None if any(each.named for each in found) else found
        return self._possible[key]

    def _meant(self, end: Endpoint, doubts: tuple[Possible, ...]) -> Missed | None:
        instance = self.owners[id(end)]
        offers = end.role in OFFERS
        candidates = self._candidates(end.kind, not offers, end.type)
        if not is_known(end.type):  # it takes any type: only a slip says what it was meant for
            self._compared += len(candidates)
            own = {each.name for each in instance.endpoints}  # a relay from one name to the other made no slip
            candidates = [each for each in candidates if each.name not in own and self._may_be_of_any_type(end, each)]
        if not candidates or len(candidates) > _MOST_CANDIDATES or not instance.certain or self._compared > _MOST_COMPARISONS:
            return None
        self._compared += sum(len(each.uses if offers else each.offers) for each in candidates)
        ranked: dict[str, Others] = {}
        for channel in candidates:
            ends = [
                each
                for each in (channel.uses if offers else channel.offers)
                if each.node != end.node and speak_alike(end, each) and self._is_to_be_met(each)
            ]
            if ends and channel.name != end.name:
                ranked.setdefault(relation(end.name, channel.name), []).append((channel, ends))
        shown = None if SLIP in ranked else self._shown(end, ranked, doubts)
        written = shown is not None and shown.written
        if not written:
            ranked.pop(TWIN, None)
        if shown is None and self._sleeps(end):
            return None
        how = next((each for each in RELATIONS if each in ranked), "") if shown is None else relation(end.name, shown.channel.name)
        if how not in ranked:
            return None
        loose = [each for each in ranked[how] if self._beside(each[0], offers=not offers) is not None]
        channels = (loose or ranked[how]) if shown is None else [shown[:2]]
        if len(channels) > 1 or (shown is None and not how and len(ranked[how]) > 1):
            return None  # it could be any of them
        has = any(each.node == end.node for each in (channels[0][0].offers if offers else channels[0][0].uses))
        if has and not (shown is not None and shown.sure):
            return None  # the node has that name already, by another one in its code
        channel, ends = channels[0]
        loose = [each for each in loose if each[0] is channel]
        other = min(ends, key=lambda each: self._apart(instance, self.owners[id(each)]))
        if loose and offers:  # what matters is who else could give what the other end waits for, not who else could take it
            doubts = self._beside(channel, offers=False) or ()
        giver, taker = (end, other) if offers else (other, end)
        doubts = tuple(each for each in doubts if each.node != taker.node)  # what it waits for comes from somebody else
        level = self._level(end, other, how, loose=bool(loose)) if shown is None else Severity.WARNING
        if doubts and shown is None:
            chosen = how == NAMESPACE and not offers and end.applied
            level = self._in_doubt(end, other, how, doubts, level) if loose or how == SLIP or chosen else None
            level = level if loose or level is not Severity.INFO else None
        if level is Severity.WARNING and how != SLIP and comes_from_around(self._view, taker, giver):
            level = Severity.INFO
        if shown is None and (self._signs.is_led_in_vain(other, end) or self._signs.is_led_in_vain(end, other)):
            level = level and Severity.INFO
        wanted = self.graph.channels[taker.kind, taker.name]
        if shown is None and any(each.node == giver.node for each in wanted.uses):
            level = level and Severity.INFO  # the giver waits for that name, too, and makes something else of it
        if level is Severity.WARNING and end.applied and not offers and self._is_of_own_program(end.name, other.name):
            level = Severity.INFO
        if level is Severity.WARNING and shown is None and how in ("", WORDS):  # a program that is not started here may be at the other end
            elsewhere = says(last_part(end), self._view.packages, offers=not offers, besides=_sources(other)) or self._is_of_others(end)
            level = Severity.INFO if elsewhere else level
        if level is Severity.WARNING and how != SLIP and giver.applied and not self.graph.launch.complete:
            # It was led below the name of a node that is not started here: by an include that is not here, maybe.
            level = Severity.INFO if self._namespaces_of_absent(giver.name, taker.name) else level
        if level is Severity.WARNING and shown is not None and doubts and tried(self._view.launch):
            level = Severity.INFO  # not as it is started by default, and then it may be another node's
        if level is None or (level is Severity.INFO and end.declaration.when == "subscriber"):
            return None
        partner = self.owners[id(other)]
        same = tuple(self.owners[id(each)] for each in ends if self.owners[id(each)].program == partner.program)
        opposite = {self.owners[id(each)].name: self.owners[id(each)] for each in (channel.offers if offers else channel.uses)}
        found = Missed(
            end, instance, other, partner, how, len(ranked[how]) == 1, bool(loose), same, tuple(opposite.values()), level, doubts
        )
        itself = hears_itself(self.graph.channels[end.kind, end.name])
        return found._replace(sign="" if shown is None else shown.sign, heard=itself)

    def _may_be_of_any_type(self, end: Endpoint, channel: Channel) -> bool:
        """Whether more than the type says that ``end``, which takes any, was meant for what ``channel`` gives."""
        offers, how = end.role in OFFERS, relation(end.name, channel.name)
        if how == SLIP:
            return True
        if not is_one_sided(channel, offers=not offers):
            return False
        if how == NAMESPACE and end.applied and not offers:
            return True
        return any(self._examples.counterparts(end, each) for each in (channel.uses if offers else channel.offers) if each.certain)

    def _is_of_others(self, end: Endpoint) -> bool:
        """Whether in ROS 2 the code says a global name below the name of a package of which nothing is started here: it is from there."""
        first = end.declared.split("/")[1] if end.declared.count("/") > 1 and end.declared.startswith("/") else ""
        if not first or self._view.dialect.name != ROS2 or not self._view.packages.colcon.has(first):
            return False
        return all(each.node.package != first for each in self._view.graph.instances)

    def _shown(self, end: Endpoint, ranked: dict[str, Others], doubts: tuple[Possible, ...]) -> Shown | None:
        """The other end that more than the names shows to be meant, where there is just one."""
        everything = [each for others in ranked.values() for each in others]
        loose = [each for each in everything if is_one_sided(each[0], offers=end.role not in OFFERS)]
        speaks = not end.type.startswith(_GENERIC) and not self._sleeps(end)
        found = self._written(end, everything, loose) if speaks else []
        found = found or self._exemplary(end, everything, loose, doubts)
        if not found and speaks:
            found = self._remaining(end, ranked, everything, loose, doubts)
        if len(found) != 1:
            return None
        heard = found[0].channel.uses or found[0].misspelt  # that remap names the other end, and so its node
        return found[0] if heard or self._beside(found[0].channel, offers=True) is not None else None

    def _written(self, end: Endpoint, everything: Others, loose: Others) -> list[Shown]:
        """The other ends that a remap names which does nothing as it stands."""
        signs = self._signs
        sure = signed(end, everything, lambda one, other: signs.stray_remap(one, other, only_ends=False))
        if sure:
            return [each._replace(written=True, sure=True) for each in sure]
        strays = signed(end, loose, lambda one, other: signs.stray_remap(one, other, only_ends=True))
        slips = [each._replace(misspelt=True) for each in signed(end, loose, signs.misspelt_remap)]
        return [each._replace(written=True) for each in strays if not self._are_one_chain(end, each.channel)] or [
            each._replace(written=True) for each in slips
        ]

    def _remaining(
        self, end: Endpoint, ranked: dict[str, Others], everything: Others, loose: Others, doubts: tuple[Possible, ...]
    ) -> list[Shown]:
        """The other ends that are left when all others have met somebody, or were led to somebody elsewhere."""
        offers, signs = end.role in OFFERS, self._signs
        found: list[Shown] = []
        same = [each for how in (NAMESPACE, SIBLING) for each in ranked.get(how, ())]
        if not offers and len(same) == 1 and (sign := self._lost(end, same[0], doubts)):
            found = [Shown(*same[0], sign)]
        elif len(loose) == 1 and self._are_only_loose_ends(end):
            ends = loose[0][1]
            signs_of = [signs.odd_one_out(each) for each in (end, *ends)]
            related = end.type.partition("/")[0] not in STANDARD or loose[0][0] not in [each[0] for each in ranked.get("", ())]
            if not offers and related and signs.is_waiting_private(end) and all(self._are_together(end, each) for each in ends):
                signs_of.append(_PRIVATE.format(end.declared))
            if len(everything) == 1 and {each.node for each in doubts} <= {end.node, *(each.node for each in ends)}:
                signs_of += (signs.parting_remap(end, each) for each in ends)
            if len(everything) == 1 and not doubts and end.kind == "service" and not offers and not same:
                signs_of.append(f"nobody else serves or calls a {end.type} here")
            if related:
                signs_of.append(signs.hears_itself(end))
            found = [Shown(*loose[0], sign) for sign in [each for each in signs_of if each][:1]]
        elif not offers and not doubts and self._is_only_one_unchosen(end, loose):
            found = [
                Shown(*each, f"no other {end.type} is published under the name that the code says") for each in loose if is_as_said(each)
            ]
        return [each for each in found if not self._are_one_chain(end, each.channel)]

    def _is_only_one_unchosen(self, end: Endpoint, loose: Others) -> bool:
        """Whether nobody else waits for the type, made for one purpose, by a name that a remap made, and one gives it as its code says.

        Those that are led elsewhere are for others.
        """
        if not end.applied or self.graph.launch.given or end.type.partition("/")[0] in STANDARD:
            return False
        given = [each for each in loose if is_as_said(each)]
        if len(given) != 1 or given[0][0].offers[0].node == end.node:
            return False
        giving = {each.node for each in given[0][0].offers}
        waiting = self._one_sided(end, offers=False)
        return not any(each.name != end.name and not giving.issuperset(one.node for one in each.uses) for each in waiting)

    def _exemplary(self, end: Endpoint, everything: Others, loose: Others, doubts: tuple[Possible, ...]) -> list[Shown]:
        """The other ends that others of their kind show to be meant."""
        examples = self._examples
        # Who publishes may have more results than anybody needs: only what waits for one was meant to get it.
        wanted = loose if end.role in OFFERS else everything
        found = [each for each in signed(end, wanted, examples.elsewhere) if not self._is_one_of_copies(each, loose)]
        found = [each for each in found if not self._signs.are_one_chain(*given_and_taken([end], each.ends))]
        if found:
            return found
        near = [each for each in everything if (how := relation(end.name, each[0].name)) == NAMESPACE or (how == SIBLING and each in loose)]
        open_ = [each for each in near or loose if each in loose and not self._has_nearer(end, each[0])]
        mates = [each for each in signed(end, open_, examples.counterparts) if not _are_both_given(end, each)]
        if mates and end.role in OFFERS and any(self._is_rival(end, mates[0].ends, each) for each in self._one_sided(end, offers=True)):
            return []
        if mates:
            return [each._replace(sure=True) for each in mates]  # be it in a chain: so are the others
        if doubts or end.type.startswith(_GENERIC):
            return []
        if end.role not in OFFERS and not self._signs.is_left_private(end):
            found = signed(end, near or everything, examples.namesake)
        found = found or [each for each in signed(end, loose, examples.of_others) if not self._is_one_of_copies(each, loose)]
        return [each for each in found if not self._are_one_chain(end, each.channel)]

    def _is_rival(self, end: Endpoint, others: list[Endpoint], channel: Channel) -> bool:
        """Whether others of their kind show as well that what ``channel`` gives was meant for ``others``."""
        pairs = ((giver, taker) for giver in channel.offers if giver.certain for taker in others if giver.node != taker.node)
        return channel.name != end.name and any(self._examples.counterparts(*pair) for pair in pairs)

    def _one_sided(self, end: Endpoint, *, offers: bool) -> list[Channel]:
        """The names of the type of ``end`` that are only given, or only taken."""
        return [each for each in self._candidates(end.kind, offers, end.type) if is_one_sided(each, offers=offers)]

    def _has_nearer(self, end: Endpoint, other: Channel) -> bool:
        """Whether another loose end on the side of ``end`` has the name of ``other`` in another namespace, and ``end`` has not."""
        offers = end.role in OFFERS
        near = (NAMESPACE, SIBLING)
        if relation(end.name, other.name) in near:
            return False
        return any(relation(each.name, other.name) in near for each in self._one_sided(end, offers=offers))

    def _is_one_of_copies(self, other: Shown, loose: Others) -> bool:
        """Whether another loose end is the same name of the same program: what holds of the one holds of that, too."""
        roles = {(self.owners[id(each)].program, each.declared) for each in other.ends}
        beside = (each for one, there in loose if one is not other.channel for each in there)
        return any((self.owners[id(each)].program, each.declared) in roles for each in beside)

    def _are_one_chain(self, end: Endpoint, other: Channel) -> bool:
        own = self.graph.channels[end.kind, end.name]
        return self._signs.are_one_chain(*((own.offers, other.uses) if end.role in OFFERS else (other.offers, own.uses)))

    def _lost(self, end: Endpoint, giver: tuple[Channel, list[Endpoint]], doubts: tuple[Possible, ...]) -> str:
        """What it says of a private name that no remap leads to its only giver, or of such a giver that nobody takes; else empty."""
        channel, ends = giver
        if not all(self._are_together(end, each) for each in ends):
            return ""
        if self._signs.is_waiting_private(end):
            return _PRIVATE.format(end.declared)
        lost = end.applied and not doubts and not channel.uses and all(self._signs.is_left_private(each) for each in ends)
        return _PRIVATE.format(ends[0].declared) if lost else ""

    def _are_together(self, end: Endpoint, other: Endpoint) -> bool:
        """Whether the nodes of both ends are in one namespace: what is said elsewhere may be for somebody there who is not here."""
        return self.owners[id(end)].namer.namespace == self.owners[id(other)].namer.namespace

    def _are_only_loose_ends(self, end: Endpoint) -> bool:
        """Whether no more than two names of the type of ``end`` have one side only, one each, beside others of its own node."""
        sides = []
        for offers in (True, False):
            channels = self._one_sided(end, offers=offers)
            own = offers != (end.role in OFFERS)
            sides.append([each for each in channels if not own or {other.node for other in (*each.offers, *each.uses)} != {end.node}])
        return all(len(channels) == 1 for channels in sides)

    def _are_only_two(self, end: Endpoint, other: Endpoint) -> bool:
        """Whether the nodes of both ends talk to nobody else, and no other two nodes of the launch talk of the same."""
        if self.graph.launch.given or self._is_connected(self.owners[id(other)]) or not self._are_only_loose_ends(end):
            return False
        return not any(channel.uses for channel in self._candidates(end.kind, True, end.type))

    def _level(self, end: Endpoint, other: Endpoint, how: str, *, loose: bool) -> Severity | None:
        """How sure it is that the two ends were meant for each other; None: not enough to say anything.

        What a node publishes is meant for somebody; what it waits for may come from outside. The more so for a node that only
        publishes: one that works on what it hears often has more results than anybody needs.
        """
        offers = end.role in OFFERS
        instance, giver = self.owners[id(end)], self.owners[id(end if offers else other)]
        alone, source = not self._is_connected(instance), self._is_source(giver)
        if how == SLIP and not loose and end.name.rpartition("/")[2] == other.name.rpartition("/")[2]:
            return None  # a letter of the namespace apart, and somebody is there: two groups
        if how == SLIP and (loose or alone or not _is_plural(end.name, other.name)):
            return Severity.WARNING
        private = any(self._signs.is_left_private(each) for each in ((end, other) if offers or not end.applied else (end,)))
        # A name that the launch file gives, and not the code, was meant to be that of somebody; so is one that just two nodes say.
        chosen = any(each.applied or each.declared != each.declaration.name for each in (end, other))
        shared = end.kind == "topic" and end.declared == other.declared
        shared = shared and all(self._programs[self.owners[id(each)].program] == 1 for each in (end, other))
        doubtful = private or (end.type.startswith(_GENERIC) and not (loose and (chosen or shared)))
        if loose and (self._are_only_ends(end) or (alone and source and not doubtful and self._are_only_two(end, other))):
            return Severity.WARNING
        if how == NAMESPACE:
            if not offers and not end.applied and self._is_of_absent_program(end.name, other.name):
                return Severity.INFO if alone else None
            same = loose and end.declared == other.declared
            waits = not offers and (loose or bool(end.applied))
            sure = same or waits or (source and (loose or (offers and alone)))
            sure = sure and not self._are_one_chain(end, self.graph.channels[other.kind, other.name])
            return Severity.WARNING if sure and not doubtful else Severity.INFO if alone or (loose and not private) else None
        if how == WORDS and offers and alone and source and not doubtful:
            return Severity.WARNING
        if not how:
            return Severity.INFO if alone and not doubtful and (source if offers else loose) else None
        return Severity.INFO if alone or (loose and source) else None

    def _is_of_absent_program(self, name: str, other: str) -> bool:
        """Whether ``name``, and not ``other``, lies below the name of a known program that is not started here: that gives it."""
        return any(is_in_library(each, self.graph.launch.dialect) for each in self._namespaces_of_absent(name, other))

    def _is_of_own_program(self, name: str, other: str) -> bool:
        """Whether ``name``, and not ``other``, lies below that of a program of the workspace that is not started here: it was led there."""
        return any(contents(self._view.packages).having(each) for each in self._namespaces_of_absent(name, other))

    def _namespaces_of_absent(self, name: str, other: str) -> set[str]:
        """The namespaces of ``name`` that ``other`` has not, and that are called as no node that is started here."""
        return set(name.split("/")[1:-1]) - set(other.split("/")) - self._started

    def _in_doubt(self, end: Endpoint, other: Endpoint, how: str, doubts: tuple[Possible, ...], level: Severity | None) -> Severity | None:
        """How sure that is of two loose ends beside which there are others that could be at one of them, though nothing says so."""
        if level is None:
            return None
        if how not in (SLIP, NAMESPACE):  # one of the two was led elsewhere
            return (
                level
                if last_part(end) == last_part(other) and bool(end.applied) != bool(other.applied) and self._are_only_ends(end)
                else None
            )
        if how == SLIP:
            return level
        remapped = bool(end.applied) + bool(other.applied)
        meant = remapped == 2 or (remapped == 1 and end.type.partition("/")[0] not in STANDARD)
        sure = meant or self._are_only_ends(end) or (end.declared == other.declared and not any(each.anything for each in doubts))
        return level if sure else Severity.INFO

    def _are_only_ends(self, end: Endpoint) -> bool:
        """Whether no more than two names have the type of ``end``, one on each side, and the type is made for one purpose.

        In another configuration than the default one, a node that has a further one may just be switched off. What nobody publishes and
        no remap leads anywhere does not count beside what a remap does.
        """
        package = end.type.partition("/")[0]
        if package in STANDARD or self.graph.launch.given or len(self._candidates(end.kind, True, end.type)) != 1:
            return False
        takers = self._candidates(end.kind, False, end.type)
        chosen = [each for each in takers if each.offers or not all(self._signs.is_left_private(taker) for taker in each.uses)]
        return len(chosen or takers) == 1

    def _is_source(self, instance: Instance) -> bool:
        """Whether the node only publishes or serves, and takes nothing from others: a driver, a controller, a keyboard."""
        more = any(instance.may_have_more(each) for each in ("subscribers", "clients", "actions"))
        ends = [each for each in instance.endpoints if not each.is_plumbing and each.name not in HUBS]
        return not more and all(each.role in OFFERS for each in ends)

    def _is_connected(self, instance: Instance) -> bool:
        """Whether the node certainly or possibly talks to another one."""
        known = self._connected.get(id(instance))
        if known is None:
            more = any(instance.may_have_more(each) for each in ("publishers", "subscribers", "services", "clients", "actions"))
            known = more or any(self._meets(endpoint) for endpoint in instance.endpoints if not endpoint.is_plumbing)
            self._connected[id(instance)] = known
        return known

    def _meets(self, endpoint: Endpoint) -> bool:
        channel = self.graph.channels[endpoint.kind, endpoint.name]
        if channel.name in HUBS:
            return channel.name in _CONNECTING_HUBS
        gives = endpoint.role in OFFERS
        if any(each.node != endpoint.node for each in (channel.uses if gives else channel.offers)):
            return True
        return bool((self.graph.may_use if gives else self.graph.may_offer)(channel.kind, channel.name, endpoint.type))

    def _candidates(self, kind: str, offers: bool, type_: str) -> list[Channel]:
        if self._by_type is None:
            self._by_type = {}
            for channel in self.graph.channels.values():
                if channel.is_hub or channel.is_plumbing:
                    continue
                for side, ends in ((True, channel.offers), (False, channel.uses)):
                    for known in (*types(ends), *(("",) if any(end.certain for end in ends) else ())):
                        self._by_type.setdefault((channel.kind, side, known), []).append(channel)
        return self._by_type.get((kind, offers, stands_for(type_) if is_known(type_) else ""), [])

    @staticmethod
    def _apart(one: Instance, other: Instance) -> tuple[bool, int, str]:
        at, there = one.node.origin.place, other.node.origin.place
        return at.source is not there.source, abs(at.span.start - there.span.start), other.name


def _are_both_given(end: Endpoint, other: Shown) -> bool:
    """Whether params or remaps give both names, and these have nothing in common: who wrote them both has told them apart."""
    given = [each for each in (end, *other.ends) if each.applied or each.declared != each.declaration.name]
    return end in given and len(given) > 1 and not relation(end.name, other.channel.name)


def last_part(end: Endpoint) -> str:
    """The last part of the name in the code."""
    return end.declared.lstrip("~").rpartition("/")[2]


def _is_plural(left: str, right: str) -> bool:
    return left.rstrip("s") == right.rstrip("s")


def _sources(end: Endpoint) -> tuple[str, ...]:
    """The files of the workspace that the name was read from."""
    return tuple(each["at"].rpartition(":")[0] for each in end.declaration.evidence if "here" in each)
