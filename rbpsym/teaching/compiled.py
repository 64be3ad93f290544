"""Scalars made ready to be evaluated at many sets of numbers.

For drawing numbers and for keys as numbers; never for a verdict (see `equality`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from rbpsym.algebra.scalar import Scalar
from rbpsym.numeric import formulas


def compiled(values: Sequence[Scalar]) -> Callable[[Mapping[str, float]], list[float]]:
    """A function of numbers that gives all values; nan where one has none (a root of a negative number)."""
    evaluate = formulas.compiled(values)
    return lambda numbers: evaluate(numbers).tolist()
