"""What a package built with ament_python installs; its setup.py is read, and never run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.ament.installed import Installed

Make = Callable[[Mapping[str, str | None]], Installed]
FILES = {
    "launch/a.launch.py": "",
    "launch/deep/b.launch.xml": "",
    "config/c.yaml": "",
    "rover/driver.py": "",
    "scripts/e.py": "",
    "setup.cfg": "[develop]\nscript_dir=$base/lib/rover\n[install]\ninstall_scripts=$base/lib/rover\n",
}
START = "import os\nfrom glob import glob\nfrom setuptools import setup\npackage_name = 'rover'\n"
SETUP = START + "setup(name=package_name, data_files={})\n"


def _shares(found: Installed, root: Path) -> dict[str, str]:
    return {share: file for file in FILES for share in found.share_paths(str(root / file))}


A, B, C = "launch/a.launch.py", "launch/deep/b.launch.xml", "config/c.yaml"
SETUPS: dict[str, tuple[str, dict[str, str]]] = {
    "names": (SETUP.format("[('share/' + package_name + '/launch', ['launch/a.launch.py'])]"), {A: A}),
    "a glob": (SETUP.format("[(os.path.join('share', package_name, 'launch'), glob('launch/*.launch.*'))]"), {A: A}),
    "a glob with any depth": (
        SETUP.format("[(f'share/{package_name}', glob('launch/**/*.launch.*', recursive=True))]"),
        {"a.launch.py": A, "b.launch.xml": B},
    ),
    "two globs": (
        SETUP.format("[('share/%s/x' % package_name, glob('launch/*.py') + glob('config/*'))]"),
        {"x/a.launch.py": A, "x/c.yaml": C},
    ),
    "a module called glob": (
        SETUP.replace("from glob import glob", "import glob").format("[('share/rover', glob.glob(os.path.join('config', '*.y*ml')))]"),
        {"c.yaml": C},
    ),
    "pathlib": (
        (
            "from pathlib import Path\nimport setuptools\n"
            "setuptools.setup(data_files=[('share/rover/config', [str(each) for each in Path('config').glob('*.yaml')])])"
        ),
        {C: C},
    ),
    "a list that grows": (
        START + "data_files = []\ndata_files.append(('share/rover', ['config/c.yaml']))\ndata_files += [('share/rover/x', [" + f"'{A}'])]\n"
        "setup(data_files=data_files)",
        {"c.yaml": C, "x/a.launch.py": A},
    ),
    "a walk": (
        START + "def tree(top):\n    whole = []\n    for path, _, found in os.walk(top):\n"
        "        whole.append((f'share/rover/{path}', [os.path.join(path, each) for each in found]))\n    return whole\n"
        "setup(data_files=tree('launch') + tree('config'))",
        {A: A, B: B, C: C},
    ),
    "a walk with a dictionary": (
        START + "paths = {}\nfor top in ['launch', 'config']:\n    for path, _, found in os.walk(top):\n        for each in found:\n"
        "            to = f'share/rover/{path}'\n            paths.setdefault(to, []).append(os.path.join(path, each))\n"
        "setup(data_files=[(key, value) for key, value in paths.items()])",
        {A: A, B: B, C: C},
    ),
    "keyword arguments in a dictionary": (
        START + "given = dict()\ngiven['data_files'] = [('share/rover', ['config/c.yaml'])]\nsetup(**given)",
        {"c.yaml": C},
    ),
    "from where the file stands": (
        START + "here = os.path.abspath(os.path.dirname(__file__))\nwith open('README') as file:\n    text = file.read()\n"
        "setup(long_description=text, data_files=[('share/rover', [os.path.join(here, 'config', 'c.yaml')])])",
        {"c.yaml": C},
    ),
    "in a function, when it is run": (
        START + "def main():\n    setup(data_files=[('share/rover', ['config/c.yaml'])])\nif __name__ == '__main__':\n    main()",
        {"c.yaml": C},
    ),
    "a condition that is known": (
        START
        + "files = []\nif os.path.isdir('config') and not os.path.exists('other'):\n    files = [('share/rover', ['config/c.yaml'])]\n"
        "setup(data_files=files)",
        {"c.yaml": C},
    ),
}


@pytest.mark.parametrize("case", SETUPS)
def test_data_files(case: str, install: Make, tmp_path: Path) -> None:
    text, expected = SETUPS[case]
    found = install({**FILES, "setup.py": text})
    assert found.reasons == ()
    assert _shares(found, tmp_path) == expected
    assert {share: found.source_of(share) for share in expected} == {share: str(tmp_path / file) for share, file in expected.items()}
    assert found.lacks("config/other.yaml")


OPEN = [
    SETUP.format("something()"),
    SETUP.format("[('share/rover', something())]"),
    SETUP.format("[(somewhere, ['config/c.yaml'])]"),
    SETUP.format("[('share/rover/x', ['launch/a.launch.py'])] + something"),
    SETUP.format("[('share/rover', glob('../other/*'))]"),
    SETUP.format("[('share/rover', [each for each in glob('config/*') if something(each)])]"),
    START + "files = []\nfor each in something():\n    files.append(('share/rover', [each]))\nsetup(data_files=files)",
    START + "files = []\nif something:\n    files = [('share/rover', ['config/c.yaml'])]\nsetup(data_files=files)",
    START + "setup(**something)",
    START + "setup(cmdclass={'install': something})",
    START + "print('no call')",
    "this is no python",
    START + "x = 'a'\nwhile True:\n    x += x\nsetup(data_files=[('share/rover', [x])])",
    "(" * 10_000,
]


@pytest.mark.parametrize("text", OPEN)
def test_what_is_not_known_is_never_said_to_be_missing(text: str, install: Make) -> None:
    assert not install({**FILES, "setup.py": text}).lacks("config/c.yaml")


POINTS = "setup(name=package_name, entry_points={'console_scripts': ['drive = rover.driver:main', 'steer=rover.steer:main [x]']})"


def test_entry_points(install: Make, tmp_path: Path) -> None:
    found = install({**FILES, "setup.py": START + POINTS})
    assert found.program_reasons == ()
    assert {name: each.sources for name, each in found.libexec.items()} == {"drive": (str(tmp_path / "rover/driver.py"),), "steer": ()}
    assert not found.lacks_program("drive")
    assert found.lacks_program("driver")


@pytest.mark.parametrize(
    ("configuration", "destination"),
    [
        ("", "bin"),
        ("[install]\ninstall-scripts = $base/lib/rover", "lib/rover"),
        ("[install]\ninstall_scripts=$base/bin", "bin"),
        ("[install]\ninstall_scripts=$base/lib/$name", None),
        ("[develop]\nscript_dir=$base/lib/rover", None),
        ("[metadata]\nname = rover", "bin"),
    ],
)
def test_where_setup_cfg_puts_programs(configuration: str, destination: str | None, install: Make) -> None:
    found = install({**FILES, "setup.py": START + POINTS, "setup.cfg": configuration})
    assert {each.destination for each in found.programs} == {destination}
    assert found.lacks_program("drive") is (destination == "bin")


def test_programs_by_other_ways(install: Make, tmp_path: Path) -> None:
    found = install(
        {
            **FILES,
            "setup.py": START + "setup(scripts=['scripts/e.py'], entry_points='''[console_scripts]\ndrive = rover.driver\n''',"
            " data_files=[('lib/' + package_name, glob('launch/*.py'))])",
            "setup.cfg": FILES["setup.cfg"] + "[options.entry_points]\nconsole_scripts =\n    park = rover.driver:park\n",
        }
    )
    assert {name: each.sources for name, each in found.libexec.items()} == {
        "a.launch.py": (str(tmp_path / A),),
        "drive": (str(tmp_path / "rover/driver.py"),),
        "e.py": (str(tmp_path / "scripts/e.py"),),
        "park": (str(tmp_path / "rover/driver.py"),),
    }


@pytest.mark.parametrize(
    ("files", "text"),
    [
        ({}, "setup(entry_points=something)"),
        ({}, "setup(entry_points={'console_scripts': something})"),
        ({}, "setup(scripts=glob('../x/*'))"),
        ({}, "setup(options={'install': {}}, entry_points={'console_scripts': ['drive = rover:main']})"),
        ({"pyproject.toml": "[project.scripts]\n"}, "setup()"),
        ({"setup.cfg": "no sections"}, "setup()"),
    ],
)
def test_programs_that_are_not_known_may_be_any(files: Mapping[str, str], text: str, install: Make) -> None:
    assert not install({**FILES, **files, "setup.py": START + text}).lacks_program("other")


def test_nothing_of_it_is_run(install: Make, tmp_path: Path) -> None:
    text = START + f"open({str(tmp_path / 'made')!r}, 'w').write('x')\nos.system('touch made')\n__import__('os').mkdir('made')\nsetup()"
    assert install({**FILES, "setup.py": text}).reasons == ()
    assert not (tmp_path / "made").exists()


def test_hostile_loops_end(install: Make) -> None:
    nested = "".join(f"{'  ' * depth}for a{depth} in many:\n" for depth in range(8)) + "  " * 8 + "pass\n"
    start = "from setuptools import setup\n"
    assert install({"setup.py": f"{start}many = list('{'x' * 300}')\n{nested}\nsetup()"}).reasons != ()
    assert install({"setup.py": f"{start}def f():\n    return f()\nf()\nsetup()"}).reasons != ()
    assert install({"setup.py": f"{start}x = [1]\nfor each in x:\n    x.append(each)\nsetup()"}).reasons == ()


@pytest.mark.parametrize("line", ["x += x", "x.extend(x)", "x = x + x", "x = [x, x]", "x = f'{x}{x}'"])
def test_what_doubles_again_and_again_is_bounded(line: str, install: Make) -> None:
    start = "from setuptools import setup\n"
    found = install({"setup.py": f"{start}x = ['a']\nfor each in '{'i' * 200}':\n    {line}\nsetup(data_files=[('share/rover', x)])"})
    assert not found.lacks("config/c.yaml")


@pytest.mark.parametrize("line", ["x = (x, x)", "x = {'a': x, 'b': x}", "x = [x, x]"])
def test_what_holds_itself_many_times_is_not_looked_through(line: str, install: Make) -> None:
    start = "from setuptools import setup\n"
    looks = "if x == [x]:\n    pass\ny = set([x])\nz = [x]\nz.remove(x)\n"
    assert install({"setup.py": f"{start}x = ()\nfor each in '{'i' * 200}':\n    {line}\n{looks}\nsetup()"}).reasons == ()
