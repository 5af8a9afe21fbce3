"""What three rules tell of from three sides: an include and the file it includes do not agree about an arg."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint.spelling import closest

_SOME, _MOST = 2, 30
"""Args by which copies of a launch file are recognised."""


def broken_call(target: str, name: str, known: Sequence[str] = ()) -> str:
    """The cause that LL403, LL404 and LL407 share: the arg ``name`` of the launch file ``target``, and not who gets it wrong.

    Of args that are passed and not declared it is all that one include passes (``a, b``): roslaunch refuses them together, and callers
    that are copies of each other pass the same. Targets that declare the same two or more args (``known``) are taken for copies of each
    other as well, of which there is one for each robot.
    """
    return f"call {','.join(sorted(known)) if _SOME <= len(known) <= _MOST else target} {name}"


def lacking_call(target: str) -> str:
    """The cause of includes that do not pass what ``target`` needs: it has no default for that, whoever leaves out which."""
    return broken_call(target, "not passed")


def undeclared_call(target: str, names: Sequence[str], known: Sequence[str]) -> str:
    """The cause of includes that pass ``names``, which ``target`` does not declare: it lost them, or never had them, whoever passes which.

    A name that is a slip of one that it declares is a mistake of who passes it.
    """
    slips = any(closest(name, known) is not None for name in names)
    return broken_call(target, ", ".join(names) if slips else "undeclared", known)


MOVE = "move "
"""How the help begins where the included file declares the arg, but in a group or under a condition.

Not *declare it there*: where the other declaration counts too, roslaunch refuses the file (roslaunch.loader, ``add_arg``).
"""
