"""The configuration of a probe: what it may say, and what is refused, with line and column."""

from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.errors import ConfigurationError
from launchlint.probe.configuration import LaunchFile, Limits, ProbeConfiguration, Repository, load
from launchlint.probe.run import Shard, job_of
from launchlint.probe.words import repository_url

ROOT = Path(__file__).resolve().parent.parent.parent


def read(directory: Path, text: str) -> ProbeConfiguration:
    file = directory / "probe.yaml"
    file.write_text(text, encoding="utf-8")
    return load(str(file))


def refusal(directory: Path, text: str) -> str:
    with pytest.raises(ConfigurationError) as caught:
        read(directory, text)
    return str(caught.value).removeprefix(f"{directory}/")


def test_everything(tmp_path: Path) -> None:
    (tmp_path / "ws").mkdir()
    configuration = read(
        tmp_path,
        """\
base: osrf/ros:noetic-desktop-full
network: host
repositories:
  - {url: ros/ros_tutorials, ref: noetic-devel}
  - {url: "git@example.org:team/robot.git", ref: v1.2}
  - path: ws
apt: [topic-tools, libpcl-dev=1.13.0+dfsg-3]
pip: ["pyserial==3.5", "numpy>=1,<2"]
packages: [a_package]
skip: [other, a_package/node]
nodes:
  a_package/node:
    args: --rate 10 "two words"
    params: {~rate: 10, ~gain: 0.5, ~on: yes, ~list: [1, x], ~deep: {a: 1}, name: "10"}
    env: {MODE: test}
    remap: {scan: /base_scan}
    files: {map.yaml: "a: 1"}
    quiet: 2
    limit: 30
    variants:
      fast: {params: {~rate: 100}}
      with_file: {args: x, match: {arg: 1, is: x}}
  a_package/Class:
    params: {}
launch:
  - a_package/launch/robot.launch
  - {file: a_package/launch/robot.launch, args: {sim: true}}
limits: {quiet: 0.5, limit: 20, jobs: 3, memory: 512m, pids: 100, total: 600, build: 60}
""",
    )
    assert configuration == ProbeConfiguration(
        path=str(tmp_path / "probe.yaml"),
        base="osrf/ros:noetic-desktop-full",
        network="host",
        repositories=(
            Repository("https://github.com/ros/ros_tutorials", "noetic-devel"),
            Repository("git@example.org:team/robot.git", "v1.2"),
        ),
        paths=(str(tmp_path / "ws"),),
        apt=("topic-tools", "libpcl-dev=1.13.0+dfsg-3"),
        pip=("pyserial==3.5", "numpy>=1,<2"),
        packages=("a_package",),
        skip=("other", "a_package/node"),
        nodes={
            "a_package/node": {
                "args": '--rate 10 "two words"',
                "params": {"~rate": 10, "~gain": 0.5, "~on": True, "~list": [1, "x"], "~deep": {"a": 1}, "name": "10"},
                "env": {"MODE": "test"},
                "remap": {"scan": "/base_scan"},
                "files": {"map.yaml": "a: 1"},
                "quiet": 2.0,
                "limit": 30.0,
                "variants": {"fast": {"params": {"~rate": 100}}, "with_file": {"args": "x", "match": {"arg": 1, "is": "x"}}},
            },
            "a_package/Class": {"params": {}},
        },
        launch=(LaunchFile("a_package/launch/robot.launch", {}), LaunchFile("a_package/launch/robot.launch", {"sim": "true"})),
        limits=Limits(0.5, 20.0, 3, "512m", 100, 600.0, 60.0),
    )
    job = job_of(configuration, Shard(2, 5), sources=["/workspace/src"])
    assert job["nodes"]["a_package/node"]["variants"] == {"fast": {"params": {"~rate": 100}}, "with_file": {"args": "x"}}
    assert (job["shard"], job["sources"]) == ([2, 5], ["/workspace/src"])


def test_the_example_is_valid() -> None:
    example = load(str(ROOT / "probe" / "example.yaml"))
    assert example.repositories == (Repository("https://github.com/ros/ros_tutorials", "noetic-devel"),)
    assert sorted(example.nodes) == ["topic_tools/relay", "topic_tools/throttle"]


def test_an_empty_file_asks_for_the_defaults(tmp_path: Path) -> None:
    assert read(tmp_path, "") == ProbeConfiguration(path=str(tmp_path / "probe.yaml"))


REFUSED = {
    "repositries: []": (
        "probe.yaml:1:1: the configuration has no key repositries, and one that is misspelled would have no effect; "
        "did you mean repositories?"
    ),
    "repositories: [{url: ros/ros_tutorials}]": (
        "probe.yaml:1:16: a repository needs `ref`, a branch, tag or commit: default branches change, and many are for ROS 2 by now"
    ),
    "repositories: [{ref: main}]": "probe.yaml:1:16: a repository needs `url` (owner/name or a URL) and `ref`, or `path`: which is it?",
    "repositories: [{path: ., ref: main}]": "probe.yaml:1:31: a repository has either `path`, a local checkout, or `url` and `ref`",
    "repositories: [{path: nowhere}]": "probe.yaml:1:23: there is no directory nowhere; paths are relative to this file",
    "repositories: [{url: a/b, ref: --upload-pack=touch}]": (
        "probe.yaml:1:32: ref cannot be --upload-pack=touch: write a branch, tag or commit"
    ),
    "repositories: [{url: a/b, ref: a..b}]": "probe.yaml:1:32: ref cannot be a..b: write a branch, tag or commit",
    'repositories: [{url: a/b, ref: "x\\ny"}]': "probe.yaml:1:32: ref cannot be 'x\\ny': write a branch, tag or commit",
    'repositories: [{url: "ext::sh -c id", ref: x}]': (
        "probe.yaml:1:22: url cannot be ext::sh -c id: write owner/name (of GitHub), or an https, ssh, git or file URL without a password"
    ),
    "base: $(id)": (
        "probe.yaml:1:7: base cannot be $(id): write the name of an image, such as debian:bookworm or osrf/ros:noetic-desktop-full"
    ),
    "base: --help": (
        "probe.yaml:1:7: base cannot be --help: write the name of an image, such as debian:bookworm or osrf/ros:noetic-desktop-full"
    ),
    "apt: [-oDebug=1]": "probe.yaml:1:7: an item of apt cannot be -oDebug=1: write the name of an apt package, with =version if need be",
    "apt: ['a;id']": "probe.yaml:1:7: an item of apt cannot be a;id: write the name of an apt package, with =version if need be",
    "pip: ['git+https://x']": (
        "probe.yaml:1:7: an item of pip cannot be git+https://x: write the name of a package on PyPI, with ==version if need be"
    ),
    "pip: ['-r/etc/passwd']": (
        "probe.yaml:1:7: an item of pip cannot be -r/etc/passwd: write the name of a package on PyPI, with ==version if need be"
    ),
    "packages: [../x]": "probe.yaml:1:12: an item of packages cannot be ../x: write the name of a ROS package",
    "nodes: {../x/y: {}}": "probe.yaml:1:9: nodes cannot have ../x/y: write package/executable, or the class of a nodelet or component",
    "nodes: {a/..: {}}": "probe.yaml:1:9: nodes cannot have a/..: write package/executable, or the class of a nodelet or component",
    "nodes: {a/b: {arg: x}}": (
        "probe.yaml:1:15: the node a/b has no key arg, and one that is misspelled would have no effect; did you mean args?"
    ),
    'nodes: {a/b: {args: "\\"x"}}': "probe.yaml:1:21: args cannot be split into words: no closing quotation",
    "nodes: {a/b: {files: {../x: y}}}": "probe.yaml:1:23: a file cannot be called ../x: write a plain file name without directories",
    "nodes: {a/b: {env: {A=B: y}}}": (
        "probe.yaml:1:21: an environment variable cannot be called A=B: write the name of an environment variable"
    ),
    "nodes: {a/b: {params: {~x y: 1}}}": (
        "probe.yaml:1:24: a param cannot be called ~x y: write the name of a param: ~private, relative or /global"
    ),
    "nodes: {a/b: {remap: {x;id: y}}}": "probe.yaml:1:23: a remapped name cannot be called x;id: write a ROS name",
    "nodes: {a/b: {remap: {x: -y}}}": "probe.yaml:1:26: the target of a remap cannot be -y: write a ROS name",
    "nodes: {a/b: {params: {~x: .inf}}}": "probe.yaml:1:28: a param cannot be .inf: XML-RPC has no such number",
    "nodes: {a/b: {params: {~x: 3000000000}}}": "probe.yaml:1:28: a param cannot be 3000000000: whole numbers have 32 bits in ROS",
    "nodes: {a/b: {variants: {v: {env: {A: b}}}}}": (
        "probe.yaml:1:26: the variant v sets no params, so say by `match` (a condition of the library format) when it is the one that runs"
    ),
    "nodes: {a/b: {variants: {v: {match: {parm: x}}}}}": (
        "probe.yaml:1:37: match is no condition: a condition has one of the keys param, arg, option, remap, not, all, any, text"
    ),
    "launch: [a/../../etc/passwd]": "probe.yaml:1:10: a launch file cannot be a/../../etc/passwd: write package/path/of.launch",
    "launch: [{args: {a: b}}]": "probe.yaml:1:10: a launch file needs `file`: package/path/of.launch",
    "limits: {jobs: 0}": "probe.yaml:1:16: jobs must be a whole number from 1 to 64, not 0",
    "limits: {quiet: nan}": "probe.yaml:1:17: quiet must be a number of seconds from 0.1 to 60, not nan",
    "limits: {memory: 1e9}": "probe.yaml:1:18: memory cannot be 1e9: write a number with m or g, such as 2g",
    "network: hots": "probe.yaml:1:10: network cannot be hots; did you mean host?",
    "skip: [a b]": "probe.yaml:1:8: skip cannot hold a b: write a package or package/executable, or the class of a nodelet or component",
}


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str, tmp_path: Path) -> None:
    assert refusal(tmp_path, text) == REFUSED[text]


@pytest.mark.parametrize(
    ("text", "url"),
    [
        ("ros/ros_tutorials", "https://github.com/ros/ros_tutorials"),
        ("https://example.org/a/b.git", "https://example.org/a/b.git"),
        ("ssh://git@example.org:22/a/b", "ssh://git@example.org:22/a/b"),
        ("git@example.org:a/b.git", "git@example.org:a/b.git"),
        ("file:///srv/git/a", "file:///srv/git/a"),
        ("https://user:secret@example.org/a", None),
        ("ssh://-oProxyCommand=touch/x", None),
        ("ssh://x@-oProxyCommand=touch/x", None),
        ("-u./payload", None),
        ("../a", None),
        ("a/../b", None),
        ("a/b..c", None),
        ("a..b/c", None),
        ("https://example.org/../a", None),
        ("ssh://git@-oProxyCommand/a", None),
        ("git@example.org:a/b;id", None),
        ("git@example.org:../b", None),
        ("https://example.org/a b", None),
        ("https://example.org/$(id)", None),
        ("https://example.org/a\nb", None),
        ("/etc", None),
        ("ext://sh/-c/id", None),
        ("ext::sh/-c/id", None),
    ],
)
def test_repository_url(text: str, url: str | None) -> None:
    assert repository_url(text) == url
