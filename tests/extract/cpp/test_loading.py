"""Plugins: nodelets that a program loads into itself, and classes that pluginlib loads by name."""

from __future__ import annotations

from pathlib import Path

from launchlint.extract.cpp import cpp_program
from launchlint.extract.fact import Plugin
from tests.extract.cpp.following import lines, spelled

NODELET = """
#include <std_msgs/Bool.h>
namespace image { class Rectify : public nodelet::Nodelet {
  virtual void onInit() {
    ros::NodeHandle nh = getNodeHandle();
    pub_ = nh.advertise<std_msgs::Bool>("image_rect", 1);
    sub_ = nh.subscribe("image_mono", 1, &Rectify::heard, this);
    getPrivateNodeHandle().param("queue_size", queue_, 5);
  }
  void heard(const std_msgs::BoolConstPtr& m) { getNodeHandle().serviceClient<std_srvs::Empty>("image_mono"); }
}; }
"""
RECTIFY = Plugin("image_proc/rectify", "image::Rectify", "nodelet::Nodelet")

PLANNERS = """
#include <nav_msgs/Path.h>
struct Planner { virtual void initialize(std::string name) = 0; };
struct Straight : public Planner {
  void initialize(std::string name) { ros::NodeHandle nh("~/" + name); nh.advertise<nav_msgs::Path>("plan", 1); }
};
struct Curved : public Planner {
  void initialize(std::string name) { ros::NodeHandle nh("~/" + name); nh.advertise<nav_msgs::Path>("curve", 1); }
};
"""
PLUGINS = (Plugin("planners/Straight", "Straight", "Planner"), Plugin("planners/Curved", "Curved", "Planner"))


def followed(root: Path, source: str, *plugins: Plugin) -> tuple[list[str], list[str]]:
    """All that is found, and for which categories there may be more, and why."""
    (root / "main.cpp").write_text(source)
    facts, doubts, _ = cpp_program([str(root / "main.cpp")], [], str(root), None, plugins)
    return [spelled(each) for each in facts], [f"{each.category}: {each.reason}" for each in doubts if each.category == "publishers"]


def test_a_nodelet_has_the_name_that_it_is_loaded_under(tmp_path: Path) -> None:
    main = """int main() {
      nodelet::Loader manager(false);
      nodelet::M_string remappings;
      nodelet::V_string arguments;
      manager.load(ros::this_node::getName() + "_mono", "image_proc/rectify", remappings, arguments);
      remappings["image_mono"] = ros::names::resolve("image_color");
      remappings["image_rect"] = "image_rect_color";
      manager.load(ros::this_node::getName(), "image_proc/rectify", remappings, arguments);
    }"""
    assert followed(tmp_path, main + NODELET, RECTIFY) == (
        lines(
            """
            clients image_color std_srvs/Empty 18 when=message
            clients image_mono std_srvs/Empty 18 when=message
            params {node}_mono/queue_size int 16 default=5
            params ~queue_size int 16 default=5
            publishers image_rect std_msgs/Bool 14 queue=1
            publishers image_rect_color std_msgs/Bool 14 queue=1
            subscribers image_color std_msgs/Bool 15 queue=1
            subscribers image_mono std_msgs/Bool 15 queue=1
            """
        ),
        [],
    )


def test_a_loader_serves_its_own_services_and_an_unknown_nodelet_is_a_doubt(tmp_path: Path) -> None:
    main = 'int main() { nodelet::Loader manager; manager.load(ros::this_node::getName(), "other/nodelet", r, a); }'
    assert followed(tmp_path, main, RECTIFY) == (
        lines(
            """
            params ~num_worker_threads int 1
            services ~list nodelet/NodeletList 1
            services ~load_nodelet nodelet/NodeletLoad 1
            services ~unload_nodelet nodelet/NodeletUnload 1
            """
        ),
        [
            "publishers: a nodelet is loaded whose class or name is not known",
            "publishers: nodelet::Loader loads nodelets, which have interfaces of their own",
        ],
    )


def test_a_plugin_chosen_by_a_param_is_one_of_those_that_are_known(tmp_path: Path) -> None:
    main = """int main() {
      pluginlib::ClassLoader<Planner> loader("planners", "Planner");
      std::string name;
      ros::NodeHandle("~").param("planner", name, std::string("planners/Straight"));
      boost::shared_ptr<Planner> planner = loader.createInstance(name);
      planner->initialize(loader.getName(name));
    }"""
    assert followed(tmp_path, main + PLANNERS, *PLUGINS) == (
        lines(
            """
            params ~planner str 4 default="planners/Straight"
            publishers ~Curved/curve nav_msgs/Path 14 queue=1 if the plugin planners/Curved is loaded
            publishers ~Straight/plan nav_msgs/Path 11 queue=1 if the plugin planners/Straight is loaded
            """
        ),
        ["publishers: pluginlib::ClassLoader loads plugins, which may have interfaces of their own"],
    )


def test_a_plugin_that_is_named_is_that_one(tmp_path: Path) -> None:
    main = """int main() {
      auto loader = std::make_shared<pluginlib::ClassLoader<Planner>>("planners", "Planner");
      auto planner = loader->createUniqueInstance("planners/Curved");
      planner->initialize("mine");
    }"""
    assert followed(tmp_path, main + PLANNERS, *PLUGINS)[0] == ["publishers ~mine/curve nav_msgs/Path 12 queue=1"]


def test_driver_base_runs_a_node_with_its_driver(tmp_path: Path) -> None:
    source = """
    class Driver { public: void doOpen() { ros::NodeHandle nh; nh.advertiseService("reset", &Driver::reset, this); } };
    class Node : public driver_base::DriverNode<Driver> {
     public:
      Node(ros::NodeHandle& nh) : driver_base::DriverNode<Driver>(nh), pub_(node_handle_.advertise<std_msgs::Bool>("scan", 1)) {}
      ros::Publisher pub_;
    };
    int main(int argc, char** argv) { return driver_base::main<Node>(argc, argv, "driver"); }
    """
    assert followed(tmp_path, source)[0] == lines(
        """
        params ~diagnostic_period double 5 default=1.0
        publishers /diagnostics diagnostic_msgs/DiagnosticArray 5 queue=1
        publishers scan std_msgs/Bool 5 queue=1
        publishers ~parameter_descriptions dynamic_reconfigure/ConfigDescription 5 latched queue=1
        publishers ~parameter_updates dynamic_reconfigure/Config 5 latched queue=1
        services reset - 2
        services ~self_test diagnostic_msgs/SelfTest 5
        services ~set_parameters dynamic_reconfigure/Reconfigure 5
        """
    )


def test_a_function_of_another_package_may_make_a_class_that_it_is_given(tmp_path: Path) -> None:
    source = """struct Node { Node() { ros::NodeHandle().advertise<std_msgs::Bool>("a", 1); } };
    int main(int argc, char** argv) { return framework::run<Node>(argc, argv); }"""
    assert followed(tmp_path, source) == ([], ["publishers: framework::run is not in these sources, and may make a Node"])
