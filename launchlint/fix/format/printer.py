"""The normal form: tokens are printed again, with white space that follows from what they are."""

from __future__ import annotations

from launchlint.fix.format.comments import moved, width_of
from launchlint.fix.format.directives import regions
from launchlint.fix.format.start_tag import attributes_of, start_tag
from launchlint.fix.format.style import Style
from launchlint.fix.format.tables import in_columns
from launchlint.fix.format.tokens import SPACE, Token, tokens
from launchlint.fix.format.yaml_block import indented
from launchlint.named_tuple import NamedTuple

MOST_ADDED = 1 << 20
MOST_TIMES = 4
"""A normal form may have this many times the characters of what was written, and :data:`MOST_ADDED` more.

Indentation of thousands of levels is nothing that people write.
"""
_LOOKED_BACK = 4_000
"""Characters of a line that are looked at to say in which column a comment stands."""


class TooLarge(Exception):
    """The normal form would be far larger than what was written."""


def printed(text: str, style: Style) -> str:
    """The normal form of a well-formed document; line ends are LF before and after.

    Raises:
        TooLarge: it would be far larger than the text.
        ValueError: the text is not well-formed.
    """
    return _Printer(text, style).run()


class _Trailing(NamedTuple):
    """A comment behind something else: the line and the column where it is printed, the number of the blank before it among the pieces,
    and the column in which it was written.
    """

    line: int
    column: int
    piece: int
    written: int


class _Printer:
    """Goes through the tokens once, without recursion: elements may stand inside each other a thousand deep."""

    def __init__(self, text: str, style: Style) -> None:
        self._text = text
        self._style = style
        self._tokens = tokens(text)
        self._off = regions(self._tokens)
        self._tables = in_columns(text, self._tokens, style)
        self._pieces: list[str] = []
        self._room = MOST_TIMES * len(text) + MOST_ADDED
        self._line = 0
        self._column = 0
        self._depth = 0
        self._gap = ""  # white space between what was printed last and what comes next
        self._first = True  # nothing has been printed yet inside the present element
        self._as_written = False  # what was printed last stays as it is, with the white space at its end
        self._trailing: list[_Trailing] = []

    def run(self) -> str:
        number = 0
        while number < len(self._tokens):
            number = self._print(number)
        self._align()
        result = "".join(self._pieces)
        return result if result.endswith("\n") else result + "\n"

    def _print(self, number: int) -> int:
        """Print the token with this number, or the whole element. Returns the number of the next token."""
        token = self._tokens[number]
        match token.kind:
            case "text":
                self._print_text(token)
            case "comment":
                self._print_beside(token.text, token.offset, movable=True)
            case "cdata" | "instruction" | "doctype":
                self._print_beside(token.text, token.offset, movable=False)
            case "start":
                number = self._print_element(number)
            case "empty":
                self._begin_line()
                in_table = self._tables.get(number)
                self._write(in_table or start_tag(token, closed=True, style=self._style, column=self._column))
            case "end":
                self._depth -= 1
                self._first = self._depth > 0  # a blank line before an end tag only where it is that of the document element
                self._begin_line()
                self._write(f"</{token.name}>")
        off = self._off.get(number)
        if off is None:
            return number + 1
        self._write(self._text[token.offset + len(token.text) : self._offset(off)])
        self._gap = ""
        self._as_written = True
        return off

    def _print_element(self, number: int) -> int:
        """Print a start tag, and all up to the end tag where nothing in between is to be changed. Returns the number of the last token."""
        start = self._tokens[number]
        stays = self._stays(number)
        empty = not stays and self._is_empty(number)
        self._begin_line()
        self._write(start_tag(start, closed=empty, style=self._style, column=self._column))
        if stays:
            self._write(f"{self._inside(number)}</{start.name}>")
        if stays or empty:
            return start.partner
        self._depth += 1
        self._first = self._depth > 1
        return number

    def _inside(self, number: int) -> str:
        """All between the tags of the element that starts here and stays as it is; YAML alone moves with its element."""
        start = self._tokens[number]
        text = self._text[self._offset(number + 1) : self._offset(start.partner)]
        if start.name != "rosparam" or start.partner != number + 2 or self._tokens[number + 1].kind != "text" or "xml:space" in start.text:
            return text
        depth, indent = self._depth, self._style.indent
        return indented(text, (depth + 1) * indent, depth * indent)

    def _stays(self, number: int) -> bool:
        """Whether white space means something in the element that starts here: YAML, text alone, and what ``xml:space`` says."""
        start = self._tokens[number]
        if start.name.lower() == "rosparam":
            return start.partner > number + 1
        if "xml:space" in start.text and any((each.name, each.value) == ("xml:space", "preserve") for each in attributes_of(start)):
            return True
        filled = False
        for between in range(number + 1, start.partner):
            if self._tokens[between].kind not in ("text", "cdata"):
                return False
            filled = filled or not self._is_blank(between)
        return filled

    def _print_text(self, token: Token) -> None:
        """Print stray text line by line; white space alone only tells lines and blank lines apart."""
        offset = token.offset
        for number, line in enumerate(token.text.split("\n")):
            if number:
                self._gap += "\n"
            words = line.strip(SPACE)
            if words:
                self._print_beside(words, offset + line.index(words), movable=False)
            offset += len(line) + 1

    def _print_beside(self, text: str, offset: int, *, movable: bool) -> None:
        """Print what may stand behind something else in its line, as a comment; ``offset`` is its place in the source."""
        written = self._written_column(offset)
        if self._pieces and "\n" not in self._gap and not self._as_written:
            if "\n" not in text and not (self._trailing and self._trailing[-1].line == self._line):
                self._trailing.append(_Trailing(self._line, self._column, len(self._pieces), written))
            self._write(" ")
        else:
            self._begin_line()
        if movable:
            by = self._column - written
            if by * text.count("\n") > self._room:
                raise TooLarge
            text = moved(text, by, self._style.indent)
        self._write(text)

    def _begin_line(self) -> None:
        """Go to the place where the next thing starts: to a new line, with one blank line before it where there were any.

        Not at the start of the file, and not behind text that stays as it is.
        """
        if self._pieces and not self._as_written:
            self._write("\n\n" if self._gap.count("\n") > 1 and not self._first else "\n")
            self._write(" " * (self._depth * self._style.indent))

    def _write(self, text: str) -> None:
        self._pieces.append(text)
        self._room -= len(text)
        if self._room < 0:
            raise TooLarge
        line_feeds = text.count("\n")
        self._line += line_feeds
        self._column = len(text) - text.rindex("\n") - 1 if line_feeds else self._column + len(text)
        self._gap = ""
        self._first = self._as_written = False

    def _align(self) -> None:
        """Comments behind lines that follow each other stay in one column where they were written in one."""
        block: list[_Trailing] = []
        for comment in self._trailing:
            if block and (comment.line != block[-1].line + 1 or comment.written != block[-1].written):
                self._in_one_column(block)
                block = []
            block.append(comment)
        self._in_one_column(block)

    def _in_one_column(self, block: list[_Trailing]) -> None:
        rightmost = max((comment.column for comment in block), default=0)
        self._room -= sum(rightmost - comment.column for comment in block)
        if self._room < 0:
            raise TooLarge
        for comment in block:
            self._pieces[comment.piece] = " " * (rightmost + 1 - comment.column)

    def _is_empty(self, number: int) -> bool:
        """Whether the element that starts here holds white space at most."""
        partner = self._tokens[number].partner
        return partner == number + 1 or (partner == number + 2 and self._is_blank(number + 1))

    def _is_blank(self, number: int) -> bool:
        token = self._tokens[number]
        return token.kind == "text" and not token.text.strip(SPACE)

    def _offset(self, number: int) -> int:
        return self._tokens[number].offset if number < len(self._tokens) else len(self._text)

    def _written_column(self, offset: int) -> int:
        """The column (from 0) of a place in the source, where tabs before it count as one level each.

        So far out that nobody sees it, a number that no other place has.
        """
        start = max(0, offset - _LOOKED_BACK)
        line_start = self._text.rfind("\n", start, offset) + 1
        if not line_start and start:
            return offset
        before = self._text[line_start:offset]
        return len(before) if before.strip(SPACE) else width_of(before, self._style.indent)
