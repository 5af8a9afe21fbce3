"""A description as a tree of tags: what stands in each, and in which form, is what the tables of the front ends say."""

from __future__ import annotations

from launchlint.export.ros2.said import Said, said
from launchlint.export.ros2.texts import CannotWrite, TextWriter
from launchlint.export.ros2.tree import Branch
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Text
from launchlint.syntax.ros2.order import ORDER
from launchlint.syntax.ros2.tables import Actions, Attribute, Children, Conditions, Kind, Parameters

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from launchlint.export.ros2.tree import Plain, Scalar
    from launchlint.syntax.ros2.description import Action, Condition, Description, ParameterSource, TypedValue
    from launchlint.syntax.ros2.tables import Distribution, Read

_READ_RAW = ("str", "int", "float")
"""Types of a ``<param>`` whose text in XML is not looked at by YAML first."""


def shaped(description: Description, distribution: Distribution) -> Branch:
    """The whole file. Raises CannotWrite for what a front end cannot read."""
    root = Branch("launch", description.place)
    root.actions = Shaper(distribution).actions(description.actions)
    return root


class Shaper:
    """Makes the tags of one distribution."""

    def __init__(self, distribution: Distribution) -> None:
        self._distribution = distribution
        self._texts = TextWriter(distribution)

    def actions(self, actions: Iterable[Action]) -> list[Branch]:
        """The tags of ``actions``, in order. Raises CannotWrite."""
        return [self.action(each) for each in actions]

    def action(self, action: Action) -> Branch:
        """The tag of one action. Raises CannotWrite."""
        spoken = said(action)
        tag = self._distribution.tags.get(spoken.tag)
        if tag is None:
            raise CannotWrite(f"<{spoken.tag}> is not there in {self._distribution.name}")
        return self._branch(spoken, tag.reads)

    def _branch(self, spoken: Said, reads: tuple[Read, ...]) -> Branch:
        branch = Branch(spoken.tag, spoken.place)
        known = {each.name for each in reads if isinstance(each, Attribute)}
        for name, value in spoken.values.items():
            if value is not None and name not in known:
                raise CannotWrite(f"<{spoken.tag}> has no attribute {name} in {self._distribution.name}")
        found: dict[str, Plain] = {}
        for each in reads:
            if isinstance(each, Attribute):
                value = spoken.values.get(each.name)
                if value is not None:
                    found[each.name] = self._attribute(each, value)
            elif isinstance(each, Conditions):
                found.update(self._condition(spoken.condition))
            elif isinstance(each, Children):
                branch.named += [self._branch(child, each.reads) for child in spoken.inner.get(each.name, ())]
            elif isinstance(each, Parameters):
                branch.named += [self._source(source) for source in spoken.params]
            elif isinstance(each, Actions):
                branch.actions = self.actions(spoken.actions)
        order = ORDER.get(spoken.tag, ())
        branch.attributes = {name: found[name] for name in (*(name for name in order if name in found), *found)}
        return branch

    def _condition(self, condition: Condition | None) -> dict[str, Plain]:
        return {} if condition is None else {condition.kind: self._texts.text(condition.operands[0])}

    def _attribute(self, attribute: Attribute, value: object) -> Plain:
        made = _OF_KIND[attribute.kind](self._texts, value)
        if made is None:
            raise CannotWrite(f"{attribute.name} takes {attribute.kind.value}, and nothing that is computed")
        return made

    # -- params --------------------------------------------------------------------------------------------------------

    def _source(self, source: ParameterSource) -> Branch:
        if isinstance(source, ParameterFile):
            branch = Branch("param", source.place)
            branch.attributes["from"] = self._texts.text(source.file)
            allowed = source.allow_substs
            if allowed is not False:
                branch.attributes["allow_substs"] = self._texts.text(allowed) if isinstance(allowed, Text) else True
            return branch
        assert isinstance(source, Parameter)  # several at once have been taken apart
        return self._parameter(source)

    def _parameter(self, parameter: Parameter) -> Branch:
        branch = Branch("param", parameter.place)
        branch.attributes["name"] = self._texts.text(parameter.name)
        value = parameter.value
        if value is None:
            branch.named += [self._parameter(each) for each in parameter.nested]
            return branch
        if value.type is not None:
            branch.attributes["type"] = value.type
        branch.attributes["value"] = self._typed(value)
        if value.type not in _READ_RAW:
            branch.typed.add("value")
        return branch

    def _typed(self, value: TypedValue) -> Plain:
        if isinstance(value.value, Text):
            assert not isinstance(value.plain, tuple)
            return self._item(value.value, value.plain)
        plain = value.plain if isinstance(value.plain, tuple) else (None,) * len(value.value)
        return [self._item(text, known) for text, known in zip(value.value, plain, strict=True)]

    def _item(self, text: Text, plain: Scalar | None) -> Scalar:
        if isinstance(plain, str):
            return self._texts.text(text._replace(pieces=(plain,)))
        return self._texts.text(text) if plain is None else plain


def _text(texts: TextWriter, value: object) -> Plain | None:
    if isinstance(value, bool):
        return "true" if value else "false"
    return texts.text(value) if isinstance(value, Text) else None


def _word(texts: TextWriter, value: object) -> Plain | None:
    return texts.word(value) if isinstance(value, str) else None


def _command(texts: TextWriter, value: object) -> Plain | None:
    return texts.command_line(value) if isinstance(value, tuple) else None


def _flag(texts: TextWriter, value: object) -> Plain | None:
    return value if isinstance(value, bool) else None


def _flag_or_text(texts: TextWriter, value: object) -> Plain | None:
    return value if isinstance(value, bool) else _text(texts, value)


def _integer(texts: TextWriter, value: object) -> Plain | None:
    return value if isinstance(value, int) and not isinstance(value, bool) else None


def _seconds(texts: TextWriter, value: object) -> Plain | None:
    if isinstance(value, Text) and value.literal is not None:
        try:
            return float(value.literal)
        except ValueError:
            return None
    return value if isinstance(value, float) and value >= 0 else None


def _period(texts: TextWriter, value: object) -> Plain | None:
    return value if isinstance(value, float) else _text(texts, value)


def _shutdown(texts: TextWriter, value: object) -> Plain | None:
    return "shutdown" if value == "shutdown" else None


_OF_KIND: Mapping[Kind, Callable[[TextWriter, object], Plain | None]] = {
    Kind.TEXT: _text,
    Kind.WORD: _word,
    Kind.COMMAND: _command,
    Kind.FLAG: _flag,
    Kind.FLAG_OR_TEXT: _flag_or_text,
    Kind.INTEGER: _integer,
    Kind.SECONDS: _seconds,
    Kind.PERIOD: _period,
    Kind.SHUTDOWN: _shutdown,
}
