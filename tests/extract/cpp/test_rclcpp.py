"""What small programs and components of rclcpp make, spelled line by line beside their sources."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.extract.cpp import cpp_program
from launchlint.extract.entries import ROS2, variant_of
from launchlint.extract.fact import Doubt, Fact, Made, Qos
from tests.extract.cpp.following import lines

HEAD = '#include "rclcpp/rclcpp.hpp"\n#include "std_msgs/msg/string.hpp"\n#include "std_srvs/srv/trigger.hpp"\n'


def follow(
    root: Path, source: str, entry: str | None = None, parameters: tuple[str, ...] = ()
) -> tuple[tuple[Fact, ...], tuple[Doubt, ...], tuple[Made, ...]]:
    """What is found in one source."""
    (root / "main.cpp").write_text(source)
    client = "component" if entry else "rclcpp"
    return cpp_program([str(root / "main.cpp")], [], str(root), entry, client=client, parameters=parameters)


def spelled(fact: Fact) -> str:
    """One fact on one line."""
    parts = [fact.category, fact.name, fact.type or fact.value_type or "-"]
    parts += [f"node={fact.node}"] if fact.node else []
    parts += [fact.role] if fact.role else []
    parts += [_qos(fact.qos)] if fact.qos is not None else []
    parts += [f"default={fact.default!r}"] if fact.default is not None else []
    parts += ["declared"] if fact.declared else []
    parts += [f"exists={fact.exists}"] if fact.exists else []
    parts += [f"when={fact.when}"] if fact.when != "start" else []
    parts += [f"if {fact.condition}"] if fact.condition else []
    return " ".join(parts)


def _qos(qos: Qos) -> str:
    said = [str(value) for value in qos[:-1] if value is not None]
    return "/".join([*said, *(["overrides"] if qos.overrides else [])])


def node(body: str, more: str = "") -> str:
    """A program with one node, with ``body`` in its constructor."""
    return f"""{HEAD}
class Talker : public rclcpp::Node {{
 public:
  Talker() : Node("talker") {{
{body}
  }}
{more}
}};
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
  rclcpp::shutdown();
  return 0;
}}
"""


INTERFACES = {
    "a publisher with a depth": (
        'pub_ = create_publisher<std_msgs::msg::String>("chatter", 7);',
        "publishers chatter std_msgs/msg/String reliable/volatile/keep_last/7",
    ),
    "with a chain": (
        'this->create_publisher<std_msgs::msg::String>("/map", rclcpp::QoS(rclcpp::KeepLast(1)).transient_local().reliable());',
        "publishers /map std_msgs/msg/String reliable/transient_local/keep_last/1",
    ),
    "with a profile that is changed bit by bit": (
        (
            "rclcpp::QoS qos(3); qos.best_effort().durability_volatile(); auto other = qos; other.reliable();"
            ' create_publisher<std_msgs::msg::String>("a", qos); create_publisher<std_msgs::msg::String>("b", other);'
        ),
        """
        publishers a std_msgs/msg/String best_effort/volatile/keep_last/3
        publishers b std_msgs/msg/String reliable/volatile/keep_last/3
        """,
    ),
    "with profiles of rmw": (
        (
            "auto p = rmw_qos_profile_sensor_data; p.depth = 2;"
            ' create_publisher<std_msgs::msg::String>("a", rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(p), p));'
            ' create_publisher<std_msgs::msg::String>("b", rclcpp::SystemDefaultsQoS());'
            ' create_publisher<std_msgs::msg::String>("c", rclcpp::SensorDataQoS().keep_last(9));'
            ' create_publisher<std_msgs::msg::String>("d", rclcpp::QoS(rclcpp::KeepAll()));'
        ),
        """
        publishers a std_msgs/msg/String best_effort/volatile/keep_last/2
        publishers b std_msgs/msg/String system_default/system_default/system_default/system_default
        publishers c std_msgs/msg/String best_effort/volatile/keep_last/9
        publishers d std_msgs/msg/String reliable/volatile/keep_all
        """,
    ),
    "with a profile that depends on something": (
        (
            'auto qos = rclcpp::QoS(1); if (declare_parameter("best_effort", false)) qos.best_effort(); else qos.reliable();'
            ' create_publisher<std_msgs::msg::String>("a", qos);'
        ),
        """
        params ~best_effort bool default=False declared
        publishers a std_msgs/msg/String volatile/keep_last/1
        """,
    ),
    "with what is not known": ('create_publisher<std_msgs::msg::String>("a", qos_of(x));', "publishers a std_msgs/msg/String"),
    "with overrides": (
        (
            "rclcpp::PublisherOptions o; o.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();"
            ' create_publisher<std_msgs::msg::String>("a", 1, o);'
        ),
        "publishers a std_msgs/msg/String reliable/volatile/keep_last/1/overrides",
    ),
    "a subscription, a lambda in it": (
        (
            'create_subscription<std_msgs::msg::String>("~/in", rclcpp::SensorDataQoS(), [this](std_msgs::msg::String::SharedPtr m) {'
            ' create_publisher<std_msgs::msg::String>("late", 1); });'
        ),
        """
        publishers late std_msgs/msg/String reliable/volatile/keep_last/1 when=message
        subscribers ~in std_msgs/msg/String best_effort/volatile/keep_last/5
        """,
    ),
    "services, clients, timers": (
        (
            'create_service<std_srvs::srv::Trigger>("reset", cb); create_client<std_srvs::srv::Trigger>("/other/reset");'
            ' create_wall_timer(1s, [this]() { create_client<std_srvs::srv::Trigger>("tick"); });'
        ),
        """
        clients /other/reset std_srvs/srv/Trigger
        clients tick std_srvs/srv/Trigger
        services reset std_srvs/srv/Trigger
        """,
    ),
    "actions": (
        (
            'rclcpp_action::create_server<example::action::Fibonacci>(this, "fibonacci", a, b, c);'
            " rclcpp_action::create_client<example::action::Fibonacci>(get_node_base_interface(), get_node_graph_interface(),"
            ' get_node_logging_interface(), get_node_waitables_interface(), "other");'
        ),
        """
        actions fibonacci example/action/Fibonacci server
        actions other example/action/Fibonacci client
        """,
    ),
    "types by other names": (
        'using Text = std_msgs::msg::String; using namespace std_srvs::srv; create_publisher<Text>("a", 1); create_client<Trigger>("b");',
        """
        clients b std_srvs/srv/Trigger
        publishers a std_msgs/msg/String reliable/volatile/keep_last/1
        """,
    ),
    "generic ones": (
        'create_generic_publisher("a", "std_msgs/msg/String", 1); create_generic_subscription("b", type, 1, cb);',
        """
        publishers a std_msgs/msg/String reliable/volatile/keep_last/1
        subscribers b * reliable/volatile/keep_last/1
        """,
    ),
    "a name from a param": (
        (
            'auto topic = declare_parameter<std::string>("topic", "scan"); create_publisher<std_msgs::msg::String>(topic, 1);'
            ' declare_parameter("size", 5); create_publisher<std_msgs::msg::String>("~/x", get_parameter("size").as_int());'
        ),
        """
        params ~size integer default=5 declared
        params ~size -
        params ~topic string default='scan' declared
        publishers {param:~topic|scan} std_msgs/msg/String reliable/volatile/keep_last/1
        publishers ~x std_msgs/msg/String reliable/volatile/keep_last/{param:~size|5}
        """,
    ),
    "a name from a param whose default is a constant of elsewhere": (
        'create_publisher<std_msgs::msg::String>(declare_parameter<std::string>("topic", elsewhere::TOPIC), 1);',
        """
        params ~topic string declared
        publishers {param:~topic|{any}} std_msgs/msg/String reliable/volatile/keep_last/1
        """,
    ),
    "a param read into a variable": (
        (
            'std::string name; declare_parameter("name", rclcpp::PARAMETER_STRING); get_parameter("name", name);'
            ' double rate; get_parameter_or("rate", rate, 2.0); create_client<std_srvs::srv::Trigger>(name + "/go");'
        ),
        """
        clients {param:~name}/go std_srvs/srv/Trigger
        params ~name string
        params ~name string declared
        params ~rate double default=2.0
        """,
    ),
    "params of many types": (
        (
            'declare_parameter("a", true); declare_parameter<int>("b", 1); declare_parameter("c", std::vector<double>{1.0, 2.0});'
            ' declare_parameter("d.e", rclcpp::ParameterValue("x")); declare_parameters<int>("f", {{"g", 1}, {"h", 2}});'
            ' declare_parameter<std::vector<std::string>>("i");'
        ),
        """
        params ~a bool default=True declared
        params ~b integer default=1 declared
        params ~c double_array default=[1.0, 2.0] declared
        params ~d.e string default='x' declared
        params ~f.g integer default=1 declared
        params ~f.h integer default=2 declared
        params ~i string_array declared
        """,
    ),
    "a default for a param that is declared does not count": (
        (
            'declare_parameter("scan", "front"); std::string scan; get_parameter_or<std::string>("scan", scan, "back");'
            " create_publisher<std_msgs::msg::String>(scan, 1);"
        ),
        """
        params ~scan string default='front' declared
        params ~scan string
        publishers {param:~scan|front} std_msgs/msg/String reliable/volatile/keep_last/1
        """,
    ),
    "lists whose type is said, and not by their items": (
        (
            'declare_parameter("a", std::vector<double>{0, 1}); std::vector<double> list = {0, 2}; declare_parameter("b", list);'
            ' declare_parameter<std::vector<double>>("c", {0, 3}); declare_parameter("d", std::vector<int64_t>{0});'
        ),
        """
        params ~a double_array default=[0.0, 1.0] declared
        params ~b double_array default=[0.0, 2.0] declared
        params ~c double_array default=[0.0, 3.0] declared
        params ~d integer_array default=[0] declared
        """,
    ),
    "policies as numbers, and by their names": (
        (
            'int number = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT; number = declare_parameter("number", number);'
            ' create_publisher<std_msgs::msg::String>("a", rclcpp::QoS(1).reliability((rmw_qos_reliability_policy_t)number));'
            ' auto word = rmw_qos_durability_policy_from_str(declare_parameter("word", "volatile").c_str());'
            ' create_publisher<std_msgs::msg::String>("b", rclcpp::QoS(1).durability(word));'
        ),
        """
        params ~number integer default=2 declared
        params ~word string default='volatile' declared
        publishers a std_msgs/msg/String volatile/keep_last/1
        publishers b std_msgs/msg/String reliable/{param:~word|volatile}/keep_last/1
        """,
    ),
    "a text that is filled in": (
        'declare_parameter(fmt::format("a.{}.{}", "b", name), 1); create_client<std_srvs::srv::Trigger>(std::format("{1}/{0}", "x", "y"));',
        """
        clients y/x std_srvs/srv/Trigger
        params ~a.b.{any} integer default=1 declared
        """,
    ),
    "a sub-node": (
        (
            'auto sub = create_sub_node("left"); sub->create_publisher<std_msgs::msg::String>("a", 1);'
            ' sub->create_publisher<std_msgs::msg::String>("/b", 1); sub->declare_parameter("c", 1);'
        ),
        """
        params ~c integer default=1 declared
        publishers /b std_msgs/msg/String reliable/volatile/keep_last/1
        publishers left/a std_msgs/msg/String reliable/volatile/keep_last/1
        """,
    ),
    "frames": (
        (
            "tf_ = std::make_shared<tf2_ros::Buffer>(get_clock()); l_ = std::make_shared<tf2_ros::TransformListener>(*tf_);"
            " b_ = std::make_unique<tf2_ros::TransformBroadcaster>(*this);"
            " s_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>(this);"
        ),
        """
        publishers /tf tf2_msgs/msg/TFMessage reliable/volatile/keep_last/100
        publishers /tf_static tf2_msgs/msg/TFMessage reliable/transient_local/keep_last/1
        subscribers /tf tf2_msgs/msg/TFMessage reliable/volatile/keep_last/100
        subscribers /tf_static tf2_msgs/msg/TFMessage reliable/transient_local/keep_last/100
        """,
    ),
    "images": (
        'image_transport::create_camera_publisher(this, "image", rmw_qos_profile_sensor_data);',
        """
        publishers image sensor_msgs/msg/Image best_effort/volatile/keep_last/5
        publishers {parent:image}/camera_info sensor_msgs/msg/CameraInfo best_effort/volatile/keep_last/5
        """,
    ),
    "diagnostics": (
        "diagnostic_updater::Updater updater(this);",
        """
        params ~diagnostic_updater.period double default=1.0 declared
        params ~diagnostic_updater.use_fqn bool default=False declared
        publishers /diagnostics diagnostic_msgs/msg/DiagnosticArray reliable/volatile/keep_last/1
        """,
    ),
    "a filter": (
        'sub_.subscribe(this, "scan", rmw_qos_profile_sensor_data);',
        "subscribers scan sensor_msgs/msg/LaserScan best_effort/volatile/keep_last/5",
    ),
    "params of another node": (
        'client_ = std::make_shared<rclcpp::SyncParametersClient>(this, "map_server");',
        """
        clients map_server/describe_parameters rcl_interfaces/srv/DescribeParameters
        clients map_server/get_parameter_types rcl_interfaces/srv/GetParameterTypes
        clients map_server/get_parameters rcl_interfaces/srv/GetParameters
        clients map_server/list_parameters rcl_interfaces/srv/ListParameters
        clients map_server/set_parameters rcl_interfaces/srv/SetParameters
        clients map_server/set_parameters_atomically rcl_interfaces/srv/SetParametersAtomically
        """,
    ),
}


@pytest.mark.parametrize("name", INTERFACES)
def test_interfaces(name: str, tmp_path: Path) -> None:
    body, expected = INTERFACES[name]
    more = "message_filters::Subscriber<sensor_msgs::msg::LaserScan> sub_;" if name == "a filter" else ""
    facts, doubts, nodes = follow(tmp_path, node(body, more))
    assert [spelled(each) for each in facts] == lines(expected)
    open_ = ["params"] if name == "images" else ["publishers"] if name.endswith("a constant of elsewhere") else []
    assert [each.category for each in doubts] == open_
    assert [(each.name, each.key) for each in nodes] == [("talker", "")]


def test_several_nodes_of_one_program(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(
        tmp_path,
        f"""{HEAD}
struct Helper {{
  Helper(rclcpp::Node::SharedPtr node, const std::string & name) {{ node->create_publisher<std_msgs::msg::String>(name, 1); }}
}};
int main(int argc, char ** argv) {{
  auto first = rclcpp::Node::make_shared("first", "/ns");
  rclcpp::NodeOptions options;
  options.allow_undeclared_parameters(true);
  auto second = std::make_shared<rclcpp::Node>("second", options);
  Helper a(first, "a"), b(second, "b");
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(first);
  executor.add_node(second->get_node_base_interface());
  executor.spin();
}}
""",
    )
    assert [spelled(each) for each in facts] == lines("""
        publishers a std_msgs/msg/String reliable/volatile/keep_last/1
        publishers b std_msgs/msg/String node=2 reliable/volatile/keep_last/1
    """)
    assert doubts == ()
    assert [(each.key, each.name, each.namespace, each.undeclared) for each in nodes] == [
        ("", "first", "/ns", False),
        ("2", "second", "", True),
    ]
    variant, unresolved = variant_of(facts, doubts, "", ROS2, nodes)
    assert (variant["node"], variant["namespace"], variant["undeclared"], unresolved) == ("first", "/ns", True, 0)
    assert [each.get("node") for each in variant["publishers"]] == [None, "second"]


def test_a_node_whose_loggers_can_be_asked_serves_that(tmp_path: Path) -> None:
    source = f"""{HEAD}
int main(int argc, char ** argv) {{
  rclcpp::init(argc, argv);
  auto quiet = std::make_shared<rclcpp::Node>("quiet", rclcpp::NodeOptions().enable_logger_service(false));
  auto asked = std::make_shared<rclcpp::Node>("asked", "ns", rclcpp::NodeOptions().enable_logger_service(true));
  rclcpp::spin(asked);
  return 0;
}}
"""
    facts, doubts, nodes = follow(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [
        f"services ~get_logger_levels rcl_interfaces/srv/GetLoggerLevels node={nodes[1].key}",
        f"services ~set_logger_levels rcl_interfaces/srv/SetLoggerLevels node={nodes[1].key}",
    ]
    assert doubts == ()


def test_a_node_that_its_options_move_lies_below_the_first_one(tmp_path: Path) -> None:
    """As the costmaps of navigation lie in a namespace of their own."""
    facts, _, nodes = follow(
        tmp_path,
        f"""{HEAD}
struct Inner : rclcpp::Node {{
  Inner(const std::string & name, const std::string & space)
  : Node(name, "", rclcpp::NodeOptions().arguments({{
      "--ros-args", "-r", std::string("__ns:=") + space, "-r", name + ":__node:=" + name}}))
  {{ create_publisher<std_msgs::msg::String>("map", 1); create_publisher<std_msgs::msg::String>("/all", 1); }}
}};
struct Outer : rclcpp::Node {{
  Outer() : Node("outer")
  {{
    std::string own = get_namespace();
    std::string space = own.back() == '/' ? own + "inner" : own + "/" + "inner";
    inner_ = std::make_shared<Inner>("inner", space);
    other_ = std::make_shared<Inner>("other", get_parameter("where").as_string());
    create_publisher<std_msgs::msg::String>("map", 1);
  }}
  std::shared_ptr<Inner> inner_, other_;
}};
int main() {{ rclcpp::spin(std::make_shared<Outer>()); }}
""",
    )
    published = sorted((each.name, each.node) for each in facts if each.category == "publishers")
    assert [(each.key, each.name, each.namespace) for each in nodes] == [
        ("", "outer", ""),
        ("2", "inner", "inner"),
        ("3", "other", "{param:~where}"),
    ]
    assert published == [("/all", "2"), ("/all", "3"), ("inner/map", "2"), ("map", ""), ("{param:~where}/map", "3")]


def test_every_object_that_is_a_node_has_its_names(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(
        tmp_path,
        f"""{HEAD}
struct Client : rclcpp::Node {{
  static const std::string kEnd;
  Client(const std::string & name, const std::string & of) : Node(name), of_(of) {{}}
  void init() {{ create_client<std_srvs::srv::Trigger>(of_ + kEnd); }}
  std::string of_;
}};
const std::string Client::kEnd = "/go";
int main() {{
  std::map<std::string, std::shared_ptr<Client>> all;
  all["a"] = std::make_shared<Client>("a_client", "a");
  all["b"] = std::make_shared<Client>("b_client", "b");
  for (auto & each : all) {{ each.second->init(); }}
  spin(all["a"]);
}}
""",
    )
    assert [(each.name, each.node) for each in facts] == [("a/go", ""), ("b/go", "2")]
    assert doubts == ()
    assert [each.name for each in nodes] == ["a_client", "b_client"]


EACH = f"""{HEAD}
class Fleet : public rclcpp::Node {{
 public:
  Fleet() : Node("fleet") {{
    auto topics = declare_parameter<std::vector<std::string>>("topics", {{"left", "right"}});
    for (const auto & topic : topics) {{ create_publisher<std_msgs::msg::String>(topic, 1); }}
    declare_parameter("robots", std::vector<std::string>{{}});
    std::vector<std::string> robots;
    get_parameter("robots", robots);
    for (const std::string & robot : robots) {{
      declare_parameter(robot + ".speed", 1.0);
      for (const auto & topic : topics) {{ create_publisher<std_msgs::msg::String>(robot + "/" + topic, 1); }}
    }}
    auto more = get_parameter("robots").as_string_array();
    for (size_t i = 0; i < more.size(); ++i) {{ create_client<std_srvs::srv::Trigger>(more[i] + "/go"); }}
    create_publisher<std_msgs::msg::String>(more[0] + "/first", 1);
  }}
}};
int main() {{ rclcpp::spin(std::make_shared<Fleet>()); }}
"""


def test_there_is_one_name_for_each_value_of_a_param(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(tmp_path, EACH)
    variant, _ = variant_of(facts, doubts, "", ROS2, nodes)
    two, some = {"param": "~topics", "default": ["left", "right"]}, {"param": "~robots", "default": []}
    assert {each["name"]: each.get("each") for each in variant["publishers"]} == {"{each}": two, "{any}/first": None, "{any}/{any}": None}
    assert {each["name"]: each.get("each") for each in variant["clients"]} == {"{each}/go": some}
    assert {each["name"]: each.get("each") for each in variant["params"]} == {"~robots": None, "~topics": None, "~{each}.speed": some}


LIFECYCLE = f"""{HEAD}#include "rclcpp_lifecycle/lifecycle_node.hpp"
namespace demo {{
class Life : public rclcpp_lifecycle::LifecycleNode {{
 public:
  explicit Life(const rclcpp::NodeOptions & options) : LifecycleNode("life", options) {{ declare_parameter("rate", 1.0); }}
  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override {{
    pub_ = create_publisher<std_msgs::msg::String>("a", 1);
    return CallbackReturn::SUCCESS;
  }}
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override {{
    timer_ = create_wall_timer(1s, std::bind(&Life::tick, this));
    return LifecycleNode::on_activate(state);
  }}
 private:
  void tick() {{ create_client<std_srvs::srv::Trigger>("b"); }}
  void start() {{ configure(); }}
}};
}}
RCLCPP_COMPONENTS_REGISTER_NODE(demo::Life)
"""


def test_a_lifecycle_node_and_component(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(tmp_path, LIFECYCLE, "demo::Life")
    assert [spelled(each) for each in facts] == lines("""
        clients b std_srvs/srv/Trigger exists=active
        params ~rate double default=1.0 declared
        publishers a std_msgs/msg/String reliable/volatile/keep_last/1 exists=configured
    """)
    assert doubts == ()
    assert [(each.name, each.lifecycle) for each in nodes] == [("life", True)]
    variant, _ = variant_of(facts, doubts, "", ROS2, nodes)
    assert (variant["node"], variant["lifecycle"]) == ("life", True)
    assert variant["publishers"][0]["exists"] == "configured"


def test_a_profile_that_may_be_another_one_is_not_known(tmp_path: Path) -> None:
    found = """
rmw_qos_profile_t like(rclcpp::Node * node, const std::string & topic) {
  auto info = node->get_publishers_info_by_topic(topic);
  if (info.size()) {
    auto profile = info[0].qos_profile().get_rmw_qos_profile();
    profile.depth = 3;
    return profile;
  }
  return rmw_qos_profile_sensor_data;
}
class Like : public rclcpp::Node {
 public:
  Like() : Node("like") {
    image_transport::create_publisher(this, "a", like(this, "b"));
    create_publisher<std_msgs::msg::String>("c", rclcpp::SensorDataQoS());
  }
};
int main() { rclcpp::spin(std::make_shared<Like>()); }
"""
    facts, _, _ = follow(tmp_path, f"{HEAD}{found}")
    assert [(each.name, each.qos is not None and each.qos.reliability) for each in facts] == [("a", False), ("c", "best_effort")]


@pytest.mark.parametrize(
    "call",
    [
        "configure();",
        "this->activate();",
        "trigger_transition(1);",
        "timer_ = create_wall_timer(1s, [this]() { start(); });",
        "timer_ = create_wall_timer(1s, std::bind(&Life::start, this));",
    ],
)
def test_a_lifecycle_node_that_its_own_program_manages(call: str, tmp_path: Path) -> None:
    source = LIFECYCLE.replace('declare_parameter("rate", 1.0);', call)
    facts, doubts, nodes = follow(tmp_path, source, "demo::Life")
    assert [(each.name, each.lifecycle, each.managed) for each in nodes] == [("life", True, True)]
    assert variant_of(facts, doubts, "", ROS2, nodes)[0]["managed"] is True


@pytest.mark.parametrize(("call", "bonds"), [("createBond();", [("bond", "active")]), ("", [])])
def test_a_node_of_nav2_keeps_a_bond_where_it_makes_one(call: str, bonds: list[tuple[str, str]], tmp_path: Path) -> None:
    source = LIFECYCLE.replace("rclcpp_lifecycle::LifecycleNode", "nav2_util::LifecycleNode")
    source = source.replace("return LifecycleNode::on_activate(state);", f"{call} return CallbackReturn::SUCCESS;")
    facts, _, _ = follow(tmp_path, source, "demo::Life")
    found = [(each.name, each.exists) for each in facts if each.type == "bond/msg/Status"]
    assert found == sorted(bonds * 2)


@pytest.mark.parametrize(
    ("assigned", "name"),
    [("topics.scan", "{any}"), ("topics.other", "scan"), ("range.scan", "scan"), ("scan", "scan"), ("other->scan", "scan")],
)
def test_a_variable_that_a_long_function_assigns_is_not_known(assigned: str, name: str, tmp_path: Path) -> None:
    source = f"""{HEAD}
namespace {{
struct Topics {{ std::string scan = "scan"; std::string other = "other"; }} topics, range;
void load() {{ {"if (sum < 9) { sum = sum + 1; } " * 40} {assigned} = text(); }}
}}
class Reader : public rclcpp::Node {{
 public:
  Reader() : Node("reader") {{ load(); create_publisher<std_msgs::msg::String>(topics.scan, 1); }}
}};
int main() {{ rclcpp::spin(std::make_shared<Reader>()); }}
"""
    facts, _, _ = follow(tmp_path, source)
    assert [each.name for each in facts] == [name]


def test_who_manages_another_node_waits_for_somebody_itself(tmp_path: Path) -> None:
    inner = 'class Inner : public rclcpp_lifecycle::LifecycleNode { public: Inner() : LifecycleNode("inner") {} };\nclass Life'
    made = "auto inner = std::make_shared<Inner>(); inner->configure();"
    source = LIFECYCLE.replace("class Life", inner, 1).replace('declare_parameter("rate", 1.0);', made)
    facts, doubts, nodes = follow(tmp_path, source, "demo::Life")
    assert [(each.name, each.managed) for each in nodes] == [("life", False), ("inner", True)]
    assert "managed" not in variant_of(facts, doubts, "", ROS2, nodes)[0]


def test_a_component_whose_class_is_not_here(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(tmp_path, LIFECYCLE, "demo::Other")
    assert facts == nodes == ()
    assert {each.reason for each in doubts} == {"the class demo::Other was not found in these sources"}


def test_a_component_that_is_registered_inside_of_its_namespace(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(tmp_path, LIFECYCLE, "Life")
    assert len(facts) == 3
    assert doubts == ()
    assert [each.name for each in nodes] == ["life"]
    facts, doubts, nodes = follow(tmp_path, f"{LIFECYCLE}\nnamespace other {{ class Life {{}}; }}", "Life")
    assert {each.reason for each in doubts} == {"the class Life was not found in these sources"}


def test_a_base_class_that_a_macro_names(tmp_path: Path) -> None:
    source = node('create_publisher<std_msgs::msg::String>("a", 1);').replace("rclcpp::Node {", "FATHER {").replace('Node("', 'FATHER("')
    facts, doubts, nodes = follow(tmp_path, f"#define FATHER rclcpp::Node\n{source}")
    assert [spelled(each) for each in facts] == ["publishers a std_msgs/msg/String reliable/volatile/keep_last/1"]
    assert doubts == ()
    assert [each.name for each in nodes] == ["talker"]


DESCRIPTOR = """
rcl_interfaces::msg::ParameterDescriptor d;
d.description = "how often"; d.read_only = true;
rcl_interfaces::msg::FloatingPointRange range;
range.from_value = 0.5; range.to_value = 10.0; range.step = 0.5;
d.floating_point_range.push_back(range);
declare_parameter("rate", 1.0, d);
rcl_interfaces::msg::ParameterDescriptor e;
e.integer_range.resize(1);
e.integer_range[0].from_value = 1;
e.integer_range[0].to_value = 3;
declare_parameter("count", 2, e);
rcl_interfaces::msg::ParameterDescriptor f;
f.dynamic_typing = true;
declare_parameter("any", rclcpp::ParameterValue(1), f);
"""


def test_descriptors(tmp_path: Path) -> None:
    facts, doubts, nodes = follow(tmp_path, node(DESCRIPTOR))
    variant, _ = variant_of(facts, doubts, "", ROS2, nodes)

    def said(name: str) -> dict[str, Any]:
        entry = next(each for each in variant["params"] if each["name"] == name)
        return {key: value for key, value in entry.items() if key not in ("name", "evidence")}

    assert said("~rate") == {
        "default": 1.0, "declared": True, "min": 0.5, "max": 10.0, "step": 0.5, "read_only": True, "description": "how often",
        "type": "double",
    }  # fmt: skip
    assert said("~count") == {"default": 2, "declared": True, "min": 1, "max": 3, "type": "integer"}
    assert (said("~any")["dynamic"], "type" in said("~any")) == (True, False)


OPEN = {
    "a class that is given the node": (
        "helper_ = std::make_unique<foreign::Helper>(shared_from_this());",
        "foreign::Helper is given a node",
    ),
    "a function that is given it": ("foreign::set_up(*this);", "foreign::set_up is given a node"),
    "an interface of it": ("foreign::Helper helper(get_node_topics_interface());", "foreign::Helper is given a node"),
    "plugins": ('pluginlib::ClassLoader<Base> loader("pkg", "Base");', "pluginlib::ClassLoader loads plugins"),
}


@pytest.mark.parametrize("name", OPEN)
def test_what_is_not_followed_is_open(name: str, tmp_path: Path) -> None:
    body, expected = OPEN[name]
    _, doubts, _ = follow(tmp_path, node(body))
    assert {each.category for each in doubts} == {"publishers", "subscribers", "services", "clients", "actions", "params"}
    assert all(each.reason.startswith(expected) for each in doubts), doubts


def test_a_base_class_that_is_not_here_opens_everything_and_what_is_seen_is_told(tmp_path: Path) -> None:
    source = (
        node('create_publisher<std_msgs::msg::String>("a", 1);')
        .replace("rclcpp::Node {", "robot::Base {")
        .replace('Node("talker")', "Base()")
    )
    facts, doubts, _ = follow(tmp_path, source)
    assert {each.reason for each in doubts} == {"the base class robot::Base is not in these sources"}
    assert [spelled(each) for each in facts] == ["publishers a std_msgs/msg/String reliable/volatile/keep_last/1"]


def test_a_thread_is_no_stranger(tmp_path: Path) -> None:
    _, doubts, _ = follow(tmp_path, node("thread_ = std::thread(&Talker::run, this);", "void run() { while (rclcpp::ok()) {} }"))
    assert doubts == ()


GENERATED = """
talker_params:
  topic: {type: string, default_value: scan, description: "where to"}
  gains:
    p: {type: double, default_value: 1, validation: {bounds<>: [0.0, 2.0]}}
  mode: {type: string, default_value: a, read_only: true, validation: {one_of<>: [["a", "b"]]}}
  joints: {type: string_array, default_value: [x, y]}
  limits:
    __map_joints:
      max: {type: int, default_value: 3}
"""


def test_generated_params(tmp_path: Path) -> None:
    (tmp_path / "params.yaml").write_text(GENERATED)
    body = """
    listener_ = std::make_shared<talker_params::ParamListener>(get_node_parameters_interface());
    params_ = listener_->get_params();
    create_publisher<std_msgs::msg::String>(params_.topic, 1);
    """
    more = "std::shared_ptr<talker_params::ParamListener> listener_; talker_params::Params params_;"
    facts, doubts, _ = follow(tmp_path, node(body, more), parameters=(str(tmp_path / "params.yaml"),))
    assert doubts == ()
    assert [(spelled(each), each.path, each.line) for each in facts] == [
        ("params ~gains.p double default=1.0 declared", "params.yaml", 5),
        ("params ~joints string_array default=['x', 'y'] declared", "params.yaml", 7),
        ("params ~limits.{any}.max integer default=3 declared", "params.yaml", 10),
        ("params ~mode string default='a' declared", "params.yaml", 6),
        ("params ~topic string default='scan' declared", "params.yaml", 3),
        ("publishers {param:~topic|scan} std_msgs/msg/String reliable/volatile/keep_last/1", "main.cpp", 11),
    ]
    described = {each.name: each.descriptor for each in facts if each.descriptor is not None}
    assert (described["~gains.p"].minimum, described["~gains.p"].maximum) == (0.0, 2.0)
    assert (described["~mode"].one_of, described["~mode"].read_only) == (("a", "b"), True)


HANDLES = """
#include <list>
class Mux;
class Handle {
 public:
  Handle(const std::string & topic, Mux * mux);
 private:
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
};
class Mux : public rclcpp::Node {
 public:
  template <typename T> using many = std::list<T>;
  using handles = many<Handle>;
  Mux() : Node("mux") {}
  void init() {
    handles_ = std::make_shared<handles>();
    fill(*handles_);
  }
  template <typename T> void fill(many<T> & all);
 private:
  std::shared_ptr<handles> handles_;
};
Handle::Handle(const std::string & topic, Mux * mux) {
  subscription_ = mux->create_subscription<std_msgs::msg::String>(topic, 1, [](std_msgs::msg::String) {});
}
template <typename T> void Mux::fill(std::list<T> & all) {
  all.emplace_back("in", this);
}
int main() { auto mux = std::make_shared<Mux>(); mux->init(); }
"""


def test_elements_that_a_container_of_a_template_makes(tmp_path: Path) -> None:
    facts, doubts, _ = follow(tmp_path, HEAD + HANDLES)
    assert [spelled(each) for each in facts] == ["subscribers in std_msgs/msg/String reliable/volatile/keep_last/1"]
    assert not doubts


def test_elements_of_which_nothing_is_known_may_talk_where_they_are_given_a_node(tmp_path: Path) -> None:
    _, doubts, _ = follow(tmp_path, node('    auto others = registry();\n    others.emplace_back("in", this);'))
    assert "emplace_back makes what is not known of a node" in {each.reason for each in doubts}


def test_texts_in_braces(tmp_path: Path) -> None:
    member = '  static constexpr char kName[]{"odom"};'
    facts, _, _ = follow(
        tmp_path, node('    declare_parameter("frame", kName);\n    declare_parameter("map", std::string{kName});', member)
    )
    assert [spelled(each) for each in facts] == [
        "params ~frame string default='odom' declared",
        "params ~map string default='odom' declared",
    ]


TWICE = (
    node(
        """
    out_ = open();
""",
        """
 private:
  rclcpp::PublisherBase::SharedPtr open();
  rclcpp::PublisherBase::SharedPtr out_;
""",
    )
    + """
#ifdef FOR_ROS1
rclcpp::PublisherBase::SharedPtr Talker::open() { return advertise("cloud"); }
#elif defined FOR_ROS2
rclcpp::PublisherBase::SharedPtr Talker::open() { return create_publisher<std_msgs::msg::String>("cloud", 5); }
#endif
"""
)


def test_a_function_that_the_preprocessor_leaves_one_of_is_followed_in_each_way(tmp_path: Path) -> None:
    """The first of two definitions is not taken for the only one, so that what the second makes is not missed."""
    facts, doubts, _ = follow(tmp_path, TWICE)
    assert [(each.category, each.name, each.type) for each in facts] == [("publishers", "cloud", "std_msgs/msg/String")]
    assert all(each.condition for each in facts) or doubts
    assert not follow(tmp_path, TWICE.replace('"cloud", 5', '"cloud", 6').replace("create_publisher<std_msgs::msg::String>", "nothing"))[0]


@pytest.mark.parametrize(
    "test",
    [
        "std::vector<int> missing; for (int each : {1, 2}) { if (find(each)) { missing.push_back(each); } } if (!missing.empty()) return;",
        "std::vector<int> missing; if (find(1)) { missing.push_back(1); } if (missing.size() > 0) { return; }",
        'std::string error; if (find(1)) { error = "none"; } if (!error.empty()) { return; }',
        'std::string error; if (find(1)) { error += "none"; } if (!error.empty()) { return; }',
    ],
)
def test_what_is_filled_under_a_condition_may_be_empty(test: str, tmp_path: Path) -> None:
    """A list or text that only one way fills decides nothing: what follows an early return is not lost."""
    facts, _, _ = follow(tmp_path, node(f'std::vector<int> wanted = {{1, 2}}; {test} create_publisher<std_msgs::msg::String>("out", 1);'))
    assert [(each.category, each.name, each.condition) for each in facts] == [("publishers", "out", "")]
    certain = test.replace("if (find(each))", "").replace("if (find(1))", "")
    assert not follow(tmp_path, node(f'std::vector<int> wanted = {{1, 2}}; {certain} create_publisher<std_msgs::msg::String>("out", 1);'))[
        0
    ]


def test_items_of_a_list_that_is_filled_under_a_condition_may_not_be_there(tmp_path: Path) -> None:
    """Each of them is told, and none as certain."""
    body = """
    std::vector<std::string> names = {"left"};
    if (both()) { names.push_back("right"); }
    for (auto & each : names) { create_publisher<std_msgs::msg::String>(each, 1); }
"""
    facts, _, _ = follow(tmp_path, node(body))
    assert [(each.name, each.condition) for each in facts] == [("left", "each is one of names"), ("right", "each is one of names")]


def test_a_source_that_begins_with_a_byte_order_mark(tmp_path: Path) -> None:
    """Its first line may be the header with the class."""
    (tmp_path / "talker.h").write_text(HEAD + "class Talker : public rclcpp::Node { public: Talker(); };\n")
    source = """\ufeff#include "talker.h"
Talker::Talker() : Node("talker") { create_publisher<std_msgs::msg::String>("out", 1); }
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Talker>()); }
"""
    assert [each.name for each in follow(tmp_path, source)[0]] == ["out"]


def test_a_specialisation_is_chosen_by_the_type_of_its_argument(tmp_path: Path) -> None:
    """A number with a point is a double, whichever specialisation comes first; so is a variable of that type whose value is not known."""
    kinds = {"int": "INTEGER", "double": "DOUBLE", "std::string": "STRING", "bool": "BOOL"}
    head = "template <typename T> T get(rclcpp::Node * node, std::string name, T fallback) = delete;\n" + "".join(
        f"template <> inline {type_} get(rclcpp::Node * node, std::string name, {type_} fallback) {{\n"
        f"  node->declare_parameter(name, rclcpp::PARAMETER_{kind});\n  return fallback;\n}}\n"
        for type_, kind in kinds.items()
    )
    body = """
    double measured = measure();
    get(this, "height", 0.5);
    get(this, "number", 2);
    get(this, "frame", std::string("map"));
    get(this, "shown", true);
    get(this, "measured", measured);
"""
    facts, _, _ = follow(tmp_path, node(body).replace("class Talker", f"{head}double measure();\nclass Talker", 1))
    assert {fact.name.lstrip("~"): fact.value_type for fact in facts if fact.category == "params"} == {
        "height": "double", "number": "integer", "frame": "string", "shown": "bool", "measured": "double",
    }  # fmt: skip
