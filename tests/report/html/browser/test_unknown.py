"""Wherever it is said that nobody is at the other end, it is said that somebody may be, where a node is not known."""

from __future__ import annotations

import pytest

pytestmark = pytest.mark.chromium


def test_nobody_is_said_with_the_doubt_that_is_there(open_report):
    page = open_report(fragment="#entry=robot.launch&topic=/base/cmd_vel&open=/base")
    assert "1 not known" in page.locator("#counts li").all_inner_texts()
    assert "may" in page.locator("#panel").inner_text()
    tips = page.locator("#drawing > svg .loose > title").all_text_contents()
    assert any("/base/cmd_vel: nobody known offers it; a node that is not known as a whole may" in each for each in tips)
    assert not any("/base/cmd_vel: nobody else" in each for each in tips)
    page.locator(".openers").get_by_role("button", name="Topics").click()
    row = page.locator("#table-topics tr", has_text="/base/cmd_vel").inner_text()
    assert "nobody here, but" in row
    assert "may" in row
