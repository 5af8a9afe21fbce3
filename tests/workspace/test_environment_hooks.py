"""Variables that the env-hooks of a workspace set."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.packages import Packages

Grow = Callable[[Mapping[str, str | None]], Path]

# Text of a hook → the variables it sets.
TEXTS = {
    "export ROBOT=one\n": ["ROBOT"],
    "  export ROBOT": ["ROBOT"],
    'if [ -z "$ROBOT" ]; then export ROBOT=one; fi': ["ROBOT"],
    "@[if DEVELSPACE]@\nexport MAPS=@(CMAKE_CURRENT_SOURCE_DIR)/maps\n@[else]@\nexport MAPS=x\n@[end if]": ["MAPS"],
    "setenv ROBOT one": ["ROBOT"],
    "set -gx ROBOT one": ["ROBOT"],
    "set ROBOT=one\r\n": ["ROBOT"],
    "set;ROBOT;one\nprepend-non-duplicate;MAPS;share": ["MAPS", "ROBOT"],
    "# export ROBOT=one\nrem set ROBOT=one": [],
    "set -e\nunset ROBOT\necho $ROBOT\nROBOT=one": [],
    "\0\xff": [],
}


@pytest.mark.parametrize("text", TEXTS)
def test_what_a_hook_sets(text: str, grow: Grow) -> None:
    root = grow({"p/package.xml": "package p", "p/env-hooks/50.p.sh.in": text})
    variables = Packages([str(root)], {}, explicit=True).hook_variables()
    assert dict(sorted(variables.items())) == dict.fromkeys(TEXTS[text], f"{root}/p/env-hooks/50.p.sh.in")


def test_where_hooks_are(grow: Grow) -> None:
    root = grow(
        {
            "p/package.xml": "package p",
            "p/CMakeLists.txt": "catkin_add_env_hooks(10.p\n SHELLS sh zsh\n DIRECTORY \"${CMAKE_CURRENT_SOURCE_DIR}/cmake/hooks\")\n"
            "catkin_add_env_hooks(20.p SHELLS bash)\ncatkin_add_env_hooks()\n# catkin_add_env_hooks(30.p SHELLS sh)\n",
            "p/cmake/hooks/10.p.sh": "export A=1", "p/cmake/hooks/11.p.sh": "export B=1", "p/20.p.bash.em": "export C=1",
            "p/30.p.sh": "export D=1", "p/scripts/setup.sh": "export E=1", "env-hooks/x.sh": "export F=1",
            "q/package.xml": "package q", "q/env_hooks/q.sh": "export G=1", "q/env-hooks": "export H=1",
        }
    )  # fmt: skip
    assert sorted(Packages([str(root)], {}, explicit=True).hook_variables()) == ["A", "C", "G"]
