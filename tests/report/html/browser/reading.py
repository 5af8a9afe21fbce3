"""What can be read on a page."""

from __future__ import annotations

from playwright.sync_api import Locator, Page


def drawn(page: Page) -> Page:
    """The page, once what it shall show is drawn."""
    page.wait_for_selector("#drawing[aria-busy=false]", state="attached")
    return page


def lines(host: Locator) -> list[str]:
    """The lines of text that are seen in something, without empty ones."""
    return [line.strip() for line in host.inner_text().split("\n") if line.strip()]


def boxes(page: Page) -> list[str]:
    """The labels of what is drawn, sorted: nodes, containers and pills."""
    drawn(page)
    titles = page.locator("#drawing > svg .box[data-id]").evaluate_all("all => all.map(each => each.querySelector('title').textContent)")
    return sorted(title.replace("\n", ", ") for title in titles)


def fragment(page: Page) -> str:
    """What stands behind ``#`` in the address."""
    return page.url.partition("#")[2]
