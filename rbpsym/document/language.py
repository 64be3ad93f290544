"""What a language brings to formulas: names of functions, the decimal mark, the words in which they are spoken."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from types import MappingProxyType

from rbpsym.document.phrases import phrases
from rbpsym.expr.glyphs import MARKS, Notation, notation_for
from rbpsym.statement.letters import letters_of
from rbpsym.statement.model import Problem


@cache
def usual_notation(language: str) -> Notation:
    """The notation of a language, as its phrases file tells it under [notation], [functions] and [spoken]."""
    table = phrases(language)
    marks = {key: table[f"notation.{key}"] for key in MARKS if f"notation.{key}" in table}
    parts = {part: MappingProxyType(part_of(part, language)) for part in ("functions", "spoken")}
    return replace(notation_for((), marks), functions=parts["functions"], words=parts["spoken"])


def part_of(part: str, language: str) -> dict[str, str]:
    """The entries of one table of a phrases file."""
    prefix = f"{part}."
    return {key.removeprefix(prefix): text for key, text in phrases(language).items() if key.startswith(prefix)}


def common_notation(
    problems: Iterable[Problem], language: str, said: Mapping[str, str] = MappingProxyType({})
) -> Notation:
    """The notation of several problems together, which should agree on names that they share; `said` overrides it."""
    problems = tuple(problems)
    own = {name for p in problems for name in letters_of(p).names}
    aliases = {name: drawn for p in problems for name, drawn in p.notation.items()}
    names = {name: word for p in problems for name, word in p.names_in(language).items()}
    found = notation_for(own, {**aliases, **said}, usual_notation(language))
    return replace(found, names=MappingProxyType(names))


def problem_notation(problem: Problem, language: str = "en") -> Notation:
    """How the names of a problem are printed in a language."""
    return common_notation((problem,), language)
