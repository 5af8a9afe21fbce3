"""What ``ros2 launch`` executes: scopes, includes, names, deferred bodies; and that the walk goes on after a problem."""

from __future__ import annotations

from pathlib import Path
from time import process_time

import pytest

from launchlint.evaluate.problems import IncludeCycle, IncludeMissingArg, RequiredArgUnset, UndeclaredArg
from launchlint.evaluate.ros2.problems import RequiredArgNotPassed
from launchlint.model import Unknown
from tests.evaluate.ros2.launching import Workspace, loaded, named, only, refusal

NODE = '<node pkg="pk" exec="e" name="{}"/>'
SHOW = '<node pkg="pk" exec="e" name="n" args="{}"/>'


def shown(directory: Path, body: str, *given: str, distro: str = "jazzy", **others: str) -> list[str]:
    """The args of the nodes, in order."""
    files = {name.replace("_", ".") + ".launch.xml": text for name, text in others.items()}
    return [node.arguments for node in loaded(Workspace(directory, body, files).launch(*given, distro=distro)).nodes]


@pytest.mark.parametrize(
    ("body", "given", "expected"),
    [
        ('<arg name="a" default="1"/>' + SHOW.format("$(var a)"), (), ["1"]),
        ('<arg name="a" default="1"/>' + SHOW.format("$(var a)"), ("a:=2",), ["2"]),
        ('<let name="a" value="0"/><arg name="a" default="1"/>' + SHOW.format("$(var a)"), (), ["0"]),
        ('<arg name="a" default="1"/><arg name="a" default="2"/>' + SHOW.format("$(var a)"), (), ["1"]),
        ('<arg name="a" default="$(var nothing)"/>' + SHOW.format("$(var a)"), ("a:=7",), ["7"]),
        ('<let name="a" value="1"/><group><let name="a" value="2"/></group>' + SHOW.format("$(var a)"), (), ["1"]),
        ('<group scoped="false"><let name="a" value="2"/></group>' + SHOW.format("$(var a)"), (), ["2"]),
        ('<let name="a" value="1"/><group><keep name="a" value="$(var a)0"/>' + SHOW.format("$(var a)") + "</group>", (), ["10"]),
        ('<let name="a" value="1"/><reset><keep name="b" value="$(var a)"/></reset>' + SHOW.format("$(var a gone)$(var b)"), (), ["gone1"]),
        ('<set_env name="E" value="1"/>' + SHOW.format("$(env E)"), (), ["1"]),
        ('<group><set_env name="E" value="1"/></group>' + SHOW.format("$(env E unset)"), (), ["unset"]),
        ('<append_env name="USER" value="x" separator="-"/>' + SHOW.format("$(env USER)"), (), ["somebody-x"]),
        (SHOW.format("a $(env USER)b 'c d'"), (), ["a somebodyb c d"]),
    ],
)  # fmt: skip
def test_configurations_and_environment(tmp_path: Path, body: str, given: tuple[str, ...], expected: list[str]) -> None:
    assert shown(tmp_path, body, *given) == expected


def test_what_an_include_sets_stays_set(tmp_path: Path) -> None:
    body = '<include file="$(dirname)/inc.launch.xml"><arg name="a" value="1"/><arg name="b" value="$(var a)2"/></include>'
    inner = '<arg name="a"/><arg name="b"/><push_ros_namespace namespace="s"/>'
    nodes = loaded(Workspace(tmp_path, body + SHOW.format("$(var b)"), {"inc.launch.xml": inner}).launch()).nodes
    assert [(node.full_name, node.arguments) for node in nodes] == [("/s/n", "12")]


def test_dirname_is_that_of_the_file_included_last(tmp_path: Path) -> None:
    body = '<group><include file="$(dirname)/sub/inc.launch.xml"/></group>' + SHOW.format("$(dirname)")
    (args,) = (node.arguments for node in loaded(Workspace(tmp_path, body, {"sub/inc.launch.xml": ""}).launch()).nodes)
    assert args.endswith("pk/launch/sub")


def test_remaps_set_in_a_group_leak_where_there_is_a_list_already(tmp_path: Path) -> None:
    inside = '<group><set_remap from="b" to="y"/></group>'
    leaks = only(Workspace(tmp_path / "1", '<set_remap from="a" to="x"/>' + inside + NODE.format("n")).launch())
    assert [(remap.source, remap.target) for remap in leaks.remaps] == [("a", "x"), ("b", "y")]
    assert only(Workspace(tmp_path / "2", inside + NODE.format("n")).launch()).remaps == ()


@pytest.mark.parametrize(
    ("pushed", "own", "expected"),
    [
        ((), None, None),
        ((), "", "/"),
        ((), "a/", "/a/"),
        (("a",), None, "/a/"),
        (("a", "b"), None, "/a/b/"),
        (("a", "/b"), None, "/b/"),
        (("a",), "b", "/a/b/"),
        (("a",), "/b", "/b/"),
        (("/",), "b", "/b/"),
    ],
)
def test_namespaces(tmp_path: Path, pushed: tuple[str, ...], own: str | None, expected: str | None) -> None:
    attribute = "" if own is None else f' namespace="{own}"'
    pushes = "".join(f'<push_ros_namespace namespace="{each}"/>' for each in pushed)
    node = only(Workspace(tmp_path, f'{pushes}<node pkg="pk" exec="e" name="n"{attribute}/>').launch())
    assert (node.namespace if node.has_namespace else None) == expected


def test_what_is_deferred_is_executed_last_and_without_its_group(tmp_path: Path) -> None:
    timer = '<timer period="1.0">' + SHOW.format("$(var a outer)") + "</timer>"
    body = '<group><push_ros_namespace namespace="g"/><let name="a" value="inner"/>' + timer + "</group>" + NODE.format("m")
    launch = loaded(Workspace(tmp_path, body).launch())
    assert [(node.name, node.deferred, node.has_namespace, node.arguments) for node in launch.nodes] == [
        ("m", None, False, ""),
        ("n", "timer", False, "outer"),
    ]


def test_what_fails_later_does_not_refuse_the_file(tmp_path: Path) -> None:
    launch = Workspace(tmp_path, '<timer period="1.0"><log message="$(var a)$(var b)"/><log message="$(var c)"/></timer>').launch()
    assert launch.refused is None
    assert [type(problem) for problem in launch.late] == [UndeclaredArg]


def test_containers_and_what_they_load(tmp_path: Path) -> None:
    component = '<composable_node pkg="pk" plugin="a::B" name="{}" {}/>'
    body = (
        '<push_ros_namespace namespace="s"/><node_container pkg="pk" exec="c" name="c" namespace="in">'
        + component.format("x", 'namespace="own"')
        + component.format("y", 'if="false"')
        + '</node_container><load_composable_node target="far">'
        + component.format("z", 'if="false"')
        + "</load_composable_node>"
    )
    launch = loaded(Workspace(tmp_path / "1", body).launch())
    assert [(node.kind, node.full_name, node.plugin, node.container) for node in launch.nodes] == [
        ("container", "/s/in/c", None, None),
        ("composable", "/s/own/x", "a::B", "/s/in/c"),
    ]
    old = loaded(Workspace(tmp_path / "2", body).launch(distro="humble"))
    assert [(node.name, node.container, node.condition_ignored) for node in old.nodes[2:]] == [("z", "far", True)]


def test_conditions_of_a_node(tmp_path: Path) -> None:
    body = '<arg name="a" default=" TRUE "/><group if="$(var a)"><node pkg="pk" exec="e" name="n" unless="0"/></group>'
    launch = loaded(Workspace(tmp_path, body).launch())
    assert [(condition.attribute, condition.text) for condition in launch.nodes[0].conditions] == [("if", " TRUE "), ("unless", "0")]
    assert [(branch.tag, branch.taken, branch.steered_by) for branch in launch.branches] == [
        ("group", True, {"a"}),
        ("node", True, frozenset()),
    ]


def test_a_process_and_its_environment(tmp_path: Path) -> None:
    body = (
        '<unset_env name="USER"/><let name="launch-prefix" value="gdb --args"/>'
        '<node pkg="pk" exec="e" name="n" output="screen" respawn="yes" cwd="$(dirname)"><env name="A" value="1"/></node>'
        '<executable cmd="ls $(env HOME)/x" name="lister"/>'
    )
    launch = loaded(Workspace(tmp_path, body).launch())
    (node,), (program,) = launch.nodes, launch.programs
    assert node.process is not None
    assert (node.process.environment, node.process.label, node.respawn, node.output) == ({"USER": None, "A": "1"}, "gdb", True, "screen")
    assert node.launch_prefix == "gdb --args"
    assert (program.command, program.process.label) == (("gdb", "--args", "ls", "/home/somebody/x"), "lister")


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("\n<log message='$(var a)'/>", "undeclared-arg main.launch.xml:2"),
        ("<log message='$(env NOT_SET)'/>", "env-unset main.launch.xml:1"),
        ("<node pkg='nowhere' exec='e'/>", "node-package-missing main.launch.xml:1"),
        ("<log message='$(find-pkg-share nowhere)'/>", "package-not-found main.launch.xml:1"),
        ("<node pkg='pk' exec='e' name='a-b'/>", "invalid-node-name main.launch.xml:1"),
        ("<node pkg='pk' exec='e' namespace='1'/>", "invalid-namespace main.launch.xml:1"),
        ("<push_ros_namespace namespace='a//b'/>", "invalid-namespace main.launch.xml:1"),
        ("<node pkg='pk' exec='e' if='yes'/>", "condition-not-boolean main.launch.xml:1"),
        ("<log message='$(not maybe)'/>", "not-a-boolean main.launch.xml:1"),
        ("<node pkg='pk' exec='e' output='loud'/>", "invalid-value main.launch.xml:1"),
        ("<arg name='a'/>", "required-arg-unset main.launch.xml:1"),
        ("<arg name='a' default='x'><choice value='y'/></arg>", "choice-refused main.launch.xml:1"),
        ("<include file='$(dirname)/nowhere.launch.xml'/>", "include-not-found main.launch.xml:1"),
        ("<set_use_sim_time value='true'/>", "never-works main.launch.xml:1"),
        ("<node pkg='pk' exec='e' launch-prefix='&quot;a'/>", "unsplittable-prefix main.launch.xml:1"),
    ],
)
def test_refusals(tmp_path: Path, body: str, expected: str) -> None:
    assert refusal(Workspace(tmp_path, body).launch()) == expected


def test_the_walk_goes_on_and_an_unknown_value_is_no_second_problem(tmp_path: Path) -> None:
    body = "<let name='a' value='$(var x)'/><log message='$(var a)'/>" + SHOW.format("$(var a)") + "<log message='$(var y)'/>"
    launch = Workspace(tmp_path, body).launch()
    assert [problem.name for problem in launch.problems if isinstance(problem, UndeclaredArg)] == ["x", "y"]
    assert launch.nodes[0].unknown == {"arguments"}


def test_an_arg_that_is_set_and_not_passed(tmp_path: Path) -> None:
    body = "<let name='r' value='1'/><include file='$(dirname)/inc.launch.xml'/><include file='$(dirname)/inc.launch.xml'/>"
    launch = Workspace(tmp_path, body, {"inc.launch.xml": "<group><arg name='r'/><log message='$(var r)'/></group>"}).launch()
    assert [type(problem) for problem in launch.problems] == [RequiredArgNotPassed, RequiredArgNotPassed]
    assert refusal(launch) == "required-arg-not-passed main.launch.xml:1"


def test_an_arg_that_is_neither_is_told_once(tmp_path: Path) -> None:
    others = {
        "middle.launch.xml": "<include file='$(find-pkg-share pk)/launch/inc.launch.xml'/>",
        "inc.launch.xml": "<arg name='r'/><log message='$(var r)'/>",
    }
    launch = Workspace(tmp_path, "<include file='$(dirname)/middle.launch.xml'/>", others).launch()
    assert [type(problem) for problem in launch.problems] == [IncludeMissingArg]
    assert refusal(launch) == "include-missing-arg main.launch.xml:1"


def test_a_condition_protects_from_the_look_in_advance(tmp_path: Path) -> None:
    body = "<include file='$(dirname)/inc.launch.xml'/>"
    launch = loaded(Workspace(tmp_path, body, {"inc.launch.xml": "<group if='false'><arg name='r'/></group>"}).launch())
    assert [(each.name, each.required, each.conditional) for each in launch.listed] == [("r", True, True)]


def test_required_args_of_the_entry_file_are_all_told(tmp_path: Path) -> None:
    launch = Workspace(tmp_path, "<arg name='a'/><arg name='b'/>" + SHOW.format("$(var a) $(var b)")).launch()
    assert [problem.name for problem in launch.problems if isinstance(problem, RequiredArgUnset)] == ["a", "b"]
    assert len(launch.problems) == 2


def test_a_file_that_includes_itself(tmp_path: Path) -> None:
    launch = Workspace(tmp_path, "<include file='$(dirname)/a.launch.xml'/>", {"a.launch.xml": "\n<include file='$(filename)'/>"}).launch()
    assert isinstance(launch.refused, IncludeCycle)
    assert launch.refused.cycle == ("pk/launch/a.launch.xml", "pk/launch/a.launch.xml")
    assert refusal(launch) == "include-cycle a.launch.xml:2"


SETTER = (
    "import other\nfrom launch import LaunchDescription\n\n"
    "def generate_launch_description():\n    return LaunchDescription([other.anything()])\n"
)


def test_a_launch_file_in_python_leaves_the_launch_incomplete(tmp_path: Path) -> None:
    body = "<include file='$(dirname)/a.launch.py'><arg name='x' value='1'/></include>" + SHOW.format("$(var x)")
    launch = loaded(Workspace(tmp_path, body, {"a.launch.py": SETTER}).launch())
    assert not launch.complete
    assert [include.arguments for include in launch.includes] == [{"x": "1"}]
    assert launch.nodes[0].arguments == "1"


EMPTY = (
    'from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    """Nothing."""\n    return LaunchDescription([])\n'
)


def test_behind_a_launch_file_in_python_what_is_set_nowhere_may_have_been_set_by_it(tmp_path: Path) -> None:
    reads = SHOW.format("$(var robot)$(env ROBOT)") + "<node pkg='pk' exec='e' name='m'><param name='h' value='$(param height)'/></node>"
    launch = loaded(Workspace(tmp_path, "<include file='$(dirname)/a.launch.py'/>" + reads, {"a.launch.py": SETTER}).launch())
    assert launch.problems == ()
    assert not launch.complete
    shown, measured = launch.nodes
    assert not shown.knows("arguments")
    assert measured.own is not None
    assert isinstance(measured.own["h"][1], Unknown)


@pytest.mark.parametrize(("read", "told"), [("$(var robot)", [UndeclaredArg]), ("$(param height)", [])])
def test_a_group_puts_back_what_a_launch_file_in_python_has_set_but_not_its_params(tmp_path: Path, read: str, told: list[type]) -> None:
    body = "<group><include file='$(dirname)/a.launch.py'/></group>" + SHOW.format(read)
    launch = Workspace(tmp_path, body, {"a.launch.py": SETTER}).launch()
    assert [type(problem) for problem in launch.problems] == told


def test_a_launch_file_in_python_that_describes_nothing_sets_nothing(tmp_path: Path) -> None:
    body = "<include file='$(dirname)/a.launch.py'/>" + SHOW.format("$(var robot)")
    launch = Workspace(tmp_path, body, {"a.launch.py": EMPTY}).launch()
    assert isinstance(launch.refused, UndeclaredArg)
    assert launch.complete


def test_the_output_of_a_command_is_not_known(tmp_path: Path) -> None:
    body = "<node pkg='pk' exec='e' name='n' if=\"$(command 'true')\"><param name='v' value=\"$(command 'rm -r $(env HOME)')\"/></node>"
    launch = loaded(Workspace(tmp_path, body).launch())
    (node,) = launch.nodes
    assert node.conditions[0].assumed
    assert node.own is not None
    value = node.own["v"][1]
    assert isinstance(value, Unknown)
    assert value.text == "$(command rm -r /home/somebody)"


def test_doubling_values_end_soon(tmp_path: Path) -> None:
    double = "<let name='a' value='$(var a)$(var a)'/>" * 60
    launch = Workspace(tmp_path, "<let name='a' value='xxxxxxxxxx'/>" + double).launch()
    assert [problem.kind for problem in launch.problems] == ["evaluation-bound"]
    assert not launch.complete


def test_includes_that_double_end_soon(tmp_path: Path) -> None:
    twice = "<include file='$(dirname)/{0}.launch.xml'/><include file='$(dirname)/{0}.launch.xml'/>"
    files = {f"{number}.launch.xml": twice.format(number + 1) for number in range(40)} | {"40.launch.xml": NODE.format("n")}
    launch = Workspace(tmp_path, twice.format(0), files).launch()
    assert [problem.kind for problem in launch.problems] == ["evaluation-bound"]
    assert not launch.complete


def test_names_of_nodes(tmp_path: Path) -> None:
    body = '<node pkg="pk" exec="e"/><node pkg="pk" exec="e" name="b" namespace="/s"/>'
    assert named(loaded(Workspace(tmp_path, body).launch())) == ["", "/s/b"]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("<let name='a{}' value='1'/>", "<group/>"),
        ("<set_remap from='a{}' to='b'/>", "<node pkg='pk' exec='e'/>"),
        ("<set_parameter name='a{}' value='1'/>", "<node pkg='pk' exec='e'/>"),
        ("<set_env name='a{}' value='1'/>", "<group/>"),
        ("<arg name='a{}' default='1'/>", "<log message='$(var no)'/>"),
        ("<timer period='1.0'><log message='$(var a{})'/></timer>", "<timer period='1.0'/>"),
    ],
)
def test_great_numbers_end_soon(tmp_path: Path, first: str, second: str) -> None:
    many = 3_000
    start = process_time()
    Workspace(tmp_path, "".join(map(first.format, range(many))) + second * many).launch()
    assert process_time() - start < 30


def test_a_deferred_body_ends_with_the_first_error_in_it(tmp_path: Path) -> None:
    """What stands behind it is neither started nor deferred; what is wrong with it is told all the same."""
    later = NODE.format("later") + '<timer period="1.0">' + NODE.format("never") + "</timer>"
    body = f'<timer period="1.0">{NODE.format("first")}<log message="$(var a)"/>{later}<log message="$(var b)"/></timer>'
    launch = loaded(Workspace(tmp_path, body).launch())
    assert named(launch) == ["first"]
    assert [problem.kind for problem in launch.late] == ["undeclared-arg"]
    assert sorted(problem.name for problem in launch.problems if isinstance(problem, UndeclaredArg)) == ["a", "b"]


def test_behind_a_package_that_is_not_here_a_deferred_body_may_go_on(tmp_path: Path) -> None:
    """Somebody may have that package: what stands in the body is not passed over in silence, nor told as certain."""
    missing = '<node pkg="nowhere" exec="e" name="there"/>'
    body = (
        f'<timer period="1.0">{NODE.format("first")}{missing}{NODE.format("later")}<log message="$(var a)"/>{NODE.format("never")}</timer>'
    )
    launch = loaded(Workspace(tmp_path, body).launch())
    assert named(launch) == ["first", "there", "later"]
    assert [[each.text for each in node.conditions] for node in launch.nodes] == [
        [],
        *[["it needs the package nowhere, which is not here"]] * 2,
    ]
    assert {node.deferred for node in launch.nodes} == {"timer"}


def test_an_arg_with_a_wrong_choice_is_not_declared(tmp_path: Path) -> None:
    body = '<timer period="1.0"><arg name="a" default="x"><choice value="y"/></arg></timer>'
    assert loaded(Workspace(tmp_path, body).launch()).declarations == ()


def test_the_log_directory_is_that_of_the_start(tmp_path: Path) -> None:
    assert shown(tmp_path, '<unset_env name="HOME"/>' + SHOW.format("$(log_dir)")) == ["/home/somebody/.ros/log/launch"]


@pytest.mark.parametrize("text", ["$(eval 1 'a b')", "$(equals '$(eval &quot;1 +&quot;)' 2)"])
def test_no_module_has_such_a_name(tmp_path: Path, text: str) -> None:
    """In quotes the other quotes are letters: what they were meant to hold together is an expression and modules to launch."""
    assert refusal(Workspace(tmp_path, f'<log message="{text}"/>').launch()) == "eval-error main.launch.xml:1"


@pytest.mark.parametrize(
    ("body", "names"),
    [
        ('<log message="$(var a)"/><arg name="a" default="1"/>', ["a"]),
        ('<group><let name="a" value="1"/></group><log message="$(var a)"/>', ["a"]),
        ('<let name="a" value="1"/><group forwarding="false"><log message="$(var a)"/></group>', ["a"]),
        ('<log message="$(var a)"/><let name="a" value="1" if="false"/><arg name="b"/>', []),
        ('<log message="$(var a)"/>', []),
    ],
)
def test_where_a_configuration_is_set_that_is_not_set_here(tmp_path: Path, body: str, names: list[str]) -> None:
    problems = [problem for problem in Workspace(tmp_path, body).launch().problems if isinstance(problem, UndeclaredArg)]
    assert [problem.name for problem in problems if problem.elsewhere] == names
