"""Random launch files in Python that keep what is set and put it back, by themselves and by groups, rightly and wrongly."""

from __future__ import annotations

from pathlib import Path
from random import Random

PACKAGE = "<package format='3'><name>pk</name><version>0.0.0</version><description>d</description></package>\n"
HEAD = """from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.substitutions import *
from launch_ros.actions import *
import os


def shown(name):
    asked = {}
    for key in 'abc':
        asked['IS_' + key] = LaunchConfiguration(key, default='-')
        asked['WAS_' + key] = EnvironmentVariable('E' + key, default_value='-')
    return Node(package='pk', executable='e', name=name, additional_env=asked)


"""
_INCLUDED = "os.path.join(os.path.dirname(__file__), 'included.launch.py')"
_KEPT = ("", "{}", "{'a': 'kept', 'b': LaunchConfiguration('c', default='q')}")


class RandomProgram:
    """A launch file that includes another one, with ``conditions`` that are put in when it is written, by their numbers."""

    def __init__(self, seed: int, doubts: int = 0) -> None:
        self._random = Random(seed)
        self._nodes = 0
        self.conditions = 0
        self._doubts = doubts
        main = self._actions(0)
        if self._random.random() < 0.75:
            main = ["PushLaunchConfigurations()", "PushEnvironment()"] * self._random.randint(1, 4) + main
        self._main = self._program(main)
        self._included = self._program(self._actions(2, includes=False))

    def write(self, directory: Path, conditions: tuple[str, ...] = ()) -> Path:
        """The path of the launch file, in a package below ``directory``."""
        package = directory / "pk"
        (package / "launch").mkdir(parents=True)
        (package / "package.xml").write_text(PACKAGE)
        for name, text in (("main", self._main), ("included", self._included)):
            for number, each in enumerate(conditions):
                text = text.replace(f"<{number}>", each)
            (package / f"launch/{name}.launch.py").write_text(text)
        return package / "launch/main.launch.py"

    def _program(self, actions: list[str]) -> str:
        listed = "".join(f"        {each},\n" for each in actions)
        if self._random.random() < 0.2:
            function = f"def setup(context):\n    return [\n{listed}    ]\n\n\n"
            listed = "        OpaqueFunction(function=setup),\n"
        else:
            function = ""
        return f"{HEAD}{function}def generate_launch_description():\n    return LaunchDescription([\n{listed}    ])\n"

    def _condition(self) -> str:
        if self.conditions < self._doubts and self._random.random() < 0.3:
            self.conditions += 1
            return f"condition=IfCondition(<{self.conditions - 1}>)"
        return self._random.choice(
            ("", "", "", "condition=IfCondition('true')", "condition=UnlessCondition(LaunchConfiguration('c', default='false'))")
        )

    def _actions(self, depth: int, *, includes: bool = True) -> list[str]:
        found = []
        for _ in range(self._random.randint(2, 7)):
            made = self._action(depth, includes=includes)
            if made:
                found.append(made)
            self._nodes += 1
            found.append(f"shown('n{self._nodes}')")
        return found

    def _action(self, depth: int, *, includes: bool) -> str:
        random = self._random
        name, value, condition = random.choice("abc"), random.choice(("1", "2", "x")), self._condition()
        also = f", {condition}" if condition else ""
        kind = random.randrange(15)
        if kind < 4:
            what = "LaunchConfigurations" if kind < 2 else "Environment"
            return f"{'Pop' if kind % 2 and random.random() < 0.8 else 'Push'}{what}({condition})"
        if kind == 4:
            return f"SetLaunchConfiguration('{name}', '{value}'{also})"
        if kind == 5:
            return f"SetEnvironmentVariable('E{name}', [LaunchConfiguration('{name}', default='n'), '{value}']{also})"
        if kind == 6:
            kept = random.choice(_KEPT)
            return f"ResetLaunchConfigurations({kept}{also if kept else condition})"
        if kind == 7:
            return f"ResetEnvironment({condition})"
        if kind == 8:
            return f"UnsetLaunchConfiguration('{name}'{also})" if random.random() < 0.5 else f"UnsetEnvironmentVariable('E{name}'{also})"
        if kind == 9 and depth < 3:
            scoped, forwarding = random.choice((True, True, False)), random.choice((True, True, False))
            inner = ", ".join(self._actions(depth + 1, includes=includes))
            return f"GroupAction([{inner}], scoped={scoped}, forwarding={forwarding}{also})"
        if kind == 10:
            return f"PushRosNamespace('{name}'{also})"
        if kind == 11:
            return f"SetRemap('{name}', 't{value}'{also})" if random.random() < 0.5 else f"SetParameter('p{name}', '{value}'{also})"
        if kind == 12 and includes:
            return f"IncludeLaunchDescription({_INCLUDED}, launch_arguments={{'{name}': '{value}'}}.items(){also})"
        if kind == 13:
            return f"DeclareLaunchArgument('{name}', default_value='d{value}')"
        if kind == 14 and random.random() < 0.4:
            return f"TimerAction(period=1.0, actions=[{', '.join(self._actions(depth + 2, includes=includes))}])"
        return f"AppendEnvironmentVariable('E{name}', '{value}')" if kind == 14 else ""
