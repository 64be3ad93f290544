"""Signs and arrows: the free-body diagram, the signs of W_T and W_θ of each force over the motion, and what cancels."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from rbpsym.document.model import Block, FigureBlock, Inlines, Math, Paragraph, Table
from rbpsym.document.words import Words
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.motion import Work
from rbpsym.pictures.figures.schematic import free_body
from rbpsym.pictures.sketches import sketch_of
from rbpsym.proof.step import BodyRef
from rbpsym.quantities import ENERGY
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench, given_as
from rbpsym.teaching.model import AskedQuantity, Item, SignRow, SignsKey
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.spoilers import Content, claims, unsigned
from rbpsym.teaching.targets import force_symbol
from rbpsym.teaching.tasks.wish import Wish
from rbpsym.teaching.wording import spoken

HALVES = ("translational", "rotational")
MOST_POINTS = 6  # of a table with many rows, which is no more work than to derive a formula
SMALL = 1e-6  # of the largest work: too small for a sign that one can see


class ForceRow(Frozen):
    """A force on a body, and the group of forces with which its works cancel."""

    force: str
    on: str
    symbol: t.Node
    cancels: str


def prepare(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item for all forces, if their works are known along the motion."""
    rows, values = tuple(_rows(bench)), [half.value if half.parts else NOTHING for half in _halves(bench)]
    known = set(scenery.ranges) | {scenery.coordinate or ""}
    told = [value for value in values if value is not None and names_in(value) <= known]
    if scenery.coordinate is None or len(told) < len(values) or not rows:
        if wish.at is not None:
            raise wish.error(
                f"the works of all forces are not known along the motion of “{bench.name}”",
                "take a problem that starts somewhere and has one coordinate that moves.",
            )
        return

    def make(setting: ItemSetting) -> Item | None:
        signs = _signs(bench, setting.values)
        return None if signs is None else _item(bench, setting, wish, rows, signs)

    shown = claims(step.statement for step in bench.derivation.steps if step.rule == "workless")
    works = frozenset(unsigned(value) for value in told if value)
    yield Prepared("signs", None, tuple(told), make, Content(signs=shown | works))


def _rows(bench: ProblemBench) -> Iterator[ForceRow]:
    for work in bench.study.works:
        cancels = bench.study.dynamics.workless.get(work.force) and (work.translational.parts or work.rotational.parts)
        symbol = force_symbol(bench.derivation, work.force, work.on)
        yield ForceRow(work.force, work.on, symbol, work.force if cancels else "")


def _halves(bench: ProblemBench) -> list[Work]:
    """W_T and W_θ row by row."""
    return [getattr(work, half) for work in bench.study.works for half in HALVES]


def _signs(bench: ProblemBench, values: Sequence[float]) -> list[str] | None:
    """The signs; None if a work is too small to see (or has no number)."""
    least, found = SMALL * max((abs(v) for v in values if math.isfinite(v)), default=0.0), []
    for half, value in zip(_halves(bench), values, strict=True):
        if half.parts and not math.isfinite(value):
            return None
        if not half.parts or half.value == NOTHING:
            found.append("0")
        elif abs(value) < least:
            return None
        else:
            found.append("+" if value > 0 else "-")
    return found


def _item(bench: ProblemBench, setting: ItemSetting, wish: Wish, rows: tuple[ForceRow, ...], signs: list[str]) -> Item:
    key = SignsKey(
        tuple(
            SignRow(row.symbol, row.on, _label(bench, row, setting.said), signs[2 * k], signs[2 * k + 1], row.cancels)
            for k, row in enumerate(rows)
        )
    )
    coordinate = next(c for c in bench.study.problem.coordinates if c.name == setting.scenery.coordinate)
    start = t.equation(t.Sym(coordinate.name), coordinate.start or t.ZERO)
    place = setting.situation.place
    end = given_as(*place, setting.said.notation) if place else start
    prompt = spoken(setting.said, "ask.signs", start=start, end=end, count=len(bench.study.system.bodies))
    asked = AskedQuantity(bench.name, "works", t.Sym("cal_W"), ENERGY, "theorem.whole")
    solution = bench.once(("signs", setting.said.language), lambda: tuple(_solution(bench, setting.said)))
    figure = bench.once(("diagrams", setting.said.language), lambda: diagrams(bench, setting.said, with_forces=False))
    return wish.item(setting, asked, (Paragraph(prompt), figure), key, min(len(rows), MOST_POINTS), solution=solution)


def _label(bench: ProblemBench, row: ForceRow, said: Words) -> Inlines:
    """The force, and on which body if there are several."""
    if len(bench.study.system.bodies) == 1:
        return (Math(row.symbol),)
    return spoken(said, "signs.on", force=row.symbol, body=BodyRef(row.on))


def diagrams(bench: ProblemBench, said: Words, *, with_forces: bool) -> FigureBlock:
    """Each body alone, with its forces or without them (for the student to draw)."""
    sketch = sketch_of(bench.derivation)
    drawn = sketch if with_forces else replace(sketch, forces=(), couples=())
    names = [body.name for body in sketch.bodies]
    scenes = tuple(
        free_body(drawn, name, said.body(name) if len(names) > 1 else "", axes_too=name == names[-1]) for name in names
    )
    key = "signs.figure" if with_forces else "signs.empty_figure"
    bodies = ", ".join(said.body(name) for name in names)
    alt = "".join(getattr(i, "text", "") for i in spoken(said, f"{key}_alt", bodies=bodies))
    return FigureBlock(scenes, spoken(said, key, count=len(names)), alt)


def _solution(bench: ProblemBench, said: Words) -> Iterator[Block]:
    """The diagrams with the forces and, where the works are known, the table of the derivation."""
    from rbpsym.document.telling import done_table

    yield diagrams(bench, said, with_forces=True)
    steps = [s for s in bench.derivation.steps if s.rule == "work_done"]
    if steps:
        table = done_table(steps, said)
        yield Table(table.header, table.rows, (), table.align)
