"""What is installed of a small package."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from launchlint.workspace.ament.installed import Installed
from launchlint.workspace.ament.reading import InstalledIndex
from launchlint.workspace.packages import Packages

MANIFEST = '<package format="3"><name>rover</name><export><build_type>{}</build_type></export></package>'


@pytest.fixture
def install(grow: Callable[[Mapping[str, str | None]], Path]) -> Callable[[Mapping[str, str | None]], Installed]:
    """A function from the files of a package called ``rover``, in the directory of the test, to what it installs."""

    def make(files: Mapping[str, str | None]) -> Installed:
        kind = "ament_cmake" if "CMakeLists.txt" in files else "ament_python"
        root = grow({"package.xml": MANIFEST.format(kind), **files})
        packages = Packages([str(root)], {}, explicit=True).colcon
        package = packages.get("rover", str(root))
        assert package is not None
        return packages.once(InstalledIndex).of(package)

    return make
