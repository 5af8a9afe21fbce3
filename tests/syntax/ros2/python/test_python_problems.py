"""What launch stops for in launch files in Python: which problem, where, and whether it is certain."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.problem import Problem
from launchlint.syntax.ros2.python.problems import (
    ConfigurationAsPythonValue,
    KeywordNotInDistribution,
    LaunchArgumentsNotPairs,
    MissingArgument,
    NoDescription,
    NotACondition,
    NotAnAction,
    NotAParameterValue,
    NotASubstitution,
    TextForList,
    TooManyPositional,
    UnknownKeyword,
    WrongModule,
    WrongSourceClass,
)
from tests.syntax.ros2.python.test_python_reading import HEAD, reading

NODE = "package='p', executable='e'"


def problems(text: str, directory: Path, distro: str = "jazzy") -> tuple[Problem, ...]:
    """What is noticed in a file, whether or not the rest of it is understood."""
    return reading(text, directory, distro).problems


def one(text: str, directory: Path, distro: str = "jazzy") -> Problem:
    """The only problem of a file."""
    (found,) = problems(text, directory, distro)
    return found


def made(expression: str, directory: Path, distro: str = "jazzy") -> Problem:
    """The only problem of a file that describes what one expression makes."""
    return one(f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{expression}])\n", directory, distro)


@pytest.mark.parametrize(
    ("expression", "kind", "at", "refused"),
    [
        ("Node(package='p', node_executable='e')", UnknownKeyword, "node_executable", True),
        (f"Node({NODE}, foo=1)", UnknownKeyword, "foo", True),
        (f"Node({NODE}, **{{'foo': 1}})", UnknownKeyword, "Node", True),
        ("Node(package='p')", MissingArgument, "Node", True),
        ("LogInfo('hello')", TooManyPositional, "'hello'", True),
        ("LogInfo(msg=PathJoinSubstitution('a', 'b'))", TooManyPositional, "'b'", True),
        ("DeclareLaunchArgument('a', default_value=True)", NotASubstitution, "True", True),
        (f"Node({NODE}, arguments=['--rate', 5])", NotASubstitution, "5", True),
        (f"Node({NODE}, name=['a', None])", NotASubstitution, "None", True),
        (f"Node({NODE}, name=5, condition=IfCondition('true'))", NotASubstitution, "5", False),
        (f"Node({NODE}, name=DeclareLaunchArgument('n'))", NotASubstitution, "DeclareLaunchArgument('n')", True),
        (f"Node({NODE}, additional_env={{'A': 1}})", NotASubstitution, "1", True),
        (f"Node({NODE}, remappings=[('a', 5)])", NotASubstitution, "5", True),
        ("TimerAction(period=5, actions=[])", NotASubstitution, "5", True),
        ("IncludeLaunchDescription('a.py', launch_arguments={'x': True}.items())", NotASubstitution, "True", True),
        ("IncludeLaunchDescription('a.py', launch_arguments=[('x', True)])", NotASubstitution, "True", True),
        (f"Node({NODE}, parameters=[{{'a': None}}])", NotAParameterValue, "None", True),
        (f"Node({NODE}, parameters=[{{'a': {{'b': []}}}}])", NotAParameterValue, "[]", True),
        (f"Node({NODE}, parameters=[{{'a': [1, 'b']}}])", NotAParameterValue, "[1, 'b']", True),
        (f"Node({NODE}, condition=True)", NotACondition, "True", True),
        (f"Node({NODE}, condition=LaunchConfiguration('a'))", NotACondition, "LaunchConfiguration('a')", True),
        ("IncludeLaunchDescription('a.py', launch_arguments={'x': 'y'})", LaunchArgumentsNotPairs, "{'x': 'y'}", True),
        ("IncludeLaunchDescription('a.py', launch_arguments={'ns': 'y'})", LaunchArgumentsNotPairs, "{'ns': 'y'}", False),
        (f"Node({NODE}, arguments='--x 1')", TextForList, "'--x 1'", False),
        (f"Node({NODE}, ros_arguments=('--log-level', 'info'))", TextForList, "('--log-level', 'info')", True),
        (f"Node({NODE}, parameters={{'a': 1}})", TextForList, "{'a': 1}", True),
        (f"Node({NODE}, parameters='f.yaml')", TextForList, "'f.yaml'", True),
        (f"Node({NODE}, parameters=LaunchConfiguration('f'))", TextForList, "LaunchConfiguration('f')", True),
        (f"Node({NODE}, remappings=('a', 'b'))", TextForList, "('a', 'b')", True),
        (f"Node({NODE}, remappings=[['a', 'b']])", TextForList, "['a', 'b']", True),
        (f"Node({NODE}, remappings=[('a', 'b', 'c')])", TextForList, "('a', 'b', 'c')", True),
        (f"Node({NODE}, remappings={{'a': 'b'}})", TextForList, "{'a': 'b'}", True),
        ("None", NotAnAction, "None", True),
        (f"[Node({NODE})]", NotAnAction, f"[Node({NODE})]", True),
        ("GroupAction([LaunchConfiguration('a')])", NotAnAction, "LaunchConfiguration('a')", True),
        ("IncludeLaunchDescription(PythonLaunchDescriptionSource('d/a.xml'))", WrongSourceClass, "PythonLaunchDescriptionSource", True),
        (f"Node({NODE}) if LaunchConfiguration('a') else LogInfo(msg='')", ConfigurationAsPythonValue, "LaunchConfiguration('a')", False),
        ("LogInfo(msg=f\"{LaunchConfiguration('a')}\")", ConfigurationAsPythonValue, "LaunchConfiguration('a')", False),
        ("LogInfo(msg='a' + LaunchConfiguration('a'))", ConfigurationAsPythonValue, "'a' + LaunchConfiguration('a')", True),
        ("LogInfo(msg=os.path.join('a', LaunchConfiguration('a')))", ConfigurationAsPythonValue, "LaunchConfiguration('a')", True),
        ("LogInfo(msg=str(LaunchConfiguration('a')))", ConfigurationAsPythonValue, "str(LaunchConfiguration('a'))", False),
        ("LogInfo(msg='' if LaunchConfiguration('a') == 'x' else 'n')", ConfigurationAsPythonValue, "LaunchConfiguration('a') == 'x'", 0),
    ],
)  # fmt: skip
def test_a_problem(expression: str, kind: type, at: str, refused: bool, tmp_path: Path) -> None:
    found = made(expression, tmp_path)
    assert type(found) is kind
    assert (found.place.text, found.refused) == (at, refused)


@pytest.mark.parametrize(
    "expression",
    [
        f"Node({NODE}, name=None, namespace=None, arguments=None, parameters=None, remappings=None, condition=None)",
        f"Node({NODE}, arguments=['a', ['b', LaunchConfiguration('c')]], remappings=[('a', ['b', LaunchConfiguration('c')])])",
        f"Node({NODE}, parameters=[{{'a': [1, 2.0], 'b': LaunchConfiguration('c'), 'd': ParameterValue('5', value_type=str)}}, 'f.yaml'])",
        f"Node({NODE}, output='screen', emulate_tty=True, log_cmd=True)",
        "DeclareLaunchArgument('a', default_value=['x', LaunchConfiguration('y')], choices=['x'])",
        "TimerAction(period=5.0, actions=[LogInfo(msg='a')])",
        "TimerAction(period=LaunchConfiguration('t'), actions=[LogInfo(msg='a')])",
        "IncludeLaunchDescription(PythonLaunchDescriptionSource(['a', '/b.launch.py']), launch_arguments=[('x', 'y')])",
        "LogInfo(msg='y' if LaunchConfiguration('a') is None else 'n')",
        "LaunchDescription([LogInfo(msg='a')])",
    ],
)
def test_no_problem(expression: str, tmp_path: Path) -> None:
    text = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{expression}])\n"
    assert reading(text, tmp_path).problems == ()


@pytest.mark.parametrize(
    ("text", "form", "what"),
    [
        ("", "missing", ""),
        ("def generate_launch_description(context):\n    pass\n", "arguments", "context"),
        ("def generate_launch_description():\n    pass\n", "nothing", "None"),
        ("def generate_launch_description():\n    return []\n", "list", "a list"),
        ("def generate_launch_description():\n    return 5\n", "other", "5, an integer"),
        ("def (:\n", "syntax", "invalid syntax"),
        ("print 'Python 2'\n", "syntax", "Missing parentheses in call to 'print'. Did you mean print(...)?"),
    ],
)
def test_no_description(text: str, form: str, what: str, tmp_path: Path) -> None:
    found = one(text, tmp_path)
    assert isinstance(found, NoDescription)
    assert (found.form, found.what, found.refused) == (form, what, True)


def test_what_foxy_had(tmp_path: Path) -> None:
    found = made("Node(package='p', node_executable='e')", tmp_path)
    assert isinstance(found, UnknownKeyword)
    assert (found.callee, found.replacement, found.since) == ("Node", "executable", "galactic")


def test_what_is_newer(tmp_path: Path) -> None:
    expression = "LogInfo(msg=PythonExpression(['1'], python_modules=['math']))"
    found = made(expression, tmp_path, "humble")
    assert isinstance(found, KeywordNotInDistribution)
    assert (found.place.text, found.since, found.sure) == ("python_modules", "jazzy", True)
    assert reading(f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{expression}])\n", tmp_path).problems == ()


def test_a_name_of_another_module(tmp_path: Path) -> None:
    head = "from launch.substitutions import FindPackageShare, LaunchConfiguration\n"
    found = one(f"{head}{HEAD}def generate_launch_description():\n    return LaunchDescription()\n", tmp_path)
    assert isinstance(found, WrongModule)
    assert (found.place.text, found.right, found.alone) == ("FindPackageShare", "launch_ros.substitutions", False)


@pytest.mark.parametrize(
    "body",
    [
        "try:\n        n = [Node(package='p')]\n    except TypeError:\n        n = None",
        "if os.getcwd():\n        n = [Node(package='p')]",
    ],
)
def test_what_may_not_come_to_pass(body: str, tmp_path: Path) -> None:
    text = f"{HEAD}def generate_launch_description():\n    {body}\n    return LaunchDescription()\n"
    found = one(text, tmp_path)
    assert isinstance(found, MissingArgument)
    assert (found.refused, found.assumed) == (False, True)


def test_a_function_that_nobody_calls_is_not_judged(tmp_path: Path) -> None:
    text = f"{HEAD}def old():\n    return Node(package='p')\ndef generate_launch_description():\n    return LaunchDescription()\n"
    assert reading(text, tmp_path).problems == ()
