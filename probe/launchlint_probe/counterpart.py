"""What a node talks to while it is probed, whatever the middleware: it says what the node does, and gives the node what it waits for."""

from typing import Any, Dict, List, Optional, Set, Tuple

Name = Tuple[str, str]
"""A kind of name (``publishers``, ``subscribers``, ``services``, ``clients``) and the name itself."""


class Known:
    """What diagnosis needs to know of what a node did.

    Args:
        contacted: it was in touch with its counterpart.
        registered: it made itself known as a node.
        has_names: it has topics or services of its own, or looked for a service.
        count: of topics and services.
        overflow: it makes up names without end.
        unanswered: services it looked for that could not be given to it, as the library spells them.
        untold: topics on which no message could be sent to it, likewise.
        missed: params it asks for again and again that are not set, likewise.
        silence: what to say of a node that never got in touch.
        misses_nothing: a node cannot have been in touch without that being known, however soon it ended.
    """

    def __init__(
        self,
        contacted: bool,
        registered: bool,
        has_names: bool,
        count: int,
        overflow: bool,
        unanswered: List[str],
        untold: List[str],
        missed: List[str],
        silence: str,
        misses_nothing: bool,
    ) -> None:
        self.contacted = contacted
        self.registered = registered
        self.has_names = has_names
        self.count = count
        self.overflow = overflow
        self.unanswered = unanswered
        self.untold = untold
        self.missed = missed
        self.silence = silence
        self.misses_nothing = misses_nothing


class Seen:
    """What watching a node has shown.

    ``start`` are its names when it was ready, ``woken`` those when its publishers had been listened to, ``served`` those when it had been
    given what it waits for; each None where it did not come so far. ``ended``: it ended by itself. ``sent``: how much it had printed when
    it was sent messages, in bytes; None where it was not. ``excess``: code and words where it took more than it may. ``reached``: all names
    that were expected came, so that nobody waited any longer.
    """

    def __init__(self) -> None:
        self.start: Optional[Set[Name]] = None
        self.woken: Optional[Set[Name]] = None
        self.ended = False
        self.served: Optional[Set[Name]] = None
        self.sent: Optional[int] = None
        self.excess: Optional[Tuple[str, str]] = None
        self.reached = False


class Counterpart:
    """Of one node, from before its start until after its end."""

    # -- what the node does ------------------------------------------------------------------------------------

    def news(self) -> float:
        """When something new was learnt last, in seconds of the monotonic clock."""
        raise NotImplementedError

    def touch(self) -> None:
        """The node was given something: whatever follows from that is new."""
        raise NotImplementedError

    def names(self) -> Set[Name]:
        """All topics and services so far."""
        raise NotImplementedError

    def is_there(self) -> bool:
        """Whether the node has been in touch."""
        raise NotImplementedError

    def has_registered(self) -> bool:
        """Whether it has topics or services of its own, not only those that every node has."""
        raise NotImplementedError

    def asks(self) -> bool:
        """Whether it has asked for a service that it may wait for."""
        raise NotImplementedError

    def overflows(self) -> bool:
        """Whether it makes up names without end."""
        raise NotImplementedError

    def refusal(self) -> Optional[Tuple[str, str]]:
        """Code and words where there is no sense in going on; None where all is well."""
        return None

    # -- what it is given --------------------------------------------------------------------------------------

    def advance(self) -> bool:
        """Lead the node into its next state, where it has states. Returns whether there was one."""
        return False

    def has_unheard(self) -> bool:
        """Whether it publishes what nobody listens to yet."""
        raise NotImplementedError

    def listen(self) -> bool:
        """Listen to what it publishes. Returns whether there was anything new."""
        raise NotImplementedError

    def is_settled(self) -> bool:
        """Whether all that is listened to has answered."""
        raise NotImplementedError

    def serve(self) -> bool:
        """Offer what it waits for. Returns whether there was anything."""
        raise NotImplementedError

    def send(self) -> bool:
        """Send a message on each topic that it hears and nobody publishes. Returns whether there was any."""
        raise NotImplementedError

    # -- what is made of it ------------------------------------------------------------------------------------

    def environment(self, directory: str) -> Dict[str, str]:
        """Variables that lead the node here; ``directory`` is its own."""
        raise NotImplementedError

    def command(self, directory: str) -> List[str]:
        """How the node is started."""
        raise NotImplementedError

    def harvest(self, seen: Seen) -> None:
        """Ask, while it still runs, what only a running node can tell."""
        raise NotImplementedError

    def interface(self, seen: Seen) -> Dict[str, Any]:
        """Keys of the record: ``interface`` as the library format has it but for the evidence, and whatever else is known."""
        raise NotImplementedError

    def known(self) -> Known:
        """What diagnosis needs."""
        raise NotImplementedError

    def doubts(self) -> List[Dict[str, str]]:
        """Problems that only this counterpart knows of: code and detail each."""
        return []

    def close(self) -> None:
        """Hang up, and end whatever was started."""
        raise NotImplementedError
