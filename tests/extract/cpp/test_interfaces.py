from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import in_main, lines, program, spelled

HEARS = "#include <nav_msgs/OccupancyGrid.h>\n#include <sensor_msgs/LaserScan.h>\n"

CALLBACKS = {
    "ConstPtr": "void cb(const sensor_msgs::LaserScan::ConstPtr& message) {}",
    "LaserScanConstPtr": "void cb(const sensor_msgs::LaserScanConstPtr& message) {}",
    "LaserScanPtr": "void cb(sensor_msgs::LaserScanPtr message) {}",
    "reference": "void cb(const sensor_msgs::LaserScan& message) {}",
    "shared_ptr": "void cb(const boost::shared_ptr<sensor_msgs::LaserScan const>& message) {}",
    "event": "void cb(const ros::MessageEvent<sensor_msgs::LaserScan const>& event) {}",
    "alias": "typedef sensor_msgs::LaserScan Scan;\nvoid cb(const Scan::ConstPtr& message) {}",
    "using": "using Scan = sensor_msgs::LaserScan;\nvoid cb(const Scan& message) {}",
    "using namespace": "using namespace sensor_msgs;\nvoid cb(const LaserScanConstPtr& message) {}",
    "alias of the namespace": "namespace sm = sensor_msgs;\nvoid cb(const sm::LaserScan& message) {}",
}


@pytest.mark.parametrize("name", CALLBACKS)
def test_type_told_by_the_callback(tmp_path: Path, name: str) -> None:
    source = in_main('ros::NodeHandle nh;\nnh.subscribe("scan", 10, cb);', HEARS + CALLBACKS[name])
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["subscribers scan sensor_msgs/LaserScan 3 queue=10"]
    assert doubts == ()


CALLS = {
    "explicit": (
        'nh.subscribe<sensor_msgs::LaserScan>("scan", 1, boost::bind(&f, _1, 2));',
        "subscribers scan sensor_msgs/LaserScan 3 queue=1",
    ),
    "lambda": (
        'nh.subscribe("scan", 1, [&](const sensor_msgs::LaserScanConstPtr& m) {});',
        "subscribers scan sensor_msgs/LaserScan 3 queue=1",
    ),
    "function object": (
        'boost::function<void(int)> f = [](int a) {};\nnh.subscribe<std_msgs::Bool>("b", 1, f);',
        "subscribers b std_msgs/Bool 4 queue=1",
    ),
    "shape shifter": ('nh.subscribe<topic_tools::ShapeShifter>("x", 1, f);', "subscribers x * 3 queue=1"),
    "point cloud": ('nh.advertise<pcl::PointCloud<pcl::PointXYZ> >("cloud", 1);', "publishers cloud sensor_msgs/PointCloud2 3 queue=1"),
    "allocator": ('nh.advertise<std_msgs::String_<std::allocator<void> > >("a", 1);', "publishers a std_msgs/String 3 queue=1"),
    "options": (
        'ros::AdvertiseOptions o = ros::AdvertiseOptions::create<std_msgs::Bool>("a", 4, c, d, e, q);\no.latch = true;\nnh.advertise(o);',
        "publishers a std_msgs/Bool 5 latched queue=4",
    ),
    "subscribe options": (
        'ros::SubscribeOptions o;\no.init<std_msgs::Bool>("a", 4, f);\nnh.subscribe(o);',
        "subscribers a std_msgs/Bool 5 queue=4",
    ),
    "client": ('nh.serviceClient<std_srvs::SetBool>("set");', "clients set std_srvs/SetBool 3"),
    "call by name": ('std_srvs::Empty e;\nros::service::call("/reset", e);', "clients /reset std_srvs/Empty 4"),
    "wait": ('ros::topic::waitForMessage<std_msgs::Bool>("on", nh);', "subscribers on std_msgs/Bool 3"),
    "filter": ('message_filters::Subscriber<std_msgs::Bool> s(nh, "on", 3);', "subscribers on std_msgs/Bool 3 queue=3"),
    "filter later": ('message_filters::Subscriber<std_msgs::Bool> s;\ns.subscribe(nh, "on", 3);', "subscribers on std_msgs/Bool 4 queue=3"),
    "transform listener": (
        "tf2_ros::TransformListener l(buffer);",
        "subscribers /tf tf2_msgs/TFMessage 3 queue=100\nsubscribers /tf_static tf2_msgs/TFMessage 3 queue=100",
    ),
    "old transform listener": (
        "tf::TransformListener l;",
        "params ~tf_prefix str 3\nsubscribers /tf tf2_msgs/TFMessage 3 queue=100\nsubscribers /tf_static tf2_msgs/TFMessage 3 queue=100",
    ),
    "broadcaster": ("static tf::TransformBroadcaster b;", "publishers /tf tf2_msgs/TFMessage 3 queue=100"),
    "static broadcaster": ("tf2_ros::StaticTransformBroadcaster b;", "publishers /tf_static tf2_msgs/TFMessage 3 latched queue=100"),
    "action server": (
        'actionlib::SimpleActionServer<demo_msgs::GoAction> as(nh, "go", false);',
        "actions go demo_msgs/GoAction 3 server",
    ),
    "action client": (
        'actionlib::SimpleActionClient<demo_msgs::GoAction> ac("go", true);',
        "actions go demo_msgs/GoAction 3 client",
    ),
    "action by typedef": (
        'typedef actionlib::SimpleActionClient<demo_msgs::GoAction> Client;\nClient* ac = new Client("go", true);',
        "actions go demo_msgs/GoAction 4 client",
    ),
    "diagnostics": (
        "diagnostic_updater::Updater u;",
        "params ~diagnostic_period double 3 default=1.0\npublishers /diagnostics diagnostic_msgs/DiagnosticArray 3 queue=1",
    ),
    "image publisher": (
        'image_transport::ImageTransport it(nh);\nit.advertise("image", 1);',
        "publishers image sensor_msgs/Image 4 transport=image queue=1",
    ),
    "camera publisher": (
        'image_transport::ImageTransport it(ros::NodeHandle("~"));\nit.advertiseCamera("left/image_raw", 1);',
        """
        publishers {parent:~left/image_raw}/camera_info sensor_msgs/CameraInfo 4 queue=1
        publishers ~left/image_raw sensor_msgs/Image 4 transport=image queue=1
        """,
    ),
    "camera subscriber": (
        'image_transport::ImageTransport it(nh);\nit.subscribeCamera("image", 1, cb);',
        """
        params ~image_transport str 4 default="raw"
        subscribers image sensor_msgs/Image 4 transport=image queue=1
        subscribers {parent:image}/camera_info sensor_msgs/CameraInfo 4 queue=1
        """,
    ),
    "camera info": ('camera_info_manager::CameraInfoManager m(nh, "cam");', "services set_camera_info sensor_msgs/SetCameraInfo 3"),
    "realtime": ('realtime_tools::RealtimePublisher<std_msgs::Bool> p(nh, "on", 4);', "publishers on std_msgs/Bool 3 queue=4"),
}


@pytest.mark.parametrize("name", CALLS)
def test_call(tmp_path: Path, name: str) -> None:
    body, expected = CALLS[name]
    facts, doubts = program(tmp_path, in_main("ros::NodeHandle nh;\n" + body))
    assert [spelled(fact) for fact in facts] == lines(expected)
    assert doubts == ()


def test_service_with_an_overloaded_callback(tmp_path: Path) -> None:
    source = """
    class Node {
     public:
      Node() {
        nh.advertiseService("go", &Node::go, this);
        nh.subscribe("go", 1, &Node::go, this);
      }
      void go(const std_msgs::StringConstPtr& message) {}
      bool go(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) { return true; }
      ros::NodeHandle nh;
    };
    int main() { Node node; }
    """
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["services go std_srvs/SetBool 5", "subscribers go std_msgs/String 6 queue=1"]


def test_templates_are_followed_with_their_arguments(tmp_path: Path) -> None:
    source = """
    template <class M> void open(ros::NodeHandle nh, const std::string& name) { nh.advertise<M>(name, 1); }
    template <class M> class Echo {
     public:
      Echo() { nh.subscribe("in", 1, &Echo<M>::heard, this); }
      void heard(const typename M::ConstPtr& message) {}
      ros::NodeHandle nh;
    };
    int main() { ros::NodeHandle nh; open<std_msgs::Bool>(nh, "on"); Echo<std_msgs::Int32> echo; }
    """
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["publishers on std_msgs/Bool 2 queue=1", "subscribers in std_msgs/Int32 5 queue=1"]
    assert doubts == ()


def test_dynamic_reconfigure_reads_the_cfg_file(tmp_path: Path) -> None:
    files = {
        "main.cpp": "int main() { dynamic_reconfigure::Server<demo::SpeedConfig> server; }",
        "cfg/Speed.cfg": """
from dynamic_reconfigure.parameter_generator_catkin import *
import os
os.system("touch started")
gen = ParameterGenerator()
LIMIT = 5
gen.add("limit", double_t, 0, "how fast", LIMIT, 0, 10)
group = gen.add_group("more")
group.add("name", str_t, 0, "whose", "me")
group.add("on", bool_t, 0, "", True)
exit(gen.generate("demo", "demo", "Speed"))
""",
    }
    facts, doubts = program(tmp_path, files)
    assert [(spelled(fact), fact.path) for fact in facts] == [
        ("params ~limit double 7 default=5.0", "cfg/Speed.cfg"),
        ('params ~name str 9 default="me"', "cfg/Speed.cfg"),
        ("params ~on bool 10 default=true", "cfg/Speed.cfg"),
        ("publishers ~parameter_descriptions dynamic_reconfigure/ConfigDescription 1 latched queue=1", "main.cpp"),
        ("publishers ~parameter_updates dynamic_reconfigure/Config 1 latched queue=1", "main.cpp"),
        ("services ~set_parameters dynamic_reconfigure/Reconfigure 1", "main.cpp"),
    ]
    assert doubts == ()
    assert not (tmp_path / "started").exists()


def test_configuration_of_another_package_is_a_doubt(tmp_path: Path) -> None:
    _, doubts = program(tmp_path, "int main() { dynamic_reconfigure::Server<other::SpeedConfig> server; }")
    assert [(doubt.category, doubt.reason) for doubt in doubts] == [("params", "the params of other::SpeedConfig are declared elsewhere")]


def test_the_param_with_the_transport_of_images(tmp_path: Path) -> None:
    source = """int main() {
      ros::NodeHandle nh, pnh("~");
      image_transport::ImageTransport it(nh);
      image_transport::TransportHints hints("raw", ros::TransportHints(), pnh, "depth_transport");
      it.subscribe("depth", 1, cb, ros::VoidPtr(), hints);
    }"""
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [
        'params ~depth_transport str 4 default="raw"',
        "subscribers depth sensor_msgs/Image 5 transport=image queue=1",
        "subscribers depth/{param:~depth_transport} - 5 if ~depth_transport is not raw",
    ]
    assert doubts == ()


def test_a_member_is_defined_under_another_name_of_its_class(tmp_path: Path) -> None:
    source = """
    namespace ns { class Node : public nodelet::Nodelet { void onInit(); void advertise(); }; }
    typedef ns::Node Node;
    void Node::onInit() { advertise(); }
    void ns::Node::advertise() { getNodeHandle().advertise<std_msgs::Bool>("a", 1); }
    """
    assert [spelled(fact) for fact in program(tmp_path, source, "ns::Node")[0]] == ["publishers a std_msgs/Bool 5 queue=1"]


def test_a_base_class_of_another_namespace_is_called_by_its_own_name(tmp_path: Path) -> None:
    source = """
    namespace base { class Base : public nodelet::Nodelet { protected: void onInit() { pnh_ = getPrivateNodeHandle(); }
      ros::NodeHandle pnh_; }; }
    namespace ns { class Node : public base::Base { void onInit() { Base::onInit(); pnh_.advertise<std_msgs::Bool>("a", 1); } }; }
    """
    facts, doubts = program(tmp_path, source, "ns::Node")
    assert [spelled(fact) for fact in facts] == ["publishers ~a std_msgs/Bool 4 queue=1"]
    assert doubts == ()


def test_the_end_of_clock_and_rosout_that_not_every_node_has(tmp_path: Path) -> None:
    source = """
    int main() { ros::NodeHandle nh; nh.advertise<rosgraph_msgs::Clock>("/clock", 1); nh.subscribe("/rosout", 1, hear); }
    """
    assert [spelled(fact) for fact in program(tmp_path, source)[0]] == [
        "publishers /clock rosgraph_msgs/Clock 2 queue=1",
        "subscribers /rosout - 2 queue=1",
    ]


def test_an_array_of_characters_that_nobody_has_filled_is_no_text(tmp_path: Path) -> None:
    source = """
    void cb(const std_msgs::StringConstPtr& given) {
      char name[9];
      memcpy(name, given->data.c_str(), 8);
      ros::NodeHandle nh;
      nh.advertise<std_msgs::Bool>("of/" + std::string(name), 1);
    }
    int main() { ros::NodeHandle nh; nh.subscribe("given", 1, cb); }
    """
    assert "publishers of/{any} std_msgs/Bool 6 queue=1 when=message" in [spelled(fact) for fact in program(tmp_path, source)[0]]


def test_plugins_are_a_doubt(tmp_path: Path) -> None:
    facts, doubts = program(tmp_path, 'int main() { pluginlib::ClassLoader<demo::Layer> loader("demo", "demo::Layer"); }')
    assert facts == ()
    assert {(doubt.category, doubt.reason) for doubt in doubts} == {
        (category, "pluginlib::ClassLoader loads plugins, which may have interfaces of their own")
        for category in ("actions", "clients", "params", "publishers", "services", "subscribers")
    }


def test_of_what_type_a_param_was_does_not_matter_after_the_program_has_set_it(tmp_path: Path) -> None:
    source = """
        int main() { ros::NodeHandle nh; std::map<std::string, std::string> set, read, other;
          nh.setParam("set", set); nh.getParam("set", read);
          nh.getParam("other", other); nh.setParam("other", other); }
        """
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == ["params other dict 4", "params set - 3"]
