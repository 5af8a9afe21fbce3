"""Plugins: what nodelet::Loader and pluginlib::ClassLoader load is followed where its sources are among those of the program."""

from __future__ import annotations

from collections.abc import Callable as Does

from launchlint.extract.cpp import classes, nodelet
from launchlint.extract.cpp.instance import Instance
from launchlint.extract.cpp.naming import NODE_NAME, PLUGIN
from launchlint.extract.cpp.spelled_type import Type
from launchlint.extract.cpp.values import UNKNOWN, Either, Handle, Items, Number, Text, Thing, Value, choices, plain
from launchlint.extract.fact import Plugin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.extract.cpp.calls import Call

_MOST_LOADED = 64
_NONE_YET = "nodelet::Loader loads nodelets, which have interfaces of their own"
_MAY_TALK = "loads plugins, which may have interfaces of their own"
_API = (("list", "NodeletList"), ("load_nodelet", "NodeletLoad"), ("unload_nodelet", "NodeletUnload"))


def loader(asked: Call) -> Value:
    """``nodelet::Loader(provide_ros_api)`` or ``nodelet::Loader(handle)``: what it serves and reads itself (nodelet/src/loader.cpp)."""
    machine, first = asked.machine, asked.value(0)
    if first != Number(False):
        space = first.namespace if isinstance(first, Handle) else "~"
        at = "" if not space else "~" if space == "~" else f"{space}/"
        for name, type_ in _API:
            machine.fact("services", Text(f"{at}{name}"), asked.node, asked.frame, type=f"nodelet/{type_}")
        machine.fact("params", Text(f"{at}num_worker_threads"), asked.node, asked.frame, value_type="int")
    machine.doubt_all(_NONE_YET, asked.frame.path, asked.node.line)
    machine.serial += 1
    return Thing(Type("nodelet::Loader"), None, machine.serial)


def load(this: Thing, asked: Call) -> Value:
    """``load(name, type, remappings, arguments)``: the nodelet runs in this program under that name."""
    machine = asked.machine
    type_ = asked.value(1)
    described = next((each for each in machine.plugins if isinstance(type_, Text) and each.name == type_.template), None)
    name = asked.value(0)
    if described is None or not isinstance(name, Text) or not name.template.startswith(NODE_NAME) or machine.instance is not None:
        machine.doubt_all("a nodelet is loaded whose class or name is not known", asked.frame.path, asked.node.line)
        return UNKNOWN
    machine.doubts = {each: None for each in machine.doubts if each.reason != _NONE_YET}
    given = asked.value(2)
    fields = given.fields.items() if isinstance(given, Thing) else ()
    known = [(key, cell.value.template) for key, cell in fields if isinstance(cell.value, Text)]
    if len(known) < len(fields):
        machine.doubt_all("a nodelet is loaded with remappings that are not known", asked.frame.path, asked.node.line)
    machine.instance = Instance(name.template, tuple(known))
    try:
        nodelet.start(machine, described.type, asked.frame.path)
    finally:
        machine.instance = None
    return UNKNOWN


def class_loader(asked: Call) -> Value:
    """``pluginlib::ClassLoader<Base>(package, base)``: any package may have a plugin for it, until it is known what it is used for."""
    machine = asked.machine
    machine.doubt_all(f"{asked.name} {_MAY_TALK}", asked.frame.path, asked.node.line)
    machine.serial += 1
    thing = Thing(Type(asked.name, asked.types), None, machine.serial)
    thing.fields["<base>"] = machine.cell(asked.value(1))
    thing.fields["<place>"] = machine.cell(Items((Text(asked.frame.path), Number(asked.node.line))))
    return thing


def create(this: Thing, asked: Call) -> Value:
    """``createInstance(name)``: one object of each class that may be meant, with the condition that it is.

    Where the name is not certain, any package may have another plugin for it.
    """
    machine = asked.machine
    held, place = this.fields.get("<base>"), this.fields.pop("<place>", None)
    if place is not None and isinstance(place.value, Items):
        made = (Text(each.path) == place.value.items[0] and Number(each.line) == place.value.items[1] for each in machine.doubts)
        machine.doubts = {
            each: None for each, here in zip(machine.doubts, made, strict=True) if not (here and each.reason.endswith(_MAY_TALK))
        }
    base = plain(held.value) if held is not None else None
    short = this.type.arguments[0].last if base is None and this.type.arguments else ""
    possible = [each for each in machine.plugins if each.base == base or (short and each.base.rpartition("::")[2] == short)]
    found: list[tuple[str, Value]] = []
    for condition, name in choices(asked.value(0)):
        constant = plain(name)
        meant = [each for each in possible if constant in (each.name, each.name.rpartition("/")[2])]
        if constant is None or not meant:
            machine.doubt_all(f"{this.type.name} {_MAY_TALK}", asked.frame.path, asked.node.line)
        if constant is None:
            found += [(_loaded(each), _made(asked, each, _loaded(each))) for each in possible]
        else:
            found += [(condition, _made(asked, each, condition)) for each in meant]
    found = found[:_MOST_LOADED]
    return found[0][1] if len(found) == 1 and not found[0][0] else Either(tuple(found)) if found else UNKNOWN


def short_name(this: Thing, asked: Call) -> Value:
    """``getName(name)``: the last part of the lookup name; of an unknown one, of that plugin which it is given to."""
    constant = plain(asked.value(0))
    return Text(PLUGIN if constant is None else constant.rpartition("/")[2].rpartition("::")[2])


def told_its_name(this: Thing, asked: Call) -> Call:
    """The call of a member of a plugin, with its own short name in the arguments that wait for it."""
    own = this.fields.get("<plugin>")
    if own is None or not isinstance(own.value, Text):
        return asked
    name = own.value.template
    given = [
        each._replace(value=Text(each.value.template.replace(PLUGIN, name)), cell=None)
        if isinstance(each.value, Text) and PLUGIN in each.value.template
        else each
        for each in asked.arguments
    ]
    return asked._replace(arguments=given)


def _loaded(plugin: Plugin) -> str:
    return f"the plugin {plugin.name} is loaded"


def _made(asked: Call, plugin: Plugin, condition: str) -> Value:
    """An object of the plugin's class."""
    machine = asked.machine
    conditions = machine.conditions
    machine.conditions = [*conditions, condition] if condition else conditions
    try:
        made = classes.construct(machine, Type(plugin.type), [], asked.node, asked.frame)
    finally:
        machine.conditions = conditions
    if isinstance(made, Thing):
        made.fields["<plugin>"] = machine.cell(Text(plugin.name.rpartition("/")[2].rpartition("::")[2]))
    return made


MAKERS: dict[str, Does[[Call], Value]] = {
    "nodelet::Loader": loader,
    **dict.fromkeys(("pluginlib::ClassLoader", "class_loader::ClassLoader", "class_loader::MultiLibraryClassLoader"), class_loader),
}

METHODS: dict[tuple[str, str], Does[[Thing, Call], Value]] = {
    ("nodelet::Loader", "load"): load,
    ("pluginlib::ClassLoader", "getName"): short_name,
    **{
        ("pluginlib::ClassLoader", name): create
        for name in ("createInstance", "createUniqueInstance", "createUnmanagedInstance", "createClassInstance")
    },
    **{
        (f"class_loader::{loader}", name): create
        for loader in ("ClassLoader", "MultiLibraryClassLoader")
        for name in ("createInstance", "createUniqueInstance", "createUnmanagedInstance", "createSharedInstance")
    },
}
