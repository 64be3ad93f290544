"""Every expression of the JSON answer, read by sympy with the names that it offers, holds just the symbols that were meant."""

from __future__ import annotations

import re

import pytest
import sympy

from rbpsym.solve import solve
from rbpsym.statement.library import problem_files
from tests.letters.renaming import Names, renamed
from tests.library.derived import answered

RELATION = re.compile(r" (?:!=|<=?|>=?) 0$")
WORD, FUNCTIONS = re.compile(r"[A-Za-z]\w*"), {"sin", "cos", "sqrt", "asin", "acos", "atan", "exp", "log", "pi", "abs"}
# what a key holds, if not expressions
WORDS = ("problem", "coordinates", "symbols", "verdicts", "speeds", "force", "friction", "contact", "coordinate", "name",
         "reason", "stable", "stability", "state", "until", "complete", "op", "relation", "why", "at_place", "sign")  # fmt: skip


def expressions(value: object, key: str = "") -> list[str]:
    if isinstance(value, dict):
        return [text for k, part in value.items() if k not in WORDS or (isinstance(part, dict) and k == "speeds")
                for text in expressions(part, k)]  # fmt: skip
    if isinstance(value, list):
        return [text for part in value for text in expressions(part, key)]
    return [value] if isinstance(value, str) else []


def check(answer: dict) -> int:
    symbols = {name: sympy.Symbol(entry["sympy"]) for name, entry in answer["symbols"].items()}
    assert len(set(symbols.values())) == len(symbols)
    assert all(sympy.sympify(symbol.name) == symbol for symbol in symbols.values())
    found = expressions(answer)
    for text in found:
        read = sympy.sympify(RELATION.split(text)[0], locals=symbols)  # sympy decides what it can of a relation
        meant = set(WORD.findall(text)) - FUNCTIONS
        assert {symbols[name] for name in meant} == read.free_symbols, text
        assert not read.has(sympy.I, sympy.zoo, sympy.nan), text
    return len(found)


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_sympy_reads_what_is_meant(name: str) -> None:
    assert check(answered(name)) > 5


@pytest.mark.parametrize(("m", "ell", "g"), [("I", "N", "S"), ("lambda", "beta", "E"), ("Integer", "len", "Q"),
                                             ("is", "J_", "I"), ("gamma", "zeta", "abs_")])  # fmt: skip
def test_names_that_sympy_has_itself(m: str, ell: str, g: str) -> None:
    problem = renamed("rod-pendulum", Names({"M": m, "ell": ell, "g": g}, {}))
    answer = solve(problem, simulation=False)
    assert check(answer) > 5
    assert answer["verdicts"]["proved"] == answer["verdicts"]["steps"]
