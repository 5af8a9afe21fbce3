"""Write docs/configuration.md from the schema of the configuration, or check that it is what the schema says (``--check``)."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/configuration.md"
SCHEMA = ROOT / "launchlint/workspace/configuration_schema.json"

INTRODUCTION = """\
# Configuration

launchlint reads `.launchlint.yaml`: the nearest one upward from the checked file, not beyond its repository. `launchlint init` writes one
with every key explained. Paths in it are relative to its directory. A key that does not exist, or a value of the wrong kind, is an error
with its line and column.

Editors that know JSON Schema complete and check the file with
what `launchlint schema configuration` prints ([editors](editors.md)).

An option on the command line wins over the configuration; `--library` adds to it.

| key | value | what it says |
|---|---|---|
"""

EXAMPLES = """\

## Examples

How the robot is started, so that required args are no riddle, and two profiles in which everything is evaluated:

```yaml
entries:
  - file: launch/robot.launch
    args: {robot_name: rosie}
  - file: launch/simulation.launch
args:
  indoors: {map: office}
  outdoors: {map: field, gps: true}
```

Packages that are built elsewhere, and a library of what their nodes do:

```yaml
workspace: [../drivers/src, ../common/src]
packages: complete
library: [library.json]
```

Fewer and other findings:

```yaml
ignore: [LL206, LL8]
severity: {LL504: error}
per-file-ignores:
  "test/**": [LL612, LL613]
exclude: [third_party, "**/generated_*.launch"]
baseline: .launchlint-baseline.json
```

In patterns `*` and `?` stop at `/`, `**` does not. A pattern without `/` names a file or directory at any depth.
"""


def page() -> str:
    """The text of the page."""
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    return INTRODUCTION + "".join(_rows(schema["properties"], "")) + EXAMPLES


def _rows(properties: dict[str, Any], prefix: str) -> Iterator[str]:
    for key, described in properties.items():
        name = f"{prefix}{key}"
        yield f"| `{name}` | {_value(key, described)} | {described['description']} |\n"
        if "properties" in described:
            yield from _rows(described["properties"], f"{name}: ")


def _value(key: str, described: dict[str, Any]) -> str:
    if "$ref" in described and described["$ref"].endswith("/texts"):
        return "a text, or a list of them"
    if "enum" in described:
        return " or ".join(f"`{each}`" for each in described["enum"] if each is not None)
    kinds = described.get("type", "object")
    kind = next((each for each in ([kinds] if isinstance(kinds, str) else kinds) if each != "null"), "object")
    words = {"object": "a mapping", "array": "a list", "string": "a text", "integer": "a number", "boolean": "`true` or `false`"}[kind]
    if "minimum" in described:
        words += f" from {described['minimum']} to {described['maximum']}"
    if "default" in described:
        words += f"; default `{json.dumps(described['default'])}`"
    return words


def main(words: list[str]) -> int:
    """Write the page, or with ``--check`` look at it. Returns the exit status."""
    text = page()
    if words == ["--check"]:
        if PAGE.is_file() and PAGE.read_text(encoding="utf-8") == text:
            return 0
        print(f"{PAGE.relative_to(ROOT)} is not what the schema says; run scripts/configuration_page.py", file=sys.stderr)
        return 1
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
