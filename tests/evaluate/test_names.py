"""Graph names as roslaunch joins and checks them: what is expected here, and what rosgraph itself says of the same names."""

from __future__ import annotations

import json
import subprocess

import pytest

from launchlint.evaluate import names

JOINED = {
    ("", ""): "",
    ("", "a"): "a",
    ("a", ""): "a/",
    ("a", "b"): "a/b",
    ("a/", "b"): "a/b",
    ("/", "a"): "/a",
    ("/a", "b/c"): "/a/b/c",
    ("a", "/b"): "/b",
    ("a", "~b"): "~b",
    ("~", "a"): "~a",
    ("~", ""): "~",
    ("~a", "b"): "~a/b",
    ("", "/"): "/",
    ("a", "/"): "/",
    ("a", "~"): "~",
}
CANONICAL = {
    "": "",
    "/": "/",
    "a": "a",
    "/a": "/a",
    "a/": "a",
    "//a//b/": "/a/b",
    "a//b": "a/b",
    "~a//b/": "~a/b",
    "//": "/",
    "~": "~",
    "-a//b/": "-a/b",
}
NAMESPACES = {"": "/", "/": "/", "a": "/a/", "/a": "/a/", "a/": "/a/", "/a/": "/a/", "a/b": "/a/b/"}
LEGAL = {
    "": (True, True),
    "a": (True, True),
    "/": (True, True),
    "~": (True, True),
    "~a": (True, True),
    "/a/b_1": (True, True),
    "a/": (True, True),
    "Z9": (True, True),
    "é": (False, False),
    "aé": (True, False),
    "9a": (False, False),
    "_a": (False, False),
    "a b": (False, False),
    "a//b": (False, False),
    "//": (False, False),
    "a-b": (False, False),
    "a\n": (False, False),
    "~~a": (False, False),
    "a~b": (False, False),
}
CHILDREN = {
    ("/", None): "/",
    ("/", ""): "/",
    ("/", "a"): "/a/",
    ("/a/", "b"): "/a/b/",
    ("/a/", "/b"): "/b/",
    ("/a", "b/"): "/a/b/",
    ("a", "b"): "/a/b/",
    ("/a/", "-b"): "/a/-b/",
}
ASKED = """
import json, sys, warnings
warnings.simplefilter("ignore")
from rosgraph import names
joined, canonical, namespaces, legal = json.load(sys.stdin)
print(json.dumps([
    [names.ns_join(*each) for each in joined], [names.canonicalize_name(each) for each in canonical],
    [names.make_global_ns(each) for each in namespaces], [bool(names.is_legal_name(each)) for each in legal],
]))
"""


def test_names_are_joined_checked_and_made_global() -> None:
    assert {each: names.join(*each) for each in JOINED} == JOINED
    assert {each: names.canonical(each) for each in CANONICAL} == CANONICAL
    assert {each: names.as_namespace(each) for each in NAMESPACES} == NAMESPACES
    assert {each: (names.is_legal(each), names.is_portable(each)) for each in LEGAL} == LEGAL
    assert {each: names.child_namespace(*each) for each in CHILDREN} == CHILDREN


@pytest.mark.parametrize("name", ["~", "~a"])
def test_a_private_name_is_no_namespace(name: str) -> None:
    with pytest.raises(ValueError, match=f"^the private name {name} cannot be a namespace$"):
        names.as_namespace(name)
    with pytest.raises(ValueError, match="private name"):
        names.child_namespace("/a/", name)


@pytest.mark.ros
def test_rosgraph_says_the_same(ros_python: str) -> None:
    asked = json.dumps([list(JOINED), list(CANONICAL), list(NAMESPACES), list(LEGAL)])
    run = subprocess.run([ros_python, "-c", ASKED], input=asked, capture_output=True, text=True, check=True)
    legal = [either for either, _ in LEGAL.values()]
    assert json.loads(run.stdout) == [list(JOINED.values()), list(CANONICAL.values()), list(NAMESPACES.values()), legal]
