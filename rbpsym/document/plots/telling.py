"""What a panel shows, in words: how each curve goes, for those who do not see it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from rbpsym.document.phrases import plain
from rbpsym.document.plots.panel import Curve, Mark, Panel
from rbpsym.document.plots.scales import Scale
from rbpsym.document.words import Words
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.text import plain_letters

FLAT = 1e-4  # of the height of a panel: less is no rise


def described(panel: Panel, notation: Notation, said: Words) -> str:
    """The axes with their units, each curve, and what happens where."""
    places = without_noise(panel.places[np.isfinite(panel.places)], np.nanmax(np.abs(panel.places)))
    begin, end = (amount(place, panel.across_scale, notation) for place in (places[0], places[-1]))
    up, across = unit_of(panel.up_scale, notation), name_of(panel.across, notation)
    variant = "degrees" if panel.up_scale.sign else "units" if up else "numbers"
    values = np.concatenate([curve.values for curve in panel.curves])
    whole = max(np.nanmax(values) - np.nanmin(values), np.nanmax(np.abs(values)))
    lines = [told_curve(curve, panel, whole, notation, said) for curve in panel.curves]
    lines += [told_mark(mark, panel.across_scale, notation, said) for mark in panel.marks if mark.name]
    slots = {"across": across, "begin": begin, "end": end, "unit": up, "curves": " ".join(lines)}
    return plain(f"plots.alt.{variant}", said.language, **slots)


def name_of(name: t.Node | str, notation: Notation) -> str:
    """A name or a formula in letters that are read out."""
    return name if isinstance(name, str) else plain_letters(name, notation)


def unit_of(scale: Scale, notation: Notation) -> str:
    """The unit of an axis, empty for pure numbers and degrees."""
    return "" if scale.sign or scale.node is None else name_of(scale.node, notation)


def amount(value: float, scale: Scale, notation: Notation) -> str:
    """A number with its unit."""
    unit = scale.sign or (f" {unit_of(scale, notation)}" if scale.node is not None else "")
    return number(value, notation) + unit


def number(value: float, notation: Notation) -> str:
    """Three figures, without a power of ten unless the number is tiny."""
    plain_text = f"{value:.3g}" if abs(value) < 1000 else f"{float(f'{value:.3g}'):.0f}"
    return plain_text.replace("-", "−").replace(".", notation.decimal)


def without_noise(values: np.ndarray, whole: float) -> np.ndarray:
    """The values, those that are nearly nothing as zero."""
    return np.where(np.abs(values) < FLAT * whole, 0.0, values)


def told_mark(mark: Mark, scale: Scale, notation: Notation, said: Words) -> str:
    """Where something happens, and what."""
    name = said.named(mark.name) if isinstance(mark.name, str) else name_of(mark.name, notation)
    return plain("plots.alt.mark", said.language, place=amount(mark.place, scale, notation), name=name)


def told_curve(curve: Curve, panel: Panel, whole: float, notation: Notation, said: Words) -> str:
    """Whether it stays, rises or falls, with a single turn on the way, or more of them."""
    is_known = np.isfinite(panel.places) & np.isfinite(curve.values)
    places, values = panel.places[is_known], without_noise(curve.values[is_known], whole)
    turn = np.argmax(np.abs(values - values[0]) + np.abs(values - values[-1]))
    told = {"first": values[0], "last": values[-1], "low": min(values), "high": max(values), "turn": values[turn]}
    sign = panel.up_scale.sign
    slots = {name: number(value, notation) + sign for name, value in told.items()}
    slots |= {"name": name_of(curve.name, notation), "place": amount(places[turn], panel.across_scale, notation)}
    return plain(f"plots.alt.curve.{course(values.tolist(), FLAT * whole)}", said.language, **slots)


def course(values: Sequence[float], small: float) -> str:
    """How values go, apart from what is small: "stays", "rises", "falls", "peak", "dip" or "varies".

    >>> [course(values, 0.1) for values in ([1, 1.05], [0, 1, 2], [0, 2, 1], [1, 0, 3], [0, 1, 0, 1])]
    ['stays', 'rises', 'peak', 'dip', 'varies']
    """
    if max(values) - min(values) <= small:
        return "stays"
    kept = [values[0]]
    for value in values:
        if abs(value - kept[-1]) > small:
            kept.append(value)
    ways = [after > before for before, after in pairwise(kept)]
    turns = [way for k, way in enumerate(ways) if k == 0 or way is not ways[k - 1]]
    return {(True,): "rises", (False,): "falls", (True, False): "peak", (False, True): "dip"}.get(
        tuple(turns), "varies"
    )
