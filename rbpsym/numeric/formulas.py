"""Formulas as functions of numbers: all their sums of products at once, by numpy, at one set of numbers or at many.

What each formula needs is computed once: names, then the sines and roots of these, then those of what is known by then.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from itertools import groupby

import numpy as np

from rbpsym.algebra import atoms
from rbpsym.algebra.poly import ONE, Poly
from rbpsym.algebra.scalar import Scalar

FUNCTIONS: Mapping[str, Callable[[np.ndarray], np.ndarray]] = {
    "symbol": np.positive,  # a name that is defined by a formula
    "cos": np.cos,
    "sin": np.sin,
    "root": np.sqrt,
    "exp": np.exp,
    "ln": np.log,
    "atan": np.arctan,
    "asin": np.arcsin,
    "acos": np.arccos,
}
CONSTANTS = {"pi": math.pi}


@dataclass(frozen=True)
class Ratios:
    """Quotients of sums of products: the rows and powers of all factors, where each product and each sum begins."""

    rows: np.ndarray
    powers: np.ndarray
    products: np.ndarray
    coefficients: np.ndarray
    sums: np.ndarray

    def at(self, known: np.ndarray) -> np.ndarray:
        """Their values where the rows of what is known are these."""
        if not len(self.sums):
            return known[:0]
        products = np.multiply.reduceat(known[self.rows] ** self.powers, self.products) * self.coefficients
        sums = np.add.reduceat(products, self.sums)
        return sums[::2] / sums[1::2]


def ratios(values: Iterable[Scalar | Poly], places: Mapping[int, int]) -> Ratios:
    """The table of some formulas; `places` are the rows of the atoms, and row 0 holds the number 1."""
    factors, products, coefficients, sums = [], [], [], []
    for value in values:
        for poly in (value.num, value.den) if isinstance(value, Scalar) else (value, ONE):
            sums.append(len(products))
            for monomial, coefficient in poly.terms.items() or (((), 0),):
                products.append(len(factors))
                coefficients.append(float(coefficient))
                factors += [(places[index], power) for index, power in monomial] or [(0, 1)]
    rows, powers = zip(*factors, strict=True) if factors else ((), ())
    whole = (np.array(numbers, dtype=int) for numbers in (rows, products, sums))
    columns = (np.array(numbers, dtype=float)[:, None] for numbers in (powers, coefficients))
    (rows, products, sums), (powers, coefficients) = whole, columns
    return Ratios(rows, powers, products, coefficients, sums)


@dataclass(frozen=True)
class Formulas:
    """A function from numbers by name to an array of values.

    Numbers may be arrays of one length; then each value is one. A value is nan where there is none: the root of
    less than nothing, a division by zero, a name without a number.
    """

    names: tuple[str, ...]
    levels: tuple[tuple[Ratios, tuple[tuple[str, int], ...]], ...]
    results: Ratios

    def __call__(self, numbers: Mapping[str, float | np.ndarray]) -> np.ndarray:
        given = [numbers.get(name, CONSTANTS.get(name, math.nan)) for name in self.names]
        shape = next((value.shape for value in given if isinstance(value, np.ndarray) and value.ndim), ())
        known = np.ones((1 + len(given), *(shape or (1,))))
        for row, value in enumerate(given, 1):
            known[row] = value
        with np.errstate(all="ignore"):
            for table, functions in self.levels:
                found, begin = table.at(known), 0
                for kind, count in functions:
                    part = found[begin : begin + count]
                    part[:] = FUNCTIONS[kind](part) if kind in FUNCTIONS else math.nan
                    begin += count
                known = np.concatenate([known, found])
            found = self.results.at(known)
        found[~np.isfinite(found)] = math.nan
        return found.reshape(-1, *shape)


@dataclass(frozen=True)
class Order:
    """The atoms of formulas by how many functions are within each other."""

    defined: Mapping[str, Scalar]
    depths: dict[int, int] = field(default_factory=dict)

    def inner(self, index: int) -> Scalar | Poly | None:
        """What an atom is a function of; None for a name whose number is given."""
        found = atoms.atom(index)
        return self.defined.get(found.arg) if found.kind == "symbol" else found.arg

    def depth(self, value: Scalar | Poly) -> int:
        """How deep a formula goes."""
        polys = (value.num, value.den) if isinstance(value, Scalar) else (value,)
        return max((self._of(index) for poly in polys for index in poly.atoms()), default=0)

    def _of(self, index: int) -> int:
        if index not in self.depths:
            inner = self.inner(index)
            self.depths[index] = 1 + self.depth(inner) if isinstance(inner, Scalar | Poly) else 0
        return self.depths[index]


def compiled(values: Iterable[Scalar], defined: Mapping[str, Scalar] | None = None) -> Formulas:
    """The function of some formulas; a `defined` name stands for its formula.

    >>> from rbpsym.algebra.scalar import symbol
    >>> area = compiled([symbol("a") * symbol("b"), symbol("a") / symbol("b")])
    >>> area({"a": 3.0, "b": 2.0}).tolist()
    [6.0, 1.5]
    >>> area({"a": 3.0, "b": np.array([1.0, 0.0])})[1].tolist()
    [3.0, nan]
    """
    values, order = list(values), Order(defined or {})
    deepest = max(map(order.depth, values), default=0)
    given = [index for index, depth in order.depths.items() if depth == 0]
    places = {index: row for row, index in enumerate(given, 1)}
    levels = []
    for level in range(1, deepest + 1):
        here = sorted((i for i, depth in order.depths.items() if depth == level), key=lambda i: atoms.atom(i).kind)
        kinds = tuple((kind, len(list(group))) for kind, group in groupby(here, key=lambda i: atoms.atom(i).kind))
        levels.append((ratios(map(order.inner, here), places), kinds))
        places |= {index: row for row, index in enumerate(here, 1 + len(places))}
    return Formulas(tuple(map(_name, given)), tuple(levels), ratios(values, places))


def _name(index: int) -> str:
    """The name under which the number of an atom is given; no name of the language for one that has none."""
    return atoms.symbol_name(index) or f"[{index}]"
