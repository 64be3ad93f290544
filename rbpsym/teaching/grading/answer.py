"""One answer against one key, without a worksheet: what a program or another system calls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, Scalar
from rbpsym.statement.model import Problem
from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.formula import Sought, determined, gap, judge_formula, linear_parts
from rbpsym.teaching.grading.ground import GradingGround, bare_ground, ground_of
from rbpsym.teaching.grading.judgement import Judgement, invalid
from rbpsym.teaching.grading.number import ExpectedNumber, judge_number
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.grading.verdicts import OUTSIDE, is_small
from rbpsym.teaching.model import Tolerance

# --- judging an equation against an equation: are they true together?
# The key is solved for a symbol in which it is linear; the answer must then hold identically, and
# determine that symbol too.


def judge_equation(answer: t.Node, key: t.Chain, ground: GradingGround) -> Judgement:
    """The judgement on an equation that should say the same as the key, both of two sides."""
    if not isinstance(answer, t.Chain) or len(answer.items) != 2:
        return j.wrong("equation wanted")
    if not is_small(gap(answer), ground, gap(key)):
        return j.undecided("the answer is too large to be multiplied out")
    for name in sorted(t.names(key) - {"pi"}):
        solved = _solved(key, name, ground)
        if solved is not None:
            return _on_key(answer, name, solved, ground)
    return j.undecided("the key is linear in none of its symbols")


def _solved(equation: t.Chain, name: str, ground: GradingGround) -> Scalar | None:
    """What the equation makes of a symbol in which it is linear, with a factor that is never zero."""
    with suppress(*OUTSIDE):
        factor, rest = linear_parts(equation, name, ground) or (NOTHING, NOTHING)
        return -rest / factor if sign(factor, ground.assumptions).is_nonzero else None
    return None


def _on_key(answer: t.Chain, name: str, solved: Scalar, ground: GradingGround) -> Judgement:
    """Does the answer hold where the key does, and nowhere else?"""
    found = determined(answer, name, solved, ground)
    if not isinstance(found, Verdict):
        return found
    if found.is_refuted:
        return replace(j.wrong("other equation"), witness=found.witness)
    if found.is_proved and _solved(answer, name, ground) is not None:
        return j.RIGHT
    return j.undecided("it could not be shown that the equations are true together")


def solved_side(key: t.Chain) -> tuple[t.Sym, t.Node] | None:
    """(y, f) for a key y = f that is solved for a symbol."""
    left, *_, right = key.items
    return (left, right) if isinstance(left, t.Sym) and left.name not in t.names(right) else None


# ---


Symbols = Mapping[str, str] | Iterable[str]


def grade_answer(
    answer: str, key: str | t.Node, symbols: Symbols | Problem | GradingGround, *, target: str = "", language: str = "en"
) -> Judgement:
    """The judgement on a typed formula, or on an equation where the key is one.

    symbols: the names with their signs (`{"m": "positive"}`), a problem, or a ground made before by
    `ground_of` (quicker for many answers). target: the symbol that is asked for. Raises ReadError if the key can't be read.

    >>> grade_answer("g m", "m*g", {"m": "positive", "g": "positive"}).status.value
    'right'
    """
    ground = _ground(symbols, language)
    value = key if isinstance(key, t.Node) else read_formula(key, ground.book)
    left = read_infix(target, ground.book.names | {target}) if target else None
    if isinstance(value, t.Chain):
        solved = solved_side(value)
        if left is None and solved is None and len(value.items) == 2:
            return _equation(answer, value, ground)
        left, value = left or (solved[0] if solved else None), value.items[-1]
    return judge_formula(answer, Sought(value, ground, left))


def _equation(answer: str, key: t.Chain, ground: GradingGround) -> Judgement:
    try:
        return judge_equation(read_formula(answer, ground.book), key, ground)
    except RbpsymError as error:
        return invalid(error)


def _ground(symbols: Symbols | Problem | GradingGround, language: str) -> GradingGround:
    if isinstance(symbols, GradingGround):
        return symbols
    if isinstance(symbols, Problem):
        from rbpsym.mechanics.study import Study

        return ground_of(Study(symbols), language)
    return bare_ground(symbols, language)


def grade_number(
    answer: str,
    value: float,
    unit: str = "",
    *,
    figures: int = 3,
    tolerance: float = 0.01,
    fewer: int = 1,
    more: int = 1,
    language: str = "en",
) -> Judgement:
    """The judgement on a typed number: value, unit and figures apart. `value` is in `unit`.

    Raises RbpsymError for a tolerance or a number of figures that makes no sense.

    >>> [(name, int(credit)) for name, credit in grade_number("5", 5, "V", figures=1).parts]
    [('value', 1), ('unit', 0), ('figures', 1)]
    """
    if not 0 <= tolerance < 1 or figures < 1:
        raise RbpsymError("a tolerance lies from 0 to below 1, and at least one figure is asked for")
    accepted = Tolerance(Fraction(tolerance).limit_denominator(10**9), figures, fewer, more)
    measured = read_unit(unit)
    return judge_number(answer, ExpectedNumber(value * measured.factor, measured, accepted, language=language))
