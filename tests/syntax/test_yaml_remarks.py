"""Comments of launch files in YAML: what they cover."""

from __future__ import annotations

import time

from launchlint.source import Source
from launchlint.suppression import Suppression, read
from launchlint.syntax.yaml_remarks import remarks

TEXT = """\
# launchlint: ignore-file[LL201] the caller gives it
launch:
# launchlint: ignore[LL301] on purpose
- node:
    pkg: a
    exec: b  # launchlint: ignore[LL304] built later

    # launchlint: ignore
    param:
    - name: x
      value: 'y # no comment'
    name: c
- let: {name: d, value: e}
  # launchlint: ignore
"""


def suppressions(text: str) -> list[Suppression]:
    source = Source("a.launch.yaml", text)
    return read(source, remarks(source))


def covered(text: str) -> list[str | None]:
    return [None if each.covers is None else text[slice(*each.covers)] for each in suppressions(text)]


def test_what_comments_cover() -> None:
    node = TEXT[TEXT.index("- node") : TEXT.index("- let")].rstrip()
    param = "param:\n    - name: x\n      value: 'y # no comment'"
    assert covered(TEXT) == [None, node, "exec: b  # launchlint: ignore[LL304] built later", param, None]


def test_what_is_wrong_with_them() -> None:
    problems = [each.problem for each in suppressions(TEXT)]
    assert problems == ["", "", "", "", "no element follows it: it belongs right before the element it is about"]
    late = "launch:\n- let:\n    name: a\n# launchlint: ignore-file\n"
    assert [each.problem for each in suppressions(late)] == [
        "it stands below the first element: ignore-file belongs at the top of the file"
    ]


def test_whole_list_below_a_key_that_is_not_indented() -> None:
    assert covered("# launchlint: ignore\nlaunch:\n- a\n- b\n") == ["launch:\n- a\n- b"]


def test_many_comments_take_linear_time() -> None:
    text = "launch:\n" + "# launchlint: ignore\n- a: b\n" * 30_000
    start = time.process_time()
    assert len(remarks(Source("", text))) == 30_000
    assert time.process_time() - start < 3
