"""Recorded answers and models with one name for every temporary file, so that a comparison of the two can see that both name one.

Launch gives files of params that it writes itself random names (``/tmp/tmpk3x_9a1q``), and a recorded answer holds one: no model can
state it. ``model`` states ``/tmp/launchlint_written_…`` there. Both become ``<temporary file>`` here, and nothing else is changed::

    python -m tests.conformance.ros2.temporary_names answers RECORDED.jsonl.xz > ANSWERS.jsonl
    python -m tests.conformance.ros2.temporary_names model --format jsonl …          as launchlint model, for whatever compares
"""

from __future__ import annotations

import lzma
import re
import subprocess
import sys

from launchlint.evaluate.session import WRITTEN

NAME = "<temporary file>"
_RANDOM = re.compile(r"/tmp/tmp[a-z0-9_]{8}(?![\w./-])")
"""As Python's ``tempfile`` makes it, and nothing behind it."""
_OURS = re.compile(re.escape(WRITTEN) + r"[0-9a-f]{16}(?![\w./-])")


def of_answer(line: str) -> str:
    """A line of recorded answers."""
    return _RANDOM.sub(NAME, line)


def of_model(line: str) -> str:
    """A line of ``launchlint model --format jsonl``."""
    return _OURS.sub(NAME, line)


def main(arguments: list[str]) -> int:
    """Write the answers of a file, or the models that launchlint states."""
    if arguments[0] == "answers":
        with lzma.open(arguments[1], "rt", encoding="utf-8") as lines:
            sys.stdout.writelines(map(of_answer, lines))
        return 0
    done = subprocess.run([sys.executable, "-m", "launchlint", *arguments], stdout=subprocess.PIPE, check=False)
    sys.stdout.write(of_model(done.stdout.decode("utf-8", "surrogateescape")))
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
