"""How points are shared out among the lines of a rubric."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from rbpsym.notation import tree as t

HALF = Fraction(1, 2)


def shares(points: Fraction, weights: Sequence[int]) -> list[Fraction]:
    """Points in proportion to weights, in half points where they can be: the greatest remainders are rounded up.

    Every line earns something as long as there are enough halves; what is no multiple of a half is shared exactly.

    >>> [str(x) for x in shares(Fraction(4), [4, 5, 3])]
    ['3/2', '3/2', '1']
    """
    exact = [points * weight / sum(weights) for weight in weights]
    halves = points / HALF
    if halves.denominator != 1 or halves < len(weights):
        return exact
    found = [max(1, int(part / HALF)) for part in exact]
    while sum(found) != halves:
        step = 1 if sum(found) < halves else -1
        fitting = [k for k in range(len(found)) if step > 0 or found[k] > 1]
        place = max(fitting, key=lambda k: (step * (exact[k] / HALF - found[k]), -k))
        found[place] += step
    return [count * HALF for count in found]


def gist(statement: t.Node) -> list[t.Node]:
    """A statement row by row, each without what stands between its first and its last side."""
    rows = statement.rows if isinstance(statement, t.System) else (statement,)
    return [t.equation(row.items[0], row.items[-1]) if _is_equality(row) else row for row in rows]


def _is_equality(row: t.Node) -> bool:
    return isinstance(row, t.Chain) and set(row.ops) == {"="}
