"""What we ask of sympy: Gröbner bases, exchange of expressions, and what is asked of flint where that is not installed.

sympy and mpmath are imported here only, and only when one of these is needed.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from rbpsym.field import atoms
from rbpsym.field.poly import ONE, Coefficient, Poly
from rbpsym.field.scalar import Scalar


@lru_cache(maxsize=256)
def _ring(count: int) -> Any:
    from sympy.polys.domains import QQ
    from sympy.polys.orderings import lex
    from sympy.polys.rings import PolyRing

    return PolyRing([f"x{k}" for k in range(count)], QQ, lex)


def element(terms: dict[tuple[int, ...], Coefficient], count: int) -> Any:
    """An element of ℚ[x0, ...] from its coefficients by powers."""
    ring = _ring(count)
    return ring.from_dict({m: ring.domain(c.numerator, c.denominator) for m, c in terms.items()})


def cofactors(a: Any, b: Any) -> tuple[Any, Any] | None:
    """Both without their greatest common divisor; None if there is none."""
    common, *found = a.cofactors(b)
    return None if common.is_ground else tuple(found)


def factor_list(value: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """Coefficient and irreducible factors."""
    coefficient, found = value.factor_list()
    return coefficient, found


def enclosed(name: str, value: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """A function of a fraction by mpmath, in so many more digits than `bits` that its last ones are far within the radius."""
    import mpmath

    with mpmath.workprec(bits + 128 + 2 * value.denominator.bit_length()):
        found = getattr(mpmath, MPMATH.get(name, name))(mpmath.mpf(value.numerator) / value.denominator)
    ratio = Fraction(*map(int, mpmath.libmp.to_rational(found._mpf_)))
    return ratio, max(abs(ratio), Fraction(1)) / (1 << bits)


MPMATH = {"elliptic_k": "ellipk"}  # what it calls otherwise


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
    names, found = list(dict.fromkeys(names)), {}
    for name in names:
        plain = name
        while plain in _exported() or hasattr(builtins, plain) or (plain != name and plain in names):
            plain += "_"
        found[name] = plain
    return found


@lru_cache(maxsize=1)
def _exported() -> frozenset[str]:
    """What sympy exports, read in its source: to import it takes as long as to solve a problem."""
    found = find_spec("sympy")
    source = ast.parse(Path(found.origin).read_text(encoding="utf-8") if found and found.origin else "")
    listed = (node.value for node in source.body if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__")
    return frozenset(ast.literal_eval(next(listed)))


def _expression(poly: Poly) -> Any:
    import sympy

    return sympy.Add(
        *(sympy.Mul(sympy.Rational(c.numerator, c.denominator), *(_atom(i) ** e for i, e in m)) for m, c in poly.terms.items())
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
    return getattr(sympy, {"ln": "log"}.get(found.kind, found.kind))(to_sympy(found.arg))
