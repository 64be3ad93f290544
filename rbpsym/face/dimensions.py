"""The dimensions of symbols that nobody declared, from the slots in which they stand: what is a rod's length is a length.

Each slot says that a formula has a dimension, each sum that its terms have the same one, each sine that its argument has
none: linear equations for the exponents, which are solved as far as they go. What contradicts them is left out; the
statement tells it where it stands.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from fractions import Fraction
from typing import Any

from rbpsym.equality.dimensions import Unsettled, require_dimension
from rbpsym.errors import DimensionError
from rbpsym.face.late import sympy
from rbpsym.notation.tree import Node, names
from rbpsym.quantities import NUMBER, TIME, Dimension
from rbpsym.statement.slots import Slot


def inferred(slots: Iterable[tuple[Node, Slot]], known: Mapping[str, Dimension]) -> dict[str, Dimension]:
    """The dimensions that follow from formulas and their slots, by name.

    >>> from rbpsym.notation.tree import Mul, Num, Sym
    >>> str(inferred([(Mul((Num(2), Sym("ell"))), Slot())], {})["ell"])
    'length'
    """
    slots, agreeing = list(slots), list[Dimension]()
    used = {name.removesuffix("_dot") for node, slot in slots for name in (*names(node), slot.of)}
    unknown = used - known.keys() - {""}
    open_ = {name: Dimension(*(sympy.Symbol(f"{part}.{name}") for part in "MLT")) for name in unknown}
    rates = {f"{name}_dot": dimension / TIME for name, dimension in {**known, **open_}.items()}
    for node, slot in slots:
        scope = Unsettled({**rates, **known, **open_, **slot.variables}, agreeing)
        with suppress(DimensionError):
            require_dimension(node, scope, slot.dimension * scope.get(slot.of, NUMBER), "")
    solved: dict[Any, Any] = {}
    for exponent in (part for each in agreeing for part in _parts(each)):
        left = sympy.expand((sympy.Integer(0) + exponent).xreplace(solved))
        for first in sorted(left.free_symbols, key=str)[:1]:
            image = {first: sympy.expand(first - left / left.coeff(first))}
            solved = {name: sympy.expand(value.xreplace(image)) for name, value in solved.items()} | image
    found = {name: [part.xreplace(solved) for part in _parts(each)] for name, each in open_.items()}
    settled = {name: parts for name, parts in found.items() if all(part.is_Rational for part in parts)}
    return {name: Dimension(*(Fraction(part.p, part.q) for part in parts)) for name, parts in settled.items()}


def _parts(dimension: Dimension) -> tuple[Any, ...]:
    return dimension.mass, dimension.length, dimension.time
