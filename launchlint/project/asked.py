"""Which files are entries, with which args and rules: what people ask for, and what their configuration says."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable

from launchlint.check.options import Arguments, EntryRequest, Options
from launchlint.errors import UsageError

STANDARD_INPUT = "stdin.launch"
"""What standard input is called where nobody says it."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.evaluate.session import Session
    from launchlint.fix.format.style import Style
    from launchlint.workspace.configuration import Configuration


class EntryOptions:
    """What ``PATHS``, ``--stdin-filename``, ``--arg``, ``--entries``, ``--workspace``, ``--library``, ``--no-extract``, ``--distro`` and
    ``--config`` say.

    ``root`` is the directory that shown paths are relative to, and where there is none the current one; with it all paths are absolute.
    Raises UsageError where they clash.
    """

    def __init__(
        self,
        paths: tuple[str, ...],
        args: tuple[str, ...] = (),
        entries: str | None = None,
        workspace: tuple[str, ...] = (),
        config: str | None = None,
        stdin_filename: str | None = None,
        library: tuple[str, ...] = (),
        extract: bool = True,
        distro: str | None = None,
        root: str | None = None,
    ) -> None:
        if "-" in paths and len(paths) > 1:
            raise UsageError("- stands for standard input and cannot be mixed with other paths; check them in two calls")
        if stdin_filename is not None and paths != ("-",):
            raise UsageError("--stdin-filename names standard input; give - as the path too")
        if entries is not None and paths:
            raise UsageError("--entries names the files; give no paths beside it")
        self.standard_input = (stdin_filename or STANDARD_INPUT) if paths == ("-",) else None
        self.paths = paths or (() if entries else (os.curdir,))
        self.arguments = tuple(parse_argument(text) for text in args)
        self.entries = entries
        self.workspace = workspace
        self.library = library
        self.extract = extract
        self.distro = distro
        self.staged = False
        self.root = root
        self._config = config
        self.configuration = read_configuration(config, (self.standard_input,) if self.standard_input else self.paths, root)

    def called(self, data: bytes) -> str:
        """What standard input that holds ``data`` is called: as people say, else by what it is written in."""
        name = self.standard_input or STANDARD_INPUT
        if name != STANDARD_INPUT or data.lstrip()[:1] in (b"", b"<"):
            return name
        from launchlint.workspace.discovery import holds_python
        from launchlint.workspace.launch_root import has_launch_key

        return f"{name}.yaml" if has_launch_key(data) else f"{name}.py" if holds_python(name, data) else name

    def take_all_of_repository(self) -> tuple[str, ...]:
        """Take the whole repository around the current directory instead of the paths that were given. Returns those."""
        from launchlint.workspace.repository import repository_root

        given = self.paths
        self.paths = (os.path.relpath(repository_root(os.curdir)),)
        self.configuration = read_configuration(self._config, self.paths)
        return given

    @property
    def named(self) -> frozenset[str]:
        """The files that are asked for by name, absolute."""
        return frozenset(os.path.abspath(path) for path in self.paths if not os.path.isdir(path))

    def requests(self) -> tuple[list[EntryRequest], dict[str, bytes]]:
        """The entry files that are asked for, in order, and text that stands in for files: standard input for ``-``.

        Raises UsageError for a path that does not exist.
        """
        if self.standard_input is not None:
            data = sys.stdin.buffer.read()
            name = self.standard_input = self.called(data)
            return [EntryRequest(name, name, self.arguments)], {name: data}
        if self.entries is not None:
            return self._listed(), {}
        configuration = self.configuration
        declared: dict[str, list[Arguments]] = {}
        for entry in configuration.entries or ():
            declared.setdefault(os.path.abspath(entry.file), []).append(tuple(entry.arguments.items()))
        profiles = [tuple(arguments.items()) for arguments in configuration.args.values()]
        requests: dict[EntryRequest, None] = {}
        files, overlay = self._found()
        for file in files:
            given = declared.get(os.path.abspath(file)) if declared else None
            for arguments in given or [()]:
                for profile in ((), *profiles):
                    both = merge_arguments(merge_arguments(arguments, profile), self.arguments)
                    requests[EntryRequest(file, file, both, given is not None)] = None
        return list(requests), overlay

    def _found(self) -> tuple[Iterable[str], dict[str, bytes]]:
        """The launch files at and below the paths, and what is staged of those that differ from it."""
        from launchlint.workspace.discovery import discover

        exclude, directory = self.configuration.exclude, self.configuration.directory
        if not self.staged:
            return discover(self.paths, exclude, directory), {}
        from launchlint.workspace.index import staged
        from launchlint.workspace.repository import repository_root

        found = staged(repository_root(os.curdir), self.paths, exclude, directory)
        return found.files, found.content

    def requests_below(self, place: Callable[[str], str], back: Callable[[str], str]) -> dict[str, EntryRequest]:
        """As :meth:`requests`, of another copy of the files, one for each file; by the path as people see it.

        ``place`` says where a path is in that copy, ``back`` the reverse. Paths that are not there are left out.
        """
        from launchlint.workspace.discovery import discover

        configuration = self.configuration
        declared = {os.path.abspath(entry.file): tuple(entry.arguments.items()) for entry in reversed(configuration.entries or ())}
        paths = [place(path) for path in self.paths if os.path.exists(place(path))]
        directory = None if configuration.directory is None else place(configuration.directory)
        found: dict[str, EntryRequest] = {}
        for file in discover(paths, configuration.exclude, directory):
            shown = back(file)
            given = declared.get(os.path.abspath(shown))
            found[shown] = EntryRequest(file, file, merge_arguments(given or (), self.arguments), given is not None)
        return found

    def _listed(self) -> list[EntryRequest]:
        from launchlint.workspace.entries import load_entries

        assert self.entries is not None
        return [
            EntryRequest(entry.file, entry.as_ or entry.file, merge_arguments(tuple(entry.arguments.items()), self.arguments))
            for entry in load_entries(self.entries)
        ]

    def options(
        self,
        *,
        everything: bool = False,
        select: Iterable[str] = (),
        ignore: Iterable[str] = (),
        severity: Iterable[str] = (),
        cache: str | None = None,
    ) -> Options:
        """All that changes findings. ``everything``: all rules, with their own severities; ``cache``: where indices are kept."""
        from launchlint.project.selection import selected_rules, severities
        from launchlint.workspace.project_library import project_libraries

        configuration = self.configuration
        rules = selected_rules(tuple(select), tuple(ignore), configuration, everything=everything)
        workspaces = self.workspace or configuration.workspace
        for directory in self.workspace:
            if not os.path.isdir(directory):
                raise UsageError(
                    f"--workspace {directory}: there is no such directory; packages are looked for in it, so give one that exists"
                )
        if not workspaces:
            from launchlint.workspace.repository import default_workspaces

            workspaces = tuple(default_workspaces([self.standard_input] if self.standard_input else self.paths or [os.curdir]))
        return Options(
            rules=rules,
            workspaces=tuple(os.path.abspath(directory) for directory in workspaces),
            explicit=bool(self.workspace or configuration.workspace),
            variables={**os.environ, **configuration.env},
            root=os.getcwd() if self.root is None else self.root,
            severities={} if everything else severities(tuple(severity), configuration),
            complete=None if configuration.packages is None else configuration.packages == "complete",
            library=(
                *project_libraries((self.standard_input,) if self.standard_input else self.paths or (os.curdir,)),
                *(os.path.abspath(file) for file in (*configuration.library, *self.library)),
            ),
            library_cache=cache,
            style=style_of(configuration),
            extract=self.extract and configuration.extract,
            distro=self.distro or configuration.distro or "",
            sources_cache=None if cache is None else os.path.join(cache, "sources"),
        )


def leave_others_out(entry: EntryOptions, requests: list[EntryRequest], session: Session) -> tuple[list[EntryRequest], tuple[str, ...]]:
    """``requests`` without those that are no launch files and nobody asked for by name; and notices of them."""
    named = entry.named
    if entry.entries is not None or entry.standard_input is not None:
        named = frozenset(os.path.abspath(each.at) for each in requests)
    if not requests or (named and named.issuperset(os.path.abspath(each.at) for each in requests)):
        return requests, ()
    from launchlint.check.dialects import sort_out

    kept, other = sort_out(requests, named, session)
    notices = []
    if other:
        path, root = other[0]
        why = "their roots are others than <launch>" if root else "their nodes name no programs"
        many = f"{len(other)} files such as {path}: {why}, so that they are no launch files"
        one = f"{path}: {f'its root is <{root}>' if root else 'its nodes name no programs'}, so that it is no launch file"
        notices.append(f"left out {many if len(other) > 1 else one}; name a file to check it all the same")
    return kept, tuple(notices)


def parse_argument(text: str) -> tuple[str, str]:
    """``name:=value``, as on the launcher's own command line. Raises UsageError."""
    name, separator, value = text.partition(":=")
    if not separator or not name:
        raise UsageError(f"--arg {text}: an arg is given as name:=value, as to roslaunch and ros2 launch")
    return name, value


def merge_arguments(base: Arguments, over: Arguments) -> Arguments:
    """``base`` with the pairs of ``over`` in place of those of the same name."""
    return tuple({**dict(base), **dict(over)}.items())


def read_configuration(config: str | None, paths: tuple[str, ...], root: str | None = None) -> Configuration:
    """The configuration file named, or the nearest one to the first path; defaults where there is none."""
    from launchlint.workspace.configuration import Configuration, find_configuration, load

    if config is not None:
        return load(config)
    found = find_configuration(paths[0] if paths else os.curdir)
    return Configuration() if found is None else load(os.path.relpath(found) if root is None else found)


def style_of(configuration: Configuration) -> Style:
    """The normal form of a project."""
    from launchlint.fix.format.style import Style

    return Style(configuration.line_width, configuration.indent, configuration.sort_attributes)
