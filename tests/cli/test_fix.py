"""``check --fix``, ``--unsafe-fixes`` and ``--diff`` as a user runs them."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from tests.cli.running import CLEAN, DOUBLE, PACKAGE, Ran, run, write

MISSPELT = '<launch>\n  <node name="talker" pkg="demo" type="talk.py" respwan="true"/>\n</launch>\n'
REPAIRED = MISSPELT.replace("respwan", "respawn")
DIFFERENCE = """\
--- a/demo/launch/typo.launch
+++ b/demo/launch/typo.launch
@@ -1,3 +1,3 @@
 <launch>
-  <node name="talker" pkg="demo" type="talk.py" respwan="true"/>
+  <node name="talker" pkg="demo" type="talk.py" respawn="true"/>
 </launch>
"""
TYPO = "demo/launch/typo.launch"


@pytest.fixture
def typo(repository: Path) -> Path:
    """A file that --fix repairs, and one with a mistake for which it takes --unsafe-fixes."""
    (repository / "demo/launch/unused.launch").unlink()
    write(repository, {TYPO: MISSPELT})
    return repository


def concise(directory: Path, *words: str, stdin: str | bytes = "") -> Ran:
    return run(directory, "check", "--format", "concise", *words, stdin=stdin)


LEFT = "demo/launch/double.launch:3:15: error LL301 duplicate-node-name: two nodes are named /talker\n"


def test_fix_writes_and_tells_of_the_rest(typo: Path) -> None:
    (typo / TYPO).chmod(0o640)
    assert concise(typo, "--fix") == (1, LEFT, "launchlint: fixed 1 finding in 1 file\n")
    assert (typo / TYPO).read_text(encoding="utf-8") == REPAIRED
    assert stat.S_IMODE((typo / TYPO).stat().st_mode) == 0o640
    assert (typo / "demo/launch/double.launch").read_text(encoding="utf-8") == DOUBLE
    assert concise(typo, "--fix") == (1, LEFT, "launchlint: fixed nothing\n")


def test_unsafe_fixes_are_made_with_the_safe_ones(typo: Path) -> None:
    assert concise(typo, "--unsafe-fixes") == (0, "", "launchlint: fixed 2 findings in 2 files\n")
    assert (typo / TYPO).read_text(encoding="utf-8") == REPAIRED
    once = '<launch>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
    assert (typo / "demo/launch/double.launch").read_text(encoding="utf-8") == once


def test_diff_changes_nothing(typo: Path) -> None:
    assert concise(typo, "--diff") == (1, DIFFERENCE, "launchlint: would fix 1 finding in 1 file\n")
    assert concise(typo, "--diff", "--fix") == concise(typo, "--diff")
    assert concise(typo, "--diff", "-q") == (1, "", "")
    assert (typo / TYPO).read_text(encoding="utf-8") == MISSPELT
    both = concise(typo, "--diff", "--unsafe-fixes")
    assert (both.status, both.errors) == (1, "launchlint: would fix 2 findings in 2 files\n")
    assert both.output.endswith(DIFFERENCE)
    assert concise(typo, "--diff", "demo/launch/double.launch") == (0, "", "launchlint: would fix nothing\n")


def test_standard_input(typo: Path) -> None:
    words = ("--stdin-filename", TYPO, "-")
    assert concise(typo, "--fix", *words, stdin=MISSPELT) == (0, REPAIRED, "launchlint: fixed 1 finding in 1 file\n")
    assert concise(typo, "--fix", *words, stdin=DOUBLE) == (1, DOUBLE, "launchlint: fixed nothing\n" + LEFT.replace("double", "typo"))
    assert concise(typo, "--diff", *words, stdin=MISSPELT).output == DIFFERENCE
    assert (typo / TYPO).read_text(encoding="utf-8") == MISSPELT


@pytest.mark.parametrize(
    "text",
    [
        b"\xef\xbb\xbf" + MISSPELT.replace("\n", "\r\n").encode(),
        b'<?xml version="1.0" encoding="iso-8859-15"?>\r<!-- \xa4 -->\n\n' + MISSPELT.encode().rstrip(),
        ('<?xml version="1.0" encoding="utf-16"?>' + MISSPELT.replace("<launch>", "<!-- \N{ROBOT FACE} --><launch>")).encode("utf-16"),
    ],
    ids=["mark and CRLF", "an old encoding and mixed line ends", "UTF-16"],
)
def test_no_other_byte_is_touched(text: bytes, typo: Path) -> None:
    (typo / TYPO).write_bytes(text)
    assert concise(typo, "--fix", TYPO).status == 0
    wrong, right = (word.encode("utf-16-le" if text.startswith(b"\xff\xfe") else "ascii") for word in ("respwan", "respawn"))
    assert (typo / TYPO).read_bytes() == text.replace(wrong, right)


UNTOUCHED = {
    "not well-formed": (1, MISSPELT.replace("</launch>", "")),
    "bytes that are no UTF-8": (1, b"<!-- \xff -->" + MISSPELT.encode()),
    "out of an entity": (
        0,
        "<!DOCTYPE launch [<!ENTITY n \"<node name='talker' pkg='demo' type='talk.py' respwan='true'/>\">]>\n<launch>\n&n;\n</launch>\n",
    ),
    "the right attribute is there too": (0, MISSPELT.replace("respwan", 'respawn="false" respwan')),
}


@pytest.mark.parametrize(("status", "text"), UNTOUCHED.values(), ids=UNTOUCHED.keys())
def test_files_that_are_left_alone(status: int, text: str | bytes, typo: Path) -> None:
    content = text if isinstance(text, bytes) else text.encode()
    (typo / TYPO).write_bytes(content)
    done = concise(typo, "--fix", TYPO)
    assert (done.status, done.errors) == (status, "launchlint: fixed nothing\n")
    assert (typo / TYPO).read_bytes() == content


def test_only_what_was_asked_for_is_changed(typo: Path) -> None:
    """Neither an included file that was not named, nor what a link leads to elsewhere."""
    outside = typo.parent / "outside.launch"
    outside.write_text(MISSPELT, encoding="utf-8")
    (typo / "demo/launch/link.launch").symlink_to(outside)
    write(typo, {"demo/launch/main.launch": '<launch>\n  <include file="$(find demo)/launch/typo.launch"/>\n</launch>\n'})
    found = "demo/launch/typo.launch:2:49: warning LL104 unknown-attribute: <node> has no attribute respwan\n"
    assert concise(typo, "--fix", "demo/launch/main.launch") == (0, found, "launchlint: fixed nothing\n")
    assert concise(typo, "--fix", "demo/launch/link.launch").errors == "launchlint: fixed nothing\n"
    assert concise(typo, "--diff", "demo/launch/link.launch").status == 0
    assert outside.read_text(encoding="utf-8") == MISSPELT


def test_only_what_has_changed_is_changed(typo: Path) -> None:
    """With --changed what is told concerns the files that are given, and may stand in others."""
    main = "demo/launch/main.launch"
    write(typo, {main: '<launch>\n  <include file="$(find demo)/launch/typo.launch"/>\n  <param nam="a" name="b" value="1"/>\n</launch>\n'})
    assert concise(typo, "--changed", "--fix", main).errors == "launchlint: fixed nothing\n"
    assert concise(typo, "--changed", "--fix", TYPO).errors == "launchlint: fixed 1 finding in 1 file\n"
    assert (typo / TYPO).read_text(encoding="utf-8") == REPAIRED


def test_a_link_inside_stays_one(typo: Path) -> None:
    (typo / "demo/launch/link.launch").symlink_to("typo.launch")
    assert concise(typo, "--fix", "demo/launch/link.launch").status == 0
    assert (typo / "demo/launch/link.launch").is_symlink()
    assert (typo / TYPO).read_text(encoding="utf-8") == REPAIRED


def test_a_fix_that_would_change_what_roslaunch_does(typo: Path) -> None:
    """The guard does not believe that the second declaration is the same: what is passed on differs."""
    text = (
        '<launch>\n  <node name="one" pkg="demo" type="talk.py">\n    <remap from="a" to="b"/>\n    <remap from="c" to="d"/>\n'
        '    <remap from="a" to="b"/>\n  </node>\n  <node if="false" name="two" pkg="demo" type="talk.py">\n'
        '    <remap from="x" to="x"/>\n  </node>\n</launch>\n'
    )
    write(typo, {TYPO: text})
    done = concise(typo, "--fix", TYPO)
    assert done.errors == (
        f"launchlint: not fixed: {TYPO}:7:5: LL605 remap-identity (remove it): no configuration shows what this does to the <node> under"
        " a condition that is never met, or of unknown name\nlaunchlint: fixed 1 finding in 1 file\n"
    )
    assert (typo / TYPO).read_text(encoding="utf-8") == text.replace('    <remap from="a" to="b"/>\n', "", 1)


def test_a_fix_that_brings_another_error(typo: Path) -> None:
    """The group would take effect, and with it a second node of the same name."""
    text = DOUBLE.replace("  <node", "  <grup><node", 1).replace("/>\n", "/></grup>\n", 1)
    write(typo, {TYPO: text})
    done = concise(typo, "--fix", TYPO)
    assert done.errors == (
        f"launchlint: not fixed: {TYPO}:2:4: LL103 unknown-tag (make it <group>): LL301 duplicate-node-name would be found in line 3 of"
        f" {TYPO}: two nodes are named /talker\nlaunchlint: fixed nothing\n"
    )
    assert (typo / TYPO).read_text(encoding="utf-8") == text


def test_callers_count(typo: Path) -> None:
    """An arg that is not read goes only where no launch file here passes it."""
    part = '<launch>\n  <arg name="speed" default="1"/>\n  <node name="talker" pkg="demo" type="talk.py"/>\n</launch>\n'
    call = '<launch>\n  <include file="$(dirname)/typo.launch">\n    <arg name="speed" value="2"/>\n  </include>\n</launch>\n'
    write(typo, {TYPO: part, "demo/launch/main.launch": call})
    words = ("--unsafe-fixes", "--select", "LL206", "--diff")
    assert concise(typo, *words).errors == "launchlint: would fix nothing\n"
    assert concise(typo, *words, TYPO).errors == "launchlint: would fix nothing\n"
    write(typo, {"demo/launch/main.launch": call.replace('name="speed"', 'name="sp&#101;ed"')})  # as nobody finds it who just reads
    assert concise(typo, *words).errors == (
        f"launchlint: not fixed: {TYPO}:2:14: LL206 unused-arg (remove the arg): LL403 include-undeclared-arg would be found in line 3 of"
        " demo/launch/main.launch: demo/launch/typo.launch does not declare the arg speed\nlaunchlint: would fix nothing\n"
    )
    assert concise(typo, *words, TYPO).errors == "launchlint: would fix 1 finding in 1 file\n"


def test_package_manifest(typo: Path) -> None:
    manifest = PACKAGE.format(name="demo").replace("</license>", "</license>\n  <exec_depend>rospy</exec_depend>\n")
    write(typo, {"demo/package.xml": manifest, TYPO: CLEAN.replace('pkg="demo" type="talk.py"', 'pkg="amcl" type="amcl"')})
    assert concise(typo, "--fix", TYPO) == (0, "", "launchlint: fixed 1 finding in 1 file\n")
    expected = manifest.replace("</exec_depend>", "</exec_depend>\n  <exec_depend>amcl</exec_depend>")
    assert (typo / "demo/package.xml").read_text(encoding="utf-8") == expected


def test_a_baseline_is_left_alone(typo: Path) -> None:
    assert concise(typo, "--write-baseline", "known.json").status == 0
    assert concise(typo, "--baseline", "known.json", "--fix") == (0, "", "launchlint: fixed nothing\n")
    assert (typo / TYPO).read_text(encoding="utf-8") == MISSPELT


def test_the_cache_knows_what_was_written(typo: Path) -> None:
    write(typo, {f"demo/launch/more{number}.launch": MISSPELT for number in range(30)})
    assert "has no attribute respwan (and at 30 more places)" in concise(typo).output
    assert concise(typo, "--fix") == (1, LEFT, "launchlint: fixed 31 findings in 31 files\n")
    assert concise(typo) == (1, LEFT, "")


def test_jobs_make_no_difference(typo: Path) -> None:
    write(typo, {f"demo/launch/more{number}.launch": MISSPELT for number in range(90)})
    shown = [concise(typo, "--diff", "--no-cache", "--jobs", jobs) for jobs in ("1", "2")]
    assert shown[0] == shown[1]
    assert shown[0].output.count("+++") == 91


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everything")
def test_a_write_protected_file(typo: Path) -> None:
    (typo / TYPO).chmod(0o444)
    done = concise(typo, "--fix")
    assert (done.status, done.errors.splitlines()[0]) == (2, f"launchlint: {str(typo / TYPO)!r} is left as it is: it is write-protected")


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (("--fix", "--staged"), "--fix changes files on disk, not what is staged of them; leave --staged out"),
        (("--unsafe-fixes", "--write-baseline", "b"), "--write-baseline records findings as they are; leave --unsafe-fixes out"),
        (("--diff", "--base", "HEAD"), "--diff repairs files, --base compares revisions; check twice"),
    ],
)
def test_what_does_not_go_together(words: tuple[str, ...], reason: str, typo: Path) -> None:
    done = run(typo, "check", *words)
    assert (done.status, done.output, done.errors) == (2, "", f"launchlint: {reason}\n")


def test_entries_are_not_repaired(typo: Path) -> None:
    write(typo, {"entries.yaml": f"- {TYPO}\n"})
    done = run(typo, "check", "--fix", "--entries", "entries.yaml", "--format", "jsonl")
    expected = "launchlint: --fix changes launch files where they are; --entries judges texts as if they stood elsewhere\n"
    assert (done.status, done.errors) == (2, expected)


@pytest.mark.parametrize(("padding", "attempts"), [("", 200), ("<!--" + "long " * 340_000 + "-->\n", 20)])
def test_attempts_are_bounded(padding: str, attempts: int, typo: Path) -> None:
    # Each attempt removes the last arg of the chain: only then nobody reads the one before.
    chain = "".join(f'  <arg name="a{number + 1}" default="$(arg a{number})"/>\n' for number in range(attempts + 5))
    write(typo, {"demo/launch/chain.launch": f'<launch>\n{padding}  <arg name="a0" default="1"/>\n{chain}</launch>\n'})
    gone = concise(typo, "--unsafe-fixes", "demo/launch/chain.launch")
    again = "run the command again to go on"
    assert gone.errors == f"launchlint: gave up after {attempts} attempts; {again}\nlaunchlint: fixed {attempts} findings in 1 file\n"
