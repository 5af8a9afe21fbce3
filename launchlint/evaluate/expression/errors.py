"""How an expression fails."""

from __future__ import annotations


class UnknownValue(Exception):
    """The value cannot be known without running something, or lies beyond our bounds: never an error of the file.

    ``reason`` says in plain words why.
    """

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


class ExpressionError(Exception):
    """The launcher itself would fail on the expression.

    ``message`` is plain words, with Python's own at its end; ``start`` and ``end`` are code points in the text that was evaluated. ``kind``
    is the name of the exception that it meets (``NameError``, …). ``undefined_arg`` and ``unset_env`` name what was asked for
    and is not there, where that is the reason.
    """

    def __init__(
        self, message: str, start: int, end: int, kind: str = "", undefined_arg: str | None = None, unset_env: str | None = None
    ) -> None:
        super().__init__(message)
        self.message = message
        self.start = start
        self.end = end
        self.kind = kind
        self.undefined_arg = undefined_arg
        self.unset_env = unset_env
