"""The names an expression can use besides args, in the order roslaunch looks them up (roslaunch.substitution_args._DictWrapper)."""

from __future__ import annotations

from launchlint.evaluate.expression.names import MATH

#: Handed in by roslaunch with the context: they go before everything else.
CONTEXT_FUNCTIONS = frozenset({"anon", "arg", "dirname", "env", "find", "optenv"})

#: The words that roslaunch adds as truth values.
TRUTH = {"true": True, "false": False, "True": True, "False": False}

#: What goes before an arg of the same name: an arg called like a name of ``math`` can only be read with ``arg('…')``.
RESERVED = CONTEXT_FUNCTIONS | TRUTH.keys() | MATH
