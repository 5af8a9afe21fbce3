"""``launchlint completion``: the script that it prints, in the real shell."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.running import ROOT, clean_environment, run, write


@pytest.mark.parametrize(
    ("shell", "word"), [("bash", "complete -o nosort -F"), ("zsh", "#compdef launchlint"), ("fish", "function _launchlint")]
)
def test_a_script_for_each_shell(tmp_path: Path, shell: str, word: str) -> None:
    ran = run(tmp_path, "completion", shell)
    assert (ran.status, ran.errors) == (0, "")
    assert word in ran.output


def test_it_completes_in_bash(tmp_path: Path) -> None:
    bash = shutil.which("bash")
    if bash is None:
        pytest.skip("bash is not installed")
    write(tmp_path, {"some.launch": "<launch/>", "bin/launchlint": ""})
    command = tmp_path / "bin/launchlint"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -c "import sys; from launchlint.cli import main; main()" "$@"\n')
    command.chmod(0o755)
    script = tmp_path / "script"
    script.write_text(run(tmp_path, "completion", "bash").output)
    ask = f"""
source {script}
ask() {{ COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _launchlint_completion launchlint; printf '%s\\n' "${{COMPREPLY[@]}}"; }}
ask launchlint che
ask launchlint check --stag
ask launchlint check --col
"""
    variables = clean_environment(tmp_path / "cache", PYTHONPATH=str(ROOT))
    variables["PATH"] = f"{tmp_path / 'bin'}:{variables['PATH']}"
    done = subprocess.run([bash, "--norc", "-c", ask], cwd=tmp_path, env=variables, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["check", "--staged", "--color"], done.stderr
