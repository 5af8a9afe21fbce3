"""How fast does the drawing of a report open, unfold and move, and how often do its lines cross?

``python -m tests.bench.report_drawing REPORT.html…``: pages that ``launchlint report`` wrote; their first entry file is drawn in headless
Chromium, 1440 × 900. ``ready`` is from opening the file to a drawing on the screen, with the time of the processor behind it: where other
programs want the processor, only the latter says something. Crossings are compared with those of elkjs doing the same view in one run.
"""

from __future__ import annotations

import re
import sys
import tempfile
from pathlib import Path
from statistics import median
from typing import Any

from playwright.sync_api import Browser, CDPSession, Page, sync_playwright

from scripts import report_assets
from tests.conftest import find_chromium

SIZE = {"width": 1440, "height": 900}
WATCH = """
addEventListener("DOMContentLoaded", () => {
  const host = document.getElementById("drawing");
  const look = () => host?.getAttribute("aria-busy") === "false" && (window.readyAt ??= performance.now());
  look(); // what has nothing to lay out may be there already
  new MutationObserver(look).observe(document, { subtree: true, attributes: true, attributeFilter: ["aria-busy"] });
});
"""
MOST_AT_ONCE = 1200
"""Nodes of a system that is also drawn with everything open."""
GROUND = "<!DOCTYPE html><style>html, body, #drawing { margin: 0; width: 100vw; height: 100vh }</style><div id=drawing></div>"


def ready(browser: Browser, report: Path, fragment: str = "") -> tuple[float, float]:
    """Milliseconds from opening a report to its drawing (or its landing page), on the clock and of the processor."""
    page = browser.new_page(viewport=SIZE)  # type: ignore[arg-type]  # Playwright's own type of a size
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})
    page.add_init_script(WATCH)
    page.goto(f"{report.as_uri()}{fragment}")
    # Not a selector: looking for one in ten thousands of rows would be measured with the page.
    page.wait_for_function("() => window.readyAt", polling=20, timeout=120_000)
    clock = float(page.evaluate("() => window.readyAt"))
    spent = processor(session)
    page.close()
    return clock, spent


def opened(browser: Browser, report: Path, script: Path) -> Page:
    """A page that draws the data of a report, and nothing else."""
    found = re.search(r'<script type="application/json" id="launchlint-data">(.*?)</script>', report.read_text(encoding="utf-8"), re.DOTALL)
    if found is None:
        raise SystemExit(f"{report} is no report of launchlint")
    page = browser.new_page(viewport=SIZE)  # type: ignore[arg-type]  # Playwright's own type of a size
    page.set_content(GROUND)
    page.add_script_tag(path=report_assets.ASSETS / "elk.js")
    page.add_script_tag(path=script)
    page.evaluate("text => Bench.load(text)", found[1])
    return page


def measure(browser: Browser, report: Path, script: Path) -> None:
    """Measure one report, and print what was found."""
    clock, spent = ready(browser, report)
    page = opened(browser, report, script)

    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def ask(what: str) -> Any:
        return page.evaluate(f"() => Bench.{what}")

    def series(name: str, what: str) -> None:
        before = processor(session)
        found = ask(what)
        each = (processor(session) - before) / max(1, len(found))
        if found:
            print(f"  {name:9} {median(found):7.0f} ms median, {max(found):.0f} ms at most, of {len(found)}; processor {each:.0f} ms each")

    def pan() -> None:
        before = processor(session)
        frames = ask("pan(2000)")
        each = (processor(session) - before) / frames
        print(f"  pan       {frames / 2:7.0f} frames a second; of the processor {each:.1f} ms each: {_drawn(ask('drawn()'))}")

    print(f"{report.name}: {report.stat().st_size / 1e6:.2f} MB")
    print(f"  ready     {clock:7.0f} ms; of the processor {spent:.0f} ms")
    before = processor(session)
    took = ask("first()")
    print(f"  first     {took:7.0f} ms; of the processor {processor(session) - before:.0f} ms: {_drawn(ask('drawn()'))}")
    series("select", "select(40)")
    series("expand", "expand(12)")
    series("hubs", "hubs()")
    pan()
    for name, found in ask("against()").items():
        print(
            f"  {name:9} {found['milliseconds']:7.0f} ms: {found['crossings']} crossings of {found['lines']} lines, "
            f"{found['width']:.0f} × {found['height']:.0f} pixels"
        )
    if int(ask("nodes()")) <= MOST_AT_ONCE:
        print(f"  all open  {ask('openEverything()'):7.0f} ms")
        pan()
    page.close()


def processor(session: CDPSession) -> float:
    """Milliseconds that the processor spent on a page's main thread."""
    metrics = {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}
    return float(metrics["TaskDuration"]) * 1000


def _drawn(found: dict[str, int]) -> str:
    return f"{found['boxes']} boxes, {found['lines']} lines"


def main() -> None:
    """Measure each report named on the command line."""
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    with tempfile.TemporaryDirectory() as directory, sync_playwright() as playwright:
        script = Path(directory) / "bench.js"
        report_assets.bundle(report_assets.tools(), Path(__file__).with_suffix(".js"), script, "--global-name=Bench")
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=["--no-sandbox"])
        for report in map(Path, sys.argv[1:]):
            measure(browser, report.resolve(), script)
        browser.close()


if __name__ == "__main__":
    main()
