"""``launchlint probe --local`` from the command line, with a package of odd programs in place of ROS."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.probe.odd_nodes import PACKAGE, install, processes_with

LIMITS = "limits: {quiet: 0.4, limit: 4, jobs: 2}\n"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A directory with an install space that the environment points at."""
    install(tmp_path / "prefix", ["wants_args.py", "waits_for_message.py", "own_name.py", "crashes_politely.py", "ignores_signals.py"])
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(tmp_path / "prefix"))
    monkeypatch.setenv("ROS_DISTRO", "odd")
    return tmp_path


def command(place: Path, *words: str, text: str = "") -> list[str]:
    (place / "probe.yaml").write_text(f"packages: [{PACKAGE}]\n{LIMITS}{text}")
    return [sys.executable, "-m", "launchlint", "probe", str(place / "probe.yaml"), "--local", "-o", str(place / "library.json"), *words]


def probe(place: Path, *words: str, text: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run(command(place, *words, text=text), capture_output=True, text=True, timeout=120, check=False)


def test_a_library_is_made(place: Path) -> None:
    done = probe(place, text=f"nodes: {{{PACKAGE}/wants_args.py: {{args: '{{}} {{}}'}}}}\nskip: [{PACKAGE}/ignores_signals.py]\n")
    assert (done.returncode, done.stdout) == (0, "")
    assert done.stderr == (
        f"{place}/library.json: 4 executables recorded, 0 could not be run, 0 programs are no nodes\n"
        "recorded, but there may be more to them:\n"
        "  exception: 1\n"
        f"    {PACKAGE}/crashes_politely.py: IndexError: list index out of range\n"
    )
    document = json.loads((place / "library.json").read_text())
    package = document["packages"][PACKAGE]
    assert package["version"] == "4.5.6"
    variant = package["executables"]["wants_args.py"]["variants"]["default"]
    run = f"local, {document['environment']['base']}"
    for entry in (*variant["publishers"], *variant["subscribers"]):
        entry.pop("md5", None)  # known only where the message is installed
    assert variant == {
        "args": "{} {}",
        "publishers": [{"name": "{arg:2}", "type": "std_msgs/String", "evidence": [{"by": "dynamic", "run": run}]}],
        "subscribers": [{"name": "{arg:1}", "type": "std_msgs/String", "evidence": [{"by": "dynamic", "run": run}]}],
        "open": {"clients": "a service client is seen only when it waits for its service or calls it"},
    }
    assert sorted(path.name for path in place.iterdir()) == ["library.json", "prefix", "probe.yaml"]


def test_the_same_library_again_with_more_jobs_and_in_parts(place: Path) -> None:
    assert probe(place, "-q").returncode == 0
    first = (place / "library.json").read_bytes()
    assert probe(place, "-q", "--jobs", "3").returncode == 0
    assert (place / "library.json").read_bytes() == first
    parts = []
    for number in (1, 2, 3):
        assert probe(place, "-q", "--shard", f"{number}/3").returncode in (0, 1)
        parts.append(str((place / "library.json").rename(place / f"{number}.json")))
    merged = subprocess.run([sys.executable, "-m", "launchlint", "library", "merge", *parts, "-o", "-"], capture_output=True, check=True)
    assert merged.stdout == first


def test_ctrl_c_loses_nothing_and_leaves_nothing_running(place: Path) -> None:
    process = subprocess.Popen(command(place, "--jobs", "1"), stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, preexec_fn=_obey)
    partial = place / "library.json.partial.jsonl"
    end = time.monotonic() + 60
    while time.monotonic() < end and not (partial.exists() and partial.read_text().count("\n") >= 2):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert re.fullmatch(
        rf"(?:1 program is|\d programs are) in {re.escape(str(partial))}: the same command with --resume .*\n+launchlint: stopped\n", said
    ), said
    assert processes_with(str(place / "prefix")) == []
    assert not (place / "library.json").exists()
    before = {json.loads(line)["name"]: json.loads(line)["seconds"] for line in partial.read_text().splitlines()}
    assert len(before) >= 2
    with partial.open("a") as file:
        file.write('{"kind": "node", "cut off')
    began = time.monotonic()
    done = probe(place, "--resume", "--jobs", "4")
    assert done.returncode == 0, done.stderr
    assert time.monotonic() - began < 60
    assert not partial.exists()
    executables = json.loads((place / "library.json").read_text())["packages"][PACKAGE]["executables"]
    assert sorted(executables) == ["crashes_politely.py", "ignores_signals.py", "own_name.py", "waits_for_message.py", "wants_args.py"]
    whole = (place / "library.json").read_bytes()
    assert probe(place, "-q").returncode == 0
    assert (place / "library.json").read_bytes() == whole


def test_what_changed_in_an_interface(place: Path) -> None:
    """A topic is renamed and a param added while a probe is interrupted; what goes on runs the changed node again."""
    few = f"skip: [{', '.join(f'{PACKAGE}/{name}.py' for name in ('crashes_politely', 'ignores_signals', 'waits_for_message'))}]\n"
    assert probe(place, "-q", text=few).returncode == 0
    old = (place / "library.json").rename(place / "old.json")
    package = place / "prefix" / "lib" / PACKAGE
    (package / "with_no_end.py").write_text("#!/usr/bin/env python3\n# rospy\nwhile True: pass\n")
    (package / "with_no_end.py").chmod(0o755)
    endless = f"{few}nodes: {{{PACKAGE}/with_no_end.py: {{limit: 300}}}}\n"
    process = subprocess.Popen(command(place, text=endless), stderr=subprocess.PIPE, text=True, preexec_fn=_obey)
    partial = place / "library.json.partial.jsonl"
    end = time.monotonic() + 60
    while time.monotonic() < end and not (partial.exists() and partial.read_text().count("\n") >= 2):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    (package / "with_no_end.py").unlink()
    node = package / "own_name.py"
    node.write_text(node.read_text().replace("/pose", "/odom").replace("spin()", 'node.param("~rate")\nspin()'))
    assert probe(place, "--resume", "-q", text=few).returncode == 0
    words = [sys.executable, "-m", "launchlint", "library", "diff", str(old), str(place / "library.json")]
    told = subprocess.run(words, capture_output=True, text=True, check=False)
    assert (told.returncode, told.stdout, told.stderr) == (
        1,
        (
            f"{PACKAGE}/own_name.py\n"
            "  + publisher /robots/{any}/{node}/odom (std_msgs/String)\n"
            "  - publisher /robots/{any}/{node}/pose (std_msgs/String)\n"
            "  + param ~rate\n"
        ),
        "",
    )


def test_a_run_that_comes_to_nothing_leaves_what_an_earlier_one_found(place: Path) -> None:
    partial = place / "library.json.partial.jsonl"
    partial.write_text("what an earlier run has found\n")
    arguments = [word for word in command(place) if word != "--local"]
    done = subprocess.run(
        arguments, capture_output=True, text=True, timeout=60, check=False, env={**os.environ, "DOCKER_HOST": f"unix://{place}/none"}
    )
    assert (done.returncode, partial.read_text()) == (2, "what an earlier run has found\n")
    assert done.stderr.splitlines()[0] == (
        f"an earlier probe did not end ({partial}): this one begins anew; to go on with the other, stop it and say --resume"
    )


def _obey() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def test_time_is_up(place: Path) -> None:
    done = probe(place, text="").returncode
    assert done == 0
    (place / "prefix" / "lib" / PACKAGE / "with_no_end.py").write_text("#!/usr/bin/env python3\n# rospy\nwhile True: pass\n")
    (place / "prefix" / "lib" / PACKAGE / "with_no_end.py").chmod(0o755)
    arguments = command(place)
    (place / "probe.yaml").write_text(
        f"packages: [{PACKAGE}]\nlimits: {{limit: 300, total: 10, jobs: 1}}\nskip: [{PACKAGE}/ignores_signals.py]\n"
    )
    late = subprocess.run(arguments, capture_output=True, text=True, timeout=120, check=False)
    assert late.returncode == 1
    assert late.stderr.endswith("not everything was probed: time was up after 10 seconds (`total` in `limits`); --resume goes on\n")
    assert (place / "library.json.partial.jsonl").exists()
    assert processes_with(str(place / "prefix")) == []


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--shard", "0/3"], "--shard cannot be '0/3': write I/N, such as 1/4 for the first of four parts"),
        (["--shard", "4/3"], "--shard cannot be '4/3': write I/N, such as 1/4 for the first of four parts"),
        (["--shard", "x"], "--shard cannot be 'x': write I/N, such as 1/4 for the first of four parts"),
        (
            ["-o", "/nowhere/at/all.json"],
            "cannot write the library to '/nowhere/at/all.json': the directory '/nowhere/at' does not exist; create it first",
        ),
    ],
)
def test_usage(words: list[str], message: str, place: Path) -> None:
    done = probe(place, *words)
    assert (done.returncode, done.stderr) == (2, f"launchlint: {message}\n")


def test_a_package_that_is_not_there(place: Path) -> None:
    arguments = command(place)
    (place / "probe.yaml").write_text("packages: [nowhere]\n")
    done = subprocess.run(arguments, capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (
        1,
        (
            f"{place}/library.json: 0 executables recorded, 0 could not be run, 0 programs are no nodes\n"
            "there is no package nowhere: correct `packages`, or install it by `apt`\n"
        ),
    )


def test_what_local_leaves_aside_is_said(place: Path) -> None:
    arguments = command(place)
    (place / "probe.yaml").write_text("packages: [nowhere]\napt: [x11-apps]\nrepositories: [{url: a/b, ref: main}]\n")
    done = subprocess.run(arguments, capture_output=True, text=True, timeout=60, check=False, env={**os.environ})
    assert done.stderr.splitlines()[:2] == [
        "--local leaves `repositories` aside: nothing is fetched, installed or built on this machine",
        "--local leaves `apt` aside: nothing is fetched, installed or built on this machine",
    ]
