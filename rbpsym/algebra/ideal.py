"""Zero test on a variety: does a polynomial vanish wherever given polynomials vanish?

Used where coordinates stay tied to each other by conditions that have no explicit solution.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

from rbpsym.algebra import atoms, sympy_bridge
from rbpsym.algebra.normal import Bases, bases_of, in_bases, partner
from rbpsym.algebra.poly import ONE, Poly, generator, inverse
from rbpsym.algebra.ring import element
from rbpsym.algebra.scalar import Scalar

MOST_TERMS = 400


def vanishes_on(value: Scalar, relations: Iterable[Scalar]) -> bool:
    """Whether the numerator lies in the ideal of the relations' numerators (True is a proof)."""
    relations = tuple(r.num for r in relations)
    bases = bases_of(value.num, *relations)
    target = _ordinary(in_bases(value.num, bases))
    if len(target) > MOST_TERMS:
        return False
    basis, order = _basis(relations, bases, tuple(sorted(target.atoms())))
    return not element(target, order, sympy_bridge).rem(list(basis))


@lru_cache(maxsize=64)
def _basis(relations: tuple[Poly, ...], bases: Bases, more: tuple[int, ...]):
    """A Gröbner basis of the relations and of sin² + cos² = 1, with the order of its atoms."""
    ideal = [_ordinary(in_bases(relation, bases)) for relation in relations]
    used = sorted(set(more).union(*(p.atoms() for p in ideal)))
    circles = [i for i in used if atoms.atom(i).kind in ("cos", "sin")]
    for index in circles:
        other = partner(index)
        used = sorted({*used, other})
        ideal.append(generator(index) * generator(index) + generator(other) * generator(other) - ONE)
    elements = [element(p, used, sympy_bridge) for p in dict.fromkeys(ideal)]
    return sympy_bridge.groebner_basis(elements), tuple(used)


def _ordinary(poly: Poly) -> Poly:
    """Negative powers multiplied away."""
    low = tuple((i, min(0, *(dict(m).get(i, 0) for m in poly.terms))) for i in sorted(poly.atoms()))
    return poly.scaled(1, inverse(tuple(item for item in low if item[1])))
