"""Which class or message a name stands for, and what a topic is called in a namespace."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from launchlint.extract.cpp.declarations import Class, Declarations, Field, Function, joined
from launchlint.extract.cpp.foreign import Foreign, is_of_messages
from launchlint.extract.cpp.frame import Frame
from launchlint.extract.cpp.spelled_type import POINTERS, Type, substituted
from launchlint.extract.cpp.values import Either, Number, Text, Value, choices, plain

_MOST_STEPS = 24
_MOST_ALIASES = 9
_DEEPEST = 4
_POINTER_ENDS = ("ConstPtr", "Ptr", "ConstSharedPtr", "SharedPtr", "UniquePtr", "ConstUniquePtr", "WeakPtr", "const_ptr", "Type", "WPtr")
_PARTS_OF_SERVICE = ("Request", "Response", "RequestType", "ResponseType")
_NAME = re.compile(r"[A-Za-z]\w*")
_ABSOLUTE = re.compile(r"(?:\{param:[^|{}]*\|)+/")
_PRIVATE = re.compile(r"~/(?!\{(?:param|arg|option):)")
"""``~`` says the same, unless a value follows that may have a slash in front: behind ``~/`` it is private all the same (names::append)."""
_EMPTY = re.compile(r"~?\{param:[^|{}]*\|\}")
_ANY_MESSAGE = frozenset(("topic_tools::ShapeShifter", "ShapeShifter", "RosIntrospection::ShapeShifter", "rosbag::MessageInstance"))
_CLOUDS = ("pcl::PointCloud", "pcl::PCLPointCloud2", "pcl::PointCloudXYZ")
_OTHER_MESSAGES = {"cv_bridge::CvImage": "sensor_msgs/Image", "PointCloud2": "sensor_msgs/PointCloud2"}

_POINTERS_OF_CLASSES = frozenset(("SharedPtr", "ConstSharedPtr", "UniquePtr", "ConstUniquePtr", "WeakPtr", "SharedConstPtr"))
"""Pointers that RCLCPP_SMART_PTR_DEFINITIONS gives a class as members."""
_KINDS = frozenset(("msg", "srv", "action"))
_CAPITAL = re.compile(r"(?<=[^_])([A-Z][a-z]+)")
_AFTER_SMALL = re.compile(r"(?<=[a-z0-9])([A-Z])")

NODE_NAME = "\x01"
"""Stands for the full name of the node in a template that is not finished."""
NODE_NAMESPACE = "\x02"
"""Stands for the namespace of the node, without a slash behind it."""
UNKNOWN_SPACE = "\x03"
"""Stands for the namespace of a node handle of which nothing is known."""
PLUGIN = "\x04"
"""Stands for the short name of a plugin, until it is known which one is meant."""
LOOSE = "\x05"
"""Stands before a part that nobody knows of a name in a namespace: it may be absolute, and then it is not in the namespace."""
ANY = "{any}"
_ANCHORED = re.compile(r"[~/]?[A-Za-z_][^{}]*\{any\}")

_NO_FRAME = Frame("", "", None, {})


class Names:
    """Looks names of types up in what a program declares."""

    def __init__(self, declarations: Declarations, foreign: Foreign | None = None) -> None:
        self.declarations = declarations
        self._foreign = foreign or Foreign()
        self._bases: dict[str, list[Class]] = {}
        self._chains: dict[Class, list[Class]] = {}
        self._derived: dict[str, list[Class]] = {}
        self._scopes: dict[str, tuple[str, ...]] = {}
        self._resolved: dict[tuple[Type, str, int], tuple[Type, frozenset[str]]] = {}
        self._functions: dict[tuple[str, str], list[Function]] = {}
        self._methods: dict[tuple[Class, str], list[Function]] = {}
        self._variables: dict[tuple[str, str], tuple[str, Field] | None] = {}
        self._meant: dict[tuple[Type, str], Type | None] = {}

    def chain(self, declared: Class) -> list[Class]:
        """A class and its bases, nearest first."""
        known = self._chains.get(declared)
        if known is None:
            known = self._chains[declared] = [declared, *self.bases(declared.name)]
        return known

    def forget(self) -> None:
        """Forget what was looked up, where a using directive in a function has added to what can be found."""
        for each in (self._bases, self._chains, self._derived, self._scopes, self._resolved, self._meant):
            each.clear()
        self._functions.clear()
        self._methods.clear()
        self._variables.clear()

    def scopes(self, scope: str) -> tuple[str, ...]:
        """``scope`` and those around it, then the namespaces that are used; a class's base classes after the class."""
        if scope in self._scopes:
            return self._scopes[scope]
        found: dict[str, None] = {}
        current = scope
        while True:
            found[current] = None
            found.update((base.name, None) for base in self.bases(current))
            if not current:
                break
            current = current.rpartition("::")[0]
        found.update(self.declarations.used)
        self._scopes[scope] = tuple(found)
        return self._scopes[scope]

    def derived(self, base: Class) -> list[Class]:
        """The classes that are derived from one, in the order of the sources."""
        if base.name not in self._derived:
            others = (each for each in self.declarations.classes.values() if each is not base)
            self._derived[base.name] = [other for other in others if any(each is base for each in self.bases(other.name))]
        return self._derived[base.name]

    def bases(self, name: str) -> list[Class]:
        """The base classes of a class, as far as they are declared, nearest first."""
        if name in self._bases:
            return self._bases[name]
        found: list[Class] = []
        pending = [name]
        seen: set[str] = set()
        while pending and len(seen) < 100:
            declared = self.declarations.classes.get(pending.pop(0))
            if declared is None or declared.name in seen:
                continue
            seen.add(declared.name)
            if declared.name != name:
                found.append(declared)
            pending += [self._class_name(base.name, declared.scope) or base.name for base in declared.bases]
        self._bases[name] = found
        return found

    def _class_name(self, name: str, scope: str, depth: int = 0) -> str | None:
        around = [scope]
        while around[-1]:
            around.append(around[-1].rpartition("::")[0])
        for space in [*around, *self.declarations.used]:
            full = joined(space, name)
            if full in self.declarations.classes:
                return full
            alias = self.declarations.aliases.get(full)
            if alias is not None and alias[0].name not in ("", name) and depth < _DEEPEST:
                return self._class_name(alias[0].name, alias[1], depth + 1) or alias[0].name
        return None

    def resolve(self, type_: Type, frame: Frame, scope: str | None = None, depth: int = 0, looked: set[str] | None = None) -> Type:
        """``type_`` with its full name, smart pointers and aliases looked through; template arguments resolved, too.

        Most types mean the same in every function: that is looked up once. ``looked`` takes the names on the way that a function may
        give another meaning.
        """
        start = frame.scope if scope is None else scope
        key = (type_, start, depth)
        known = self._resolved.get(key)
        if known is None:
            names: set[str] = set()
            found = self._resolve(type_, _NO_FRAME, start, depth, names)
            known = self._resolved[key] = (found, frozenset(names))
        found, on_the_way = known
        if looked is not None:
            looked |= on_the_way
        if (frame.aliases or frame.bindings or frame.outer is not None) and any(frame.alias(each) is not None for each in on_the_way):
            return self._resolve(type_, frame, start, depth, set())
        return found

    def functions(self, name: str, scope: str) -> list[Function]:
        """The functions that a name means in a scope: those of the nearest one that has any."""
        key = (name, scope)
        known = self._functions.get(key)
        if known is None:
            listed = (self.declarations.functions.get(joined(each, name)) for each in self.scopes(scope))
            known = self._functions[key] = next(filter(None, listed), [])
        return known

    def methods(self, declared: Class, name: str) -> list[Function]:
        """The member functions of that name that a call on an object of a class means."""
        key = (declared, name)
        known = self._methods.get(key)
        if known is None:
            known = self._methods[key] = self.methods_among(self.chain(declared), name)
        return known

    def methods_among(self, classes: Sequence[Class], name: str) -> list[Function]:
        """Those of some classes, the nearest first."""
        found: list[Function] = []
        for declared in classes:
            # One of a base class with as many parameters is overridden; one with another number is meant by a call that needs it.
            taken = {len(each.parameters) for each in found}
            own = self.declarations.functions.get(joined(declared.name, name), [])
            found += [each for each in own if each.body is not None and len(each.parameters) not in taken]
        return found

    def variable(self, name: str, scope: str) -> tuple[str, Field] | None:
        """The variable outside of functions, or the static member, that a name means in a scope, with its full name."""
        key = (name, scope)
        if key not in self._variables:
            self._variables[key] = self._variable(name, scope)
        return self._variables[key]

    def _variable(self, name: str, scope: str) -> tuple[str, Field] | None:
        for each in self.scopes(scope):
            full = joined(each, name)
            field = self.declarations.variables.get(full)
            if field is None and "::" in name:
                owner, _, last = full.rpartition("::")
                declared = self.declarations.classes.get(owner)
                field = declared.fields.get(last) if declared is not None else None
            if field is not None:
                return full, field
        return None

    def behind_aliases(self, type_: Type, scope: str) -> Type | None:
        """What a type is another name of, by the aliases of the program alone; None where that is a smart pointer."""
        key = (type_, scope)
        if key not in self._meant:
            self._meant[key] = self._behind_aliases(type_, scope)
        return self._meant[key]

    def _behind_aliases(self, type_: Type, scope: str) -> Type | None:
        aliases = self.declarations.aliases
        for _ in range(_MOST_ALIASES):
            if type_.name in POINTERS or type_.name.endswith(("::Ptr", "::ConstPtr")) or type_.member in ("Ptr", "ConstPtr"):
                return None
            name = type_.name
            found = next((full for each in self.scopes(scope) if (full := joined(each, name)) in aliases), "")
            if not found:
                break
            type_, scope = aliases[found]
        return type_

    def _resolve(self, type_: Type, frame: Frame, scope: str, depth: int, looked: set[str]) -> Type:
        start = scope
        for _ in range(_MOST_STEPS):
            if not type_.name:
                return type_
            if type_.name in POINTERS and type_.arguments:
                type_ = type_.arguments[0]
                continue
            looked.add(type_.name.partition("::")[0])
            following = self._step(type_, frame, start)
            if following is None:
                break
            type_, start = following
        if depth > _DEEPEST:
            return type_._replace(arguments=())
        if not type_.arguments:
            return type_
        return type_._replace(arguments=tuple(self.resolve(each, frame, scope, depth + 1, looked) for each in type_.arguments[:6]))

    def _step(self, type_: Type, frame: Frame, scope: str) -> tuple[Type, str] | None:
        """One alias looked through; None where there is nothing left to do."""
        name = type_.name
        first, separator, rest = name.partition("::")
        bound = frame.alias(first)
        if bound is not None and bound.name != name:
            if separator:
                return (Type(f"{bound.name}::{rest}") if not bound.arguments else bound._replace(member=rest)), scope
            return bound, scope
        classes, aliases, namespaces = self.declarations.classes, self.declarations.aliases, self.declarations.namespaces
        is_pointer = not type_.arguments and type_.last in _POINTERS_OF_CLASSES
        for around in self.scopes(scope):
            full = f"{around}::{name}" if around else name
            if full in classes:
                found = type_._replace(name=full)
                if type_.member:
                    inner = joined(full, type_.member)
                    if inner in aliases or inner in classes:
                        return Type(inner), full
                return None if full == name else (found, "")
            if full in aliases:
                named, where = aliases[full]
                if full in self.declarations.alias_templates:
                    named = substituted(named, dict(zip(self.declarations.alias_templates[full], type_.arguments, strict=False)))
                if named.name not in (name, full):
                    if type_.member:
                        named = named._replace(member=type_.member) if named.arguments else Type(joined(named.name, type_.member))
                    return named, where
            if is_pointer:
                inner = joined(around, name.rpartition("::")[0])
                if inner in classes:
                    return Type(inner), ""
            if separator:
                head = f"{around}::{first}" if around else first
                if head in namespaces:
                    return type_._replace(name=joined(namespaces[head], rest)), ""
                if head in aliases:
                    named, where = aliases[head]
                    if named.name not in (first, head):
                        return (
                            Type(joined(named.name, rest), type_.arguments) if not named.arguments else named._replace(member=rest)
                        ), where
        return None

    def declared(self, type_: Type) -> Class | None:
        """The class that a resolved type is."""
        return self.declarations.classes.get(type_.name)

    def message(self, type_: Type, frame: Frame, service: bool = False) -> str:
        """``pkg/Type`` of a message type (or of a service, also by its request); empty where it is none that is known."""
        resolved = self.resolve(type_, frame)
        for _ in range(4):
            if resolved.name in ("ros::MessageEvent", "ros::ServiceEvent", "ros::ServiceSpec") and resolved.arguments:
                resolved = self.resolve(resolved.arguments[0], frame)
        name = resolved.name
        if name in _ANY_MESSAGE:
            return "*"
        if name.startswith(_CLOUDS):
            return "sensor_msgs/PointCloud2"
        parts = [part.strip() for part in name.split("::")]
        if resolved.arguments and resolved.member and resolved.member not in _POINTER_ENDS:
            parts.append(resolved.member)
        while len(parts) > 1 and (parts[-1] in _POINTER_ENDS or (service and parts[-1] in _PARTS_OF_SERVICE)):
            parts.pop()
        if name in _OTHER_MESSAGES or "::".join(parts) in _OTHER_MESSAGES:
            return _OTHER_MESSAGES["::".join(parts)]
        if parts[0].startswith(_CLOUDS):
            return "sensor_msgs/PointCloud2"
        return self._of_ros2(parts, frame.scope) or self._message(parts, service, frame.scope)

    def _of_ros2(self, parts: list[str], scope: str) -> str:
        """``pkg/msg/Type`` of ``pkg::msg::Type``, also where a namespace around or used saves the beginning of it; empty where none."""
        if not all(_NAME.fullmatch(part) for part in parts):
            return ""
        last = parts[-1].removesuffix("_")
        if "::".join(parts) in self.declarations.classes or not last:
            return ""
        if len(parts) >= 3 and parts[-2] in _KINDS:
            return f"{parts[-3]}/{parts[-2]}/{last}"
        for space in self.scopes(scope):
            spaces = [*space.split("::"), *parts[:-1]]
            if len(spaces) >= 2 and spaces[-1] in _KINDS and f"{spaces[-2]}/{spaces[-1]}/{snake(last)}" in self.declarations.messages:
                return f"{spaces[-2]}/{spaces[-1]}/{last}"
        return ""

    def _message(self, parts: list[str], service: bool, scope: str) -> str:
        last = parts[-1].removesuffix("_")
        known = self.declarations.messages
        if not all(_NAME.fullmatch(part) for part in parts) or joined("::".join(parts[:-1]), parts[-1]) in self.declarations.classes:
            return ""
        spellings = [last]
        if service:
            spellings += [last.removesuffix(end) for end in ("Request", "Response") if last.endswith(end)][:1]
        else:
            spellings += [last.removesuffix(end) for end in ("ConstPtr", "Ptr") if last.endswith(end)][:1]
        for spelling in reversed(spellings):
            if len(parts) == 2 and f"{parts[0]}/{spelling}" in known:
                return f"{parts[0]}/{spelling}"
        opened = self._opened("::".join(parts[:-1]), scope) if len(parts) > 1 else None
        if opened is not None:
            included = [f"{used}/{each}" for used in opened for each in reversed(spellings) if f"{used}/{each}" in known]
            return included[0] if len(included) == 1 else ""
        if len(parts) == 2 and self._foreign.may_declare(parts[0], any(each.startswith(f"{parts[0]}/") for each in known)):
            return ""
        if len(parts) == 2 and parts[0] not in ("std", "boost", "ros", "Eigen", "cv", "pcl", "tf", "tf2"):
            return f"{parts[0]}/{spellings[-1]}"
        if len(parts) == 1:
            for spelling in reversed(spellings):
                for used in self.declarations.used:
                    if f"{used}/{spelling}" in known:
                        return f"{used}/{spelling}"
        return f"{parts[0]}/{last}" if len(parts) == 2 and f"{parts[0]}/{last}" in ("tf/tfMessage", "tf/FrameGraph") else ""

    def _opened(self, name: str, scope: str) -> list[str] | None:
        """The namespaces that are used in namespace ``name`` of these sources; None where it may be that of a message package."""
        for around in self.scopes(scope):
            opened = self.declarations.opened.get(joined(around, name))
            if opened is not None and (around or "::" in name or any(is_of_messages(each) for each in opened)):
                return opened
        return None


def snake(name: str) -> str:
    """How the header of a message is called: ``PointCloud2`` is in ``point_cloud2.hpp`` (rosidl_pycommon)."""
    return _AFTER_SMALL.sub(r"_\1", _CAPITAL.sub(r"_\1", name)).lower()


_MARKS = dict.fromkeys(map(ord, NODE_NAME + NODE_NAMESPACE + UNKNOWN_SPACE + PLUGIN + LOOSE))


def is_whole(text: Text) -> bool:
    """Whether a text is known to its last letter: nothing in it stands for what only the launch file or a param says."""
    return not any(each in "{}" or ord(each) in _MARKS for each in text.template)


def braced(text: str) -> str:
    """Plain text as a template."""
    return text.replace("{", "{{").replace("}", "}}").translate(_MARKS)


def together(first: Value, second: Value) -> Value:
    """Two texts, one behind the other."""
    if isinstance(first, Either) or isinstance(second, Either):
        from launchlint.extract.cpp.values import both, either

        found = [(both(a, b), together(left, right)) for a, left in choices(first)[:4] for b, right in choices(second)[:4]]
        return either(found)
    return Text(template(first) + template(second))


def template(value: Value) -> str:
    """What ``value`` puts into a text."""
    if isinstance(value, Text):
        return value.template
    if isinstance(value, Number):
        return plain(value) or ANY
    return ANY


def in_namespace(namespace: str, name: str) -> str:
    """A name as a node handle of ``namespace`` makes it (ros::NodeHandle::resolveName)."""
    if name.startswith(("/", "~", "{remap:", "{parent:", NODE_NAME, NODE_NAMESPACE)) or not namespace:
        return name
    if not name:
        return namespace
    if _ABSOLUTE.match(name):
        return name  # a param that is a global name by default
    if name.startswith(ANY):
        name = LOOSE + name
    if namespace == "~":
        return f"~{name}"
    return f"{namespace.rstrip('/')}/{name}"


def is_anchored(name: str) -> bool:
    """Whether what is known of a name that is not known as a whole says where it lies: ``camera{any}``, ``~costmap/{any}``."""
    return UNKNOWN_SPACE not in name and _ANCHORED.match(name) is not None


def is_loose(name: str) -> bool:
    """Whether what is known of a name does not say how it begins."""
    return ANY in name and not is_anchored(name)


def below(namespace: str, name: str) -> str:
    """The namespace of a node handle made of another one and a name; a mere slash is no name (ros::names::clean leaves nothing of it)."""
    if name and not name.strip("/"):
        return namespace
    if name.startswith("~"):
        return "~/" + name[1:].lstrip("/") if name.strip("~/") else "~"
    return name if name == UNKNOWN_SPACE else in_namespace(namespace, name)


@lru_cache(maxsize=16384)
def finished(name: str) -> str:
    """A name as the library format has it: the node's own name in front is ``~``, doubled and last slashes are gone."""
    name = name.replace(LOOSE, "").replace("/" + NODE_NAME, NODE_NAME).replace("/" + NODE_NAMESPACE, NODE_NAMESPACE)
    if name.startswith(NODE_NAME):
        rest = name[1:]
        name = "~" + rest.lstrip("/") if not rest or rest.startswith("/") else "{node}" + rest
    elif name.startswith(NODE_NAMESPACE):
        name = name[1:].lstrip("/")
    elif name.startswith("~" + NODE_NAME):
        name = "~" + name[2:].lstrip("/")
    name = name.replace(NODE_NAME, ANY).replace(NODE_NAMESPACE, ANY).replace(PLUGIN, ANY)
    name = _PRIVATE.sub("~", re.sub(r"/{2,}", "/", name))
    if _EMPTY.fullmatch(name):
        name = name[:-2] + "}"  # no topic can be called by an empty default
    while ANY + ANY in name:
        name = name.replace(ANY + ANY, ANY)
    return name.rstrip("/") if len(name) > 1 else name


def full_name(namespace: str) -> str:
    """What ros::NodeHandle::getNamespace() gives, unfinished."""
    if namespace.startswith("/"):
        return namespace
    if namespace.startswith("~"):
        rest = namespace[1:].lstrip("/")
        return NODE_NAME + ("/" + rest if rest else "")
    return NODE_NAMESPACE + ("/" + namespace if namespace else "")
