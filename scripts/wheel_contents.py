"""Check that a built wheel holds every file of the package: code, data and type marker.

Run as ``python scripts/wheel_contents.py dist/launchlint-….whl``. Exit status 1 where something of ``launchlint/`` is missing from
the wheel, or where the wheel holds something that is not part of the package.
"""

from __future__ import annotations

import argparse
import sys
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NOT_SHIPPED = {".pyc", ".pyo"}
CONTAINER = "launchlint/probe/container"


def package_files(root: Path) -> set[str]:
    """Names of all files below ``root/launchlint``, relative to ``root`` and with ``/``, without compiled ones, and those of
    ``root/probe``.

    The latter, but for its settings of ruff, are shipped in ``launchlint/probe/container`` (``force-include`` in pyproject.toml).
    """

    def below(directory: str) -> set[str]:
        files = (path for path in (root / directory).rglob("*") if path.is_file() and path.suffix not in NOT_SHIPPED)
        return {path.relative_to(root / directory).as_posix() for path in files}

    return {f"launchlint/{name}" for name in below("launchlint")} | {
        f"{CONTAINER}/{name}" for name in below("probe") if not name.startswith((".", "ruff.toml"))
    }


def wheel_files(wheel: Path) -> set[str]:
    """Names of all files in ``wheel`` but for its metadata directory."""
    with zipfile.ZipFile(wheel) as archive:
        return {name for name in archive.namelist() if not name.endswith("/") and ".dist-info/" not in name}


def main() -> int:
    """Compare, tell, and return the exit status."""
    parser = argparse.ArgumentParser(description="Check that a wheel holds every file of the package.")
    parser.add_argument("wheel", type=Path, help="the wheel to look into")
    wheel: Path = parser.parse_args().wheel
    pages = f"{'-'.join(wheel.name.split('-')[:2])}.data/data/share/man/man1"
    expected = package_files(ROOT) | {f"{pages}/{page.name}" for page in (ROOT / "docs/man").iterdir()}
    found = wheel_files(wheel)
    for name in sorted(expected - found):
        print(f"{wheel.name} lacks {name}")
    for name in sorted(found - expected):
        print(f"{wheel.name} holds {name}, which is not in the source tree")
    if expected != found:
        return 1
    print(f"{wheel.name}: all {len(found)} files of the package are in it")
    return 0


if __name__ == "__main__":
    sys.exit(main())
