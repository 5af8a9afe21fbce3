"""A picture as PNG: drawn by a browser of this machine, where there is one."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile

from launchlint.errors import UsageError

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge", "chrome")
"""Programs that know ``--headless --screenshot``, the first that is there is taken."""
TIME = 60
"""Seconds that it may take."""
SCALE = 2
"""Pixels of the PNG for each of the SVG, so that it is sharp on today's screens."""


def png(svg: str) -> bytes:
    """The PNG of an SVG that launchlint wrote. Raises UsageError where no browser is here, or it fails."""
    browser = next((found for found in map(shutil.which, BROWSERS) if found), None)
    if browser is None:
        raise UsageError(f"--picture: a PNG is drawn by a browser, and none is here ({', '.join(BROWSERS[:3])}); write an .svg instead")
    size = re.match(r'<svg [^>]*width="(\d+)" height="(\d+)"', svg)
    assert size is not None  # launchlint wrote it
    with tempfile.TemporaryDirectory(prefix="launchlint-") as directory:
        source, target = os.path.join(directory, "picture.svg"), os.path.join(directory, "picture.png")
        with open(source, "w", encoding="utf-8") as file:
            file.write(svg)
        words = [
            browser, "--headless", "--disable-gpu", "--hide-scrollbars", "--no-first-run", f"--user-data-dir={directory}/profile",
            *(["--no-sandbox"] if os.geteuid() == 0 else []),  # it refuses to start as root with one; the file is launchlint's own
            f"--force-device-scale-factor={SCALE}", f"--window-size={size[1]},{size[2]}", f"--screenshot={target}", f"file://{source}",
        ]  # fmt: skip
        try:
            subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=TIME, check=False)
            with open(target, "rb") as file:
                return file.read()
        except (OSError, subprocess.TimeoutExpired):
            raise UsageError(f"--picture: {browser} does not draw it; write an .svg instead") from None
