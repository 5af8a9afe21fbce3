"""Write the JavaScript that pages of the report carry, or check that it is what the sources give.

``python scripts/report_assets.py`` type-checks the modules under ``launchlint/report/html/js`` with TypeScript, bundles them with esbuild
into ``launchlint/report/html/assets/report.js``, and copies the layout engine elkjs beside it as it comes from npm, with its licence.
``--check`` writes nothing, says what differs, and exits with status 1 where something does.

The tools come from npm in the versions of ``scripts/report_assets/package-lock.json``, and are kept in a cache directory
(``LAUNCHLINT_CI_CACHE``, else the user's). Where npm is missing, or cannot install them, ``--check`` says so and passes: it has nothing to
compare with.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HTML = ROOT / "launchlint" / "report" / "html"
ASSETS = HTML / "assets"
SETTINGS = ROOT / "scripts" / "report_assets"
NOTICE = """elk.js in this directory is lib/elk.bundled.js of elkjs {version}, unchanged.

elkjs is made by the Eclipse Layout Kernel project and its contributors. launchlint distributes it under the Eclipse Public License 2.0,
whose text is in elk.LICENSE.md. Its source code: https://github.com/kieler/elkjs/tree/{version}
"""


class ToolError(Exception):
    """A tool is missing or failed; the message says which, and how."""


def tools() -> Path:
    """The ``node_modules`` directory of the locked versions, installed once.

    Raises:
        ToolError: where npm is missing or cannot install them.
    """
    npm = shutil.which("npm")
    if npm is None:
        raise ToolError("npm is not installed")
    lock = SETTINGS / "package-lock.json"
    caches = os.environ.get("LAUNCHLINT_CI_CACHE") or Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "launchlint-ci")
    directory = Path(caches, f"report-assets-{hashlib.sha256(lock.read_bytes()).hexdigest()[:12]}")
    modules = directory / "node_modules"
    if not (modules / ".complete").exists():
        directory.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(SETTINGS / name, directory / name)
        run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error", "--prefix", str(directory)])
        (modules / ".complete").touch()
    return modules


def run(command: list[str]) -> None:
    """Run a command, and show what it says where it fails.

    Raises:
        ToolError: where it fails.
    """
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    if done.returncode:
        raise ToolError(f"{Path(command[0]).name} failed:\n{done.stdout}{done.stderr}")


def bundle(modules: Path, entry: Path, out: Path, *more: str) -> None:
    """Bundle a module and all that it imports into one script.

    Raises:
        ToolError: where esbuild fails.
    """
    # The names of browsers are those that know CSSStyleSheet.replaceSync, which the drawing needs.
    options = ["--bundle", "--format=iife", "--charset=utf8", "--target=chrome90,firefox101,safari16.4", "--loader:.css=text"]
    run([str(modules / ".bin" / "esbuild"), str(entry), *options, "--log-level=warning", f"--outfile={out}", *more])


def type_check(modules: Path) -> None:
    """Check the types of all modules.

    Raises:
        ToolError: where they are wrong.
    """
    run([str(modules / ".bin" / "tsc"), "--project", str(SETTINGS / "tsconfig.json")])


def expected_files(modules: Path) -> dict[str, bytes]:
    """Name to content of every file in the directory of assets.

    Raises:
        ToolError: where a tool fails.
    """
    with tempfile.TemporaryDirectory() as directory:
        out = Path(directory) / "report.js"
        bundle(modules, HTML / "js" / "main.js", out)
        report = out.read_bytes()
    elk = modules / "elkjs"
    version = json.loads((elk / "package.json").read_text(encoding="utf-8"))["version"]
    return {
        "elk.LICENSE.md": (elk / "LICENSE.md").read_bytes(),
        "elk.NOTICE": NOTICE.format(version=version).encode(),
        "elk.js": (elk / "lib" / "elk.bundled.js").read_bytes(),
        "report.js": report,
    }


def main() -> int:
    """Write or compare, tell, and return the exit status."""
    parser = argparse.ArgumentParser(description="Write the JavaScript that pages of the report carry.")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 where a file is not what the sources give")
    check: bool = parser.parse_args().check
    try:
        modules = tools()
    except ToolError as error:
        print(f"The assets of the report are not {'checked' if check else 'written'}: {error}", file=sys.stderr)
        return 0 if check else 1
    try:
        type_check(modules)
        expected = expected_files(modules)
    except ToolError as error:
        print(error, file=sys.stderr)
        return 1
    present = {path.name: path.read_bytes() for path in ASSETS.glob("*")}
    wrong = sorted(name for name in expected.keys() | present.keys() if expected.get(name) != present.get(name))
    if not check:
        ASSETS.mkdir(exist_ok=True)
        for name in wrong:
            if name in expected:
                (ASSETS / name).write_bytes(expected[name])
            else:
                (ASSETS / name).unlink()
        print(f"{ASSETS.relative_to(ROOT)}: {', '.join(wrong) or 'nothing'} changed")
        return 0
    for name in wrong:
        print(f"{(ASSETS / name).relative_to(ROOT)} is not what the sources give: run python scripts/report_assets.py", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
