"""What is said of something that may be written, when somebody looks at it in the list of what is offered: in Markdown."""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.ide.files import package_of, resolved
from launchlint.ide.hover import MOST, taken
from launchlint.ide.view import View

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launchlint.library.program import Program


def documentation(view: View, what: str, name: str, detail: str) -> str:
    """Of a choice (:class:`launchlint.ide.completion.Choice`): ``what`` it is, its label, and its detail; empty where nothing is known."""
    lines: Iterator[str] = iter(())
    if what == "package":
        lines = _package(view, name)
    elif what == "executable":
        library = view.snapshot.library.of_launch(view.dialect.name)
        lines = _program(library.executable(detail, name) or library.nodelet(name))
    elif what == "file":
        path = resolved(view, name)
        lines = iter(()) if path is None else taken(view, path)
    elif what == "name":
        lines = _ends(view, name)
    return "\n".join(lines)


def _package(view: View, name: str) -> Iterator[str]:
    home = package_of(view, name)
    if home is None:
        yield "not on this machine"
        return
    yield f"`{home.directory}`"
    index = view.snapshot.library.of_launch(view.dialect.name).executables(name)
    if index:
        yield "\n" + ", ".join(f"`{each}`" for each in list(index)[:MOST])


def _program(program: Program | None) -> Iterator[str]:
    declarations = [] if program is None else [each for variant in program.variants[:1] for each in variant.declarations]
    for each in declarations[:MOST]:
        yield f"- {each.category} `{each.name}`" + (f" ({each.type})" if each.type not in ("", "*") else "")
    if len(declarations) > MOST:
        yield f"- … and {len(declarations) - MOST} more"


def _ends(view: View, name: str) -> Iterator[str]:
    for configuration in view.configurations:
        graph = configuration.graph
        for channel in () if graph is None else graph.channels.values():
            if channel.name == name:
                for endpoint in (*channel.offers, *channel.uses)[:MOST]:
                    yield f"- `{endpoint.node}`: {endpoint.role} {endpoint.type}".rstrip()
                return
