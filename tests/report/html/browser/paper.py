"""What a page is on paper: sheets, by what stands on them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import Page

PAPERS = [(paper, landscape) for paper in ("A4", "Letter") for landscape in (False, True)]
DARK = 128
"""What is darker is ink."""


def sheets(page: Page, directory: Path, paper: str, *, landscape: bool) -> list[str]:
    """The words on each sheet that a page is printed on; poppler's tools read them."""
    if shutil.which("pdftotext") is None:
        pytest.skip("poppler-utils are not installed")
    file = directory / "page.pdf"
    file.write_bytes(page.pdf(format=paper, landscape=landscape))
    text = subprocess.run(["pdftotext", "-layout", str(file), "-"], capture_output=True, text=True, check=True).stdout
    return text.removesuffix("\f").split("\f")


def ink(directory: Path, sheet: int) -> tuple[float, float, float, float]:
    """Where there is ink on a sheet, numbered from 1, that :func:`sheets` printed: left, top, right, bottom as shares of its size."""
    command = ["pdftoppm", "-r", "40", "-gray", "-f", str(sheet), "-l", str(sheet), "-singlefile", str(directory / "page.pdf")]
    subprocess.run([*command, str(directory / "sheet")], check=True)
    kind, width, height, _, pixels = (directory / "sheet.pgm").read_bytes().split(maxsplit=4)
    assert kind == b"P5"
    columns, rows = int(width), int(height)
    inked = [row for row in range(rows) if min(pixels[row * columns : (row + 1) * columns]) < DARK]
    across = [column for column in range(columns) if min(pixels[column::columns]) < DARK]
    return min(across) / columns, inked[0] / rows, (max(across) + 1) / columns, (inked[-1] + 1) / rows
