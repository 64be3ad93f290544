"""Names of curves beside the curves: where nothing else is, and nearer to the own curve than to any other.

The panel is looked at as a sheet of small squares: each row of it is a number whose bits say where ink is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from rbpsym.document.figures.placing import Box, grown
from rbpsym.document.figures.scene import Point

SQUARE = 0.04  # cm
LEFT, BELOW = -3.0, -2.0  # the corner of the sheet
STRIDE = 0.16  # cm along a curve between the places that are tried
# cm between a curve and its name, and to all other curves: the most liked first
LIKED = ((0.07, 0.30), (0.07, 0.18), (0.18, 0.30), (0.07, 0.11), (0.32, 0.42), (0.18, 0.25))


@dataclass(frozen=True)
class Sheet:
    """Rows of squares with ink."""

    rows: dict[int, int] = field(default_factory=dict)

    def ink(self, points: Sequence[Point]) -> None:
        """A broken line."""
        for (x, y), (u, v) in pairwise(points):
            count = max(1, math.ceil(max(abs(u - x), abs(v - y)) / SQUARE))
            for k in range(count + 1):
                self.dot(x + (u - x) * k / count, y + (v - y) * k / count)

    def dot(self, x: float, y: float) -> None:
        """One square."""
        row = row_of(y)
        self.rows[row] = self.rows.get(row, 0) | 1 << column_of(x)

    def fill(self, box: Box) -> None:
        """All squares of a box."""
        first, last, bits = span(box)
        for row in range(first, last + 1):
            self.rows[row] = self.rows.get(row, 0) | bits

    def is_free(self, box: Box) -> bool:
        """Is there no ink in a box?"""
        first, last, bits = span(box)
        return not any(self.rows.get(row, 0) & bits for row in range(first, last + 1))


def row_of(y: float) -> int:
    """The row of a height."""
    return math.floor((y - BELOW) / SQUARE)


def column_of(x: float) -> int:
    """The column of a place; none is left of the sheet."""
    return max(0, math.floor((x - LEFT) / SQUARE))


def span(box: Box) -> tuple[int, int, int]:
    """First and last row of a box, and the bits of its columns."""
    first, last = column_of(box[0]), column_of(box[2])
    return row_of(box[1]), row_of(box[3]), ((1 << last - first + 1) - 1) << first


@dataclass(frozen=True)
class Named:
    """A curve in pieces, and the size of its name."""

    pieces: tuple[tuple[Point, ...], ...]
    size: tuple[float, float]


def places(
    curves: Sequence[Named], taken: Iterable[Box], lines: Iterable[Sequence[Point]], within: Box
) -> list[Point | None]:
    """For each curve the middle of its name; None where there is no room beside it."""
    sheets = [Sheet() for _ in curves]
    for sheet, curve in zip(sheets, curves, strict=True):
        for piece in curve.pieces:
            sheet.ink(piece)
    others = Sheet()
    for box in taken:
        others.fill(box)
    for line in lines:
        others.ink(line)
    found: dict[int, Point] = {}
    for k in sorted(range(len(curves)), key=lambda k: length(curves[k])):
        rest = [sheet for n, sheet in enumerate(sheets) if n != k]
        place = best(curves[k], sheets[k], rest, others, within)
        if place is not None:
            found[k] = place
            others.fill(grown(around(place, curves[k].size), 0.02))
    return [found.get(k) for k in range(len(curves))]


def best(curve: Named, own: Sheet, rest: list[Sheet], others: Sheet, within: Box) -> Point | None:
    """The most liked place that is free; among equals the one nearest to three quarters of the way."""
    for gap, margin in LIKED:
        spots = sorted(candidates(curve, gap), key=lambda spot: abs(spot[0] - 0.75))
        for _, place in spots:
            box = around(place, curve.size)
            if inside(box, within) and others.is_free(grown(box, 0.03)) and own.is_free(grown(box, gap - 0.04)):
                wide = grown(box, margin)
                if all(sheet.is_free(wide) for sheet in rest):
                    return place
    return None


def candidates(curve: Named, gap: float) -> Iterator[tuple[float, Point]]:
    """Places above, below and beside points of a curve, with the share of its length."""
    wide, high = (size / 2 + gap for size in curve.size)
    for share, (x, y) in walked(curve):
        for across, up in SIDES:
            yield share, (x + across * wide, y + up * high)


SIDES = tuple((a, b) for b in (1, -1, 0, 0.6, -0.6) for a in (0, 1, -1, 0.5, -0.5) if max(abs(a), abs(b)) == 1)


def walked(curve: Named) -> Iterator[tuple[float, Point]]:
    """Points along a curve at equal distances, and its ends, with the share of the way."""
    whole, gone, due = length(curve) or 1.0, 0.0, STRIDE / 2
    for piece in curve.pieces:
        yield gone / whole, piece[0]
        for (x, y), (u, v) in pairwise(piece):
            size = math.hypot(u - x, v - y)
            while size and due <= gone + size:
                part = (due - gone) / size
                yield due / whole, (x + part * (u - x), y + part * (v - y))
                due += STRIDE
            gone += size
        yield gone / whole, piece[-1]


def length(curve: Named) -> float:
    """How long a curve is, in cm."""
    return sum(math.dist(a, b) for piece in curve.pieces for a, b in pairwise(piece))


def around(place: Point, size: tuple[float, float]) -> Box:
    """The box of a name about its middle."""
    return place[0] - size[0] / 2, place[1] - size[1] / 2, place[0] + size[0] / 2, place[1] + size[1] / 2


def inside(box: Box, within: Box) -> bool:
    """Does a box lie in another?"""
    return within[0] <= box[0] and within[1] <= box[1] and box[2] <= within[2] and box[3] <= within[3]
