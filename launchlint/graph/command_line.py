"""What a process gets on its command line: arguments, remappings and private params (``args`` of a node and its remaps)."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.graph.names import Rule
from launchlint.library.template import Undetermined
from launchlint.model import Node
from launchlint.named_tuple import NamedTuple
from launchlint.words import split_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class CommandLine(NamedTuple):
    """``words`` are the arguments without what is meant for ROS: text, or what is known of it.

    ``known`` is false where ``args`` goes on with something that is not known: any number of words. ``namespace`` is what ``__ns:=`` says,
    else None. ``open`` are remappings that are not known: patterns of source and target, ``*`` for anything.
    """

    words: tuple[str | Undetermined, ...]
    rules: tuple[Rule, ...]
    params: Mapping[str, Any]
    known: bool
    namespace: str | None = None
    open: tuple[tuple[str, str], ...] = ()


def command_line(node: Node) -> CommandLine:
    """The command line of ``node``: first what ``args`` says, then its remaps (roslaunch.node_args.create_local_process_args).

    A word with ``:=`` is no argument: ``a:=b`` is a remapping, ``_p:=5`` sets the private param ``~p`` (ros::init, ros::param::init,
    rosgraph.names.load_mappings). Of the words with two underscores only ``__ns`` can say something here: roslaunch gives the name last.

    Of ``args`` that are not known in every part, a word that is not known at all may be several words, or none: what follows has no place.
    """
    unknown = not node.knows("arguments")
    known = True
    unknown_remaps = [remap.patterns for remap in node.open_remaps if remap.patterns is not None]
    try:
        given = split_words(node.patterns.get("arguments", "*") if unknown else node.arguments)
    except ValueError:
        return CommandLine((), _from_launch(node), {}, False, open=tuple(unknown_remaps))
    words: list[str | Undetermined] = []
    rules: list[Rule] = []
    params: dict[str, Any] = {}
    namespace = None
    for word in given:
        source, sign, target = word.partition(":=")
        hidden = unknown and "*" in word
        if not sign:
            known = known and not (hidden and word == "*")
            if known:
                words.append(Undetermined(word) if hidden else word)
        elif source.startswith("__"):
            namespace = target if source == "__ns" else namespace
        elif source.startswith("_"):
            params[source[1:]] = Undetermined(target) if hidden else plain_value(target)
        elif hidden:
            unknown_remaps.append((source, target))
        elif source and target:
            rules.append(Rule(source.strip(), target.strip()))
    return CommandLine(tuple(words), (*rules, *_from_launch(node)), params, known, namespace, tuple(unknown_remaps))


def _from_launch(node: Node) -> tuple[Rule, ...]:
    return tuple(Rule(remap.source, remap.target, remap) for remap in node.remaps)


def plain_value(text: str) -> Any:
    """A param given as text: a whole number, a number, a truth value, or text (ros::param::init, roslaunch's own guess)."""
    if text in ("true", "True", "TRUE", "false", "False", "FALSE"):
        return text.lower() == "true"
    whole = text.lstrip("+-")
    if whole.isdecimal():
        return int(text) if len(text) - len(whole) <= 1 and text.isascii() else text
    try:
        return float(text) if text.isascii() and "_" not in text and text == text.strip() else text
    except ValueError:
        return text


def split_options(
    words: tuple[str | Undetermined, ...], options: Mapping[str, int] | None
) -> tuple[tuple[str | Undetermined, ...], Mapping[str, Any]]:
    """The positional words, and the options with their values (True for one without, its first value, else a list).

    Without ``options`` every word is positional. With them an option that is not listed takes no value; ``--x=v`` gives a value,
    ``--`` ends the options, and what looks like a negative number is no option.
    """
    if options is None:
        return words, {}
    positional: list[str | Undetermined] = []
    found: dict[str, Any] = {}
    at = 0
    while at < len(words):
        word = words[at]
        at += 1
        if isinstance(word, Undetermined):
            positional.append(word)
            continue
        name, sign, value = word.partition("=")
        if word == "--":
            positional.extend(words[at:])
            break
        if word in options:
            values = words[at : at + options[word]]
            at += options[word]
            found[word] = True if not options[word] else values[0] if len(values) == 1 else list(values)
        elif sign and name in options:
            found[name] = value
        elif word.startswith("-") and len(word) > 1 and not word[1].isdecimal() and word[1] != ".":
            found[word] = True
        else:
            positional.append(word)
    return tuple(positional), found
