"""What its launcher makes of one entry file: the one verdict that every output gives."""

from __future__ import annotations

from collections.abc import Iterable

from launchlint.named_tuple import NamedTuple
from launchlint.plural import counted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Literal

MOST_NAMED = 3
"""What is missing is named up to so many times in a sentence."""


class Refusal(NamedTuple):
    """Args with which its launcher refuses an entry file; ``rule`` (its ID) and ``reason`` say why."""

    arguments: tuple[tuple[str, str], ...]
    rule: str
    reason: str

    @property
    def given(self) -> str:
        """The args as on the command line."""
        return " ".join(f"{name}:={value}" for name, value in self.arguments)


class Verdict(NamedTuple):
    """``word`` says what becomes of the file as it stands; ``rule`` (its ID) and ``reason`` say why the launcher refuses it, or stops here.

    ``missing`` is what somebody who starts the file would have and this check has not: a package, an arg of the command line, a variable of
    the machine, a file that is made later. ``elsewhere`` are the other configurations that it refuses, each for a reason of its own;
    none where it refuses the file as it stands, and none where only that was looked at. ``launcher`` is the command that starts the file.
    """

    word: Literal["loads", "refused", "cannot be told"]
    rule: str = ""
    reason: str = ""
    missing: tuple[str, ...] = ()
    elsewhere: tuple[Refusal, ...] = ()
    launcher: str = "roslaunch"

    @property
    def sentence(self) -> str:
        """The verdict in words, without a full stop."""
        return "; ".join(filter(None, (self._as_it_stands, self.with_args)))

    @property
    def notice(self) -> str:
        """The sentence; empty where no configuration is known that does not load."""
        return "" if self.word == "loads" and not self.elsewhere else self.sentence

    @property
    def brief(self) -> str:
        """The notice where the findings stand beside it, so that it need not repeat why the file is refused."""
        if self.word == "refused":
            return f"refused by {self.launcher}"
        untold = self._as_it_stands if self.word == "cannot be told" else ""
        return "; ".join(
            filter(None, (untold, f"refused by {self.launcher} with {self.elsewhere[0].given}{self._others}" if self.elsewhere else ""))
        )

    @property
    def why(self) -> str:
        """Why it does not load as it stands, in words; empty where it does."""
        if not self.missing:
            return self.reason
        named = self.missing[:MOST_NAMED]
        more = [f"{len(self.missing) - len(named)} more"] if len(self.missing) > len(named) else []
        words = [*named, *more]
        listed = " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
        return f"it needs {listed}"

    @property
    def with_args(self) -> str:
        """Which other configuration is refused, and why: ``refused with sim:=true: two nodes are named /a``; empty for none."""
        return f"refused with {self.elsewhere[0].given}: {self.elsewhere[0].reason}{self._others}" if self.elsewhere else ""

    def as_object(self) -> dict[str, Any]:
        """The verdict as JSON has it."""
        others = [{"configuration": dict(each.arguments), "rule": each.rule, "reason": each.reason} for each in self.elsewhere]
        return {"word": self.word, "rule": self.rule, "reason": self.reason, "missing": list(self.missing), "elsewhere": others}

    def beside(self, others: Iterable[tuple[tuple[tuple[str, str], ...], Verdict]]) -> Verdict:
        """The verdict on the file as it stands, joined with those on other configurations by their args."""
        if self.word == "refused":
            return self
        reasons: dict[tuple[str, str], Refusal] = {}
        for arguments, verdict in others:
            if verdict.word == "refused":
                reasons.setdefault((verdict.rule, verdict.reason), Refusal(arguments, verdict.rule, verdict.reason))
        return self._replace(elsewhere=tuple(reasons.values()))

    @property
    def _as_it_stands(self) -> str:
        if self.word == "refused":
            return f"refused by {self.launcher}: {self.reason}"
        return f"cannot be told: {self.why}" if self.word == "cannot be told" else "loads"

    @property
    def _others(self) -> str:
        more = len(self.elsewhere) - 1
        return f"; with other args for {counted(more, 'more reason')}" if more else ""


LOADS = Verdict("loads")
