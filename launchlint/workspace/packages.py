"""Packages by name and by place: the static counterpart of rospkg.RosPack, and of what colcon and ament find.

Where several places have a package of one name, the order is: the workspaces as given, the entries of
``ROS_PACKAGE_PATH``, then installed prefixes (``CMAKE_PREFIX_PATH``, ``/opt/ros/$ROS_DISTRO``) and last ``/usr/share``, which Debian's
rospkg always adds. Every place is crawled when it is first needed, and only if no earlier one has the name. Where one
place has the source of a package and an installed copy of it, the source counts, whatever rospkg would meet first.
For ROS 2 (:attr:`Packages.colcon`) the order is: the workspaces, ``AMENT_PREFIX_PATH``, then the other installed prefixes.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence

from launchlint.workspace.crawl import COLCON, ROSPACK, Way, examine, hides
from launchlint.workspace.looking import QUESTION, Answer, Looked, answered, note, note_question, unnoted, watched
from launchlint.workspace.package import Kind, Package
from launchlint.workspace.place import Hidden, Place
from launchlint.workspace.prefixes import Prefix, ament_prefixes, prefixes
from launchlint.workspace.public_packages import PublicPackages, public_names
from launchlint.workspace.repository import LONGEST_PATH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, TypeVar

    from launchlint.workspace.arg_uses import ArgUses
    from launchlint.workspace.contents import Contents
    from launchlint.workspace.distributions import Distributions
    from launchlint.workspace.looking import Kept, Surveyed
    from launchlint.workspace.releases import Needs
    from launchlint.workspace.variables import Readers

    Made = TypeVar("Made")
    Seen = TypeVar("Seen", bound=Surveyed)

SYSTEM_SHARE = "/usr/share"
DEBIAN_CATKIN = "/usr/lib/python3/dist-packages/catkin"
"""Debian's own catkin looks for resources of every package in ``/usr`` too, before the source tree, whatever the workspaces are."""


class Packages:
    """All packages that can be seen from here.

    Args:
        workspaces: directories, searched in this order before anything else.
        environment: environment variables; read are ROS_PACKAGE_PATH, CMAKE_PREFIX_PATH and ROS_DISTRO.
        explicit: the workspaces were given by the user (``--workspace``); the machine's own ``/usr`` is then left out.
        complete: overrides :attr:`complete` (configuration key ``packages``).
        way: how packages are found; :attr:`colcon` are those that colcon finds in the same places.

    ``held`` may be set before anything is asked for: what files hold, as an earlier run has seen it; ``kept``: what it was answered.
    """

    def __init__(
        self,
        workspaces: Sequence[str],
        environment: Mapping[str, str],
        *,
        explicit: bool,
        complete: bool | None = None,
        way: Way = ROSPACK,
    ) -> None:
        self.workspaces: tuple[str, ...] = tuple(dict.fromkeys(os.path.abspath(each) for each in workspaces))
        self._environment = environment
        self._explicit = explicit
        self._complete = complete
        self.way = way
        self.held: Contents | None = None
        self.kept: Kept | None = None
        self._places: list[Place] | None = None
        self._prefixes: list[Prefix] | None = None
        self._made: dict[Callable[..., Any], Any] = {}
        self._read_for: dict[Callable[..., Any], Looked] = {}
        self._found: dict[tuple[str, str], Package | None] = {}
        self._of_directory: dict[str, Package | None] = {}
        self._sources: dict[str, Place] = {}
        self._resolved: dict[tuple[str, str], str] = {}
        self._duplicates: dict[str, list[Package]] | None = None
        self._hidden: dict[str, Hidden] | None = None
        self._needs: dict[str, Needs] = {}
        self._answers: dict[str, tuple[Any, Answer]] = {}

    @property
    def colcon(self) -> Packages:
        """The packages as ROS 2 sees them, in the same workspaces and environment; these themselves where they are those already."""
        return self if self.way is COLCON else self.once(_as_colcon)

    def seen_by(self, way: Way) -> Packages:
        """The packages in the same places and environment, found in another way."""
        other = Packages(self.workspaces, self._environment, explicit=self._explicit, complete=self._complete, way=way)
        other.held = self.held
        return other

    def once(self, make: Callable[[Packages], Made]) -> Made:
        """What ``make`` (a class or a function of a module) makes of these packages, made once and kept with them.

        Whoever asks hangs on all that was looked at for it.
        """
        if make not in self._made:
            self._made[make], self._read_for[make] = watched(lambda: make(self))
        else:
            note(self._read_for[make])
        made: Made = self._made[make]
        return made

    def answer(self, question: Callable[[Packages, str], Made], about: str) -> Made:
        """The answer to a question (:func:`launchlint.workspace.questions.question`), found once; whoever asks hangs on that alone."""
        made: Made = answered(self._answers, self._asked(question, about), lambda: question(self, about), self.kept)
        return made

    def answer_state(self, question: Callable[[Packages, str], Any], about: str) -> str:
        """The state of that answer."""
        self.answer(question, about)
        return self._answers[self._asked(question, about)][1].state

    def _asked(self, question: Callable[[Packages, str], Any], about: str) -> str:
        return f"{QUESTION}{self.way.name} {question.__module__}:{question.__name__} {about}"

    def answers(self) -> list[Answer]:
        """All answers that were given."""
        return [known for _, known in self._answers.values()]

    def survey(self, read: Callable[..., Seen], *held: Contents | None) -> Seen:
        """What ``read`` sees in the workspaces (with what it is ``held`` that files hold, if it can use that), read once.

        Whoever asks hangs on all that it looked at.
        """
        if read not in self._made:
            self._made[read] = read(self.workspaces, *held)
        seen: Seen = self._made[read]
        note(seen.looked)
        return seen

    def texts_changed(self, files: Collection[str], *, listed: bool) -> None:
        """Files (absolute) hold something else: what was seen of their texts in the whole workspace is looked at again, when asked for.

        ``listed``: they may also have been made or removed. What manifests and build files hold is the same.
        """
        from launchlint.workspace.texts import parts_of

        directories = {os.path.dirname(file) for file in files} if listed else frozenset()
        changed = {*files, *directories, *(part for file in files for part in parts_of(file))}
        self._answers = {
            name: known for name, known in self._answers.items() if all(map(changed.isdisjoint, known[1].looked.sets()))
        }  # fmt: skip
        for read, seen in list(self._made.items()):
            if isinstance(seen, Packages):
                seen.texts_changed(files, listed=listed)
                continue
            looked: frozenset[str] = getattr(seen, "looked", frozenset())
            met = [file for file in files if file in looked or not looked.isdisjoint(parts_of(file))]
            if not looked.isdisjoint(directories) or (met and not hasattr(seen, "after")):
                del self._made[read]
            elif met:
                self._made[read] = seen.after(met)

    def get(self, name: str, near: str) -> Package | None:
        """The package called ``name`` as a launch file at ``near`` gets it; ``None`` where there is none.

        Of several copies in one place the one nearest the file is taken: the longest common path, then the one crawled first. (The
        real rospack takes whichever the file system's order gives it.)
        """
        if not name:
            return None
        note_question(self.way.name, "get", name)
        key = (name, near)
        if key not in self._found:
            self._found[key] = self._search(name, near)
        return self._found[key]

    def copies(self, name: str) -> Sequence[Package]:
        """The packages of this name in the first place that has any, in the order of the crawl."""
        note_question(self.way.name, "get", name)
        return next((copies for place in self._searched if (copies := place.by_name.get(name))), ())

    def find(self, name: str, near: str) -> str | None:
        """The directory of package ``name``, as ``$(find name)`` answers it (rospkg.RosPack.get_path)."""
        return None if (package := self.get(name, near)) is None else package.directory

    def has(self, name: str) -> bool:
        """Whether any place has a package of this name."""
        return bool(self.copies(name))

    def package_of(self, path: str) -> Package | None:
        """The package (or metapackage, or broken package) that the file or directory ``path`` lies in.

        That is the nearest directory upward with a ``manifest.xml`` or ``package.xml`` (rospkg.get_package_name).
        """
        path = os.path.abspath(path)
        directory = path if os.path.isdir(path) else os.path.dirname(path)
        if len(directory) > LONGEST_PATH:
            directory = directory[: directory.rfind(os.sep, 0, LONGEST_PATH)] or os.sep
        note_question(self.way.name, "of", directory)
        walked: list[str] = []
        while directory not in self._of_directory:
            walked.append(directory)
            file = next((each for each in reversed(self.way.manifests) if os.path.isfile(os.path.join(directory, each))), None)
            if file is not None:
                self._of_directory[directory] = Package(examine(directory, file, self.held), self.held)
            elif directory == os.path.dirname(directory):
                self._of_directory[directory] = None
            else:
                directory = os.path.dirname(directory)
        answer = self._of_directory[directory]
        for each in walked:
            self._of_directory[each] = answer
        return answer

    def with_manifest(self, path: str) -> Package | None:
        """The package of which ``path`` (absolute) is the manifest, wherever it lies: a question can be about it."""
        found = self.once(_by_manifest).get(path) or self.package_of(os.path.dirname(path))
        return found if found is not None and found.manifest_path == path else None

    def described_by(self, file: str) -> Kind | None:
        """What the package is of which ``file`` (absolute) is the manifest; ``None`` where it is none that counts."""
        package = self.package_of(os.path.dirname(file))
        return None if package is None or package.manifest_path != file else package.kind

    def names(self) -> list[str]:
        """Names of all packages, sorted."""
        note_question(self.way.name, "names")
        return sorted({name for place in self._searched for name in place.by_name})

    def hidden(self, name: str) -> Hidden | None:
        """The package ``name`` that a workspace holds and a ``CATKIN_IGNORE`` hides from catkin and rospack; ``None`` where there is none.

        COLCON_IGNORE and AMENT_IGNORE hide nothing from rospack (rospkg.rospack.list_by_path): such a package is simply there. From
        colcon it is those that hide packages.
        """
        note_question(self.way.name, "hidden", name)
        return None if self.has(name) else self._all_hidden().get(name)

    def is_hidden(self, directory: str) -> bool:
        """Whether ``directory`` (absolute) is or lies in one that a ``CATKIN_IGNORE`` hides; below a package nobody looks for one."""
        note_question(self.way.name, "is-hidden", directory)
        return any(hides(workspace, directory, self.way) for workspace in self.workspaces)

    def _all_hidden(self) -> dict[str, Hidden]:
        if self._hidden is None:
            self._hidden = {}
            for place in self.own_places:
                for each in place.hidden():
                    self._hidden.setdefault(each.name, each)
        return self._hidden

    def hook_variables(self) -> Mapping[str, str]:
        """The environment variables that env-hooks of the workspaces' packages set, each with the file (absolute) that does."""
        from launchlint.workspace.surveys import hook_variables

        return self.answer(hook_variables, "")

    def listed_in(self, name: str) -> str | None:
        """The list of sources (absolute: .gitmodules, *.rosinstall, *.repos) that names a repository called ``name`` which is not here.

        A repository is here where a package lies in a directory of its name: then its packages are those, and no others.
        """
        from launchlint.workspace.surveys import listed_in

        return self.answer(listed_in, name)

    def variable_in(self, name: str) -> str | None:
        """A file (absolute) of the workspaces, no launch file, that sets or reads the variable; ``None`` where there is none."""
        from launchlint.workspace.surveys import variable_in

        return self.answer(variable_in, name)

    def documented_in(self, name: str) -> str | None:
        """A README or another document of the workspaces (absolute) that names package ``name``, or a script, a workflow or an image that
        fetches something of that name; ``None`` where there is none.
        """
        from launchlint.workspace.surveys import documented_in

        return self.answer(documented_in, name)

    def told_to_install(self) -> tuple[str, ...]:
        """The lines of the documents of the workspaces in which people are told to install something."""
        from launchlint.workspace.surveys import told_to_install

        return self.answer(told_to_install, "")

    def map_saved_in(self, name: str) -> str | None:
        """A document that tells people to save a map under that name, without path and end; ``None`` where there is none."""
        from launchlint.workspace.surveys import map_saved_in

        return self.answer(map_saved_in, name)

    def distributions(self) -> Distributions:
        """What the workspaces say of ROS distributions and of installing (in a README, a workflow, an image, a script …)."""
        from launchlint.workspace.distributions import Distributions
        from launchlint.workspace.surveys import distributions

        return Distributions(*self.answer(distributions, ""))

    def survey_distributions(self) -> Distributions:
        """The same, with all that was looked at."""
        note_question(self.way.name, "all")
        return self.survey(self._read_distributions)

    def _read_distributions(self, workspaces: Sequence[str]) -> Distributions:
        from launchlint.workspace.distributions import read_distributions

        own = (each.directory for place in self.own_places for each in place.everything)
        return read_distributions(workspaces, own)

    def needs(self, package: Package) -> frozenset[str]:
        """The packages that ``package`` declares to run, and those that its launch files name."""
        from launchlint.workspace.releases import read_needs

        if package.directory not in self._needs:
            self._needs[package.directory] = read_needs(package.directory)
        note(self._needs[package.directory].looked)
        return self._needs[package.directory].names | package.run_dependencies

    def arg_uses(self) -> ArgUses:
        """Where files of the workspaces give args to launch files by name."""
        from launchlint.workspace.arg_uses import read_arg_uses

        return self.survey(read_arg_uses, self.held)

    def launch_readers(self) -> Readers:
        """Which environment variables launch files of the workspaces read."""
        from launchlint.workspace.variables import read_in_launch_files

        return self.survey(read_in_launch_files, self.held)

    def machine_defined_in(self, name: str) -> str | None:
        """A launch file of the workspaces (absolute) that defines machine ``name``; ``None`` where there is none."""
        from launchlint.workspace.surveys import machine_defined_in

        return self.answer(machine_defined_in, name)

    def launch_files(self, name: str) -> tuple[str, ...]:
        """The launch files (absolute) of the workspaces that are called ``name``, whatever directory they lie in."""
        from launchlint.workspace.surveys import launch_files

        return self.answer(launch_files, name)

    def container_users(self) -> frozenset[str]:
        """The users whose home directories the containers of the workspaces have."""
        from launchlint.workspace.surveys import container_users

        return self.answer(container_users, "")

    def container_directories(self) -> frozenset[str]:
        """The directories right below the root (``/ws``) that the containers of the workspaces have, and other machines have not."""
        from launchlint.workspace.surveys import container_directories

        return self.answer(container_directories, "")

    def duplicates(self) -> dict[str, list[Package]]:
        """Names that several packages of one workspace bear, with these packages in the order of the crawl; sorted by name.

        A directory that is reached twice through symbolic links counts once.
        """
        note_question(self.way.name, "duplicates")
        if self._duplicates is None:
            self._duplicates = self._find_duplicates()
        return self._duplicates

    def _find_duplicates(self) -> dict[str, list[Package]]:
        found: dict[str, list[Package]] = {}
        for place in self.own_places:
            for name, packages in place.by_name.items():
                if len(packages) > 1 and name not in found:
                    distinct = list({os.path.realpath(each.directory): each for each in reversed(packages)}.values())
                    if len(distinct) > 1:
                        found[name] = distinct[::-1]
        return dict(sorted(found.items()))

    def broken(self) -> list[Package]:
        """Packages of the workspaces whose ``package.xml`` cannot be used, in the order of the crawl.

        The real rospkg stops at the first of them: no ``$(find)`` works any more.
        """
        return [each for place in self.places[: len(self.workspaces)] for each in place.everything if each.broken]

    @property
    def complete(self) -> bool:
        """Whether what is not found here does not exist: true where a ROS installation is set up on this machine."""
        if self._complete is not None:
            return self._complete
        variable = "AMENT_PREFIX_PATH" if self.way is COLCON else "ROS_PACKAGE_PATH"
        return bool(self._environment.get(variable, "").strip(":")) or any(each.is_ros for each in self.prefixes)

    @property
    def public(self) -> PublicPackages:
        """The packages of the public ROS index, whether or not they are here; nothing is read before the first lookup."""
        return public_names()

    @property
    def places(self) -> list[Place]:
        """The directory trees that are searched, in this order. Whoever asks hangs on which packages there are in all of them."""
        note_question(self.way.name, "all")
        return self._searched

    @property
    def own_places(self) -> list[Place]:
        """Those of the workspaces; whoever asks notes what of them it hangs on."""
        return self._searched[: len(self.workspaces)]

    @property
    def _searched(self) -> list[Place]:
        if self._places is None:
            roots = list(self.workspaces)
            if self.way is not COLCON:
                roots += [os.path.abspath(each) for each in self._environment.get("ROS_PACKAGE_PATH", "").split(os.pathsep) if each]
            roots += [each.share for each in self.prefixes]
            if not self._explicit and self.way is not COLCON:
                roots.append(SYSTEM_SHARE)
            self._places = [Place(each, self.way, self.held) for each in dict.fromkeys(roots)]
        return self._places

    @property
    def prefixes(self) -> list[Prefix]:
        """Devel and install spaces, in the order of the search."""
        if self._prefixes is None:
            self._prefixes = (ament_prefixes if self.way is COLCON else prefixes)(self._environment)
        return self._prefixes

    def resolve_resource(self, directory: str, path: str) -> str:
        """What ``$(find pkg)/path`` stands for, where ``directory`` is what ``find`` answered (roslaunch.substitution_args._find).

        Args:
            directory: directory of the package.
            path: all that follows the command up to a blank, with its leading slash if there is one; may be empty.

        Returns:
            An executable of that base name in the package's libexec directories, else the file below the package if it is
            executable, else the first that exists below the share and source directories of the catkin workspaces on
            CMAKE_PREFIX_PATH, else ``directory`` joined with ``path``.
        """
        key = (directory, path)
        note_question(self.way.name, "resource", "\0".join(key))
        if key not in self._resolved:
            with unnoted():
                self._resolved[key] = self._resolve_resource(directory, path)
        return self._resolved[key]

    def _resolve_resource(self, directory: str, path: str) -> str:
        relative = path.replace("\\", "/")
        relative = relative.removeprefix("/")
        if not relative:
            return directory
        beside = os.path.join(directory, relative)
        spaces = [each for each in self.prefixes if each.is_catkin]
        if os.path.isdir(DEBIAN_CATKIN):
            spaces.append(Prefix("/usr", False, False))
        if not spaces:
            return beside
        package = self.package_of(directory)
        if package is None or not package.name:
            return beside
        for space in spaces:
            libexec = space.libexec(package.name)
            if libexec:
                executable = os.path.join(libexec[0], os.path.basename(relative))
                if is_executable(executable):
                    return executable
                break
        if is_executable(beside):
            return beside
        for space in spaces:
            for candidate in self._shares(space, package.name):
                resource = os.path.join(candidate, relative)
                if os.path.exists(resource):
                    return resource
        return beside

    def _shares(self, space: Prefix, name: str) -> Iterable[str]:
        yield os.path.join(space.share, name)
        for source in space.sources():
            for package in self._place(source).by_name.get(name, ())[:1]:
                yield package.directory

    def _place(self, root: str) -> Place:
        for place in self._searched:
            if place.root == root:
                return place
        return self._sources.setdefault(root, Place(root, self.way, self.held))

    def _search(self, name: str, near: str) -> Package | None:
        copies = self.copies(name)
        if len(copies) < 2:
            return copies[0] if copies else None
        path = os.path.abspath(near)
        return max(copies, key=lambda copy: len(os.path.commonpath((copy.directory, path))))


def is_executable(path: str) -> bool:
    """Whether ``path`` is a file that this user may execute."""
    return os.path.isfile(path) and os.access(path, os.X_OK)


def _by_manifest(packages: Packages) -> dict[str, Package]:
    return {each.manifest_path: each for place in packages.places for each in place.everything}


def _as_colcon(packages: Packages) -> Packages:
    return packages.seen_by(COLCON)
