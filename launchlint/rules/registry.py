"""All rules, explicitly. A rule module is imported only when there is something for it to look at: start-up is the product.

``on`` holds the kinds of problem that a rule speaks about (its module then has ``tell``); ``view`` says what it looks at (its module then
has ``check``). A rule with both speaks in ``tell``, and says in ``check`` where things are in order. Numbers never change meaning;
``REDIRECTS`` keeps retired IDs and names working.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from sys import modules

import launchlint.evaluate.problems as evaluate
import launchlint.syntax.problems as syntax
from launchlint.finding import Severity
from launchlint.model import ROS1, ROS2, DialectName
from launchlint.named_tuple import NamedTuple
from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

BOTH: tuple[DialectName, ...] = (ROS1, ROS2)
ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO


class Entry(NamedTuple):
    """One line of the registry. ``dialects``: those whose launch files the rule speaks of; it is not run on others.

    ``ros2`` names further kinds of problem, which only ROS 2 has: classes are not imported before there is one of them.
    """

    id: str
    name: str
    module: str
    severity: Severity
    view: str = "problem"
    on: tuple[type[Problem], ...] = ()
    default: bool = True
    dialects: tuple[DialectName, ...] = (ROS1,)
    ros2: tuple[str, ...] = ()

    def load(self) -> Any:
        """Import and return the rule's module."""
        name = f"launchlint.rules.{self.module}"
        return modules.get(name) or import_module(name)  # import_module itself takes its time, thousands of times


RULES: tuple[Entry, ...] = (
    Entry("LL100", "unreadable-file", "xml.unreadable_file", ERROR, on=(syntax.UnreadableFile,), dialects=BOTH),
    Entry(
        "LL101",
        "malformed-xml",
        "xml.malformed_xml",
        ERROR,
        on=(syntax.MalformedXml,),
        dialects=BOTH,
        ros2=("MalformedXml2", "MalformedYaml", "TooDeep"),
    ),
    Entry("LL102", "root-not-launch", "xml.root_not_launch", ERROR, on=(syntax.RootNotLaunch,), dialects=BOTH, ros2=("WrongRoot",)),
    Entry("LL103", "unknown-tag", "xml.unknown_tag", WARNING, on=(syntax.UnknownTag,), dialects=BOTH, ros2=("UnknownAction",)),
    Entry(
        "LL104",
        "unknown-attribute",
        "xml.unknown_attribute",
        WARNING,
        on=(syntax.UnknownAttribute,),
        dialects=BOTH,
        ros2=("UnreadAttribute",),
    ),
    Entry(
        "LL105", "missing-attribute", "xml.missing_attribute", ERROR, on=(syntax.MissingAttribute,), dialects=BOTH, ros2=("LacksAttribute",)
    ),
    Entry("LL106", "misplaced-tag", "xml.misplaced_tag", WARNING, on=(syntax.MisplacedTag,), dialects=BOTH, ros2=("MisplacedEntity",)),
    Entry("LL107", "stray-text", "xml.stray_text", WARNING, on=(syntax.StrayText,), dialects=BOTH, ros2=("UnreadText",)),
    Entry("LL108", "if-and-unless", "xml.if_and_unless", ERROR, on=(syntax.IfAndUnless,), dialects=BOTH, ros2=("BothConditions",)),
    Entry(
        "LL109",
        "invalid-value",
        "xml.invalid_value",
        ERROR,
        on=(syntax.InvalidValue, evaluate.UnbalancedQuotes),
        dialects=BOTH,
        ros2=("WrongValue", "NegativeValue", "OpenQuote", "YamlForm", "ChoiceRefused", "UnsplittablePrefix"),
    ),
    Entry(
        "LL110",
        "conflicting-attributes",
        "xml.conflicting_attributes",
        ERROR,
        on=(syntax.ConflictingAttributes,),
        dialects=BOTH,
        ros2=("ParameterForm",),
    ),
    Entry("LL111", "deprecated-construct", "xml.deprecated_construct", WARNING, view="graph", on=(syntax.DeprecatedConstruct,)),
    Entry("LL112", "wrong-dialect", "xml.wrong_dialect", ERROR, on=(syntax.WrongDialect,), dialects=BOTH, ros2=("OfRos1",)),
    Entry("LL113", "ineffective-attribute", "xml.ineffective_attribute", WARNING, on=(syntax.IneffectiveAttribute,)),
    Entry("LL114", "condition-on-launch", "xml.condition_on_launch", ERROR, on=(evaluate.ConditionOnLaunch, syntax.InvalidValue)),
    Entry("LL115", "left-from-ros1", "xml.left_from_ros1", WARNING, view="file"),
    Entry("LL201", "undeclared-arg", "args.undeclared_arg", ERROR, on=(evaluate.UndeclaredArg,), dialects=BOTH),
    Entry("LL202", "required-arg-unset", "args.required_arg_unset", INFO, on=(evaluate.RequiredArgUnset,), dialects=BOTH),
    Entry("LL203", "arg-redeclared", "args.arg_redeclared", ERROR, on=(evaluate.ArgRedeclared,)),
    Entry("LL204", "arg-value-and-default", "args.arg_value_and_default", ERROR, on=(syntax.ArgValueAndDefault,)),
    Entry("LL205", "arg-cycle", "args.arg_cycle", ERROR, on=(evaluate.UsedBeforeDeclaration, evaluate.UndeclaredArg), dialects=BOTH),
    Entry("LL206", "unused-arg", "args.unused_arg", WARNING, view="file", dialects=BOTH, ros2=("ArgUnused",)),
    Entry(
        "LL207",
        "bad-substitution",
        "args.bad_substitution",
        ERROR,
        on=(evaluate.BadSubstitution,),
        dialects=BOTH,
        ros2=(
            "UnreadableSubstitution",
            "UnknownSubstitution",
            "SubstitutionArity",
            "CommandOption",
            "NoDirectory",
            "ParameterNotSet",
        ),
    ),
    Entry(
        "LL208",
        "eval-error",
        "args.eval_error",
        ERROR,
        on=(evaluate.EvalError, evaluate.EvalNotCovered, evaluate.EvalNeverEqual),
        dialects=BOTH,
    ),
    Entry("LL209", "env-unset", "args.env_unset", WARNING, view="launch", on=(evaluate.EnvUnset,), dialects=BOTH),
    Entry(
        "LL210",
        "package-not-found",
        "args.package_not_found",
        ERROR,
        view="launch",
        on=(evaluate.PackageNotFound,),
        dialects=BOTH,
        ros2=("InvalidPackageName",),
    ),
    Entry("LL211", "arg-out-of-scope", "args.arg_out_of_scope", ERROR, on=(evaluate.ArgOutOfScope,)),
    Entry("LL212", "arg-override-refused", "args.arg_override_refused", ERROR, on=(evaluate.ArgOverrideRefused,)),
    Entry("LL213", "unreachable-branch", "args.unreachable_branch", WARNING, view="launch"),
    Entry(
        "LL214",
        "condition-not-boolean",
        "args.condition_not_boolean",
        ERROR,
        on=(evaluate.ConditionNotBoolean, syntax.InvalidValue),
        dialects=BOTH,
        ros2=("NotABoolean",),
    ),
    Entry("LL215", "unexpanded-substitution", "args.unexpanded_substitution", WARNING, on=(evaluate.UnexpandedSubstitution,)),
    Entry("LL216", "evaluation-bound", "args.evaluation_bound", WARNING, on=(evaluate.EvaluationBound,), dialects=BOTH),
    Entry("LL301", "duplicate-node-name", "nodes.duplicate_node_name", ERROR, on=(evaluate.DuplicateNode,), dialects=BOTH),
    Entry("LL302", "invalid-node-name", "nodes.invalid_node_name", ERROR, on=(evaluate.InvalidNodeName,), dialects=BOTH),
    Entry("LL303", "unknown-package", "nodes.unknown_package", ERROR, view="launch", dialects=BOTH, ros2=("NodePackageMissing",)),
    Entry("LL304", "unknown-executable", "nodes.unknown_executable", ERROR, view="graph", dialects=BOTH),
    Entry("LL305", "not-executable", "nodes.not_executable", ERROR, view="launch"),
    Entry("LL306", "unknown-machine", "nodes.unknown_machine", ERROR, view="launch", on=(evaluate.UnknownMachine,)),
    Entry("LL307", "machine-conflict", "nodes.machine_conflict", ERROR, on=(evaluate.MachineConflict,)),
    Entry("LL308", "nodelet-manager-missing", "nodes.nodelet_manager_missing", ERROR, view="launch"),
    Entry("LL309", "unknown-nodelet-class", "nodes.unknown_nodelet_class", ERROR, view="graph"),
    Entry("LL310", "test-without-name", "nodes.test_without_name", ERROR, on=(syntax.MissingAttribute, syntax.ConflictingAttributes)),
    Entry("LL311", "duplicate-test-name", "nodes.duplicate_test_name", WARNING, view="launch"),
    Entry("LL312", "anon-reuse", "nodes.anon_reuse", WARNING, view="file"),
    Entry("LL313", "test-shadows-node", "nodes.test_shadows_node", WARNING, view="launch"),
    Entry("LL314", "invalid-namespace", "nodes.invalid_namespace", ERROR, on=(evaluate.InvalidNamespace,), dialects=BOTH),
    Entry("LL315", "env-without-node", "nodes.env_without_node", WARNING, view="launch"),
    Entry(
        "LL401",
        "include-not-found",
        "includes.include_not_found",
        ERROR,
        on=(evaluate.IncludeNotFound, evaluate.IncludeNotLoadable),
        dialects=BOTH,
    ),
    Entry("LL402", "include-cycle", "includes.include_cycle", ERROR, on=(evaluate.IncludeCycle,), dialects=BOTH),
    Entry("LL403", "include-undeclared-arg", "includes.include_undeclared_arg", ERROR, on=(evaluate.IncludeUndeclaredArg,)),
    Entry("LL404", "include-missing-arg", "includes.include_missing_arg", ERROR, on=(evaluate.IncludeMissingArg,), dialects=BOTH),
    Entry("LL405", "pass-all-args-hides-typo", "includes.pass_all_args_hides_typo", WARNING, on=(evaluate.PassAllHidesTypo,)),
    Entry("LL406", "non-portable-path", "includes.non_portable_path", WARNING, view="file", dialects=BOTH),
    Entry("LL407", "broken-caller", "includes.broken_caller", ERROR, view="run", dialects=BOTH),
    Entry("LL408", "deprecated-include", "includes.deprecated_include", WARNING, on=(evaluate.DeprecatedInclude,)),
    Entry("LL409", "orphan-launch-file", "includes.orphan_launch_file", INFO, view="run", default=False, dialects=BOTH),
    Entry("LL410", "repeated-include", "includes.repeated_include", WARNING, view="file"),
    Entry("LL411", "named-file-missing", "includes.named_file_missing", WARNING, view="launch", dialects=BOTH),
    Entry(
        "LL501",
        "param-value-type",
        "params.param_value_type",
        ERROR,
        on=(evaluate.ParamValueType,),
        dialects=BOTH,
        ros2=("ParameterValueType",),
    ),
    Entry("LL502", "param-file-missing", "params.param_file_missing", ERROR, on=(evaluate.ParamFileMissing,), dialects=BOTH),
    Entry(
        "LL503",
        "param-yaml-invalid",
        "params.param_yaml_invalid",
        ERROR,
        on=(evaluate.ParamYamlInvalid,),
        dialects=BOTH,
        ros2=("ComponentFileRefused", "ContentNoYaml"),
    ),
    Entry("LL504", "param-overwritten", "params.param_overwritten", WARNING, view="launch"),
    Entry("LL505", "param-parent-conflict", "params.param_parent_conflict", WARNING, view="launch"),
    Entry("LL506", "private-param-unused", "params.private_param_unused", WARNING, view="launch"),
    Entry("LL507", "param-never-read", "params.param_never_read", WARNING, view="graph", dialects=BOTH),
    Entry("LL508", "param-wrong-type", "params.param_wrong_type", WARNING, view="graph", dialects=BOTH),
    Entry("LL509", "hard-coded-secret", "params.hard_coded_secret", WARNING, view="file", dialects=BOTH),
    Entry("LL510", "invalid-param-name", "params.invalid_param_name", WARNING, view="graph"),
    Entry("LL511", "global-param-in-node", "params.global_param_in_node", WARNING, on=(evaluate.GlobalParamInNode,)),
    Entry("LL512", "suspicious-param-value", "params.suspicious_param_value", WARNING, view="graph"),
    Entry(
        "LL513",
        "duplicate-yaml-key",
        "params.duplicate_yaml_key",
        WARNING,
        on=(evaluate.YamlDuplicateKey,),
        dialects=BOTH,
        ros2=("KeyTwice",),
    ),
    Entry("LL514", "param-repeated", "params.param_repeated", INFO, view="launch"),
    Entry("LL515", "ros2-parameter-file", "params.ros2_parameter_file", WARNING, on=(evaluate.Ros2Parameters,)),
    Entry("LL601", "remap-matches-nothing", "remaps.remap_matches_nothing", WARNING, view="graph", dialects=BOTH),
    Entry("LL602", "remap-after-node", "remaps.remap_after_node", WARNING, view="launch"),
    Entry("LL603", "remap-out-of-effect", "remaps.remap_out_of_effect", WARNING, view="launch", dialects=BOTH),
    Entry("LL604", "remap-duplicate", "remaps.remap_duplicate", WARNING, view="launch", dialects=BOTH),
    Entry("LL605", "remap-identity", "remaps.remap_identity", INFO, view="file", dialects=BOTH),
    Entry("LL606", "remap-chain", "remaps.remap_chain", WARNING, view="graph", dialects=BOTH),
    Entry("LL607", "invalid-remap-name", "remaps.invalid_remap_name", ERROR, on=(evaluate.InvalidRemapName, evaluate.DoubledSlash)),
    Entry("LL611", "type-mismatch", "connections.type_mismatch", ERROR, view="graph", dialects=BOTH),
    Entry("LL612", "no-publisher", "connections.no_publisher", WARNING, view="graph", dialects=BOTH),
    Entry("LL613", "no-subscriber", "connections.no_subscriber", INFO, view="graph", dialects=BOTH),
    Entry("LL614", "no-server", "connections.no_server", WARNING, view="graph", dialects=BOTH),
    Entry("LL615", "several-servers", "connections.several_servers", ERROR, view="graph", dialects=BOTH),
    Entry("LL616", "competing-publishers", "connections.competing_publishers", WARNING, view="graph", dialects=BOTH),
    Entry("LL617", "absolute-name-escapes-namespace", "connections.absolute_name_escapes_namespace", WARNING, view="graph", dialects=BOTH),
    Entry("LL618", "isolated-node", "connections.isolated_node", INFO, view="graph", dialects=BOTH),
    Entry("LL619", "sim-time-mismatch", "connections.sim_time_mismatch", WARNING, view="graph", dialects=BOTH),
    Entry("LL620", "lost-connection", "connections.lost_connection", WARNING, view="base", dialects=BOTH),
    Entry("LL621", "static-transform-args", "frames.static_transform_args", ERROR, view="launch"),
    Entry("LL622", "competing-transforms", "frames.competing_transforms", ERROR, view="graph"),
    Entry("LL623", "frame-leading-slash", "frames.frame_leading_slash", WARNING, view="graph"),
    Entry("LL624", "unknown-frame", "frames.unknown_frame", WARNING, view="graph"),
    Entry("LL701", "missing-exec-depend", "packages.missing_exec_depend", WARNING, view="file", dialects=BOTH),
    Entry("LL702", "launch-not-installed", "packages.launch_not_installed", WARNING, view="file"),
    Entry("LL703", "duplicate-package", "packages.duplicate_package", WARNING, view="run", dialects=BOTH),
    Entry("LL704", "broken-manifest", "packages.broken_manifest", WARNING, view="run", dialects=BOTH),
    Entry("LL801", "not-formatted", "style.not_formatted", INFO, view="file", default=False, dialects=BOTH),
    Entry("LL802", "unused-suppression", "style.unused_suppression", WARNING, view="suppression", dialects=BOTH),
    Entry(
        "LL803", "suppression-without-reason", "style.suppression_without_reason", INFO, view="suppression", default=False, dialects=BOTH
    ),
    Entry("LL901", "params-for-nobody", "ros2.params_for_nobody", WARNING, dialects=(ROS2,), ros2=("ParametersForNobody",)),
    Entry("LL902", "composable-key-ignored", "ros2.composable_key_ignored", WARNING, dialects=(ROS2,), ros2=("ComponentKeyIgnored",)),
    Entry("LL903", "wildcard-wins", "ros2.wildcard_wins", WARNING, dialects=(ROS2,), ros2=("LaterValueLost",)),
    Entry(
        "LL904", "params-file-refused", "ros2.params_file_refused", ERROR, dialects=(ROS2,), ros2=("ParametersFileDies", "ParameterDies")
    ),
    Entry("LL905", "value-changes-type", "ros2.value_changes_type", WARNING, dialects=(ROS2,), ros2=("TextRetyped", "NumberStaysText")),
    Entry("LL906", "param-int-for-double", "ros2.param_int_for_double", ERROR, view="graph", dialects=(ROS2,)),
    Entry("LL907", "string-parsed-as-yaml", "ros2.string_parsed_as_yaml", WARNING, dialects=(ROS2,), ros2=("CommandReadAsYaml",)),
    Entry("LL908", "set-parameter-list", "ros2.set_parameter_list", ERROR, dialects=(ROS2,), ros2=("ListBecomesText",)),
    Entry("LL909", "set-parameter-empty", "ros2.set_parameter_empty", ERROR, dialects=(ROS2,), ros2=("SetParameterDies",)),
    Entry(
        "LL911",
        "default-overruled-by-sibling",
        "ros2.default_overruled_by_sibling",
        WARNING,
        dialects=(ROS2,),
        ros2=("DefaultOverruled",),
    ),
    Entry("LL912", "required-arg-not-passed", "includes.required_arg_not_passed", ERROR, dialects=(ROS2,), ros2=("RequiredArgNotPassed",)),
    Entry("LL913", "passed-but-not-declared", "includes.passed_but_not_declared", WARNING, dialects=(ROS2,), ros2=("PassedForNothing",)),
    Entry("LL914", "undeclared-configuration", "ros2.undeclared_configuration", INFO, dialects=(ROS2,), ros2=("UndeclaredRead",)),
    Entry("LL915", "arg-declared-differently", "ros2.arg_declared_differently", INFO, dialects=(ROS2,), ros2=("DefaultOverruled",)),
    Entry("LL916", "dirname-after-include", "ros2.dirname_after_include", ERROR, dialects=(ROS2,), ros2=("DirectoryOfAnother",)),
    Entry("LL917", "setting-leaks-from-group", "ros2.setting_leaks_from_group", WARNING, dialects=(ROS2,), ros2=("LeaksFromGroup",)),
    Entry("LL918", "namespace-leaks-from-include", "ros2.namespace_leaks_from_include", WARNING, dialects=(ROS2,), ros2=("NamespaceLeft",)),
    Entry("LL919", "deferred-loses-scope", "ros2.deferred_loses_scope", WARNING, dialects=(ROS2,), ros2=("ScopeLost",)),
    Entry(
        "LL921",
        "configuration-as-python-value",
        "python.configuration_as_python_value",
        ERROR,
        dialects=(ROS2,),
        ros2=("ConfigurationAsPythonValue",),
    ),
    Entry(
        "LL922", "not-a-substitution", "python.not_a_substitution", ERROR, dialects=(ROS2,), ros2=("NotASubstitution", "NotAParameterValue")
    ),
    Entry(
        "LL923",
        "condition-never-boolean",
        "python.condition_never_boolean",
        ERROR,
        on=(evaluate.EvalError,),
        dialects=(ROS2,),
        ros2=("NotACondition",),
    ),
    Entry("LL924", "removed-keyword", "python.removed_keyword", ERROR, dialects=(ROS2,), ros2=("UnknownKeyword",)),
    Entry("LL925", "wrong-module", "python.wrong_module", ERROR, dialects=(ROS2,), ros2=("WrongModule",)),
    Entry(
        "LL926",
        "launch-arguments-not-pairs",
        "python.launch_arguments_not_pairs",
        ERROR,
        dialects=(ROS2,),
        ros2=("LaunchArgumentsNotPairs",),
    ),
    Entry("LL927", "text-for-list", "python.text_for_list", ERROR, dialects=(ROS2,), ros2=("TextForList",)),
    Entry(
        "LL928",
        "missing-constructor-argument",
        "python.missing_constructor_argument",
        ERROR,
        dialects=(ROS2,),
        ros2=("MissingArgument", "TooManyPositional"),
    ),
    Entry("LL929", "executed-twice", "python.executed_twice", ERROR, dialects=(ROS2,), ros2=("ExecutedTwice",)),
    Entry("LL930", "runs-at-load", "python.runs_at_load", INFO, dialects=(ROS2,), ros2=("RunsAtLoad",)),
    Entry("LL931", "wrong-source-class", "python.wrong_source_class", ERROR, dialects=(ROS2,), ros2=("WrongSourceClass",)),
    Entry("LL932", "no-description", "python.no_description", ERROR, dialects=(ROS2,), ros2=("NoDescription", "NotAnAction")),
    Entry("LL933", "yaml-wants-text", "ros2.yaml_wants_text", ERROR, dialects=(ROS2,), ros2=("WantsText", "WantsFraction")),
    Entry(
        "LL934",
        "not-in-this-distro",
        "ros2.not_in_this_distro",
        ERROR,
        dialects=(ROS2,),
        ros2=("NotInDistribution", "KeywordNotInDistribution"),
    ),
    Entry("LL935", "broken-in-frontend", "ros2.broken_in_frontend", ERROR, dialects=(ROS2,), ros2=("BrokenInFrontend", "NeverWorks")),
    Entry("LL936", "action-never-added", "python.action_never_added", WARNING, dialects=(ROS2,), ros2=("NeverAdded",)),
    Entry("LL937", "container-missing", "ros2.container_missing", ERROR, view="launch", dialects=(ROS2,)),
    Entry("LL938", "unknown-component", "ros2.unknown_component", ERROR, view="graph", dialects=(ROS2,)),
    Entry("LL939", "condition-ignored", "ros2.condition_ignored", WARNING, view="launch", dialects=(ROS2,)),
    Entry("LL940", "lifecycle-manager-names-nobody", "ros2.lifecycle_manager_names_nobody", ERROR, view="graph", dialects=(ROS2,)),
    Entry("LL941", "controller-not-configured", "ros2.controller_not_configured", ERROR, view="launch", dialects=(ROS2,)),
    Entry("LL942", "qos-incompatible", "ros2.qos_incompatible", ERROR, view="graph", dialects=(ROS2,)),
    Entry("LL943", "sim-time-patchy", "ros2.sim_time_patchy", WARNING, view="launch", dialects=(ROS2,)),
    Entry("LL944", "anonymous-gets-named-params", "ros2.anonymous_gets_named_params", WARNING, view="graph", dialects=(ROS2,)),
    Entry("LL945", "not-installed", "packages.not_installed", ERROR, view="launch", dialects=(ROS2,)),
    Entry("LL946", "not-in-libexec", "nodes.not_in_libexec", ERROR, view="launch", dialects=(ROS2,)),
    Entry("LL947", "remap-kills-node", "ros2.remap_kills_node", ERROR, dialects=(ROS2,), ros2=("RemapDies",)),
    Entry("LL948", "absolute-remap-misses", "ros2.absolute_remap_misses", WARNING, view="graph", dialects=(ROS2,)),
    Entry("LL949", "stops-with-error", "python.stops_with_error", ERROR, dialects=(ROS2,), ros2=("StopsWithError", "NothingToPop")),
    Entry("LL950", "lifecycle-node-left-inactive", "ros2.lifecycle_node_left_inactive", WARNING, view="graph", dialects=(ROS2,)),
)

REDIRECTS: Mapping[str, str] = {}
"""Retired IDs and names → the ID that took over. Empty so far."""

_BY_WORD: Mapping[str, Entry] = {**{entry.id.lower(): entry for entry in RULES}, **{entry.name: entry for entry in RULES}}


def find(word: str) -> Entry | None:
    """The rule with this ID or name (letter case does not matter), redirects followed."""
    key = word.strip().lower()
    redirect = REDIRECTS.get(key)
    return _BY_WORD.get(key if redirect is None else redirect.lower())


@cache
def _by_kind() -> Mapping[type[Problem] | str, tuple[Entry, ...]]:
    """Kind of problem → the rules that speak about it."""
    kinds: dict[type[Problem] | str, tuple[Entry, ...]] = {}
    for entry in RULES:
        both: tuple[type[Problem] | str, ...] = (*entry.on, *entry.ros2)
        for kind in both:
            kinds[kind] = (*kinds.get(kind, ()), entry)
    return kinds


def speaking_of(kind: type[Problem]) -> tuple[Entry, ...]:
    """The rules that speak about a kind of problem."""
    return _by_kind().get(kind) or (_by_kind().get(kind.__name__, ()) if ".ros2." in kind.__module__ else ())


def rule_of(kind: type[Problem]) -> str:
    """ID of the first rule that speaks about a kind of problem; ``LL000`` where none does."""
    return next((entry.id for entry in speaking_of(kind)), "LL000")
