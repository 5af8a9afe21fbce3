"""The thread in which a workspace is looked at: what is typed first, and all else when typing has paused."""

from __future__ import annotations

import time
from pathlib import Path
from queue import Queue

from launchlint.server.analysis import PAUSE, Analysis, First, Ready
from tests.server.workspace import MAIN, make

OUTER = '<launch>\n  <include file="$(find demo)/launch/main.launch"/>\n</launch>\n'


def test_what_is_not_open_waits_until_typing_has_paused(tmp_path: Path) -> None:
    root = make(tmp_path / "ws")
    (root / "demo" / "launch" / "outer.launch").write_text(OUTER, encoding="utf-8")
    told: Queue[Ready | First] = Queue()
    failed: list[str] = []

    def ready_for(version: int) -> Ready:
        while True:
            found = told.get(timeout=60)
            if isinstance(found, Ready) and found.versions == {main: version}:
                return found

    analysis = Analysis(str(root), None, told.put, failed.append)
    main = str(root / "demo" / "launch" / "main.launch")
    try:
        analysis.hold(main, MAIN.encode(), 1)
        while not ready_for(1).whole:
            pass
        analysis.hold(main, MAIN.replace("\n", "\n\n", 1).encode(), 2)
        assert not ready_for(2).whole, "outer.launch leads to it, too"
        begun = time.monotonic()
        assert ready_for(2).whole
        assert time.monotonic() - begun > PAUSE / 2
    finally:
        analysis.end()
    assert failed == []
