"""A command line as launch splits it: text into words as a shell does, what is substituted never."""

from __future__ import annotations

from launchlint.source import Origin
from launchlint.syntax.ros2.description import Substitution, Text
from launchlint.syntax.ros2.problems import OpenQuote
from launchlint.words import split_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.problem import Problem


def command_line(text: Text, tag: str, attribute: str, problems: list[Problem]) -> tuple[Text, ...]:
    """The words of ``text``; a quote that is not closed is put to ``problems``.

    Every stretch of text between substitutions is split on its own, one of blanks alone ends a word even where none has begun. Source:
    ``launch.actions.ExecuteProcess._parse_cmdline``.
    """
    words: list[Text] = []
    word: list[str | Substitution] = []

    def end() -> None:
        words.append(Text(tuple(word), text.place))
        word.clear()

    for piece in text.pieces or ("",):
        if isinstance(piece, Substitution):
            word.append(piece)
            continue
        try:
            tokens = split_words(piece)
        except ValueError as error:
            problems.append(OpenQuote(origin=Origin(text.place), refused=True, tag=tag, attribute=attribute, reason=str(error)))
            tokens = piece.split()
        if not tokens:
            end()
            continue
        if piece[0].isspace() and word:
            end()
        word.append(tokens[0])
        if len(tokens) > 1:
            end()
            words.extend(Text((each,), text.place) for each in tokens[1:-1])
            word.append(tokens[-1])
        if piece[-1].isspace():
            end()
    if word:
        end()
    return tuple(words)
