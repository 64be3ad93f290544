"""The frame of a panel: its ticks, and where the names of its curves stand."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from rbpsym.frozen import Frozen
from rbpsym.pictures.figures.scene import Box, Point, grown

TICKS = 4  # about as many steps on an axis
NEAR = 5e-3  # of a step: so little beyond the end a tick still stands
DEGREES = (5, 10, 15, 30, 45, 60, 90, 180, 360)


class Axis(Frozen):
    """The range of an axis, its length in cm, its ticks and how each is written."""

    low: float
    high: float
    length: float
    ticks: tuple[float, ...]
    texts: tuple[str, ...]

    def at(self, value: Any) -> Any:
        """How far from its beginning a value (or each of an array) is, in cm."""
        return self.length * (value - self.low) / (self.high - self.low)


def axis(values: Sequence[float] | np.ndarray, length: float, *, sign: str = "", decimal: str = ".", tight: bool = False) -> Axis:
    """The axis that holds all values; a `tight` one ends with them, else it ends at ticks or a little beyond."""
    known = np.asarray(values)[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 0.0)
    if high - low < 1e-9 * max(abs(high), abs(low), 1e-9):
        low, high = low - max(abs(low), 1.0) * 0.5, high + max(abs(high), 1.0) * 0.5
    if not tight:
        margin = 0.04 * (high - low)
        low, high = low - margin, high + margin
    step = step_of(low, high, degrees=sign == "°")
    first, last = math.ceil(low / step - NEAR), math.floor(high / step + NEAR)
    ticks = tuple(k * step for k in range(first, last + 1))
    places = max(0, -math.floor(math.log10(step) + 1e-9))
    return Axis(low, high, length, ticks, tuple(written(tick, places, decimal) + sign for tick in ticks))


def step_of(low: float, high: float, *, degrees: bool) -> float:
    """The round step with about TICKS ticks, with three of them if there can be."""
    steps = [round_step((high - low) / TICKS * share, degrees=degrees) for share in (1.0, 0.6, 0.4)]
    return next((s for s in steps if math.floor(high / s + NEAR) - math.ceil(low / s - NEAR) >= 2), steps[0])


def round_step(step: float, *, degrees: bool = False) -> float:
    """The next round number: 1, 2 or 5 times a power of ten, or a usual angle."""
    if degrees and step > 3:
        return float(min((d for d in DEGREES if d >= step * 0.9), default=360.0 * math.ceil(step / 360)))
    power = 10.0 ** math.floor(math.log10(step))
    return next(factor * power for factor in (1, 2, 5, 10) if factor * power >= step * 0.999)


def written(value: float, places: int, decimal: str) -> str:
    """A tick's number with a real minus sign and thin spaces between thousands."""
    text = f"{abs(value):,.{places}f}".replace(",", "\u2009").replace(".", decimal)
    return ("−" if round(value, places) < 0 else "") + text


# --- names of curves beside the curves: where nothing else is, and nearer to the own curve than to any other
# The panel is looked at as a sheet of small squares with and without ink; all places that are tried are asked at once,
# by how many squares with ink are left of and below each corner.


SQUARE = 0.04  # cm
CORNER = np.array([-3.0, -2.0])  # of the sheet, left and below
EXTENT = 350, 220  # squares
STRIDE = 0.16  # cm along a curve between the places that are tried
WANTED = 0.75  # of the way along a curve: where its name is liked most
AIR = 0.03
# cm between a curve and its name, and to all other curves: the most liked first
LIKED = ((0.07, 0.30), (0.07, 0.18), (0.18, 0.30), (0.07, 0.11), (0.32, 0.42), (0.18, 0.25))
SIDES = np.array([(a, b) for b in (1, -1, 0, 0.6, -0.6) for a in (0, 1, -1, 0.5, -0.5) if max(abs(a), abs(b)) == 1])


Pieces = Sequence[np.ndarray]  # of a curve: points as rows


def lengths(points: np.ndarray) -> np.ndarray:
    """The way from the first point of a broken line to each."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def walked(points: np.ndarray, stride: float) -> np.ndarray:
    """Points along a broken line at equal distances, and its ends."""
    gone = lengths(points)
    steps = np.linspace(0.0, gone[-1], 2 + int(gone[-1] / stride))
    return np.stack([np.interp(steps, gone, column) for column in points.T], axis=1)


def squares(points: np.ndarray) -> np.ndarray:
    """The column and row of points, as far as the sheet goes."""
    return np.asarray(np.clip(np.floor((points - CORNER) / SQUARE).astype(int), 0, np.array(EXTENT) - 1))


def inked(lines: Iterable[Sequence[Point] | np.ndarray], boxes: Iterable[Box] = ()) -> np.ndarray:
    """A sheet with some broken lines and full boxes."""
    sheet = np.zeros(EXTENT, dtype=bool)
    for line in lines:
        sheet[tuple(squares(walked(np.asarray(line), SQUARE / 2)).T)] = True
    for left, bottom, right, top in boxes:
        (first, low), (last, high) = squares(np.array([(left, bottom), (right, top)]))
        sheet[first : last + 1, low : high + 1] = True
    return sheet


def summed(sheet: np.ndarray) -> np.ndarray:
    """How many squares with ink are left of and below each corner."""
    return np.pad(sheet.cumsum(axis=0, dtype=np.int32).cumsum(axis=1), ((1, 0), (1, 0)))


def are_free(ink: np.ndarray, middles: np.ndarray, half: np.ndarray) -> np.ndarray:
    """At which middles there is no ink in a box of half that size."""
    (first, low), (last, high) = squares(middles - half).T, squares(middles + half).T + 1
    return np.asarray(ink[last, high] - ink[first, high] - ink[last, low] + ink[first, low] == 0)


def places(
    curves: Sequence[Pieces], sizes: Sequence[Point], taken: Iterable[Box], lines: Iterable[Sequence[Point]], within: Box
) -> list[Point | None]:
    """For each curve the middle of its name, which has a size; None where there is no room beside it."""
    sheets, others = [inked(pieces) for pieces in curves], inked(lines, taken)
    found: list[Point | None] = [None] * len(curves)
    for k in sorted(range(len(curves)), key=lambda k: sum(lengths(piece)[-1] for piece in curves[k])):
        rest = np.any([sheet for n, sheet in enumerate(sheets) if n != k] or [np.zeros(EXTENT, dtype=bool)], axis=0)
        found[k] = place = best(curves[k], sizes[k], sheets[k], rest, others, within)
        if place is not None:
            others |= inked((), [grown(around(place, sizes[k]), 0.02)])
    return found


def best(
    pieces: Pieces, size: Point, own: np.ndarray, rest: np.ndarray, others: np.ndarray, within: Box
) -> Point | None:
    """The most liked place that is free; among equals the one nearest to three quarters of the way."""
    if not pieces:
        return None
    points = np.concatenate([walked(piece, STRIDE) for piece in pieces])
    shares = np.repeat(np.linspace(0.0, 1.0, len(points)), len(SIDES))
    half, (own, rest, others) = np.array(size) / 2, map(summed, (own, rest, others))
    for gap, margin in LIKED:
        middles = (points[:, None] + SIDES * (half + gap)).reshape(-1, 2)
        is_fine = ((middles - half >= within[:2]) & (middles + half <= within[2:])).all(axis=1)
        for ink, air in ((others, AIR), (own, gap - 0.04), (rest, margin)):
            is_fine &= are_free(ink, middles, half + air)
        if is_fine.any():
            return tuple(middles[np.where(is_fine, np.abs(shares - WANTED), np.inf).argmin()].tolist())
    return None


def around(place: Point, size: tuple[float, float]) -> Box:
    """The box of a name about its middle."""
    return place[0] - size[0] / 2, place[1] - size[1] / 2, place[0] + size[0] / 2, place[1] + size[1] / 2
