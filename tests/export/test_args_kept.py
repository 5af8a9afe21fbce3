"""``export --flatten --args-kept``: one file whose args can still be given."""

from __future__ import annotations

from pathlib import Path

from tests.export.workspace import ROBOT, exported


def test_args_stay(tmp_path: Path) -> None:
    export = exported(tmp_path, ROBOT, args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from robot.launch. -->

  <!-- The whole robot. -->

  <arg name="name" default="r1" doc="namespace of the robot"/>
  <arg name="sim" default="false"/>

  <!-- wheels first -->
  <!-- from base/launch/base.launch -->
  <machine name="wheels" address="10.0.0.2" default="true" ssh-port="2222"/>
  <!-- limits & gains -->
  <rosparam param="$(arg name)/limits"><![CDATA[
    # metres per second
    linear: {max: 1.5}
    angular:
      max: 2 # < pi
  ]]></rosparam>
  <node name="wheels" pkg="base" type="wheels" ns="$(arg name)" args="--port /dev/$(arg name) --if 'a &lt; b'">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="rate" type="int" value="10"/>
    <rosparam subst_value="true">{port: /dev/$(arg name), frames: [odom, base]}</rosparam>
  </node>

  <!-- back in robot/launch/robot.launch -->
  <node name="planner" pkg="robot" type="plan.py" ns="$(arg name)" output="screen">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="verbose" value="true"/>
    <!-- the brain -->
    <remap from="goal" to="/goal"/>
    <param name="map" value="$(find robot)/maps/$(arg name).yaml"/>
  </node>
  <node if="$(arg sim)" name="simulator" pkg="robot" type="sim.py">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <node unless="$(arg sim)" name="driver" pkg="robot" type="drive.py" respawn="true" launch-prefix="nice -n 5">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <param name="description" command="xacro '$(find robot)/robot.xacro'"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_what_is_given_becomes_the_default(tmp_path: Path) -> None:
    export = exported(tmp_path, ROBOT, "name:=r2", args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from robot.launch, started with name:=r2. -->

  <!-- The whole robot. -->

  <arg name="name" default="r2" doc="namespace of the robot"/>
  <arg name="sim" default="false"/>

  <!-- wheels first -->
  <!-- from base/launch/base.launch -->
  <machine name="wheels" address="10.0.0.2" default="true" ssh-port="2222"/>
  <!-- limits & gains -->
  <rosparam param="$(arg name)/limits"><![CDATA[
    # metres per second
    linear: {max: 1.5}
    angular:
      max: 2 # < pi
  ]]></rosparam>
  <node name="wheels" pkg="base" type="wheels" ns="$(arg name)" args="--port /dev/$(arg name) --if 'a &lt; b'">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="rate" type="int" value="10"/>
    <rosparam subst_value="true">{port: /dev/$(arg name), frames: [odom, base]}</rosparam>
  </node>

  <!-- back in robot/launch/robot.launch -->
  <node name="planner" pkg="robot" type="plan.py" ns="$(arg name)" output="screen">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
    <param name="verbose" value="true"/>
    <!-- the brain -->
    <remap from="goal" to="/goal"/>
    <param name="map" value="$(find robot)/maps/$(arg name).yaml"/>
  </node>
  <node if="$(arg sim)" name="simulator" pkg="robot" type="sim.py">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <node unless="$(arg sim)" name="driver" pkg="robot" type="drive.py" respawn="true" launch-prefix="nice -n 5">
    <env name="LEVEL" value="$(optenv LEVEL info)"/>
    <remap from="scan" to="/scan"/>
  </node>
  <param name="description" command="xacro '$(find robot)/robot.xacro'"/>
</launch>
"""
    )
    assert export.fixed == ()


def test_expressions_of_included_files(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <arg name="mode" default="fast"/>
  <arg name="level" default="2"/>
  <include file="$(dirname)/inner.launch" ns="$(arg mode)">
    <arg name="mode" value="$(arg mode)_x"/>
    <arg name="l" value="$(arg level)"/>
    <arg name="c" value="7"/>
  </include>
</launch>
""",
        "p/launch/inner.launch": """\
<launch>
  <arg name="mode"/>
  <arg name="l"/>
  <arg name="c"/>
  <arg name="big" value="$(eval l &gt; c - 5)"/>
  <node if="$(eval mode == 'fast_x')" name="n" pkg="p" type="t" args="$(arg big) $(arg l)"/>
  <group unless="$(arg big)" ns="$(arg mode)">
    <node name="k" pkg="p" type="t"/>
    <param name="q" value="$(eval 2 * c)"/>
  </group>
</launch>
""",
    }
    export = exported(tmp_path, files, args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <arg name="mode" default="fast"/>
  <arg name="level" default="2"/>

  <!-- from p/launch/inner.launch -->
  <arg name="big" value="$(eval level &gt; 7 - 5)"/>
  <arg name="mode_2" value="$(arg mode)_x"/>

  <node if="$(eval mode_2 == 'fast_x')" name="n" pkg="p" type="t" ns="$(arg mode)" args="$(arg big) $(arg level)"/>
  <group unless="$(arg big)" ns="$(arg mode)">
    <node name="k" pkg="p" type="t" ns="$(arg mode_2)"/>
    <param name="$(arg mode_2)/q" value="14"/>
  </group>
</launch>
"""
    )
    assert export.fixed == ()


def test_both_sides_of_a_condition(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <arg name="debug" default="false"/>
  <arg if="$(arg debug)" name="prefix" value="gdb --args"/>
  <arg unless="$(arg debug)" name="prefix" value=""/>
  <remap if="$(arg debug)" from="log" to="debug_log"/>
  <include file="$(dirname)/inner.launch"><arg name="prefix" value="$(arg prefix)"/></include>
</launch>
""",
        "p/launch/inner.launch": """\
<launch>
  <arg name="prefix"/>
  <node name="n" pkg="p" type="t" launch-prefix="$(arg prefix)"/>
</launch>
""",
    }
    export = exported(tmp_path, files, args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <arg name="debug" default="false"/>
  <arg if="$(arg debug)" name="prefix" value="gdb --args"/>
  <arg unless="$(arg debug)" name="prefix" value=""/>

  <!-- from p/launch/inner.launch -->
  <node name="n" pkg="p" type="t" launch-prefix="$(arg prefix)">
    <remap if="$(arg debug)" from="log" to="debug_log"/>
  </node>
</launch>
"""
    )
    assert export.fixed == ()


def test_an_arg_that_chooses_a_file_is_fixed(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <arg name="robot" default="r1"/>
  <arg name="speed" default="1"/>
  <include file="$(dirname)/$(arg robot).launch"><arg name="speed" value="$(arg speed)"/></include>
</launch>
""",
        "p/launch/r1.launch": """\
<launch>
  <arg name="speed"/>
  <param name="speed" value="$(arg speed)"/>
</launch>
""",
    }
    export = exported(tmp_path, files, args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->
  <!-- Fixed: the arg robot, 'r1' here, since $(dirname)/$(arg robot).launch decides which file is included -->

  <arg name="robot" value="r1"/>
  <arg name="speed" default="1"/>

  <!-- from p/launch/r1.launch -->
  <param name="speed" value="$(arg speed)"/>
</launch>
"""
    )
    assert export.fixed == ("the arg robot, 'r1' here, since $(dirname)/$(arg robot).launch decides which file is included",)


def test_args_of_groups(tmp_path: Path) -> None:
    files = {
        "p/launch/main.launch": """\
<launch>
  <group>
    <arg name="port" default="1"/>
    <node name="a" pkg="p" type="t" args="$(arg port)"/>
  </group>
  <group>
    <arg name="port" default="2"/>
    <node name="b" pkg="p" type="t" args="$(arg port)"/>
  </group>
</launch>
""",
    }
    export = exported(tmp_path, files, args_kept=True)
    assert (
        export.data.decode()
        == """\
<launch>
  <!-- Flattened by launchlint from main.launch. -->

  <group>
    <arg name="port" default="1"/>

    <node name="a" pkg="p" type="t" args="$(arg port)"/>
  </group>
  <group>
    <arg name="port" default="2"/>

    <node name="b" pkg="p" type="t" args="$(arg port)"/>
  </group>
</launch>
"""
    )
    assert export.fixed == ()
