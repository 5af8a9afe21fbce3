"""The classes of launch and launch_ros that launch files in Python make, with what their constructors take.

A line is a class: its full name with its arguments in order; ``x=`` need not be given, ``*`` stands before those that have to be named,
``*x`` for any number of values without a name, ``+process`` for everything that a process takes, ``+node`` for that and what a node takes,
and ``+`` for what every action takes.
Source: the constructors in ``launch`` and ``launch_ros``.
"""

from __future__ import annotations

from functools import lru_cache

from launchlint.named_tuple import NamedTuple

_CLASSES = """
launch.LaunchDescription initial_entities= * deprecated_reason=
launch.actions.DeclareLaunchArgument name * default_value= description= choices= +
launch.actions.SetLaunchConfiguration name value +
launch.actions.UnsetLaunchConfiguration name +
launch.actions.GroupAction actions * scoped= forwarding= launch_configurations= +
launch.actions.IncludeLaunchDescription launch_description_source * launch_arguments= +
launch.actions.ExecuteProcess * cmd name= +process
launch.actions.LogInfo * msg +
launch.actions.OpaqueFunction * function args= kwargs= +
launch.actions.ForLoop length * function name= +
launch.actions.ForEach input_values * function +
launch.actions.RegisterEventHandler event_handler +
launch.actions.UnregisterEventHandler event_handler +
launch.actions.EmitEvent * event +
launch.actions.OpaqueCoroutine * coroutine args= kwargs= ignore_context= +
launch.actions.ResetLaunchConfigurations launch_configurations= +
launch.event_handlers.OnProcessExit * target_action= on_exit handle_once=
launch.event_handlers.OnProcessStart * target_action= on_start handle_once=
launch.event_handlers.OnProcessIO * target_action= on_stdin= on_stdout= on_stderr= handle_once=
launch.event_handlers.OnShutdown * on_shutdown handle_once=
launch.event_handlers.OnExecutionComplete * target_action= on_completion handle_once=
launch.EventHandler * matcher entities= handle_once=
launch.event_handler.EventHandler * matcher entities= handle_once=
launch_ros.event_handlers.OnStateTransition * entities target_lifecycle_node= transition= start_state= goal_state= matcher= handle_once=
launch.LaunchDescriptionSource launch_description= location= * method=
launch.launch_description_source.LaunchDescriptionSource launch_description= location= * method=
launch.launch_context.LaunchContext * argv= noninteractive=
launch.LaunchContext * argv= noninteractive=
launch.actions.SetEnvironmentVariable name value +
launch.actions.UnsetEnvironmentVariable name +
launch.actions.AppendEnvironmentVariable name value prepend= separator= +
launch.actions.PushEnvironment +
launch.actions.PopEnvironment +
launch.actions.ResetEnvironment +
launch.actions.ReplaceEnvironmentVariables environment= +
launch.actions.PushLaunchConfigurations +
launch.actions.PopLaunchConfigurations +
launch.actions.TimerAction * period actions cancel_on_shutdown= +
launch.actions.Shutdown * reason= due_to_sigint= +
launch_ros.actions.Node * name= namespace= +node
launch_ros.actions.LifecycleNode * name namespace autostart= +node
launch_ros.actions.ComposableNodeContainer * name namespace composable_node_descriptions= +node
launch_ros.actions.LoadComposableNodes * composable_node_descriptions target_container +
launch_ros.actions.PushROSNamespace namespace +
launch_ros.actions.SetRemap src dst +
launch_ros.actions.SetParameter name value +
launch_ros.actions.SetParametersFromFile filename * node_name= +
launch_ros.actions.SetUseSimTime value +
launch_ros.actions.SetROSLogDir new_log_dir +
launch_ros.actions.LifecycleTransition * lifecycle_node_names transition_ids +
launch_testing.actions.ReadyToTest
launch_ros.actions.RosTimer * period actions cancel_on_shutdown= +
launch_ros.descriptions.ComposableNode * package plugin name= namespace= parameters= remappings= extra_arguments= condition=
launch_ros.parameter_descriptions.ParameterValue value * value_type=
launch_ros.parameter_descriptions.ParameterFile param_file * allow_substs=
launch.conditions.IfCondition predicate_expression
launch.conditions.UnlessCondition predicate_expression
launch.conditions.LaunchConfigurationEquals launch_configuration_name expected_value
launch.conditions.LaunchConfigurationNotEquals launch_configuration_name expected_value
launch.launch_description_sources.PythonLaunchDescriptionSource launch_file_path
launch.launch_description_sources.AnyLaunchDescriptionSource launch_file_path
launch.launch_description_sources.FrontendLaunchDescriptionSource launch_file_path
launch_xml.launch_description_sources.XMLLaunchDescriptionSource launch_file_path
launch_yaml.launch_description_sources.YAMLLaunchDescriptionSource launch_file_path
launch.substitutions.LaunchConfiguration variable_name * default=
launch.substitutions.EnvironmentVariable name * default_value=
launch.substitutions.TextSubstitution * text
launch.substitutions.PathJoinSubstitution substitutions
launch.substitutions.PythonExpression expression python_modules=
launch.substitutions.Command command * on_stderr=
launch.substitutions.FindExecutable * name
launch.substitutions.ThisLaunchFile
launch.substitutions.ThisLaunchFileDir
launch.substitutions.AnonName name
launch.substitutions.NotSubstitution value
launch.substitutions.AndSubstitution left right
launch.substitutions.OrSubstitution left right
launch.substitutions.AnySubstitution *values
launch.substitutions.AllSubstitution *values
launch.substitutions.EqualsSubstitution left right
launch.substitutions.NotEqualsSubstitution left right
launch.substitutions.IfElseSubstitution condition if_value= else_value=
launch.substitutions.FileContent path
launch.substitutions.LaunchLogDir
launch_ros.substitutions.FindPackageShare package
launch_ros.substitutions.FindPackagePrefix package
launch_ros.substitutions.ExecutableInPackage executable package
launch_ros.substitutions.Parameter name * default=
"""
_PROCESS = """prefix= cwd= env= additional_env= output= shell= sigterm_timeout= sigkill_timeout= emulate_tty= respawn= respawn_delay=
    respawn_max_retries= on_exit= output_format= cached_output= log_cmd= condition="""
_GROUPS = {
    "+": "condition=",
    "+process": _PROCESS,
    "+node": f"executable package= exec_name= parameters= remappings= ros_arguments= arguments= {_PROCESS}",
}
_NEW_SINCE_HUMBLE = {
    "launch.actions.TimerAction": (),
    "launch_ros.actions.LifecycleNode": ("autostart",),
    "launch.substitutions.PythonExpression": ("python_modules",),
    **{
        f"launch.substitutions.{name}": None
        for name in (
            "AllSubstitution",
            "AnySubstitution",
            "EqualsSubstitution",
            "NotEqualsSubstitution",
            "IfElseSubstitution",
            "FileContent",
        )
    },
    **{f"launch_ros.actions.{name}": None for name in ("LifecycleTransition", "SetROSLogDir")},
}
"""What humble does not know: of a class these arguments, or (None) the class itself."""
_NEW_SINCE_JAZZY = ("launch.actions.ForLoop", "launch.actions.ForEach")
"""Classes that neither humble nor jazzy knows."""
_LATER = {"launch_ros.actions.LifecycleNode": ("autostart",)}
"""Arguments that came after all distributions that are known here; updates have brought them to some of these."""
_RENAMED = {
    "launch_ros.descriptions.ParameterFile": "launch_ros.parameter_descriptions.ParameterFile",
    "launch_ros.descriptions.ParameterValue": "launch_ros.parameter_descriptions.ParameterValue",
    "launch_ros.actions.PushRosNamespace": "launch_ros.actions.PushROSNamespace",
    "launch_ros.actions.ROSTimer": "launch_ros.actions.RosTimer",
    "launch.substitutions.LaunchLogDirectory": "launch.substitutions.LaunchLogDir",
}
LATER = "later"
_PACKAGES = ("launch", "launch_ros", "launch_testing", "launch_xml", "launch_yaml")


class Signature(NamedTuple):
    """What the constructor of a class takes: names in order, how many of them by position, and which have to be given.

    ``gathers``: it takes any number of values without a name, which are one argument here.
    """

    name: str
    arguments: tuple[str, ...]
    positional: int
    required: frozenset[str]
    gathers: bool = False


def signature(name: str, distro: str) -> Signature | None:
    """What is known of the class of a full name, as a distribution has it; None where there is no such class."""
    return _signatures(distro).get(_canonical(name))


def class_of_kind(kind: str) -> str | None:
    """The full name of a class of launch by its last word, the same in all distributions; None where there is none."""
    return _kinds().get(kind)


def newer(name: str, argument: str, distro: str) -> tuple[str, bool] | None:
    """Since which distribution a class has an argument that ``distro`` does not know, and whether that is certain; None where none has."""
    if argument in _LATER.get(name, ()):
        return LATER, False
    return ("jazzy", True) if distro == "humble" and argument in (_NEW_SINCE_HUMBLE.get(name) or ()) else None


def is_of_launch(name: str) -> bool:
    """Whether something is of launch, launch_ros or one of their front ends."""
    return name.partition(".")[0] in _PACKAGES


def _canonical(name: str) -> str:
    """Classes can be imported from the module that defines them, too: ``launch_ros.actions.node.Node``."""
    parts = name.split(".")
    if len(parts) == 4 and parts[0] in _PACKAGES and parts[2].islower():
        name = ".".join((*parts[:2], parts[3]))
    elif len(parts) == 3 and parts[:2] == ["launch", "launch_description"]:
        name = f"launch.{parts[2]}"
    return _RENAMED.get(name, name)


@lru_cache(maxsize=4)
def _signatures(distro: str) -> dict[str, Signature]:
    found: dict[str, Signature] = {}
    for line in _CLASSES.strip().splitlines():
        name, *words = line.split()
        new: tuple[str, ...] | None = _NEW_SINCE_HUMBLE.get(name, ()) if distro == "humble" else ()
        if new is None or (name in _NEW_SINCE_JAZZY and distro in ("humble", "jazzy")):
            continue
        gathers = any(word.startswith("*") and word != "*" for word in words)
        words = [word if word == "*" else word.removeprefix("*") for word in words]
        plain = [each for word in words for each in _GROUPS.get(word, word).split()]
        starts = next((at for at, word in enumerate(words) if word == "*" or word in _GROUPS), len(words))
        unknown = (*new, *_LATER.get(name, ()))
        named = [word for word in plain if word != "*" and word.removesuffix("=") not in unknown]
        arguments = tuple(word.removesuffix("=") for word in named)
        required = frozenset(word for word in named if not word.endswith("="))
        found[name] = Signature(name, arguments, starts, required, gathers)
    return found


@lru_cache(maxsize=1)
def _kinds() -> dict[str, str]:
    names = (line.split()[0] for line in _CLASSES.strip().splitlines())
    return {name.rpartition(".")[2]: name for name in names}
