"""The peer of the comparison: what the real roslaunch makes of launch files, as JSON.

Run with a Python that has roslaunch. Standard input is a JSON list of ``{"file", "args", "environment", "packages", "directory"}``;
standard output one
JSON object per job, in order, with the keys of ``launchlint model``. No master is asked, nothing is started, no command of a param is run,
``$(anon)`` gives numbered names, and an ``$(eval)`` that names a builtin with effects is refused. Every job has a process of its own.
"""

from __future__ import annotations

import ast
import builtins
import hashlib
import io
import json
import os
import re
import resource
import shlex
import sys
from itertools import count

import rosgraph.names
import rosgraph.network
import roslaunch.config
import roslaunch.core
import roslaunch.loader
import roslaunch.substitution_args
import roslaunch.xmlloader
import rospkg

PLAIN = {"abs", "bool", "dict", "eval", "float", "int", "len", "list", "max", "min", "range", "round", "sorted", "str", "sum", "tuple"}
TYPES = {"auto", "str", "string", "int", "double", "bool", "boolean", "yaml"}
MEMORY, SECONDS = 1 << 29, 8
"""Bytes and processor seconds after which a job ends: a file that includes itself twice would go on for ever."""
FIELDS = ("output", "respawn", "respawn_delay", "required", "cwd", "launch_prefix")

real_eval = roslaunch.substitution_args._eval
real_param_value = roslaunch.loader.Loader.param_value
real_include_args = roslaunch.loader.process_include_args


class Command(str):
    """Stands for the output of a command that is not run."""


def guarded_eval(text, context):
    """Refuse an expression that names a builtin with effects."""
    try:
        names = {node.id for node in ast.walk(ast.parse(text.strip(), mode="eval")) if isinstance(node, ast.Name)}
    except SyntaxError:
        names = set()
    known = set(roslaunch.substitution_args._eval_dict) | set(context.get("arg", {}))
    reached = {name for name in names if hasattr(builtins, name)} - PLAIN - known
    if reached:
        raise roslaunch.substitution_args.SubstitutionException(f"not evaluated here: {sorted(reached)}")
    return real_eval(text, context)


def param_value(self, verbose, name, ptype, value, textfile, binfile, command):
    """Read the value of a param as roslaunch does; of a command only what is wrong before and after it is run."""
    if value is None and textfile is None and binfile is None:
        if not shlex.split(command):
            raise IndexError("no command to run")
        if ptype not in TYPES:
            raise ValueError(f"Unknown type {ptype}")
        return Command(command)
    return real_param_value(self, verbose, name, ptype, value, textfile, binfile, command)


def prepare(job, includes):
    """Make roslaunch deterministic and harmless, in the environment of the job."""
    os.environ.clear()
    os.environ.update(job["environment"])
    os.chdir(job["directory"])
    roslaunch.substitution_args._eval = guarded_eval
    roslaunch.substitution_args._rospack = rospkg.RosPack([job["packages"]])
    roslaunch.loader.Loader.param_value = param_value
    roslaunch.config.is_machine_local = lambda machine: True
    rosgraph.network.get_local_address = lambda *_: "127.0.0.1"
    numbers = count(1)
    rosgraph.names.anonymous_name = lambda name: re.sub(r"[.\-:]", "_", f"{name}_anon{next(numbers)}")

    def include_args(context):
        real_include_args(context)
        arguments = dict(sorted(context.resolve_dict.get("arg", {}).items()))
        includes.append({"file": context.filename, "ns": context.ns, "args": arguments})

    roslaunch.loader.process_include_args = include_args


def load(job):
    """The answer for one file; any exception of roslaunch means that it refuses it."""
    includes = []
    prepare(job, includes)
    config = roslaunch.config.ROSLaunchConfig()
    core = roslaunch.xmlloader.XmlLoader()
    core.ignore_unset_args = False
    roslaunch.config.load_roscore(core, config, verbose=False)
    core_parameters, core_files = dict(config.params), len(config.roslaunch_files)
    loader = roslaunch.xmlloader.XmlLoader()
    loader.ignore_unset_args = False
    words = [f"{name}:={value}" for name, value in job["args"].items()]
    try:
        loader.load(job["file"], config, argv=["roslaunch", job["file"], *words], verbose=False)
        config.assign_machines()
        for node in config.nodes + config.tests:
            shlex.split(node.args)
            shlex.split(node.launch_prefix or "")
    except Exception as error:
        return {"verdict": "error", "reason": f"{type(error).__name__}: {error}"[:400]}
    return {
        "verdict": "ok",
        "nodes": [as_node(node) for node in config.nodes],
        "tests": [
            {**as_node(test), "test_name": test.test_name, "time_limit": test.time_limit, "retry": test.retry} for test in config.tests
        ],
        "params": {name: as_value(p.value) for name, p in config.params.items() if core_parameters.get(name) is not p},
        "clear_params": config.clear_params,
        "machines": {name: as_machine(machine) for name, machine in config.machines.items() if name},
        "executables": [" ".join(["ros/bin/rosparam", *(each for each in step.args if each is not None)]) for step in config.executables],
        "files": config.roslaunch_files[core_files:],
        "includes": includes,
    }


def as_node(node):
    """A node with the keys of the model."""
    return {
        "name": node.name,
        "ns": node.namespace,
        "fqn": rosgraph.names.ns_join(node.namespace, node.name) if node.name else None,
        "pkg": node.package,
        "type": node.type,
        "machine": node.machine_name,
        "args": node.args,
        "remaps": [list(pair) for pair in node.remap_args],
        "env": [list(pair) for pair in node.env_args],
        **{field: getattr(node, field) for field in FIELDS},
        "file": node.filename,
    }


def as_machine(machine):
    """A machine with the keys of the model."""
    fields = ("address", "assignable", "env_loader", "ssh_port", "timeout", "user")
    return {**{field: getattr(machine, field) for field in fields}, "password": machine.password is not None}


def as_value(value):
    """A parameter value with its type, as JSON can hold it."""
    if isinstance(value, Command):
        return {"type": "command", "value": str(value)}
    value = getattr(value, "data", value)
    if isinstance(value, bytes):
        return {"type": "binary", "sha1": hashlib.sha1(value).hexdigest(), "len": len(value)}
    words = {bool: "bool", int: "int", float: "double", str: "str", type(None): "null", dict: "dict", list: "list", tuple: "list"}
    if type(value) not in words:
        return {"type": type(value).__name__, "value": str(value)}
    if isinstance(value, dict):
        value = {str(key): item for key, item in value.items()}
    if isinstance(value, float) and (value != value or abs(value) == float("inf")):
        return {"type": "double", "value": repr(value)}
    if isinstance(value, (dict, list, tuple)):
        return {"type": words[type(value)], "value": json.loads(re.sub(r"\b(NaN|-?Infinity)\b", r'"\1"', json.dumps(value, default=str)))}
    return {"type": words[type(value)], "value": value}


def in_own_process(job):
    """The answer for ``job``, found in a forked process, so that no job changes the next one."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read)
        answer = {"verdict": "error"}
        sys.stdout, sys.stderr = io.StringIO(), io.StringIO()
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        try:
            answer = load(job)
        except BaseException as error:
            answer["reason"] = f"{type(error).__name__}: {error}"
        with os.fdopen(write, "wb") as pipe:
            pipe.write(json.dumps(answer).encode("utf-8", "surrogateescape"))
        os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    return text.decode("utf-8") or json.dumps({"verdict": "error", "reason": "roslaunch does not end: it was stopped"})


def main():
    """Answer every job on standard input."""
    for job in json.load(sys.stdin):
        print(in_own_process(job), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
