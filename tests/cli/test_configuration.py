"""``.launchlint.yaml`` through the command line."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.running import CLEAN, PACKAGE, run, write
from tests.cli.test_check import BOTH, FOUND_DOUBLE, FOUND_UNUSED


@pytest.mark.parametrize(
    ("text", "status", "output"),
    [
        ("ignore: [LL301]\n", 0, FOUND_UNUSED),
        ("select: [LL301]\n", 1, FOUND_DOUBLE),
        ("severity: {duplicate-node-name: warning}\n", 0, BOTH.replace("error LL301", "warning LL301")),
        ("exclude: [double.launch]\n", 0, FOUND_UNUSED),
        ("exclude: [demo/launch]\n", 0, ""),
        ("per-file-ignores: {double.launch: [LL301]}\n", 0, FOUND_UNUSED),
        ("per-file-ignores: {demo/launch/*.launch: [LL301, unused-arg]}\n", 0, ""),
        ("per-file-ignores: {launch/*.launch: [LL301]}\n", 1, BOTH),
        ("per-file-ignores: {'demo/**': [LL2]}\n", 1, FOUND_DOUBLE),
    ],
)
def test_keys(repository: Path, text: str, status: int, output: str) -> None:
    write(repository, {".launchlint.yaml": text})
    assert run(repository, "check", "--format", "concise") == (status, output, "")


def test_patterns_are_relative_to_the_file_and_not_to_the_current_directory(repository: Path) -> None:
    write(
        repository, {".launchlint.yaml": "per-file-ignores: {demo/launch/double.launch: [LL301]}\nexclude: [demo/launch/unused.launch]\n"}
    )
    for directory in (repository, repository / "demo", repository / "demo" / "launch"):
        said = (
            "no problems in 2 launch files; of 2 entry files 1 loads, 1 is refused by roslaunch\n"  # whatever somebody wants to hear of it
        )
        assert run(directory, "check") == (0, said, ""), directory


def test_options_go_over_the_file(repository: Path) -> None:
    write(repository, {".launchlint.yaml": "select: [LL206]\nseverity: {LL301: info}\n"})
    ran = run(repository, "check", "--format", "concise", "--select", "LL301", "--severity", "LL301=warning")
    assert ran.output == FOUND_DOUBLE.replace("error", "warning")


def test_config_names_another_file(repository: Path) -> None:
    write(repository, {"strict.yaml": "select: [LL301]\n", ".launchlint.yaml": "select: [LL206]\n"})
    assert run(repository, "check", "--format", "concise", "--config", "strict.yaml").output == FOUND_DOUBLE


BRANCH = (
    '<launch><arg name="robot" default="one"/><node name="one" pkg="demo" type="talk.py" if="$(eval robot == \'two\')"/>'
    '<node name="$(arg robot)" pkg="demo" type="talk.py"/></launch>\n'
)


def test_profiles_of_args(repository: Path) -> None:
    write(
        repository,
        {
            "needs.launch": '<launch><arg name="robot"/><node name="$(arg robot)" pkg="demo" type="talk.py"/>'
                            '<node name="two" pkg="demo" type="talk.py"/></launch>\n',
            ".launchlint.yaml": "args: {first: {robot: one}, second: {robot: two}}\n",
        },
    )  # fmt: skip
    ran = run(repository, "check", "--format", "json", "needs.launch")
    assert ran.status == 1
    assert '"message": "two nodes are named /two"' in ran.output
    assert '"configuration": {"robot": "two"}' in ran.output


def test_entries_of_the_file_bring_their_args(repository: Path) -> None:
    write(
        repository,
        {
            "needs.launch": '<launch><arg name="robot"/><node name="$(arg robot)" pkg="demo" type="talk.py"/></launch>\n',
            ".launchlint.yaml": "entries:\n  - {file: needs.launch, args: {robot: one}}\n  - {file: needs.launch, args: {robot: two}}\n",
        },
    )
    assert run(repository, "check", "-v", "--fail-on", "info", "needs.launch") == (
        0,
        "no problems in 1 launch file; 2 of 2 nodes known\n",
        "",
    )
    write(repository, {".launchlint.yaml": "entries: [needs.launch]\n"})
    ran = run(repository, "check", "-v", "--format", "concise", "needs.launch")
    assert "LL202 required-arg-unset" in ran.output


def test_env_is_what_launch_files_see(repository: Path) -> None:
    write(repository, {"env.launch": '<launch><node name="$(env ROBOT)" pkg="demo" type="talk.py"/></launch>\n'})
    assert "LL209" in run(repository, "check", "--format", "concise", "env.launch").output
    write(repository, {".launchlint.yaml": "env: {ROBOT: one}\n"})
    assert run(repository, "check", "--format", "concise", "env.launch") == (0, "", "")


def test_env_of_a_checked_repository_does_not_move_the_cache(repository: Path, tmp_path: Path) -> None:
    write(repository, {f"demo/launch/many{number}.launch": CLEAN for number in range(30)})
    elsewhere = tmp_path / "elsewhere"
    write(repository, {".launchlint.yaml": f"env: {{XDG_CACHE_HOME: {elsewhere}, HOME: {elsewhere}}}\n"})
    assert run(repository, "check", "-q").status == 1
    assert not elsewhere.exists()
    assert (tmp_path / "repository-cache" / "launchlint").is_dir()


def test_workspace_of_the_file(repository: Path) -> None:
    write(
        repository,
        {
            "vendor/arm/package.xml": PACKAGE.format(name="arm"),
            "vendor/arm/part.launch": "<launch/>\n",
            "arm.launch": '<launch><include file="$(find arm)/part.launch"/></launch>\n',
            ".launchlint.yaml": "workspace: [demo]\n",
        },
    )
    assert "LL210" in run(repository, "check", "-v", "--format", "concise", "arm.launch").output
    write(repository, {".launchlint.yaml": "workspace: [demo, vendor]\n"})
    assert run(repository, "check", "-v", "--format", "concise", "arm.launch") == (0, "", "")
