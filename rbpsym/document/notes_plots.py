"""The section of the notes that shows the formulas of a derivation as curves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rbpsym.derivation.step import Derivation
from rbpsym.document.model import FigureBlock, Inlines, Paragraph, Section, Text
from rbpsym.document.phrases import plain
from rbpsym.document.plots.following import REASONS
from rbpsym.document.plots.motion import Motion, motion
from rbpsym.document.plots.panel import Panel, has_jump, scene
from rbpsym.document.plots.scales import told_numbers
from rbpsym.document.plots.subjects import energies, forces, positions, speeds, works
from rbpsym.document.plots.telling import described
from rbpsym.document.words import Words
from rbpsym.errors import NotApplicable
from rbpsym.notation import tree as t

IN_A_ROW = 2
Panels = list[Panel]


def plots_section(derivation: Derivation, said: Words, level: int) -> Section:
    """The curves of a derivation, or a sentence that says why there are none."""
    title, label = said.say("plots.title"), said.prefix + "section.plots"
    try:
        moving = motion(derivation)
        figures = tuple(plot_figures(moving, said))
    except NotApplicable as reason:
        return Section(title, (Paragraph(why_not(reason, said)),), label, level)
    return Section(title, (Paragraph(numbers(moving, said)), *figures), label, level)


def why_not(reason: NotApplicable, said: Words) -> Inlines:
    """Why nothing is drawn."""
    key = next((key for key, text in REASONS.items() if text == reason.what), "other")
    return said.say(f"plots.none.{key}")


def plot_figures(moving: Motion, said: Words) -> Iterator[FigureBlock]:
    """Works, energies with speeds, forces with the motion in time; two panels in a figure."""
    worked = list(works(moving))
    groups = [("works" if len(worked) > 1 else "works_one", worked)] if worked else []
    groups += shared(("energies", list(energies(moving))), ("speeds", list(speeds(moving))))
    placed = list(positions(moving, plain("plots.linear", said.language)))
    groups += shared(("forces", list(forces(moving))), ("positions", placed))
    for number, (name, panels) in enumerate(groups):
        words = caption(moving, name, panels, said, is_first=number == 0)
        yield figure(label_of(name, groups, number), panels, words, moving, said)


def label_of(name: str, groups: Sequence[tuple[str, Panels]], number: int) -> str:
    """The name of a figure: that of its first panel, with a number if it is not the first of this name."""
    kind = name.partition("_")[0]
    before = sum(other.partition("_")[0] == kind for other, _ in groups[:number])
    return f"{kind}-{before + 1}" if before else kind


def shared(one: tuple[str, Panels], other: tuple[str, Panels]) -> Iterator[tuple[str, Panels]]:
    """Two kinds of panels in one figure, where there is one of each; else in figures of their own."""
    if len(one[1]) == len(other[1]) == 1:
        yield f"{one[0]}_{other[0]}", one[1] + other[1]
        return
    for name, panels in (one, other):
        for start in range(0, len(panels), IN_A_ROW):
            yield name, panels[start : start + IN_A_ROW]


def caption(moving: Motion, name: str, panels: Panels, said: Words, *, is_first: bool) -> Inlines:
    """What the panels of a figure show, and what their dashed lines and circles mean."""
    found = said.say(f"plots.{name}")
    for key, slots in remarks(moving, name, panels, is_first):
        found += (Text(" "), *said.say(f"plots.{key}", **slots))
    return found


def remarks(moving: Motion, name: str, panels: Panels, is_first: bool) -> Iterator[tuple[str, dict]]:
    """What has to be said beside: keys of phrases and their slots."""
    all_curves = [curve for panel in panels for curve in panel.curves]
    if any(isinstance(curve.name, t.Delta) for curve in all_curves):
        yield "since_start", {}
    if omitted := sum(panel.omitted for panel in panels):
        yield "omitted", {"count": omitted}
    if "forces" in name and moving.loss:
        yield kind_of_loss(moving), {"force": t.Sym(moving.loss[1])}
    if any(curve.style == "curve thin" for curve in all_curves):
        yield "small", {}
    if is_first and len(moving.whole.legs) > 1:
        yield "phases", {}
    if any(has_jump(panel) for panel in panels):
        yield "jumps", {}


def kind_of_loss(moving: Motion) -> str:
    """Whether a string goes slack or a contact is lost."""
    element = moving.way.legs[-1].study.system.element(moving.loss[1])
    return "slack" if element.kind == "string" else "lost"


def figure(name: str, panels: Sequence[Panel], caption: Inlines, moving: Motion, said: Words) -> FigureBlock:
    """Panels side by side."""
    notation = said.notation
    alt = " ".join(described(panel, notation, said) for panel in panels)
    scenes = tuple(scene(panel, notation) for panel in panels)
    return FigureBlock(scenes, caption, alt, f"{said.prefix}figure.{name}")


def numbers(moving: Motion, said: Words) -> Inlines:
    """With which numbers the curves are drawn."""
    problem = moving.derivation.study.problem
    told = list(told_numbers(problem, moving.scales, said.notation.decimal))
    if not moving.scales.base:
        return said.say("plots.numbers", numbers=told)
    base = [t.Sym(quantity.name) for quantity in moving.scales.base]
    return said.say("plots.unit_numbers", base=base, numbers=told) if told else said.say("plots.unit", base=base)
