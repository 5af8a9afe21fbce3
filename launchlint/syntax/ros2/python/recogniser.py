"""What launch files in Python find outside of them: launch and launch_ros, the package index, paths and the environment."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from launchlint.python import builtins, standard
from launchlint.python.call import Call
from launchlint.python.failures import Asked, Raised
from launchlint.python.letter import LATER
from launchlint.python.values import (
    COMPLETE,
    ITEMS,
    MISSING,
    UNKNOWN,
    UNORDERED,
    Class,
    External,
    Failure,
    Handle,
    Instance,
    Map,
    Partial,
    Scope,
    Seq,
    Unknown,
    Value,
)
from launchlint.python.values import Text as Open
from launchlint.source import Place, Span
from launchlint.syntax.ros2.python import bundled, calculated, libraries, machine, patterns
from launchlint.syntax.ros2.python.arguments import wrong_action, wrong_values
from launchlint.syntax.ros2.python.command_line import words
from launchlint.syntax.ros2.python.conditions import is_condition
from launchlint.syntax.ros2.python.constructors import Given, wrong_shape
from launchlint.syntax.ros2.python.files import FILE, XACRO, Files
from launchlint.syntax.ros2.python.paths import PATH, Paths, is_path, path, spelled
from launchlint.syntax.ros2.python.running import CONFIGURATIONS, CONTEXT, VARIABLES, Running
from launchlint.syntax.ros2.python.tables import Signature, is_of_launch, signature
from launchlint.syntax.ros2.python.texts import SUBSTITUTIONS, TO_LAUNCH, Texts, is_own_substitution, is_substitution
from launchlint.yaml.tree import Reader
from launchlint.yaml.values import load

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.syntax.ros2.live import LiveContext
    from launchlint.syntax.ros2.python.following import Following
    from launchlint.workspace.ros2_distributions import Meant

_OUTSIDE = ("launch", "launch_ros", "launch_testing", "launch_xml", "launch_yaml", "ament_index_python", bundled.SAID)
_SHARE = ("ament_index_python.packages.get_package_share_directory", "ament_index_python.get_package_share_directory")
_SHARE_PATH = ("ament_index_python.packages.get_package_share_path", "ament_index_python.get_package_share_path")
_PREFIX = ("ament_index_python.packages.get_package_prefix", "ament_index_python.get_package_prefix")
_EVENTS = ("launch.events.", "launch_ros.events.")
_HARMLESS = ("logging.", "os.path.", "os.getcwd", "math.", "time.", "datetime.", "platform.", "sys.")
"""What changes nothing, and needs nothing that may not be there."""
_COPIES = ("copy.copy", "copy.deepcopy", "collections.OrderedDict")
_MADE_LATER = ("GroupAction",)
"""Classes that keep the list they are given, so that it can be changed afterwards; the others make a copy."""
_DEEPEST = 20
_BEHAVIOUR = frozenset(("execute", "visit", "perform", "evaluate", "get_sub_entities", "handle", "describe_sub_entities"))
"""Methods with which a class does something else than the class of launch that it is made of."""
_IN_ANY_ORDER = ("actions", "initial_entities", "entities", "composable_node_descriptions")
"""Arguments that are lists of what stands side by side."""
_GONE_THROUGH = (*_IN_ANY_ORDER, "launch_arguments")
"""Arguments that may be anything that can be gone through."""
PACKAGES, EVENT = "packages", "event"
"""All packages that are installed; an event, or what says which one is meant: they come to nothing that would be known beforehand."""
_YAML = Reader("launch", longest=1_000_000)


class Outside:
    """What is asked of whoever reads launch files.

    ``meant`` is the distribution that launch files are for. ``share`` gives the directory of a package (None: there is none of that name),
    ``environment`` the variables; ``looked_at`` is told
    which of them a launch file asks for. ``inside`` says whether a path lies in the workspace, below which files are read,
    ``installed`` gives the file that a build puts to a path where the sources have none, if that is known, and ``may_be_built`` says
    whether it may put one there.
    ``fresh`` gives the context of a launch in which nothing has been executed, ``arguments`` those that launch is given. ``shown`` gives
    the path that people see of a file.
    """

    def __init__(
        self,
        meant: Meant,
        share: Callable[[str], str | None],
        environment: Mapping[str, str],
        looked_at: Callable[[str], None] = lambda name: None,
        inside: Callable[[str], bool] = lambda file: False,
        fresh: Callable[[], LiveContext | None] = lambda: None,
        arguments: Callable[[], Iterable[tuple[str, str]]] = tuple,
        installed: Callable[[str], str | None] = lambda file: None,
        may_be_built: Callable[[str], bool] = lambda file: False,
        shown: Callable[[str], str] = lambda file: file,
    ) -> None:
        self.meant = meant
        self.distro = meant.name
        self.share = share
        self.environment = environment
        self.looked_at = looked_at
        self.inside = inside
        self.fresh = fresh
        self.arguments = arguments
        self.installed = installed
        self.may_be_built = may_be_built
        self.shown = shown


class LaunchRecogniser:
    """Recognises for one launch file (a :class:`~launchlint.python.recogniser.Recogniser`).

    ``shares`` are the directories of packages that it was given, each with the package's name.
    """

    def __init__(self, run: Following, outside: Outside, place: Callable[[ast.AST, Scope], Place]) -> None:
        self._run = run
        self._outside = outside
        self._place = place
        self.environment = Map(Variables(outside.environment, self._looked_at))
        self.shares: dict[str, str] = {}
        self.texts = Texts(self.shares)
        self.running = Running(run, self.texts, outside.fresh)
        self.paths = Paths(run, outside.inside, self.environment, outside.installed, outside.may_be_built)
        self.files = Files(run, self.paths, lambda text: load(text, _YAML), self.texts.stand_in)

    def _looked_at(self, variable: str) -> None:
        self._outside.looked_at(variable)
        if variable not in self._outside.environment:
            self._run.missing_variable = self._run.missing_variable or variable

    def call(self, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope) -> Value:
        """An object of launch, a directory, a path, or something that is not known."""
        known = signature(name, self._outside.distro)
        place = self._place(node, scope)
        if known is not None:
            positional = [Seq(list(positional), is_tuple=True)] if known.gathers else positional
            return self._object(known, Given(known, positional, keywords, node, lambda each: self._place(each, scope)))
        if libraries.is_of_library(name):
            made = libraries.made(name, [snapshot(each) for each in positional], keywords, place)
            for problem in libraries.wrong_rewrites(made, place):
                self._run.record(problem)
            return made
        if name in _SHARE or name in _PREFIX:
            return self._directory(name in _SHARE, positional, keywords, place)
        if name in _SHARE_PATH:
            directory = self._directory(True, positional, keywords, place)
            return path(directory) if isinstance(directory, str) else directory
        if name.startswith("launch.utilities.") and not keywords:
            made = self._utility(name.rpartition(".")[2], positional, place)
            if made is not MISSING:
                return made
        if name.startswith(_EVENTS):
            return Handle(EVENT, {"name": name})
        made = self._of_python(name, positional, keywords, place)
        if made is not MISSING:
            return made
        made, fails = bundled.call(name, positional, place, self._outside.distro)
        if made is MISSING:
            made, fails = machine.call(name, positional, place)
        if made is not MISSING:
            self._run.risks += fails
            return made
        if name.startswith("os.path."):
            return _path(name[len("os.path.") :], positional)
        if name == "os.getenv":
            given = [*positional, *(keywords[each] for each in ("key", "default") if each in keywords)]
            return builtins.method(self._run, self.attribute("os", "environ"), "get", given, {})
        if name in _COPIES and len(positional) == 1 and not keywords:
            return snapshot(positional[0])
        if name in _COPIES and not positional:
            return Map(dict(keywords))
        handler = standard.HANDLERS.get(name)
        if handler is not None:
            return handler(Call(self._run, name, positional, keywords, node, scope))
        if name.startswith(_HARMLESS):
            return UNKNOWN
        self._run.escape([*positional, *keywords.values()], "start")
        return Unknown(f"{name} is not looked into", place)

    def _utility(self, name: str, positional: list[Value], place: Place) -> Value:
        """What functions of launch.utilities give; MISSING for all others."""
        if name == "perform_substitutions" and len(positional) == 2:
            return self.running.performed(positional[1], positional[0], place)
        if name != "normalize_to_list_of_substitutions" or len(positional) != 1:
            return MISSING
        given = positional[0]
        items = given.items if isinstance(given, Seq) and given.is_sure else [given]
        if not all(isinstance(each, (str, Open)) or is_path(each) or is_substitution(each) or is_own_substitution(each) for each in items):
            return MISSING
        plain = [spelled(each) for each in items]
        return Seq(
            [Handle("TextSubstitution", {"text": each, "place": place}) if isinstance(each, (str, Open)) else each for each in plain]
        )

    def _of_python(self, name: str, positional: list[Value], keywords: dict[str, Value], place: Place) -> Value:
        """What functions of Python's library give that look at values, paths or files; MISSING for all others."""
        if name.startswith("os.path."):
            return self.paths.of_os(name[len("os.path.") :], positional)
        if name in ("pathlib.Path", "pathlib.PosixPath", "pathlib.PurePath", "pathlib.PurePosixPath"):
            return self.paths.made(positional)
        if name in ("os.listdir", "os.fspath"):
            return (
                self.paths.listed(positional[0])
                if name == "os.listdir" and positional
                else spelled(positional[0])
                if positional
                else MISSING
            )
        if name in ("glob.glob", "glob.iglob") and positional:
            return self.paths.globbed(positional[0], keywords)
        if name.startswith("re."):
            return patterns.call(name, positional, keywords, self._run.spend)
        if name in ("sys.path.append", "sys.path.insert") and positional:
            self._run.finder.look_in(spelled(positional[-1]))
            return None
        if name == "dataclasses.field":
            factory = keywords.get("default_factory", MISSING)
            return keywords.get("default", UNKNOWN) if factory is MISSING else Partial(External(name), (factory,), ())
        if name in ("ament_index_python.packages.get_packages_with_prefixes", "ament_index_python.get_packages_with_prefixes"):
            return Handle(PACKAGES, {})
        made = self.files.call(name, positional, keywords, place)
        return calculated.call(name, positional, keywords) if made is MISSING else made

    def _object(self, known: Signature, given: Given) -> Handle:
        """An object of a class of launch, as it is now; what its constructor would not take is noted, and left out."""
        for name, value in given.values.items():
            if isinstance(value, Seq) and LATER in value.content and name not in _GONE_THROUGH:
                self._run.risks += 1  # most arguments have to be lists
            self._gone_through(value)
        for problem in (*wrong_shape(given, self._outside.meant), *wrong_values(given)):
            self._run.record(problem)
        kind = known.name.rpartition(".")[2]
        if kind == CONTEXT:
            return self.running.context(own=True)
        more = Unknown(f"not all arguments of {kind} are known", given.whole)
        names = known.arguments if given.open else [name for name in known.arguments if name in given.values or name in known.required]
        values = {name: given.values.get(name, more) for name in names}
        if kind not in _MADE_LATER:
            values = {key: snapshot(value, ordered=key not in _IN_ANY_ORDER) for key, value in values.items()}
        if kind == "LaunchDescription" and values.get("initial_entities") is None:
            values["initial_entities"] = Seq([])
        places = {name: inside(given.where(name)) for name in given.values}
        return Handle(kind, {**values, "place": given.whole, "places": places})

    def _gone_through(self, value: Value, depth: int = 0) -> None:
        """Take all that generators give: the classes of launch go through them when they are made, or soon after."""
        if isinstance(value, Seq) and depth <= _DEEPEST:
            self._run.force(value)
            for each in value.items:
                self._gone_through(each, depth + 1)

    def _directory(self, shared: bool, positional: list[Value], keywords: dict[str, Value], place: Place) -> Value:
        package = positional[0] if positional else keywords.get("package_name", UNKNOWN)
        if not isinstance(package, str):
            return Unknown("which package it is, is not known", place)
        directory = self._outside.share(package)
        prefix = f"/opt/ros/{self._outside.distro}"
        if directory is None:
            self._run.missing_package = self._run.missing_package or package
            asked = Asked("find-pkg-share", package)
            if self._run.catching:
                missing = Failure(External("ament_index_python.packages.PackageNotFoundError"), (f"the package {package} is not here",))
                raise Raised(missing, asked=asked)
            self._run.asks(asked, place)
            directory = f"{prefix}/share/{package}"
        if not shared:
            return prefix
        self.shares[directory] = package
        return directory

    def has_package(self, name: Value) -> Value:
        """Whether there is a package of a name."""
        if not isinstance(name, str):
            return UNKNOWN
        found = self._outside.share(name) is not None
        if not found:
            self._run.missing_package = self._run.missing_package or name
        return found

    def given_away(self, value: Handle) -> None:
        """An object of launch is given to code that is not followed: what takes further actions may be given some."""
        actions = value.state.get("initial_entities" if value.kind == "LaunchDescription" else "actions")
        if isinstance(actions, Seq) and value.kind in ("LaunchDescription", "GroupAction"):
            self._run.store(actions.content, COMPLETE, False)

    def attribute(self, name: str, member: str) -> Value:
        """``os.environ`` and whatever else."""
        if (name, member) == ("os", "environ"):
            return self.environment
        if (name, member) == ("sys", "argv"):
            return words(self._outside.arguments())
        constant = calculated.CONSTANTS.get(f"{name}.{member}", MISSING)
        if constant is MISSING and name == "re":
            constant = patterns.flag(f"re.{member}")
        return standard.attribute(name, member) if constant is MISSING else constant

    def member(self, receiver: Handle, name: str) -> Value:
        """All are methods, but the list of actions."""
        if receiver.kind == "LaunchDescription" and name == "entities":
            return receiver.state["initial_entities"]
        if receiver.kind == PATH:
            return self.paths.attribute(receiver, name)
        if receiver.kind == FILE:
            return receiver.state["name"] if name == "name" else MISSING
        return self.running.member(receiver, name)

    def method(
        self, receiver: Handle, name: str, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """``ld.add_action(…)``, and what is asked of the context of a launch that runs."""
        given = [*positional, *keywords.values()]
        if receiver.kind == "LaunchDescription" and name in ("add_action", "add_entity") and len(given) == 1:
            actions = receiver.state["initial_entities"]
            argument = node.args[0] if isinstance(node, ast.Call) and node.args else node
            for problem in wrong_action("LaunchDescription", given[0], self._place(argument, scope)):
                self._run.record(problem)
            if isinstance(actions, Seq):
                self._run.store(actions.content, ITEMS, [*actions.items, given[0]])
            return None
        place = self._place(node, scope)
        if receiver.kind == machine.THING:
            return machine.method(name, place)
        if receiver.kind in (patterns.PATTERN, patterns.MATCH):
            made = MISSING if keywords else patterns.method(receiver, name, positional, self._run.spend)
            return Unknown(f"what {name}() gives is not known", place) if made is MISSING else made
        if receiver.kind in (PATH, FILE, XACRO):
            if receiver.kind == PATH and name in ("open", "read_text"):
                opened = self.files.opened(receiver, given[0] if given and name == "open" else "r")
                return self.files.method(opened, "read", []) if name == "read_text" else opened
            made = (self.paths if receiver.kind == PATH else self.files).method(receiver, name, given)
            return Unknown(f"what {name}() gives is not known", place) if made is MISSING else made
        if receiver.kind in (CONTEXT, CONFIGURATIONS, VARIABLES):
            return self.running.method(receiver, name, given, place)
        if receiver.kind in ("FindPackageShare", "FindPackagePrefix") and name == "find" and len(given) == 1:
            return self._directory(receiver.kind == "FindPackageShare", given, {}, place)
        if name == "_predicate_func" and is_condition(receiver):
            name = "evaluate"
        if len(given) == 1 and ((name == "perform" and receiver.kind in SUBSTITUTIONS) or (name == "evaluate" and is_condition(receiver))):
            return self.running.performed(receiver, given[0], place)
        self._run.escape([receiver, *given], "start")
        return Unknown(f"what {name}() of {receiver.kind} gives is not known", place)

    def inherited(
        self, base: str, instance: Instance, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> None:
        """What an object of a class made of a class of launch is to launch, is kept with it, unless it does something of its own."""
        known = signature(base, self._outside.distro)
        own = (each for each in instance.type.order if isinstance(each, Class))
        if known is None or any(_BEHAVIOUR & each.attributes.keys() for each in own):
            self._run.escape([*positional, *keywords.values()], "start")
            return
        given = Given(known, positional, keywords, node, lambda each: self._place(each, scope))
        self._run.store(instance.attributes, TO_LAUNCH, self._object(known, given))

    def inherited_method(
        self, name: str, instance: Value, positional: list[Value], keywords: dict[str, Value], node: ast.AST, scope: Scope
    ) -> Value:
        """As above."""
        self._run.escape([*positional, *keywords.values()], "start")
        return Unknown(f"{name} is not looked into", self._place(node, scope))

    def text_method(self, spelled: str, name: str, positional: Sequence[Value]) -> Value:
        """Nothing more is known of a directory than its name."""
        return MISSING

    def stays_outside(self, name: str) -> bool:
        """Launch itself and the package index."""
        return name.partition(".")[0] in _OUTSIDE or name.startswith(libraries.FOLLOWED_NOT)

    def is_generated(self, name: str) -> bool:
        """Launch files use no messages."""
        return False

    def is_harmless(self, spelled: str) -> bool:
        """A module by a name that is not known may hold anything."""
        return False

    def from_stars(self, name: str, stars: list[str]) -> Value:
        """What all classes of a module of launch brings; otherwise it may be of any of them."""
        for star in stars:
            if signature(f"{star}.{name}", self._outside.distro) is not None:
                return External(f"{star}.{name}")
        return UNKNOWN

    def is_silent(self, name: str) -> bool:
        """What is not recognised is not known."""
        return False

    def is_open(self, name: str) -> bool:
        """Nothing is known of classes outside."""
        return name != "builtins.object"

    def matters(self, name: str) -> bool:
        """Whoever is given a class of launch may make actions."""
        return is_of_launch(name)

    def mattering(self, name: str) -> list[str]:
        """Not told one by one."""
        return []


class Variables(dict[Any, Any]):
    """The environment; who asks for a variable is noted."""

    def __init__(self, variables: Mapping[str, str], looked_at: Callable[[str], None]) -> None:
        super().__init__(variables)
        self._looked_at = looked_at

    def __contains__(self, name: object) -> bool:
        if isinstance(name, str):
            self._looked_at(name)
        return super().__contains__(name)

    def get(self, name: Any, default: Any = None) -> Any:
        """As of any dict."""
        asked = name in self  # the one way to ask that is noted
        return self[name] if asked else default


def snapshot(value: Value, depth: int = 0, *, ordered: bool = True) -> Value:
    """A value as it is now: lists and dicts that are changed later do not change it; ``ordered``: the order of a list matters."""
    if depth > _DEEPEST:
        return Unknown("lists stand in lists without end")
    if isinstance(value, Seq):
        sure = value.complete and not (ordered and value.kind in UNORDERED and len(value.items) > 1)
        return Seq([snapshot(each, depth + 1) for each in value.items] if sure or not value.complete else [], sure, value.is_tuple)
    if isinstance(value, Map):
        return Map({key: snapshot(each, depth + 1) for key, each in value.entries.items()}, value.complete)
    return value


def inside(place: Place) -> Place:
    """Where the text of a plain string stands: between its quotes; any other place as it is."""
    text = place.text
    if len(text) < 2 or text[0] not in "'\"" or text[-1] != text[0] or text[0] in text[1:-1] or "\\" in text:
        return place
    return Place(place.source, Span(place.span.start + 1, place.span.end - 1))


def _path(name: str, positional: list[Value]) -> Value:
    """Functions of os.path that look at nothing."""
    first = positional[0] if positional else UNKNOWN
    if name in ("abspath", "realpath", "normpath") and isinstance(first, str) and first.startswith("/"):
        return posixpath.normpath(first)
    if isinstance(first, Open) and "/" in first.template.rpartition("}")[2] and name in ("basename", "dirname"):
        head, _, tail = first.template.rpartition("/")
        return tail if name == "basename" else Open(head)
    if isinstance(first, (str, Open)) and name == "splitext":
        spelled = first if isinstance(first, str) else first.template
        root, end = posixpath.splitext(spelled)
        if "}" in end:
            return UNKNOWN
        return Seq([root if isinstance(first, str) else Open(root), end])
    return builtins.path_function(name, positional) if name in ("join", "basename", "dirname", "normpath") else UNKNOWN
