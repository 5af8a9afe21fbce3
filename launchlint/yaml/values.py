"""YAML text to plain Python values, as PyYAML's safe_load makes them; within the bounds of the reader of trees."""

from __future__ import annotations

import re
from typing import Any

from launchlint.yaml.refusals import YamlError
from launchlint.yaml.tree import MAPPING, SCALAR, SEQUENCE, STR, Node, Reader, YamlBeyond, parse, yaml_1_1

_SIMPLE = re.compile(r"[A-Za-z0-9_./+-](?:[\w./+=@-]| (?=[\w./+=@-]))*", re.ASCII)
"""Texts of one line that are one plain scalar, whatever stands around them; none begins like a list or another thing of YAML."""


def load(text: str, reader: Reader) -> Any:
    """The value of a YAML text of one document; None for an empty one. Raises YamlError and YamlBeyond."""
    if _SIMPLE.fullmatch(text) is not None and not text.startswith(("- ", "---", "...")) and text != "-":
        tag = yaml_1_1()(text)
        return text if tag == STR else value(Node(SCALAR, tag, text, 0, len(text)))
    root = parse(text, reader).root
    return None if root is None else value(root)


def value(node: Node) -> Any:
    """The value of a node of a tree. Raises YamlError and YamlBeyond."""
    import yaml

    constructor = yaml.constructor.SafeConstructor()
    try:
        return constructor.construct_document(as_pyyaml(yaml, node))
    except yaml.constructor.ConstructorError as error:
        place = error.problem_mark.index if error.problem_mark is not None else node.start
        raise YamlError(f"this does not fit its YAML tag (YAML says: {(error.problem or '')[:200]})", place, "value") from None
    except (RecursionError, MemoryError):
        raise YamlBeyond("this YAML value is nested too deeply", node.start) from None
    except Exception as error:  # whatever PyYAML meets here, everybody meets who loads the text by it
        said = f"Python says: {type(error).__name__}: {str(error)[:200]}"
        raise YamlError(f"this cannot be read as its YAML tag wants it ({said})", node.start, "value") from None


def as_pyyaml(yaml: Any, node: Node) -> Any:
    """The node of a tree as one of PyYAML's, for its constructors; ``yaml`` is that module. What several aliases mean is made once."""
    return _as_pyyaml(yaml, node, {})


def _as_pyyaml(yaml: Any, node: Node, made: dict[int, Any]) -> Any:
    known = made.get(id(node))
    if known is not None:
        return known
    mark = yaml.error.Mark(None, node.start, 0, 0, None, None)
    if node.kind == SCALAR:
        result = yaml.ScalarNode(node.tag, node.value, mark, mark)
    elif node.kind == SEQUENCE:
        result = yaml.SequenceNode(node.tag, [_as_pyyaml(yaml, child, made) for child in node.value], mark, mark)
    else:
        assert node.kind == MAPPING
        pairs = [(_as_pyyaml(yaml, key, made), _as_pyyaml(yaml, each, made)) for key, each in node.value]
        result = yaml.MappingNode(node.tag, pairs, mark, mark)
    made[id(node)] = result
    return result
