"""Python 2 rewritten so that Python 3's grammar takes it: words and signs only, lines stay where they are.

What differs in grammar: ``print x``, ``exec x``, ``except X, e``, ``raise X, "text"``, backquotes, ``<>``, ``0777``, ``10L``, ``ur""``,
parameters that are tuples, tabs that count as eight columns.
"""

from __future__ import annotations

import re

from launchlint.named_tuple import NamedTuple

_TOKEN = re.compile(
    r"""(?P<blank>[ \t\f]+|\\\r?\n)
    |(?P<comment>\#[^\n]*)
    |(?P<string>[bBuUrR]{0,3}(?:
        \"\"\"(?:[^\\]|\\.)*?(?:\"\"\"|\\?\Z)|'''(?:[^\\]|\\.)*?(?:'''|\\?\Z)|"(?:[^"\\\n]|\\.)*"?|'(?:[^'\\\n]|\\.)*'?
    ))
    |(?P<newline>\n)
    |(?P<number>(?:0[xX][0-9a-fA-F]+|0[bB][01]+|\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)[lLjJ]?)
    |(?P<word>[^\W\d]\w*)
    |(?P<sign><>|>>|.)""",
    re.VERBOSE | re.DOTALL,
)
_MOST_TOKENS = 300_000
_OPENING, _CLOSING = "([{", ")]}"


class _Token(NamedTuple):
    kind: str
    text: str


def rewritten(source: str) -> str:
    """``source`` with what Python 3's grammar refuses spelled its way; what is in order stays as it is."""
    lines = [_untabbed(line) for line in source.replace("\r\n", "\n").replace("\r", "\n").split("\n")]
    result: list[str] = []
    statement: list[_Token] = []
    depth = 0
    in_lambda = False  # a colon belongs to one
    for count, match in enumerate(_TOKEN.finditer("\n".join(lines))):
        if count > _MOST_TOKENS:
            raise ValueError("it is too long")
        token = _Token(match.lastgroup or "", match[0])
        if token.text in _OPENING and token.kind == "sign":
            depth += 1
        elif token.text in _CLOSING and token.kind == "sign":
            depth = max(depth - 1, 0)
        ends = depth == 0 and (token.kind == "newline" or (token.kind == "sign" and token.text in ";:" and not in_lambda))
        if ends:
            result += [*_statement(statement), token.text]
            statement = []
        else:
            statement.append(token)
        if ends or token.text == ":":
            in_lambda = False
        elif token.text == "lambda":
            in_lambda = True
    result += _statement(statement)
    return "".join(result)


def _untabbed(line: str) -> str:
    body = line.lstrip(" \t")
    indent = line[: len(line) - len(body)]
    return indent.expandtabs(8) + body if "\t" in indent else line


def _statement(tokens: list[_Token]) -> list[str]:
    """The texts of one simple statement, or of the head of a block, rewritten."""
    texts = [_token(token) for token in tokens]
    solid = [at for at, token in enumerate(tokens) if token.kind not in ("blank", "comment", "newline")]
    if not solid:
        return texts
    first = tokens[solid[0]].text
    end = solid[-1] + 1
    if "`" in texts:
        _backquotes(texts)
    if first == "print" and not _is_call_or_name(tokens, solid):
        _print(tokens, texts, solid, end)
    elif first == "exec" and len(solid) > 1 and tokens[solid[1]].text not in ("(", "=", "."):
        texts[solid[0]] = "exec("
        texts[end - 1] += ")"
    elif first == "except":
        comma = _comma(tokens, solid)
        if comma is not None:
            texts[comma] = " as"
    elif first == "raise":
        comma = _comma(tokens, solid)
        if comma is not None:
            texts[comma] = "("
            texts[end - 1] += ")"
    elif first == "def" or "lambda" in texts:
        _tuple_parameters(tokens, texts, solid, first)
    return texts


def _token(token: _Token) -> str:
    if token.kind == "number":
        text = token.text.rstrip("lL") if token.text[-1] in "lL" else token.text
        return "0o" + (text.lstrip("0") or "0") if re.fullmatch(r"0\d+", text) and not re.search("[89]", text) else text
    if token.kind == "string" and token.text[:2].lower() == "ur":
        return token.text[1:]
    return "!=" if token.text == "<>" else token.text


def _is_call_or_name(tokens: list[_Token], solid: list[int]) -> bool:
    """Whether ``print`` is used as Python 3 has it: ``print(…)`` and nothing behind it, or as a name."""
    if len(solid) == 1:
        return False
    following = tokens[solid[1]].text
    if following in ("=", ".", ","):
        return True
    if following != "(":
        return False
    depth = 0
    for number, at in enumerate(solid[1:], 1):
        depth += (tokens[at].text in _OPENING) - (tokens[at].text in _CLOSING) if tokens[at].kind == "sign" else 0
        if depth == 0:
            return number == len(solid) - 1
    return True


def _print(tokens: list[_Token], texts: list[str], solid: list[int], end: int) -> None:
    texts[solid[0]] = "print("
    if len(solid) > 1 and tokens[solid[1]].text == ">>":
        texts[solid[1]] = ""
    texts[end - 1] += ")"


def _comma(tokens: list[_Token], solid: list[int]) -> int | None:
    """The first comma that is in no bracket."""
    depth = 0
    for at in solid:
        if tokens[at].kind == "sign":
            depth += (tokens[at].text in _OPENING) - (tokens[at].text in _CLOSING)
            if tokens[at].text == "," and depth == 0:
                return at
    return None


def _backquotes(texts: list[str]) -> None:
    opening = True
    for at, text in enumerate(texts):
        if text == "`":
            texts[at] = "repr(" if opening else ")"
            opening = not opening


def _tuple_parameters(tokens: list[_Token], texts: list[str], solid: list[int], first: str) -> None:
    """A parameter ``(a, b)`` becomes one parameter: its names are then not known in the body."""
    start = next((n for n, at in enumerate(solid) if tokens[at].text == ("(" if first == "def" else "lambda")), None)
    if start is None:
        return
    depth = 0
    previous = tokens[solid[start]].text
    for at in solid[start + 1 :]:
        text = tokens[at].text
        if text == "(" and depth == 0 and previous in ("(", "lambda", ","):
            texts[at], depth = "_tuple", 1
        elif depth:
            depth += (text == "(") - (text == ")")
            texts[at] = ""
        elif text in ("=", ":", ")"):
            return
        previous = text
