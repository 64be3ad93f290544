"""Floating-point values of many scalars at one state, each sine and root computed once."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from functools import cached_property

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import derivative
from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.poly import ONE, Poly
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.notation.tree import Node

FUNCTIONS = {
    "cos": math.cos,
    "sin": math.sin,
    "root": math.sqrt,
    "exp": math.exp,
    "ln": math.log,
    "atan": math.atan,
    "asin": math.asin,
    "acos": math.acos,
}


class Numbers:
    """Values of scalars where the names have these numbers."""

    __slots__ = ("known", "names")

    def __init__(self, names: Mapping[str, float]) -> None:
        self.names, self.known = names, {atoms.PI: math.pi}

    def of(self, value: Scalar) -> float:
        """The value (KeyError for a name without a number)."""
        top = self._poly(value.num)
        return top if value.den is ONE else top / self._poly(value.den)

    def row(self, values: Iterable[Scalar]) -> list[float]:
        """Several values."""
        return [self.of(value) for value in values]

    def _poly(self, poly: Poly) -> float:
        total, known = 0.0, self.known
        for m, c in poly.terms.items():
            product = float(c)
            for index, exponent in m:
                base = known[index] if index in known else self._atom(index)
                product *= base if exponent == 1 else base**exponent
            total += product
        return total

    def _atom(self, index: int) -> float:
        found = atoms.atom(index)
        if found.kind == "symbol":
            value = self.names[found.arg]
        else:
            inner = self.of(found.arg) if isinstance(found.arg, Scalar) else self._poly(found.arg)
            value = FUNCTIONS[found.kind](inner)
        self.known[index] = value
        return value


class Stated:
    """An expression of the statement as a function of the coordinates and t, with two derivatives.

    `slopes` are ∂/∂q for every coordinate; `drift` is ∂/∂t; `bend` the part of d²/dt² without q̈.
    """

    def __init__(self, node: Node, coordinates: tuple[str, ...]) -> None:
        self.value, self.coordinates = scalar(node), coordinates

    @cached_property
    def slopes(self) -> tuple[Scalar, ...]:
        """∂/∂q by coordinate."""
        return tuple(derivative(self.value, name) for name in self.coordinates)

    @cached_property
    def drift(self) -> Scalar:
        """∂/∂t."""
        return derivative(self.value, "t")

    @cached_property
    def bend(self) -> Scalar:
        """Σ ∂²/∂q∂q' q̇ q̇' + 2 Σ ∂²/∂q∂t q̇ + ∂²/∂t²."""
        total = derivative(self.drift, "t")
        for name, slope in zip(self.coordinates, self.slopes, strict=True):
            total = total + derivative(slope, "t") * symbol(f"{name}_dot") * 2
            for other in self.coordinates:
                total = total + derivative(slope, other) * symbol(f"{name}_dot") * symbol(f"{other}_dot")
        return total
