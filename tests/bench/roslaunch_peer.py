"""The peer of the corpus measurement: the real roslaunch loads many files in one process.

Run with a Python that has roslaunch: ``roslaunch_peer.py RESULT < FILES`` (one path per line). Nothing is started: commands of params are
not run, no machine is looked up, and an ``$(eval …)`` that reaches for anything but plain functions is refused. The result is one JSON
object.
"""

from __future__ import annotations

import ast
import builtins
import contextlib
import io
import json
import sys
import time

begin = time.perf_counter()

import roslaunch.config  # noqa: E402  (the time this import takes is part of the measurement)
import roslaunch.loader  # noqa: E402
import roslaunch.substitution_args  # noqa: E402

PLAIN = {"abs", "bool", "float", "int", "len", "list", "max", "min", "range", "round", "sorted", "str", "sum", "tuple"}

real_eval = roslaunch.substitution_args._eval
real_param_value = roslaunch.loader.Loader.param_value


def guarded_eval(text, context):
    """Refuse an expression that names a builtin with effects."""
    names = {node.id for node in ast.walk(ast.parse(text.strip(), mode="eval")) if isinstance(node, ast.Name)}
    reached = {name for name in names if hasattr(builtins, name)} - PLAIN - set(roslaunch.substitution_args._eval_dict)
    if reached:
        raise roslaunch.substitution_args.SubstitutionException(f"not evaluated here: {sorted(reached)}")
    return real_eval(text, context)


def param_value(self, verbose, name, ptype, value, textfile, binfile, command):
    """Read the value of a param as roslaunch does, but run no command."""
    if command is not None:
        return command
    return real_param_value(self, verbose, name, ptype, value, textfile, binfile, command)


roslaunch.substitution_args._eval = guarded_eval
roslaunch.loader.Loader.param_value = param_value
roslaunch.config.is_machine_local = lambda machine: True


def main():
    """Load every file named on standard input; write the result; return the exit status."""
    files = sys.stdin.read().split("\n")
    imported = time.perf_counter()
    loaded = 0
    for file in filter(None, files):
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            try:
                roslaunch.config.load_config_default([file], None, verbose=False)
                loaded += 1
            except Exception:  # a refused file costs time too, whatever its error
                continue
    end = time.perf_counter()
    with open(sys.argv[1], "w", encoding="utf-8") as result:
        json.dump({"loaded": loaded, "import": imported - begin, "load": end - imported}, result)
    return 0


if __name__ == "__main__":
    sys.exit(main())
