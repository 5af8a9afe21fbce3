"""Names of what nobody is to read in a file: passwords, tokens, keys."""

from __future__ import annotations

import re

from launchlint.late import late

_SECRET = late(
    r"(?:^|[\W_]|(?<=[a-z])(?=[A-Z]))(?:password|passwd|passphrase|passcode|secret|(?:secret|api|access|auth|private|encryption)_?key|"
    r"(?:(?:auth|access|api|bearer)_?)?token|(pw|pwd|pass|key))$",
    re.IGNORECASE,
)

_LONGEST_WORD = 40
"""More characters than the longest of these words has, with what stands in front of it."""


def is_said_by_name(value: str, name: str) -> bool:
    """Whether ``value`` is one of the words of ``name``, a token: ``ready`` for ``ready_token`` is a word that programs tell each other.

    A password or a key that its name says is one all the same.
    """
    words = re.split(r"[\W_]+", re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name.strip()).lower())
    return words[-1] == "token" and value.strip().lower() in words


def is_secret(name: str, *, variable: bool = False) -> bool:
    """Whether ``name`` ends in a word for a secret.

    Of an environment variable (``variable``) shorter words say so too: a param may be a pulse width, a low pass or the key of a map.
    """
    name = name.strip()
    found = _SECRET.search(name, max(0, len(name) - _LONGEST_WORD))
    return found is not None and (variable or found[1] is None)
