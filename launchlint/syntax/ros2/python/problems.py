"""What launch stops for in a launch file in Python, mostly with an error of Python: one class for each kind of problem.

``refused`` is set where the error comes whenever the file is loaded; under a condition that is not known, or in a ``try`` that catches
it, the problem is ``assumed``.
"""

from __future__ import annotations

from launchlint.problem import Problem

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Literal

    from launchlint.source import Place

    ListForm = Literal["letters", "text", "dict", "tuple", "one", "list-for-pair", "flat-pair", "not-pair", "not-two"]
    NoLaunch = Literal["syntax", "missing", "arguments", "nothing", "list", "other"]
    Effect = Literal["process", "question", "write", "delete", "connection"]
    Use = Literal["test", "compare", "format", "join", "path", "str", "performed"]


class UnknownKeyword(Problem):
    """A keyword that the constructor of ``callee`` does not take.

    ``replacement`` is what has taken its place ``since`` a distribution, where it once was one. ``known`` are those that are not given.
    ``still`` are distributions that the file is for, too, and that take it, oldest first; ``refused`` is not set where there are no others.
    ``missing`` is the only argument that must be given and is not, where this keyword is the only strange one.
    """

    callee: str
    keyword: str
    replacement: str
    since: str
    known: tuple[str, ...]
    still: tuple[str, ...]
    missing: str


class KeywordNotInDistribution(Problem):
    """A keyword of ``callee``, or (with none) ``callee`` itself, that this ``distro`` does not have, and another has ``since`` it.

    ``sure``: no update of the distribution can have brought it.
    """

    callee: str
    keyword: str
    distro: str
    since: str
    sure: bool


class MissingArgument(Problem):
    """An argument that the constructor of ``callee`` must be given."""

    callee: str
    argument: str


class TooManyPositional(Problem):
    """``count`` values without a name where the constructor of ``callee`` takes ``most``: those behind are at ``extra``.

    ``names`` are the arguments that may be meant, in order. ``listed``: the constructor takes one list of what is given one by one, from
    the place in ``related`` on.
    """

    callee: str
    count: int
    most: int
    extra: tuple[Place, ...]
    names: tuple[str, ...]
    listed: bool


class NotASubstitution(Problem):
    """A value that is no text where the constructor of ``callee`` takes one; ``found`` says in words what it is.

    ``item``: it is one of a list. ``written`` is how a text with it is written, where that is certain. ``declared`` is the name of the arg,
    where the value is the declaration of one.
    """

    callee: str
    argument: str
    found: str
    item: bool
    written: str
    declared: str


class NotAParameterValue(Problem):
    """A value that no param can have; ``found`` says in words what it is, ``name`` is the param (empty: not known)."""

    callee: str
    name: str
    found: str


class NotACondition(Problem):
    """What is given as ``condition`` and is none; ``found`` says in words what it is. ``substitution``: a condition is made of such."""

    callee: str
    found: str
    substitution: bool


class LaunchArgumentsNotPairs(Problem):
    """``launch_arguments`` of an include that is not made of pairs: a dict without ``.items()`` (``is_dict``), or something else."""

    found: str
    is_dict: bool


class TextForList(Problem):
    """A value of another form than the list that ``argument`` of ``callee`` takes; ``form`` says which.

    ``letters``: a text, of which launch takes each letter for one item, and goes on.
    """

    callee: str
    argument: str
    form: ListForm


class NotAnAction(Problem):
    """What stands among the actions of ``holder`` and is none; ``found`` says in words what it is."""

    holder: str
    found: str


class WrongModule(Problem):
    """``name`` is imported from ``module``, which has none; ``right`` is the module that has it. ``alone``: nothing else is imported."""

    name: str
    module: str
    right: str
    alone: bool


class NoDescription(Problem):
    """Launch gets no description out of the file, for the reason that ``form`` says; ``what`` says more in plain words."""

    form: NoLaunch
    what: str


class StopsWithError(Problem):
    """The file itself ends with an exception, of the class ``error``, that says ``what``; ``stated``: it raises that itself.

    ``called``: it comes when launch calls a function of the file, not when the file is loaded. ``lacking``: a launch configuration that
    the function asked for before, and that nothing here sets, or to nothing but an empty text: somebody has to give it a value.
    ``package``: one that the program looked for before it raised this itself, and that is not here; ``variable``: likewise a variable of
    the environment that is not set. ``action``: the class of an action that ends so by itself, not in a function of the file.
    """

    error: str
    what: str
    stated: bool
    called: bool
    lacking: str = ""
    package: str = ""
    variable: str = ""
    action: str = ""

    @property
    def lacks(self) -> tuple[str, str] | None:
        """That package, arg or variable."""
        if self.package:
            return "the package", self.package
        if self.lacking:
            return "the arg", self.lacking
        return ("the environment variable", self.variable) if self.variable else None


class ExecutedTwice(Problem):
    """One object, a ``callee`` (by the name of its tag), that launch is to start twice: it stops at the second time."""

    callee: str


class WrongSourceClass(Problem):
    """``callee``, the source of an include, is not for files with the name of ``file``; ``right`` is the one that is."""

    callee: str
    file: str
    right: str


class ConfigurationAsPythonValue(Problem):
    """A substitution of the class ``name`` that Python uses as if it were the text it will stand for; ``use`` says how.

    ``of`` is the name of the launch configuration, if it is one. ``idle``: what comes of it reaches no action.
    """

    use: Use
    name: str
    of: str
    idle: bool = False


class RunsAtLoad(Problem):
    """A call of ``what`` that has an ``effect`` on the machine as soon as somebody loads the file."""

    what: str
    effect: Effect


class NeverAdded(Problem):
    """An action, made by ``callee``, that the variable ``name`` holds, and that nothing looks at. ``commented``: a comment names it.

    ``chosen``: of the actions of the function more are commented out, or left out like this one, than added. ``together`` are all that
    the function leaves out, in words: the same in copies of it. ``call`` is where it is made, ``related`` what would stop launch there.
    """

    callee: str
    name: str
    commented: bool
    chosen: bool
    call: Place
    together: str = ""
