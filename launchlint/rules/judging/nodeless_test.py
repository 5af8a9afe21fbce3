"""Programs of tests that only ask functions something: they make no node, so that nobody bears the name that rostest gives them."""

from __future__ import annotations

from launchlint.rules.judging.package_contents import contents
from launchlint.rules.view import LaunchView
from launchlint.workspace.looking import content

_MAKE_A_NODE = (b"init_node", b"roscpp_init")
"""What makes a node in Python: rospy.init_node, or what does so in its place (moveit_commander.roscpp_initialize)."""


def makes_no_node(package: str, name: str, view: LaunchView) -> bool:
    """Whether the program ``name`` of ``package`` is a script in Python of the workspace in which nothing makes a node."""
    found = view.packages.get(package, view.launch.entry.file)
    program = None if found is None else contents(view.packages).executables(found).by_name.get(name)
    text = None if program is None or program.path is None else content(program.path)
    if text is None or not (name.endswith(".py") or b"python" in text.partition(b"\n")[0]):
        return False
    return not any(word in text for word in _MAKE_A_NODE)
