"""How a launch file is entered, by a person or by an include."""

from __future__ import annotations

from launchlint.evaluate.block import Value

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Entering:
    """How a file is entered: its name, namespace, args, and what it inherits that changes its own evaluation.

    ``from_environment`` names the args whose value was made from an environment variable.
    """

    __slots__ = ("arguments", "default_machine", "file", "from_environment", "is_entry", "namespace", "pass_all", "private_above")

    def __init__(
        self, file: str, namespace: str, arguments: dict[str, Value], *, pass_all: bool, private_above: bool,
        default_machine: str | None, is_entry: bool = False, from_environment: frozenset[str] = frozenset(),
    ) -> None:  # fmt: skip
        self.file = file
        self.namespace = namespace
        self.arguments = arguments
        self.pass_all = pass_all
        self.private_above = private_above
        self.default_machine = default_machine
        self.is_entry = is_entry
        self.from_environment = from_environment

    @property
    def key(self) -> tuple[Any, ...]:
        """Equal for two entries that come to the same block."""
        arguments = tuple(
            sorted((name, type(value).__name__, value if isinstance(value, str) else value.text) for name, value in self.arguments.items())
        )
        outside = tuple(sorted(self.from_environment))
        return (self.file, self.namespace, arguments, self.pass_all, self.private_above, self.default_machine, self.is_entry, outside)
