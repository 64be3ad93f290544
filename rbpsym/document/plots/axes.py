"""Axes: round numbers for ticks, and how they are written."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

TICKS = 4  # about as many steps on an axis
NEAR = 5e-3  # of a step: so little beyond the end a tick still stands
DEGREES = (5, 10, 15, 30, 45, 60, 90, 180, 360)


@dataclass(frozen=True, slots=True)
class Axis:
    """The range of an axis, its length in cm, its ticks and how each is written."""

    low: float
    high: float
    length: float
    ticks: tuple[float, ...]
    texts: tuple[str, ...]

    def at(self, value: float | np.ndarray) -> float | np.ndarray:
        """How far from its beginning a value is, in cm."""
        return self.length * (value - self.low) / (self.high - self.low)


def axis(values: Sequence[float], length: float, *, sign: str = "", decimal: str = ".", tight: bool = False) -> Axis:
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
