"""The section of the notes that shows the formulas of a derivation as curves."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from rbpsym.derivation.step import Derivation
from rbpsym.document.model import FigureBlock, Inlines, Paragraph, Section, Text
from rbpsym.document.notes_figures import problem_notation
from rbpsym.document.phrases import plain
from rbpsym.document.plots.panel import Curve, Panel, scene
from rbpsym.document.plots.scales import Scale, told_numbers
from rbpsym.document.plots.subjects import Motion, energies, forces, motion, positions, speeds, works
from rbpsym.document.words import Words
from rbpsym.errors import NotApplicable
from rbpsym.notation import tree as t
from rbpsym.notation.glyphs import Notation
from rbpsym.notation.speech import to_speech

IN_A_ROW = 2


def plots_section(derivation: Derivation, said: Words, level: int) -> Section | None:
    """The curves of a derivation; None where the motion can't be followed in numbers."""
    try:
        moving = motion(derivation)
        figures = tuple(plot_figures(moving, said))
    except NotApplicable:
        return None
    if not figures:
        return None
    title, label = said.say("plots.title"), said.prefix + "section.plots"
    return Section(title, (Paragraph(numbers(moving, said)), *figures), label, level)


def plot_figures(moving: Motion, said: Words) -> Iterator[FigureBlock]:
    """Works, energies with speeds, forces with the motion in time."""
    worked = list(works(moving))
    if worked:
        yield figure("works", worked, said.say("plots.works" if len(worked) > 1 else "plots.works_one"), moving, said)
    stored, moved = list(energies(moving)), list(speeds(moving))
    if stored:
        yield figure("energies", stored + moved[: IN_A_ROW - 1], said.say("plots.energies"), moving, said)
    pushed, placed = list(forces(moving)), list(positions(moving, plain("plots.linear", said.language)))
    if pushed or placed:
        shown = (pushed + placed)[:IN_A_ROW]
        yield figure("forces", shown, caption_of_forces(moving, pushed, shown, said), moving, said)


def caption_of_forces(moving: Motion, pushed: Sequence[Panel], shown: Sequence[Panel], said: Words) -> Inlines:
    """What the forces and the motion in time show, and what their dashed lines mean."""
    key = "forces" if pushed and len(shown) > 1 else "forces_alone" if pushed else "positions"
    found = said.say(f"plots.{key}")
    if pushed and moving.loss:
        found += (Text(" "), *said.say("plots.lost", force=t.Sym(moving.loss[0])))
    if any(isinstance(curve.name, str) for panel in shown for curve in panel.curves):
        found += (Text(" "), *said.say("plots.small"))
    return found


def figure(name: str, panels: Sequence[Panel], caption: Inlines, moving: Motion, said: Words) -> FigureBlock:
    """Panels side by side."""
    notation = problem_notation(moving.derivation.study.problem)
    alt = " ".join(described(panel, notation, said) for panel in panels)
    scenes = tuple(scene(panel, notation) for panel in panels)
    return FigureBlock(scenes, caption, alt, f"{said.prefix}figure.{name}")


def numbers(moving: Motion, said: Words) -> Inlines:
    """With which numbers the curves are drawn."""
    problem = moving.derivation.study.problem
    told = list(told_numbers(problem, moving.scales, problem_notation(problem).decimal))
    if not moving.scales.base:
        return said.say("plots.numbers", numbers=told)
    base = [t.Sym(quantity.name) for quantity in moving.scales.base]
    return said.say("plots.unit_numbers", base=base, numbers=told) if told else said.say("plots.unit", base=base)


def described(panel: Panel, notation: Notation, said: Words) -> str:
    """What a panel shows, for those who do not see it."""
    curves = [line for curve in panel.curves if (line := told_curve(curve, panel.up_scale, notation, said))]
    across = to_speech(panel.across, notation)
    return plain("plots.alt", said.language, across=across, curves=" ".join(curves))


def told_curve(curve: Curve, scale: Scale, notation: Notation, said: Words) -> str:
    """Where a curve begins and ends, and its extremes."""
    known = [value for value in curve.values if math.isfinite(value)]
    if not known:
        return ""
    unit = scale.sign or (f" {to_speech(scale.node, notation)}" if scale.node is not None else "")
    values = {"first": known[0], "last": known[-1], "low": min(known), "high": max(known)}
    slots = {name: f"{value:.3g}{unit}".replace("-", "−") for name, value in values.items()}
    name = curve.name if isinstance(curve.name, str) else to_speech(curve.name, notation)
    return plain("plots.alt_curve", said.language, name=name, **slots)
