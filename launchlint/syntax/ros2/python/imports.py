"""What a launch file imports from launch and launch_ros, by names that are in another of their modules."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from functools import lru_cache

from launchlint.problem import Problem
from launchlint.source import Origin, Place
from launchlint.syntax.ros2.python.problems import WrongModule

_MODULES = """
launch Action Condition Event EventHandler InvalidLaunchFileError LaunchContext LaunchDescription LaunchDescriptionEntity
    LaunchDescriptionSource LaunchIntrospector LaunchService SomeActionsType SomeEntitiesType SomeEntitiesType_types_tuple
    SomeSubstitutionsType SomeSubstitutionsType_types_tuple Substitution
launch.actions AppendEnvironmentVariable DeclareLaunchArgument EmitEvent ExecuteLocal ExecuteProcess ForEach ForLoop GroupAction
    IncludeLaunchDescription LogInfo OpaqueCoroutine OpaqueFunction PopEnvironment PopLaunchConfigurations PushEnvironment
    PushLaunchConfigurations ReplaceEnvironmentVariables ResetEnvironment ResetLaunchConfigurations RegisterEventHandler
    SetEnvironmentVariable SetLaunchConfiguration Shutdown TimerAction UnregisterEventHandler UnsetEnvironmentVariable
    UnsetLaunchConfiguration
launch.conditions IfCondition InvalidConditionExpressionError LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition
    evaluate_condition_expression
launch.event_handlers OnExecutionComplete OnIncludeLaunchDescription OnProcessExit OnProcessIO OnProcessStart OnShutdown event_named
launch.launch_description_sources AnyLaunchDescriptionSource FrontendLaunchDescriptionSource PythonLaunchDescriptionSource
    InvalidFrontendLaunchFileError InvalidLaunchFileError InvalidPythonLaunchFileError get_launch_description_from_any_launch_file
    get_launch_description_from_frontend_launch_file get_launch_description_from_python_launch_file load_python_launch_file_as_module
launch.substitutions AllSubstitution AndSubstitution AnonName AnySubstitution BooleanSubstitution Command EnvironmentVariable
    EqualsSubstitution FileContent FindExecutable ForEachVar ForLoopIndex IfElseSubstitution LaunchConfiguration LaunchLogDir
    LocalSubstitution NotEqualsSubstitution NotSubstitution OrSubstitution PathJoinSubstitution PathSubstitution PythonExpression
    StringJoinSubstitution SubstitutionFailure TextSubstitution ThisLaunchFile ThisLaunchFileDir
launch_ros.actions ComposableNodeContainer LifecycleNode LifecycleTransition LoadComposableNodes Node PushROSNamespace PushRosNamespace
    ROSTimer RosTimer SetParameter SetParametersFromFile SetROSLogDir SetRemap SetUseSimTime
launch_ros.descriptions ComposableLifecycleNode ComposableNode ParameterFile ParameterValue
launch_ros.event_handlers OnStateTransition
launch_ros.substitutions ExecutableInPackage FindPackage FindPackagePrefix FindPackageShare
launch_xml.launch_description_sources XMLLaunchDescriptionSource
launch_yaml.launch_description_sources YAMLLaunchDescriptionSource
"""
"""What the modules export, in any distribution; ``Parameter`` and other names that several of them have are left out."""
_CLOSED = frozenset(
    """launch launch.actions launch.conditions launch.event_handlers launch.launch_description_sources launch.substitutions
    launch_ros.actions launch_ros.descriptions launch_ros.event_handlers launch_ros.substitutions""".split()
)


@lru_cache(maxsize=1)
def _homes() -> dict[str, str]:
    """Name → the module that has it."""
    lines = _MODULES.strip().replace("\n    ", " ").splitlines()
    return {name: module for module, *names in (line.split() for line in lines) for name in names}


def wrong_imports(tree: ast.Module, place: Callable[[ast.AST], Place]) -> Iterator[Problem]:
    """The imports at the top of a module that fail: ``launch.substitutions`` has no ``FindPackageShare``."""
    homes = _homes()
    for node in tree.body:
        if not isinstance(node, ast.ImportFrom) or node.level or node.module not in _CLOSED:
            continue
        for alias in node.names:
            right = homes.get(alias.name, node.module)
            if right != node.module:
                yield WrongModule(
                    origin=Origin(place(alias)),
                    refused=True,
                    related=((place(node), "imported here"),),
                    name=alias.name,
                    module=node.module or "",
                    right=right,
                    alone=len(node.names) == 1,
                )
