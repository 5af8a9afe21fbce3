"""What the real front ends said of small files: where launchlint's refuse one, launch does, and where launch reads all, they do."""

from __future__ import annotations

import json
import lzma
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from launchlint.syntax.ros2.reading import read

# What launch notices only when it executes a file that it has read to the end.
LATER = {
    *("condition", "env", "include_missing_arg", "missing_file", "package", "var_undefined", "recursion", "required_arg", "choice"),
    *("node_name", "namespace", "param_type", "SubstitutionFailure", "output"),
}
READ_WHILE_EXECUTED = (
    "paramfile_",
    "param_subst_",
    "param_type_subst_",
    "param_set_parameters_",
    "param_from_",
    "subst_eval_",
    "scope_include_",
)
# Rolling was recorded with launch 3.7.1 (December 2024); these are read by launch 3.8, with which loops came to Kilted and Rolling.
SINCE_THEN = {"rolling": {"subst_index_new"}}
ONLY_THEN = {"node_respawn_1", "node_respawn_bad", "subst_not_word", "subst_not_1", "subst_param_none", "tag_set_use_sim_time"}


@pytest.fixture(scope="module")
def oracle() -> Path:
    directory = Path(os.environ.get("LAUNCHLINT_ORACLE", ""), "ros2")
    if not (directory / "make_cases.py").is_file():
        pytest.skip("LAUNCHLINT_ORACLE does not name a directory with recorded answers")
    return directory


@pytest.fixture(scope="module")
def cases(oracle: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("cases")
    subprocess.run([sys.executable, str(oracle / "make_cases.py"), str(directory)], check=True, capture_output=True)
    return directory


def answers(oracle: Path, distro: str) -> Iterator[dict[str, Any]]:
    found: dict[tuple[str, str], dict[str, Any]] = {}
    for each in dict.fromkeys(("jazzy", distro)):
        with lzma.open(oracle / f"cases.{each}.jsonl.xz", "rt", encoding="utf-8") as lines:
            for line in lines:
                answer = json.loads(line)
                found[answer["file"], str(answer.get("given_args"))] = answer
    return (answer for (file, _), answer in found.items() if not file.endswith(".py"))


@pytest.mark.parametrize("distro", ["humble", "jazzy", "rolling"])
def test_refusals_are_those_of_launch(oracle: Path, cases: Path, distro: str) -> None:
    different: list[str] = []
    refused = 0
    for answer in answers(oracle, distro):
        case = answer["file"].split("/")[0]
        if case in SINCE_THEN.get(distro, ()):
            continue
        refusal = read((cases / answer["file"]).read_bytes(), answer["file"], distro=distro).refusal
        error = answer.get("error")
        later = error is not None and (
            error["kind"] in LATER or error["file"] != answer["file"] or case in ONLY_THEN or case.startswith(READ_WHILE_EXECUTED)
        )
        refused += refusal is not None
        if refusal is None and error is not None and not later:
            different.append(f"{case}: launch says {error['message']}")
        if refusal is not None and (error is None or error["kind"] in LATER):
            different.append(f"{case}: {refusal.kind}, launch {error}")
    assert refused > 100
    assert not different
