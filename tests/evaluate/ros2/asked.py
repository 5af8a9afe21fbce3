"""Who performs texts for the tests of params: variables from a mapping, files from another, no launch file needed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NoReturn

from launchlint.evaluate.session import Session
from launchlint.model import Unknown
from launchlint.problem import Problem
from launchlint.source import Origin, Place, Source, Span
from launchlint.syntax.ros2.description import Parameter, ParameterFile, Substitution, Text, TypedValue
from launchlint.workspace.packages import Packages

NOWHERE = Place(Source("x.launch.xml", ""), Span(0, 0))


class Stopped(Exception):
    """launch stopped."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.problem = problem


class Asked:
    """See the module; ``noticed`` fills."""

    digits_are_boolean = True
    tags_count = True
    outside = False

    def __init__(self, variables: Mapping[str, str] | None = None, files: Mapping[str, str] | None = None) -> None:
        self.variables = variables or {}
        overlay = {f"/w/{name}": text.encode() for name, text in (files or {}).items()}
        self.session = Session(Packages([], {}, explicit=True), {}, "/w", overlay)
        self.noticed: list[Problem] = []

    def perform(self, text: Text) -> str | Unknown:
        values = [piece if isinstance(piece, str) else self.variables.get(piece.name) for piece in text.pieces]
        return Unknown("?", "it is not known") if None in values else "".join(value for value in values if value is not None)

    def perform_content(self, source: Source) -> str | Unknown:
        return re.sub(r"\$\(var (\w+)\)", lambda match: self.variables[match[1]], source.text)

    def where(self, place: Place) -> Origin:
        return Origin(place)

    def notice(self, problem: Problem) -> None:
        self.noticed.append(problem)

    def fail(self, problem: Problem) -> NoReturn:
        raise Stopped(problem)


def text(*pieces: str | Substitution) -> Text:
    return Text(pieces, NOWHERE)


def var(name: str) -> Substitution:
    return Substitution(name, (), NOWHERE)


def param(name: str, *pieces: str | Substitution, type_: str | None = None) -> Parameter:
    """A param whose value is computed from these pieces."""
    return Parameter(text(name), TypedValue(text(*pieces), type_), (), NOWHERE)


def plain(name: str, value: bool | int | float | str) -> Parameter:
    """A param whose value the front end knows."""
    return Parameter(text(name), TypedValue(text(str(value)), None, value), (), NOWHERE)


def file(name: str, allow_substs: bool = False) -> ParameterFile:
    return ParameterFile(text(name), allow_substs, NOWHERE)
