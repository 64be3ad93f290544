"""Order: steps of a derivation to be put in order; the graph of the derivation says which orders are right."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.derivation.step import Step
from rbpsym.document.model import Display, Paragraph
from rbpsym.teaching.bench import Bench, Prepared, Setting
from rbpsym.teaching.codes import Draws
from rbpsym.teaching.lines import lines_to, piece, precedence
from rbpsym.teaching.model import Item, OrderKey
from rbpsym.teaching.papers.blocks import LETTERS
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.spoilers import Content, claims
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

FEWEST, MOST, TRIALS = 4, 6, 20


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a result that several steps lead to."""
    fits = lambda x: bool(x.step) and _is_long(bench, x)  # noqa: E731
    for target in wanted(bench, wish, fits, f"fewer than {FEWEST} steps lead to it, or they may stand in any order"):
        yield _prepared(bench, wish, target)


def _is_long(bench: Bench, target: Target) -> bool:
    steps = lines_to(bench, target.step, MOST)
    pairs = precedence(bench, [s.id for s in steps])
    return len(steps) >= FEWEST and len(pairs) >= len(steps) - 1 and len({s.statement for s in steps}) == len(steps)


def _prepared(bench: Bench, wish: Wish, target: Target) -> Prepared:
    steps = lines_to(bench, target.step, MOST)

    def make(setting: Setting) -> Item | None:
        key = _shuffled(bench, steps, setting.draws)
        if key is None:
            return None
        first = () if wish.level else spoken(setting.said, "hint.order", letter=LETTERS[key.sample[0]])
        prompt = (Paragraph((*spoken(setting.said, "ask.order", left=target.left), *first)),)
        solution = (Display(s.statement, numbered=False) for s in steps)
        return wish.item(setting, bench.asked(target), prompt, key, 2, solution=solution)

    return Prepared("order", target, (), make, content=Content(claims(s.statement for s in steps)))


def _shuffled(bench: Bench, steps: tuple[Step, ...], draws: Draws) -> OrderKey | None:
    """The steps in an order that is wrong."""
    for _ in range(TRIALS):
        order = draws.shuffled(range(len(steps)))
        before = frozenset(precedence(bench, [steps[k].id for k in order]))
        sample = tuple(order.index(k) for k in range(len(steps)))
        key = OrderKey(tuple(piece(steps[k]) for k in order), before, sample)
        if not key.accepts(tuple(range(len(steps)))):
            return key
    return None
