"""Solving a small system of balances for the accelerations, shown as a textbook shows it."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.present import present_ratio
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.notation import tree as t


def isolated(draft: Draft, left: Scalar, right: Scalar, name: str) -> t.Node:
    """The unknown of one linear equation as a quotient that keeps the form of both sides."""
    coefficient = derivative(left - right, name)
    rest = substitute(right - left, {name: NOTHING})
    if coefficient.den is not ONE or rest.den is not ONE or _varies(coefficient, draft):
        return draft.show(rest / coefficient, factor=True)
    return present_ratio(rest.num, coefficient.num, draft.study.style, factor=coefficient.num.is_monomial())


def _varies(coefficient: Scalar, draft: Draft) -> bool:
    """Whether the inertia depends on position: then common factors are cancelled first."""
    return any(depends_on(coefficient, name) for name in draft.study.system.coordinates)
