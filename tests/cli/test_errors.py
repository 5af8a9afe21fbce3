"""Whatever a person gets wrong: one clear message on standard error, exit status 2, and nothing half-written."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from launchlint.cli.commands import COMMANDS
from launchlint.rules.registry import RULES
from tests.cli.running import CLEAN, clean_environment, run, write

NO_EFFECT = "and one that is misspelled would have no effect"
NO_WORKSPACE = "--workspace nowhere: there is no such directory; packages are looked for in it, so give one that exists"
BROKEN_BASELINE = (
    "broken.json:1:2: this baseline is no JSON: Expecting property name enclosed in double quotes; --write-baseline makes a new one"
)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["nowhere"], "nowhere: No such file or directory; give launch files, or directories to search for them"),
        (["demo", "no\x1bwhere"], "no\\x1bwhere: No such file or directory; give launch files, or directories to search for them"),
        (["--format", "sarf"], "there is no format 'sarf': did you mean sarif?"),
        (
            ["--format", "pdf"],
            "there is no format 'pdf': the formats are text, concise, json, jsonl, sarif, github, gitlab, junit, markdown",
        ),
        (["--format", "json:"], "--format json:: the name of a file belongs after the colon"),
        (["--format", "json:demo"], "cannot write the json report to 'demo': it is a directory; give the name of a file"),
        (
            ["--format", "json:no/where.json"],
            "cannot write the json report to 'no/where.json': the directory 'no' does not exist; create it first",
        ),
        (
            ["--format", "json:a.out", "--format", "sarif:./a.out"],
            "--format sarif:./a.out: --format json:a.out goes to the same file; give each a file of its own",
        ),
        (["--write-baseline", "demo"], "cannot write the baseline to 'demo': it is a directory; give the name of a file"),
        (["--baseline", "nowhere.json"], "nowhere.json: there is no such baseline file; --write-baseline makes one"),
        (["--baseline", "demo"], "demo: the baseline must be a file"),
        (["--baseline", "broken.json"], BROKEN_BASELINE),
        (["--baseline", "list.json"], 'list.json: this is no baseline: it has no list "findings"; --write-baseline makes a new one'),
        (["--select", "LL999"], "--select LL999: there is no rule LL999; launchlint rules lists them all"),
        (["--select", "unused-ar"], "--select unused-ar: there is no rule unused-ar; did you mean unused-arg?"),
        (["--ignore", "LL301,whatever-else"], "--ignore whatever-else: there is no rule whatever-else; launchlint rules lists them all"),
        (["--severity", "LL301"], "--severity LL301: write RULE=error, RULE=warning or RULE=info"),
        (["--severity", "LL301=fatal"], "--severity LL301=fatal: write RULE=error, RULE=warning or RULE=info"),
        (["--severity", "LL3x1=error"], "--severity LL3x1=error: there is no rule LL3x1; launchlint rules lists them all"),
        (["--fail-on", "fatal"], "--fail-on: fatal is no severity; write error, warning or info"),
        (["--arg", "speed=1"], "--arg speed=1: an arg is given as name:=value, as to roslaunch and ros2 launch"),
        (["--arg", ":=1"], "--arg :=1: an arg is given as name:=value, as to roslaunch and ros2 launch"),
        (["--workspace", "nowhere"], NO_WORKSPACE),
        (["-", "demo"], "- stands for standard input and cannot be mixed with other paths; check them in two calls"),
        (["--stdin-filename", "a.launch"], "--stdin-filename names standard input; give - as the path too"),
        (["--entries", "nowhere.json"], "nowhere.json: it cannot be read: No such file or directory"),
        (["--entries", "list.json", "demo"], "--entries names the files; give no paths beside it"),
        (
            ["--entries", "list.json", "--format", "sarif"],
            "--entries judges each entry by itself and prints one line of JSON for it: it goes with --format jsonl only",
        ),
        (["--entries", "entries.yaml"], f"entries.yaml:2:3: an entry has no key fiel, {NO_EFFECT}; did you mean file?"),
        (["--config", "nowhere.yaml"], "nowhere.yaml: it cannot be read: No such file or directory"),
        (["--config", "demo"], "demo: it cannot be read: it is not a plain file"),
        (["--config", "unknown.yaml"], f"unknown.yaml:2:1: the configuration has no key selct, {NO_EFFECT}; did you mean select?"),
        (["--config", "rule.yaml"], "rule.yaml:1:17: select: there is no rule LL999; launchlint rules lists them all"),
        (["--config", "ignores.yaml"], "ignores.yaml:2:13: per-file-ignores: there is no rule nothing; launchlint rules lists them all"),
        (["--config", "severity.yaml"], "severity.yaml:1:12: severity: there is no rule LL3x1; launchlint rules lists them all"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)  # fmt: skip
def test_bad_input(repository: Path, words: list[str], message: str) -> None:
    write(
        repository,
        {
            "broken.json": "{",
            "list.json": "[]",
            "entries.yaml": "- file: a.launch\n- fiel: b.launch\n",
            "unknown.yaml": "ignore: []\nselct: [LL301]\n",
            "rule.yaml": "select: [LL301, LL999]\n",
            "ignores.yaml": "per-file-ignores:\n  'a/**':  [nothing]\n",
            "severity.yaml": "severity: {LL3x1: error}\n",
        },
    )
    before = sorted(repository.rglob("*"))
    ran = run(repository, "check", *words)
    assert ran == (2, "", f"launchlint: {message}\n")
    assert sorted(repository.rglob("*")) == before


@pytest.mark.parametrize(
    "words",
    [["--jobs", "-1"], ["--jobs", "many"], ["--color", "maybe"], ["--selct", "LL301"], ["--select"], ["-x"], ["--exit-zero=1"]],
)
def test_what_click_refuses(repository: Path, words: list[str]) -> None:
    """Its words differ from version to version; they are one line and name the option."""
    ran = run(repository, "check", *words)
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.startswith("launchlint: ")
    assert words[0].partition("=")[0] in ran.errors
    assert ran.errors.endswith("; `launchlint check --help` shows what can be said\n")
    assert ran.errors.count("\n") == 1


def test_bad_configuration_that_is_found_by_itself(repository: Path) -> None:
    write(repository, {".launchlint.yaml": "ignore: [\n"})
    ran = run(repository, "check")
    assert (ran.status, ran.output) == (2, "")
    assert ran.errors.startswith("launchlint: .launchlint.yaml:2:1: this is not valid YAML: ")


def test_names_are_shown_in_one_line_and_without_tricks(repository: Path) -> None:
    ran = run(repository, "check", "a\nb\u202e")
    assert ran == (2, "", "launchlint: a\\nb\\u202e: No such file or directory; give launch files, or directories to search for them\n")


def test_unreadable_file_is_a_finding(repository: Path) -> None:
    """A directory that is called like a launch file, and a link to nothing: everything else is checked all the same."""
    (repository / "folder.launch").mkdir()
    (repository / "dangling.launch").symlink_to("nowhere")
    write(repository, {"includes.launch": '<launch>\n  <include file="$(dirname)/folder.launch"/>\n</launch>\n'})
    ran = run(repository, "check", "--format", "concise", "includes.launch", "demo/launch/clean.launch", "folder.launch")
    assert (ran.status, ran.errors) == (1, "")
    assert ran.output == "includes.launch:2:18: error LL401 include-not-found: the included file folder.launch does not exist\n"


def test_no_command_and_unknown_command(repository: Path) -> None:
    bare = run(repository)
    assert (bare.status, bare.output) == (2, "")
    assert bare.errors.startswith("Usage: launchlint [OPTIONS] [COMMAND] [ARGS]...\n")
    hint = "; `launchlint --help` shows what can be said\n"
    assert run(repository, "chekc") == (2, "", f"launchlint: there is no command 'chekc': did you mean check?{hint}")
    listed = ", ".join(COMMANDS)
    assert run(repository, "fly") == (2, "", f"launchlint: there is no command 'fly': the commands are {listed}{hint}")


def test_a_reader_that_goes_away(repository: Path) -> None:
    """``launchlint check | head -1``: no traceback, and not the status that means findings."""
    write(repository, {f"demo/launch/double{number}.launch": CLEAN.replace("</launch>", CLEAN[9:]) for number in range(200)})
    environment = clean_environment(repository / ".cache")
    command = [sys.executable, "-m", "launchlint", "check", "--no-cache", "--jobs", "1"]
    with subprocess.Popen(command, cwd=repository, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        errors = process.stderr.read()
        assert (process.wait(timeout=60), errors) == (141, b"")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no /dev/full")
def test_a_full_disk(repository: Path) -> None:
    environment = clean_environment(repository / ".cache")
    with open("/dev/full", "wb") as full:
        ran = subprocess.run(
            [sys.executable, "-m", "launchlint", "check", "--no-cache"], cwd=repository, env=environment, stdout=full,
            stderr=subprocess.PIPE, check=False, timeout=60,
        )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (2, b"launchlint: this cannot be done: No space left on device\n")


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_ctrl_c(repository: Path, jobs: str) -> None:
    """One word to the terminal, at once, and no worker left behind."""
    includes = "".join(f'<include file="$(dirname)/part.launch" ns="n{number}"/>' for number in range(300))
    write(repository, {f"many{number}.launch": f"<launch>{includes}</launch>\n" for number in range(200)})
    write(repository, {"part.launch": "<launch>" + '<param name="a" value="$(anon b)"/>' * 100 + "</launch>\n"})
    process = subprocess.Popen(
        [sys.executable, "-m", "launchlint", "check", "--no-cache", "--jobs", jobs], cwd=repository,
        env=clean_environment(repository / ".cache"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    # A shell's background job ignores SIGINT, and so would its children: hence the preexec_fn.
    time.sleep(2.5)
    assert process.poll() is None, "it is not meant to be done by now"
    began = time.monotonic()
    os.killpg(process.pid, signal.SIGINT)
    output, errors = process.communicate(timeout=30)
    assert (process.returncode, output) == (130, b"")
    assert errors.decode().strip() == "launchlint: stopped"
    assert time.monotonic() - began < 15
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)


def test_a_crash_of_launchlint_itself_is_one_line(repository: Path) -> None:
    """No traceback for the user; where it happened is named."""
    program = (
        "import sys; import launchlint.workspace.discovery as d\n"
        "def broken(*_): raise ZeroDivisionError('on purpose')\n"
        "d.discover = broken\n"
        "from launchlint.cli import main; main(['check'])"
    )
    ran = subprocess.run(
        [sys.executable, "-c", program], cwd=repository, env=clean_environment(repository / ".cache"), capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr == ("launchlint: launchlint itself failed: ZeroDivisionError: on purpose (<string>, line 2); please report this\n")


def test_every_rule_can_be_named(repository: Path) -> None:
    words = ",".join(rule.name for rule in RULES)
    assert run(repository, "check", "-q", "--select", words, "demo/launch/clean.launch").status == 0
