"""One answer against one key, without a worksheet: what a program or another system calls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.infix import read_infix
from rbpsym.statement.model import Problem
from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading.equations import judge_equation, solved_side
from rbpsym.teaching.grading.formula import Sought, judge_formula
from rbpsym.teaching.grading.ground import Ground, bare_ground, ground_of
from rbpsym.teaching.grading.judgement import Judgement, invalid
from rbpsym.teaching.grading.number import Wanted, judge_number
from rbpsym.teaching.grading.reading import read_formula
from rbpsym.teaching.model import Tolerance

Symbols = Mapping[str, str] | Iterable[str]


def grade_answer(
    answer: str, key: str | t.Node, symbols: Symbols | Problem | Ground, *, target: str = "", language: str = "en"
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


def _equation(answer: str, key: t.Chain, ground: Ground) -> Judgement:
    try:
        return judge_equation(read_formula(answer, ground.book), key, ground)
    except RbpsymError as error:
        return invalid(error)


def _ground(symbols: Symbols | Problem | Ground, language: str) -> Ground:
    if isinstance(symbols, Ground):
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
    return judge_number(answer, Wanted(value * measured.factor, measured, accepted, language=language))
