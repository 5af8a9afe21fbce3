"""Take the pictures of the topology report that the documentation shows: ``python scripts/report_pictures.py [ROBOT]``.

They go to ``docs/images``: ``report-finding.png`` and ``report-changes.png`` of the launch files in ``examples/turtles``, and, where ROBOT
names a checkout of a robot's launch files, ``report-robot.png`` of that. Needs Chromium and Playwright; a picture is 1440 × 900 pixels.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
TURTLES = ROOT / "examples" / "turtles"
CHROMIUM = ("chromium", "chromium-browser", "google-chrome")
GIT = ("git", "-c", "user.name=nobody", "-c", "user.email=nobody@example.org", "-c", "commit.gpgsign=false")
CHANGES = (("wide_circle", "huge_circle"), ('to="turtle1/cmd_vel"', 'to="turtle1/cmd"'))
"""What becomes of the first launch file of the turtles."""
SIZE = {"width": 1440, "height": 900}


def report(directory: Path, *words: str) -> Path:
    """The page that ``launchlint report WORDS`` writes in a directory."""
    page = directory / "page.html"
    subprocess.run([sys.executable, "-m", "launchlint", "report", *words, "-o", str(page), "--quiet"], cwd=directory, check=True)
    return page


def changed_turtles(directory: Path) -> Path:
    """The page that compares the turtles with what they were before :data:`CHANGES`."""
    for words in (("init", "--quiet"), ("add", "--all"), ("commit", "--quiet", "--message", "before")):
        subprocess.run([*GIT, *words], cwd=directory, check=True)
    launch = directory / "turtle_parade" / "launch" / "parade.launch"
    text = launch.read_text(encoding="utf-8")
    for before, after in CHANGES:
        text = text.replace(before, after, 1)
    launch.write_text(text, encoding="utf-8")
    return report(directory, "turtle_parade/launch/parade.launch", "--base", "HEAD")


def take(pictures: dict[str, tuple[Path, str]]) -> None:
    """Take a picture of each page, by name, once the link with a text was followed; an empty text: at once."""
    from playwright.sync_api import sync_playwright

    executable = next(found for found in map(shutil.which, CHROMIUM) if found)
    IMAGES.mkdir(exist_ok=True)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=["--no-sandbox"])
        for name, (address, link) in pictures.items():
            page = browser.new_page(viewport=SIZE, color_scheme="light", reduced_motion="reduce")  # type: ignore[arg-type]
            page.goto(address.as_uri())
            page.wait_for_selector("#drawing[aria-busy=false]")
            if link:
                page.locator("#panel").get_by_role("link", name=link).click()
            page.mouse.move(0, 0)
            picture = page.screenshot(path=IMAGES / f"{name}.png")
            print(f"{name}.png: {len(picture) / 1000:.0f} kB")
        browser.close()


def main() -> None:
    """Take them all."""
    with tempfile.TemporaryDirectory() as scratch:
        for name in ("finding", "changes"):
            shutil.copytree(TURTLES, Path(scratch, name))
        finding = report(Path(scratch, "finding"), "turtle_parade/launch/parade_broken.launch")
        pictures = {
            "report-finding": (finding, "nobody subscribes to /cmd_vel"),
            "report-changes": (changed_turtles(Path(scratch, "changes")), ""),
        }
        if len(sys.argv) > 1:
            robot = Path(scratch, Path(sys.argv[1]).resolve().name.rpartition("+")[2])
            shutil.copytree(sys.argv[1], robot, symlinks=True)
            pictures["report-robot"] = (report(robot, "."), "")
        take(pictures)


if __name__ == "__main__":
    main()
