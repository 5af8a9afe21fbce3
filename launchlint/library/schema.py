"""The library format as a JSON Schema, made from the same tables as the validator."""

from __future__ import annotations

from collections.abc import Mapping

from launchlint.library.format import LIBRARIES
from launchlint.library.shapes import Amount, Choice, Entries, Flag, Items, Keys, Number, Rule, Shape, Text

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def json_schema(version: int | None = None) -> Mapping[str, Any]:
    """The format as a JSON Schema (2020-12), for editors and other programs: one version of it, or all.

    It knows shapes, not grammars: what a name, a type or a template looks like, and how deep things are nested, only the validator knows.
    """
    versions = list(LIBRARIES) if version is None else [version]
    schemas = {each: _schema(LIBRARIES[each]) for each in versions}
    for each, schema in schemas.items():
        schema["properties"]["version"] = {"const": each}
    found: dict[str, Any] = schemas[versions[-1]]
    for each in reversed(versions[:-1]):
        found = {"if": {"properties": {"version": {"const": each}}}, "then": schemas[each], "else": found}
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"launchlint library, version {' or '.join(map(str, versions))}",
        **found,
        "$defs": {"condition": _CONDITION_SCHEMA, "each": _EACH_SCHEMA},
    }


def _schema(shape: Shape) -> dict[str, Any]:
    if isinstance(shape, Keys):
        properties = {key: _schema(inner) for key, inner in shape.keys.items()}
        required = {"required": list(shape.required)} if shape.required else {}
        return {"type": "object", "properties": properties, **required, "additionalProperties": False}
    if isinstance(shape, Entries):
        return {"type": "object", "propertyNames": {"minLength": 1, "maxLength": 1000}, "additionalProperties": _schema(shape.each)}
    if isinstance(shape, Items):
        return {"type": "array", "items": _schema(shape.each)}
    if isinstance(shape, Choice):
        return _chosen(shape)
    if isinstance(shape, Text):
        limits = {"enum": list(shape.one_of)} if shape.one_of else {"maxLength": shape.longest}
        return {"anyOf": [{"type": "string", **limits}, _TEMPLATE]} if shape.templates else {"type": "string", **limits}
    if isinstance(shape, Amount):
        words = [{"enum": list(shape.words)}] if shape.words else []
        return {"anyOf": [{"type": "integer" if shape.whole else "number", "minimum": 0}, *words, _TEMPLATE]}
    if isinstance(shape, Number):
        return {"type": "integer", "minimum": shape.least}
    if isinstance(shape, Flag):
        return {"type": "boolean"}
    return {"$ref": f"#/$defs/{shape.grammar}"} if isinstance(shape, Rule) else {}


def _chosen(shape: Choice) -> dict[str, Any]:
    default = shape.shapes[shape.default]
    found = _schema(default)
    for said, inner in shape.shapes.items():
        if inner is not default:
            asked = {"properties": {shape.key: {"const": said}}, "required": [shape.key]}
            found = {"if": {"type": "object", **asked}, "then": _schema(inner), "else": found}
    return found


_TEMPLATE: Mapping[str, Any] = {"type": "string", "pattern": r"[{}]", "maxLength": 1000}
_STRING: Mapping[str, Any] = {"type": "string", "minLength": 1, "maxLength": 1000}
_ARGUMENT: Mapping[str, Any] = {"type": "integer", "minimum": -9999, "maximum": 9999, "not": {"const": 0}}
_CONDITION: Mapping[str, Any] = {"$ref": "#/$defs/condition"}
_COMPARISON: Mapping[str, Any] = {"is": {}, "in": {"type": "array"}, "set": {"type": "boolean"}, "default": {}}


def _one(key: str, inner: Mapping[str, Any], more: Mapping[str, Any] | None = None) -> dict[str, Any]:
    return {"type": "object", "properties": {key: inner, **(more or {})}, "required": [key], "additionalProperties": False}


_CONDITION_SCHEMA: Mapping[str, Any] = {
    "oneOf": [
        _one("param", _STRING, _COMPARISON),
        _one("arg", _ARGUMENT, _COMPARISON),
        _one("option", _STRING, _COMPARISON),
        _one("remap", _STRING),
        _one("text", _STRING),
        _one("not", _CONDITION),
        _one("all", {"type": "array", "items": _CONDITION, "minItems": 1}),
        _one("any", {"type": "array", "items": _CONDITION, "minItems": 1}),
    ]
}
_WORDS: Mapping[str, Any] = {"default": {"type": "array", "items": {"type": "string"}}}
_PARTS = r"^[^{}]*(\{[a-z]{1,20}\}[^{}]+)*\{[a-z]{1,20}\}[^{}]*$"
_LIKE: Mapping[str, Any] = {"like": {"type": "string", "maxLength": 1000, "pattern": _PARTS}}
_EACH_SCHEMA: Mapping[str, Any] = {
    "oneOf": [_one("args", _ARGUMENT, _LIKE), _one("param", _STRING, _WORDS), _one("words", _STRING, _WORDS)]
}
