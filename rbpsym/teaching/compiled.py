"""Scalars made ready to be evaluated at many sets of numbers: each atom once, in floating point.

For drawing numbers and for keys as numbers; never for a verdict (see `equality`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, Poly
from rbpsym.algebra.scalar import Scalar
from rbpsym.mechanics.numbers import FUNCTIONS

Numbers = Mapping[str, float]
Values = dict[int, float]
_Sum = tuple[tuple[float, tuple[tuple[int, int], ...]], ...]
_Step = tuple[int, Callable[[Values], float]]


def compiled(values: Sequence[Scalar]) -> Callable[[Numbers], list[float]]:
    """A function of numbers that gives all values; nan where one has none (a root of a negative number)."""
    order: dict[int, Callable[[Values], float] | str] = {}
    for value in values:
        _collect(value, order)
    names = [(index, step) for index, step in order.items() if isinstance(step, str)]
    steps = [(index, step) for index, step in order.items() if not isinstance(step, str)]
    parts = [(_sum(value.num), None if value.den is ONE else _sum(value.den)) for value in values]

    def evaluate(numbers: Numbers) -> list[float]:
        known: Values = {index: numbers.get(name, math.nan) for index, name in names}
        known[atoms.PI] = math.pi
        for index, step in steps:
            known[index] = _tried(step, known)
        return [_tried(lambda known, top=top, low=low: _ratio(top, low, known), known) for top, low in parts]

    return evaluate


def _collect(value: Scalar | Poly, order: dict) -> None:
    for index in sorted(value.atoms()):
        if index in order or index == atoms.PI:
            continue
        found = atoms.atom(index)
        if found.kind == "symbol":
            order[index] = found.arg
        else:
            _collect(found.arg, order)
            order[index] = _function(found)


def _function(found: atoms.Atom) -> Callable[[Values], float]:
    arg = found.arg
    top, low = (
        (_sum(arg.num), None if arg.den is ONE else _sum(arg.den)) if isinstance(arg, Scalar) else (_sum(arg), None)
    )
    function = FUNCTIONS.get(found.kind)
    if function is None:
        return lambda known: math.nan
    return lambda known: function(_ratio(top, low, known))


def _sum(poly: Poly) -> _Sum:
    return tuple((float(c), m) for m, c in poly.terms.items())


def _total(terms: _Sum, known: Values) -> float:
    total = 0.0
    for coefficient, powers in terms:
        for index, exponent in powers:
            coefficient *= known[index] ** exponent
        total += coefficient
    return total


def _ratio(top: _Sum, low: _Sum | None, known: Values) -> float:
    return _total(top, known) if low is None else _total(top, known) / _total(low, known)


def _tried(step: Callable[[Values], float], known: Values) -> float:
    try:
        found = step(known)
    except (ArithmeticError, ValueError):
        return math.nan
    return found if isinstance(found, float) else math.nan
