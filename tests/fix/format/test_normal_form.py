"""What is written, and how it looks in normal form."""

from __future__ import annotations

from typing import NamedTuple

import pytest

from launchlint.fix.format.formatting import formatted
from launchlint.fix.format.style import Style


class Case(NamedTuple):
    """A text, its normal form, and the style where it is not the default; ␣ stands for a blank at the end of a line."""

    written: str
    expected: str
    style: Style = Style()


CASES = {
    "indentation, one element a line, self-closed empty elements": Case(
        """<launch><group   ns="a" ><node pkg="p" name="n" type="t"></node>
<node name="m" pkg="p" type="t">
</node></group></launch>""",
        """\
<launch>
  <group ns="a">
    <node name="n" pkg="p" type="t"/>
    <node name="m" pkg="p" type="t"/>
  </group>
</launch>
""",
    ),
    "canonical order: what the dialect knows, then the rest as written": Case(
        """<launch>
  <node zeta="1" output="screen" alpha="2" type="t" if="$(arg a)" pkg="p" name="n"/>
  <arg default="1" name="a"/>
  <rosparam file="a.yaml" command="load"/>
  <other b="1" a="2"/>
</launch>
""",
        """\
<launch>
  <node if="$(arg a)" name="n" pkg="p" type="t" output="screen" zeta="1" alpha="2"/>
  <arg name="a" default="1"/>
  <rosparam command="load" file="a.yaml"/>
  <other b="1" a="2"/>
</launch>
""",
    ),
    "attributes as written, where the project wants that": Case(
        '<launch><node type="t"   pkg="p" name="n"/></launch>',
        '<launch>\n  <node type="t" pkg="p" name="n"/>\n</launch>\n',
        Style(sort_attributes=False),
    ),
    "one attribute a line, where the tag is too long for one": Case(
        """<launch>
  <node pkg="a_package" type="a_type" name="a_name" args="something rather long"/>
  <node pkg="a_package" type="a_type" name="a_name" args="something rather long">
    <param name="a_long_parameter" value="of_some_length_indeed"/></node>
  <include file="only one attribute can never be broken over several lines"/>
</launch>
""",
        """\
<launch>
  <node name="a_name"
        pkg="a_package"
        type="a_type"
        args="something rather long"/>
  <node name="a_name"
        pkg="a_package"
        type="a_type"
        args="something rather long">
    <param name="a_long_parameter"
           value="of_some_length_indeed"/>
  </node>
  <include file="only one attribute can never be broken over several lines"/>
</launch>
""",
        Style(line_width=60),
    ),
    "tags that were broken by hand and fit": Case(
        '<launch>\n  <node name="n"\n        pkg="p"\n        type="t" />\n</launch>\n',
        '<launch>\n  <node name="n" pkg="p" type="t"/>\n</launch>\n',
    ),
    "line breaks inside a value stay": Case(
        '<launch><param name="p" value="a\n     b"/><arg\nname="x"\n/><arg doc="one\n two"/></launch>',
        """\
<launch>
  <param name="p"
         value="a
     b"/>
  <arg name="x"/>
  <arg doc="one
 two"/>
</launch>
""",
    ),
    "quotes": Case(
        """<launch><arg name='a' value = 'say "x"'/><arg name="b" value="it's &quot;&#x41;&quot;"/></launch>""",
        """<launch>\n  <arg name="a" value='say "x"'/>\n  <arg name="b" value="it's &quot;&#x41;&quot;"/>\n</launch>\n""",
    ),
    "blank lines: one at most, also at the ends of the file's element; none at the ends of others": Case(
        """

<launch>


  <arg name="a"/>


  <group>

    <arg name="b"/>

  </group>

</launch>


""",
        """\
<launch>

  <arg name="a"/>

  <group>
    <arg name="b"/>
  </group>

</launch>
""",
    ),
    "comments stay where they are": Case(
        """<!-- before --><launch><!-- at the root -->
<!-- own line -->
<arg name="a"/><!-- behind -->
<group> <!-- behind a start tag -->
      </group>   <!-- behind an end tag --> <!-- and another -->
<!-- in front --><arg name="b"/>
</launch> <!-- at the end -->
<!-- after -->""",
        """\
<!-- before -->
<launch> <!-- at the root -->
  <!-- own line -->
  <arg name="a"/> <!-- behind -->
  <group> <!-- behind a start tag -->
  </group> <!-- behind an end tag --> <!-- and another -->
  <!-- in front -->
  <arg name="b"/>
</launch> <!-- at the end -->
<!-- after -->
""",
    ),
    "comments of several lines are moved as they are": Case(
        """<launch>
        <!--
          <node pkg="p" type="t" name="n">
            <param name="a" value="1"/>␣␣␣
          </node>

        -->
      <!-- one
     two, which cannot go further to the left than this
three -->
  <arg name="a"/>     <!-- behind
                           and aligned with itself -->
</launch>
""",
        """\
<launch>
  <!--
    <node pkg="p" type="t" name="n">
      <param name="a" value="1"/>
    </node>

  -->
  <!-- one
     two, which cannot go further to the left than this
three -->
  <arg name="a"/> <!-- behind
                       and aligned with itself -->
</launch>
""",
    ),
    "comments that were aligned stay aligned": Case(
        """<launch>
  <arg name="a" />            <!-- one -->
  <arg name="long_name" />    <!-- two -->
  <arg name="b" />     <!-- three -->

  <arg name="c" />     <!-- four -->
</launch>
""",
        """\
<launch>
  <arg name="a"/>         <!-- one -->
  <arg name="long_name"/> <!-- two -->
  <arg name="b"/> <!-- three -->

  <arg name="c"/> <!-- four -->
</launch>
""",
    ),
    "attributes in columns stay in columns": Case(
        """<launch>
    <arg name="robot_ip"    value="$(arg robot_ip)" />  <!-- where -->
    <arg name="factor"      value='1'        doc="a"/>
    <arg name="x"           value="100"      doc="b"/>

    <arg name="y"           value="1"/>
    <param name="a"  type="int"   value="1"/>
    <!-- other columns -->
    <param name="a"      type="int"    value="1"/>
    <param name="long"   type="double" value="1"/>
    <param name="a"      value="1"     type="int"/>
    <param name="long"   value="1"     type="int"/>
</launch>
""",
        """\
<launch>
  <arg name="robot_ip" value="$(arg robot_ip)"/> <!-- where -->
  <arg name="factor"   value="1"   doc="a"/>
  <arg name="x"        value="100" doc="b"/>

  <arg name="y" value="1"/>
  <param name="a" type="int" value="1"/>
  <!-- other columns -->
  <param name="a"    type="int"    value="1"/>
  <param name="long" type="double" value="1"/>
  <param name="a" type="int" value="1"/>
  <param name="long" type="int" value="1"/>
</launch>
""",
    ),
    "columns that do not fit into a line": Case(
        """<launch>
  <arg name="a"                default="a_long_value"/>
  <arg name="a_long_long_name" default="1"/>
</launch>
""",
        """\
<launch>
  <arg name="a" default="a_long_value"/>
  <arg name="a_long_long_name" default="1"/>
</launch>
""",
        Style(line_width=50),
    ),
    "tabs": Case(
        "<launch>\n\t<!-- a\n\t\tb -->\n\t<group\tns='x'>\n\t\t<arg\tname='a'/>\t<!-- c -->\n\t</group>\n</launch>\n",
        '<launch>\n  <!-- a\n    b -->\n  <group ns="x">\n    <arg name="a"/> <!-- c -->\n  </group>\n</launch>\n',
    ),
    "YAML moves as a whole": Case(
        """<launch>
        <rosparam  param="a" >
  # left of the keys
    x: [1,
        2]␣␣␣

      # right
    y: "of
  two lines"
        </rosparam>
    <node name="n" pkg="p" type="t"><rosparam>
b: 2</rosparam></node>
</launch>
""",
        """\
<launch>
  <rosparam param="a">
    # left of the keys
      x: [1,
          2]␣␣␣

        # right
      y: "of
    two lines"
  </rosparam>
  <node name="n" pkg="p" type="t">
    <rosparam>
      b: 2</rosparam>
  </node>
</launch>
""",
    ),
    "YAML that its column says something of, and other text, stay byte for byte": Case(
        """<launch>
    <rosparam  param="a" >
  x: |
   text
        </rosparam>
    <rosparam  param="a" >
  text: >-
   folded
        </rosparam>
    <rosparam>
---
a: 1
    </rosparam>
    <rosparam subst_value="true">
a: $(arg b)
    </rosparam>
    <rosparam>
# far left
        a: 1
    </rosparam>
    <rosparam>
\ta: 1
    </rosparam>
    <rosparam>
a: &lt;
    </rosparam>
    <rosparam>a: 1
    </rosparam>
    <rosparam>
a: [1
    </rosparam>
    <rosparam><![CDATA[
a: 1
    ]]></rosparam>
    <rosparam> </rosparam><rosparam file="f" command="load"></rosparam>
    <node name="n" pkg="p" type="t"><RosParam>
a: 1</RosParam></node>
    <param name="p" >  text roslaunch never reads </param>
    <description><![CDATA[
  <launch>
]]></description>
    <group xml:space="preserve">  <arg name="a" />
</group>
</launch>
""",
        """\
<launch>
  <rosparam param="a">
  x: |
   text
        </rosparam>
  <rosparam param="a">
  text: >-
   folded
        </rosparam>
  <rosparam>
---
a: 1
    </rosparam>
  <rosparam subst_value="true">
a: $(arg b)
    </rosparam>
  <rosparam>
# far left
        a: 1
    </rosparam>
  <rosparam>
\ta: 1
    </rosparam>
  <rosparam>
a: &lt;
    </rosparam>
  <rosparam>a: 1
    </rosparam>
  <rosparam>
a: [1
    </rosparam>
  <rosparam><![CDATA[
a: 1
    ]]></rosparam>
  <rosparam> </rosparam>
  <rosparam command="load" file="f"/>
  <node name="n" pkg="p" type="t">
    <RosParam>
a: 1</RosParam>
  </node>
  <param name="p">  text roslaunch never reads </param>
  <description><![CDATA[
  <launch>
]]></description>
  <group xml:space="preserve">  <arg name="a" />
</group>
</launch>
""",
    ),
    "stray text, CDATA and references among elements": Case(
        """<!DOCTYPE launch [ <!ENTITY more '<arg name="a"/>'> ]>
<launch>
      some text
        of two lines<arg name="b"/>`
  &more;
  <![CDATA[ x ]]>
</launch>
""",
        """\
<!DOCTYPE launch [ <!ENTITY more '<arg name="a"/>'> ]>
<launch>
  some text
  of two lines
  <arg name="b"/> `
  &more;
  <![CDATA[ x ]]>
</launch>
""",
    ),
    "declaration, document type and processing instructions": Case(
        """<?xml version='1.0'  encoding="utf-8"?><?style   a="1"?>
<!DOCTYPE launch [
    <!-- > ]> -->
    <!ENTITY   a "]>'">
]  >
  <launch   ><?pi x
     y?></launch >""",
        """\
<?xml version='1.0'  encoding="utf-8"?> <?style   a="1"?>
<!DOCTYPE launch [
    <!-- > ]> -->
    <!ENTITY   a "]>'">
]  >
<launch> <?pi x
     y?>
</launch>
""",
    ),
    "format off and on": Case(
        """<launch>
      <!-- launchlint: format off: a table -->
  <param name="a"     value="1" />
  <param name="long"  value="2" />


      <!-- launchlint: format on -->
      <param name="b"     value="3" />
      <group>
      <!-- launchlint: format: off -->
          <arg   name="a"/>
            </group>
</launch>
""",
        """\
<launch>
  <!-- launchlint: format off: a table -->
  <param name="a"     value="1" />
  <param name="long"  value="2" />


      <!-- launchlint: format on -->
  <param name="b" value="3"/>
  <group>
    <!-- launchlint: format: off -->
          <arg   name="a"/>
            </group>
</launch>
""",
    ),
    "format off for the whole file": Case(
        "<!-- launchlint: format off -->\n\n\n<launch>\n <arg   name='a'/></launch>",
        "<!-- launchlint: format off -->\n\n\n<launch>\n <arg   name='a'/></launch>\n",
    ),
    "an on in another element ends nothing": Case(
        "<launch>\n<!-- launchlint: format off -->\n<group>\n<!-- launchlint: format on -->\n<arg   name='a'/>\n</group>\n</launch>\n",
        "<launch>\n  <!-- launchlint: format off -->\n<group>\n<!-- launchlint: format on -->\n<arg   name='a'/>\n</group>\n</launch>\n",
    ),
    "an empty file": Case("<launch   />", "<launch/>\n"),
    "another indentation": Case(
        "<launch>\n  <group>\n    <arg name='a'/>\n  </group>\n</launch>\n",
        '<launch>\n    <group>\n        <arg name="a"/>\n    </group>\n</launch>\n',
        Style(indent=4),
    ),
}


def data_of(text: str) -> bytes:
    return text.replace("␣", " ").encode()


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_normal_form(case: Case) -> None:
    result = formatted(data_of(case.written), "a.launch", case.style)
    assert (result.problem, result.refusal) == (None, "")
    assert result.data == data_of(case.expected)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_normal_form_is_its_own(case: Case) -> None:
    data = data_of(case.expected)
    assert formatted(data, "a.launch", case.style).data == data


ARG = '<launch>{0}  <arg name="é"/>{0}</launch>{0}'

ENCODED = {
    "CRLF stays": (b'<launch>\r\n<arg name="a"/>\n</launch>\r\n', b'<launch>\r\n  <arg name="a"/>\r\n</launch>\r\n'),
    "LF where most are": (b'<launch>\r\n<arg name="a"/>\n</launch>\n', b'<launch>\n  <arg name="a"/>\n</launch>\n'),
    "CR stays": (b'<launch>\r<arg name="a"/>\r</launch>\r', b'<launch>\r  <arg name="a"/>\r</launch>\r'),
    "byte order mark": ("\ufeff<launch>\n<arg name='é'/>\n</launch>".encode(), ("\ufeff" + ARG.format("\n")).encode()),
    "UTF-16": ("\ufeff<launch>\n<arg name='é'/>\n</launch>".encode("utf-16-le"), ("\ufeff" + ARG.format("\n")).encode("utf-16-le")),
    "Latin-1": (
        b"<?xml version='1.0' encoding='ISO-8859-1'?>\n<launch>\n<arg name='\xe9'/>\n</launch>\n",
        b"<?xml version='1.0' encoding='ISO-8859-1'?>\n<launch>\n  <arg name=\"\xe9\"/>\n</launch>\n",
    ),
    "an encoding that only Python knows": (
        "<?xml version='1.0' encoding='iso-8859-15'?>\n<launch>\n<arg name='€'/>\n</launch>\n".encode("iso-8859-15"),
        "<?xml version='1.0' encoding='iso-8859-15'?>\n<launch>\n  <arg name=\"€\"/>\n</launch>\n".encode("iso-8859-15"),
    ),
    "line ends of Unicode are no line ends": (
        "<launch>\n<!-- a\u2028  b\u0085 c -->\n</launch>\n".encode(),
        "<launch>\n  <!-- a\u2028  b\u0085 c -->\n</launch>\n".encode(),
    ),
    "blanks of Unicode are no white space": (
        '<launch>\u00a0<arg name="\u00a0"/></launch>\n'.encode(),
        '<launch> \u00a0\n  <arg name="\u00a0"/>\n</launch>\n'.encode(),
    ),
}


@pytest.mark.parametrize(("written", "expected"), ENCODED.values(), ids=ENCODED.keys())
def test_encoding_and_line_ends_stay(written: bytes, expected: bytes) -> None:
    assert formatted(written, "a.launch", Style()).data == expected


LEFT_ALONE = {
    "malformed-xml": b"<launch><arg></launch>",
    "root-not-launch": b"<robot><arg /></robot>",
    "unreadable-file": b"<!DOCTYPE a ["
    + b"".join(b'<!ENTITY e%d "&e%d;">' % (n, n - 1) for n in range(1, 60))
    + b"]><launch >&e59;</launch>",
}


@pytest.mark.parametrize(("kind", "data"), LEFT_ALONE.items())
def test_what_roslaunch_cannot_read_is_left_alone(kind: str, data: bytes) -> None:
    result = formatted(data, "a.launch", Style())
    assert result.data == data
    assert result.problem is not None
    assert result.problem.kind == kind


HUGE = {
    "indentation": "<launch>" + "<group>" * 980 + "<arg/>" * 10_000 + "</group>" * 980 + "</launch>",
    "comments of several lines behind each other": "<launch>" + "<!-- a\n -->" * 100_000 + "</launch>",
    "comments in one column": "<launch><a\nb='" + "x" * 10_000 + "'\n/><!-- -->\n" + "<a\n/><!-- -->\n" * 1_000 + "</launch>",
    "a long comment far out": "<launch>" + "<!-- a -->" * 1_000 + "<!--" + "\nx" * 100_000 + "--></launch>",
}


@pytest.mark.parametrize("text", HUGE.values(), ids=HUGE.keys())
def test_what_would_become_huge_is_left_alone(text: str) -> None:
    result = formatted(text.encode(), "a.launch", Style())
    assert result == (text.encode(), None, "its normal form would be far larger than the file")


def test_hundreds_of_levels_and_a_long_line_are_no_trouble() -> None:
    depth = 500
    text = "<launch>" + "<group>" * depth + "<!-- a -->" * 2000 + "</group>" * depth + "</launch>"
    result = formatted(text.encode(), "a.launch", Style()).data.decode()
    lines = result.splitlines()
    assert lines[0] == "<launch>"
    assert lines[depth] == "  " * depth + "<group> " + " ".join(["<!-- a -->"] * 2000)
    assert lines[-1] == "</launch>"
