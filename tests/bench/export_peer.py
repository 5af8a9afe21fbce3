"""The peer of the export measurement: the real roslaunch loads each original and what was exported of it, and compares.

Run with a Python that has roslaunch: ``export_peer.py DIRECTORY RESULT < PAIRS``. PAIRS is a JSON list of ``{original, exported, given,
given_exported}``, the last two being words like ``sim:=true``. RESULT becomes a list in this order of ``{"loads": BOOL, "difference":
TEXT}``: whether roslaunch loads the original (if not, why), and what differs. Nothing is started, and no command of a param is run.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

import rosgraph.names
import roslaunch.config
import roslaunch.substitution_args
import rospkg
from roslaunch_peer import guarded_eval  # noqa: F401  (importing it guards roslaunch)

PARTS = ("nodes", "tests", "params", "machines", "clear_params", "executables")


def packages_below(directory):
    """Name of a package: all its directories."""
    found = {}
    for parent, folders, files in os.walk(directory):
        folders.sort()
        if "package.xml" in files:
            try:
                name = ElementTree.parse(os.path.join(parent, "package.xml")).getroot().findtext("name")
            except ElementTree.ParseError:
                name = None
            found.setdefault((name or "").strip(), []).append(parent)
            folders.clear()
        elif "manifest.xml" in files:
            found.setdefault(os.path.basename(parent), []).append(parent)
            folders.clear()
    return found


class Packages(rospkg.RosPack):
    """As rospkg, but of several packages of one name the one nearest to the file that is loaded, and a broken one breaks nothing else."""

    def __init__(self, directory):
        super().__init__([directory])
        self.known = packages_below(directory)
        self.near = directory

    def get_path(self, name):
        """Directory of the package."""
        if name not in self.known:
            raise rospkg.ResourceNotFound(name)
        return max(self.known[name], key=lambda directory: len(os.path.commonpath((directory, self.near))))

    def list(self):
        """All names."""
        return sorted(self.known)


def loaded(file, given):
    """What roslaunch would start, as plain values."""
    made = []

    def anonymous(name):
        made.append(name)
        return re.sub("[.:-]", "_", f"{name}_anon{len(made)}")

    rosgraph.names.anonymous_name = anonymous
    config = roslaunch.config.load_config_default([(file, given)], None, verbose=False, assign_machines=False)
    core = roslaunch.config.load_config_default([], None, verbose=False, assign_machines=False).params
    return {
        "nodes": [node(each) for each in config.nodes],
        "tests": [[*node(each), each.test_name, each.time_limit, each.retry] for each in config.tests],
        "params": {name: repr(getattr(param.value, "data", param.value)) for name, param in config.params.items() if name not in core},
        "machines": {name: [each.address, each.env_loader, each.ssh_port, each.user, each.password, each.assignable, each.timeout]
                     for name, each in config.machines.items()},
        "clear_params": list(config.clear_params),
        "executables": [str(each).rstrip("/") for each in config.executables],
    }  # fmt: skip


def node(each):
    """All that is said of a node."""
    return [each.namespace, each.name, each.package, each.type, each.machine_name, each.args, each.remap_args, each.env_args, each.output,
            each.respawn, each.respawn_delay, each.required, each.cwd, each.launch_prefix]  # fmt: skip


def renumbered(value):
    """``value`` as text, with anonymous names numbered as they come."""
    numbers = {}
    text = json.dumps(value, sort_keys=True, default=str)
    return re.sub(r"_anon(\d+)", lambda match: f"_anon#{numbers.setdefault(match[1], len(numbers) + 1)}", text)


def compared(pair):
    """Whether roslaunch loads the original, and what differs."""
    try:
        before = loaded(pair["original"], pair["given"])
    except Exception as error:  # roslaunch refuses it, in one of many ways
        return {"loads": False, "difference": f"roslaunch refuses the original: {error}"}
    try:
        after = loaded(pair["exported"], pair["given_exported"])
    except Exception as error:
        return {"loads": True, "difference": f"roslaunch refuses what was exported: {error}"}
    differing = [part for part in PARTS if before[part] != after[part] and renumbered(before[part]) != renumbered(after[part])]
    return {"loads": True, "difference": ", ".join(differing)}


def main():
    """Compare all pairs of standard input; write the result; return the exit status."""
    packages = Packages(os.path.abspath(sys.argv[1]))
    roslaunch.substitution_args._rospack = packages
    roslaunch.substitution_args._find_executable = lambda *_, **__: None
    results = []
    with open(os.devnull, "w") as nowhere, contextlib.redirect_stderr(nowhere):
        for pair in json.load(sys.stdin):
            packages.near = pair["original"]
            results.append(compared(pair))
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump(results, file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
