"""Values of a followed launch file as texts: strings, substitutions, and lists of them.

What is not known of a value is a piece of its text that says why. Source: ``launch.utilities.normalize_to_list_of_substitutions``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from launchlint.model import StandIn
from launchlint.python.failures import Asked
from launchlint.python.values import SIGNS, Choice, Class, External, Handle, Instance, Map, Seq, Unknown, Value
from launchlint.python.values import Text as Open
from launchlint.source import Place
from launchlint.syntax.ros2 import description as described
from launchlint.syntax.ros2.description import NOT_KNOWN, Substitution, Text, unknown

_SLOT = re.compile(r"\{\{|\}\}|\ue000\{stand-in:(\d+)\}|\{(?:[^{}]|\{[^{}]*\})*\}|[{}\ue000\ue001]")
_SHARE = r"(?:(?<![\w./-])|(?<=://))(?:{})(?![\w.-])"
"""A directory in a text: the whole of a path, or what one begins with; it may be that of an address."""
_PLAIN = {
    "LaunchConfiguration": ("var", "variable_name", "default"),
    "EnvironmentVariable": ("env", "name", "default_value"),
    "Command": ("command", "command", "on_stderr"),
    "FindExecutable": ("find-exec", "name"),
    "ThisLaunchFile": ("filename",),
    "ThisLaunchFileDir": ("dirname",),
    "AnonName": ("anon", "name"),
    "NotSubstitution": ("not", "value"),
    "AndSubstitution": ("and", "left", "right"),
    "OrSubstitution": ("or", "left", "right"),
    "EqualsSubstitution": ("equals", "left", "right"),
    "NotEqualsSubstitution": ("not-equals", "left", "right"),
    "IfElseSubstitution": ("if", "condition", "if_value", "else_value"),
    "FileContent": ("file-content", "path"),
    "LaunchLogDir": ("launch_log_dir",),
    "FindPackageShare": ("find-pkg-share", "package"),
    "FindPackagePrefix": ("find-pkg-prefix", "package"),
    "ExecutableInPackage": ("exec-in-pkg", "executable", "package"),
    "Parameter": ("param", "name", "default"),
}
"""Class → the name of its substitution, and which of its arguments are the words."""
_BASES = ("launch.Substitution", "launch.substitution.Substitution")
_FOLDED = {"AnySubstitution": ("or", "false"), "AllSubstitution": ("and", "true")}
"""What is the same as a substitution of two values, one after the other, and what it is without any."""
LIBRARY = frozenset(("LaunchConfigAsBool", "RewrittenYaml", "ReplaceString", "HasNodeParams"))
"""Those of nav2_common."""
SUBSTITUTIONS = frozenset((*_PLAIN, *_FOLDED, *LIBRARY, "TextSubstitution", "PathJoinSubstitution", "PythonExpression"))
TO_LAUNCH = "\0to launch"
"""Among the attributes of an object of a class of the program: what it is to launch, as an object of the class of launch it is made of."""
PATH_JOIN = "path-join"
"""What stands for PathJoinSubstitution: its parts are joined as by os.path.join when all of them are performed."""
SHARE = "find-pkg-share"


def is_substitution(value: Value) -> bool:
    """Whether a value is an object of a substitution's class."""
    return isinstance(value, Handle) and value.kind in SUBSTITUTIONS


def is_of_class(value: Value, type_: Value) -> bool | None:
    """``isinstance(value, type_)`` for an object of launch and a class of launch; None where that is not known."""
    if isinstance(type_, Seq):
        answers = [is_of_class(value, each) for each in type_.items]
        return True if True in answers else None if None in answers or not type_.complete else False
    if not isinstance(value, Handle) or not isinstance(type_, External) or not type_.name.startswith(("launch.", "launch_ros.")):
        return None
    word = type_.name.rpartition(".")[2]
    if word == value.kind or (word == "Substitution" and value.kind in SUBSTITUTIONS):
        return True
    apart = SUBSTITUTIONS.issuperset((word, value.kind)) and not word.startswith("Find")  # one that finds is made of another
    return False if apart else None


def is_own_substitution(value: Value) -> bool:
    """Whether a value is an object of a class of the program that is made of launch's Substitution, and can be performed."""
    if not isinstance(value, Instance) or not any(isinstance(each, External) and each.name in _BASES for each in value.type.order):
        return False
    return any(isinstance(each, Class) and "perform" in each.attributes for each in value.type.order)


def why(value: Value, what: str) -> str:
    """Why a value is none of those that are wanted: since it is not known, for its own reason, or for ``what`` it is."""
    if isinstance(value, Unknown):
        return value.reason or "it is not known what it is"
    if isinstance(value, Choice):
        said = next((condition for condition, _ in value.alternatives if condition), "what is not known")
        return f"it depends on {said}"
    return what


def asking(asked: Asked, place: Place) -> Substitution:
    """The substitution that asks for what a program asks for."""
    return Substitution(asked.name, (Text((asked.word,), place),), place)


class Texts:
    """Makes texts in one launch file.

    ``shares`` are the directories of packages that the program was given, each with its package: paths in strings that begin with one
    are said to be in that package. ``gives`` says what performs a substitution of the program's own.
    """

    def __init__(self, shares: Mapping[str, str]) -> None:
        self._shares = shares
        self.gives: Callable[[Instance, Place], described.Gives] | None = None
        self._stand_ins: list[StandIn | Asked] = []
        self._numbers: dict[StandIn | Asked, int] = {}
        self._directories: tuple[int, re.Pattern[str]] | None = None

    def stand_in(self, found: StandIn | Asked) -> Open:
        """A text that stands for what is not known, or not here, as a string of the program."""
        number = self._numbers.setdefault(found, len(self._stand_ins))
        if number == len(self._stand_ins):
            self._stand_ins.append(found)
        return Open(f"{SIGNS[0]}{{stand-in:{number}}}")

    def text(self, value: Value, place: Place) -> Text:
        """The text that a value stands for."""
        pieces: list[str | Substitution] = []
        for each in value.items if isinstance(value, Seq) else [value]:
            self._add(pieces, each, place)
        if isinstance(value, Seq) and not value.complete:
            pieces += unknown("not all parts of the list are known", place).pieces
        return Text(tuple(pieces), place)

    def optional(self, value: Value, place: Place) -> Text | None:
        """The same for what may be None."""
        return None if value is None else self.text(value, place)

    def texts(self, value: Value, place: Place) -> tuple[Text, ...]:
        """A list of texts; one that is not known stands for those that are not."""
        if value is None:
            return ()
        if isinstance(value, str):  # each letter is an item, as Python goes through a text
            return tuple(Text((each,), place) for each in value)
        if not isinstance(value, Seq):
            return (unknown(why(value, "it is no list"), place),)
        more = () if value.complete else (unknown("not all items of the list are known", place),)
        return (*(self.text(each, place) for each in value.items), *more)

    def _add(self, pieces: list[str | Substitution], value: Value, place: Place) -> None:
        new: list[str | Substitution] = []
        if isinstance(value, Handle) and value.kind == "Path":
            value = value.state["text"]
        if isinstance(value, str):
            new = self._string(value, place)
        elif isinstance(value, Open):
            new = self._slots(value.template, place)
        elif isinstance(value, Handle) and value.kind == "TextSubstitution":
            self._add(pieces, value.state["text"], place)
        elif isinstance(value, Handle) and value.kind in SUBSTITUTIONS:
            new = [self.substitution(value)]
        elif self.gives is not None and isinstance(value, Instance) and is_own_substitution(value):
            new = [Substitution(described.CALLED, (), place, self.gives(value, place))]
        else:
            at = value.place if isinstance(value, Unknown) and value.place is not None else place
            new = list(unknown(why(value, "it is no text"), at).pieces)
        for piece in new:
            if isinstance(piece, str) and pieces and isinstance(pieces[-1], str):
                pieces[-1] += piece
            elif piece != "":
                pieces.append(piece)

    def _string(self, value: str, place: Place) -> list[str | Substitution]:
        """A string; where the directory of a package stands in it, as a path or the beginning of one, it says so."""
        if not self._shares or "/" not in value:
            return [value]
        if self._directories is None or self._directories[0] != len(self._shares):
            longest_first = sorted(self._shares, key=len, reverse=True)
            self._directories = len(self._shares), re.compile(_SHARE.format("|".join(map(re.escape, longest_first))))
        found: list[str | Substitution] = []
        at = 0
        for match in self._directories[1].finditer(value):
            found += [value[at : match.start()], Substitution(SHARE, (Text((self._shares[match[0]],), place),), place)]
            at = match.end()
        return [*found, value[at:]]

    def _slots(self, template: str, place: Place) -> list[str | Substitution]:
        """A string of which not all is known."""
        found: list[str | Substitution] = []
        at = 0
        for match in _SLOT.finditer(template):
            found.append(template[at : match.start()])
            at = match.end()
            if match[1] and int(match[1]) < len(self._stand_ins):
                one = self._stand_ins[int(match[1])]
                if isinstance(one, Asked):
                    found.append(asking(one, place))
                else:
                    found.append(Substitution(NOT_KNOWN, (Text((one.reason,), place), Text((one.text,), place)), place))
            elif match[0] in ("{{", "}}"):
                found.append(match[0][0])
            else:
                of = match[0][1:-1] if match[0].endswith("()}") else ""
                found += unknown(f"what {of} gives is not known" if of else "a part of the string is not known", place).pieces
        return [*found, template[at:]]

    def literal(self, value: Value, place: Place) -> str | None:
        """A string, where all of it is known."""
        return value if isinstance(value, str) else None

    def substitution(self, value: Handle) -> Substitution:
        """What an object of a substitution's class stands for."""
        place: Place = value.state["place"]
        given, places = value.state, value.state.get("places", {})
        if value.kind == "PathJoinSubstitution":
            return Substitution(PATH_JOIN, self.texts(given["substitutions"], places.get("substitutions", place)), place)
        if value.kind == "PythonExpression":
            modules = given.get("python_modules")
            words = (self.text(given["expression"], places.get("expression", place)),)
            if modules is None:
                return Substitution("eval", words, place)
            names = modules.items if isinstance(modules, Seq) else [modules]
            if not all(isinstance(each, str) for each in names):
                return Substitution("eval", (*words, self.text(modules, place)), place)
            return Substitution("eval", (*words, Text((",".join(names),), place)), place)
        if value.kind in LIBRARY:
            return self._of_library(value.kind, given, place)
        if value.kind in _FOLDED:
            name, none = _FOLDED[value.kind]
            made = Text((none,), place)
            for each in self.texts(given["values"], place):
                made = Text((Substitution(name, (made, each), place),), place)
            return Substitution(name, (made, Text((none,), place)), place)
        name, *roles = _PLAIN[value.kind]
        arguments = [self.text(_default(given[role], role), places.get(role, place)) for role in roles if given.get(role) is not None]
        return Substitution(name, tuple(arguments), place)

    def _of_library(self, kind: str, given: Mapping[Any, Value], place: Place) -> Substitution:
        """A substitution of nav2_common, with its words as :mod:`launchlint.evaluate.ros2.library_substitutions` takes them."""
        if kind == "LaunchConfigAsBool":
            configuration = Substitution("var", (self.text(given["name"], place),), place)
            return Substitution(described.AS_BOOL, (Text((configuration,), place),), place)
        source = self.text(given["source_file"], place)
        if kind == "HasNodeParams":
            return Substitution(described.HAS_PARAMS, (source, self.text(given["node_name"], place)), place)
        if kind == "ReplaceString":
            condition = given.get("condition")
            replaced = Substitution(described.REPLACED, (source, *self._rewrites(given["replacements"], "", place)), place)
            if condition is None:
                return replaced
            if not isinstance(condition, Handle) or condition.kind not in ("IfCondition", "UnlessCondition"):
                return Substitution(NOT_KNOWN, (Text(("whether texts are replaced is not known",), place),), place)
            test = self.text(condition.state["predicate_expression"], place)
            ways = (Text((replaced,), place), source)
            return Substitution("if", (test, *(ways if condition.kind == "IfCondition" else ways[::-1])), place)
        root = given.get("root_key")
        converts = given.get("convert_types", False)
        words = [source, Text((), place) if root is None else self.text(root, place)]
        words.append(
            Text((str(converts),), place) if isinstance(converts, bool) else unknown("whether types are converted is not known", place)
        )
        for role, name in (("param_rewrites", "param"), ("key_rewrites", "key"), ("value_rewrites", "value")):
            words += self._rewrites(given.get(role), name, place)
        return Substitution(described.REWRITTEN, tuple(words), place)

    def _rewrites(self, value: Value, kind: str, place: Place) -> list[Text]:
        """The entries of a dict as words, each behind its kind."""
        if value is None or value == "" or (isinstance(value, Seq) and value.is_sure and not value.items):
            return []
        if not isinstance(value, Map) or not value.is_sure or not all(isinstance(key, str) for key in value.entries):
            return [unknown(why(value, "which values are rewritten is not known"), place)]
        found: list[Text] = []
        for key, each in value.entries.items():
            found += [Text((kind,), place)] if kind else []
            found += [Text((key,) if key else (), place), self.text(each, place)]
        return found


def _default(value: Value, role: str) -> Value:
    """A default may be anything: ``str()`` of what is no text counts (launch.substitutions.LaunchConfiguration)."""
    if role == "default" and isinstance(value, (bool, int, float)):
        return str(value)
    return value


def pairs(value: Value) -> tuple[list[tuple[Value, Value]], bool]:
    """A list of pairs, or the items of a mapping; and whether these are all of them."""
    if isinstance(value, Map):
        return list(value.entries.items()), value.complete
    found: list[tuple[Value, Value]] = []
    complete = isinstance(value, Seq) and value.complete
    for each in value.items if isinstance(value, Seq) else []:
        two = each.items if isinstance(each, Seq) and each.complete else ()
        if len(two) == 2:
            found.append((two[0], two[1]))
        else:
            complete = False
    return found, complete
