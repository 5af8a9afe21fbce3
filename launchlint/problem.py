"""What the lower rooms noticed: facts, not yet words.

The syntax and evaluation rooms do not know any rule. Where roslaunch would stop, warn or silently
do something else, they record a :class:`Problem`: one class for each kind, with a place, and
the facts a rule needs for its message as fields. One rule turns one kind (or a few) into findings.

The classes stand where they are recorded: :mod:`launchlint.syntax.problems` and :mod:`launchlint.evaluate.problems`.
"""

from __future__ import annotations

from launchlint.source import Origin, Place

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from typing_extensions import Self, dataclass_transform

    @dataclass_transform(kw_only_default=True, frozen_default=True)
    class _Record:
        """Its subclasses are frozen dataclasses to type checkers; made by hand, since those of the standard library take long to make."""
else:
    _Record = object


class Problem(_Record):
    """One noticed fact; what the fields of its kind mean is said there.

    ``refused`` says that roslaunch refuses to load (or launch) the file because of it; ``related`` are further places with a short label
    each. ``assumed`` says that it stands under a condition whose value is unknown, so that it may never come to pass.
    """

    origin: Origin
    refused: bool = False
    related: tuple[tuple[Place, str], ...] = ()
    assumed: bool = False

    def __init__(self, **fields: Any) -> None:
        object.__setattr__(self, "__dict__", fields)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} does not change")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in vars(self).items())})"

    @property
    def place(self) -> Place:
        """Where it is written."""
        return self.origin.place

    @property
    def lacks(self) -> tuple[str, str] | None:
        """What is not here and may be elsewhere, so that the launcher stops: what kind of thing, and its name; None where it is no lack."""
        return None

    @property
    def kind(self) -> str:
        """What it is, in words: ``package-not-found`` for a ``PackageNotFound``."""
        return "".join(f"-{letter.lower()}" if letter.isupper() else letter for letter in type(self).__name__)[1:]

    def but(self, *, origin: Origin | None = None, refused: bool | None = None, assumed: bool | None = None) -> Self:
        """The same, with what is given changed."""
        changes = {"origin": origin, "refused": refused, "assumed": assumed}
        return type(self)(**vars(self) | {name: value for name, value in changes.items() if value is not None})
