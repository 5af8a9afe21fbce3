"""The guard: what may be changed in a launch file without changing what it does, and what may not."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.fix.guard import Caller, Guard
from launchlint.fix.meaning import Meaning, difference
from tests.evaluate.comparison import MAIN, case, content, inside, session_in, write

SIM = '<arg name="sim" default="false"/>'
BOT = '<arg name="bot"/>'
ABSENT = '<include file="$(find nowhere)/x.launch"/>'

SAME: dict[str, tuple[str, str]] = {
    "blanks and attribute order": ('[[n ns="a"]]', '\n  <node  ns="a" type="t" name="n"\n pkg="p"\t/>\n'),
    "a comment": ("[[n]]", "<!-- why -->[[n]]"),
    "quotes and references": ('<param name="a" value="&quot;x&quot;"/>', "<param name='a' value='\"x\"'/>"),
    "args in another order": ('<arg name="a" default="1"/>' + SIM, SIM + '<arg name="a" default="1"/>'),
    "an arg after a node that does not read it": ("[[n]]" + SIM, SIM + "[[n]]"),
    "a remap that only the nodes after it see": ("[[n]]<remap from='a' to='b'/>", "[[n]]"),
    "parameters in another order": (
        '<param name="a" value="1"/><param name="b" value="2"/>', '<param name="b" value="2"/><param name="a" value="1"/>',
    ),
    "a parameter set twice to the same": ('<param name="a" value="1"/><param name="a" value="1"/>', '<param name="a" value="1"/>'),
    "the end of the namespace of parameters that are not known": (
        '<rosparam file="$(find nowhere)/x.yaml" ns="a"/>', '<rosparam file="$(find nowhere)/x.yaml" param="a"/>',
    ),
    "a number in another spelling": ('<param name="a" value="1.0"/>', '<param name="a" value="1.00"/>'),
    "an unknown attribute": ('[[n outputt="screen"]]', "[[n]]"),
    "a group around nothing that scopes": ("[[n]]", "<group>[[n]]</group>"),
    "a remap to itself": ('[[n | <remap from="a" to="b"/><remap from="c" to="c"/>]]', '[[n | <remap from="a" to="b"/>]]'),
    "a remap of nodes that are never taken, in another node": (
        '[[m | <remap from="a" to="a"/>]]<group if="false">[[n]]</group>',
        '[[m]]<group if="false">[[n]]</group>',
    ),
    "a private remap to itself beside one of a like name": (
        '[[n | <remap from="~ab" to="~ab"/><remap from="~cb" to="d"/>]]', '[[n | <remap from="~cb" to="d"/>]]',
    ),
    "what is refused, as long as the rest stays": ("[[n]][[n]]", "[[n]] [[n]]"),
    "never taken, but as it was": ('<group if="false">[[n]]</group>[[m]]', '<group if="false">\n [[n]]\n</group> [[m]]'),
    "args before what is never taken": (
        '<arg name="a" default="1"/><arg name="b" default="1"/><group if="false">[[n]]</group>',
        '<arg name="b" default="1"/><arg name="a" default="1"/><group if="false">[[n]]</group>',
    ),
    "an unknown tag before what is never taken": ('<Arg name="a"/><group if="false">[[n]]</group>', '<group if="false">[[n]]</group>'),
    "a remap after what is never taken": ('<group if="false">[[n]]</group><remap from="a" to="b"/>', '<group if="false">[[n]]</group>'),
    "parameters of which one begins like another": (
        '<param name="ab" value="1"/><param name="a" value="1"/>', '<param name="a" value="1"/><param name="ab" value="1"/>',
    ),
}  # fmt: skip

OTHERWISE = "there would be another parameter '/a' (with mode:=b sim:=false)"
NEVER_SEEN = "no configuration shows what this does to the <group> under a condition that is never met, or of unknown name"

CHANGED: dict[str, tuple[str, str, str]] = {
    "a node goes": ("[[n]][[m]]", "[[n]]", "the node '/m' would be gone"),
    "a node comes": ("[[n]]", "[[n]][[m]]", "there would be another node '/m'"),
    "the order of nodes": ("[[n]][[m]]", "[[m]][[n]]", "the order of the nodes would change, beginning with '/n'"),
    "the order of nodes, the other way round": (
        "[[m]][[n]]", "[[n]][[m]]", "the order of the nodes would change, beginning with '/m'",
    ),
    "a private remap to itself that takes a global one back": (
        '[[n | <remap from="/n/a" to="b"/><remap from="~a" to="~a"/>]]', '[[n | <remap from="/n/a" to="b"/>]]',
        "the node '/n' would change: remaps from (('/n/a', 'b'), ('~a', '~a')) to (('/n/a', 'b'),)",
    ),
    "a value that can just be shown": (
        f'<param name="a" value="{"x" * 118}"/>', f'<param name="a" value="{"y" * 119}"/>',
        f"the parameter '/a' would change from '{'x' * 118}' to '{'y' * 116}…",
    ),
    "an attribute of a node": (
        '[[n respawn="true" required="false"]]', "[[n]]", "the node '/n' would change: respawn from True to False",
    ),
    "a remap in force": (
        "[[n]]<remap from='a' to='b'/>[[m]]", "<remap from='a' to='b'/>[[n]][[m]]",
        "the node '/n' would change: remaps from nothing to (('a', 'b'),)",
    ),
    "a remap to a name that comes before its own": (
        '[[n | <remap from="b" to="a"/>]]', "[[n]]", "the node '/n' would change: remaps from (('b', 'a'),) to nothing",
    ),
    "the order of remaps": (
        "<remap from='a' to='b'/><remap from='/a' to='c'/>[[n]]", "<remap from='/a' to='c'/><remap from='a' to='b'/>[[n]]",
        "the node '/n' would change: remaps from (('a', 'b'), ('/a', 'c')) to (('/a', 'c'), ('a', 'b'))",
    ),
    "a remap to itself that takes another one back": (
        '<remap from="a" to="b"/>[[n ns="r" | <remap from="/r/a" to="/r/a"/>]]',
        '<remap from="a" to="b"/>[[n ns="r"]]',
        "the node '/r/n' would change: remaps from (('a', 'b'), ('/r/a', '/r/a')) to (('a', 'b'),)",
    ),
    "a remap to itself of a node whose namespace is not known": (
        '[[n ns="$(eval unknown)" | <remap from="a" to="b"/><remap from="c" to="c"/>]]',
        '[[n ns="$(eval unknown)" | <remap from="a" to="b"/>]]',
        "the node '/unknown_namespace/n' would change: remaps from (('a', 'b'), ('c', 'c')) to (('a', 'b'),)",
    ),
    "the environment": (
        "<env name='A' value='1'/>[[n]]", "[[n]]<env name='A' value='1'/>",
        "the node '/n' would change: environment from (('A', '1'),) to nothing",
    ),
    "a parameter": ('<param name="a" value="1"/>', '<param name="a" value="2"/>', "the parameter '/a' would change from 1 to 2"),
    "a type": ('<param name="a" value="1"/>', '<param name="a" value="1.0"/>', "the parameter '/a' would change from 1 to 1.0"),
    "a type inside": (
        '<rosparam param="a">[1, {b: 1}]</rosparam>', '<rosparam param="a">[1, {b: true}]</rosparam>',
        "the parameter '/a' would change from [1, {'b': 1}] to [1, {'b': True}]",
    ),
    "which parameter is set last": (
        '<param name="a" value="1"/><param name="a" value="2"/>', '<param name="a" value="2"/><param name="a" value="1"/>',
        "the parameter '/a' would change from 2 to 1",
    ),
    "a parameter below another": (
        '<param name="a/b" value="1"/><param name="a" value="1"/>', '<param name="a" value="1"/><param name="a/b" value="1"/>',
        "the order of the nested parameters would change",
    ),
    "commands run in another order": (
        '<param name="a" command="x"/><param name="b" command="y"/>', '<param name="b" command="y"/><param name="a" command="x"/>',
        "the order of the param commands would change",
    ),
    "rosparam steps": (
        '<rosparam command="delete" param="a"/><rosparam command="dump" param="a" file="f"/>',
        '<rosparam command="dump" param="a" file="f"/><rosparam command="delete" param="a"/>',
        "the order of the rosparam steps would change",
    ),
    "clear_params": (
        '<group ns="a" clear_params="true">[[n]]</group>', '<group ns="a">[[n]]</group>', "the cleared namespace '/a/' would be gone",
    ),
    "a machine": (
        '<machine name="m" address="a"/>', '<machine name="m" address="a" timeout="3"/>',
        ("the machine 'm' would change from ('m', 'a', '/opt/ros/noetic/env.sh', 22, None, None, True, 10.0)"
         " to ('m', 'a', '/opt/ros/noetic/env.sh', 22, None, None, True, 3.0)"),
    ),
    "the default of an arg": (SIM, '<arg name="sim" default="true"/>', "the arg 'sim' would change: default from 'false' to 'true'"),
    "default into value": (
        SIM, '<arg name="sim" value="false"/>', "the arg 'sim' would change: value from None to 'false'",
    ),
    "only in another configuration": (
        SIM + '[[n if="$(arg sim)" ns="a"]]', SIM + '[[n if="$(arg sim)" ns="b"]]', "the node '/a/n' would be gone (with sim:=true)",
    ),
    "a configuration that only the result has": (
        SIM + "[[n]]", SIM + '[[n unless="$(arg sim)"]]', "the node '/n' would be gone (with sim:=true)",
    ),
    "loads and would be refused": ("[[n]]", '[[n respawn="yes"]]', "roslaunch would refuse the file (invalid value)"),
    "refused and would load": ("[[n]][[n]]", "[[n]]", "roslaunch would no longer refuse the file (duplicate node)"),
    "refused for another reason": (
        "[[n]][[n]]", '[[n]][[m respawn="yes"]]', "roslaunch would refuse the file for another reason (invalid value)",
    ),
    "arg use before its declaration": (
        '<param name="a" value="$(arg sim)"/>' + SIM, SIM + '<param name="a" value="$(arg sim)"/>',
        "roslaunch would no longer refuse the file (used before declaration)",
    ),
    "a parameter of a node whose namespace is a required arg": (
        BOT + '<group ns="$(arg bot)">[[n | <param name="a" value="1"/>]]</group>',
        BOT + '<group ns="$(arg bot)">[[n | <param name="a" value="2"/>]]</group>',
        "the parameter '/unknown_namespace/n/a' would change from 1 to 2",
    ),
    "two required args that are swapped": (
        BOT + '<arg name="other"/>[[n args="$(arg bot) $(arg other)"]]', BOT + '<arg name="other"/>[[n args="$(arg other) $(arg bot)"]]',
        "the node '/n' would change: arguments from '$(arg bot) $(arg other)' to '$(arg other) $(arg bot)'",
    ),
    "a parameter of a node whose name is a required arg": (
        BOT + '<node pkg="p" type="t" name="$(arg bot)"><param name="a" value="1"/></node>',
        BOT + '<node pkg="p" type="t" name="$(arg bot)"><param name="a" value="2"/></node>',
        "the parameter '/value_of_bot/a' would change from 1 to 2 (with bot:=value_of_bot)",
    ),
    "a parameter of a node whose name is an unset variable": (
        '<node pkg="p" type="t" name="$(env BOT)"><param name="a" value="1"/></node>',
        '<node pkg="p" type="t" name="$(env BOT)"><param name="a" value="2"/></node>',
        "the parameter '/value_of_BOT/a' would change from 1 to 2",
    ),
    "a parameter of a node whose name is never known": (
        '<node pkg="p" type="t" name="$(eval unknown)"><param name="a" value="1"/></node>',
        '<node pkg="p" type="t" name="$(eval unknown)"><param name="a" value="2"/></node>',
        "no configuration shows what this does to the <node> under a condition that is never met, or of unknown name",
    ),
    "a parameter of a node whose namespace is an unset variable": (
        '<group ns="$(env BOT)">[[n | <param name="a" value="1"/>]]</group>',
        '<group ns="$(env BOT)">[[n | <param name="a" value="2"/>]]</group>',
        "the parameter '/unknown_namespace/n/a' would change from 1 to 2",
    ),
    "never taken": (
        '<group if="false">[[n ns="a"]]</group>', '<group if="false">[[n ns="b"]]</group>',
        NEVER_SEEN,
    ),
    "a remap before what is never taken": (
        '<remap from="a" to="b"/><group if="false">[[n]]</group>', '<group if="false">[[n]]</group><remap from="a" to="b"/>',
        NEVER_SEEN,
    ),
    "an arg before what is never taken": (
        SIM + '<group if="false">[[n args="$(arg sim)"]]</group>', '<group if="false">[[n args="$(arg sim)"]]</group>' + SIM,
        NEVER_SEEN,
    ),
    "a parameter after what is never taken": (
        '<param name="a" value="1"/><param if="false" name="a" value="2"/><param name="a" value="1"/>',
        '<param name="a" value="1"/><param if="false" name="a" value="2"/>',
        "no configuration shows what this does to the <param> under a condition that is never met, or of unknown name",
    ),
    "something that is never taken, and was not there": ("[[n]]", '[[n]]<group if="false">[[m]]</group>', NEVER_SEEN),
    "the second of two that touch and are never taken": (
        '<group if="false">[[n]]</group><group if="false">[[m]]</group>',
        '<group if="false">[[n]]</group><group if="false">[[m ns="a"]]</group>', NEVER_SEEN,
    ),
    "the second of what is never taken": (
        '<group if="false">[[n]][[m]]</group>', '<group if="false">[[n]][[m ns="a"]]</group>', NEVER_SEEN,
    ),
    "a remap between two that are never taken": (
        '<group if="false">[[n]]</group><remap from="a" to="b"/><group if="false">[[m]]</group>',
        '<group if="false">[[n]]</group><group if="false">[[m]]</group>', NEVER_SEEN,
    ),
    "the namespace of parameters that are not known": (
        '<rosparam file="$(find nowhere)/x.yaml" ns="a"/>', '<rosparam file="$(find nowhere)/x.yaml" ns="b"/>',
        "the unresolved item 'parameters of unknown names' would change: namespace from '/a' to '/b'",
    ),
    "a remap before an include that is not here": (
        '<remap from="a" to="b"/><include file="$(find nowhere)/x.launch"/>',
        '<include file="$(find nowhere)/x.launch"/><remap from="a" to="b"/>',
        "the unresolved item 'a' would change: includes from 1 to 0",
    ),
    "a remap between two includes that are not here": (
        '<include file="$(find nowhere)/x.launch"/><remap from="a" to="b"/><include file="$(find nowhere)/y.launch"/>',
        '<include file="$(find nowhere)/x.launch"/><include file="$(find nowhere)/y.launch"/><remap from="a" to="b"/>',
        "the unresolved item 'a' would change: includes from 1 to 0",
    ),
    "a remap before two of three includes that are not here": (
        f'{ABSENT}<remap from="a" to="b"/>{ABSENT}{ABSENT}', f'{ABSENT}{ABSENT}{ABSENT}<remap from="a" to="b"/>',
        "the unresolved item 'a' would change: includes from 2 to 0",
    ),
    "a parameter below another with a short name": (
        '<param name="aaaa/b/c" value="1"/><param name="aaaa/b" value="1"/>',
        '<param name="aaaa/b" value="1"/><param name="aaaa/b/c" value="1"/>',
        "the order of the nested parameters would change",
    ),
    "an arg for an include that is not here": (
        '<include file="$(find nowhere)/x.launch"><arg name="a" value="1"/></include>',
        '<include file="$(find nowhere)/x.launch"><arg name="a" value="2"/></include>',
        "the unresolved item '$(find nowhere)/x.launch' would change: arguments from (('a', '1'),) to (('a', '2'),)",
    ),
    "a condition of unknown value": (
        '<param name="a" value="1"/><param name="a" value="2" if="$(env WHO)"/>',
        '<param name="a" value="3"/><param name="a" value="2" if="$(env WHO)"/>',
        "the unresolved item '/a' would change: value from 1 to 3",
    ),
}  # fmt: skip


def refusal(before: str, after: str, directory: Path) -> str:
    write(case(before), directory)
    with inside(directory):
        guard = Guard(session_in(directory))
        return guard.refusal(str(directory / MAIN), content(MAIN, before), content(MAIN, after))


@pytest.mark.parametrize(("before", "after"), SAME.values(), ids=SAME.keys())
def test_means_the_same(before: str, after: str, tmp_path: Path) -> None:
    assert refusal(before, after, tmp_path) == ""
    assert refusal(after, before, tmp_path) == ""


@pytest.mark.parametrize(("before", "after", "why"), CHANGED.values(), ids=CHANGED.keys())
def test_does_not_mean_the_same(before: str, after: str, why: str, tmp_path: Path) -> None:
    assert refusal(before, after, tmp_path) == why
    assert refusal(after, before, tmp_path) != ""


def test_args_before_what_is_never_taken_are_compared_themselves_and_not_their_hashes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two texts whose args have hashes of the same sum are two texts."""
    monkeypatch.setattr("launchlint.fix.hidden.hash", lambda each: 0, raising=False)
    never = '<group if="false">[[n args="$(arg sim)"]]</group>'
    assert refusal(SIM + never, never + SIM, tmp_path) != ""


@pytest.mark.parametrize(
    ("before", "after", "why"),
    [
        (b"<launch>", b"<launch/>", "the file is no launch file that roslaunch can read"),
        (b"<launch/>", b"<launch>", "the result is no launch file that roslaunch can read"),
        (b"<launch/>", b"<a/>", "the result is no launch file that roslaunch can read"),
        (b"<launch>", b"<launch>", ""),
        (b"\xef\xbb\xbf<launch/>", "<?xml version='1.0' encoding='utf-16'?><launch/>".encode("utf-16"), ""),
    ],
)
def test_what_cannot_be_read(before: bytes, after: bytes, why: str, tmp_path: Path) -> None:
    copy = bytes(bytearray(after))  # equal texts need not be one object
    assert Guard(session_in(tmp_path)).refusal(str(tmp_path / MAIN), before, copy) == why


def test_what_only_a_file_that_includes_it_shows(tmp_path: Path) -> None:
    """A ~param acts on the nodes after it, and those may stand in the including file, if that has set one before."""
    caller = '<param name="~a" value="1"/><include file="part.launch"/>[[n]]'
    before, after = '<param name="~b" value="1"/>', ""
    write(case(caller, files={"part.launch": before}), tmp_path)
    file = str(tmp_path / "part.launch")
    edit = (file, content("part.launch", before), content("part.launch", after))
    with inside(tmp_path):
        session = session_in(tmp_path)
        assert Guard(session).refusal(*edit) == ""
        guard = Guard(session, lambda each: [Caller(str(tmp_path / MAIN))] if each == file else [])
        assert guard.refusal(*edit) == f"the parameter '/n/b' would be gone (with {MAIN})"


PRIVATE = '<param name="~{}" value="1"/>'
"""It acts on the nodes after the include of the file that it ends."""


def test_edits_of_many_files_are_proved_together(tmp_path: Path) -> None:
    """Refused is what changes something: by itself, where one includes it, or together with others, of which the first may stay."""
    leaves = {"one.launch": "a", "two.launch": "a", "three.launch": "b"}
    files = {
        **{name: PRIVATE.format(param) for name, param in leaves.items()},
        "shown.launch": '<param name="c" value="1"/>',
        "same.launch": "[[m]]",
    }
    includes = "".join(f'<include file="{name}"/>' for name in files)
    write(case(f'<param name="~d" value="1"/>{includes}[[n]]', files=files), tmp_path)
    file = {name: str(tmp_path / name) for name in files}
    with inside(tmp_path):
        guard = Guard(session_in(tmp_path), lambda _: [Caller(str(tmp_path / MAIN))])
        empty = {file[name]: content(name, "") for name in (*leaves, "shown.launch")}
        refused = guard.refusals({**empty, file["same.launch"]: content("same.launch", "[[m]] ")})
        read = guard.read
        again = guard.refusals({file[name]: empty[file[name]] for name in ("one.launch", "three.launch", "shown.launch")})
    assert refused == {
        file["two.launch"]: f"the parameter '/m/a' would be gone (with {MAIN})",
        file["three.launch"]: f"the parameter '/m/b' would be gone (with {MAIN})",
        file["shown.launch"]: "the parameter '/c' would be gone",
    }
    assert again == {name: reason for name, reason in refused.items() if name != file["two.launch"]}
    assert guard.read == read, "what was asked before is known"


def test_what_no_edit_has_reached_is_known_afterwards(tmp_path: Path) -> None:
    parts = {"a.launch": "[[a]]", "b.launch": "[[b]]"}
    write(case("", files=parts), tmp_path)
    a, b = (str(tmp_path / name) for name in parts)
    with inside(tmp_path):
        guard = Guard(session_in(tmp_path))
        assert guard.refusals({a: content("a.launch", "[[a]] "), b: content("b.launch", "")}) == {b: "the node '/b' would be gone"}
        later = guard.holding({a: content("a.launch", "[[c]]")}, lambda _: [])
        assert later.refusals({b: content("b.launch", "")}) == {b: "the node '/b' would be gone"}
        assert later.read == guard.read
        assert later.refusals({a: content("a.launch", "[[a]]")}) == {a: "the node '/c' would be gone"}
    assert later.read > guard.read


@pytest.mark.parametrize("caller", ["a.launch", "z.launch"])
def test_who_else_includes_it_is_asked_for_what_it_sees_alone(caller: str, tmp_path: Path) -> None:
    """What a caller never shows, since it gives the arg one value, is shown by the file itself; what it changes is told with its name."""
    part = SIM + '<group if="$(arg sim)"><param name="a" value="{}"/></group><param name="b" value="{}"/>'
    main = f'<include file="{MAIN}"><arg name="sim" value="false"/></include><param name="b" value="2"/>'
    write(case(part.format("1.0", 1), files={caller: main}), tmp_path)
    with inside(tmp_path):
        session = session_in(tmp_path)
        file = str(tmp_path / MAIN)
        callers = [Caller(str(tmp_path / caller)), Caller(file)]
        guard = Guard(session, lambda _: callers)
        before = content(MAIN, part.format("1.0", 1))
        assert guard.refusal(file, before, content(MAIN, part.format("1.00", 1))) == ""
        late = content(MAIN, '<param name="~c" value="1"/>' + part.format("1.0", 1))
        assert guard.refusal(file, before, late) == ""
        (tmp_path / caller).write_bytes(content(caller, f'<param name="~d" value="1"/>{main}[[n]]'))
        assert Guard(session_in(tmp_path), lambda _: callers).refusal(file, before, late) == (
            f"there would be another parameter '/n/c' (with {caller})"
        )


def test_of_many_that_include_it_the_first_twenty_are_asked(tmp_path: Path) -> None:
    include = f'<include file="{MAIN}"/>'
    names = [f"{number}.launch" for number in range(30)]
    write(case("[[n]]", files=dict.fromkeys(names, include)), tmp_path)
    callers = (Caller(str(tmp_path / name)) for name in names)
    with inside(tmp_path):
        guard = Guard(session_in(tmp_path), lambda _: callers)
        assert guard.refusal(str(tmp_path / MAIN), content(MAIN, "[[n]]"), content(MAIN, "[[n]] ")) == ""
    assert next(callers).file == str(tmp_path / "20.launch")


@pytest.mark.parametrize(
    ("before", "after", "why"),
    [
        ('<param name="$(arg mode)" value="1"/>', '<param name="a" value="1"/>', OTHERWISE),
        ('<param name="$(arg mode)" value="1.0"/>', '<param name="$(arg mode)" value="1.00"/>', ""),
        ('<param name="a" value="1.0" if="$(arg sim)"/>', '<param name="a" value="1.00" if="$(arg sim)"/>', ""),
    ],
)
def test_a_file_that_is_started_with_args_is_proved_with_these_too(before: str, after: str, why: str, tmp_path: Path) -> None:
    """What these args leave out is shown without them."""
    declared = f'{SIM}<arg name="mode" default="a"/>'
    texts = [content(MAIN, declared + text) for text in (before, after)]
    file = str(tmp_path / MAIN)
    guard = Guard(session_in(tmp_path), lambda each: [Caller(each), Caller(file, (("mode", "b"), ("sim", "false")))])
    assert guard.refusal(str(tmp_path / MAIN), *texts) == why


def test_the_namespace_and_the_ros_of_roslaunch_are_those_it_is_started_in(tmp_path: Path) -> None:
    """They are no variables of the file: what is the same in them is the same."""
    before, after = (content(MAIN, text) for text in ('<param name="a" value="1"/>', '<param name="/robot/a" value="1"/>'))
    guard = Guard(session_in(tmp_path, {"ROS_NAMESPACE": "/robot"}))
    assert guard.refusal(str(tmp_path / MAIN), before, after) == ""


@pytest.mark.parametrize(
    "part",
    ['<include file="$(find nowhere)/x.launch"/><include file="$(find nowhere)/y.launch"/>', b"<robot/>"],
    ids=["absent", "no launch"],
)
def test_a_remap_before_a_file_that_cannot_be_followed(part: str | bytes, tmp_path: Path) -> None:
    before, after = '<remap from="a" to="b"/><include file="part.launch"/>', '<include file="part.launch"/><remap from="a" to="b"/>'
    write(case(before, files={"part.launch": part}), tmp_path)
    with inside(tmp_path):
        guard = Guard(session_in(tmp_path))
        found = guard.refusal(str(tmp_path / MAIN), content(MAIN, before), content(MAIN, after))
    assert found == "the unresolved item 'a' would change: includes from 1 to 0"


@pytest.mark.parametrize("other", ["a.launch", "z.launch"])
def test_a_node_of_another_file_that_stands_at_the_same_place_says_nothing_of_this_one(other: str, tmp_path: Path) -> None:
    node = '<node pkg="p" type="t" name="$(eval unknown)"><param name="a" value="{}"/></node>'
    text = f'<launch><include file="{other}"/>{node}</launch>'
    at = text.index("<node")
    write(case("", files={other: f"<launch>{' ' * (at - len('<launch>'))}[[known]]</launch>"}), tmp_path)
    with inside(tmp_path):
        before, after = (text.replace("{}", value).encode() for value in "12")
        assert Guard(session_in(tmp_path)).refusal(str(tmp_path / MAIN), before, after) == NEVER_SEEN.replace("<group>", "<node>")


def test_what_says_more_of_one_thing_does_not_say_the_same() -> None:
    nothing = Meaning(*((),) * len(Meaning._fields))
    short, long = (nothing._replace(left_open=(facts,)) for facts in ((("name", "a"),), (("name", "a"), ("value", "1"))))
    assert [difference(short, long), difference(long, short)] == ["the unresolved item 'a' would change"] * 2


def test_other_files_are_read_from_the_session(tmp_path: Path) -> None:
    write(case('<include file="part.launch"/>', files={"part.launch": "[[a]]"}), tmp_path)
    before = content(MAIN, '<include file="part.launch"/>')
    after = content(MAIN, "[[a]]")
    with inside(tmp_path):
        session = session_in(tmp_path)
        assert Guard(session).refusal(str(tmp_path / MAIN), before, after) == ""
        overlaid = session.with_text(str(tmp_path / "part.launch"), content("part.launch", "[[b]]"))
        assert Guard(overlaid).refusal(str(tmp_path / MAIN), before, after) == "the node '/b' would be gone"
