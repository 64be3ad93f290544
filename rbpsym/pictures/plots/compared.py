"""Two motions in one plot: a coordinate that both problems have, and its rate, from the same start with the same numbers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from rbpsym.claims.comparison import indexed
from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.pictures.moving import require_motion
from rbpsym.pictures.plots.following import leg
from rbpsym.pictures.plots.motion import Journey, PlottedMotion, legs
from rbpsym.pictures.plots.panel import Panel, PlotCurve
from rbpsym.pictures.plots.scales import Scales, scales
from rbpsym.pictures.plots.subjects import column, dimension_of, over_time
from rbpsym.proof.step import Derivation
from rbpsym.quantities import TIME


def motions(first: Derivation, second: Derivation) -> tuple[PlottedMotion, PlottedMotion]:
    """Both with the numbers of the first, as far as it has them, and for the same time. Raises NotApplicable."""
    for one in (first, second):
        require_motion(one.study)
    if first.phases or second.phases:
        raise NotApplicable("a motion in phases is not put beside another")
    found, own = (scales(one.study.problem) for one in (first, second))
    numbers = (found, Scales({**own.numbers, **found.numbers}, found.base))
    pairs = list(zip((first, second), numbers, strict=True))
    end = max(next(legs(one, scale)).moments[-1] for one, scale in pairs)
    one, other = (PlottedMotion(one, scale, Journey((leg(one, scale.numbers, end),))) for one, scale in pairs)
    return one, other


def beside(pair: tuple[PlottedMotion, PlottedMotion], name: str) -> Iterator[Panel]:
    """The coordinate over the time, and its rate, each with the number of the problem."""
    first = pair[0]
    length = dimension_of(first, name)
    ways = [one.real if one.loss else one.whole for one in pair]
    node, times, own = over_time(first, max(ways, key=lambda way: np.nanmax(way.times)))
    for suffix, dimension in (("", length), ("_dot", length / TIME)):
        scale = first.scales.of(dimension)
        letters = (t.Sym(indexed(name + suffix, first.derivation.study, k)) for k in (1, 2))
        columns = (column(way, name + suffix, scale) for way in ways)
        known = [np.interp(times, way.times / own.size, values, right=np.nan) for way, values in zip(ways, columns, strict=True)]
        yield Panel(node, times, tuple(map(PlotCurve, letters, known)), own, scale)
