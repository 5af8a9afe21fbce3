"""C++ types as they are spelled: ``const boost::shared_ptr<std_msgs::String const>&`` without what does not matter here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache

from launchlint.named_tuple import NamedTuple

_IGNORED = re.compile(
    r"\b(?:const|volatile|typename|struct|class|static|mutable|inline|extern|constexpr|unsigned|signed|register|virtual|enum|template)\b|[&*]"
)
_LONGEST = 2_000
_DEEPEST = 12


class Type(NamedTuple):
    """``name`` with its template ``arguments``; ``member`` is what follows them, as ``ConstPtr`` in ``Image_<A>::ConstPtr``."""

    name: str
    arguments: tuple[Type, ...] = ()
    member: str = ""

    @property
    def last(self) -> str:
        """The last part of the name."""
        return self.name.rpartition("::")[2]


UNTYPED = Type("")
"""A type that is not known, or ``auto``."""

POINTERS = frozenset(
    """boost::shared_ptr std::shared_ptr shared_ptr std::unique_ptr unique_ptr boost::scoped_ptr scoped_ptr
    boost::intrusive_ptr boost::weak_ptr std::weak_ptr std::auto_ptr boost::optional std::optional QSharedPointer
    boost::unique_ptr""".split()
)
"""Types that stand for what they point to."""

TEXTS = frozenset(("std::string", "string", "char", "std::string_view", "QString", "std::basic_string"))
"""Types that hold text."""

DOUBLES = frozenset(("double", "float", "long double", "Scalar", "ros::Duration", "ros::Rate"))
INTEGERS = frozenset(
    """int long short size_t std::size_t uint8_t uint16_t uint32_t uint64_t int8_t int16_t int32_t int64_t std::uint8_t
    std::uint16_t uint std::uint32_t std::uint64_t std::int8_t std::int16_t std::int32_t std::int64_t boost::uint32_t""".split()
) | {"long long", "long int", "short int", "long unsigned int", "long long int"}
LISTS = frozenset(("std::vector", "vector", "std::list", "std::array", "std::set", "std::deque"))
MAPPINGS = frozenset(("std::map", "map", "std::unordered_map"))
ANYTHING = frozenset(("XmlRpc::XmlRpcValue", "XmlRpcValue"))
"""Types that hold a param of any type."""


def substituted(type_: Type, given: Mapping[str, Type], depth: int = 0) -> Type:
    """``type_`` with template parameters replaced by what they are given: ``std::list<T>`` of a template alias."""
    if type_.name in given and not type_.arguments and not type_.member:
        return given[type_.name]
    if not type_.arguments or not given or depth > _DEEPEST:
        return type_
    return type_._replace(arguments=tuple(substituted(each, given, depth + 1) for each in type_.arguments))


@lru_cache(maxsize=8192)
def parse_type(text: str) -> Type:
    """The type that ``text`` spells; :data:`UNTYPED` for one that is too long."""
    if len(text) > _LONGEST:
        return UNTYPED
    plain = " ".join(_IGNORED.sub(" ", text).split())
    plain = re.sub(r" ?(::|<|>|,) ?", r"\1", plain)
    return _parsed(plain, 0)


def _parsed(text: str, depth: int) -> Type:
    text = text.strip().removeprefix("::")
    opening = text.find("<")
    if opening < 0 or depth > _DEEPEST:
        return Type("" if text == "auto" else text)
    closing, parts = _arguments(text, opening)
    member = text[closing + 1 :].removeprefix("::")
    return Type(text[:opening], tuple(_parsed(each, depth + 1) for each in parts), member.partition("<")[0])


def _arguments(text: str, opening: int) -> tuple[int, list[str]]:
    """Where the angle bracket closes, and what stands between, separated by commas."""
    level = 0
    start = opening + 1
    parts: list[str] = []
    for position in range(opening, len(text)):
        char = text[position]
        if char in "<(":
            level += 1
        elif char in ">)":
            level -= 1
            if level == 0:
                return position, [*parts, text[start:position]]
        elif char == "," and level == 1:
            parts.append(text[start:position])
            start = position + 1
    return len(text), [*parts, text[start:]]
