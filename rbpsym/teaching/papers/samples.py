"""Values of formulas at some points, for pages that compare typed formulas without holding the key."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from rbpsym.algebra.evaluate import scalar
from rbpsym.errors import RbpsymError
from rbpsym.notation.tree import Node
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.draws import Draws


def sample_points(names: Sequence[str], count: int) -> list[dict[str, float]]:
    """Points at which all names have generic values between 0.3 and 1.4 (so that angles are acute)."""
    draws = Draws(b"points", ",".join(names))
    return [{name: round(0.3 + 1.1 * draws.below(100_000) / 100_000, 5) for name in names} for _ in range(count)]


def sampled(node: Node, points: Sequence[Mapping[str, float]]) -> list[float] | None:
    """The values of a formula at the points; None if it has none there."""
    try:
        evaluate = compiled([scalar(node)])
    except (RbpsymError, ZeroDivisionError):
        return None
    values = [evaluate(point)[0] for point in points]
    return values if all(map(math.isfinite, values)) else None
