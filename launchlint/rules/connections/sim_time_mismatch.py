"""Simulated time is on without a clock, or a clock runs and simulated time is off.

What it does: it compares the param `/use_sim_time` with the publishers of `/clock`. It is a warning where `rosbag play --clock`
publishes the clock for other nodes of the launch and the param is not true, since nobody then listens to it. It is an info where the
param is true and nothing in the launch publishes the clock: people often start a bag or a simulator by hand. Simulators that set the
param themselves (Gazebo, Stage) do not count. All bags whose clock nobody uses are one finding.

In ROS 2 each node has a param `use_sim_time` of its own, and a bag is played by a program that launch starts: `ros2 bag play --clock`. It
is told where the params of all nodes are known; that some nodes have the param and others do not, LL943 tells.

## Why it matters

With `/use_sim_time` every node takes its time from `/clock`. Without a clock the time stays zero: timers do not fire, `sleep` never
returns, and tf has no transforms. With a clock and without the param the nodes live in the present while their data come from the past.

## Example

```xml
<launch>
  <node pkg="rosbag" type="play" name="player" args="--clock $(dirname)/drive.bag"/>
  <node pkg="gmapping" type="slam_gmapping" name="mapping"/>
</launch>
```

## Use instead

```xml
<launch>
  <param name="/use_sim_time" value="true"/>
  <node pkg="rosbag" type="play" name="player" args="--clock $(dirname)/drive.bag"/>
  <node pkg="gmapping" type="slam_gmapping" name="mapping"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.graph.connections import Endpoint, Instance
from launchlint.model import ROS2, Executable, ParameterSetting
from launchlint.rules.judging.name_places import owners
from launchlint.rules.judging.param_values import is_certain
from launchlint.rules.rule import Fine, Rule
from launchlint.rules.view import GraphView
from launchlint.rules.wording import words_at
from launchlint.source import Origin

RULE = Rule("LL619", "sim-time-mismatch", Severity.WARNING)

PARAM, CLOCK = "/use_sim_time", "/clock"
_PLAYER = "rosbag/play"
_OWN, _CLOCK_TYPE = "use_sim_time", "rosgraph_msgs/msg/Clock"


def check(view: GraphView) -> Iterator[Finding | Fine]:
    """Compare the param with the clock (ros::start, rospy.impl.simtime; rclcpp::TimeSource, rclpy.time_source)."""
    graph = view.graph
    if view.dialect.name == ROS2:
        yield from _of_ros2(view)
        return
    setting = graph.parameters.setting(PARAM)
    channel = graph.channels.get(("topic", CLOCK))
    clocks = [] if channel is None else channel.offers
    if setting is not None and setting.value is True:
        yield from _without_clock(setting, clocks, view)
    else:
        yield from _unused_clock(setting, clocks, view)


def _without_clock(setting: ParameterSetting, clocks: list[Endpoint], view: GraphView) -> Iterator[Finding | Fine]:
    graph = view.graph
    if clocks or not is_certain(setting):
        yield RULE.fine(setting.origin)
        known = view.once(owners)
        yield from (RULE.fine(_args(known[id(endpoint)])) for endpoint in clocks)
        return
    players = [instance for instance in graph.instances if instance.program == _PLAYER and instance.certain]
    others = [instance for instance in graph.instances if instance.program != _PLAYER]
    unsure = not graph.launch.complete or any(instance.may_have_more("publishers") for instance in others)
    if unsure or not others or not all(player.node.knows("arguments") for player in players):
        yield RULE.fine(setting.origin)
    elif players:
        player = players[0]
        yield RULE.at(
            _args(player),
            f"{PARAM} is true, and {player.name} plays its bag without --clock",
            severity=Severity.INFO,
            label="publishes no clock",
            related=((setting.origin.place, "set here"),),
            notes=("without a clock the time stays zero, unless the bag itself holds /clock",),
            help="add --clock to its args",
        )
    else:
        yield RULE.at(
            setting.origin,
            f"{PARAM} is true, and no node of this launch publishes {CLOCK}",
            severity=Severity.INFO,
            label="time stays zero without a clock",
            help="start what publishes the clock (rosbag play --clock, a simulator), or do not set the param here",
        )


def _args(player: Instance) -> Origin:
    """Where it is said how a bag is played."""
    return Origin(player.node.places.get("arguments", player.node.origin.place), player.node.origin.step)


def _unused_clock(setting: ParameterSetting | None, clocks: list[Endpoint], view: GraphView) -> Iterator[Finding]:
    graph = view.graph
    if setting is not None and (setting.value is not False or not is_certain(setting)):
        return
    if setting is None and not graph.launch.complete:
        return
    known = view.once(owners)
    others = [other for other in graph.instances if other.program != _PLAYER]
    if not others or any(known[id(endpoint)].program != _PLAYER for endpoint in clocks):
        return  # Gazebo (gazebo_ros_api_plugin) and Stage (stageros) set the param themselves
    for endpoint in clocks:
        instance = known[id(endpoint)]
        if not endpoint.certain:
            continue
        state = "not set" if setting is None else "false"
        yield RULE.at(
            _args(instance),
            f"{endpoint.node} publishes {CLOCK}, and {PARAM} is {state}: no node uses it",
            label="nobody uses this clock",
            related=() if setting is None else ((setting.origin.place, "set here"),),
            help='put <param name="/use_sim_time" value="true"/> above the nodes',
            cause=f"bags, {state}",
        )


def _of_ros2(view: GraphView) -> Iterator[Finding | Fine]:
    graph, launch = view.graph, view.launch
    players = [each for each in launch.programs if _plays_clock(each)]
    nodes = [each for each in launch.nodes if each.kind != "container"]
    unsure = not launch.complete or any(each.own is None for each in nodes) or not all(each.certain for each in graph.instances)
    simulated = [each for each in nodes if (each.own or {}).get(_OWN, ("", None))[1] is True]
    if players and nodes and not simulated and not unsure:
        tag = words_at(players[0].origin).written("set_parameter", {"name": _OWN, "value": "true"}, f"SetParameter('{_OWN}', True)")
        yield RULE.at(
            players[0].origin,
            f"ros2 bag play publishes {CLOCK}, and no node here has {_OWN}: none uses it",
            label="nobody uses this clock",
            help=f"put {tag} above the nodes",
        )
    else:
        yield from (RULE.fine(each.origin) for each in players)
    given = next((each.own_origins[_OWN] for each in simulated if _OWN in each.own_origins), None)
    if given is None:
        return
    channel = graph.channels.get(("topic", CLOCK))
    clock = launch.programs or (channel is not None and channel.offers) or graph.may_offer("topic", CLOCK, _CLOCK_TYPE)
    if unsure or clock:
        yield RULE.fine(given)
        return
    yield RULE.at(
        given,
        f"{_OWN} is true, and nothing in this launch publishes {CLOCK}",
        severity=Severity.INFO,
        label="time stays zero without a clock",
        help="start what publishes the clock (ros2 bag play --clock, a simulator and its bridge), or do not set the param here",
    )


def _plays_clock(program: Executable) -> bool:
    words = " ".join(program.command).split()
    return words[:3] == ["ros2", "bag", "play"] and any(word.partition("=")[0] == "--clock" for word in words)
