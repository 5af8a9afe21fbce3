"""What can be wrong with the params of ROS 2 nodes when they are evaluated: one class for each kind of problem."""

from __future__ import annotations

from launchlint.problem import Problem


class ParameterValueType(Problem):
    """A ``value`` that launch does not take for the param ``name``, for this ``reason``; ``type`` is what the file says it is."""

    name: str
    value: str
    type: str | None
    reason: str


class ParameterFileMissing(Problem):
    """A ``file`` of params that is not there: launch warns and goes on without it, or stops (``refused``)."""

    file: str
    reason: str


class GlobalFileMissing(Problem):
    """A ``file`` of ``<set_parameters_from_file>`` that is not there: launch stops at the first node behind it."""

    file: str
    reason: str


class ContentNoYaml(Problem):
    """What a ``file`` of params becomes when the substitutions in it are performed is no YAML."""

    file: str
    reason: str


class ComponentFileRefused(Problem):
    """A ``file`` of params that launch itself reads for a composable node and cannot use, for this ``reason``."""

    file: str
    reason: str
