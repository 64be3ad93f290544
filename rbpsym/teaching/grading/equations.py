"""Judging an equation against an equation: are they true together?

The key is solved for a symbol in which it is linear; the answer must then hold identically, and
determine that symbol too.
"""

from __future__ import annotations

from dataclasses import replace

from rbpsym.algebra import atoms
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.signs import sign
from rbpsym.errors import LimitError, ReadError, Undecided
from rbpsym.notation import tree as t
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.ground import Ground
from rbpsym.teaching.grading.judgement import Judgement
from rbpsym.teaching.grading.size import is_small
from rbpsym.teaching.grading.verdicts import are_equal

OUTSIDE = (LimitError, Undecided, ReadError, ZeroDivisionError)


def judge_equation(answer: t.Node, key: t.Chain, ground: Ground) -> Judgement:
    """The judgement on an equation that should say the same as the key, both of two sides."""
    if not isinstance(answer, t.Chain) or len(answer.items) != 2:
        return j.wrong("equation wanted")
    if not is_small(_gap(answer), _gap(key)):
        return j.undecided("the answer is too large to be multiplied out")
    for name in sorted(t.names(key) - {"pi"}):
        solved = _linear(key, name, ground)
        if solved is not None:
            return _on_key(answer, name, solved, ground)
    return j.undecided("the key is linear in none of its symbols")


def _gap(equation: t.Chain) -> t.Node:
    return t.Add((equation.items[0], t.Neg(equation.items[1])))


def _linear(equation: t.Chain, name: str, ground: Ground) -> Scalar | None:
    """What the equation makes of a symbol in which it is linear, with a factor that is never zero."""
    try:
        value = scalar(_gap(equation), ground.scope)
        index = atoms.intern("symbol", name)
        parts = value.num.by_power(index)
        if set(parts) - {0, 1} or 1 not in parts or index in value.den.atoms():
            return None
        factor = Scalar(parts[1])
        if not sign(factor, ground.assumptions).is_nonzero:
            return None
        return -Scalar(parts[0]) / factor if 0 in parts else factor - factor
    except OUTSIDE:
        return None


def _on_key(answer: t.Chain, name: str, solved: Scalar, ground: Ground) -> Judgement:
    """Does the answer hold where the key does, and nowhere else?"""
    there = replace(ground, scope=ground.scope.with_scalars({name: solved}))
    if are_equal(*answer.items, ground).is_proved:
        return j.wrong("identity")
    verdict = are_equal(*answer.items, there)
    if verdict.is_refuted:
        return replace(j.wrong("other equation"), witness=verdict.witness)
    own = _linear(answer, name, ground)
    if verdict.is_proved and own is not None:
        return j.RIGHT
    return j.undecided("it could not be shown that the equations are true together")


def solved_side(key: t.Chain) -> tuple[t.Sym, t.Node] | None:
    """(y, f) for a key y = f that is solved for a symbol."""
    left, *_, right = key.items
    return (left, right) if isinstance(left, t.Sym) and left.name not in t.names(right) else None
