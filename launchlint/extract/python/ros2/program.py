"""One Python program of ROS 2: a script, or a function of a module that an entry point names."""

from __future__ import annotations

import os

from launchlint.extract.python.modules import PackageModules
from launchlint.extract.python.program import Extracted, followed
from launchlint.extract.python.ros2.run import Ros2Run


def rclpy_program(path: str, root: str, package: str, finder: PackageModules, entry: str = "") -> Extracted:
    """Follow the program at ``path``. Nothing is run or imported.

    Args:
        path: the file.
        root: the directory that paths of facts are relative to.
        package: directory of the package it is of; empty where it is of none.
        finder: where its modules are looked for.
        entry: ``module:function`` of an entry point, which is called once the module at ``path`` is imported; empty for a script.

    Raises:
        SourceError: the file itself is not Python, or cannot be read.
    """
    # The modules beside a script can be imported by it, those beside the module of an entry point cannot: it is installed elsewhere.
    beside = os.path.join(package, "lib", "programs") if entry and package else os.path.dirname(path)
    run = Ros2Run(root, package, finder, beside)
    return followed(run, path, entry)
