"""Values in which a root has a letter s, the length of a spring: its pull as one product, k(1 - ℓ/s) times an arm."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.field.poly import generator
from rbpsym.field.scalar import Scalar
from rbpsym.present.forms import present
from rbpsym.present.style import Style


def by_pulls(value: Scalar, style: Style) -> t.Node:
    """a - a ℓ/s as a(1 - ℓ/s), and half a (s - ℓ)² as such, of each spring that is slack at ℓ, beside what is left."""
    rest, pulls = value, list[t.Node]()
    for index, letter, slack in style.called:
        s = Scalar(generator(index))
        powers = {n: Scalar(part) / Scalar(rest.den) for n, part in rest.num.by_power(index).items()}
        if slack and -1 in powers:
            arm, rest = -powers[-1] / slack, rest - powers[-1] / s + powers[-1] / slack
            pulls.append(_times(arm, t.add(t.ONE, t.neg(t.div(present(slack, style), t.Sym(letter)))), style))
        elif slack and 1 in powers and (half := -powers[1] / slack / 2) * (s - slack) ** 2 == value:
            return _times(half, t.Pow(t.add(t.Sym(letter), t.neg(present(slack, style))), t.TWO), style)
    return t.add(*pulls, *([present(rest, style, factor=True)] if rest or not pulls else []))


def _times(value: Scalar, factor: t.Node, style: Style) -> t.Node:
    node = present(value, style, factor=True)
    return t.neg(t.mul(node.arg, factor)) if isinstance(node, t.Neg) else t.mul(node, factor)
