"""The environment variables that files of a workspace set or read."""

from pathlib import Path

import pytest

from launchlint.workspace.variables import read_variables


@pytest.mark.parametrize(
    ("name", "text", "known"),
    [
        ("a.sh", "export A=1\n  B=2\n# export C=3\necho D\n", {"A", "B"}),
        ("robot.service", "[Service]\nEnvironment=ROBOT=left\nExecStart=/bin/x\n", {"ROBOT", "ExecStart"}),
        ("Dockerfile", "FROM ros\nENV SITE=office \\\n  CONFIG=/config\nRUN true\n  NONE=1\n", {"SITE", "CONFIG"}),
        (".docker/Dockerfile.dev", "FROM ros\nENV SITE=office\n", {"SITE"}),
        ("Dockerfile", "FROM ros\nENV SITE office\n# ENV NONE 1\n", {"SITE"}),
        ("docker-compose.yml", "services:\n  robot:\n    environment:\n      - ROBOT=left\n      SITE: office\n", {"ROBOT", "SITE"}),
        ("a.py", "os.environ['A']\nos.environ.get(\"B\")\nos.getenv('C', 1)\n", {"A", "B", "C"}),
        ("a.cpp", 'std::getenv("A"); // B=\n', {"A"}),
        ("a.txt", "export A=1\n", set()),
    ],
)
def test_what_is_set_or_read(tmp_path: Path, name: str, text: str, known: set[str]) -> None:
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text(text)
    found = read_variables([str(tmp_path)])
    assert set(found.known) == known
    assert (f"{tmp_path}/{name}" in found.looked) == (name != "a.txt")
