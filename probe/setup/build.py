"""Builds the packages of a workspace one by one, each as far as it goes: ``build.py WORKSPACE``.

Sources are in ``WORKSPACE/src``. All results are, in ROS 1, in the devel space ``WORKSPACE/devel``, in ROS 2 in the install space
``WORKSPACE/install``. A package that cannot be configured or compiled does not stop the others; what went wrong is written to
``WORKSPACE/build.json``. Plain CMake and setuptools, since the tools of ROS stop at the first error, and not every image has them.
"""

import json
import os
import re
import signal
import subprocess
import sys
from typing import Dict, List, Set
from xml.etree import ElementTree

LONGEST = int(os.environ.get("LAUNCHLINT_BUILD_LIMIT", "900"))
"""Seconds for one package."""
KEPT = 4 * 1024 * 1024
"""Bytes of a build log that are looked at, from its end."""
MOST_ERRORS = 5
LAST_LINES = 12
"""Lines of a failed build that are shown."""
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_ERROR = re.compile(r"(?m)^.*(?:\berror\b ?:|CMake Error|\*\*\* \[|undefined reference|No such file|Could NOT find|Could not find).*$")
# Why a script that CMake calls has failed: what it raised, in two lines where the first ends with a colon. CMake only says that it has.
_RAISED = re.compile(r"(?m)^Traceback \(most recent call last\):\n(?:[ \t].*\n)+(\S.*(?:(?<=:)\n\S.*)?)$")
ROS2 = bool(os.environ.get("AMENT_PREFIX_PATH"))
_VERSION = re.compile(r"\$ROS_VERSION\s*==\s*\W?([12])\b")
_DEPENDS = {"depend", "build_depend", "build_export_depend", "buildtool_depend", "buildtool_export_depend", "exec_depend", "run_depend"}


class Package:
    """A source package: its directory, what it depends on, and its build type."""

    def __init__(self, name: str, directory: str, depends: Set[str], kind: str) -> None:
        self.name = name
        self.directory = directory
        self.depends = depends
        self.kind = kind


def packages(space: str) -> Dict[str, Package]:
    """The packages below a source space."""
    found: Dict[str, Package] = {}
    for directory, inner, files in os.walk(space):
        inner[:] = sorted(name for name in inner if not name.startswith("."))
        if "CATKIN_IGNORE" in files or (ROS2 and "COLCON_IGNORE" in files):
            inner[:] = []
        elif "package.xml" in files:
            inner[:] = []
            try:
                root = ElementTree.parse(os.path.join(directory, "package.xml")).getroot()
            except (ElementTree.ParseError, OSError, ValueError):
                continue
            name = (root.findtext("name") or "").strip()
            depends = {(each.text or "").strip() for each in root if each.tag in _DEPENDS and _applies(each)}
            kinds = [(each.text or "").strip() for each in root.iterfind("export/build_type") if _applies(each)]
            kind = kinds[0] if kinds else "catkin"
            if _NAME.fullmatch(name):
                found.setdefault(name, Package(name, directory, depends, kind))
    return found


def _applies(element: ElementTree.Element) -> bool:
    """Whether a tag of a manifest is for this version of ROS."""
    wanted = _VERSION.search(element.get("condition") or "")
    return wanted is None or (wanted.group(1) == "2") == ROS2


def ordered(known: Dict[str, Package]) -> List[str]:
    """The names of packages, each behind those it depends on; where they depend on each other in a circle, by name."""
    left = {name: package.depends & set(known) - {name} for name, package in known.items()}
    order: List[str] = []
    while left:
        free = sorted(name for name, needs in left.items() if not needs & set(left))
        for name in free or [sorted(left)[0]]:
            order.append(name)
            del left[name]
    return order


def build(package: Package, workspace: str, environment: Dict[str, str]) -> Dict[str, object]:
    """Configure and compile one package. Returns its record."""
    record: Dict[str, object] = {"kind": "build", "package": package.name, "result": "ok", "errors": []}
    if package.kind != "cmake" and package.kind.startswith("ament") != ROS2:
        return dict(record, result="failed", errors=["it is a package for ROS {}".format(1 if ROS2 else 2)])
    directory = os.path.join(workspace, "build", package.name)
    log = os.path.join(directory, "launchlint-build.log")
    if package.kind == "ament_python":
        os.makedirs(directory, exist_ok=True)
        if _run(_setuptools(package, workspace, directory), package.directory, log, environment):
            return record
        return dict(record, result="failed", errors=_errors(log, workspace), log=_last_lines(log, workspace))
    if not os.path.isfile(os.path.join(package.directory, "CMakeLists.txt")):
        return record
    os.makedirs(directory, exist_ok=True)
    if not _run(_cmake(package, workspace), directory, log, environment):
        return dict(record, result="failed", errors=_errors(log, workspace), log=_last_lines(log, workspace))
    made = _run(["make", "-k", "-j{}".format(os.cpu_count() or 1)], directory, log, environment)
    if not made:
        record = dict(record, result="partial", errors=_errors(log, workspace), log=_last_lines(log, workspace))
    if not made:
        _take_what_is_there(directory)
    if ROS2 and not _run(["cmake", "-P", "cmake_install.cmake"], directory, log, environment) and made:
        record = dict(record, result="partial", errors=_errors(log, workspace), log=_last_lines(log, workspace))
    return record


def _take_what_is_there(directory: str) -> None:
    """Have CMake install what was built, and go on where something was not."""
    for place, _, files in os.walk(directory):
        if "cmake_install.cmake" in files:
            path = os.path.join(place, "cmake_install.cmake")
            with open(path, encoding="utf-8") as file:
                text = file.read()
            with open(path, "w", encoding="utf-8") as file:
                file.write(re.sub(r"(file\(INSTALL DESTINATION \S+ TYPE \w+) (?=.*FILES)", r"\1 OPTIONAL ", text))


def _cmake(package: Package, workspace: str) -> List[str]:
    """The command that configures a package."""
    own = ["-DBUILD_TESTING=OFF"]
    if not ROS2:
        own = [
            "-DCATKIN_DEVEL_PREFIX=" + os.path.join(workspace, "devel"),
            "-DCATKIN_ENABLE_TESTING=0",
            "-DCATKIN_SKIP_TESTING=1",
        ]
    command = [
        "cmake",
        package.directory,
        *own,
        "-DCMAKE_INSTALL_PREFIX=" + os.path.join(workspace, "install"),
        "-DCMAKE_BUILD_TYPE=None",
        "-DCMAKE_CXX_FLAGS=-O0",
        "-DCMAKE_POLICY_VERSION_MINIMUM=3.5",
        "-Wno-dev",
    ]
    if os.environ.get("LAUNCHLINT_CXX"):
        command.append("-DCMAKE_CXX_COMPILER=" + os.environ["LAUNCHLINT_CXX"])
    return command


def _setuptools(package: Package, workspace: str, directory: str) -> List[str]:
    """The command that installs a package of Python, its programs where ROS 2 looks for them."""
    install = os.path.join(workspace, "install")
    return [
        "python3",
        "setup.py",
        "build",
        "--build-base",
        os.path.join(directory, "base"),
        "install",
        "--prefix",
        install,
        "--install-lib",
        python_directory(install),
        "--install-scripts",
        os.path.join(install, "lib", package.name),
        "--install-data",
        install,
        "--single-version-externally-managed",
        "--record",
        os.path.join(directory, "installed.txt"),
    ]


def python_directory(install: str) -> str:
    """Where Python packages are below an install space."""
    return os.path.join(install, "lib", "python{}.{}".format(*sys.version_info[:2]), "site-packages")


def _run(command: List[str], directory: str, log: str, environment: Dict[str, str]) -> bool:
    """Run a command, output to the end of ``log``; whether it ended well and in time."""
    with open(log, "ab") as output:
        process = subprocess.Popen(
            command,
            cwd=directory,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            return process.wait(LONGEST) == 0
        except subprocess.TimeoutExpired:
            output.write("\nerror: stopped after {} seconds\n".format(LONGEST).encode())
            return False
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except OSError:
                pass
            process.wait()


def _errors(log: str, workspace: str) -> List[str]:
    text = _end_of(log)
    text = re.sub(r"(CMake Error at [^\n]*):\n\s*\n?([^\n]*)", r"\1: \2", text[:KEPT])  # CMake says what is wrong below where it is
    lines = list(dict.fromkeys(" ".join(found.split())[:300] for found in (*_RAISED.findall(text), *_ERROR.findall(text))))
    if not lines:
        lines = [line.strip()[:300] for line in text.splitlines() if line.strip()][-1:] or ["it failed without a word"]
    return [_harmless(line, workspace) for line in lines[:MOST_ERRORS]]


def _last_lines(log: str, workspace: str) -> List[str]:
    """The end of what the build said, for people."""
    lines = [line.rstrip()[:200] for line in _end_of(log).splitlines() if line.strip()]
    return [_harmless(line, workspace) for line in lines[-LAST_LINES:]]


def _end_of(log: str) -> str:
    with open(log, "rb") as file:
        file.seek(0, os.SEEK_END)
        file.seek(max(0, file.tell() - KEPT))
        return file.read().decode("utf-8", "replace")


def _harmless(line: str, workspace: str) -> str:
    """A line without the place of the workspace, and without what a terminal obeys."""
    inside = r"(?<![\w./-])" + re.escape(workspace) + "/"
    return "".join(each if each.isprintable() else " " for each in re.sub(inside, "", line))


def _environment(workspace: str) -> Dict[str, str]:
    """As after sourcing the workspace's setup file, which does not exist before the first package is built."""
    if ROS2:
        install = os.path.join(workspace, "install")
        ahead = {
            "AMENT_PREFIX_PATH": [install],
            "CMAKE_PREFIX_PATH": [install],
            "PYTHONPATH": [
                python_directory(install),
                os.path.join(install, "local", "lib", "python{}.{}".format(*sys.version_info[:2]), "dist-packages"),
            ],
            "LD_LIBRARY_PATH": [os.path.join(install, "lib")],
            "PATH": [os.path.join(install, "bin")],
        }
    else:
        devel = os.path.join(workspace, "devel")
        ahead = {
            "CMAKE_PREFIX_PATH": [devel],
            "PYTHONPATH": [
                os.path.join(devel, "lib", "python3", "dist-packages"),
                os.path.join(devel, "lib", "python2.7", "dist-packages"),
            ],
            "PKG_CONFIG_PATH": [os.path.join(devel, "lib", "pkgconfig")],
            "LD_LIBRARY_PATH": [os.path.join(devel, "lib")],
            "ROS_PACKAGE_PATH": [os.path.join(workspace, "src")],
            "PATH": [os.path.join(devel, "bin")],
        }
    environment = dict(os.environ)
    for name, paths in ahead.items():
        environment[name] = os.pathsep.join(paths + [each for each in [environment.get(name, "")] if each])
    return environment


def main() -> int:
    """Build everything, say how it went."""
    workspace = os.path.abspath(sys.argv[1])
    known = packages(os.path.join(workspace, "src"))
    environment = _environment(workspace)
    if ROS2:
        os.makedirs(python_directory(os.path.join(workspace, "install")), exist_ok=True)
    records: List[Dict[str, object]] = []
    order = ordered(known)
    for number, name in enumerate(order, 1):
        record = build(known[name], workspace, environment)
        records.append(record)
        print("[{}/{}] {}: {}".format(number, len(order), name, record["result"]), flush=True)
        with open(os.path.join(workspace, "build.json"), "w") as file:
            json.dump(records, file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
