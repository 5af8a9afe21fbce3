"""The guides: their snippets are valid, their workflows are those that are tested, and the site builds without a warning."""

from __future__ import annotations

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from tests.cli.running import DOUBLE, run, write

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
WORKFLOWS = [*sorted((DOCS / "workflows").glob("*.yml")), *sorted((ROOT / ".github/workflows").glob("*.yml"))]
TOOLS = Path(sys.executable).parent
# In a guide a version says more than a hash; a project that pins has a tool that does it.
POLICY = "rules: {unpinned-uses: {config: {policies: {'*': ref-pin}}}}\n"


def snippets(page: str, language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", (DOCS / page).read_text(encoding="utf-8"), re.DOTALL)


def tool(name: str) -> Path:
    if not (TOOLS / name).is_file():
        pytest.skip(f"{name} is not installed (it is part of the dev extra)")
    return TOOLS / name


def passes(*words: str | Path) -> None:
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.name)
def test_workflows_are_valid_and_safe(file: Path, tmp_path: Path) -> None:
    passes(tool("check-jsonschema"), "--builtin-schema", "vendor.github-workflows", file)
    policy = tmp_path / "zizmor.yml"
    policy.write_text(POLICY if DOCS in file.parents else "rules: {}\n")
    passes(tool("zizmor"), "--offline", "--quiet", "--config", policy, file)


def test_the_host_of_the_site_is_told_how_to_build_it() -> None:
    passes(tool("check-jsonschema"), "--builtin-schema", "vendor.readthedocs", ROOT / ".readthedocs.yaml")


def test_every_workflow_is_explained() -> None:
    told = (DOCS / "github-action.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"\]\(workflows/([\w.]+)\)", told)) == [file.name for file in WORKFLOWS if DOCS in file.parents]


def test_every_input_and_output_of_the_action_is_explained() -> None:
    action = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
    inputs, outputs = (DOCS / "github-action.md").read_text(encoding="utf-8").split("## Inputs")[1].split("## Outputs")
    assert re.findall(r"^\| `([\w-]+)`", inputs, re.MULTILINE) == list(action["inputs"])
    assert re.findall(r"`([\w-]+)`", "".join(re.findall(r"^\| (`[^|]+) \|", outputs, re.MULTILINE))) == list(action["outputs"])


def test_the_hooks_are_explained() -> None:
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    told = (DOCS / "pre-commit.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `([\w-]+)`", told, re.MULTILINE) == [hook["id"] for hook in hooks]


def test_snippets_of_gitlab_are_valid(tmp_path: Path) -> None:
    for number, text in enumerate(snippets("other-ci.md", "yaml")):
        (tmp_path / f"{number}.yml").write_text(text)
        passes(tool("check-jsonschema"), "--builtin-schema", "vendor.gitlab-ci", tmp_path / f"{number}.yml")


def test_the_problem_matcher_matches(tmp_path: Path) -> None:
    """VS Code's pattern, read from the guide, takes a real finding apart."""
    (task,) = next(each for each in map(json.loads, snippets("editors.md", "json")) if "tasks" in each)["tasks"]
    pattern = task["problemMatcher"]["pattern"]
    directory = tmp_path / "robot"
    write(directory, {"a.launch": DOUBLE})
    line = run(directory, *task["command"].split()[1:]).output.splitlines()[-1]
    match = re.match(pattern["regexp"], line)
    assert match is not None
    parts = {name: match[group] for name, group in pattern.items() if name != "regexp"}
    assert parts == {
        "file": "a.launch", "line": "3", "column": "15", "severity": "error", "code": "LL301",
        "message": "duplicate-node-name: two nodes are named /talker",
    }  # fmt: skip


def test_the_examples_of_the_configuration_are_valid(tmp_path: Path) -> None:
    for text in snippets("configuration.md", "yaml"):
        names = ("launch/robot.launch", "launch/simulation.launch")
        files = dict.fromkeys(names, '<launch><arg name="robot_name" default="r"/></launch>\n')
        write(tmp_path / "robot", {**files, ".launchlint.yaml": text, "library.json": "{}", ".launchlint-baseline.json": ""})
        for directory in ("drivers/src", "common/src"):
            (tmp_path / directory).mkdir(parents=True, exist_ok=True)
        ran = run(tmp_path / "robot", "model", "launch/robot.launch")
        assert "launchlint.yaml" not in ran.errors, ran.errors


def test_the_page_of_the_configuration_is_what_the_schema_says() -> None:
    passes(sys.executable, ROOT / "scripts/configuration_page.py", "--check")


def test_the_manual_pages_are_what_the_commands_say() -> None:
    if importlib.util.find_spec("click_man") is None:
        pytest.skip("click-man is not installed (it is part of the dev extra)")
    passes(sys.executable, ROOT / "scripts/man_pages.py", "--check")


def test_the_compiled_templates_are_what_the_templates_give() -> None:
    passes(sys.executable, ROOT / "scripts/page_templates.py", "--check")


def test_the_site_builds(tmp_path: Path) -> None:
    if importlib.util.find_spec("material") is None:
        pytest.skip("mkdocs-material is not installed (it is part of the dev extra)")
    passes(sys.executable, ROOT / "scripts/docs_site.py", tmp_path / "site")
    assert (tmp_path / "site/rules/LL301/index.html").is_file()
    assert (tmp_path / "site/getting-started/index.html").is_file()


def test_every_test_that_the_threat_model_names_is_there() -> None:
    named = re.findall(r"`(tests/[\w/]+\.py)::(test_\w+)`", (DOCS / "security.md").read_text(encoding="utf-8"))
    assert len(named) > 20
    for file, test in named:
        assert f"def {test}(" in (ROOT / file).read_text(encoding="utf-8"), f"{file}::{test}"
