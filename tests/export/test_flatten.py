"""``export --flatten``: what goes in, and the whole file that comes out."""

from __future__ import annotations

from pathlib import Path

from tests.export.workspace import ROBOT, exported


def test_a_robot(tmp_path: Path) -> None:
    export = exported(tmp_path, ROBOT)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from robot.launch. -->

  <!-- The whole robot. -->

  <!-- wheels first -->
  <!-- from base/launch/base.launch -->
  <machine name="wheels" address="10.0.0.2" default="true" ssh-port="2222"/>
  <!-- limits & gains -->
  <rosparam param="r1/limits"><![CDATA[
    # metres per second
    linear: {max: 1.5}
    angular:
      max: 2 # < pi
  ]]></rosparam>
  <node name="wheels" pkg="base" type="wheels" ns="r1" args="--port /dev/r1 --if 'a &lt; b'">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="rate" type="int" value="10"/>
    <rosparam>{port: /dev/r1, frames: [odom, base]}</rosparam>
  </node>

  <!-- back in robot/launch/robot.launch -->
  <node name="planner" pkg="robot" type="plan.py" ns="r1" output="screen">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="verbose" value="true"/>
    <!-- the brain -->
    <remap from="goal" to="/goal"/>
    <param name="map" value="$(find robot)/maps/r1.yaml"/>
  </node>
  <node name="driver" pkg="robot" type="drive.py" respawn="true" launch-prefix="nice -n 5">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <param name="description" command="xacro '$(find robot)/robot.xacro'"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_the_side_that_is_taken_with_these_args(tmp_path: Path) -> None:
    export = exported(tmp_path, ROBOT, "name:=r2", "sim:=true")
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from robot.launch, started with name:=r2 sim:=true. -->

  <!-- The whole robot. -->

  <!-- wheels first -->
  <!-- from base/launch/base.launch -->
  <machine name="wheels" address="10.0.0.2" default="true" ssh-port="2222"/>
  <!-- limits & gains -->
  <rosparam param="r2/limits"><![CDATA[
    # metres per second
    linear: {max: 1.5}
    angular:
      max: 2 # < pi
  ]]></rosparam>
  <node name="wheels" pkg="base" type="wheels" ns="r2" args="--port /dev/r2 --if 'a &lt; b'">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="rate" type="int" value="10"/>
    <rosparam>{port: /dev/r2, frames: [odom, base]}</rosparam>
  </node>

  <!-- back in robot/launch/robot.launch -->
  <node name="planner" pkg="robot" type="plan.py" ns="r2" output="screen">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="verbose" value="true"/>
    <!-- the brain -->
    <remap from="goal" to="/goal"/>
    <param name="map" value="$(find robot)/maps/r2.yaml"/>
  </node>
  <node name="simulator" pkg="robot" type="sim.py">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <param name="description" command="xacro '$(find robot)/robot.xacro'"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_names_that_anon_makes_up_stay_apart(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <include file="$(dirname)/camera.launch"/>
  <include file="$(dirname)/camera.launch"/>
</launch>
""",
        "p/launch/camera.launch": """\
<launch>
  <node name="$(anon camera)" pkg="p" type="camera">
    <param name="frame" value="$(anon camera)"/>
  </node>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <!-- from p/launch/camera.launch -->
  <group>
    <node name="$(anon camera)" pkg="p" type="camera">
      <param name="frame" value="$(anon camera)"/>
    </node>
  </group>

  <!-- from p/launch/camera.launch -->
  <group>
    <node name="$(anon camera)" pkg="p" type="camera">
      <param name="frame" value="$(anon camera)"/>
    </node>
  </group>
</launch>
"""
    )
    assert export.fixed == ()


def test_steps_and_order(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <group ns="a" clear_params="true">
    <param name="x" value="1"/>
    <rosparam command="delete"/>
    <rosparam command="dump" file="$(find p)/dump.yaml" param="x"/>
    <group ns="/b"><rosparam param="y">[1, 2]</rosparam></group>
  </group>
  <param name="a/x" value="2"/>
  <param name="binary" binfile="$(find p)/package.xml"/>
  <test test-name="t" pkg="p" type="t.py" time-limit="5" retry="2"/>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <group ns="a" clear_params="true"/>
  <param name="a/x" value="1"/>
  <rosparam command="delete" param="a/"/>
  <rosparam command="dump" file="$(find p)/dump.yaml" param="a/x"/>
  <rosparam param="/b/y">[1, 2]</rosparam>
  <param name="a/x" value="2"/>
  <param name="binary" binfile="$(find p)/package.xml"/>
  <test test-name="t" pkg="p" type="t.py" time-limit="5" retry="2"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_settings_reach_what_follows_them_only(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <node name="before" pkg="p" type="t"/>
  <remap from="a" to="b"/>
  <param name="~rate" value="1"/>
  <group>
    <remap from="a" to="c"/>
    <env name="E" value="inner"/>
    <node name="inside" pkg="p" type="t">
      <param name="rate" value="2"/>
    </node>
  </group>
  <node name="after" pkg="p" type="t"/>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <node name="before" pkg="p" type="t"/>
  <node name="inside" pkg="p" type="t">
    <env name="E" value="inner"/>
    <remap from="a" to="c"/>
    <param name="rate" value="2"/>
  </node>
  <node name="after" pkg="p" type="t">
    <remap from="a" to="b"/>
    <param name="rate" value="1"/>
  </node>
</launch>
"""
    )
    assert export.fixed == ()


def test_what_the_environment_decides_when_it_is_started(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <arg name="robot" default="$(optenv ROBOT r1)"/>
  <group if="$(optenv SIM false)">
    <remap from="scan" to="sim/scan"/>
    <node name="simulator" pkg="p" type="t"/>
    <node name="view" pkg="p" type="t"/>
  </group>
  <node name="driver" pkg="p" type="t" args="$(arg robot)"/>
  <param name="address" value="$(eval arg('robot') + ':' + optenv('PORT', '80'))"/>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <group if="$(optenv SIM false)">
    <node name="simulator" pkg="p" type="t">
      <remap from="scan" to="sim/scan"/>
    </node>
    <node name="view" pkg="p" type="t">
      <remap from="scan" to="sim/scan"/>
    </node>
  </group>
  <node name="driver" pkg="p" type="t" args="$(optenv ROBOT r1)"/>
  <arg name="robot" value="$(optenv ROBOT r1)"/>

  <param name="address" value="$(eval arg('robot') + ':' + optenv('PORT', '80'))"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_an_include_that_the_environment_chooses(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <arg name="base" default="$(optenv BASE kobuki)"/>
  <include file="$(dirname)/$(arg base).launch"/>
  <node name="n" pkg="p" type="t" args="$(arg base)"/>
</launch>
""",
        "p/launch/kobuki.launch": """\
<launch>
  <param name="radius" value="0.18"/>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->
  <!-- Fixed: the environment variable BASE, not set here, since $(dirname)/$(arg base).launch decides which file is included -->

  <!-- from p/launch/kobuki.launch -->
  <param name="radius" value="0.18"/>

  <!-- back in p/launch/main.launch -->
  <node name="n" pkg="p" type="t" args="kobuki"/>
</launch>
"""
    )
    assert export.fixed == (
        "the environment variable BASE, not set here, since $(dirname)/$(arg base).launch decides which file is included",
    )


def test_hostile_text(tmp_path: Path) -> None:
    files = {
        "p/launch/--x$y.launch": """\
<launch>
  <node name="a" pkg="p" type="t" args="&lt;&amp;&quot;&#10;--&gt; ]]&gt;"/>
  <rosparam>a: "]]&gt; &lt;"</rosparam>
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from - -x$y.launch. -->

  <node name="a" pkg="p" type="t" args="&lt;&amp;&quot;&#10;--&gt; ]]&gt;"/>
  <rosparam>a: "]]&gt; &lt;"</rosparam>
</launch>
"""
    )
    assert export.fixed == ()


def test_comments(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <!-- stands alone -->

  <!-- goes with the arg -->
  <arg name="a" default="1"/> <!-- beside the arg -->
  <!-- goes with the node,
       in two lines -->
  <node name="n" pkg="p" type="t">
    <!-- goes with the param -->
    <param name="p" value="$(arg a)"/> <!-- metres -->
    <!-- goes with what is not there -->
    <param if="false" name="q" value="1"/>
  </node> <!-- beside the node -->

  <!-- not taken -->
  <group if="false">
    <!-- inside -->
    <node name="m" pkg="p" type="t"/>
  </group>
  <!-- at the end -->
</launch>
""",
    }
    export = exported(tmp_path, files)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <!-- stands alone -->

  <!-- goes with the node,
       in two lines -->
  <node name="n" pkg="p" type="t">
    <!-- goes with the param -->
    <param name="p" value="1"/> <!-- metres -->
  </node> <!-- beside the node -->

  <!-- at the end -->
</launch>
"""
    )
    assert export.fixed == ()
