"""From a workspace to a library."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from launchlint.errors import UsageError
from launchlint.extract.package import extract
from launchlint.library.validate import faults

MANIFEST = "<package format='2'><name>{name}</name><version>1.0.0</version>{more}</package>"
TALKER = "#!/usr/bin/env python3\nimport rospy\nfrom std_msgs.msg import String\nrospy.Publisher('chatter', String, queue_size=1)\n"

PLAIN = TALKER.partition("\n")[2]


def grow(root: Path, files: dict[str, str]) -> Path:
    """Write files; what begins with ``#!`` can be run."""
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        if text.startswith("#!"):
            path.chmod(0o755)
    return root


def program(root: Path, package: str, name: str, kind: str = "executables") -> Any:
    """What the library says of a program, after a look whether it is a library at all."""
    document = extract([str(root)]).document
    assert faults(document) == []
    return document["packages"][package][kind][name]


def at(*places: str) -> list[dict[str, str]]:
    return [{"by": "static", "at": f"ws:{place}"} for place in places]


def test_a_library_of_one_script(tmp_path: Path) -> None:
    root = grow(tmp_path / "ws", {"demo/package.xml": MANIFEST.format(name="demo", more=""), "demo/scripts/talker.py": TALKER})
    result = extract([str(root)])
    document = result.document
    document.pop("generator")
    assert document == {
        "format": "launchlint-library",
        "version": 1,
        "sources": [{"id": "ws", "url": "file:ws"}],
        "packages": {
            "demo": {
                "source": "ws",
                "executables": {
                    "talker.py": {
                        "class": "rospy",
                        "variants": {
                            "default": {
                                "publishers": [
                                    {"name": "chatter", "type": "std_msgs/String", "queue": 1, "evidence": at("demo/scripts/talker.py:4")}
                                ]
                            }
                        },
                    }
                },
            }
        },
    }
    assert (result.programs, result.names, result.unresolved, result.skipped) == (1, 1, 0, ())


def test_which_scripts_are_programs(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/CMakeLists.txt": "project(demo)\ncatkin_install_python(PROGRAMS nodes/installed.py DESTINATION x)\n"
            "install(PROGRAMS nodes/other RENAME renamed DESTINATION x)\n",
            "demo/nodes/installed.py": PLAIN,
            "demo/nodes/other": TALKER,
            "demo/setup.py": "from setuptools import setup\nsetup(scripts=['bin/by_setup'])\n",
            "demo/bin/by_setup": TALKER,
            "demo/src/plain_module.py": PLAIN,
            "demo/scripts/with_bit": TALKER,
            "demo/scripts/shell.sh": "#!/bin/sh\nrosrun demo x\n",
            "demo/scripts/no_ros.py": "#!/usr/bin/env python3\nprint('hello')\n",
            "demo/scripts/broken.py": "#!/usr/bin/env python3\ndef f(:\n",
        },
    )
    result = extract([str(root)])
    programs = result.document["packages"]["demo"]["executables"]
    assert {name: each["class"] for name, each in sorted(programs.items())} == {
        "by_setup": "rospy",
        "installed.py": "rospy",
        "no_ros.py": "none",
        "other": "rospy",
        "renamed": "rospy",
        "with_bit": "rospy",
    }
    assert [(each.name, each.path, each.reason) for each in result.skipped] == [
        ("shell.sh", "demo/scripts/shell.sh", "it is a script, but not Python"),
        ("broken.py", "demo/scripts/broken.py", "is not Python: line 2: invalid syntax"),
    ]


def test_modules_of_packages(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "one/package.xml": MANIFEST.format(name="one", more="<depend>two</depend>"),
            "one/setup.py": "generate_distutils_setup(packages=['one'], package_dir={'': 'src'})\n",
            "one/src/one/__init__.py": "",
            "one/src/one/talk.py": "import rospy\nfrom .names import NAME\nfrom two.msg import Thing\nimport two.tool\n"
            "def main():\n    rospy.Publisher(NAME, Thing)\n    two.tool.listen('in')\n",
            "one/src/one/names.py": "NAME = 'from_a_module'\n",
            "one/scripts/beside.py": "BESIDE = 'from_beside'\n",
            "one/scripts/talk": "#!/usr/bin/env python\nimport rospy\nfrom one import talk\nfrom beside import BESIDE\n"
            "talk.main()\nrospy.get_param(BESIDE)\n",
            "two/package.xml": MANIFEST.format(name="two", more=""),
            "two/src/two/__init__.py": "",
            "two/src/two/tool.py": "import rospy\nfrom std_msgs.msg import Bool\n\ndef listen(name):\n    rospy.Subscriber(name, Bool)\n",
        },
    )
    assert program(root, "one", "talk")["variants"]["default"] == {
        "publishers": [{"name": "from_a_module", "type": "two/Thing", "evidence": at("one/src/one/talk.py:6")}],
        "subscribers": [{"name": "in", "type": "std_msgs/Bool", "evidence": at("two/src/two/tool.py:5")}],
        "params": [{"name": "from_beside", "evidence": at("one/scripts/talk:6")}],
    }


def test_libraries_that_a_package_says_are_of_python(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "requirements.txt": "# tools\nlast_one>=1.0\n",
            "one/package.xml": MANIFEST.format(name="one", more="<exec_depend>python3-fast-laser-pip</exec_depend>"),
            "one/requirements.txt": "some.thing\n",
            "one/scripts/told": "#!/usr/bin/env python\nimport rospy\nimport fast_laser, some_thing\nfast_laser.go()\nsome_thing.go()\n",
            "one/scripts/not_told": "#!/usr/bin/env python\nimport rospy\nimport slow_laser\nslow_laser.go()\n",
        },
    )
    (root / "one/scripts/told").chmod(0o755)
    (root / "one/scripts/not_told").chmod(0o755)
    assert program(root, "one", "told")["variants"]["default"] == {}
    reason = "it uses slow_laser, whose source was not given (one/scripts/not_told:4)"
    assert set(program(root, "one", "not_told")["variants"]["default"]["open"].values()) == {reason}


def test_dynamic_reconfigure(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/cfg/Demo.cfg": "#!/usr/bin/env python\nfrom dynamic_reconfigure.parameter_generator_catkin import *\n"
            "gen = ParameterGenerator()\ngroup = gen.add_group('g')\ngen.add('speed', double_t, 0, 'how fast', 1.5, 0, 3)\n"
            "for side in ('left', 'right'):\n    group.add(side + '_on', bool_t, 0, '', False)\n"
            "exit(gen.generate('demo', 'demo', 'Demo'))\n",
            "demo/scripts/node": "#!/usr/bin/env python\nfrom dynamic_reconfigure.server import Server\nfrom demo.cfg import DemoConfig\n"
            "Server(DemoConfig, lambda config, level: config)\n",
        },
    )
    here = at("demo/scripts/node:4")
    described = at("demo/cfg/Demo.cfg:7")
    assert program(root, "demo", "node")["variants"]["default"] == {
        "publishers": [
            {
                "name": "~parameter_descriptions",
                "type": "dynamic_reconfigure/ConfigDescription",
                "latched": True,
                "queue": 10,
                "evidence": here,
            },
            {"name": "~parameter_updates", "type": "dynamic_reconfigure/Config", "latched": True, "queue": 10, "evidence": here},
        ],
        "services": [{"name": "~set_parameters", "type": "dynamic_reconfigure/Reconfigure", "evidence": here}],
        "params": [
            {"name": "~left_on", "default": False, "type": "bool", "evidence": described},
            {"name": "~right_on", "default": False, "type": "bool", "evidence": described},
            {"name": "~speed", "default": 1.5, "type": "double", "evidence": at("demo/cfg/Demo.cfg:5")},
        ],
    }


def test_several_places_of_one_name(tmp_path: Path) -> None:
    source = (
        "#!/usr/bin/env python\nimport rospy\nfrom std_msgs.msg import Bool, String\n"
        "if rospy.get_param('~a', 1):\n    rospy.Publisher('x', String)\nelse:\n    rospy.Publisher('x', Bool)\n"
        "rospy.wait_for_service('s')\nrospy.get_param('~a', 2.0)\n"
        "if rospy.has_param('~b'):\n    rospy.Subscriber('y', Bool)\nif rospy.has_param('~c'):\n    rospy.Subscriber('y', Bool)\n"
        "if rospy.has_param('~c'):\n    rospy.Subscriber('z', Bool)\nrospy.Subscriber('z', Bool)\n"
        "rospy.Publisher('twice', Bool)\nrospy.Publisher('twice', String)\n"
        "rospy.Publisher(input(), String)\n"
    )
    root = grow(tmp_path / "ws", {"demo/package.xml": MANIFEST.format(name="demo", more=""), "demo/n": source})
    assert program(root, "demo", "n")["variants"]["default"] == {
        "publishers": [
            {"name": "twice", "evidence": at("demo/n:17", "demo/n:18")},
            {
                "name": "x",
                "type": "std_msgs/Bool",
                "condition": {"text": "not rospy.get_param('~a', 1)"},
                "evidence": at("demo/n:7"),
            },
            {"name": "x", "type": "std_msgs/String", "condition": {"text": "rospy.get_param('~a', 1)"}, "evidence": at("demo/n:5")},
            {"name": "{any}", "type": "std_msgs/String", "evidence": at("demo/n:19")},
        ],
        "subscribers": [
            {
                "name": "y",
                "type": "std_msgs/Bool",
                "condition": {"any": [{"text": "rospy.has_param('~b')"}, {"text": "rospy.has_param('~c')"}]},
                "evidence": at("demo/n:11", "demo/n:13"),
            },
            {"name": "z", "type": "std_msgs/Bool", "evidence": at("demo/n:15", "demo/n:16")},
        ],
        "clients": [{"name": "s", "evidence": at("demo/n:8")}],
        "params": [
            {"name": "~a", "evidence": at("demo/n:4", "demo/n:9")},
            {"name": "~b", "evidence": at("demo/n:10")},
            {"name": "~c", "evidence": at("demo/n:12", "demo/n:14")},
        ],
        "literals": ["twice"],
    }


def test_topics_of_an_action_are_not_listed_and_what_is_called_like_them_is(tmp_path: Path) -> None:
    source = (
        "#!/usr/bin/env python\nimport rospy, actionlib\nfrom demo.msg import GoAction, GoActionGoal\nfrom std_msgs.msg import String\n"
        "name = input()\nactionlib.SimpleActionClient('go', GoAction)\nrospy.Publisher('go/goal', GoActionGoal)\n"
        "actionlib.SimpleActionClient(name, GoAction)\nrospy.Subscriber(name + '/feedback', String)\n"
    )
    root = grow(tmp_path / "ws", {"demo/package.xml": MANIFEST.format(name="demo", more=""), "demo/n": source})
    variant = program(root, "demo", "n")["variants"]["default"]
    assert [entry["name"] for entry in variant["actions"]] == ["go", "{any}"]
    assert "publishers" not in variant
    assert variant["subscribers"] == [{"name": "{any}/feedback", "type": "std_msgs/String", "evidence": at("demo/n:9")}]


def test_an_rqt_plugin(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "rqt_demo/package.xml": MANIFEST.format(name="rqt_demo", more=""),
            "rqt_demo/plugin.xml": "<library path='src'>"
            "<class name='Demo' type='rqt_demo.view.View' base_class_type='rqt_gui_py::Plugin'/></library>",
            "rqt_demo/src/rqt_demo/__init__.py": "",
            "rqt_demo/src/rqt_demo/view.py": "import rospy\nfrom rqt_gui_py.plugin import Plugin\nfrom std_msgs.msg import Bool\n"
            "class View(Plugin):\n    def __init__(self, context):\n        super(View, self).__init__(context)\n"
            "        rospy.Subscriber('shown', Bool, None)\n",
            "rqt_demo/scripts/rqt_demo": "#!/usr/bin/env python\nimport sys\nfrom rqt_gui.main import Main\n"
            "Main().main(sys.argv, standalone='rqt_demo')\n",
        },
    )
    assert program(root, "rqt_demo", "rqt_demo")["variants"]["default"] == {
        "subscribers": [{"name": "shown", "type": "std_msgs/Bool", "evidence": at("rqt_demo/src/rqt_demo/view.py:7")}]
    }


def test_only_some_packages_and_more_processes(tmp_path: Path) -> None:
    files = {f"p{n}/package.xml": MANIFEST.format(name=f"p{n}", more="") for n in range(9)}
    root = grow(tmp_path / "ws", {**files, **{f"p{n}/talker": TALKER for n in range(9)}})
    assert extract([str(root)], jobs=2).document == extract([str(root)]).document
    assert list(extract([str(root)], ["p3"]).document["packages"]) == ["p3"]
    with pytest.raises(UsageError, match="--package p33: there is no such package in these sources; there are 9 packages: p0"):
        extract([str(root)], ["p33"])


@pytest.mark.parametrize(
    ("name", "message"),
    [("missing", "cannot read sources from .*: it does not exist"), ("file", "it is a file"), ("empty", "there is no package in")],
)
def test_what_is_no_source(name: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "empty").mkdir()
    with pytest.raises(UsageError, match=message):
        extract([str(tmp_path / name)])


DEPENDS = "<depend>{name}</depend>"
HEADER = "#pragma once\nnamespace lib { class Map { public: Map(ros::NodeHandle nh); void unused(); }; }\n"


def test_sources_of_a_library_of_another_package_come_with_its_header(tmp_path: Path) -> None:
    root = grow(
        tmp_path / "ws",
        {
            "node/package.xml": MANIFEST.format(name="node", more=DEPENDS.format(name="maps")),
            "node/CMakeLists.txt": "project(node)\nadd_executable(node src/main)\ntarget_link_libraries(node ${catkin_LIBRARIES})\n",
            "node/src/main.cpp": "#include <deep/map.h>\nint main() { ros::NodeHandle nh; lib::Map map(nh); }\n",
            "maps/package.xml": MANIFEST.format(name="maps", more=""),
            "maps/CMakeLists.txt": 'project(maps)\ninclude_directories(parts/include)\nset(S "src/map.cpp" "src/other.cpp")\n'
            'add_library(maps "${S}")\n',
            "maps/parts/include/deep/map.h": HEADER,
            "maps/src/map.cpp": '#include "deep/map.h"\nlib::Map::Map(ros::NodeHandle nh) { nh.advertise<nav_msgs::Path>("map", 1); }\n',
            "maps/src/other.cpp": "this is no C++ at all, and nobody reads it: ros::NodeHandle(",
        },
    )
    assert program(root, "node", "node") == {
        "class": "roscpp",
        "variants": {
            "default": {"publishers": [{"name": "map", "type": "nav_msgs/Path", "queue": 1, "evidence": at("maps/src/map.cpp:2")}]}
        },
    }


def test_a_plugin_of_another_package_is_followed(tmp_path: Path) -> None:
    described = "<library path='lib/libcurved'><class name='curved/Curved' type='Curved' base_class_type='Planner'/></library>"
    exported = "<export><planners plugin='${prefix}/plugins.xml'/></export>"
    root = grow(
        tmp_path / "ws",
        {
            "node/package.xml": MANIFEST.format(name="node", more=""),
            "node/CMakeLists.txt": "project(node)\nadd_executable(node main.cpp)\n",
            "node/main.cpp": "struct Planner {};\nint main() {\n"
            'pluginlib::ClassLoader<Planner> loader("node", "Planner");\nloader.createInstance("curved/Curved");\n}\n',
            "curved/package.xml": MANIFEST.format(name="curved", more=exported),
            "curved/plugins.xml": described,
            "curved/CMakeLists.txt": "project(curved)\nadd_library(curved curved.cpp)\n",
            "curved/curved.cpp": 'struct Curved { Curved() { ros::NodeHandle().advertise<nav_msgs::Path>("curve", 1); } };\n',
        },
    )
    found = program(root, "node", "node")["variants"]["default"]
    assert found["publishers"] == [{"name": "curve", "type": "nav_msgs/Path", "queue": 1, "evidence": at("curved/curved.cpp:1")}]
    assert "open" not in found  # no other plugin than this one is loaded


def test_programs_that_import_nothing_of_ros_are_none(tmp_path: Path) -> None:
    head = "#!/usr/bin/env python\n"
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more=""),
            "demo/src/demo/__init__.py": "",
            "demo/src/demo/plain.py": "import numpy\nfrom demo import beside\n",
            "demo/src/demo/beside.py": "import os\n",
            "demo/src/demo/talk.py": "import rospy\nrospy.wait_for_service('s')\n",
            "demo/src/demo/strange.py": "from other_package import *\n",
            "demo/src/demo/old.py": "import talk\n",
            "demo/scripts/quiet": head + "import sys, yaml\nfrom demo import plain\nfrom demo.beside import something\nprint(something)\n",
            "demo/scripts/by_module": head + "from demo import talk\n",
            "demo/scripts/deep": head + "import os.path\ndef f():\n    import demo.talk\nf()\n",
            "demo/scripts/as_python_2": head + "import demo.old\n",
            "demo/scripts/worked_out": head + "import importlib\nimportlib.import_module('demo.talk')\n",
            "demo/scripts/by_text": head + "__import__('demo.talk')\n",
            "demo/scripts/by_builtin": head + "import __builtin__\n__builtin__.__import__('demo.talk')\n",
            "demo/scripts/stranger": head + "from demo import strange\nstrange.go()\n",
        },
    )
    for path in (root / "demo/scripts").iterdir():
        path.chmod(0o755)
    programs = extract([str(root)]).document["packages"]["demo"]["executables"]
    assert {name: each["class"] for name, each in sorted(programs.items())} == {
        "as_python_2": "rospy",
        "by_builtin": "rospy",
        "by_module": "rospy",
        "by_text": "rospy",
        "deep": "rospy",
        "quiet": "none",
        "stranger": "rospy",
        "worked_out": "rospy",
    }
    assert {name for name, each in programs.items() if each["variants"]["default"].get("clients")} == set(programs) - {"quiet", "stranger"}


def test_a_name_from_a_param_whose_name_is_not_known(tmp_path: Path) -> None:
    plugin = """class Reader : public nodelet::Nodelet {
    void init(ros::NodeHandle& nh) { std::string t; nh.getParam("topic", t); ros::NodeHandle().advertise<std_msgs::Bool>(t, 1); }
    };
    """
    root = grow(
        tmp_path / "ws",
        {
            "demo/package.xml": MANIFEST.format(name="demo", more="<export><nodelet plugin='${prefix}/plugins.xml'/></export>"),
            "demo/plugins.xml": "<library path='lib/libdemo'>"
            "<class name='demo/Reader' type='Reader' base_class_type='nodelet::Nodelet'/></library>",
            "demo/CMakeLists.txt": "project(demo)\nadd_library(demo reader.cpp)\n",
            "demo/reader.cpp": plugin,
        },
    )
    variant = program(root, "demo", "demo/Reader", "nodelets")["variants"]["default"]
    assert [(each["name"], each["type"]) for each in variant["publishers"]] == [("{any}", "std_msgs/Bool")]
    assert variant["open"]["publishers"].endswith("(demo/reader.cpp:2)")


def test_classes_that_register_themselves_come_with_their_library(tmp_path: Path) -> None:
    """Nothing includes the header of the class: an object that is made as the library is loaded tells the registry how to make it."""
    root = grow(
        tmp_path / "ws",
        {
            "node/package.xml": MANIFEST.format(name="node", more="<depend>modules</depend>"),
            "node/CMakeLists.txt": "project(node)\nadd_executable(node src/main.cpp)\ntarget_link_libraries(node ${catkin_LIBRARIES})\n",
            "node/src/main.cpp": '#include <modules/registry.h>\nint main() { modules::make("Map"); }\n',
            "modules/package.xml": MANIFEST.format(name="modules", more=""),
            "modules/CMakeLists.txt": "project(modules)\nadd_library(modules src/registry.cpp src/map.cpp src/other.cpp)\n",
            "modules/include/modules/registry.h": (
                "namespace modules {\nclass Module { public: virtual ~Module() {} };\nModule* make(const std::string& name);\n"
                "std::map<std::string, std::function<Module*()>>& entries();\n"
                "template <class T> struct Registration {\n  explicit Registration(const std::string& name) {\n"
                "    entries().insert(std::make_pair(name, []() { return new T(); }));\n  }\n};\n}\n"
            ),
            "modules/src/registry.cpp": (
                "#include <modules/registry.h>\nnamespace modules {\n"
                "std::map<std::string, std::function<Module*()>>& entries() { static std::map<std::string, std::function<Module*()>> e; "
                "return e; }\nModule* make(const std::string& name) { return entries().at(name)(); }\n}\n"
            ),
            "modules/src/map.cpp": (
                "#include <modules/registry.h>\nnamespace modules {\nclass Map : public Module {\n  ros::NodeHandle nh_;\n"
                '  ros::Publisher pub_;\n public:\n  Map() { pub_ = nh_.advertise<nav_msgs::OccupancyGrid>("map", 1); }\n'
                "  static Registration<Map> registration;\n};\nRegistration<Map> Map::registration(\n"
                '    "Map");\n}\n'
            ),
            "modules/src/other.cpp": "namespace modules { void unused() { ros::NodeHandle().advertise<std_msgs::String>(name, 1); } }\n",
        },
    )
    default = program(root, "node", "node")["variants"]["default"]
    assert [each["name"] for each in default["publishers"]] == ["map"]
    assert "open" not in default


def test_implementations_that_call_each_other_are_followed_to_an_end(tmp_path: Path) -> None:
    """Each of them asks the next one, of which only the base class is known: these are more ways than can be followed."""
    classes = "".join(
        f"class C{each} : public Base {{\n  bool ask(int x) override {{ return next_->ask(x + 1) && next_->ask(x + 2); }}\n}};\n"
        for each in range(12)
    )
    main = (
        "#include <ros/ros.h>\nclass Base {\n public:\n  virtual bool ask(int x) = 0;\n  Base* next_;\n};\n"
        f"{classes}int main() {{\n  Base* base = find();\n  base->ask(1);\n  ros::NodeHandle nh;\n"
        '  ros::Publisher pub = nh.advertise<std_msgs::String>("last", 1);\n}\n'
    )
    root = grow(
        tmp_path / "ws",
        {
            "node/package.xml": MANIFEST.format(name="node", more=""),
            "node/CMakeLists.txt": "project(node)\nadd_executable(node main.cpp)\n",
            "node/main.cpp": main,
        },
    )
    default = program(root, "node", "node")["variants"]["default"]
    assert [each["name"] for each in default["publishers"]] == ["last"]
    assert not any("too long" in reason for reason in default.get("open", {}).values())


def test_a_module_that_is_called_leaves_all_open(tmp_path: Path) -> None:
    """``from drive import Drive`` takes the module of that name where the package lacks the class: nobody knows what was meant."""
    files = {
        "demo/package.xml": MANIFEST.format(name="demo", more=""),
        "demo/setup.py": "from setuptools import setup\nsetup(packages=['drive'], package_dir={'': 'src'})\n",
        "demo/src/drive/__init__.py": "",
        "demo/src/drive/Drive.py": "import rospy\nfrom std_msgs.msg import String\nclass Drive:\n"
        "    def __init__(self):\n        self.pub = rospy.Publisher('speed', String, queue_size=1)\n",
        "demo/scripts/node.py": "#!/usr/bin/env python\nimport rospy\nfrom drive import Drive\nrospy.init_node('drive')\nDrive()\n",
    }
    variant = program(grow(tmp_path / "ws", files), "demo", "node.py")["variants"]["default"]
    assert "the module drive.Drive is called" in variant["open"]["publishers"]
    files["demo/src/drive/__init__.py"] = "from .Drive import Drive\n"
    variant = program(grow(tmp_path / "other", files), "demo", "node.py")["variants"]["default"]
    assert [each["name"] for each in variant["publishers"]] == ["speed"]
    assert "publishers" not in variant.get("open", {})
