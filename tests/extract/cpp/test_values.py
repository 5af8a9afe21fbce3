from __future__ import annotations

from pathlib import Path

import pytest

from tests.extract.cpp.following import in_main, lines, program, spelled

PARAMS = {
    "param": ('int n;\npnh.param("n", n, 5);', "params ~n int 4 default=5"),
    "explicit": ('double d;\npnh.param<double>("d", d, 1);', "params ~d double 4 default=1.0"),
    "returned": ('bool b = nh.param("b", true);', "params b bool 3 default=true"),
    "returned, explicit": ('auto s = nh.param<std::string>("s", "x");', 'params s str 3 default="x"'),
    "getParam": ('std::vector<double> v;\nnh.getParam("v", v);', "params v list 4"),
    "of any type": ('XmlRpc::XmlRpcValue v;\nnh.getParam("v", v);', "params v * 4"),
    "also of any type": (
        'std::string s;\nXmlRpc::XmlRpcValue v;\nnh.getParam("v", s);\nnh.getParam("v", v);',
        "params v str 5\nparams v * 6",
    ),
    "cached": ('int n;\nnh.getParamCached("/n", n);', "params /n int 4"),
    "hasParam": ('if (nh.hasParam("n")) return 1;', "params n - 3"),
    "ros::param": ('std::string s;\nros::param::param<std::string>("~s", s, "x");', 'params ~s str 4 default="x"'),
    "ros::param::get": ('bool b;\nros::param::get("b", b);', "params b bool 4"),
    "negative": ('pnh.param("n", n, -5);', "params ~n int 3 default=-5"),
    "constant": ('const double LIMIT = 2.5;\npnh.param("n", n, 2 * LIMIT);', "params ~n double 4 default=5.0"),
    "a constant of elsewhere": ('std::string s;\npnh.param("s", s, elsewhere::TOPIC);', "params ~s str 4"),
    "not a constant": ('double n;\npnh.param("n", n, compute());', "params ~n double 4"),
}


@pytest.mark.parametrize("name", PARAMS)
def test_param(tmp_path: Path, name: str) -> None:
    body, expected = PARAMS[name]
    facts, doubts = program(tmp_path, in_main('ros::NodeHandle nh, pnh("~");\n' + body))
    assert [spelled(fact) for fact in facts] == lines(expected)
    assert doubts == ()


NAMES = {
    "of a param": ('std::string t;\npnh.param<std::string>("topic", t, "scan");', "{param:~topic|scan}"),
    "of a param without default": ('std::string t;\npnh.getParam("topic", t);', "{param:~topic}"),
    "of a param with a constant of elsewhere": (
        'std::string t;\npnh.param<std::string>("topic", t, elsewhere::TOPIC);',
        "{param:~topic|{any}}",
    ),
    "of a param that gives a constant of elsewhere": (
        'auto t = pnh.param<std::string>("topic", elsewhere::TOPIC);',
        "{param:~topic|{any}}",
    ),
    "of a param over a value": ('std::string t = "scan";\npnh.getParam("topic", t);', "{param:~topic|scan}"),
    "of a param, else a constant": ('std::string t;\nif (!pnh.getParam("topic", t)) t = "scan";', "{param:~topic|scan}"),
    "of a param with something behind": ('std::string t = pnh.param<std::string>("ns", "a") + "/b";', "{param:~ns|a}/b"),
    "of a param of a param": (
        'std::string a = pnh.param<std::string>("a", "x");\nstd::string t = pnh.param<std::string>("b", a);',
        "{param:~b|{param:~a|x}}",
    ),
    "put together": ('std::string t = std::string("a") + "/" + std::to_string(2);', "a/2"),
    "a stream": ('std::stringstream s;\ns << "a" << 2;\nstd::string t = s.str();', "a2"),
    "a format": ('std::string t = boost::str(boost::format("a%d/%s") % 2 % "b");', "a2/b"),
    "printf": ('char t[20];\nsnprintf(t, 20, "a%02d", 2);', "a02"),
    "of what does not begin so": ('std::string t = "scan";\nif (t.find("/") == 0) t = t.substr(1);', "scan"),
    "of what begins so": ("std::string t = \"/scan\";\nif (t.find('/') == 0) t = t.substr(1);", "scan"),
    "of what has it nowhere": ('std::string t = "scan";\nif (t.rfind("/") != std::string::npos) t = "x";', "scan"),
    "of what ends so": ('std::string t = "scan";\nif (t.ends_with("an") && !t.starts_with("an") && t.contains("ca")) t = "x";', "x"),
    "appended": ('std::string t = "a";\nt += "/b";', "a/b"),
    "macros side by side": ("std::string t;\nt = TOPIC TOPIC;", "from/macrofrom/macro"),
    "a list of a length": ('std::vector<std::string> l(3);\nl[2] = "c";\nstd::string t = "a" + l[2];', "ac"),
    "a format of a library": ('std::string t = utils::format("a%d/%s", 2, "b");', "a2/b"),
    "a macro": ("std::string t = TOPIC;", "from/macro"),
    "a constant of a class": ("std::string t = Names::SCAN;", "of/class"),
    "a list": ('std::vector<std::string> v = {"a", "b"};\nstd::string t = v[1];', "b"),
    "a list by enumerators": (
        'std::vector<std::string> v;\nv.resize(5);\nv[THIRD] = "c";\nstd::string t = v[4];',
        "c",
    ),
    "unknown": ("std::string t = read_from_somewhere();", "{any}"),
    "partly unknown": ('std::string t = read_from_somewhere() + "/scan";', "{any}/scan"),
    "with braces": ('std::string t = "a{b}";', "a{{b}}"),
}
BEFORE = (
    'enum { FIRST, SECOND = 3, THIRD };\n#define TOPIC "from/macro"\nstruct Names { static constexpr const char* SCAN = "of/class"; };\n'
)


@pytest.mark.parametrize("name", NAMES)
def test_name(tmp_path: Path, name: str) -> None:
    body, expected = NAMES[name]
    source = in_main(f'ros::NodeHandle nh, pnh("~");\n{body}\nnh.advertise<std_msgs::Bool>(t, 1);', BEFORE)
    facts, doubts = program(tmp_path, source)
    assert [fact.name for fact in facts if fact.category == "publishers"] == [expected]
    assert [doubt.category for doubt in doubts] == (["publishers"] if "{any}" in expected else [])


def test_loops_over_literal_lists_are_unrolled(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh;
    const std::vector<std::string> names = {"left", "right"};
    for (const std::string& name : names) nh.advertise<std_msgs::Bool>(name + "/on", 1);
    for (size_t i = 0; i < names.size(); ++i) nh.advertise<std_msgs::Bool>(names[i] + "/off", 1);
    for (int i = 0; i < 2; i++) nh.advertise<std_msgs::Bool>("arm" + std::to_string(i), 1);
    """
    facts, doubts = program(tmp_path, in_main(body))
    assert [fact.name for fact in facts] == ["arm0", "arm1", "left/off", "left/on", "right/off", "right/on"]
    assert doubts == ()


NUMBERED = {
    "for": """
        ros::NodeHandle nh;
        int n = count();
        for (int i = 0; i < n; i++) {
          nh.subscribe<std_msgs::Bool>("all", 1, cb);
          char name[20];
          snprintf(name, 20, "in%02d", i);
          nh.advertise<std_msgs::Bool>(name, 1);
        }
        """,
    "do while": """
        ros::NodeHandle nh("~");
        int i = 0;
        bool more = false;
        do {
          std::stringstream s;
          s << "odom" << i++;
          more = nh.hasParam(s.str());
        } while (more);
        """,
}
NUMBERED_NAMES = {
    "for": [f"publishers in{number:02} std_msgs/Bool 8 queue=1 if i < n" for number in range(10)]
    + ["publishers in{any} std_msgs/Bool 8 queue=1", "subscribers all std_msgs/Bool 5 queue=1"],
    "do while": [f"params ~odom{number} - 8 if more" for number in range(10)] + ["params ~odom{any} - 8"],
}


@pytest.mark.parametrize("name", NUMBERED)
def test_names_that_a_loop_numbers_are_listed_as_far_as_ten(tmp_path: Path, name: str) -> None:
    facts, doubts = program(tmp_path, in_main(NUMBERED[name]))
    assert [spelled(fact) for fact in facts] == NUMBERED_NAMES[name]
    assert doubts == ()


def test_numbered_names_of_which_no_beginning_is_known_leave_it_open(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh;
    for (int i = 0; i < count(); ++i) nh.advertise<std_msgs::Bool>(std::to_string(i) + "/in", 1);
    """
    facts, doubts = program(tmp_path, in_main(body))
    assert [fact.name for fact in facts] == [f"{number}/in" for number in range(10)]
    assert {doubt.reason for doubt in doubts} == {"names are numbered, and only 10 of them listed: i < count()"}


def test_a_list_of_unknown_length_that_is_filled_one_by_one(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh;
    subs.resize(count());
    for (int i = 0; i < count(); ++i) {
      subs[i] = new message_filters::Subscriber<std_msgs::Bool>;
      subs[i]->subscribe(nh, uFormat("in%d", i), 1);
    }
    """
    facts, _ = program(tmp_path, in_main(body, "std::vector<message_filters::Subscriber<std_msgs::Bool>*> subs;"))
    condition = "if i < count()"
    assert [spelled(fact) for fact in facts] == [
        *(f"subscribers in{number} std_msgs/Bool 6 queue=1 {condition}" for number in range(10)),
        "subscribers in{any} std_msgs/Bool 6 queue=1",
    ]


def test_loops_of_unknown_length_have_unknown_names(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh;
    std::vector<std::string> names;
    nh.getParam("names", names);
    for (size_t i = 0; i < names.size(); ++i) nh.subscribe<std_msgs::Bool>(names[i], 1, cb);
    """
    facts, doubts = program(tmp_path, in_main(body))
    assert [spelled(fact) for fact in facts] == ["params names list 4", "subscribers {any} std_msgs/Bool 5 queue=1"]
    assert [(doubt.category, doubt.reason, doubt.path, doubt.line) for doubt in doubts] == [
        ("subscribers", "a name is not known before it runs: nh.subscribe<std_msgs::Bool>(names[i], 1, cb)", "main.cpp", 5)
    ]


CONDITIONS = {
    "if": ('if (debug) nh.advertise<std_msgs::Bool>("a", 1);', "publishers a std_msgs/Bool 3 queue=1 if debug"),
    "else": ('if (debug) {} else { nh.advertise<std_msgs::Bool>("a", 1); }', "publishers a std_msgs/Bool 3 queue=1 if !(debug)"),
    "not not": ('if (!debug) {} else { nh.advertise<std_msgs::Bool>("a", 1); }', "publishers a std_msgs/Bool 3 queue=1 if debug"),
    "nested": ('if (a) { if (b > 2) nh.advertise<std_msgs::Bool>("a", 1); }', "publishers a std_msgs/Bool 3 queue=1 if a and b > 2"),
    "known": ('const bool debug = false;\nif (debug) nh.advertise<std_msgs::Bool>("a", 1);', ""),
    "known to be": ('if (1 + 1 == 2) nh.advertise<std_msgs::Bool>("a", 1);', "publishers a std_msgs/Bool 3 queue=1"),
    "early return": ('if (argc < 2) return 1;\nnh.advertise<std_msgs::Bool>("a", 1);', "publishers a std_msgs/Bool 4 queue=1"),
    "while it runs": ('while (ros::ok()) { nh.advertise<std_msgs::Bool>("a", 1); }', "publishers a std_msgs/Bool 3 queue=1"),
    "switch": (
        'switch (mode) {\ncase 1:\ncase 2: nh.advertise<std_msgs::Bool>("a", 1); break;\ndefault: nh.advertise<std_msgs::Bool>("b", 1);\n}',
        """
        publishers a std_msgs/Bool 5 queue=1 if mode == 1 or mode == 2
        publishers b std_msgs/Bool 6 queue=1 if no case of mode
        """,
    ),
    "preprocessor": (
        '#ifdef WITH_A\nnh.advertise<std_msgs::Bool>("a", 1);\n#else\nnh.advertise<std_msgs::Bool>("b", 1);\n#endif',
        """
        publishers a std_msgs/Bool 4 queue=1 if #ifdef WITH_A
        publishers b std_msgs/Bool 6 queue=1 if not #ifdef WITH_A
        """,
    ),
    "commented out": ('#if 0\nnh.advertise<std_msgs::Bool>("a", 1);\n#endif', ""),
    "both ways": (
        'if (a) { nh.advertise<std_msgs::Bool>("a", 1); } else nh.advertise<std_msgs::Bool>("a", 1);',
        """
        publishers a std_msgs/Bool 3 queue=1 if !(a)
        publishers a std_msgs/Bool 3 queue=1 if a
        """,
    ),
    "name of either": (
        'nh.advertise<std_msgs::Bool>(front ? "a" : "b", 1);',
        """
        publishers a std_msgs/Bool 3 queue=1 if front
        publishers b std_msgs/Bool 3 queue=1 if !(front)
        """,
    ),
}


@pytest.mark.parametrize("name", CONDITIONS)
def test_condition(tmp_path: Path, name: str) -> None:
    body, expected = CONDITIONS[name]
    facts, _ = program(tmp_path, in_main("ros::NodeHandle nh;\n" + body))
    assert [spelled(fact) for fact in facts] == lines(expected)


def test_a_name_from_a_param_may_be_absolute(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh("~");
    std::string topic, other;
    nh.getParam("topic", topic);
    nh.param<std::string>("other", other, "map");
    nh.advertise<std_msgs::Bool>(topic, 1);
    nh.advertise<std_msgs::Bool>(other + "/x", 1);
    """
    facts, _ = program(tmp_path, in_main(body))
    assert [spelled(fact) for fact in facts if fact.category == "publishers"] == [
        "publishers {param:~other}/x std_msgs/Bool 7 queue=1 if ~other is an absolute name",
        "publishers {param:~topic} std_msgs/Bool 6 queue=1 if ~topic is an absolute name",
        "publishers ~{param:~other|map}/x std_msgs/Bool 7 queue=1",
        "publishers ~{param:~topic} std_msgs/Bool 6 queue=1 if ~topic is a relative name",
    ]


def test_a_name_from_a_param_need_not_be_as_absolute_as_its_default(tmp_path: Path) -> None:
    body = """
    ros::NodeHandle nh("~"), other;
    std::string topic;
    nh.param<std::string>("topic", topic, "/wheels/cmd_vel");
    nh.advertise<std_msgs::Bool>(topic, 1);
    other.advertise<std_msgs::Byte>(topic, 1);
    """
    facts, _ = program(tmp_path, in_main(body))
    assert [spelled(fact) for fact in facts if fact.category == "publishers"] == [
        "publishers {param:~topic|/wheels/cmd_vel} std_msgs/Byte 6 queue=1",
        "publishers ~{param:~topic|/wheels/cmd_vel} std_msgs/Bool 5 queue=1",
    ]


def test_a_template_fits_better_than_a_specialisation_for_another_type(tmp_path: Path) -> None:
    source = """
    template <typename T> bool get(ros::NodeHandle& nh, const std::string& key, T& found) { return nh.getParam(key, found); }
    template <> bool get(ros::NodeHandle& nh, const std::string& key, uint32_t& found) {
      int32_t value = found;
      bool good = get(nh, key, value);
      found = value;
      return good;
    }
    int main() {
      ros::NodeHandle nh;
      bool chosen = false;
      get(nh, "chosen", chosen);
      if (chosen) nh.advertise<std_msgs::Bool>("yes", 1); else nh.advertise<std_msgs::Bool>("no", 1);
    }
    """
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts if fact.category == "publishers"] == [
        "publishers no std_msgs/Bool 13 queue=1 if !(chosen)",
        "publishers yes std_msgs/Bool 13 queue=1 if chosen",
    ]


def test_a_member_that_a_callback_changes_decides_nothing(tmp_path: Path) -> None:
    source = """
    class Node {
     public:
      Node() : ready_(false) { sub_ = nh_.subscribe("in", 1, &Node::heard, this); }
      void heard(const std_msgs::BoolConstPtr& m) { if (!ready_) ready_ = true; else pub_ = nh_.advertise<std_msgs::Bool>("out", 1); }
      bool ready_;
      ros::NodeHandle nh_;
    };
    int main() { Node node; ros::spin(); }
    """
    facts, _ = program(tmp_path, source)
    assert [spelled(fact) for fact in facts] == [
        "publishers out std_msgs/Bool 5 queue=1 when=message if ready_",
        "subscribers in std_msgs/Bool 4 queue=1",
    ]


MANY = "".join(f"  value[{number}] = {number};\n" for number in range(200))


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        ("ros::this_node::getName()", "params ~gain double 11"),
        ("std::string(read_from_somewhere())", "params {any}/gain double 11"),
    ],
)
def test_a_member_that_a_long_function_sets(tmp_path: Path, made: str, expected: str) -> None:
    """Such a function may be passed over where nothing in it speaks of ROS: then the member is not what it was before."""
    code = f"""struct Controller {{
  Controller();
  void init();
  void get();
  std::string name;
  double gain;
  int value[200];
  ros::NodeHandle nh;
}};
void Controller::get() {{
  nh.getParam(name + "/gain", gain);
}}
void Controller::init() {{
  name = {made};
{MANY}}}
Controller::Controller() {{
  init();
  get();
}}
int main(int argc, char** argv) {{
  Controller controller;
}}
"""
    facts, _ = program(tmp_path, code)
    assert [spelled(fact) for fact in facts] == lines(expected)
