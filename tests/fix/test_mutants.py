"""Files with one mistake each, repaired: nothing new is found in them, and roslaunch starts what it did before the mistake was made.

``LAUNCHLINT_CORPUS`` names the unpacked files, ``LAUNCHLINT_ORACLE`` the directory with the program that asks roslaunch.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tests.bench.fixes import differences, outcome_of, repairs

EVERY = 12


@pytest.mark.corpus
@pytest.mark.ros
def test_repaired_files(corpus: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """``remap_to_itself`` is the one kind whose name no repair can bring back: there the node is started as by the mutant."""
    oracle = Path(os.environ.get("LAUNCHLINT_ORACLE", ""))
    if not (oracle / "oracle.py").is_file():
        pytest.skip("LAUNCHLINT_ORACLE does not name a directory with the program that asks roslaunch")
    monkeypatch.setattr(sys, "path", [str(oracle), *sys.path])
    found = list(repairs(corpus, every=EVERY))
    different = differences(found, corpus, oracle)
    new = [f"{repair.mutant['id']}: {finding.rule} {finding.message}" for repair in found for finding in repair.left]
    changed = [
        f"{repair.mutant['id']} ({', '.join(repair.rules)}): {different[repair.mutant['id']]}"
        for repair in found
        if repair.fixed.made and outcome_of(repair, different) == "different" and repair.mutant["kind"] != "remap_to_itself"
    ]
    assert (new, changed) == ([], [])
    assert sum(bool(repair.fixed.made) for repair in found) > 15
