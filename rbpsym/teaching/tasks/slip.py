"""Find the slip: a derivation with one wrong step, made by a misconception and carried through."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rbpsym.derivation.step import Step
from rbpsym.document.model import Display, Inlines, Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting
from rbpsym.teaching.distractors import size
from rbpsym.teaching.lines import lines_to, piece
from rbpsym.teaching.misconceptions.registry import MISCONCEPTIONS
from rbpsym.teaching.model import Item, Slip, SlipKey
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

MOST, FEWEST = 7, 3
ENOUGH = 3  # slips to draw from for one quantity
TRIES = 6  # wrong studies that are told for it at most
Told = tuple[Slip, tuple[Step, ...], int, t.Node]


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result that a slip on the way spoils."""
    fits = lambda x: bool(x.step) and any(True for _ in _candidates(bench, x, wish))  # noqa: E731
    for target in wanted(bench, wish, fits, "no misconception that reads well spoils a step on the way to it"):
        found = tuple(_told(bench, target, wish))
        if found:
            yield _prepared(bench, wish, target, found)


def _candidates(bench: Bench, target: Target, wish: Wish) -> Iterator[int]:
    """Places of the wrong studies that change the target and can be told as a derivation."""
    for place, wrong in enumerate(bench.pool.wrongs):
        own = wrong.misconception
        if own.tells is None or target.kind not in own.about:
            continue
        if not wish.misconceptions or own.name in wish.misconceptions:
            yield place


def _told(bench: Bench, target: Target, wish: Wish) -> Iterator[Told]:
    """Slips with their lines: equal to the right ones up to the wrong line, the result different."""
    found = 0
    for place in list(_candidates(bench, target, wish))[:TRIES]:
        told = _with_slip(bench, target, place)
        if told is not None:
            found += 1
            yield told
        if found == ENOUGH:
            return


def _with_slip(bench: Bench, target: Target, place: int) -> Told | None:
    hidden = MISCONCEPTIONS[bench.pool.wrongs[place].misconception.name].tells or frozenset()
    right = [s for s in lines_to(bench, target.step, MOST) if s.chapter not in hidden]
    lines = bench.pool.retold(place).steps(s.id for s in right) if len(right) >= FEWEST else None
    if lines is None:
        return None
    first = next((k for k, (a, b) in enumerate(zip(lines, right, strict=True)) if a.statement != b.statement), None)
    if first is None or lines[-1].statement == right[-1].statement or not _reads_well(lines[first], right[first]):
        return None
    return bench.pool.slip(place), lines, first, right[first].statement


def _reads_well(wrong: Step, right: Step) -> bool:
    """The wrong line is one that a student would write: not “= 0” for what matters, not much longer than the right one."""
    ends = [row.items[-1] for row in _rows(wrong) if isinstance(row, t.Chain)]
    is_empty = t.ZERO in ends and wrong.rule in ("mass_integral", "parallel_axis", "differentiation")
    return not is_empty and size(wrong.statement) <= 2 * size(right.statement) + 6


def _rows(step: Step) -> tuple[t.Node, ...]:
    return step.statement.rows if isinstance(step.statement, t.System) else (step.statement,)


def _prepared(bench: Bench, wish: Wish, target: Target, found: tuple[Told, ...]) -> Prepared:
    def make(setting: Setting) -> Item:
        slip, lines, first, corrected = setting.draws.one_of(found)
        comment = feedback(setting, slip)
        return Item(
            setting.id,
            "find-the-slip",
            (Paragraph(spoken(setting.said, "ask.find-the-slip", left=target.left)),),
            SlipKey(tuple(map(piece, lines)), first, corrected, slip),
            bench.asked(target),
            wish.points if wish.points is not None else Fraction(3),
            solution=(Paragraph(comment), Display(corrected, numbered=False)),
            level=wish.level,
            space=Fraction(2),
        )

    return Prepared("find-the-slip", target, (), make)


def feedback(setting: Setting, slip: Slip) -> Inlines:
    """What is said of a slip."""
    return spoken(setting.said, slip.phrase, **slip.slots)
