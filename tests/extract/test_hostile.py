"""Programs that are made to hang, to be huge or to break out: each is followed to an end, quickly, and nothing of it is run."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from launchlint.extract.package import extract
from tests.extract.test_rospy import follow

HEAD = "import rospy\nfrom std_msgs.msg import String\n"
FUNCTIONS = "".join(f"def f{n}():\n    f{n + 1}(); f{n + 1}()\n" for n in range(60)) + "def f60(): pass\n"


@pytest.mark.parametrize(
    "source",
    [
        pytest.param(FUNCTIONS + "f0()\n", id="calls that double sixty times"),
        pytest.param(
            "for a in range(60):\n for b in range(60):\n  for c in range(60):\n   for d in range(60):\n    a\n", id="nested loops"
        ),
        pytest.param("def f(n):\n    return f(n) + f(n)\nf(f(f(1)))\n", id="recursion"),
        pytest.param("x = 'a'\n" + "x = x + x\n" * 500 + "rospy.Publisher(x, String)\n", id="a string that doubles"),
        pytest.param("x = [1]\n" + "x = x + x\n" * 500, id="a list that doubles"),
        pytest.param("x = 9 ** 9 ** 9 ** 9\ny = 'a' * 10 ** 12\nz = 1 << 10 ** 12\n", id="huge numbers"),
        pytest.param("x = '%0999999999d' % 1\ny = '{:999999999}'.format(1)\nz = f'{1:999999999}'\n", id="huge widths"),
        pytest.param(
            "x = []\nx.append(x)\nx[0][0]\nprint(x)\nrospy.Publisher(x, String)\nrospy.get_param('~x', x)\n", id="a list in itself"
        ),
        pytest.param("x = {}\nx['x'] = x\nrospy.get_param('~x', x)\n", id="a dict in itself"),
        pytest.param("class A(A): pass\nA()\nclass B: pass\nB.__bases__ = (B,)\nB().x\n", id="a class that is its own base"),
        pytest.param("if a:\n    x = 1\nelse:\n    x = 2\n" * 2_000 + "rospy.Publisher(str(x), String)\n", id="many branches"),
        pytest.param("".join(f"{' ' * n}if a{n}:\n" for n in range(90)) + " " * 90 + "rospy.Publisher('x', String)\n", id="deep branches"),
        pytest.param("while True:\n    rospy.Publisher(str(rospy), String)\n", id="a loop without end"),
        pytest.param("x = lambda: x()\nx()\n", id="a lambda that calls itself"),
        pytest.param("import node\nimport node.node\nfrom . import x\nfrom .... import y\nfrom node import *\n", id="imports of itself"),
        pytest.param("x = " + " + ".join(["'a'"] * 90) + "\n", id="a long sum"),
        pytest.param("rospy.Publisher('a' * 900 + '{', String)\nrospy.Publisher('}{any}{', String)\n", id="braces in names"),
        pytest.param("rospy.Subscriber('x', String, rospy.Subscriber)\n", id="odd callbacks"),
        pytest.param("rospy.Publisher(*[*[*[]]], **{**{}})\nrospy.Publisher()\nrospy.get_param()\n", id="no arguments"),
        pytest.param("class A:\n    @property\n    def x(self): return self.x\nA().x\n", id="a property that reads itself"),
        pytest.param(
            "".join(f"class C{n}(C{n - 1}): pass\n" if n else "class C0: pass\n" for n in range(300)) + "C299().x\n", id="many bases"
        ),
        pytest.param(
            "".join(f"class C{n}(object): pass\n" for n in range(600))
            + f"class D({', '.join(f'C{n}' for n in range(600))}): pass\nD().x\n",
            id="many bases at once",
        ),
        pytest.param("class A: pass\nclass B(A): pass\nclass C(A, B): pass\nC().x\n", id="bases that have no order"),
        pytest.param("x = 'exec(x)'\nexec(x)\ny = 'eval(y)'\neval(y)\n", id="code that makes itself"),
        pytest.param("exec('(' * 5000)\neval('1 +' * 3000 + '1')\nexec('\\0')\n", id="code that is none"),
        pytest.param("class A(object):\n    def __new__(cls): return A()\nA()\n", id="a class that makes itself"),
        pytest.param(
            "class A(object):\n    @property\n    def x(self): pass\n    @x.setter\n    def x(self, v): self.x = v\nA().x = 1\n",
            id="a setter",
        ),
        pytest.param("def d(f): return d(f)\n@d\n@d\ndef f(): pass\nf()\n", id="a decorator that calls itself"),
        pytest.param("".join(f"rospy.Publisher('x{n}', String)\n" for n in range(20_000)), id="very many names"),
        pytest.param("try:\n    pass\nexcept E:\n    raise\nfinally:\n    exit()\n", id="an end in finally"),
        pytest.param("getattr(rospy, 'Publ' + 'isher')('x', String)\n__import__('os').system('touch ran')\neval('1')\n", id="eval"),
    ],
)
def test_it_ends(source: str, tmp_path: Path) -> None:
    begin = time.process_time()
    found = follow(tmp_path, HEAD + source)
    assert time.process_time() - begin < 20
    assert all(fact.name and len(fact.name) <= 1_000 and len(fact.condition) <= 1_000 for fact in found.facts)
    assert os.listdir(tmp_path) == ["node.py"]


def test_a_program_that_is_too_much_says_so(tmp_path: Path) -> None:
    found = follow(tmp_path, HEAD + "rospy.Publisher('x', String)\n" + FUNCTIONS.replace("pass", "rospy.Publisher('y', String)") + "f0()\n")
    assert {fact.name for fact in found.facts} >= {"x"}
    assert "it calls functions in functions too deep to be followed" in {doubt.reason for doubt in found.doubts}


def test_links_and_special_files(tmp_path: Path) -> None:
    package = tmp_path / "ws" / "p"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "outside.py").write_text("#!/usr/bin/env python\nimport rospy\nrospy.get_param('~secret', 'outside')\n")
    (tmp_path / "outside.py").chmod(0o755)
    (package / "outside.py").symlink_to(tmp_path / "outside.py")
    (package / "round").symlink_to(package)
    os.mkfifo(package / "pipe.py", 0o755)
    (package / "CMakeLists.txt").write_text("catkin_install_python(PROGRAMS pipe.py ../../outside.py /etc/passwd missing.py)\n")
    assert extract([str(tmp_path / "ws")]).document["packages"] == {}


def test_names_of_files_and_conditions_that_a_terminal_would_obey(tmp_path: Path) -> None:
    package = tmp_path / "ws" / "p"
    (package / "\x1b[31mred").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>p</name></package>")
    source = "#!/usr/bin/env python\nimport rospy\nif rospy.get_param('~\x07', '\x1b[0m'):\n    rospy.wait_for_service('s')\n"
    for name in ("good", "\x1b]0;bad\x07", os.fsdecode(b"\xff\xfe")):
        (package / "\x1b[31mred" / name).write_text(source)
        (package / "\x1b[31mred" / name).chmod(0o755)
    programs = extract([str(tmp_path / "ws")]).document["packages"]["p"]["executables"]
    assert programs == {
        "good": {
            "class": "rospy",
            "variants": {
                "default": {
                    "clients": [
                        {
                            "name": "s",
                            "condition": {"text": "rospy.get_param('~\\x07', '\\x1b[0m')"},
                            "evidence": [{"by": "static", "at": "ws:p/ [31mred/good:4"}],
                        }
                    ],
                    "open": {"params": "a name that is not known (p/ [31mred/good:3)"},
                }
            },
        }
    }
