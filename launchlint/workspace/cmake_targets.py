"""What was found in the CMake files of a package: its executables, the targets they are made of, and what is installed."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.named_tuple import NamedTuple
from launchlint.workspace.cmake_made import Made
from launchlint.workspace.cmake_scope import Value


class Generated(NamedTuple):
    """A file that ``configure_file`` makes: of which template (absolute path), with which variables.

    ``only_at``: ``@NAME@`` is replaced, ``${NAME}`` is not. ``literal``: the file is a plain copy.
    """

    template: str
    variables: Mapping[str, Value]
    only_at: bool
    literal: bool


class Install(NamedTuple):
    """One installed file or directory tree (absolute path), with the name patterns of ``install(DIRECTORY)``.

    ``only`` are the patterns behind FILES_MATCHING (empty: all files), ``without`` those with EXCLUDE; not those of REGEX.
    ``destination`` is ``None`` where it cannot be known. ``runnable`` are the patterns of the files that can be run once they are
    installed, whatever their permissions in the source: ``*`` for all of them. ``optional``: it need not exist. ``contents``: what is in
    the directory is installed, without the directory itself. ``renamed`` is the new name of a file; ``None`` where it cannot be known.
    """

    path: str
    is_directory: bool
    destination: Value
    only: tuple[str, ...] = ()
    without: tuple[str, ...] = ()
    runnable: tuple[str, ...] = ()
    optional: bool = False
    contents: bool = False
    renamed: Value = ""


class TargetInstall(NamedTuple):
    """One target of ``install(TARGETS …)``, and where it goes if it is an executable; ``None`` where that cannot be known."""

    name: str
    destination: Value


class Component(NamedTuple):
    """A component of ROS 2 that is registered: the target of the library with it, its class, and the program that runs it alone, if any."""

    library: str
    plugin: str
    executable: str


class ScriptsInstall(NamedTuple):
    """A file (``setup.cfg``, absolute) that names programs written in Python, and where ``ament_python_install_package`` installs them."""

    file: str
    destination: Value


class Target:
    """What one executable or library is made of.

    ``sources`` are absolute paths; those of them that the build makes of a template are in ``generated``, too. ``libraries`` is what is
    linked to it (names of targets or libraries); ``complete`` says that the sources are all known. ``output`` is the name of the file,
    without ``lib``. ``assumed``: a command that is not known gets a name and sources; it makes an executable if one of them has a main().
    """

    __slots__ = ("assumed", "complete", "generated", "is_library", "libraries", "output", "sources")

    def __init__(self, name: str, is_library: bool) -> None:
        self.output = name
        self.is_library = is_library
        self.sources: list[str] = []
        self.generated: dict[str, Generated] = {}
        self.libraries: list[str] = []
        self.complete = True
        self.assumed = False


class CMakeFacts:
    """What was found: ``executables`` maps the name of each executable to the command that makes it, ``targets`` the name of each target
    to what it is made of. ``programs`` are the files that are installed to be run, absolute; ``include_directories`` where headers are;
    ``made`` is what files the build makes.

    ``installs_by_name`` says that there is an ``install()`` as such: ``catkin_install_python`` makes scripts run in a devel space, too;
    ``installs_targets``, that it takes something that is built.
    ``target_installs`` are the targets that are installed, ``automatic`` those that ``ament_auto_package`` installs if it is called, and
    ``script_installs`` the programs in Python. ``components`` are what ``rclcpp_components_register_node(s)`` registers;
    ``parameter_libraries`` maps the name of each library of ``generate_parameter_library`` to the YAML file that it is made of (absolute),
    and ``automatic_libraries`` are those of ``ament_auto_add_library``. ``found`` are the packages that ``find_package`` asks for in ROS 2.
    ``gaps`` are those of ``installs_reasons`` that concern one destination (the second), if that is known.
    ``executables_reasons``, ``installs_reasons`` and ``targets_reasons`` say why the respective list may be incomplete; empty lists mean:
    it is complete.
    """

    __slots__ = (
        "automatic", "automatic_libraries", "components", "executables", "executables_reasons", "found", "gaps", "include_directories",
        "installs", "installs_by_name", "installs_reasons", "installs_targets", "made", "parameter_libraries", "programs", "project",
        "script_installs", "target_installs", "targets", "targets_reasons",
    )  # fmt: skip

    def __init__(self) -> None:
        self.project = ""
        self.executables: dict[str, str] = {}
        self.targets: dict[str, Target] = {}
        self.programs: dict[str, str] = {}
        self.include_directories: dict[str, None] = {}
        self.executables_reasons: list[str] = []
        self.installs: list[Install] = []
        self.installs_by_name = False
        self.installs_targets = False
        self.installs_reasons: list[str] = []
        self.found: dict[str, None] = {}
        self.gaps: list[tuple[str, Value]] = []
        self.automatic: list[str] = []
        self.automatic_libraries: list[str] = []
        self.components: list[Component] = []
        self.parameter_libraries: dict[str, str] = {}
        self.target_installs: list[TargetInstall] = []
        self.script_installs: list[ScriptsInstall] = []
        self.targets_reasons: list[str] = []
        self.made = Made()
