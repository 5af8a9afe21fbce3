"""Manifests as earlier runs have read them: as JSON values and back. What they are made from is read when somebody asks for the text."""

from __future__ import annotations

from launchlint.source import Source, Span
from launchlint.workspace.manifest import Dependency, Identity, Manifest, identify, parse_manifest, text_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from launchlint.workspace.contents import Contents


class _Later(Source):
    """The text of a file that is read when it is asked for; empty where it cannot be read any more."""

    __slots__ = ()

    def __init__(self, file: str) -> None:
        super().__init__(file, "")
        del self.text

    def __getattr__(self, name: str) -> Any:
        if name != "text":
            raise AttributeError(name)
        self.text = text_of(self.file)
        return self.text


def known_identity(path: str, held: Contents) -> Identity:
    """As :func:`launchlint.workspace.manifest.identify` of the file at ``path``. Raises OSError."""
    return held.fact(path, "identity", identify, list, _identity_from_json)


def known_manifest(path: str, held: Contents) -> Manifest:
    """As :func:`launchlint.workspace.manifest.read_manifest`."""
    return held.fact(path, "manifest", lambda data: parse_manifest(data, path), _to_json, lambda known: _from_json(known, path))


def _identity_from_json(known: Any) -> Identity:
    name, metapackage, reason = known
    if not (isinstance(name, str) and isinstance(metapackage, bool) and isinstance(reason, str)):
        raise TypeError("no identity")
    return Identity(name, metapackage, reason)


def _to_json(manifest: Manifest) -> list[Any]:
    dependencies = [[each.name, each.tag, *each.span, each.condition] for each in manifest.dependencies]
    return [
        manifest.name,
        manifest.format,
        manifest.metapackage,
        dependencies,
        manifest.plugins,
        manifest.build_types,
        manifest.name_span,
        manifest.root_end,
        manifest.build_conditions,
        sorted(manifest.people),
        manifest.urls,
        manifest.signatures,
        manifest.licences,
    ]


def _from_json(known: Any, path: str) -> Manifest:
    name, number, metapackage, dependencies, plugins, types, name_span, root_end, conditions, people, urls, signatures, licences = known
    return Manifest(
        _Later(path),
        name,
        number,
        metapackage,
        tuple(Dependency(each, tag, Span(start, end), condition) for each, tag, start, end, condition in dependencies),
        tuple(plugins),
        tuple(types),
        None if name_span is None else Span(*name_span),
        None if root_end is None else Span(*root_end),
        tuple(conditions),
        frozenset(people),
        tuple((kind, text) for kind, text in urls),
        tuple(signatures),
        tuple(licences),
    )
