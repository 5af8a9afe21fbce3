from __future__ import annotations

from pathlib import Path

import pytest

from launchlint.python.modules import ModuleFinder
from launchlint.python.setup_paths import setup_paths

SAID = {
    "of all": ("generate_distutils_setup(packages=['a'], package_dir={'': 'src'})", {"": "src"}),
    "deeper": ("d = generate_distutils_setup(package_dir={'': 'ros/src/'})", {"": "ros/src"}),
    "of one": ("d = generate_distutils_setup(packages=['a'], package_dir={'a': 'ros/src/a'})", {"a": "ros/src/a"}),
    "of one inside": ("setup(package_dir={'a': 'x', 'a.b': 'y/b'})", {"a": "x", "a.b": "y/b"}),
    "dict()": ("setup(**dict(packages=['a'], package_dir=dict(a='ros/a')))", {"a": "ros/a"}),
    "an item": ("d = {}\nd['package_dir'] = {'': 'src'}\nsetup(**d)", {"": "src"}),
    "in a dict": ("d = {'packages': ['a'], 'package_dir': {'a': 'b'}}\nsetup(**d)", {"a": "b"}),
    "constants": ("N = 'a'\nB = 'ros/'\nD = {N: B + N}\nsetup(package_dir=D)", {"a": "ros/a"}),
    "joined": ("N = 'a'\nsetup(package_dir={N: os.path.join('ros', f'{N}_py')})", {"a": "ros/a_py"}),
    "beside setup.py": ("setup(packages=['a', 'b.c'])", {"a": "a", "b.c": "b/c"}),
    "beside and elsewhere": ("setup(packages=['a', 'b'], package_dir={'b': 'ros/b'})", {"b": "ros/b", "a": "a"}),
    "python 2": ("print 'hello'\nsetup(package_dir={'': 'src'})", {"": "src"}),
    "commented out": ("setup(packages=[])  # package_dir={'': 'src'}", {}),
    "computed": ("setup(packages=find_packages(), package_dir={'a': where(), 'b': 'c'})", {"b": "c"}),
    "outside": ("setup(package_dir={'': '../other', 'a': '/usr', 'b': 'x/../../y'})", {}),
    "of itself": ("a = a\nb = c\nc = b\nsetup(packages=a, package_dir=b)", {}),
    "no Python": ("setup(package_dir={'': 'src'}", {}),
}


@pytest.mark.parametrize(("source", "expected"), SAID.values(), ids=SAID)
def test_what_setup_says(source: str, expected: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_text(source + "\n", encoding="utf-8")
    assert setup_paths(str(tmp_path)) == expected


def test_without_setup(tmp_path: Path) -> None:
    assert setup_paths(str(tmp_path)) == {}


def test_the_setup_is_not_run(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_text(f"open({str(tmp_path / 'ran')!r}, 'w')\nsetup(package_dir={{'': 'src'}})\n", encoding="utf-8")
    setup_paths(str(tmp_path))
    assert not (tmp_path / "ran").exists()


def test_modules_are_found_there(tmp_path: Path) -> None:
    files = (
        "one/scripts/node",
        "one/ros/src/one/__init__.py",
        "one/ros/src/one/talk.py",
        "one/deep/__init__.py",
        "one/deep/tool.py",
        "two/lib/two/bare.py",
    )
    for name in files:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    (tmp_path / "one/setup.py").write_text("setup(package_dir={'one': 'ros/src/one', 'one.sub': 'deep'})\n")
    (tmp_path / "two/setup.py").write_text("setup(package_dir={'two': 'lib/two'})\n")
    one, two = str(tmp_path / "one"), str(tmp_path / "two")
    finder = ModuleFinder({one: "one", two: "two"})

    def found(name: str) -> str:
        return str(finder.find(name, f"{one}/scripts", one)).removeprefix(f"{tmp_path}/")

    assert found("one") == "one/ros/src/one/__init__.py"
    assert found("one.talk") == "one/ros/src/one/talk.py"
    assert found("one.sub") == "one/deep/__init__.py"
    assert found("one.sub.tool") == "one/deep/tool.py"
    assert found("two") == "two/lib/two/"
    assert found("two.bare") == "two/lib/two/bare.py"
    assert finder.find("other", f"{one}/scripts", one) is None
    assert finder.find("onel", f"{one}/scripts", one) is None
