"""Build the documentation site: scripts/docs_site.py TARGET.

The pages are README.md, CONTRIBUTING.md, CHANGELOG.md and what lies in docs/; mkdocs-material draws them. A link that leads nowhere, a page
that is in no menu and every other warning ends the build with status 1.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FORGE = "https://github.com/launchlint/launchlint/blob/main/"
TOP = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}

_LINK = re.compile(r"(\]\()([^)\s]+)(\))")


def stage(directory: Path) -> None:
    """Put the sources of the site below ``directory``: every page at its place in one tree, links as they are there."""
    pages = directory / "docs"
    shutil.copytree(ROOT / "docs", pages)
    for name, top in TOP.items():
        (pages / top).write_text((ROOT / name).read_text(encoding="utf-8"), encoding="utf-8")
    for page in sorted(pages.rglob("*.md")):
        home = ROOT if page.parent == pages and page.name in TOP.values() else ROOT / "docs" / page.relative_to(pages).parent
        moved = partial(_moved, home=home, page=page, pages=pages)
        page.write_text(_LINK.sub(moved, page.read_text(encoding="utf-8")), encoding="utf-8")
    shutil.copy(ROOT / "scripts/docs_site/mkdocs.yml", directory / "mkdocs.yml")


def _moved(match: re.Match[str], home: Path, page: Path, pages: Path) -> str:
    """A link as written in the repository, as it must be on the site: files that are no pages are shown by the forge."""
    target, anchor, name = match[2].partition("#")
    if not target or "://" in target or target.startswith("mailto:"):
        return match[0]
    file = (home / target).resolve()
    if not file.is_relative_to(ROOT) or not file.exists():
        return match[0]  # mkdocs says that it leads nowhere
    inside = file.relative_to(ROOT).as_posix()
    if inside in TOP:
        place = pages / TOP[inside]
    elif inside.startswith("docs/") and (file.suffix in (".md", ".png", ".svg")):
        place = pages / inside.removeprefix("docs/")
    else:
        return f"{match[1]}{FORGE}{inside}{anchor}{name}{match[3]}"
    relative = Path(*[".."] * len(page.parent.relative_to(pages).parts), place.relative_to(pages))
    return f"{match[1]}{relative.as_posix()}{anchor}{name}{match[3]}"


def main(words: list[str]) -> int:
    """Build the site into TARGET. Returns the exit status."""
    if len(words) != 1:
        print("usage: scripts/docs_site.py TARGET", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as directory:
        stage(Path(directory))
        target = Path(words[0]).resolve()
        command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--clean", "--site-dir", str(target)]
        environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
        return subprocess.run(command, cwd=directory, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
