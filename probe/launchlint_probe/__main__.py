"""``python3 -m launchlint_probe < job.json``: probe the nodes of a job, one line of JSON for each thing that is known."""

import json
import sys

from launchlint_probe.work import environment, run_all, say


def main() -> int:
    """Read the job from standard input and do it."""
    job = json.load(sys.stdin)
    say(environment())
    left = run_all(job)
    say({"kind": "end", "left": left})
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
