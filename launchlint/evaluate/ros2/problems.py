"""What can be wrong with what a ROS 2 launch file comes to, where ROS 1 has no such thing: one class for each kind.

What both have is in :mod:`launchlint.evaluate.problems`.
"""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal


class NotABoolean(Problem):
    """A ``value`` that ``$(not …)``, ``$(and …)``, ``$(or …)`` or ``$(if …)`` cannot take for a truth value; ``text`` is all of it."""

    substitution: str
    value: str
    text: str


class ParameterNotSet(Problem):
    """``$(param name)`` of something that no ``<set_parameter>`` has set."""

    name: str


class CommandOption(Problem):
    """A second word of ``$(command …)`` that says nothing to launch; ``known`` are those that do."""

    value: str
    known: tuple[str, ...]


class InvalidPackageName(Problem):
    """What is looked for as a package and can be the name of none."""

    package: str


class NodePackageMissing(Problem):
    """The package of a node, which is not here (looked for from the entry file ``near``), or, not being ``valid``, is the name of none."""

    package: str
    near: str
    valid: bool

    @property
    def lacks(self) -> tuple[str, str] | None:
        """That package, where it may be elsewhere."""
        return ("the package", self.package) if self.valid else None


class NoDirectory(Problem):
    """``$(dirname)`` or ``$(filename)`` where there is no launch file."""

    substitution: str


class ChoiceRefused(Problem):
    """A ``value`` that an arg does not take; ``given``: from the command line or an include, else its own default."""

    name: str
    value: str
    choices: tuple[str, ...]
    given: bool


class RequiredArgNotPassed(Problem):
    """An arg that the included ``file`` needs, that has a value here, and that the include does not pass.

    ``passed`` are those that it passes. launch looks at what is passed before it looks at what is set.
    """

    name: str
    file: str
    passed: tuple[str, ...]
    target: str


class NeverWorks(Problem):
    """An action that launch's front ends for XML and YAML make so that it fails whenever it is executed."""

    tag: str


class UnsplittablePrefix(Problem):
    """A ``launch-prefix`` with a quote that nothing closes."""

    value: str


class PassedForNothing(Problem):
    """An arg that is passed to the included ``file``, and that nothing executed from there on reads.

    ``known`` are those declared there and in what it includes. Not ``certain``: what comes after the include is not all known.
    """

    name: str
    file: str
    known: tuple[str, ...]
    certain: bool


class ArgUnused(Problem):
    """A declared arg that neither its file reads nor anything that is executed after it; ``description`` is its own.

    ``alone``: the file holds nothing but args.
    """

    name: str
    description: str
    alone: bool


class DefaultOverruled(Problem):
    """The ``default`` of an arg that does not count: the configuration has another ``value``.

    ``left``: an included file that has been executed to its end left it, by how it was set (``default``, ``passed``, ``let``); else it is
    the default of another declaration: of a file around this one or, where it is the ``same_file``, of this one.
    """

    name: str
    default: str
    value: str
    how: str
    left: bool
    same_file: bool
    setter: str


class UndeclaredRead(Problem):
    """A configuration that a file reads and does not declare, and that has a value here; ``setter`` is the file that set it.

    ``left``: that file has been executed to its end, and is none of those around.
    """

    name: str
    setter: str
    left: bool


class LeaksFromGroup(Problem):
    """A remap or param that a group sets, and that acts on ``node`` behind the group as well; ``tag`` is its own."""

    tag: str
    node: str


class NamespaceLeft(Problem):
    """A ``namespace`` that an included ``file`` pushes, and that is still there for what is started behind the include."""

    namespace: str
    file: str


class ScopeLost(Problem):
    """What is executed ``later`` reads ``name``, whose ``value`` in the group around is forgotten by then: it gets ``instead``, if any.

    ``name`` is empty for the namespace that the group has pushed.
    """

    name: str
    value: str
    instead: str | None
    later: str


class DirectoryOfAnother(Problem):
    """``$(dirname)`` or ``$(filename)`` that, behind an include, ``means`` (as shown) another file than its own."""

    substitution: str
    means: str


class NothingToPop(Problem):
    """Nothing is kept any more of ``what`` is to be put back (empty: both, at the end of a group): launch stops with an error."""

    what: Literal["environment", "configurations", ""]
