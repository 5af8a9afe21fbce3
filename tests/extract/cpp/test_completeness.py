"""What is called complete: for each thing that may talk and is not followed a source that says why, and its twin that is clean."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import in_main, lines, program, spelled

CATEGORIES = ["actions", "clients", "params", "publishers", "services", "subscribers"]


def doubted(root: Path, files: str | dict[str, str], entry: str | None = None) -> dict[str, list[str]]:
    """The reasons for which there may be more than was found, with the categories that each of them opens."""
    _, doubts = program(root, files, entry)
    found: dict[str, list[str]] = {}
    for doubt in doubts:
        found.setdefault(doubt.reason, []).append(doubt.category)
    return found


FOREIGN = {
    "an object of a ROS package": (
        "#include <mavlink_router/router.h>\n#include <swri_route_util/route.h>\n",
        "swri_route_util::Route route(1);",
        "swri_route_util::Route is of swri_route_util/route.h, which is not in these sources",
    ),
    "an object whose package is told by a namespace that is used": (
        "#include <swri_route_util/route.h>\nusing namespace swri_route_util;\n",
        "Route route;",
        "Route is of swri_route_util/route.h, which is not in these sources",
    ),
    "a function of a ROS package": (
        "#include <swri_route_util/util.h>\n",
        "swri_route_util::start();",
        "swri_route_util::start is of swri_route_util/util.h, which is not in these sources",
    ),
    "a static member": (
        "#include <swri_route_util/route.h>\n",
        "auto* route = swri_route_util::Route::create();",
        "swri_route_util::Route::create is of swri_route_util/route.h, which is not in these sources",
    ),
    "what looks like a message and is made of a text": (
        "#include <swri_route_util/Route.h>\n",
        'swri_route_util::Route route("name", 1);',
        "swri_route_util::Route is of swri_route_util/Route.h, which is not in these sources",
    ),
}


@pytest.mark.parametrize("name", FOREIGN)
def test_what_comes_with_a_header_of_a_ros_package_that_is_not_here_may_talk(tmp_path: Path, name: str) -> None:
    before, body, reason = FOREIGN[name]
    assert doubted(tmp_path, before + in_main(body)) == {reason: CATEGORIES}


SILENT = {
    "a library that is no ROS package": ("#include <modbus/modbus.h>\n", "modbus::Context context(1); modbus::connect(context);"),
    "mathematics": (
        "#include <tf2/LinearMath/Quaternion.h>\n#include <angles/angles.h>\n",
        "tf2::Quaternion q(0, 0, 0, 1); angles::from_degrees(3);",
    ),
    "a message": ("#include <swri_route_util/Route.h>\n", "swri_route_util::Route route; swri_route_util::Route other(route);"),
    "messages of a package of messages": ("#include <marti_nav_msgs/Route.h>\n", "marti_nav_msgs::RoutePoint point;"),
    "a class of another library beside one": (
        "#include <swri_route_util/route.h>\n#include <opencv2/opencv.hpp>\n", 'cv::Mat image(1, 2); std::ofstream file("x");'
    ),
    "data of MoveIt": (
        "#include <moveit/move_group_interface/move_group_interface.h>\n",
        "moveit::planning_interface::MoveGroupInterface::Plan plan; moveit::core::RobotState state(model);",
    ),
    "the client library": ("#include <ros/ros.h>\n", "ros::AsyncSpinner spinner(2); ros::Rate rate(5); spinner.start();"),
    "the callback type of a server": (
        "#include <dynamic_reconfigure/server.h>\n", "dynamic_reconfigure::Server<demo::DemoConfig>::CallbackType f;"
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SILENT)
def test_what_is_known_to_be_silent_leaves_nothing_open(tmp_path: Path, name: str) -> None:
    before, body = SILENT[name]
    assert program(tmp_path, before + in_main(body)) == ((), ())


def test_a_package_that_only_the_manifest_names_is_one_of_ros(tmp_path: Path) -> None:
    from launchlint.extract.cpp import cpp_program

    (tmp_path / "main.cpp").write_text("#include <our_parts/arm.h>\n" + in_main("our_parts::Arm arm;"))
    found = [
        {doubt.reason for doubt in cpp_program([str(tmp_path / "main.cpp")], [], str(tmp_path), None, packages=packages)[1]}
        for packages in ((), ("our_parts",))
    ]
    assert found == [set(), {"our_parts::Arm is of our_parts/arm.h, which is not in these sources"}]


MODELLED = {
    "costmap": (
        'costmap_2d::Costmap2DROS costmap("local_costmap", buffer);',
        """
        params ~local_costmap/{any} - 2
        publishers ~local_costmap/costmap nav_msgs/OccupancyGrid 2 latched
        publishers ~local_costmap/costmap_updates map_msgs/OccupancyGridUpdate 2
        publishers ~local_costmap/footprint geometry_msgs/PolygonStamped 2
        publishers ~local_costmap/parameter_descriptions dynamic_reconfigure/ConfigDescription 2 latched
        publishers ~local_costmap/parameter_updates dynamic_reconfigure/Config 2 latched
        publishers ~local_costmap/{any} - 2
        services ~local_costmap/set_parameters dynamic_reconfigure/Reconfigure 2
        services ~local_costmap/{any} - 2
        subscribers ~local_costmap/footprint geometry_msgs/Polygon 2
        """,
        {"the layers of a costmap hear topics that params name": ["subscribers"]},
    ),
    "planning scene": (
        "moveit::planning_interface::PlanningSceneInterface scene;",
        """
        clients apply_planning_scene moveit_msgs/ApplyPlanningScene 2
        clients get_planning_scene moveit_msgs/GetPlanningScene 2
        publishers planning_scene moveit_msgs/PlanningScene 2
        """,
        {},
    ),
    "robot model": (
        "robot_model_loader::RobotModelLoader loader;",
        """
        params robot_description - 2
        params robot_description_kinematics/{any} - 2
        params robot_description_planning/{any} - 2
        params robot_description_semantic - 2
        """,
        {},
    ),
    "buffer server": (
        'tf2_ros::BufferServer server(buffer, "tf2_buffer", false);',
        "actions tf2_buffer tf2_msgs/LookupTransformAction 2 server",
        {},
    ),
    "a name that nobody knows": (
        "navfn::NavfnROS planner(name(), map);",
        """
        params ~{any}/{any} - 2
        publishers ~{any}/plan nav_msgs/Path 2
        publishers ~{any}/{any} - 2
        services ~{any}/make_plan nav_msgs/GetPlan 2
        services ~{any}/{any} - 2
        """,
        {
            "a name is not known before it runs: navfn::NavfnROS planner(name(), map);": ["params", "publishers", "services"],
        },
    ),
    "by a node handle": (
        'bond::Bond bond("/link", "id");\nrviz_visual_tools::RvizVisualTools tools("base", "markers", ros::NodeHandle("~"));',
        """
        params /bond_disable_heartbeat_timeout - 2
        publishers /link bond/Status 2
        publishers ~markers visualization_msgs/MarkerArray 3
        subscribers /link bond/Status 2
        subscribers /rviz_visual_tools_gui sensor_msgs/Joy 3
        """,
        {},
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MODELLED)
def test_classes_of_well_known_packages_make_what_is_known_of_them(tmp_path: Path, name: str) -> None:
    body, expected, reasons = MODELLED[name]
    assert [spelled(fact) for fact in program(tmp_path, in_main(body))[0]] == lines(expected)
    assert doubted(tmp_path, in_main(body)) == reasons


def test_a_move_group_hears_the_joints_only_once_it_is_asked_for_the_state(tmp_path: Path) -> None:
    facts, _ = program(tmp_path, in_main('moveit::planning_interface::MoveGroupInterface arm("arm");'))
    heard = {fact.name: fact.condition for fact in facts if fact.category == "subscribers"}
    assert heard == {"joint_states": "the state of the robot is asked for", "/tf": "", "/tf_static": ""}


def test_a_base_class_that_is_not_here_may_talk(tmp_path: Path) -> None:
    source = "struct Node : public {base} {{ Node() {{}} }};\nint main() {{ Node node; }}"
    assert doubted(tmp_path, source.format(base="robot::Skill")) == {"the base class robot::Skill is not in these sources": CATEGORIES}
    for base in (
        "nodelet::Nodelet",
        "std::enable_shared_from_this<Node>",
        "boost::noncopyable",
        "QMainWindow",
        "nav_core::BaseGlobalPlanner",
    ):
        assert doubted(tmp_path, source.format(base=base)) == {}


DECLARED = """
#include <ros/ros.h>
class Arm {{ public: Arm(){constructor}; void start(){start}; ros::NodeHandle nh; }};
int main() {{ Arm arm; arm.start(); }}
"""


def test_a_function_that_is_declared_and_whose_source_is_not_here_may_talk(tmp_path: Path) -> None:
    assert doubted(tmp_path, DECLARED.format(constructor="", start="")) == {
        "the constructor of Arm is not in these sources": CATEGORIES,
        "Arm::start is declared, and its source is not here": CATEGORIES,
    }
    assert doubted(tmp_path, DECLARED.format(constructor=" = default", start=" {}")) == {}
    silent = DECLARED.replace("#include <ros/ros.h>\n", "").replace("ros::NodeHandle nh;", "int handle;")
    assert doubted(tmp_path, silent.format(constructor="", start="")) == {}


HANDED_ON = {
    "to a function": ("framework::run(nh);", "framework::run", CATEGORIES),
    "to one that is called like a check": ("assertions::run(nh);", "assertions::run", CATEGORIES),
    "to one that reads params": ("util::getParams(nh, x);", "util::getParams", ["params"]),
    "to an object": ("Driver driver(nh);", "Driver", CATEGORIES),
}  # fmt: skip


@pytest.mark.parametrize("name", HANDED_ON)
def test_a_node_handle_that_is_handed_to_code_that_is_not_read(tmp_path: Path, name: str) -> None:
    body, called, categories = HANDED_ON[name]
    reason = f"{called} is given a node handle, and is not in these sources"
    assert doubted(tmp_path, in_main(f"ros::NodeHandle nh;\n{body}")) == {reason: categories}
    assert doubted(tmp_path, in_main('ros::NodeHandle nh;\nros::Rate rate(nh.param("rate", 5));')) == {}


def test_a_topic_of_a_node_handle_that_nobody_knows_is_told(tmp_path: Path) -> None:
    source = """struct Node { ros::NodeHandle* nh; void run() { nh->subscribe("scan", 1, cb); } };
    int main() { Node* node = find(); node->run(); }"""
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["subscribers {any}/scan - 1 queue=1"]


def test_what_is_made_of_something_unknown_is_a_doubt(tmp_path: Path) -> None:
    body = 'registry()->handle().advertise<std_msgs::Bool>("a", 1);'
    assert doubted(tmp_path, in_main(body)) == {f"advertise is called of what may be a node handle: {body[:-1]}": ["publishers"]}


FOLLOWED = {
    "a function in a table": """
        void start() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); }
        std::map<std::string, void (*)()> table;
        int main() { table["start"] = start; table[next()](); }
        """,
    "a lambda that is kept": """
        struct Machine { std::vector<std::function<void()>> states; };
        int main() { Machine m; m.states = {[]() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); }}; m.states[0](); }
        """,
    "a virtual function that only a class from elsewhere calls": """
        struct Window : public QWidget { virtual void showEvent(QShowEvent* e) { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        int main() { Window window; window.show(); }
        """,
    "a slot that is connected by its name": """
        struct Window : public QWidget { void on_start_clicked() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        int main() { Window window; window.show(); }
        """,
    "a member of an object out of a container": """
        struct Arm { void start() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        std::map<std::string, std::shared_ptr<Arm>> arms;
        int main() { arms[name()] = std::make_shared<Arm>(); arms.at(name())->start(); }
        """,
    "objects that an array makes": """
        struct Arm { Arm() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        int main() { Arm arms[4]; }
        """,
    "objects that a list makes": """
        struct Arm { Arm() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        int main() { std::vector<Arm> arms(4); }
        """,
    "a pointer to a virtual member": """
        struct Part { virtual void start() = 0; template <class F> void safely(F f) { (this->*f)(); } };
        struct Arm : public Part { void start() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        int main() { Part* part = new Arm(); part->safely(&Part::start); }
        """,
    "an object that is made in its place": """
        struct Arm { Arm(ros::NodeHandle nh) { nh.advertise<std_msgs::Bool>("a", 1); } };
        int main() { ros::NodeHandle nh; std::vector<Arm> arms; arms.emplace_back(nh); }
        """,
    "a global object that nobody asks for": """
        struct Arm { Arm() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
        Arm arm;
        int main() { ros::spin(); }
        """,
}


@pytest.mark.parametrize("name", FOLLOWED)
def test_what_is_called_in_a_way_that_is_not_read_is_followed(tmp_path: Path, name: str) -> None:
    facts, doubts = program(tmp_path, FOLLOWED[name])
    assert [(fact.category, fact.name, fact.type) for fact in facts] == [("publishers", "a", "std_msgs/Bool")]
    assert doubts == ()


def test_what_nobody_calls_is_not_followed(tmp_path: Path) -> None:
    source = """
    struct Window : public QWidget { void unused() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
    struct Arm {
      Arm(ros::NodeHandle nh) { nh.advertise<std_msgs::Bool>("b", 1); }
      void start() { ros::NodeHandle().advertise<std_msgs::Bool>("c", 1); }
    };
    int main() { Window window; window.show(); other()->start(); std::vector<Arm> arms; }
    """
    assert program(tmp_path, source) == ((), ())


def test_a_condition_on_what_other_code_may_have_set_is_not_decided(tmp_path: Path) -> None:
    body = 'int mode = 1;\nsettings::get("mode", mode);\nif (mode == 2) ros::NodeHandle().advertise<std_msgs::Bool>("a", 1);'
    assert [spelled(fact) for fact in program(tmp_path, in_main(body))[0]] == ["publishers a std_msgs/Bool 4 queue=1 if mode == 2"]
    kept = body.replace('settings::get("mode", mode);', 'ROS_INFO("mode %d", mode);')
    assert program(tmp_path, in_main(kept))[0] == ()


def test_names_with_a_known_beginning_are_told_and_the_rest_is_a_doubt(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh, arm("arm");
    nh.advertise<std_msgs::Bool>("camera" + name() + "/image", 1);
    nh.advertise<std_msgs::Bool>(name() + "/image", 1);
    arm.advertise<std_msgs::Int32>(name(), 1);
    """
    facts, doubts = program(tmp_path, in_main(body))
    assert [spelled(fact) for fact in facts] == [
        "publishers arm/{any} std_msgs/Int32 5 queue=1",
        "publishers camera{any}/image std_msgs/Bool 3 queue=1",
        "publishers {any}/image std_msgs/Bool 4 queue=1",
    ]
    assert [doubt.line for doubt in doubts] == [4, 5]


DERIVED = """
struct Base {{
  Base() {{ setup(); }}
  void start() {{ setup(); }}
  {virtual}void setup() {{ ros::NodeHandle().getParam("base", x); }}
}};
struct Derived : public Base {{ Derived() {{ {call} }} void setup() {{ ros::NodeHandle().getParam("derived", x); }} }};
int main() {{ Derived object; }}
"""


@pytest.mark.parametrize(
    ("virtual", "call", "expected"),
    [
        ("", "", ["base"]),
        ("virtual ", "", ["base"]),
        ("", "start();", ["base"]),
        ("virtual ", "start();", ["base", "derived"]),
        ("", "setup();", ["base", "derived"]),
    ],
)
def test_a_constructor_calls_the_functions_of_its_own_class(tmp_path: Path, virtual: str, call: str, expected: list[str]) -> None:
    facts, _ = program(tmp_path, DERIVED.format(virtual=virtual, call=call))
    assert [fact.name for fact in facts] == expected


def test_a_factory_that_a_macro_registers_with_makes_its_class(tmp_path: Path) -> None:
    source = """
    struct Part { virtual void start() = 0; };
    std::map<std::string, std::function<Part*()>>& makers() { static std::map<std::string, std::function<Part*()>> all; return all; }
    template <class T> struct Registered { Registered(const std::string& name) { makers()[name] = []() { return new T(); }; } };
    #define REGISTER_PART(Class) static Registered<Class> registered##Class(#Class);
    struct Arm : public Part { Arm() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } void start() {} };
    REGISTER_PART(Arm);
    int main() { makers()[name()]()->start(); }
    """
    facts, _ = program(tmp_path, source)
    assert [(fact.category, fact.name) for fact in facts] == [("publishers", "a")]


def test_members_that_are_given_one_by_one_and_constructors_that_are_inherited(tmp_path: Path) -> None:
    source = """
    struct Context { ros::NodeHandle nh; std::string name; };
    struct Base { Base(ros::NodeHandle nh) { nh.advertise<std_msgs::Bool>("b", 1); } };
    struct Derived : public Base { using Base::Base; };
    int main() { Context c{ros::NodeHandle("~"), "a"}; c.nh.advertise<std_msgs::Bool>(c.name, 1); Derived d(ros::NodeHandle("/arm")); }
    """
    facts, doubts = program(tmp_path, source)
    assert [fact.name for fact in facts] == ["/arm/b", "~a"]
    assert doubts == ()


def test_a_part_that_is_not_understood_leaves_it_open(tmp_path: Path) -> None:
    sound = 'int main() { ros::NodeHandle nh; nh.advertise<std_msgs::Bool>("b", 1); }'
    torn = f'{sound}\n\n\n@ @ ) void more(ros::NodeHandle nh) ( nh.subscribe("a", 1, cb); @ ( }}'
    assert doubted(tmp_path, torn) == {"a part of the source is not understood": CATEGORIES}
    assert doubted(tmp_path, sound) == {}


def test_a_base_that_is_called_by_another_name_gets_what_it_is_given(tmp_path: Path) -> None:
    facts, doubts = program(
        tmp_path,
        """
        class Common {
         public:
          explicit Common(ros::NodeHandlePtr nh) : nh_(nh) {}
          virtual void initialize() { pub_ = nh_->advertise<std_msgs::String>("raw", 1); }
          ros::NodeHandlePtr nh_;
          ros::Publisher pub_;
        };
        class Online : public Common {
          using BASE = Common;
         public:
          explicit Online(ros::NodeHandlePtr nh) : BASE(nh) {}
          void initialize() override { BASE::initialize(); }
        };
        int main(int argc, char** argv) {
          ros::NodeHandlePtr nh(new ros::NodeHandle("~"));
          Online online(nh);
          online.initialize();
        }
        """,
    )
    assert [each.name for each in facts] == ["~raw"]
    assert not doubts


def test_a_pointer_to_a_node_handle_that_nobody_set_is_one_that_nobody_knows(tmp_path: Path) -> None:
    facts, doubts = program(
        tmp_path,
        """
        class Lost {
         public:
          void initialize() { pub_ = nh_->advertise<std_msgs::String>("lost", 1); }
          ros::NodeHandlePtr nh_;
          ros::Publisher pub_;
        };
        int main(int argc, char** argv) { Lost lost; lost.initialize(); }
        """,
    )
    assert [each.name for each in facts] == ["{any}/lost"]
    assert {each.category for each in doubts} == {"publishers"}


def test_a_flag_whose_address_is_given_away_is_not_decided(tmp_path: Path) -> None:
    facts, _ = program(
        tmp_path,
        """
        struct Settings { bool interactive = false; };
        void load(const Table& table, Settings* p) { read(table, "interactive", &p->interactive); }
        int main(int argc, char** argv) {
          Settings settings;
          for (const auto& each : tables()) { reader.load(each, settings); }
          ros::NodeHandle nh;
          if (settings.interactive) { ros::Publisher pub = nh.advertise<std_msgs::String>("markers", 1); }
        }
        """,
    )
    assert [each.name for each in facts] == ["markers"]


def test_a_text_whose_address_is_given_away_may_be_another_one(tmp_path: Path) -> None:
    facts, doubts = program(
        tmp_path,
        """
        int main(int argc, char** argv) {
          ros::NodeHandle nh;
          std::string topic("given");
          fill(&topic);
          ros::Subscriber first = nh.subscribe<std_msgs::String>(topic, 1, heard);
        }
        """,
    )
    assert [each.name for each in facts] == ["given", "{any}"]
    assert {each.category for each in doubts} == {"subscribers"}


def test_a_namespace_that_is_read_in_is_not_the_empty_one_that_it_was_before(tmp_path: Path) -> None:
    facts, _ = program(
        tmp_path,
        """
        struct Config {
          std::string space() { std::string ns; inner("_space", &ns); return ns; }
          template <class T> void inner(const std::string& key, T* value) {
            auto it = map_.find(key);
            if (it == map_.end()) { return; }
            *value = it->second;
          }
          std::map<std::string, XmlRpc::XmlRpcValue> map_;
        };
        int main(int argc, char** argv) {
          Config config;
          ros::NodeHandle nh(config.space());
          ros::Subscriber sub = nh.subscribe<std_msgs::String>("in", 1, heard);
        }
        """,
    )
    assert [each.name for each in facts] == ["{any}/in"]


def test_a_namespace_that_is_set_somewhere_is_not_the_empty_one(tmp_path: Path) -> None:
    facts, _ = program(
        tmp_path,
        """
        struct Config : public Elsewhere {
          void fromParams() { space = namespaceOfParams(); }
          std::string space;
        };
        int main(int argc, char** argv) {
          Config config;
          setUp(config);
          ros::NodeHandle nh(config.space);
          ros::Subscriber sub = nh.subscribe<std_msgs::String>("in", 1, heard);
        }
        """,
    )
    assert [each.name for each in facts] == ["{any}/in"]


_COMPONENT = """#include <ros/ros.h>
#include <rtm/Manager.h>
class Bridge : public RTC::DataFlowComponentBase {
 public:
  Bridge(RTC::Manager* manager) {}
  RTC::ReturnCode_t onInitialize() { pub = nh.advertise<std_msgs::String>("odom", 1); }
  ros::NodeHandle nh;
  ros::Publisher pub;
};
void init(RTC::Manager* manager) { manager->registerFactory(profile, MAKER, MAKER); }
"""


@pytest.mark.parametrize(
    ("maker", "expected"),
    [
        ("RTC::Create<Bridge>", {"an object of Bridge may be made by code that is not here": CATEGORIES}),
        ("RTC::Create<Other>", {}),
    ],
)
def test_a_class_that_code_from_elsewhere_makes_may_talk(tmp_path: Path, maker: str, expected: dict[str, list[str]]) -> None:
    source = _COMPONENT.replace("MAKER", maker) + in_main('ros::NodeHandle n; n.param("rate", 1.0);\nRTC::Manager::run(init);')
    assert doubted(tmp_path, source) == expected
