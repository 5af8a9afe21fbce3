"""What ``launchlint init`` writes and shows."""

from __future__ import annotations

from collections.abc import Sequence

from launchlint import __version__
from launchlint.named_tuple import NamedTuple

ADDRESS = "https://github.com/launchlint/launchlint"
GUIDE = "https://launchlint.readthedocs.io/en/stable/"

HOOK = f"""\
repos:
  - repo: {ADDRESS}
    rev: v{__version__}
    hooks:
      - id: launchlint
      # - id: launchlint-format  # puts launch files in normal form
"""

WORKFLOW = f"""\
# Checks the launch files of every pull request. Copy it to .github/workflows/launchlint.yml.
name: launchlint

on:
  pull_request:
  push:
    branches: [main, master, devel]

permissions:
  contents: read

jobs:
  launchlint:
    runs-on: ubuntu-latest
    steps:
      - uses: actions/checkout@v4
        with:
          fetch-depth: 0 # what the pull request changes in the topology is told by comparing with its base
          persist-credentials: false
      - uses: launchlint/launchlint@v{__version__}
"""

GITLAB = """\
launchlint:
  image: python:3.12-slim
  script:
    - pip install --quiet launchlint
    - launchlint check --format gitlab:gl-code-quality-report.json --format junit:launchlint.xml --format text
  artifacts:
    when: always
    reports:
      codequality: gl-code-quality-report.json
      junit: launchlint.xml
"""


class Found(NamedTuple):
    """What is in a repository: names of ``packages``, paths of launch files that are ``read``, and the CI.

    ``started`` are the launch files that no other one includes; ``errors`` and ``warnings`` count what a check finds.
    """

    packages: Sequence[str]
    read: Sequence[str]
    started: Sequence[str]
    errors: int
    warnings: int
    github: bool
    gitlab: bool
    hooks: bool


def configuration(found: Found) -> str:
    """The text of a new ``.launchlint.yaml``: every key, explained, none of them set."""
    entries = found.started[:3] or ["launch/robot.launch"]
    listed = "\n".join(f"#   - file: {_quoted(file)}" for file in entries)
    return f"""\
# What launchlint is told about this repository: {GUIDE}configuration/
# Everything here is optional, and shown with an example; take away the "# " of what you need.

# The launch files that people start, and with which args. Without it: every launch file that no other one includes.
# entries:
{listed}
#     args: {{sim: true}}

# Where packages are, besides this repository (the first directory that has a package wins).
# workspace: [../other_packages]

# complete: every package the robot has can be found, so one that is missing is an error; partial: it may be elsewhere.
# packages: partial

# The distribution of ROS 2 that its launch files are for.
# distro: jazzy

# Libraries of what nodes do, beside those in .launchlint/; and whether the sources of your own nodes are read.
# library: [library.json]
# extract: false

# Rules not to run (launchlint rules lists them), and others that count more or less here.
# ignore: [LL206]
# severity: {{LL504: error}}
# per-file-ignores:
#   "test/*.launch": [LL702]

# Files and directories to leave out.
# exclude: [third_party]

# Findings that are known already and not told: launchlint check --write-baseline .launchlint-baseline.json
# baseline: .launchlint-baseline.json

# How launchlint format writes.
# format: {{line-width: 120, indent: 2}}
"""


def _quoted(text: str) -> str:
    from json import dumps

    return text if text.isascii() and text.replace("/", "").replace("_", "").replace(".", "").isalnum() else dumps(text)
