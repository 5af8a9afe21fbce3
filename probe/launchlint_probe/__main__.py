"""``python3 -I …/launchlint_probe/__main__.py [JOB]``: do a job (a file, else standard input), one line of JSON for each thing that is
known.
"""

import json
import os
import signal
import sys
import tempfile

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from launchlint_probe.work import environment, leave, run_all, say


def main() -> int:
    """Read the job, do it, end whatever was started."""
    signal.signal(signal.SIGTERM, _stop)
    signal.signal(signal.SIGINT, _stop)
    if len(sys.argv) > 1:
        with open(sys.argv[1], encoding="utf-8") as file:
            job = json.load(file)
    else:
        job = json.load(sys.stdin)
    signal.signal(signal.SIGALRM, _stop)
    signal.alarm(int(job.get("limits", {}).get("total", 86400)) + 30)  # nobody may be left who would stop it
    with tempfile.TemporaryDirectory(prefix="launchlint-probe-") as directory:
        tempfile.tempdir = directory
        say(environment())
        left = run_all(job)
        say({"kind": "end", "left": left})
    return 1 if left else 0


def _stop(number: int, frame: object) -> None:
    """Asked to stop: whatever runs below this process ends with it."""
    leave(128 + number)


if __name__ == "__main__":
    sys.exit(main())
