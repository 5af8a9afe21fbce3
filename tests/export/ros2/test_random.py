"""Random descriptions, hostile ones too: what is carried over is written so that it is read again as the same, in XML and in YAML."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from launchlint.export.ros2.carrying import carried
from launchlint.export.ros2.converting import XML, YAML, written
from launchlint.fix.format.style import Style
from launchlint.source import Place, Source, Span
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import Condition, Description, Pair, Parameter, Process, Remap, Substitution, Text, TypedValue
from launchlint.syntax.ros2.reading import Reading
from launchlint.syntax.ros2.tables import distribution

SOURCE = Source("a.launch.py", "", "/a.launch.py")
HERE = Place(SOURCE, Span(0, 0))
TAME = st.text(st.sampled_from("ab c-/_:.,'#&<5ytrue"), max_size=6)
HOSTILE = st.text(st.sampled_from("ab \t\r\n'\"\\$(){}[]:,#&<-%=é\u2028\x07\x85"), max_size=6)


def texts(letters: st.SearchStrategy[str], *, computed: bool = True) -> st.SearchStrategy[Text]:
    name = st.sampled_from(["x", "some/name"]).map(lambda each: Text((each,), HERE))
    variable = st.builds(lambda word: Substitution("var", (word,), HERE), name)
    default = st.builds(lambda word, other: Substitution("env", (word, Text((other,), HERE)), HERE), name, letters)
    piece = st.one_of(letters, variable, default) if computed else letters
    return st.lists(piece, max_size=3).map(lambda pieces: Text(tuple(pieces), HERE))


def values(letters: st.SearchStrategy[str]) -> st.SearchStrategy[TypedValue]:
    scalar = st.one_of(st.booleans(), st.integers(-9, 9**30), st.floats(allow_nan=False), letters)
    plain = scalar.map(lambda each: TypedValue(Text((str(each),), HERE), None, each))
    lists = st.one_of(*(st.lists(kind, max_size=3) for kind in (st.booleans(), st.integers(), letters))).map(
        lambda items: TypedValue(tuple(Text((str(each),), HERE) for each in items), None, tuple(items))
    )
    computed = st.builds(lambda name, type_: TypedValue(Text((Substitution("var", (Text((name,), HERE),), HERE),), HERE), type_),
                         st.sampled_from("ab"), st.sampled_from([None, "str", "int", "float", "bool"]))  # fmt: skip
    mixed = st.lists(texts(letters), min_size=1, max_size=3).map(lambda items: TypedValue(tuple(items), None, (None,) * len(items)))
    return st.one_of(plain, lists, computed, mixed)


def descriptions(letters: st.SearchStrategy[str]) -> st.SearchStrategy[Description]:
    text = texts(letters)
    condition = st.one_of(st.none(), st.builds(lambda kind, each: Condition(kind, (each,), HERE), st.sampled_from(["if", "unless"]), text))
    optional = st.one_of(st.none(), text)
    pairs = st.lists(st.builds(lambda one, other: Pair(one, other, HERE), text, text), max_size=2).map(tuple)
    parameter = st.builds(lambda name, value: Parameter(name, value, (), HERE), text, values(letters))
    process = st.builds(
        lambda name, respawn, delay, shell, env: Process(
            name=name, respawn=respawn, respawn_delay=delay, shell=shell, additional_environment=env
        ),
        optional,
        st.one_of(st.none(), st.booleans(), text),
        st.one_of(st.none(), st.floats(0, 9)),
        st.one_of(st.none(), st.booleans()),
        pairs,
    )
    node = st.builds(
        lambda package, program, name, arguments, remaps, parameters, process, condition: described.Node(
            "node", package, program, name, None, tuple(arguments), (), tuple(Remap(*each, HERE) for each in remaps), tuple(parameters), (),
            process, HERE, condition,
        ),
        optional, text, optional, st.lists(text, max_size=3), st.lists(st.tuples(text, text), max_size=2),
        st.lists(parameter, max_size=3), process, condition,
    )  # fmt: skip
    argument = st.builds(
        lambda name, default, words, choices: described.Argument(name, default, words, choices, HERE),
        letters, optional, letters, st.one_of(st.none(), st.lists(letters, min_size=1, max_size=2).map(tuple)),
    )  # fmt: skip
    others = st.one_of(
        node,
        argument,
        st.builds(lambda one, other, when: described.Let(one, other, HERE, when), text, text, condition),
        st.builds(lambda file, given: described.Include(file, given, HERE), text, pairs),
        st.builds(lambda name, value: described.SetParameter(name, TypedValue(value), HERE), text, text),
        st.builds(lambda value: described.SetUseSimTime(value, HERE), st.booleans()),
    )
    actions = st.recursive(
        others,
        lambda inner: st.one_of(
            st.builds(
                lambda actions, scoped, keep: described.Group(tuple(actions), scoped, True, keep, HERE),
                st.lists(inner, max_size=3), st.booleans(), pairs,
            ),
            st.builds(
                lambda period, actions: described.Timer(period, tuple(actions), HERE),
                st.one_of(st.floats(0, 9), text),
                st.lists(inner, max_size=3),
            ),
        ),
        max_leaves=4,
    )  # fmt: skip
    return st.lists(actions, max_size=3).map(lambda found: Description(tuple(found), HERE))


@pytest.mark.parametrize("language", [XML, YAML])
@pytest.mark.parametrize("letters", [TAME, HOSTILE], ids=["tame", "hostile"])
def test_what_is_carried_over_is_read_again_as_the_same(letters: st.SearchStrategy[str], language: str) -> None:
    @given(descriptions(letters))
    def check(description: Description) -> None:
        kept = carried(description, distribution("jazzy"), xml=language == XML)
        reading = Reading(kept.description, (), SOURCE)
        assert written(kept.description, reading, language, "jazzy", Style(), kept.lost)  # compares, and raises where it is not the same

    check()
