""".launchlint.yaml and --entries: what they give, and what is said when they are wrong."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.errors import ConfigurationError
from launchlint.workspace.configuration import KEYS, SCHEMA_NAME, Configuration, Entry, find_configuration, load, load_entries

Grow = Callable[[Mapping[str, str | None]], Path]

WHOLE = """
workspace: [src, ../other]
library: robot.json
select: [LL3, unused-arg]
ignore: LL301
severity:
  LL206: info
per-file-ignores:
  "test/**": [LL202, LL206]
exclude: [old]
entries:
  - start.launch
  - file: start.launch
    as: moved.launch
    args: {sim: true, rate: 1.0, name: "", on: yes}
args:
  real:
  simulated: {sim: true}
env: {ROBOT: r1, NUMBER: 0x10}
packages: complete
format: {line-width: 100, indent: 4, sort-attributes: false, sort-args: true}
"""


def test_every_key(grow: Grow) -> None:
    root = grow({"project/.launchlint.yaml": WHOLE, "project/start.launch": "", "project/src": None, "other": None})
    path = f"{root}/project/.launchlint.yaml"
    found = load(path)
    assert found._replace(positions={}) == Configuration(
        path=path,
        directory=f"{root}/project",
        workspace=(f"{root}/project/src", f"{root}/other"),
        library=(f"{root}/project/robot.json",),
        select=("LL3", "unused-arg"),
        ignore=("LL301",),
        severity={"LL206": "info"},
        per_file_ignores={"test/**": ("LL202", "LL206")},
        exclude=("old",),
        entries=(
            Entry(f"{root}/project/start.launch", None, {}),
            Entry(
                f"{root}/project/start.launch",
                f"{root}/project/moved.launch",
                {"sim": "true", "rate": "1.0", "name": "", "on": "yes"},
            ),
        ),
        args={"real": {}, "simulated": {"sim": "true"}},
        env={"ROBOT": "r1", "NUMBER": "0x10"},
        packages="complete",
        line_width=100,
        indent=4,
        sort_attributes=False,
        sort_args=True,
        positions={},
    )
    assert found.where("select", 1) == f"{path}:4:15"
    assert found.where("severity", "LL206") == f"{path}:7:3"
    assert found.where("nothing") == path


@pytest.mark.parametrize(
    "text", ["", "# nothing\n", "---\n", "select:\n", "{}", "\ufeff", "format: {}", "severity:\nargs:\nenv:\nentries:\n"]
)
def test_a_file_that_says_nothing(text: str, tmp_path: Path) -> None:
    path = tmp_path / ".launchlint.yaml"
    path.write_text(text)
    defaults = Configuration(path=str(path), directory=str(tmp_path), positions={})
    assert load(str(path))._replace(positions={}) == defaults


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("selct: [a]", "1:1: the configuration has no key selct, and one that is misspelled would have no effect; did you mean select?"),
        (
            "colour: x",
            "1:1: the configuration has no key colour, and one that is misspelled would have no effect; it has: " + ", ".join(sorted(KEYS)),
        ),
        ("- a", "1:1: the configuration must be a mapping (name: value), not a list"),
        ("words", "1:1: the configuration must be a mapping (name: value), not a text"),
        ("[a]: b", "1:1: a key of the configuration must be a plain text, not a list"),
        ("select: a\nselect: b", "2:1: select is given twice, so one of the two would be lost; the first stands in line 1"),
        ("select: {a: b}", "1:9: select must be a list of texts, not a mapping"),
        ("select:\n  - a\n  - [b]", "3:5: each item of select must be a text, not a list"),
        ("select: [a, ]\nignore: [~]", "2:10: each item of ignore has no value; write one, or '' for an empty text"),
        ("ignore: ['']", "1:10: an item of ignore is empty; remove it"),
        ("severity: {LL301: warnin}", "1:19: the severity of LL301 cannot be warnin; did you mean warning?"),
        ("severity: {LL301: 7}", "1:19: the severity of LL301 cannot be 7; write one of them: error, warning, info"),
        ("severity: error", "1:11: severity must be a mapping (name: value), not a text"),
        ("per-file-ignores: [a]", "1:19: per-file-ignores must be a mapping (name: value), not a list"),
        ("packages: complet", "1:11: packages cannot be complet; did you mean complete?"),
        ("packages: ''", "1:11: packages cannot be ''; write one of them: complete, partial"),
        ("workspace: nowhere", "1:12: there is no directory nowhere, so no package can be found in it; correct the path or remove it"),
        ("entries: {a: b}", "1:10: entries must be a list of {file: PATH, args: {NAME: VALUE}}, not a mapping"),
        ("entries: [no.launch]", "1:11: there is no launch file no.launch, so it cannot be checked; correct the path or remove the entry"),
        ("entries: [{fil: x}]", "1:12: an entry has no key fil, and one that is misspelled would have no effect; did you mean file?"),
        ("entries: [{args: {a: b}}]", "1:11: this entry names no launch file; write file: PATH"),
        ("entries: [{file: x, args: [a]}]", "1:27: args must be a mapping (name: value), not a list"),
        ("entries: [{file: x, args: {a: }}]", "1:30: the arg a has no value; write one, or '' for an empty text"),
        ("args: {sim: true}", "1:13: args are grouped in profiles, so sim must be a mapping; put it under a name, such as default"),
        ("env: {A: [1]}", "1:10: the environment variable A must be a text, not a list"),
        ("env: {A: }", "1:9: the environment variable A has no value; write one, or '' for an empty text"),
        ("env: {'A=B': c}", "1:7: an environment variable cannot be called A=B; remove the = or the empty name"),
        ("format: {indnt: 2}", "1:10: format has no key indnt, and one that is misspelled would have no effect; did you mean indent?"),
        ("format: {indent: 99}", "1:18: indent must be a whole number from 1 to 8, not 99"),
        ("format: {line-width: wide}", "1:22: line-width must be a whole number from 40 to 400, not wide"),
        ("format: {sort-args: maybe}", "1:21: sort-args cannot be maybe; write one of them: true, false"),
        ("a: b: c", "1:5: this is not valid YAML: mapping values are not allowed in this context"),
        ("a: *b", "1:4: the alias *b refers to an anchor that is not set above it"),
        ("a: &b [*b]", "1:8: a YAML value that contains itself is not looked into"),
        ("a: b\n---\nc: d", "2:1: a second document starts here, and only one is read; remove the --- line"),
        (
            "ignore: !!python/object/apply:os.system [ls]",
            "1:9: the tag tag:yaml.org,2002:python/object/apply:os.system has no meaning here; remove it",
        ),
        ("\x1b[31m: a", "1:1: this is not valid YAML: control characters are not allowed"),
        ('"\\e[31m": a', None),
        ("[" * 100_000, "1:33: the YAML text is nested more than 32 deep"),
        ("- " * 100_000, "1:65: the YAML text is nested more than 32 deep"),
        (" " * (1 << 20) + " ", ": it cannot be read: it is larger than 1048576 bytes"),
    ],
)
def test_what_is_wrong(text: str, message: str | None, tmp_path: Path) -> None:
    path = tmp_path / ".launchlint.yaml"
    path.write_text(text)
    with pytest.raises(ConfigurationError) as caught:
        load(str(path))
    if message is None:  # control characters in a key: shown escaped
        assert "\x1b" not in str(caught.value)
        assert "no key '\\x1b[31m'," in str(caught.value)
    else:
        assert str(caught.value) == f"{path}{message if message.startswith(':') else ':' + message}"


def test_bytes_that_are_no_utf8(tmp_path: Path) -> None:
    path = tmp_path / "c.yaml"
    path.write_bytes(b"select: a\nignore: \xff")
    with pytest.raises(ConfigurationError) as caught:
        load(str(path))
    assert str(caught.value) == f"{path}:2:9: this is not UTF-8 text; save the file in UTF-8"


def test_aliases(tmp_path: Path) -> None:
    path = tmp_path / "c.yaml"
    path.write_text("select: &all [LL1, LL2]\nignore: *all")
    assert load(str(path)).ignore == ("LL1", "LL2")
    bomb = ["a0: &a0 [" + ", ".join(["x"] * 50) + "]"]
    bomb += [f"a{n}: &a{n} [" + ", ".join([f"*a{n - 1}"] * 12) + "]" for n in range(1, 9)]
    path.write_text("\n".join(bomb))
    start = time.process_time()
    with pytest.raises(ConfigurationError, match="too large when its aliases are written out"):
        load(str(path))
    assert time.process_time() - start < 2


def test_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        load(f"{tmp_path}/no.yaml")
    assert str(caught.value) == f"{tmp_path}/no.yaml: it cannot be read: No such file or directory"
    with pytest.raises(ConfigurationError) as caught:
        load(str(tmp_path))
    assert str(caught.value) == f"{tmp_path}: it cannot be read: it is not a plain file"


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("repo/a/b/x.launch", "repo/a/.launchlint.yaml"),
        ("repo/a", "repo/a/.launchlint.yaml"),
        ("repo/c/x.launch", "repo/.launchlint.yaml"),
        ("repo", "repo/.launchlint.yaml"),
        ("other/x.launch", None),
        ("loose/x.launch", None),
    ],
)
def test_the_nearest_file_within_the_repository(path: str, expected: str | None, grow: Grow) -> None:
    root = grow(
        {
            ".launchlint.yaml": "",
            "repo/.git/HEAD": "",
            "repo/.launchlint.yaml": "",
            "repo/a/.launchlint.yaml": "",
            "repo/a/b/x.launch": "",
            "repo/c/x.launch": "",
            "other/.git/HEAD": "",
            "other/.launchlint.yaml": None,
            "other/x.launch": "",
            "loose/x.launch": "",
        }
    )
    assert find_configuration(f"{root}/{path}") == (None if expected is None else f"{root}/{expected}")


def test_the_schema_knows_the_same_keys(root: Path) -> None:
    schema = json.loads((root / "launchlint" / "workspace" / SCHEMA_NAME).read_text())
    assert sorted(schema["properties"]) == sorted(KEYS)
    defaults = {name: each["default"] for name, each in schema["properties"]["format"]["properties"].items()}
    default = Configuration()
    assert defaults == {
        "line-width": default.line_width,
        "indent": default.indent,
        "sort-attributes": default.sort_attributes,
        "sort-args": default.sort_args,
    }


def test_the_schema_accepts_what_is_read(root: Path) -> None:
    import yaml

    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is not installed")
    schema = json.loads((root / "launchlint" / "workspace" / SCHEMA_NAME).read_text())
    jsonschema.validate(yaml.safe_load(WHOLE.replace("on: yes", "n: yes")), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"selct": []}, schema)


ENTRIES = [
    Entry("a.launch", None, {}),
    Entry("/b c.launch", "d.launch", {"x": "true", "y": "1.50", "z": "", "n": "-3"}),
    Entry("e.launch", None, {}),
]


@pytest.mark.parametrize(
    "text",
    [
        "- a.launch\n- file: /b c.launch\n  as: d.launch\n  args: {x: true, y: 1.50, z: '', n: -3}\n- {file: e.launch, args: }\n",
        '[{"file": "a.launch"}, {"file": "/b c.launch", "as": "d.launch", "args": {"x": true, "y": 1.50, "z": "", "n": -3}}, "e.launch"]',
        """ [{"file": "a.launch", "args": {}},
              {"file": "/b c.launch", "as": "d.launch", "args": {"x": "true", "y": "1.50", "z": "", "n": "-3"}},
              {"file": "e.launch", "args": null, "as": null}]""",
    ],
)
def test_entries(text: str, tmp_path: Path) -> None:
    path = tmp_path / "entries"
    path.write_text(text)
    assert load_entries(str(path)) == ENTRIES


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{}", "1:1: entries must be a list of {file: PATH, args: {NAME: VALUE}}, not a mapping"),
        ('[{"file": "a", "x": 1}]', "1:16: an entry has no key x, and one that is misspelled would have no effect; it has: args, as, file"),
        ('[{"file": "a"},\n {"args": {}}]', "2:2: this entry names no launch file; write file: PATH"),
        ('[{"file": ""}]', "1:2: this entry names no launch file; write file: PATH"),
        ('[{"file": ["a"]}]', "1:11: file must be a text, not a list"),
        ('[{"file": "a", "args": {"x": null}}]', "1:30: the arg x has no value; write one, or '' for an empty text"),
        ('[{"file": "a", "args": {"x": [1]}}]', "1:30: the arg x must be a text, not a list"),
        ('[{"file": "a", "file": "b"}]', "1:16: file is given twice, so one of the two would be lost; the first stands in line 1"),
        ('[{"file": "a"}', "1:15: this is not valid YAML: did not find expected ',' or ']'"),
        ("[" * 100_000, "1:33: the YAML text is nested more than 32 deep"),
    ],
)
def test_entries_that_are_wrong(text: str, message: str, tmp_path: Path) -> None:
    path = tmp_path / "entries.json"
    path.write_text(text)
    with pytest.raises(ConfigurationError) as caught:
        load_entries(str(path))
    assert str(caught.value) == f"{path}:{message}"


def test_no_entries(tmp_path: Path) -> None:
    path = tmp_path / "entries.yaml"
    for text in ("", "[]", "# none\n"):
        path.write_text(text)
        assert load_entries(str(path)) == []
    with pytest.raises(ConfigurationError) as caught:
        load_entries(f"{tmp_path}/no.yaml")
    assert str(caught.value) == f"{tmp_path}/no.yaml: it cannot be read: No such file or directory"
