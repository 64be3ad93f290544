"""Solving a small system of balances for the accelerations, shown as a textbook shows it."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on, derivative, substitute
from rbpsym.algebra.normal import is_zero, without_even_roots
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.present import present_ratio
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation.draft import MUCH_SHORTER, Draft, length
from rbpsym.notation import tree as t


def isolated(draft: Draft, left: Scalar, right: Scalar, name: str, *, as_ratio: bool = False) -> t.Node:
    """The unknown of one linear equation as a quotient that keeps the form of both sides.

    With `as_ratio`, what is no sum stands before it (see `present_ratio`).
    """
    coefficient = derivative(left - right, name)
    rest = substitute(right - left, {name: NOTHING})
    if is_zero(rest):
        return draft.show(NOTHING)
    if coefficient.den is not ONE or rest.den is not ONE or _varies(coefficient, draft):
        return draft.show(rest / coefficient, factor=True)
    above, below = without_even_roots(rest.num), without_even_roots(coefficient.num)
    return present_ratio(above, below, draft.study.style, factor=below.is_monomial(), as_ratio=as_ratio)


def isolated_again(draft: Draft, left: Scalar, right: Scalar, name: str) -> t.Node:
    """The unknown of one linear equation, in the form in which it was found before where that has the same sides."""
    forms = [isolated(draft, left, right, name, as_ratio=as_ratio) for as_ratio in (False, True)]
    found = [step for step in draft.steps if step.id == f"motion.{name.removesuffix('_ddot')}"]
    known = [item for step in found if isinstance(step.statement, t.Chain) for item in step.statement.items]
    return next((form for form in forms if form in known), forms[0])


def _varies(coefficient: Scalar, draft: Draft) -> bool:
    """Whether the inertia depends on position: then common factors are cancelled first."""
    return any(depends_on(coefficient, name) for name in draft.study.system.coordinates)


def solved_for(draft: Draft, name: str, raw: t.Node, value: Scalar) -> t.Node:
    """unknown = form that keeps both sides of the equation (= the same with all that cancels taken out)."""
    return t.equation(t.Sym(name), *with_shorter(draft, raw, value))


def with_shorter(draft: Draft, raw: t.Node, value: Scalar) -> list[t.Node]:
    """The form, and the one that all cancelling leads to if it is much shorter or a quantity drops out."""
    shown = draft.show(value, factor=True)
    cancels = t.names(shown) < t.names(raw)
    return [raw, shown] if cancels or length(shown) <= MUCH_SHORTER * length(raw) else [raw]
