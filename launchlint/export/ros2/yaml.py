"""A tree of tags as the text of a launch file in YAML."""

from __future__ import annotations

from launchlint.export.ros2.scalars import yaml
from launchlint.export.tree import one_line

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from launchlint.export.ros2.tree import Branch

_STEP = "  "


def written(root: Branch) -> str:
    """The whole file. Raises CannotWrite for a character that YAML cannot hold."""
    lines: list[str] = []
    _comments(root.above, "", lines)
    actions = root.actions or []
    lines.append("launch: []" if not actions else "launch:")
    lines[-1] += _beside(root)
    _actions(actions, "", lines)
    _comments(root.below, "", lines)
    return "\n".join(lines) + "\n"


def _actions(actions: Iterable[Branch], indent: str, lines: list[str]) -> None:
    """The items of a list, each with one key."""
    for each in actions:
        _comments(each.above, indent, lines)
        if each.actions is not None and not each.attributes and not each.named:
            lines.append(f"{indent}- {each.tag}:{'' if each.actions else ' []'}{_beside(each)}")
            _actions(each.actions, indent + 2 * _STEP, lines)
            _comments(each.below, indent + 2 * _STEP, lines)
        elif not each.attributes and not each.named:
            lines.append(f"{indent}- {each.tag}: {{}}{_beside(each)}")
            _comments(each.below, indent + 2 * _STEP, lines)
        else:
            lines.append(f"{indent}- {each.tag}:{_beside(each)}")
            _content(each, indent + 2 * _STEP, lines)


def _content(branch: Branch, indent: str, lines: list[str]) -> None:
    """The keys of a mapping."""
    for name, value in branch.attributes.items():
        lines.append(f"{indent}{name}: {yaml(value)}")
    by_name: dict[str, list[Branch]] = {}
    for each in branch.named:
        by_name.setdefault(each.tag, []).append(each)
    for name, items in by_name.items():
        lines.append(f"{indent}{name}:")
        for each in items:
            _item(each, indent, lines)
    if branch.actions is not None:
        lines.append(f"{indent}children:{'' if branch.actions else ' []'}")
        _actions(branch.actions, indent, lines)
    _comments(branch.below, indent, lines)


def _item(branch: Branch, indent: str, lines: list[str]) -> None:
    """One mapping in a list."""
    _comments(branch.above, indent, lines)
    at = len(lines)
    _content(branch, indent + _STEP, lines)
    lines[at] = f"{indent}- {lines[at][len(indent) + 2 :]}{_beside(branch)}"


def _beside(branch: Branch) -> str:
    return f"  # {one_line('; '.join(branch.beside))}" if branch.beside else ""


def _comments(texts: Iterable[str], indent: str, lines: list[str]) -> None:
    for text in texts:
        lines += [f"{indent}# {one_line(each)}".rstrip() for each in text.split("\n")] if text else [""]
