from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import in_main, lines, program, spelled

CASES = {
    "default": ('ros::NodeHandle nh;\nnh.advertise<std_msgs::String>("a", 5);', "publishers a std_msgs/String 3 queue=5"),
    "private": (
        'ros::NodeHandle nh("~");\nnh.advertise<std_msgs::String>("a", 5, true);',
        "publishers ~a std_msgs/String 3 latched queue=5",
    ),
    "sub": ('ros::NodeHandle nh("arm");\nnh.advertise<std_msgs::String>("a", 5);', "publishers arm/a std_msgs/String 3 queue=5"),
    "global": ('ros::NodeHandle nh("/arm");\nnh.advertise<std_msgs::String>("a", 5);', "publishers /arm/a std_msgs/String 3 queue=5"),
    "global name": ('ros::NodeHandle nh("~");\nnh.advertise<std_msgs::String>("/a", 5);', "publishers /a std_msgs/String 3 queue=5"),
    "private, named by a param": (
        """
        std::string name = ros::param::param<std::string>("~camera", "camera");
        ros::NodeHandle nh("~/" + name);
        nh.advertise<std_msgs::String>("a", 5);
        """,
        """
        params ~camera str 2 default="camera"
        publishers ~/{param:~camera|camera}/a std_msgs/String 4 queue=5
        """,
    ),
    "a name of a param in a private one": (
        """
        std::string name = ros::param::param<std::string>("~camera", "camera");
        ros::NodeHandle nh(ros::NodeHandle("~"), name);
        nh.advertise<std_msgs::String>("a", 5);
        """,
        """
        params ~camera str 2 default="camera"
        publishers ~{param:~camera|camera}/a std_msgs/String 4 queue=5
        """,
    ),
    "nested": (
        'ros::NodeHandle nh("~");\nros::NodeHandle arm(nh, "arm");\narm.advertise<std_msgs::String>("a", 5);',
        "publishers ~arm/a std_msgs/String 4 queue=5",
    ),
    "copy": (
        'ros::NodeHandle nh("~");\nros::NodeHandle b(nh);\nb.advertise<std_msgs::String>("a", 5);',
        "publishers ~a std_msgs/String 4 queue=5",
    ),
    "pointer": (
        'ros::NodeHandle* nh = new ros::NodeHandle("~");\nnh->advertise<std_msgs::String>("a", 5);',
        "publishers ~a std_msgs/String 3 queue=5",
    ),
    "shared pointer": (
        'boost::shared_ptr<ros::NodeHandle> nh = boost::make_shared<ros::NodeHandle>("~");\nnh->advertise<std_msgs::String>("a", 5);',
        "publishers ~a std_msgs/String 3 queue=5",
    ),
    "reset": (
        'std::unique_ptr<ros::NodeHandle> nh;\nnh.reset(new ros::NodeHandle("~"));\nnh->advertise<std_msgs::String>("a", 5);',
        "publishers ~a std_msgs/String 4 queue=5",
    ),
    "one of two": (
        'ros::NodeHandle nh;\nif (argc > 3) nh = ros::NodeHandle("~");\nnh.advertise<std_msgs::String>("a", 5);',
        """
        publishers a std_msgs/String 4 queue=5 if !(argc > 3)
        publishers ~a std_msgs/String 4 queue=5 if argc > 3
        """,
    ),
    "by the size of the namespace": (
        'ros::NodeHandle nh;\nif (nh.getNamespace().size() <= 1) nh = ros::NodeHandle("~");\nnh.advertise<std_msgs::String>("a", 5);',
        """
        publishers a std_msgs/String 4 queue=5 if !(nh.getNamespace().size() <= 1)
        publishers ~a std_msgs/String 4 queue=5 if nh.getNamespace().size() <= 1
        """,
    ),
    "by the namespace of the node": (
        """
        ros::NodeHandle nh;
        if (ros::this_node::getNamespace() == "/") nh.advertise<std_msgs::String>("a", 5);
        if (ros::this_node::getNamespace() != "/") nh.advertise<std_msgs::String>("b", 5);
        std::string space = ros::this_node::getNamespace().substr(1);
        nh.advertise<std_msgs::String>("/of" + space, 5);
        """,
        """
        publishers /of{any} std_msgs/String 6 queue=5
        publishers a std_msgs/String 3 queue=5 if ros::this_node::getNamespace() == "/"
        publishers b std_msgs/String 4 queue=5 if ros::this_node::getNamespace() != "/"
        """,
    ),
    "by the name of the node": (
        """
        ros::NodeHandle nh, left("~left"), here("~");
        if (ros::this_node::getName() == "/one") nh.advertise<std_msgs::String>("a", 5);
        if (here.getNamespace() == "/one") nh.advertise<std_msgs::String>("b", 5);
        if (left.getNamespace().length() > 9) nh.advertise<std_msgs::String>("c", 5);
        """,
        """
        publishers a std_msgs/String 3 queue=5 if ros::this_node::getName() == "/one"
        publishers b std_msgs/String 4 queue=5 if here.getNamespace() == "/one"
        publishers c std_msgs/String 5 queue=5 if left.getNamespace().length() > 9
        """,
    ),
    "by a namespace that is known": (
        """
        ros::NodeHandle nh("/arm");
        if (nh.getNamespace() == "/arm") nh.advertise<std_msgs::String>("a", 5);
        if (nh.getNamespace().size() <= 1) nh.advertise<std_msgs::String>("b", 5);
        """,
        "publishers /arm/a std_msgs/String 3 queue=5",
    ),
    "by getName": (
        """
        ros::NodeHandle nh;
        nh.advertise<std_msgs::String>(ros::this_node::getName() + "/a", 5);
        nh.advertise<std_msgs::String>(ros::this_node::getName() + "_b", 5);
        """,
        """
        publishers {node}_b std_msgs/String 4 queue=5
        publishers ~a std_msgs/String 3 queue=5
        """,
    ),
    "resolved": (
        'ros::NodeHandle nh;\nnh.subscribe(nh.resolveName("rgb") + "/image", 1, cb);',
        "subscribers {remap:rgb}/image - 3 queue=1",
    ),
    "argument": ("ros::NodeHandle nh;\nnh.advertise<std_msgs::String>(argv[1], 5);", "publishers {arg:1} std_msgs/String 3 queue=5"),
    "a slash is no namespace": (
        (
            'ros::NodeHandle nh("/"), own("~"), inner(own, "/"), k(nh, "k");\nnh.serviceClient<std_srvs::Empty>("a");\n'
            'inner.serviceClient<std_srvs::Empty>("b");\nk.serviceClient<std_srvs::Empty>("c");'
        ),
        "clients a std_srvs/Empty 3\nclients k/c std_srvs/Empty 5\nclients ~b std_srvs/Empty 4",
    ),
    "alias of a namespace": (
        'namespace r = ros;\nros::NodeHandle nh;\nnh.serviceClient<std_srvs::Empty>("a");',
        "clients a std_srvs/Empty 4",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_namespace_of_a_node_handle(tmp_path: Path, name: str) -> None:
    body, expected = CASES[name]
    facts, doubts = program(tmp_path, in_main(body))
    assert [spelled(fact) for fact in facts] == lines(expected)
    assert doubts == ()


def test_handle_and_name_travel_together_through_constructors(tmp_path: Path) -> None:
    source = """
    #include <sensor_msgs/LaserScan.h>
    class Base {
     public:
      explicit Base(ros::NodeHandle& nh) : nh_(nh), pnh_("~") {}
      void open(const std::string& topic) { pub_ = nh_.advertise<sensor_msgs::LaserScan>(topic, 1); }
      ros::NodeHandle nh_, pnh_;
      ros::Publisher pub_;
    };
    class Node : public Base {
     public:
      Node(ros::NodeHandle nh, std::string prefix = "front") : Base(nh), prefix_(prefix) {
        open(prefix_ + "/scan");
        pnh_.param("rate", rate_, 10.0);
      }
      std::string prefix_;
      double rate_;
    };
    int main(int argc, char** argv) {
      ros::NodeHandle nh("robot");
      Node one(nh);
      Node* two = new Node(ros::NodeHandle("~"), "rear");
    }
    """
    facts, doubts = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == lines(
        """
        params ~rate double 14 default=10.0
        publishers robot/front/scan sensor_msgs/LaserScan 6 queue=1
        publishers ~rear/scan sensor_msgs/LaserScan 6 queue=1
        """
    )
    assert doubts == ()


def test_class_in_a_header_with_its_constructor_in_another_file(tmp_path: Path) -> None:
    files = {
        "include/demo/node.h": "namespace demo { class Node { public: Node(ros::NodeHandle nh, int queue = 7); ros::Publisher pub_; }; }",
        "src/node.cpp": '#include "demo/node.h"\nusing namespace demo;\n'
        'Node::Node(ros::NodeHandle nh, int queue) { pub_ = nh.advertise<std_msgs::Bool>("on", queue); }',
        "src/main.cpp": "#include <demo/node.h>\nint main() { ros::NodeHandle nh; demo::Node node(nh); }",
    }
    facts, doubts = program(tmp_path, files)
    assert [(spelled(fact), fact.path) for fact in facts] == [("publishers on std_msgs/Bool 3 queue=7", "src/node.cpp")]
    assert doubts == ()


def test_handle_given_to_code_that_is_not_there_is_a_doubt_in_every_category(tmp_path: Path) -> None:
    facts, doubts = program(tmp_path, in_main("ros::NodeHandle nh;\nelsewhere::Planner planner(nh);"))
    assert facts == ()
    assert [(doubt.category, doubt.reason, doubt.line) for doubt in doubts] == [
        (category, "elsewhere::Planner is given a node handle, and is not in these sources", 3)
        for category in ("actions", "clients", "params", "publishers", "services", "subscribers")
    ]


def test_nodelet(tmp_path: Path) -> None:
    source = """
    namespace demo {
    class Relay : public nodelet::Nodelet {
      virtual void onInit() {
        ros::NodeHandle& private_nh = getPrivateNodeHandle();
        image_transport::ImageTransport it(getNodeHandle());
        boost::lock_guard<boost::mutex> lock(mutex_);
        pub_ = private_nh.advertise<std_msgs::String>("out", 1, boost::bind(&Relay::connect, this));
      }
      void connect() { sub_ = getNodeHandle().subscribe("in", 2, &Relay::heard, this); }
      void heard(const std_msgs::StringConstPtr& message) {}
    };
    }
    """
    facts, doubts = program(tmp_path, source, "demo::Relay")
    assert [spelled(fact) for fact in facts] == lines(
        """
        publishers ~out std_msgs/String 8 queue=1
        subscribers in std_msgs/String 10 queue=2 when=subscriber
        """
    )
    assert doubts == ()


FURTHER = "if where nothing nearer is set"
SEARCHES = {
    'ros::param::search("ids", found);': ("~ids - 3", f"ids - 3 {FURTHER}", f"/ids - 3 {FURTHER}"),
    'ros::NodeHandle("~").searchParam("ids", found);': ("~ids - 3", f"ids - 3 {FURTHER}", f"/ids - 3 {FURTHER}"),
    'ros::NodeHandle("a").searchParam("ids", found);': ("a/ids - 3", f"ids - 3 {FURTHER}", f"/ids - 3 {FURTHER}"),
    'ros::param::search("/a/b", "ids", found);': ("/a/b/ids - 3", f"/a/ids - 3 {FURTHER}", f"/ids - 3 {FURTHER}"),
    'ros::param::search("/ids", found);': ("/ids - 3",),
    'std::string s; ros::param::param<std::string>("~s", s, "/a/b"); ros::NodeHandle(s).searchParam("ids", found);': (
        '~s str 3 default="/a/b"',
        "{param:~s|/a/b}/ids - 3",
        f"{{any}}/ids - 3 {FURTHER}",
        f"/ids - 3 {FURTHER}",
    ),
}


@pytest.mark.parametrize("call", SEARCHES)
def test_searched_upward(tmp_path: Path, call: str) -> None:
    facts, _ = program(tmp_path, in_main(f"std::string found;\n{call}"))
    assert sorted(spelled(fact) for fact in facts) == sorted(f"params {line}" for line in SEARCHES[call])


def test_what_was_found_is_read(tmp_path: Path) -> None:
    facts, _ = program(
        tmp_path, in_main('std::string found;\nros::param::search("rate", found);\nint rate;\nros::param::get(found, rate);')
    )
    assert "params ~rate int 5" in [spelled(fact) for fact in facts]


def test_private_names_of_the_process_are_those_of_a_manager_that_a_nodelet_does_not_know(tmp_path: Path) -> None:
    facts, doubts = program(
        tmp_path,
        """
        class N : public nodelet::Nodelet {
          void onInit() {
            ros::NodeHandle own("~"), below("~/camera");
            first_ = own.advertise<std_msgs::String>("manager", 1);
            second_ = below.advertise<std_msgs::String>("image", 1);
            third_ = getPrivateNodeHandle().advertise<std_msgs::String>("nodelet", 1);
          }
        };
        """,
        entry="N",
    )
    assert [each.name for each in facts] == ["{any}/camera/image", "{any}/manager", "~nodelet"]
    assert {each.category for each in doubts} == {"publishers"}
