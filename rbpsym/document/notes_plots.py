"""The section of the notes that shows the formulas of a derivation as curves."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from rbpsym.document.model import FigureBlock, Inlines, Paragraph, Section
from rbpsym.document.notes_checks import Told
from rbpsym.document.phrases import plain
from rbpsym.document.words import Words, sentences
from rbpsym.errors import NotApplicable
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.mechanics.events import pushes
from rbpsym.pictures.plots.following import PlottedMotion, motion
from rbpsym.pictures.plots.panel import Panel, PlotCurve, PlotMark, has_jump, scene
from rbpsym.pictures.plots.scales import Scale, told_numbers
from rbpsym.pictures.plots.subjects import changes, energies, forces, positions, speeds, works
from rbpsym.pictures.pose import REASONS
from rbpsym.proof.step import Derivation
from rbpsym.typeset.text import plain_letters

# --- what a panel shows, in words: how each curve goes, for those who do not see it


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


def told_mark(mark: PlotMark, scale: Scale, notation: Notation, said: Words) -> str:
    """Where something happens, and what."""
    name = said.named(mark.name) if isinstance(mark.name, str) else name_of(mark.name, notation)
    return plain("plots.alt.mark", said.language, place=amount(mark.place, scale, notation), name=name)


def told_curve(curve: PlotCurve, panel: Panel, whole: float, notation: Notation, said: Words) -> str:
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


# ---


IN_A_ROW = 3
Panels = Sequence[Panel]
Slots = dict[str, Any]
ALL = ("energies", "speeds", "forces", "positions")
FEW = ("forces", "energies", "positions")  # one row of panels, where not everything is shown


def plots_section(derivation: Derivation, said: Words, level: int, told: Iterable[Told] = ()) -> Section:
    """The curves of a derivation, of works, energies and forces those that the page has `told` of (all, if nothing is said of
    that); or a sentence that says why there are none."""
    title, label = said.say("plots.title"), said.prefix + "section.plots"
    try:
        moving = motion(derivation)
        figures = tuple(plot_figures(moving, said, ALL if said.is_full else FEW, names_told(told)))
    except NotApplicable as reason:
        return Section(title, (Paragraph(why_not(reason, said)),), label, level)
    return Section(title, (Paragraph(numbers(moving, said)), *figures), label, level)


def why_not(reason: NotApplicable, said: Words) -> Inlines:
    """Why nothing is drawn."""
    key = next((key for key, text in REASONS.items() if text == reason.what), "other")
    return said.say(f"plots.none.{key}")


def names_told(told: Iterable[Told]) -> frozenset[t.Node]:
    """The quantities of which the shown steps say what they are."""
    rows = (row for words, steps in told for step in steps if step.id in words.shown for row in t.rows(step.statement))
    return frozenset(row.items[0] for row in rows if isinstance(row, t.Chain))


def plot_figures(
    moving: PlottedMotion, said: Words, wanted: Sequence[str] = ALL, named: Collection[t.Node] = ()
) -> Iterator[FigureBlock]:
    """The works, force by force; then what is wanted, three panels in a figure; where some are `named`, of these quantities."""
    made = {"energies": energies(moving), "speeds": speeds(moving), "forces": forces(moving, named)}
    made["positions"] = positions(moving, plain("plots.linear", said.language))
    few, wanted = wanted is FEW, [name for name in wanted if name != "energies" or not named or t.Sym("K") in named]
    worked = [called(panel, said) for panel in works(moving, named)]
    if few and any(map(is_split, worked)):
        worked = [panel for panel in worked if is_split(panel) and len(panel.curves) <= IN_A_ROW][: IN_A_ROW - 1]
    several = len(worked) > 1 and not few
    groups: list[tuple[tuple[str, ...], list[Panel]]] = [(("works",), worked)] if several else []
    name = "works" if len(worked) > 1 else "works_one"
    rest = [(name, panel) for panel in worked if not several]
    rest += [(name, called(panel, said)) for name in wanted for panel in made[name] if not few or has_course(panel)]
    for start in range(0, min(1, len(rest)) if few else len(rest), IN_A_ROW):
        row = rest[start : start + IN_A_ROW]
        groups.append((tuple(dict.fromkeys(name for name, _ in row)), [panel for _, panel in row]))
    for number, (names, panels) in enumerate(groups):
        words = caption(moving, names, panels, said, is_first=number == 0)
        yield panels_figure(label_of(names, groups, number), panels, words, said)


def called(panel: Panel, said: Words) -> Panel:
    """A panel that says what it counts."""
    return replace(panel, kind=plain(f"plots.axis.{panel.kind}", said.language)) if panel.kind else panel


def has_course(panel: Panel) -> bool:
    """Does a curve rise or fall? One that stays shows no more than its formula."""
    sizes = ((np.nanmax(c.values) - np.nanmin(c.values), np.nanmax(np.abs(c.values))) for c in panel.curves)
    return any(height > FLAT * most for height, most in sizes)


def is_split(panel: Panel) -> bool:
    """Does it show the works of one force, along the path and in the rotation?"""
    return any(curve.style.startswith("curve sum") for curve in panel.curves)


def label_of(names: tuple[str, ...], groups: Sequence[tuple[tuple[str, ...], Panels]], number: int) -> str:
    """The name of a figure: that of its first panel, with a number if it is not the first of this name."""
    kind = names[0].partition("_")[0]
    before = sum(other[0].partition("_")[0] == kind for other, _ in groups[:number])
    return f"{kind}-{before + 1}" if before else kind


def caption(moving: PlottedMotion, names: tuple[str, ...], panels: Panels, said: Words, *, is_first: bool) -> Inlines:
    """What the panels of a figure show, and what their dashed lines and circles mean."""
    told = [said.say(f"plots.{name}") for name in names]
    return sentences([*told, *(said.say(f"plots.{key}", **slots) for key, slots in remarks(moving, names, panels, is_first))])


def remarks(moving: PlottedMotion, names: tuple[str, ...], panels: Panels, is_first: bool) -> Iterator[tuple[str, Slots]]:
    """What has to be said beside: keys of phrases and their slots."""
    all_curves = [curve for panel in panels for curve in panel.curves]
    if any(isinstance(curve.name, t.Delta) for curve in all_curves):
        yield "since_start", {}
    if omitted := sum(panel.omitted for panel in panels):
        yield "omitted", {"count": omitted}
    if "forces" in names and moving.loss:
        yield kind_of_loss(moving), {"force": t.Sym(moving.loss[1])}
    if any(curve.style == "curve thin" for curve in all_curves):
        yield "small", {}
    if is_first and changes(moving):
        yield "phases", {}
    if any(has_jump(panel) for panel in panels):
        yield "jumps", {}


def kind_of_loss(moving: PlottedMotion) -> str:
    """Whether a string goes slack, a contact is lost, or static friction gives way."""
    force = moving.loss[1] if moving.loss else ""
    constraints = moving.way.legs[-1].study.problem.constraints
    if any(element.values.get("friction") == force for element in constraints):
        return "slips"
    return next("slack" if element.kind == "string" else "lost" for element in constraints if force in pushes(element))


def panels_figure(name: str, panels: Sequence[Panel], caption: Inlines, said: Words) -> FigureBlock:
    """Panels side by side."""
    notation = said.notation
    alt = " ".join(described(panel, notation, said) for panel in panels)
    scenes = tuple(scene(panel, notation) for panel in panels)
    return FigureBlock(scenes, caption, alt, f"{said.prefix}figure.{name}")


def numbers(moving: PlottedMotion, said: Words) -> Inlines:
    """With which numbers the curves are drawn."""
    problem = moving.derivation.study.problem
    told = list(told_numbers(problem, moving.scales, said.notation.decimal))
    if not moving.scales.base:
        return said.say("plots.numbers", numbers=told)
    base = [t.Sym(quantity.name) for quantity in moving.scales.base]
    return said.say("plots.unit_numbers", base=base, numbers=told) if told else said.say("plots.unit", base=base)
