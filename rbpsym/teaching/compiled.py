"""Scalars made ready to be evaluated at many sets of numbers.

For drawing numbers and for keys as numbers; never for a verdict (see `equality`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib.util import find_spec

from rbpsym.errors import NoNumber
from rbpsym.field import Scalar
from rbpsym.mechanics.numbers import number

Evaluate = Callable[[Mapping[str, float]], list[float]]


def compiled(values: Sequence[Scalar]) -> Evaluate:
    """A function of numbers that gives all values; nan where one has none (a root of a negative number)."""
    if find_spec("numpy") is None:
        return lambda numbers: list(_one_by_one(values, numbers))
    from rbpsym.numeric import formulas

    evaluate = formulas.compiled(values)
    return lambda numbers: evaluate(numbers).tolist()


def _one_by_one(values: Sequence[Scalar], numbers: Mapping[str, float]) -> Iterator[float]:
    """The same, slowly, where numpy is not installed (in a browser)."""
    for value in values:
        try:
            yield number(value, numbers)
        except NoNumber:
            yield math.nan
