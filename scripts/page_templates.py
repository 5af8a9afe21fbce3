"""Compile the templates of the report's page, or check that what is there is what the templates give.

``python scripts/page_templates.py`` writes ``launchlint/report/html/compiled``: the Python that jinja2 makes of each template. Another
version of jinja2 than the one that wrote it takes the templates themselves. ``--check`` writes nothing, says what differs, and exits with
status 1 where something does; it has nothing to compare with where another jinja2 is installed, says so, and passes.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

from launchlint.report.html.page import COMPILED, templates

ROOT = Path(__file__).resolve().parent.parent


def expected(target: Path) -> dict[str, str]:
    """Name to text of each file that the templates give; ``target`` is an empty directory to write into."""
    environment = templates(compiled=False)
    environment.compile_templates(target, extensions=["html"], zip=None, ignore_errors=False)
    return _read(target)


def _read(directory: Path) -> dict[str, str]:
    return {path.name: path.read_text(encoding="utf-8") for path in sorted(directory.glob("*.py"))}


def main() -> int:
    """Write or compare, tell, and return the exit status."""
    parser = argparse.ArgumentParser(description="Compile the templates of the report's page.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 where a file is not what the templates give")
    check: bool = parser.parse_args().check
    directory = COMPILED / f"jinja2-{version('jinja2')}"
    others = sorted(path.name for path in COMPILED.glob("jinja2-*") if path != directory)
    if check and others and not directory.exists():
        print(f"The templates are not compared: {', '.join(others)} wrote what is there, and this is {directory.name}", file=sys.stderr)
        return 0
    with tempfile.TemporaryDirectory() as made:
        wanted = expected(Path(made))
    if wanted == _read(directory) and not others:
        return 0
    if check:
        print(f"{COMPILED.relative_to(ROOT)} is not what the templates give: run python scripts/page_templates.py", file=sys.stderr)
        return 1
    shutil.rmtree(COMPILED, ignore_errors=True)
    directory.mkdir(parents=True)
    for name, text in wanted.items():
        (directory / name).write_text(text, encoding="utf-8")
    print(f"{directory.relative_to(ROOT)}: {len(wanted)} templates written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
