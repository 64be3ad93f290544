"""Formula: a result to be entered, in the quantities of the problem."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.document.model import Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, asks_for, formula_of
from rbpsym.teaching.following import follow_ons
from rbpsym.teaching.model import Anticipated, FormulaKey, Item
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.solving import hint, worked
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity."""
    for target in wanted(bench, wish, lambda target: True, ""):
        yield _prepared(bench, wish, target)


def _prepared(bench: Bench, wish: Wish, target: Target) -> Prepared:
    found = bench.pool.of(target)
    anticipated = tuple(Anticipated(d.slip, d.formula) for d in found)
    right = formula_of(bench, target)
    names = in_order(bench, names_in(target.value(bench.study)))

    def make(setting: Setting) -> Item:
        follows = tuple(follow_ons(bench, target, setting.before, "formula"))
        slots = {**target.slots, "left": target.left, "names": [t.Sym(name) for name in names]}
        asks = spoken(setting.said, f"ask.formula.{target.kind}", **slots)
        prompt = (Paragraph((*asks, *hint(bench, setting, target, wish.level))),)
        key = FormulaKey(right, target.left, names, anticipated, follows)
        solution = worked(bench, setting, target, None)
        return wish.item(setting, bench.asked(target), prompt, key, 3, solution=solution, space=4)

    return Prepared("formula", target, (), make, content=asks_for(bench, target))


def in_order(bench: Bench, names: set[str]) -> tuple[str, ...]:
    """Names in the order of the statement: parameters, starts, coordinates, then speeds."""
    problem = bench.study.problem
    order = [q.name for q in problem.parameters] + [c.name for c in problem.coordinates]
    return tuple(sorted(names, key=lambda name: (order.index(name) if name in order else len(order), name)))
