"""What is not known of a launch file in Python is said wherever something is said of it, with the reason."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.cli import main

FILE = """\
import os
import foo
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription([Node(package='p', executable='e', name='sure')])
    if os.getcwd() == '/x':
        ld.add_action(Node(package='p', executable='e', name='perhaps'))
    foo.more(ld)
    return ld
"""
REASON = "os.getcwd() == '/x'"


def said(directory: Path, capsys: pytest.CaptureFixture[str], *words: str) -> str:
    file = directory / "a.launch.py"
    file.write_text(FILE, encoding="utf-8")
    main([*words, str(file)], standalone_mode=False)
    return capsys.readouterr().out


def test_model_check_and_graph(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    model = said(tmp_path, capsys, "model")
    assert "a.launch.py is known in part without running it:\n  line 8: not all actions of a list are known\n" in model
    assert f"line 10: {REASON}" in model
    assert f"[maybe: {REASON}]" in model
    assert f"line 10: {REASON}" in said(tmp_path, capsys, "check", "-v", "--no-cache")
    graph = said(tmp_path, capsys, "graph")
    assert f"maybe: {REASON}" in graph
    assert "not everything could be followed, so there may be more" in graph


def test_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    said(tmp_path, capsys, "report", "-o", "page.html")
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert '"python":[{' in page
    assert '"state":"partly"' in page
