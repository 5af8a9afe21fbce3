"""Which refusals cannot be due to an empty default, from the texts alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.check.empty_reach import may_be_caused
from launchlint.evaluate.ros1.launch import evaluate
from launchlint.evaluate.session import Session
from launchlint.workspace.packages import Packages

EMPTY = '<arg name="e" default=""/>'
MISSING = '<param name="p" value="$(find no_such_package)"/>'


@pytest.mark.parametrize(
    ("text", "may"),
    [
        pytest.param(MISSING, False, id="elsewhere"),
        pytest.param('<param name="p" value="$(find no_such_package)/$(arg e)"/>', False, id="beside it in a text"),
        pytest.param('<group ns="a$(arg e)">' + MISSING + "</group>", False, id="in a namespace"),
        pytest.param("""<param name="p" value="$(eval find('no_such_package') + e)"/>""", True, id="in an expression"),
        pytest.param("""<group if="$(eval e != 'x')">""" + MISSING + "</group>", True, id="under a condition"),
        pytest.param(
            """<arg name="f" value="$(eval e != 'x')"/><group if="$(arg f)">""" + MISSING + "</group>", True, id="under an arg of it"
        ),
        pytest.param("""<group if="$(eval arg('e') == '')">""" + MISSING + "</group>", True, id="asked for as a text"),
        pytest.param("""<group if="$(eval arg('' + 'e') == '')">""" + MISSING + "</group>", True, id="under a name that is made"),
        pytest.param("""<arg name="f" value="$(eval arg('' + 'e'))"/>""" + MISSING, True, id="a name that is made, for an arg"),
        pytest.param('<include file="$(arg e)"/>', True, id="another kind of problem"),
        pytest.param('<arg name="r"/><param name="p" value="$(arg r)"/>', False, id="a required arg"),
        pytest.param("""<arg name="r"/><param name="p" value="$(eval e + r)"/>""", True, id="a required arg beside it"),
    ],
)
def test_what_an_empty_default_may_cause(text: str, may: bool, tmp_path: Path) -> None:
    file = tmp_path / "main.launch"
    file.write_text(f"<launch>{EMPTY}{text}</launch>", encoding="utf-8")
    session = Session(Packages([str(tmp_path)], {}, explicit=True), {}, str(tmp_path))
    evaluation = evaluate(session, str(file))
    assert evaluation.launch.refused is not None
    assert may_be_caused(session, evaluation, {"e"}) is may
