"""What we ask of sympy: greatest common divisors, factors, and exchange of expressions.

sympy is imported here only, and only when one of these is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, Coefficient, Monomial, Poly
from rbpsym.algebra.scalar import Scalar


@lru_cache(maxsize=256)
def _ring(count: int) -> Any:
    from sympy.polys.domains import QQ
    from sympy.polys.orderings import lex
    from sympy.polys.rings import PolyRing

    return PolyRing([f"x{k}" for k in range(count)], QQ, lex)


def to_element(poly: Poly, order: list[int]) -> Any:
    """The polynomial (no negative powers) as an element of ℚ[x0, x1, ...]."""
    ring = _ring(len(order))
    place = {index: k for k, index in enumerate(order)}
    convert = ring.domain.convert
    terms = {}
    for m, c in poly.terms.items():
        powers = [0] * len(order)
        for index, exponent in m:
            powers[place[index]] = exponent
        terms[tuple(powers)] = ring.domain(c.numerator, c.denominator) if type(c) is Fraction else convert(c)
    return ring.from_dict(terms)


def from_element(element: Any, order: list[int]) -> Poly:
    """Back from ℚ[x0, x1, ...]."""
    return Poly({_monomial(powers, order): _coefficient(c) for powers, c in element.terms()})


def _monomial(powers: tuple[int, ...], order: list[int]) -> Monomial:
    return tuple((index, e) for index, e in zip(order, powers, strict=True) if e)


def _coefficient(c: Any) -> Coefficient:
    return int(c.numerator) if c.denominator == 1 else Fraction(int(c.numerator), int(c.denominator))


def cofactors(a: Poly, b: Poly) -> tuple[Poly, Poly]:
    """a/g and b/g for the greatest common divisor g."""
    order = sorted(a.atoms() | b.atoms())
    x, y = to_element(a, order), to_element(b, order)
    _, p, q = x.cofactors(y)
    return from_element(p, order), from_element(q, order)


@lru_cache(maxsize=4096)
def factors(poly: Poly) -> tuple[Coefficient, tuple[tuple[Poly, int], ...]]:
    """Rational coefficient and irreducible factors over ℚ with multiplicities.

    Sines and cosines count as independent; negative powers must have been taken out.
    """
    order = sorted(poly.atoms())
    if not order:
        return poly.constant_value() or 0, ()
    coefficient, found = to_element(poly, order).factor_list()
    return _coefficient(coefficient), tuple((from_element(f, order), k) for f, k in found)


def groebner_basis(elements: list[Any]) -> tuple[Any, ...]:
    """A Gröbner basis of elements of one ring."""
    from sympy.polys.groebnertools import groebner

    return tuple(groebner(elements, elements[0].ring))


def to_sympy(value: Scalar) -> Any:
    """The scalar as a sympy expression; plain symbols are positive-free `Symbol(name)`."""
    num = _expression(value.num)
    return num if value.den is ONE else num / _expression(value.den)


def plain_names(names: Iterable[str]) -> dict[str, str]:
    """Each name with one that `sympify` reads as a symbol, and not as what sympy or Python call so (I, N, beta, len)."""
    import builtins

    import sympy

    names, found = list(dict.fromkeys(names)), {}
    for name in names:
        plain = name
        while hasattr(sympy, plain) or hasattr(builtins, plain) or (plain != name and plain in names):
            plain += "_"
        found[name] = plain
    return found


def lambdified(values: Sequence[Scalar], names: Sequence[str]) -> Callable[..., list[float]]:
    """A function of numbers, in the order of the names; common subexpressions are evaluated once."""
    import sympy

    letters = {sympy.Symbol(name): sympy.Symbol(f"x{k}") for k, name in enumerate(names)}  # no name runs as code
    found = [to_sympy(value).xreplace(letters) for value in values]
    return sympy.lambdify(list(letters.values()), found, modules="math", cse=True)


def _expression(poly: Poly) -> Any:
    import sympy

    return sympy.Add(
        *(
            sympy.Mul(sympy.Rational(c.numerator, c.denominator), *(_atom(i) ** e for i, e in m))
            for m, c in poly.terms.items()
        )
    )


@lru_cache(maxsize=4096)
def _atom(index: int) -> Any:
    import sympy

    found = atoms.atom(index)
    if index == atoms.PI:
        return sympy.pi
    if found.kind == "symbol":
        return sympy.Symbol(found.arg)
    if found.kind in ("cos", "sin"):
        return getattr(sympy, found.kind)(_expression(found.arg))
    if found.kind == "root":
        return sympy.sqrt(to_sympy(found.arg))
    if found.kind == "opaque":
        return sympy.Symbol(f"opaque_{index}")
    return getattr(sympy, {"ln": "log"}.get(found.kind, found.kind))(to_sympy(found.arg))
