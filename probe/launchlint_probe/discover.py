"""Which programs of which packages are nodes: found by looking, not by running them."""

import ast
import glob
import hashlib
import json
import os
import re
import subprocess
from typing import Any, Dict, FrozenSet, Iterator, List, Optional, Set, Tuple
from xml.etree import ElementTree

LARGEST_SCRIPT = 4 * 1024 * 1024

MOST_FILES = 20000
"""Files of a package's source directory that are looked at."""

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_PROGRAM = re.compile(r"[A-Za-z0-9_][\w.+-]{0,199}", re.ASCII)
_CLASS = re.compile(r"[A-Za-z_]\w*(?:(?:/|::)\w+)*", re.ASCII)
_NO_SCRIPTS = {"test", "tests", "cmake", "build", "doc", "docs", "msg", "srv", "action", "cfg"}


class Marks:
    """By what a node is known: the library that a binary is linked with, the modules that a script imports, of which it is enough to find
    ``word`` in its text where it cannot be read; and what such nodes are called.
    """

    def __init__(self, library: str, binary: str, modules: FrozenSet[str], word: str, script: str) -> None:
        self.library = library
        self.binary = binary
        self.modules = modules
        self.word = word
        self.script = script


ROS1 = Marks(
    "libroscpp.so",
    "roscpp",
    frozenset(
        (
            "rospy",
            "roslib",
            "rosgraph",
            "roslaunch",
            "rosservice",
            "rostopic",
            "actionlib",
            "tf",
            "tf2_ros",
            "smach_ros",
            "dynamic_reconfigure",
        )
    ),
    r"\brospy\b|init_node",
    "rospy",
)
ROS2 = Marks("librclcpp.so", "rclcpp", frozenset(("rclpy", "tf2_ros")), r"\brclpy\b", "rclpy")


class Found:
    """A program: ``kind`` is roscpp, rospy, nodelet, rclcpp, rclpy, component or none; ``command`` starts it; ``path`` is what it is made
    from.
    """

    def __init__(self, package: str, name: str, kind: str, command: List[str], path: str) -> None:
        self.package = package
        self.name = name
        self.kind = kind
        self.command = command
        self.path = path

    @property
    def label(self) -> str:
        """``package/executable``, or the class of a nodelet or component."""
        return self.name if self.kind in ("nodelet", "component") else "{}/{}".format(self.package, self.name)


def default_prefixes() -> List[str]:
    """Where packages are installed: what the environment says, and Debian's own place."""
    found = [each for each in os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if each]
    found += sorted(os.path.join("/opt/ros", name) for name in (os.listdir("/opt/ros") if os.path.isdir("/opt/ros") else []))
    return list(dict.fromkeys(found + ["/usr"]))


class Packages:
    """The packages that can be seen.

    Args:
        programs: package → the directories that hold its programs.
        shares: package → the directories that may hold its ``msg`` folder, the one with its manifest first.
        sources: package → its source directory, where it has one; scripts are started from there as roslaunch does.
    """

    def __init__(self, programs: Dict[str, List[str]], shares: Dict[str, List[str]], sources: Dict[str, str]) -> None:
        self.programs = programs
        self.shares = shares
        self.sources = sources


def see(prefixes: List[str], sources: List[str], marks: Marks = ROS1) -> Packages:
    """The packages of install and devel spaces (``prefixes``) and of source spaces."""
    spaces = list(sources)
    for prefix in prefixes:
        try:
            with open(os.path.join(prefix, ".catkin"), encoding="utf-8") as file:
                spaces.extend(each for each in file.read().split(";") if each and os.path.isdir(each))
        except (OSError, ValueError):
            continue
    own: Dict[str, str] = {}
    for space in spaces:
        for name, directory in sorted(_source_packages(space).items()):
            own.setdefault(name, directory)
    programs = packages(prefixes, frozenset(own), marks)
    shares = {name: [directory] for name, directory in own.items()}
    for prefix in prefixes:
        for name in programs:
            directory = os.path.join(prefix, "share", name)
            if os.path.isdir(directory):
                shares.setdefault(name, []).append(directory)
    return Packages(programs, shares, own)


def _source_packages(space: str) -> Dict[str, str]:
    """The packages below a source space: directories with a manifest, none inside another."""
    found: Dict[str, str] = {}
    for directory, inner, files in os.walk(space):
        inner[:] = sorted(name for name in inner if not name.startswith("."))
        if "CATKIN_IGNORE" in files or "COLCON_IGNORE" in files:
            inner[:] = []
        elif "package.xml" in files:
            inner[:] = []
            name = _manifest_name(os.path.join(directory, "package.xml"))
            if name:
                found.setdefault(name, directory)
    return found


def _manifest_name(path: str) -> str:
    name = manifest_text(path, "name")
    return name if _NAME.fullmatch(name) else ""


def manifest_text(path: str, tag: str) -> str:
    """The text of an element of a manifest; empty where there is none."""
    try:
        if os.path.getsize(path) > LARGEST_SCRIPT:
            return ""
        return (ElementTree.parse(path).getroot().findtext(tag) or "").strip()
    except (ElementTree.ParseError, OSError, ValueError):
        return ""


def packages(prefixes: List[str], own: FrozenSet[str] = frozenset(), marks: Marks = ROS1) -> Dict[str, List[str]]:
    """Package → the directories that hold its programs. Debian puts some programs into ``lib/PACKAGE`` without a manifest.

    ``own`` are packages whose manifest is in a source space.
    """
    found: Dict[str, List[str]] = {name: [] for name in own}
    for prefix in prefixes:
        for place in ("lib", "libexec"):
            top = os.path.join(prefix, place)
            for name in sorted(os.listdir(top)) if os.path.isdir(top) else ():
                directory = os.path.join(top, name)
                if (
                    _NAME.fullmatch(name)
                    and os.path.isdir(directory)
                    and (name in own or _manifest(prefix, name) or _has_nodes(directory, marks))
                ):
                    found.setdefault(name, []).append(directory)
        share = os.path.join(prefix, "share")
        for name in sorted(os.listdir(share)) if os.path.isdir(share) else ():
            if _NAME.fullmatch(name) and _manifest(prefix, name):
                found.setdefault(name, [])
    return found


def _manifest(prefix: str, package: str) -> Optional[str]:
    path = os.path.join(prefix, "share", package, "package.xml")
    return path if os.path.isfile(path) else None


def _has_nodes(directory: str, marks: Marks) -> bool:
    return any(classify(os.path.join(directory, name), marks) != "none" for name in sorted(os.listdir(directory))[:50])


def executables(package: str, directories: List[str], source: Optional[str] = None, marks: Marks = ROS1) -> Iterator[Found]:
    """The programs of a package, by name; of one name the first. In its source directory only nodes count: roslaunch finds scripts
    there.
    """
    seen = set()
    for directory in directories:
        for name in sorted(os.listdir(directory)):
            path = os.path.join(directory, name)
            if name in seen or not _is_program(path):
                continue
            seen.add(name)
            yield Found(package, name, classify(path, marks), [path], path)
    for path in _scripts(source) if source else ():
        name = os.path.basename(path)
        kind = classify(path, marks) if name not in seen and _is_program(path) else "none"
        if kind != "none":
            seen.add(name)
            yield Found(package, name, kind, [path], path)


def _is_program(path: str) -> bool:
    name = os.path.basename(path)
    return (
        _PROGRAM.fullmatch(name) is not None
        and ".so" not in name
        and os.path.isfile(path)
        and os.access(path, os.X_OK)
        and os.path.isfile(os.path.realpath(path))
    )


def _scripts(source: str) -> List[str]:
    found: List[str] = []
    for directory, inner, files in os.walk(source):
        inner[:] = sorted(name for name in inner if not name.startswith(".") and name not in _NO_SCRIPTS)
        found.extend(os.path.join(directory, name) for name in sorted(files) if name != "setup.py")
    return found[:MOST_FILES]


def classify(path: str, marks: Marks = ROS1) -> str:
    """The kind of a program, or none: by what a binary is linked with, or what a script imports."""
    try:
        if not os.path.isfile(path) or not os.access(path, os.X_OK):
            return "none"
        with open(path, "rb") as file:
            head = file.read(4)
            if head == b"\x7fELF":
                return marks.binary if marks.library in _linked(path) else "none"
            text = (head + file.read(LARGEST_SCRIPT)).decode("utf-8", "replace")
    except OSError:
        return "none"
    if not text.startswith("#!") or "python" not in text.splitlines()[0]:
        return "none"
    return marks.script if _is_node(_relayed(text, path), marks) else "none"


def _linked(path: str) -> str:
    try:
        done = subprocess.run(["ldd", path], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=20)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.decode("utf-8", "replace")


def _relayed(text: str, path: str) -> List[str]:
    """The texts of what a script runs: the script itself, or the script behind one of catkin's devel space, or the package whose function
    one of setuptools calls.
    """
    target = re.search(r"python_script = '([^'\n]+)'", text)
    if target is not None:
        return [_text_of(target.group(1)) or text]
    entry = _ENTRY.search(text)
    if entry is not None:
        distribution, name = entry.groups()
        prefix = os.path.dirname(os.path.dirname(os.path.dirname(path)))
        for points in _entry_points(prefix, distribution):
            module = re.search(r"(?m)^\s*{}\s*=\s*([\w.]+)".format(re.escape(name)), _text_of(points))
            if module is not None:
                place = os.path.join(os.path.dirname(os.path.dirname(points)), *module.group(1).split("."))
                return _texts_beside(place)
    return [text]


_ENTRY = re.compile(r"(?m)^# EASY-INSTALL-ENTRY-SCRIPT: '([\w.-]+?)(?:==[^']*)?','console_scripts','([\w.-]+)'")
"""How setuptools marks a script that it writes for an entry point."""
_PYTHON_PLACES = ("lib/python3*/site-packages", "lib/python3*/dist-packages", "local/lib/python3*/dist-packages")
"""Where Python packages are below a prefix."""
MOST_MODULES = 50


def _entry_points(prefix: str, distribution: str) -> List[str]:
    wanted = re.sub(r"[-_.]+", "_", distribution).lower()
    found = []
    for place in _PYTHON_PLACES:
        for path in sorted(glob.glob(os.path.join(glob.escape(prefix), place, "*", "entry_points.txt"))):
            known = re.sub(r"[-_.]+", "_", os.path.basename(os.path.dirname(path)).partition("-")[0]).lower()
            if known in (wanted, wanted + "_egg_info") or known.startswith(wanted + "_dist"):
                found.append(path)
    return found


def _texts_beside(place: str) -> List[str]:
    """The module of an entry point, and those in its directory and below: nodes are often in another one of the same package."""
    texts = [_text_of(place + ".py") or _text_of(os.path.join(place, "__init__.py"))]
    beside = sorted(glob.glob(os.path.join(glob.escape(os.path.dirname(place)), "**", "*.py"), recursive=True))
    return texts + [_text_of(path) for path in beside[:MOST_MODULES]]


def _text_of(path: str) -> str:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read(LARGEST_SCRIPT)
    except OSError:
        return ""


def _is_node(texts: List[str], marks: Marks) -> bool:
    # One that only calls the main of a module of its own package is a node where that module is; where there is none, running it says so.
    return not any(texts) or any(_imports(text) & marks.modules or re.search(marks.word, text) for text in texts)


def _imports(text: str) -> Set[str]:
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return set(re.findall(r"^\s*(?:import|from)\s+(\w+)", text, re.MULTILINE))  # Python 2
    found: Set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found.update(alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module.split(".")[0])
    return found


def nodelets(package: str, shares: List[str], loader: Optional[str]) -> Iterator[Found]:
    """The nodelet classes that a package exports, each as a process of its own (``nodelet standalone``)."""
    manifest = next((path for path in (os.path.join(each, "package.xml") for each in shares) if os.path.isfile(path)), None)
    if manifest is None or loader is None:
        return
    seen = set()
    for plugins in _plugin_files(manifest):
        for name, kind in _classes(plugins):
            if kind in ("nodelet::Nodelet", "::nodelet::Nodelet") and name not in seen and _CLASS.fullmatch(name):
                seen.add(name)
                yield Found(package, name, "nodelet", [loader, "standalone", name], plugins)


def components(package: str, prefixes: List[str], loader: Optional[str]) -> Iterator[Found]:
    """The components that a package registers, each to be loaded into a container of its own (``loader``)."""
    if loader is None:
        return
    seen = set()
    for prefix in prefixes:
        listed = os.path.join(prefix, "share", "ament_index", "resource_index", "rclcpp_components", package)
        for line in _text_of(listed).splitlines():
            name, _, library = line.strip().partition(";")
            path = os.path.join(prefix, library)
            if _CLASS.fullmatch(name) and name not in seen:
                seen.add(name)
                yield Found(package, name, "component", [loader], path if library and os.path.isfile(path) else listed)


def _plugin_files(manifest: str) -> Iterator[str]:
    try:
        root = ElementTree.parse(manifest).getroot()
    except (ElementTree.ParseError, OSError):
        return
    for export in root.iter("nodelet"):
        path = (export.get("plugin") or "").replace("${prefix}", os.path.dirname(manifest))
        if path and os.path.isfile(path):
            yield path


def _classes(path: str) -> List[Tuple[str, str]]:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            text = re.sub(r"^\s*<\?xml[^>]*\?>", "", file.read(LARGEST_SCRIPT))
        root = ElementTree.fromstring("<all>{}</all>".format(text))
    except (ElementTree.ParseError, OSError):
        return []
    return [(each.get("name") or each.get("type") or "", each.get("base_class_type") or "") for each in root.iter("class")]


def fingerprint(found: Found, settings: Any) -> str:
    """Changes when the program, what it is started with, or the probe changes."""
    digest = hashlib.sha256(json.dumps([found.label, found.command, settings], sort_keys=True, default=str).encode("utf-8", "replace"))
    here = os.path.dirname(os.path.abspath(__file__))
    for path in [found.path, *sorted(os.path.join(here, name) for name in os.listdir(here) if name.endswith(".py"))]:
        try:
            with open(path, "rb") as file:
                digest.update(hashlib.sha256(file.read()).digest())
        except OSError:
            digest.update(b"?")
    return digest.hexdigest()[:32]


def digest(found: Found) -> str:
    """What a program is made from, as a sum: the same on every machine that has the same file."""
    try:
        with open(found.path, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()[:32]
    except OSError:
        return ""
