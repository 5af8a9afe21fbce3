"""What roslaunch makes of one entry file as it would be started: the one verdict that every output gives."""

from __future__ import annotations

from typing import NamedTuple

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Literal

MOST_NAMED = 3
"""What is missing is named up to so many times in a sentence."""


class Verdict(NamedTuple):
    """``word`` says it; ``rule`` (its ID) and ``reason`` say why roslaunch refuses the file, or stops here.

    ``missing`` is what somebody who starts the file would have and this check has not: a package, an arg of the command line, a variable of
    the machine, a file that is made later.
    """

    word: Literal["loads", "refused", "cannot be told"]
    rule: str = ""
    reason: str = ""
    missing: tuple[str, ...] = ()

    @property
    def sentence(self) -> str:
        """The verdict in words, without a full stop."""
        if self.word == "refused":
            return f"refused by roslaunch: {self.reason}"
        return f"cannot be told: {self.why}" if self.word == "cannot be told" else "loads"

    @property
    def why(self) -> str:
        """Why it does not load, in words; empty where it does."""
        if not self.missing:
            return self.reason
        named = self.missing[:MOST_NAMED]
        more = [f"{len(self.missing) - len(named)} more"] if len(self.missing) > len(named) else []
        words = [*named, *more]
        listed = " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
        return f"it needs {listed}"

    def as_object(self) -> dict[str, Any]:
        """The verdict as JSON has it."""
        return {"word": self.word, "rule": self.rule, "reason": self.reason, "missing": list(self.missing)}


LOADS = Verdict("loads")
