"""The form of a value that is told, what is a square taken out of its roots, and the sense that numbers give to what has both."""

from __future__ import annotations

import math

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import inside
from rbpsym.algebra.normal import is_rooted
from rbpsym.algebra.poly import Poly, generator, inverse
from rbpsym.algebra.present import present
from rbpsym.algebra.ring import factors
from rbpsym.algebra.roots import simplified_root, tidied, with_image
from rbpsym.algebra.scalar import UNITY, Scalar
from rbpsym.derivation.draft import length
from rbpsym.equality.assumptions import Assumptions
from rbpsym.equality.rooted import rooted
from rbpsym.equality.signs import sign
from rbpsym.errors import NoNumber
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.numbers import number, sample
from rbpsym.mechanics.study import Study
from rbpsym.quantity.path import SENSES, even


def shortest(value: Scalar, study: Study) -> Scalar:
    """The value in the shortest of its forms: as it is, with short roots, as one root."""
    if not is_rooted(value.num) and not is_rooted(value.den):
        return value
    given, square = study.assumptions, short(even(value * value))
    forms, way = [value, neat(value, given)], SENSES.get(sign(value, given).kind)
    if way and not is_rooted(square.num) and not is_rooted(square.den):
        forms.append(simplified_root(square, lambda name: given.sign_of(name) == "positive") * way)
    return min(forms, key=lambda form: length(present(form, study.style, factor=True)))


def sense_at_sample(study: Study, push: Scalar) -> int:
    """1 or -1, the sense of a push at the sample numbers; 0 where it has none there."""
    try:
        return int(math.copysign(1, found)) if (found := number(push, sample(study.problem))) else 0
    except NoNumber:
        return 0


def neat(value: Scalar, given: Assumptions) -> Scalar:
    """The same value with short roots: squares are taken out of them, of a product of roots too."""

    def is_positive(name: str) -> bool:
        return given.sign_of(name) == "positive"

    value = rooted(short(even(inside(value, lambda part: neat(part, given)))), given)
    if value.num.is_monomial():
        value = _joined(value, is_positive)
    for index in sorted(value.atoms()):
        found = atoms.atom(index)
        outer = _outer(found.arg, given) if found.kind == "root" and isinstance(found.arg, Scalar) else UNITY
        if outer != UNITY:
            image = outer * simplified_root(short(found.arg / outer**2), is_positive)
            value = with_image(value.num, index, image) / with_image(value.den, index, image)
    return tidied(value, is_positive, lambda total: False)


def _outer(radicand: Scalar, given: Assumptions) -> Scalar:
    """What is taken out of the root: the factors whose squares stand in it, with the signs that make them positive."""
    found = UNITY
    for poly, power in ((radicand.num, 1), (radicand.den, -1)):
        low = tuple((i, e) for i, e in poly.content()[1] if e < 0)
        for factor, count in (*factors(poly.scaled(1, inverse(low)))[1], *((generator(i), e) for i, e in low)):
            way = SENSES.get(sign(Scalar(factor), given).kind) if abs(count) > 1 else None
            found = found * (Scalar(factor) * way) ** (power * int(count / 2)) if way else found
    return found


def _joined(value: Scalar, is_positive) -> Scalar:
    """A product of roots as that of the whole, with what is a square in front."""
    [(m, c)] = value.num.terms.items()
    roots = [(index, exponent) for index, exponent in m if atoms.atom(index).kind == "root"]
    if len(roots) < 2 and all(exponent > 0 for _, exponent in roots):
        return value
    radicand = UNITY
    for index, exponent in roots:
        radicand = radicand * atoms.atom(index).arg ** exponent
    rest = Scalar(Poly({tuple(item for item in m if item not in roots): c}), value.den)
    return simplified_root(short(radicand), is_positive) * rest
