"""Formulas as functions of numbers: all their sums of products at once, by numpy, at one set of numbers or at many.

What each formula needs is computed once: names, then the sines and roots of these, then those of what is known by then.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from itertools import groupby

import numpy as np

from rbpsym.field import ONE, Poly, Scalar, atoms, elliptic
from rbpsym.frozen import Frozen

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
    "elliptic_k": np.vectorize(elliptic.first),
    "elliptic_e": np.vectorize(elliptic.second),
}
CONSTANTS = {"pi": math.pi}


class Ratios(Frozen):
    """Quotients of sums of products: the rows and powers of all factors, where each product and each sum begins."""

    rows: np.ndarray
    powers: np.ndarray
    products: np.ndarray
    sums: np.ndarray
    coefficients: np.ndarray

    def at(self, known: np.ndarray) -> np.ndarray:
        """Their values where the rows of what is known are these."""
        if not len(self.sums):
            return known[:0]
        products = np.multiply.reduceat(known[self.rows] ** self.powers, self.products) * self.coefficients
        sums = np.add.reduceat(products, self.sums)
        return sums[::2] / sums[1::2]


def ratios(values: Iterable[Scalar | Poly], places: Mapping[int, int]) -> Ratios:
    """The table of some formulas; `places` are the rows of the atoms, and row 0 holds the number 1."""
    factors = list[tuple[int, int]]()
    products, coefficients, sums = list[int](), list[float](), list[int]()
    for value in values:
        for poly in (value.num, value.den) if isinstance(value, Scalar) else (value, ONE):
            sums.append(len(products))
            for monomial, coefficient in poly.terms.items() or (((), 0),):
                products.append(len(factors))
                coefficients.append(float(coefficient))
                factors += [(places[index], power) for index, power in monomial] or [(0, 1)]
    rows, powers = np.array(factors or [(0, 1)]).T
    firsts, exponents = [np.array(numbers, dtype=int) for numbers in (products, sums)], powers[:, None].astype(float)
    return Ratios(rows, exponents, firsts[0], firsts[1], np.array(coefficients, dtype=float)[:, None])


class Formulas(Frozen):
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


def compiled(values: Iterable[Scalar], defined: Mapping[str, Scalar] | None = None) -> Formulas:
    """The function of some formulas; a `defined` name stands for its formula.

    >>> from rbpsym.field.scalar import symbol
    >>> area = compiled([symbol("a") * symbol("b"), symbol("a") / symbol("b")])
    >>> area({"a": 3.0, "b": 2.0}).tolist()
    [6.0, 1.5]
    >>> area({"a": 3.0, "b": np.array([1.0, 0.0])})[1].tolist()
    [3.0, nan]
    """
    values, defined, depths = list(values), defined or {}, {}

    def inner(index: int) -> Scalar | Poly | None:
        """What an atom is a function of; None for a name or a label whose number is given."""
        found = atoms.atom(index)
        argument = defined.get(found.arg) if found.kind == "symbol" else found.arg
        return argument if isinstance(argument, Scalar | Poly) else None

    def depth(value: Scalar | Poly) -> int:
        """How many functions are within each other."""
        for index in value.atoms():
            if index not in depths:
                argument = inner(index)
                depths[index] = 0 if argument is None else 1 + depth(argument)
        return max(map(depths.__getitem__, value.atoms()), default=0)

    deepest = max(map(depth, values), default=0)
    given = [index for index, level in depths.items() if level == 0]
    places, levels = {index: row for row, index in enumerate(given, 1)}, []
    for level in range(1, deepest + 1):
        here = sorted((i for i, own in depths.items() if own == level), key=lambda i: atoms.atom(i).kind)
        kinds = tuple((kind, len(list(group))) for kind, group in groupby(atoms.atom(index).kind for index in here))
        levels.append((ratios([value for i in here if (value := inner(i)) is not None], places), kinds))
        places |= {index: row for row, index in enumerate(here, 1 + len(places))}
    names = tuple(atoms.symbol_name(index) or f"[{index}]" for index in given)
    return Formulas(names, tuple(levels), ratios(values, places))
