"""The constructs of launch files in Python."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import isqrt

from tests.growth.ros2 import BUILD, PACKAGE
from tests.growth.workspace import Construct, times

ENTRY = "launch/a.launch.py"
HEAD = """\
import os

from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode


"""
EACH = "Node(package='demo', executable='talk', name='n{}')"
ONE = EACH.replace("{}", "")
INNER = "IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(os.path.dirname(__file__), 'b.launch.py')))"
COMPONENT = "ComposableNode(package='demo', plugin='demo::Talk', name='c{}')"
TALKER = "Node(package='demo_nodes_cpp', executable='talker', name='talker{}', remappings=[('chatter', 'topic{}')])"
LISTENER = "Node(package='demo_nodes_cpp', executable='listener', name='listener{}', remappings=[('chatter', '{to}')])"
DEEPEST = 60
"""Brackets in each other: Python itself takes no more than 200, and an action inside of another one needs three."""


def launch(*parts: str, before: str = "") -> str:
    """The text of a launch file whose description holds these actions."""
    return f"{HEAD}{before}\ndef generate_launch_description():\n    return LaunchDescription([\n{''.join(parts)}\n    ])\n"


def node(**given: str) -> str:
    """One node with these keywords."""
    return f"Node(package='demo', executable='talk', name='one', {', '.join(f'{key}={value}' for key, value in given.items())}),\n"


def listed(count: int, action: str) -> str:
    """The action so many times."""
    return times(count, f"        {action},")


def _construct(
    name: str,
    text: Callable[[int], str],
    inner: Callable[[int], Mapping[str, str]] | None = None,
    most: int = 100_000,
    product: bool = False,
) -> Construct:
    def files(count: int) -> Mapping[str, str]:
        others = {f"launch/{file}": content for file, content in inner(count).items()} if inner else {}
        return {".git/HEAD": "", "package.xml": PACKAGE, "CMakeLists.txt": BUILD, ENTRY: text(count), **others}

    return Construct(f"Python: {name}", ENTRY, files, most, product)


def _repeated(name: str, action: str, first: str = "", last: str = "", before: str = "", *, product: bool = False) -> Construct:
    return _construct(name, lambda count: launch(first, listed(count, action), last, before=before), product=product)


def _statements(name: str, line: str, after: str = "", *, product: bool = False) -> Construct:
    """Lines of a function, which makes ``description``."""

    def text(count: int) -> str:
        lines = times(count, f"    {line}")
        return f"{HEAD}def generate_launch_description():\n    description = LaunchDescription()\n{lines}\n{after}    return description\n"

    return _construct(name, text, product=product)


def _levels(count: int, copies: int) -> Mapping[str, str]:
    """Files of which each includes the next one, so many times."""
    again = {f"b{level}.launch.py": launch(f"{INNER}, ".replace("'b.", f"'b{level + 1}.") * copies) for level in range(count)}
    return {**again, f"b{count}.launch.py": launch("SetLaunchConfiguration('x', '1')")}


CONSTRUCTS = (
    _repeated("nodes", EACH),
    _repeated("nodes of one name", ONE),
    _repeated("args", "DeclareLaunchArgument('a{}', default_value='1')"),
    _repeated("args declared twice", "DeclareLaunchArgument('a', default_value='{}')"),
    _repeated(
        "chain of args",
        "DeclareLaunchArgument('a{+}', default_value=LaunchConfiguration('a{}'))",
        first="DeclareLaunchArgument('a0', default_value='1'),\n",
    ),
    _repeated(
        "chain of configurations",
        "SetLaunchConfiguration('a{+}', LaunchConfiguration('a{}'))",
        first="SetLaunchConfiguration('a0', '1'),\n",
    ),
    _repeated("environment", "SetEnvironmentVariable('A{}', 'b')", last=f"\n{ONE}"),
    _repeated("remaps for all", "SetRemap('a{}', 'b{}')", last=f"\n{ONE}"),
    _repeated("params for all", "SetParameter('p{}', 1)", last=f"\n{ONE}"),
    _repeated(
        "conditions of one arg",
        EACH.replace(")", ", condition=IfCondition(LaunchConfiguration('a')))"),
        first="DeclareLaunchArgument('a', default_value='true'),\n",
    ),
    _construct(
        "conditions",
        lambda count: launch(
            listed(count, "DeclareLaunchArgument('a{}', default_value='true')"),
            "\n",
            listed(count, EACH.replace(")", ", condition=IfCondition(LaunchConfiguration('a{}')))")),
        ),
    ),
    _repeated("expressions", "SetLaunchConfiguration('a{}', PythonExpression(['1 + ', '{}']))"),
    _repeated("groups", f"GroupAction([PushRosNamespace('g{{}}'), {EACH}])"),
    _construct("depth of groups", lambda count: launch("GroupAction([" * count + ONE + "])" * count), most=DEEPEST),
    _repeated("processes", "ExecuteProcess(cmd=['ls', '{}'])"),
    _repeated("timers", f"TimerAction(period=1.0, actions=[{EACH}])"),
    _repeated(
        "handlers",
        f"RegisterEventHandler(OnProcessExit(target_action=one, on_exit=[{EACH}]))",
        first="one,\n",
        before=f"one = {ONE}\n\n",
    ),
    _repeated("functions that are called", "OpaqueFunction(function=made)", before=f"def made(context):\n    return [{ONE}]\n\n"),
    _construct("remaps of a node", lambda count: launch(node(remappings=f"[{times(count, '''('a{}', 'b{}')''', ', ')}]"))),
    _construct("params of a node", lambda count: launch(node(parameters="[{" + times(count, "'p{}': 1", ", ") + "}]"))),
    _construct("sets of params of a node", lambda count: launch(node(parameters="[" + times(count, "{'p{}': 1}", ", ") + "]"))),
    _construct("arguments of a node", lambda count: launch(node(arguments="[" + times(count, "'a{}'", ", ") + "]"))),
    _construct("variables of a node", lambda count: launch(node(additional_env="{" + times(count, "'A{}': 'b'", ", ") + "}"))),
    _construct(
        "parts of a value",
        lambda count: launch(
            "DeclareLaunchArgument('a', default_value='1'), SetLaunchConfiguration('x', [",
            times(count, "LaunchConfiguration('a')", ", "),
            "])",
        ),
    ),
    _construct("letters of a value", lambda count: launch(f"SetLaunchConfiguration('x', '{'abcdefghij' * count}')")),
    _construct("long sum", lambda count: launch(f"SetLaunchConfiguration('x', {' + '.join([repr('a')] * count)})"), most=900),
    _construct(
        "components",
        lambda count: launch(
            "ComposableNodeContainer(package='demo', executable='talk', name='n', namespace='', composable_node_descriptions=[\n",
            listed(count, COMPONENT),
            "\n])",
        ),
    ),
    _repeated(
        "loaded components",
        f"LoadComposableNodes(target_container='m', composable_node_descriptions=[{COMPONENT}])",
        first="ComposableNodeContainer(package='demo', executable='talk', name='m', namespace=''),\n",
    ),
    _repeated("packages nobody has", "Node(package='demo{}', executable='talk', name='n{}')"),
    _repeated("programs nobody has", "Node(package='demo', executable='talk{}', name='n{}')"),
    _repeated("keywords nobody knows", "Node(package='demo', executable='talk', name='n{}', nam='a')"),
    _repeated("names nobody set", "SetLaunchConfiguration('b{}', LaunchConfiguration('a{}'))", product=True),
    _repeated("pairs", f"{TALKER}, {LISTENER.replace('{to}', 'topic{}')}"),
    _repeated("pairs that just miss", f"{TALKER}, {LISTENER.replace('{to}', 'topik{}')}"),
    _repeated("a hub", f"{TALKER.replace('topic{}', 'topic')}, {LISTENER.replace('{to}', 'topic')}"),
    _statements("actions that are added", f"description.add_action({EACH})"),
    _statements("names of Python", "x{} = 'a{}'"),
    _statements("chain of names of Python", "x{+} = x{}"),
    _statements("one name of Python", "x = 'a{}'"),
    _statements("branches of Python", f"if os.path.exists('/nowhere/{{}}'):\n        description.add_action({EACH})"),
    _statements(
        "a text that grows", "x = ('' if {} == 0 else x) + 'abcdefghij'", after="    description.add_action(LogInfo(msg=x))\n", product=True
    ),
    _statements("a text that doubles", "x = ('a' if {} == 0 else x) * 2", after="    description.add_action(LogInfo(msg=x))\n"),
    _statements("a list that doubles", "x = ([1] if {} == 0 else x) + x", after="    description.add_action(LogInfo(msg=str(x)))\n"),
    _construct(
        "functions of Python",
        lambda count: launch(listed(count, "made{}()"), before=times(count, f"def made{{}}():\n    return {EACH}\n\n")),
    ),
    _construct(
        "a loop of Python",
        lambda count: (
            f"{HEAD}def generate_launch_description():\n    description = LaunchDescription()\n    for number in range({count}):\n"
            f"        description.add_action(Node(package='demo', executable='talk', name='n' + str(number)))\n    return description\n"
        ),
    ),
    _construct(
        "includes of one file",
        lambda count: launch(listed(count, INNER)),
        lambda _: {"b.launch.py": launch("SetLaunchConfiguration('x', '1')")},
    ),
    _construct(
        "includes with an arg",
        lambda count: launch(listed(count, INNER[:-1] + ", launch_arguments={'a': '{}'}.items())")),
        lambda _: {"b.launch.py": launch("DeclareLaunchArgument('a'), SetLaunchConfiguration('x', LaunchConfiguration('a'))")},
    ),
    _construct(
        "args handed on",
        lambda count: launch(INNER[:-1], ", launch_arguments={", times(count, "'a{}': '1'", ", "), "}.items())"),
        lambda count: {"b.launch.py": launch(listed(count, "DeclareLaunchArgument('a{}')"))},
    ),
    _construct(
        "files",
        lambda count: launch(listed(count, INNER.replace("'b.", "'b{}."))),
        lambda count: {f"b{number}.launch.py": launch(EACH.replace("{}", str(number))) for number in range(count)},
        most=10_000,
    ),
    _construct("depth of includes", lambda _: launch(INNER.replace("'b.", "'b0.")), lambda count: _levels(count, 1), most=10_000),
    _construct(
        "includes that meet again",
        lambda _: launch(INNER.replace("'b.", "'b0.")),
        lambda count: _levels(isqrt(count), 2),
        most=10_000,
        product=True,
    ),
)
