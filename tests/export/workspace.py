"""A small robot in a workspace of two packages, and the export of its files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from launchlint.evaluate.session import Session
from launchlint.export.flatten import Exported, flatten
from launchlint.fix.format.style import Style
from launchlint.workspace.packages import Packages

PACKAGE = (
    '<package format="2"><name>{name}</name><version>1.0.0</version><description>A demo.</description>'
    '<maintainer email="a@example.com">A</maintainer><license>MIT</license></package>\n'
)

ROBOT = {
    "robot/launch/robot.launch": """\
<?xml version="1.0"?>
<launch>
  <!-- The whole robot. -->

  <arg name="name" default="r1" doc="namespace of the robot"/>
  <arg name="sim" default="false"/>
  <arg name="rate" value="$(eval 2 * 5)"/>

  <!-- sensors talk about /scan -->
  <remap from="scan" to="/scan"/>
  <env name="LEVEL" value="$(optenv LEVEL info)"/>
  <group ns="$(arg name)">
    <!-- wheels first -->
    <include file="$(find base)/launch/base.launch">
      <arg name="port" value="/dev/$(arg name)"/>
      <arg name="rate" value="$(arg rate)"/>
    </include>
    <param name="~verbose" value="true"/>
    <node name="planner" pkg="robot" type="plan.py" output="screen"> <!-- the brain -->
      <remap from="goal" to="/goal"/>
      <param name="map" value="$(find robot)/maps/$(arg name).yaml"/>
    </node>
  </group>
  <node if="$(arg sim)" name="simulator" pkg="robot" type="sim.py"/>
  <node unless="$(arg sim)" name="driver" pkg="robot" type="drive.py" launch-prefix="nice -n 5" respawn="true"/>
  <param name="description" command="xacro '$(find robot)/robot.xacro'"/>
</launch>
""",
    "base/launch/base.launch": """\
<launch>
  <arg name="port"/>
  <arg name="rate" default="1"/>
  <machine name="wheels" address="10.0.0.2" ssh-port="2222" default="true"/>
  <!-- limits & gains -->
  <rosparam file="$(find base)/config/limits.yaml" ns="limits"/>
  <node name="wheels" pkg="base" type="wheels" args="--port $(arg port) --if 'a &lt; b'">
    <param name="rate" type="int" value="$(arg rate)"/>
    <rosparam subst_value="true">{port: $(arg port), frames: [odom, base]}</rosparam>
  </node>
</launch>
""",
    "base/config/limits.yaml": """\
# metres per second
linear: {max: 1.5}
angular:
  max: 2 # < pi
""",
}
"""A robot with its base, which another package starts."""


def workspace(directory: Path, files: Mapping[str, str]) -> None:
    """Write ``files`` below ``directory``; the first part of each name is its package."""
    for name, text in files.items():
        file = directory / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        package = Path(name).parts[0]
        (directory / package / "package.xml").write_text(PACKAGE.format(name=package), encoding="utf-8")


def session(directory: Path, environment: Mapping[str, str] | None = None) -> Session:
    """A session that sees the packages in ``directory`` and nothing of this machine."""
    variables = dict(environment or {})
    return Session(Packages([str(directory)], variables, explicit=True), variables, str(directory))


def exported(
    directory: Path, files: Mapping[str, str], *given: str, args_kept: bool = False, environment: Mapping[str, str] | None = None
) -> Exported:
    """The export of the first of ``files``, started with ``given``."""
    workspace(directory, files)
    pairs = tuple((name, value) for name, _, value in (word.partition(":=") for word in given))
    return flatten(session(directory, environment), str(directory / next(iter(files))), pairs, Style(), args_kept=args_kept)
