"""Which functions of a program can have to do with names of ROS: those that call its interface, and those that call such functions.

Told by the words of their bodies, without following them: a word that tells (``advertise``) makes a function relevant, and so does the call
of a relevant one. Which function a call means is told by the class of what stands before it where that is known; else any of its name is.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import lru_cache

from launchlint.extract.cpp.declarations import Class, Declarations, Function
from launchlint.extract.cpp.foreign import is_silent
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.naming import Names
from launchlint.extract.cpp.spelled_type import POINTERS, Type, parse_type
from launchlint.extract.cpp.tables import Tables
from launchlint.named_tuple import NamedTuple

_SKIPPED = re.compile(
    r'//[^\n]*|/\*.*?(?:\*/|\Z)|\bR"(\w{0,16})\(.*?(?:\)\1"|\Z)|"(?:\\.|[^"\\\n])*"?|\'(?:\\.|[^\'\\\n]){1,4}\'',
    re.DOTALL,
)
_MENTION = re.compile(r"(?:((?:[)\]>]\s*)?(?:->|\.|::))\s*)?(?<!\w)([A-Za-z_]\w*)(?=\s*(\(|<[\w:\s,*&<>]{0,200}>\s*\(?|->|>|\.|::|\*|&)?)")
_WORD = re.compile(r"[A-Za-z_]\w*")
_LOCAL = re.compile(
    r"(?<![\w:.>])([A-Za-z_][\w:]*(?:\s*<[^;(){}]{0,200}>)?(?:::\w+)?)(?:\s+const)?(?:\s*[*&]+\s*|\s+)([A-Za-z_]\w*)\s*(?=[;=({,\[:)])"
)
_NO_TYPES = frozenset("return else new delete throw case goto typename const using namespace".split())
_LIBRARIES = frozenset("std boost Eigen cv pcl".split())
_MEMBERS_OF_CLASSES = ("Ptr", "iterator", "Iterator", "pointer", "reference")
_OF_POINTERS = frozenset(("reset", "get", "swap", "lock", "release"))
_NOT_MADE = frozenset(("::", "*", "&", ">"))
_BY_ANY_MENTION = frozenset(("thread",))
_SILENT_MEMBERS = frozenset(("NodeHandle", "Publisher", "Subscriber"))


class Mention(NamedTuple):
    """A word of a body, what it is joined to (``.``, ``->`` or ``::``, and the word before that, where it is one), and what follows.

    A word between angle brackets is told once more, joined by ``<`` to the word before them.
    """

    word: str
    joint: str
    before: str
    follow: str


@lru_cache(maxsize=8192)
def _mentions(text: str) -> dict[str, tuple[Mention, ...]]:
    """The words of a body, without those of comments and literals, each with how it stands there."""
    found: set[Mention] = set()
    last = ""
    for prefix, word, follow in _MENTION.findall(_SKIPPED.sub(" ", text)):
        joint = "" if not prefix else "::" if prefix.endswith("::") else "->" if prefix.endswith("->") else "."
        found.add(Mention(word, joint, last if prefix in ("->", ".", "::") else "", follow))
        if follow[:1] == "<":
            found.update(Mention(each, "<", word, follow[-1]) for each in _WORD.findall(follow))
        last = word
    by_word: dict[str, tuple[Mention, ...]] = {}
    for each in found:
        by_word[each.word] = (*by_word.get(each.word, ()), each)
    return by_word


@lru_cache(maxsize=4096)
def _locals(text: str) -> dict[str, list[str]]:
    """The variables that a body seems to declare, each with what stands for its type, mostly once."""
    found: dict[str, list[str]] = {}
    for type_, name in _LOCAL.findall(_SKIPPED.sub(" ", text)):
        if type_ not in _NO_TYPES:
            found.setdefault(name, []).append(type_)
    return found


def _is_given(handle: Mention) -> bool:
    """Whether the name of a node handle stands for the handle itself, which may be handed on, and not for a member of it."""
    return handle.follow not in (".", "->")


def _is_of(type_: Type, last: str, owners: frozenset[str]) -> bool:
    """Whether a type is the class ``last`` of one of some namespaces, or of none."""
    space = type_.name.rpartition("::")[0].rpartition("::")[2]
    return type_.last == last and (not space or space in owners)


def _tells(mention: Mention) -> bool:
    """Whether a word that tells stands where it does: a function (``param``) where it is called or its address is taken."""
    word = mention.word
    return not word[0].islower() or word in _BY_ANY_MENTION or mention.joint == "::" or mention.follow.endswith(("(", "::"))


class Relevance:
    """Marks each function of a program that is relevant.

    Args:
        declarations: of the program.
        names: looks up the types of what calls stand behind.
        tables: of the client library, with the words that tell.
        others: says which of some words are of headers that are not here and may talk.
    """

    def __init__(self, declarations: Declarations, names: Names, tables: Tables, others: Callable[[Iterable[str]], set[str]]) -> None:
        self._declarations = declarations
        self._names = names
        self._tables = tables
        self._classes: dict[tuple[Function, str], tuple[str | None, ...]] = {}
        self._lineage: dict[str, frozenset[str]] = {}
        self._mentioned: dict[str, list[tuple[Function, Mention]]] = {}
        self._pending: list[Function] = []
        self._made: set[str] = set()
        self._by_last: dict[str, list[str]] = {}
        self._holders: dict[str, list[Class]] = {}
        self._fields: dict[str, list[Type]] = {}
        self._derived: dict[str, list[Class]] = {}
        self._aliases: dict[str, list[str]] = {}
        self._handles = {name.rpartition("::")[2] for name, each in declarations.variables.items() if self._is_handle(each.type)}
        self._read(tables.words, others)
        while self._pending:
            self._reached(self._pending.pop())

    def _read(self, telling: Iterable[str], others: Callable[[Iterable[str]], set[str]]) -> None:
        for declared in self._declarations.classes.values():
            self._by_last.setdefault(declared.name.rpartition("::")[2], []).append(declared.name)
            for field_name, field in declared.fields.items():
                self._fields.setdefault(field_name, []).append(field.type)
                if self._is_handle(field.type):
                    self._handles.add(field_name)
                if not field.pointer:
                    self._holders.setdefault(field.type.last, []).append(declared)
            for base in self._names.bases(declared.name):
                self._derived.setdefault(base.name, []).append(declared)
        functions = [each for found in self._declarations.functions.values() for each in found if each.body is not None]
        functions += [each for each in self._declarations.tests if each.body is not None]
        for full, (named, _) in self._declarations.aliases.items():
            self._aliases.setdefault(named.last, []).append(full.rpartition("::")[2])
        strange = others({word for each in functions for word in _mentions(each.text)} | {each for each in self._holders if each})
        told = self._with_aliases({*telling, *strange})
        told.update(name for name, (_, text) in self._declarations.calls.items() if not told.isdisjoint(_mentions(text)))
        # Only these words can make a function relevant.
        words = {*told, *self._by_last, *self._handles, *(alias for listed in self._aliases.values() for alias in listed)}
        words.update(name.rpartition("::")[2] for name in (*self._declarations.functions, *self._tables.qualified))
        for each in functions:
            each.relevant = False
            own = _mentions(each.text)
            for word in words.intersection(own) if len(own) > len(words) else [word for word in own if word in words]:
                self._mentioned.setdefault(word, []).extend((each, mention) for mention in own[word])
            for parameter in each.parameters:
                if self._is_handle(parameter.type) and any(_is_given(mention) for mention in own.get(parameter.name, ())):
                    self._found(each)
        for found in self._declarations.functions.values():
            # What is declared with ROS at hand, and stands in no source that is here, may do anything.
            if any(each.absent for each in found) and not any(each.body for each in found) and found[0].path in self._declarations.of_ros:
                self._called(found[0])
        for declared in self._declarations.classes.values():
            if any(self._is_strange(base, declared) for base in declared.bases):
                self._making(declared.name)
        for word in self._handles:
            for function, mention in self._mentioned.get(word, ()):
                if _is_given(mention) and not self._is_another(function, word):
                    self._found(function)
        for space, _, word in (name.partition("::") for name in self._tables.qualified):
            for function, mention in self._mentioned.get(word, ()):
                if mention.joint == "::" and mention.before == space:
                    self._found(function)
        methods = {each.last for each in functions if each.owner}
        for word in told:
            for function, mention in self._mentioned.get(word, ()):
                if word in self._tables.owners and not self._is_owned(function, mention):
                    continue
                if word in strange or (_tells(mention) and not (word in methods and self._is_of_program(function, mention))):
                    self._found(function)
            if word[0].isupper() and word not in _SILENT_MEMBERS:
                self._held(word)

    def _is_owned(self, function: Function, mention: Mention) -> bool:
        """Whether a word that other libraries have, too, stands behind a namespace of ROS, or behind none."""
        owners = self._tables.owners[mention.word]
        if mention.joint == "<":
            own = _mentions(function.text)
            return any(each.joint == "<" and each.before == mention.before for owner in owners for each in own.get(owner, ()))
        return mention.joint != "::" or not mention.before or mention.before in owners

    def _is_another(self, function: Function, word: str) -> bool:
        """Whether a word that is a node handle elsewhere is a member of another type in the class of a function."""
        if not function.owner or function.owner not in self._declarations.classes or any(each.name == word for each in function.parameters):
            return False
        chain = (self._declarations.classes[function.owner], *self._names.bases(function.owner))
        field = next((each.fields[word] for each in chain if word in each.fields), None)
        return field is not None and not self._is_handle(field.type)

    def _is_handle(self, type_: Type) -> bool:
        return self._tables.is_handle(type_) or any(self._tables.is_handle(each) for each in type_.arguments)

    def _is_strange(self, base: Type, declared: Class) -> bool:
        """Whether a base class is not here, and may talk."""
        resolved = self._names.resolve(base, Frame(declared.path, declared.name, None, {}))
        return self._names.declared(resolved) is None and resolved.name not in declared.template and not is_silent(resolved.name)

    def _with_aliases(self, words: Iterable[str]) -> set[str]:
        """The last parts of names of classes, with other names of them."""
        found: set[str] = set()
        pending = list(words)
        while pending:
            word = pending.pop()
            if word not in found:
                found.add(word)
                pending += self._aliases.get(word, ())
        return found

    def _found(self, function: Function) -> None:
        if not function.relevant:
            function.relevant = True
            self._pending.append(function)

    def _reached(self, target: Function) -> None:
        """Functions that call ``target``, or make an object of its class."""
        if target.last != target.owner.rpartition("::")[2]:
            self._called(target)
        if target.owner:
            self._making(target.owner)

    def _called(self, target: Function) -> None:
        for function, mention in self._mentioned.get(target.last, ()):
            if not function.relevant and self._means(function, mention, target):
                self._found(function)

    def _making(self, name: str) -> None:
        """An object of the class matters: what is made here may be called elsewhere."""
        if name in self._made:
            return
        self._made.add(name)
        last = name.rpartition("::")[2]
        for each in self._with_aliases((last,)):
            for function, mention in self._mentioned.get(each, ()):
                if not function.relevant and self._makes(mention):
                    self._found(function)
            self._held(each)
        for derived in self._derived.get(name, ()):
            self._making(derived.name)

    def _makes(self, mention: Mention) -> bool:
        """Whether an object is made of the class that a word names, or by a template that is given the class."""
        if mention.joint == "<":
            return mention.before in self._by_last or (mention.follow == "(" and "cast" not in mention.before)
        return mention.follow not in _NOT_MADE

    def _held(self, last: str) -> None:
        """Classes with a member of a class of this name."""
        owners = self._tables.owners.get(last)
        for holder in self._holders.get(last, ()):
            if owners is not None and not any(_is_of(field.type, last, owners) for field in holder.fields.values()):
                continue
            for each in self._declarations.functions.get(f"{holder.name}::{holder.name.rpartition('::')[2]}", ()):
                if each.body is not None:
                    self._found(each)
            self._making(holder.name)

    def _is_of_program(self, function: Function, mention: Mention) -> bool:
        """Whether a call is one of a member of the program's classes that is called like a function of ROS."""
        if mention.joint == "::" or (mention.joint and not mention.before):
            return False
        of_own = not mention.joint or mention.before == "this"
        owners = (function.owner or None,) if of_own else self._class_of(function, mention.before)
        return all(each is not None and self._has(each, mention.word) for each in owners)

    def _has(self, owner: str, name: str) -> bool:
        """Whether a class or one of its bases has a member function with a body."""
        chain = (owner, *(each.name for each in self._names.bases(owner)))
        return any(one.body is not None for each in chain for one in self._declarations.functions.get(f"{each}::{name}", ()))

    # -- which function a call means ----------------------------------------------------------------------------------

    def _means(self, function: Function, mention: Mention, target: Function) -> bool:
        """Whether a word in a function may stand for the function ``target`` of that name."""
        is_method = bool(target.owner)
        if mention.joint in (".", "->"):
            if not mention.before:
                return True
            if mention.joint == "." and mention.word in _OF_POINTERS and self._is_pointer(function, mention.before):
                return False
            if mention.before == "this":
                return not is_method or self._related(function.owner, target.owner)
            return any(each is None or self._related(each, target.owner) for each in self._class_of(function, mention.before))
        if mention.joint == "::" and mention.before:
            if mention.before in _LIBRARIES:
                return False
            declared = self._by_last.get(mention.before)
            if declared and is_method:
                return any(self._related(each, target.owner) for each in declared)
            return True
        if is_method and not mention.joint:
            return "::" in function.name and (not function.owner or self._related(function.owner, target.owner))
        return True

    def _is_pointer(self, function: Function, variable: str) -> bool:
        """Whether a variable is a smart pointer, by the name of its type: what stands behind its dot is of the pointer itself."""
        types = self._types_of(function, variable) or self._fields.get(variable, [])
        return bool(types) and all(each.name in POINTERS or each.last.endswith("Ptr") for each in types)

    def _related(self, name: str, owner: str) -> bool:
        """Whether an object of class ``name`` may be of class ``owner``: one of them is derived from the other."""
        if not owner or name == owner:
            return True
        if name not in self._declarations.classes:
            return name.rpartition("::")[2] in self._of(owner)
        return name in self._of(owner) or owner in self._of(name)

    def _of(self, name: str) -> frozenset[str]:
        """The base classes of a class: by full name where they are here, else by the last part."""
        if name not in self._lineage:
            declared = self._declarations.classes.get(name)
            chain = [*([declared] if declared else []), *self._names.bases(name)]
            self._lineage[name] = frozenset([*(each.name for each in chain), *(base.last for each in chain for base in each.bases)])
        return self._lineage[name]

    def _class_of(self, function: Function, variable: str) -> tuple[str | None, ...]:
        """The classes that a variable may be of; None is one that is not known."""
        key = (function, variable)
        if key not in self._classes:
            types = self._types_of(function, variable)
            self._classes[key] = tuple({self._class_name(function, each) for each in types}) if types else (None,)
        return self._classes[key]

    def _types_of(self, function: Function, variable: str) -> list[Type]:
        types = [parse_type(text) for text in _locals(function.text).get(variable, ())]
        types += [each.type for each in function.parameters if each.name == variable]
        if types or not function.owner:
            return types
        declared = self._declarations.classes.get(function.owner)
        chain = [*([declared] if declared else []), *self._names.bases(function.owner)]
        return next(([each.fields[variable].type] for each in chain if variable in each.fields), [])

    def _class_name(self, function: Function, type_: Type) -> str | None:
        """The full name of the class that a variable of ``type_`` is of; None where it is not known."""
        owner = self._declarations.classes.get(function.owner)
        resolved = self._names.resolve(type_, Frame(function.path, function.scope, None, {}))
        if resolved.name in self._declarations.classes:
            return resolved.name
        if not resolved.name or resolved.member or resolved.last.endswith(_MEMBERS_OF_CLASSES):
            return None
        if resolved.name in function.template or (owner is not None and resolved.name in owner.template):
            return None
        return resolved.name if "::" in resolved.name or resolved.name[0].islower() else None
