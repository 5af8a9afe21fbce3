"""Functions of Python's library that look at nothing but the values they are given, and its constants."""

from __future__ import annotations

import math
import shlex
import textwrap
from collections.abc import Callable, Mapping
from itertools import chain, islice, product
from typing import Any

from launchlint.python.failures import of_python
from launchlint.python.plain import NotPlain, plain, value_of
from launchlint.python.values import MISSING, MOST_EXACT, Seq, Value

CONSTANTS: Mapping[str, Value] = {
    "math.pi": math.pi,
    "math.e": math.e,
    "math.inf": math.inf,
    "math.tau": math.tau,
    "os.name": "posix",
    "os.sep": "/",
    "os.path.sep": "/",
    "os.linesep": "\n",
    "os.pathsep": ":",
    "sys.platform": "linux",
}
_LONGEST = 10_000
_MATH = """acos asin atan atan2 ceil copysign cos degrees dist exp fabs floor fmod hypot isclose isfinite isinf isnan log log10 log2 radians
    sin sqrt tan trunc""".split()
_PURE: Mapping[str, Callable[..., Any]] = {
    **{f"math.{name}": getattr(math, name) for name in _MATH},
    "shlex.split": shlex.split,
    "shlex.quote": shlex.quote,
    "textwrap.dedent": textwrap.dedent,
}


def call(name: str, positional: list[Value], keywords: Mapping[str, Value]) -> Value:
    """What a function gives; MISSING where it is not known. Raises Raised."""
    if name in ("itertools.chain", "itertools.product", "itertools.chain.from_iterable"):
        return _combined(name, positional, keywords)
    function = _PURE.get(name)
    if function is None:
        return MISSING
    try:
        words = [plain(each) for each in positional]
        named = {key: plain(value) for key, value in keywords.items()}
        if any(isinstance(each, str) and len(each) > _LONGEST for each in (*words, *named.values())):
            return MISSING
        return value_of(function(*words, **named))
    except NotPlain:
        return MISSING
    except (ArithmeticError, TypeError, ValueError) as error:
        raise of_python(error) from None


def _combined(name: str, positional: list[Value], keywords: Mapping[str, Value]) -> Value:
    lists = positional
    if name == "itertools.chain.from_iterable" and len(positional) == 1 and isinstance(positional[0], Seq) and positional[0].is_sure:
        lists = positional[0].items
    kinds = ("list", "tuple", "range", "view")
    if keywords or not all(isinstance(each, Seq) and each.is_sure and each.kind in kinds for each in lists):
        return MISSING
    items = [each.items for each in lists]
    if name != "itertools.product":
        return Seq(list(islice(chain(*items), MOST_EXACT + 1)), kind="iterator")
    rows = list(islice(product(*items), MOST_EXACT + 1))
    return Seq([Seq(list(each), is_tuple=True) for each in rows], kind="iterator")
