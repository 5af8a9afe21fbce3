"""What counts as saying the same in XML."""

from __future__ import annotations

import pytest

from launchlint.fix.format.same import says_the_same

SAME = {
    "white space between elements": ("<launch><arg/></launch>", "<launch>\n  <arg/>\n</launch>\n"),
    "order of attributes, quotes, blanks in a tag": ("<launch a='1' b='2'/>", '<launch   b="2" a="1"></launch>'),
    "indentation in comments": ("<launch><!-- a\n      b --></launch>", "<launch><!-- a\n  b --></launch>"),
    "line ends": ("<launch>\n<rosparam>a\nb</rosparam></launch>", "<launch>\r\n<rosparam>a\r\nb</rosparam></launch>"),
    "the column of YAML": (
        "<launch><rosparam>\na: 1\n\nb: 2\n   </rosparam></launch>",
        "<launch><rosparam>\n  a: 1\n\n  b: 2\n</rosparam></launch>",
    ),
    "stray text": ("<launch>a\n    b</launch>", "<launch>\na b</launch>"),
}

DIFFERENT = {
    "a value": ('<launch><arg name="a b"/></launch>', '<launch><arg name="a  b"/></launch>'),
    "an attribute": ('<launch><arg name="a"/></launch>', "<launch><arg/></launch>"),
    "order of elements": ("<launch><a/><b/></launch>", "<launch><b/><a/></launch>"),
    "an element inside another": ("<launch><a/><b/></launch>", "<launch><a><b/></a></launch>"),
    "YAML": ("<launch><rosparam>\na:\n  - b</rosparam></launch>", "<launch><rosparam>\na:\n- b</rosparam></launch>"),
    "YAML that begins behind its tag": ("<launch><rosparam>a:\n b</rosparam></launch>", "<launch><rosparam>a:\nb</rosparam></launch>"),
    "YAML with a mark": ("<launch><rosparam>\n---\na: 1</rosparam></launch>", "<launch><rosparam>\n ---\n a: 1</rosparam></launch>"),
    "a text of several lines": ("<launch><rosparam>\na: |\n b</rosparam></launch>", "<launch><rosparam>\n a: |\n  b</rosparam></launch>"),
    "YAML, whatever the letter case": ("<launch><RosParam> a</RosParam></launch>", "<launch><RosParam>a</RosParam></launch>"),
    "an element inside YAML": ("<launch><rosparam><b> </b></rosparam></launch>", "<launch><rosparam><b/></rosparam></launch>"),
    "text that keeps its white space": ('<launch xml:space="preserve"> </launch>', '<launch xml:space="preserve"/>'),
    "words of stray text": ("<launch>a</launch>", "<launch>b</launch>"),
    "words of a comment": ("<launch><!-- a b --></launch>", "<launch><!-- a  b --></launch>"),
    "a comment": ("<launch><!-- a --></launch>", "<launch/>"),
    "place of a comment": ("<launch><!-- a --><b/></launch>", "<launch><b/><!-- a --></launch>"),
    "a processing instruction": ("<launch><?a b?></launch>", "<launch><?a c?></launch>"),
    "the declaration": ("<?xml version='1.0' encoding='utf-8'?><launch/>", "<launch/>"),
    "an entity": ("<!DOCTYPE l [<!ENTITY a 'x'>]><launch/>", "<!DOCTYPE l [<!ENTITY a 'y'>]><launch/>"),
}


@pytest.mark.parametrize(("before", "after"), SAME.values(), ids=SAME.keys())
def test_says_the_same(before: str, after: str) -> None:
    assert says_the_same(before.encode(), after.encode())


@pytest.mark.parametrize(("before", "after"), DIFFERENT.values(), ids=DIFFERENT.keys())
def test_says_something_else(before: str, after: str) -> None:
    assert not says_the_same(before.encode(), after.encode())
