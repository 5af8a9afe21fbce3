"""A check leaves no garbage in circles behind: what is no longer needed goes at once, and Python need seldom look for it."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest

from launchlint.check.entry import EntryChecker
from launchlint.project.asked import EntryOptions
from tests.check.many import many

UNKNOWN = """\
<launch>
  <include file="$(find nowhere)/launch/a.launch"/>
  <include file="$(find nowhere)/launch/$(env NOT_SET)/$(arg not_declared).launch"/>
</launch>
"""


def test_a_check_leaves_no_circles(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    many(tmp_path, 8)
    (tmp_path / "arm" / "launch" / "unknown.launch").write_text(UNKNOWN, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    entry = EntryOptions((str(tmp_path),))
    requests, _ = entry.requests()
    options = entry.options()
    for request in requests:  # what is imported on the way makes circles once
        EntryChecker(options).check(request)
    checker = EntryChecker(options)
    gc.collect()
    gc.disable()
    try:
        results = [checker.check(request) for request in requests]
        left = gc.collect()
    finally:
        gc.enable()
    assert len(results) == len(requests) > 8
    assert left == 0
