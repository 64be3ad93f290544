"""Values in a neat form: what is a square is taken out of roots, of a product of roots too."""

from __future__ import annotations

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import inside
from rbpsym.algebra.poly import Poly, generator, inverse
from rbpsym.algebra.ring import factors
from rbpsym.algebra.roots import simplified_root, tidied, with_image, without_even_roots
from rbpsym.algebra.scalar import UNITY, Scalar
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.rooted import rooted
from rbpsym.equality.signs import sign
from rbpsym.mechanics.demands import WAYS
from rbpsym.mechanics.elimination import short


def neat(value: Scalar, given: Assumptions) -> Scalar:
    """The same value with short roots."""
    value = _signed(_joined(rooted(_even(value), given), given), given)
    return tidied(value, lambda name: given.sign_of(name) == "positive", lambda total: False)


def _even(value: Scalar) -> Scalar:
    return short(without_even_roots(inside(value, _even)))


def _signed(value: Scalar, given: Assumptions) -> Scalar:
    """√(f² g) as f √g or -f √g, where the sign of the factor f is decided."""
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        outer = _outer(found.arg, given) if found.kind == "root" and isinstance(found.arg, Scalar) else UNITY
        if outer != UNITY:
            inner = simplified_root(short(found.arg / outer**2), lambda name: given.sign_of(name) == "positive")
            value = with_image(value.num, index, outer * inner) / with_image(value.den, index, outer * inner)
    return value


def _outer(radicand: Scalar, given: Assumptions) -> Scalar:
    """What is taken out of the root: the factors whose squares stand in it, with the signs that make them positive."""
    found = UNITY
    for poly, power in ((radicand.num, 1), (radicand.den, -1)):
        low = tuple((i, e) for i, e in poly.content()[1] if e < 0)
        for factor, count in (*factors(poly.scaled(1, inverse(low)))[1], *((generator(i), e) for i, e in low)):
            way = WAYS.get(sign(Scalar(factor), given).kind) if abs(count) > 1 else None
            found = found * (Scalar(factor) * way) ** (power * int(count / 2)) if way else found
    return found


def _joined(value: Scalar, given: Assumptions) -> Scalar:
    """A product of roots as that of the whole, with what is a square in front."""
    if not value.num.is_monomial():
        return value
    [(m, c)] = value.num.terms.items()
    roots = [(index, exponent) for index, exponent in m if atoms.atom(index).kind == "root"]
    if len(roots) < 2 and all(exponent > 0 for _, exponent in roots):
        return value
    radicand = UNITY
    for index, exponent in roots:
        radicand = radicand * atoms.atom(index).arg ** exponent
    rest = Scalar(Poly({tuple(item for item in m if item not in roots): c}), value.den)
    outer = simplified_root(short(radicand), lambda name: given.sign_of(name) == "positive")
    return outer * rest
