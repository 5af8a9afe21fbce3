"""Installs what the packages of a workspace say they need, as far as apt has it: ``dependencies.py MANIFESTS APT REPORT``.

``APT`` is a file with the names of further apt packages, one in a line; the report is a list of records as JSON.

Run while the image is built, as root. A manifest names ROS packages and rosdep keys; without a network of its own rosdep cannot be
asked, so
names are looked up in apt by the rules of the two worlds: ``ros-DISTRO-name`` where ROS comes from packages.ros.org, ``libname-dev``,
``python3-name`` and others where it is Debian's. What is not found is reported, never fatal.
"""

import glob
import json
import os
import re
import subprocess
import sys
from typing import Dict, Iterable, List, Set
from xml.etree import ElementTree

KEYS = {
    "boost": "libboost-all-dev",
    "eigen": "libeigen3-dev",
    "Eigen3": "libeigen3-dev",
    "opencv3": "libopencv-dev",
    "opencv": "libopencv-dev",
    "libopencv": "libopencv-dev",
    "python-numpy": "python3-numpy",
    "numpy": "python3-numpy",
    "python-yaml": "python3-yaml",
    "python-serial": "python3-serial",
    "python-scipy": "python3-scipy",
    "python-opencv": "python3-opencv",
    "yaml-cpp": "libyaml-cpp-dev",
    "tinyxml": "libtinyxml-dev",
    "tinyxml2": "libtinyxml2-dev",
    "qtbase5-dev": "qtbase5-dev",
    "libqt5-core": "libqt5core5a",
    "libqt5-gui": "libqt5gui5",
    "pcl": "libpcl-dev",
    "libpcl-all": "libpcl-dev",
    "libpcl-all-dev": "libpcl-dev",
    "bullet": "libbullet-dev",
    "sdl": "libsdl1.2-dev",
    "curl": "libcurl4-openssl-dev",
    "libcurl": "libcurl4-openssl-dev",
    "protobuf": "libprotobuf-dev",
    "protobuf-dev": "libprotobuf-dev",
    "assimp": "libassimp-dev",
    "assimp-dev": "libassimp-dev",
    "fcl": "libfcl-dev",
    "orocos_kdl": "liborocos-kdl-dev",
    "pkg-config": "pkg-config",
    "libusb": "libusb-0.1-4",
    "libusb-dev": "libusb-dev",
    "libusb-1.0-dev": "libusb-1.0-0-dev",
    "glut": "freeglut3-dev",
    "opengl": "libgl1-mesa-dev",
    "cmake_modules": "ros-cmake-modules",
    "urdfdom_headers": "liburdfdom-headers-dev",
    "console_bridge": "libconsole-bridge-dev",
    "class_loader": "libclass-loader-dev",
    "pluginlib": "pluginlib-dev",
    "catkin": "catkin",
    "filters": "libfilters-dev",
    "rosunit": "python3-rosunit",
    "python3-catkin-pkg-modules": "python3-catkin-pkg",
}
"""Names that no rule leads to the right package."""
ALSO = {
    "actionlib": ("libactionlib-dev", "python3-actionlib"),
    "message_generation": (
        "ros-message-generation",
        "python3-genmsg",
        "python3-genpy",
        "libgencpp-dev",
        "gencpp",
        "genlisp",
        "geneus",
        "gennodejs",
    ),
    "nodelet": ("libnodelet-dev", "libnodeletlib-dev", "libnodeletlib-tools"),
    "roslaunch": ("python3-roslaunch", "libroslaunch-dev"),
    "rospy": ("python3-rospy",),
    "roscpp_core": ("libroscpp-core-dev",),
    "roscpp_serialization": ("libroscpp-core-dev",),
    "roscpp_traits": ("libroscpp-core-dev",),
    "rostime": ("libroscpp-core-dev",),
    "cpp_common": ("libroscpp-core-dev",),
    "rosconsole": ("librosconsole-dev", "python3-rosconsole"),
    "topic_tools": ("topic-tools", "libtopic-tools-dev"),
}
"""Names that stand for several packages, installed where they exist."""
NOT_NEEDED = {"roslint", "python", "python3", "python-dev", "cmake", "git", "gcc", "g++", "make"}
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.+-]*")
_DEPENDS = {"depend", "build_depend", "build_export_depend", "buildtool_depend", "buildtool_export_depend", "exec_depend", "run_depend"}


def needed(directory: str) -> Dict[str, List[str]]:
    """What the manifests below ``directory`` need and do not bring themselves → the packages that need it."""
    own: Set[str] = set()
    wanted: Dict[str, List[str]] = {}
    for path in sorted(glob.glob(os.path.join(directory, "**", "package.xml"), recursive=True)):
        try:
            root = ElementTree.parse(path).getroot()
        except (ElementTree.ParseError, OSError, ValueError):
            continue
        package = (root.findtext("name") or "").strip()
        own.add(package)
        for element in root:
            name = (element.text or "").strip()
            if element.tag in _DEPENDS and _NAME.fullmatch(name):
                wanted.setdefault(name, []).append(package)
    return {
        name: sorted(set(by)) for name, by in sorted(wanted.items()) if name not in own and name not in NOT_NEEDED and not is_here(name)
    }


def is_here(name: str) -> bool:
    """Whether an installation below ``/opt`` has a ROS package."""
    return any(
        glob.glob(os.path.join(place, "share", name, "package.xml")) for place in ("/opt/ros/*", "/opt/ros/*/install", "/opt/*/install")
    )


def packages_for(name: str, known: Set[str], distro: str) -> List[str]:
    """The apt packages that stand for a ROS package or rosdep key; empty where there are none."""
    dashed = name.lower().replace("_", "-")
    if distro:
        candidates: Iterable[str] = ("ros-{}-{}".format(distro, dashed),)
        found = [each for each in candidates if each in known]
        if found:
            return found
    else:
        several = [each for each in ALSO.get(name, ()) if each in known]
        if several:
            return several
        if name not in KEYS and "-" not in name:
            rules = ("lib{}-dev".format(dashed), "python3-{}".format(dashed), "ros-{}".format(dashed), "{}-tools".format(dashed))
            found = [each for each in rules if each in known]
            if found:
                return found
    for each in (KEYS.get(name, ""), name, dashed, "python3-" + re.sub("^python3?-", "", dashed), "lib{}-dev".format(dashed)):
        if each in known:
            return [each]
    return []


def _apt(*words: str) -> int:
    return subprocess.call(["apt-get", "-qy"] + list(words), env=dict(os.environ, DEBIAN_FRONTEND="noninteractive"))


def _install(packages: List[str]) -> List[str]:
    """Install packages, together if that goes, else one by one. Returns those that cannot be installed."""
    if not packages or _apt("install", "--no-install-recommends", "--", *packages) == 0:
        return []
    return [package for package in packages if _apt("install", "--no-install-recommends", "--", package) != 0]


def main() -> int:
    """Look up, install, write the report: a list of records."""
    manifests, extra, report = sys.argv[1:4]
    with open(extra) as file:
        asked = file.read().split()
    distros = sorted(os.path.basename(os.path.dirname(path)) for path in glob.glob("/opt/ros/*/setup.sh"))
    wanted = needed(manifests)
    records = []
    if wanted or asked:
        _apt("update")
        listed = subprocess.run(["apt-cache", "pkgnames"], stdout=subprocess.PIPE)
        known = set(listed.stdout.decode("utf-8", "replace").split())
        chosen = {name: packages_for(name, known, distros[-1] if distros else "") for name in wanted}
        failed = set(_install(sorted({package for found in chosen.values() for package in found} | set(asked))))
        for name, found in chosen.items():
            if not found or failed.intersection(found):
                why = (
                    "apt has no package for it"
                    if not found
                    else "apt could not install {}".format(", ".join(sorted(failed.intersection(found))))
                )
                records.append({"kind": "dependency", "name": name, "needed_by": wanted[name], "detail": why})
        detail = "apt could not install it"
        records.extend({"kind": "dependency", "name": each, "needed_by": ["apt"], "detail": detail} for each in asked if each in failed)
        _apt("clean")
    with open(report, "w") as file:
        json.dump(records, file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
