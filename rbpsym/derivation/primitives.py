"""Antiderivatives as checkers take them: whoever proposes one, it is differentiated before it is believed."""

from __future__ import annotations

from rbpsym.algebra import Scalar, derivative, is_zero
from rbpsym.algebra.integration import antiderivative
from rbpsym.errors import Undecided


def primitive(value: Scalar, name: str) -> Scalar:
    """An antiderivative with respect to a symbol. Raises Undecided where none is known, or its derivative is another."""
    found = antiderivative(value, name)
    if found is None:
        raise Undecided("no closed form of the integral was found")
    if not is_zero(derivative(found, name) - value):
        raise Undecided("the derivative of what is proposed as the integral is another function")
    return found
