"""``argparse`` and ``optparse``: positional arguments become ``{arg:N}``, options ``{option:--x|default}``."""

from __future__ import annotations

from launchlint.extract.python.arguments import Call, number_or_none
from launchlint.python.text import ANY, template, text
from launchlint.python.values import MISSING, UNKNOWN, Argv, Handle, Seq, Value, alternatives

_FLAGS = ("store_true", "store_false", "store_const", "append_const", "count", "help", "version")
MOST_ARGUMENTS = 200


def _parser(made: Call) -> Value:
    return Handle("parser", {"arguments": []})


def _add(receiver: Handle, made: Call) -> Value:
    words = [each for each in made.positional if isinstance(each, str)]
    known = _declared(receiver)
    if words and len(known) < MOST_ARGUMENTS:
        made.run.store(receiver.state, "arguments", [*known, (tuple(words), dict(made.keywords))])
    return UNKNOWN


def _declared(receiver: Handle) -> list[tuple[tuple[str, ...], dict[str, Value]]]:
    """The arguments that were added: options of any way through an ``if``, and positional ones where all ways have the same, else one
    that stands for some number of them.
    """
    ways = [value for _, value in alternatives(receiver.state["arguments"])]
    if len(ways) == 1:
        only: list[tuple[tuple[str, ...], dict[str, Value]]] = ways[0]
        return only
    positional = [[each for each in way if not each[0][0].startswith("-")] for way in ways]
    options = {each[0]: each for way in ways for each in way if each[0][0].startswith("-")}
    same = all(each == positional[0] for each in positional)
    return [*(positional[0] if same else [(("?",), {"nargs": "*"})]), *options.values()]


def _group(receiver: Handle, made: Call) -> Value:
    return receiver


def _defaults(receiver: Handle, made: Call) -> Value:
    made.run.escape([*made.positional, *made.keywords.values()], "start")
    return None


def _subparsers(receiver: Handle, made: Call) -> Value:
    return Handle("subparsers", {})


def _sub_parser(receiver: Handle, made: Call) -> Value:
    return Handle("parser", {"arguments": []})


def _parsed(receiver: Handle, made: Call) -> Value:
    """``parse_args()`` of argparse: an object with an attribute for each argument."""
    attributes: dict[object, Value] = {}
    position = _first(made)
    for words, keywords in _declared(receiver):
        if words[0].startswith("-"):
            name = next((word for word in words if word.startswith("--")), words[0])
            attributes["attribute", _dest(keywords, name)] = _option(made, words, keywords)
            continue
        count = keywords.get("nargs", MISSING)
        value: Value = UNKNOWN
        if position is not None and position < 1:
            value = UNKNOWN
        elif position is not None and count in (MISSING, None):
            value = text(f"{{arg:{position}}}")
        elif position is not None and count == "?":
            value = _with_default("arg", str(position), keywords.get("default", None))
        elif position is not None and isinstance(count, int) and 0 < count < 100:
            value = Seq([text(f"{{arg:{position + at}}}") for at in range(count)])
            position += count - 1
        countable = count in (MISSING, None, "?") or isinstance(count, int)
        position = position + 1 if position is not None and countable else None
        attributes["attribute", _dest(keywords, words[0])] = value
    return Handle("plain", attributes)


def _parsed_known(receiver: Handle, made: Call) -> Value:
    return Seq([_parsed(receiver, made), UNKNOWN])


def _parsed_options(receiver: Handle, made: Call) -> Value:
    """``parse_args()`` of optparse: options, and what is left of the arguments."""
    attributes: dict[object, Value] = {}
    for words, keywords in _declared(receiver):
        name = next((word for word in words if word.startswith("--")), words[0])
        attributes["attribute", _dest(keywords, name)] = _option(made, words, keywords)
    first = _first(made)
    return Seq([Handle("plain", attributes), UNKNOWN if first is None else Argv(first)])


def _first(made: Call) -> int | None:
    """Which argument of the command line the parser sees as its first."""
    given = made.get(0, "args", None)
    if given is None:
        return 1
    return given.offset if isinstance(given, Argv) else None


def _dest(keywords: dict[str, Value], name: str) -> str:
    dest = keywords.get("dest")
    return dest if isinstance(dest, str) else name.lstrip("-").replace("-", "_")


def _option(made: Call, words: tuple[str, ...], keywords: dict[str, Value]) -> Value:
    action = keywords.get("action", "store")
    takes = 0 if action in _FLAGS else 1
    count = number_or_none(keywords.get("nargs"))
    for word in words[:4]:
        if len(made.run.options) < MOST_ARGUMENTS:
            made.run.options[word] = min(count if count is not None and takes else takes, 100)
    if takes == 0 or count is not None or keywords.get("nargs") in ("*", "+", "?") or action == "append":
        return UNKNOWN
    value: Value = keywords.get("default")
    for word in words[:3]:
        value = _with_default("option", word, value)
    return value


def _with_default(kind: str, key: str, default: Value) -> Value:
    if any(char in key for char in "|{}") or len(key) > 60:
        return UNKNOWN
    if default is None:
        return text(f"{{{kind}:{key}}}")
    spelled = template(default)
    return text(f"{{{kind}:{key}|{ANY if '}}' in spelled.replace('{any}', '') and len(spelled) > 200 else spelled}}}")


HANDLERS = {
    "argparse.ArgumentParser": _parser,
    "optparse.OptionParser": lambda made: Handle("option parser", {"arguments": []}),
}

METHODS = {
    ("parser", "add_argument"): _add,
    ("parser", "add_argument_group"): _group,
    ("parser", "add_mutually_exclusive_group"): _group,
    ("parser", "set_defaults"): _defaults,
    ("parser", "add_subparsers"): _subparsers,
    ("subparsers", "add_parser"): _sub_parser,
    ("parser", "parse_args"): _parsed,
    ("parser", "parse_known_args"): _parsed_known,
    ("option parser", "add_option"): _add,
    ("option parser", "add_option_group"): _group,
    ("option parser", "parse_args"): _parsed_options,
}
