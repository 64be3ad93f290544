"""A result to be entered: as a formula in the quantities of the problem, or as a number at the student's numbers."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.document.model import Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, asked_unit, asks_for, formula_of, is_number, numbers_at
from rbpsym.teaching.distractors import Distractor, apart, shown
from rbpsym.teaching.model import Anticipated, FormulaKey, Item, Measure, NumberKey
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.solving import follow_ons, hint, measure_of, number_formula, number_names, where_text, worked
from rbpsym.teaching.spoilers import Content
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

# --- formula: a result to be entered, in the quantities of the problem


def formulas(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity."""
    for target in wanted(bench, wish, lambda target: True, ""):
        yield _formula_task(bench, wish, target)


def _formula_task(bench: Bench, wish: Wish, target: Target) -> Prepared:
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


# --- number: a quantity at the student's numbers, with unit and significant figures


def numbers(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity that is a number at the place that is asked about."""
    fits = lambda x: is_number(bench, x, scenery)  # noqa: E731
    for target in wanted(bench, wish, fits, "it has no number at the place that is asked about"):
        yield _number_task(bench, scenery, wish, target)


def _number_task(bench: Bench, scenery: Scenery, wish: Wish, target: Target) -> Prepared:
    known = set(scenery.ranges) | {scenery.coordinate or ""}
    found = tuple(d for d in bench.pool.of(target) if d.along is not None and names_in(d.along) <= known)
    right = target.along(bench.study)

    def make(setting: Setting) -> Item | None:
        return _number_item(bench, setting, target, wish, found)

    values, content = (right, *(d.along for d in found)), Content(numbers=asks_for(bench, target).asks)
    return Prepared("number", target, values, make, content)


def _number_item(bench: Bench, setting: Setting, target: Target, wish: Wish, found: tuple[Distractor, ...]) -> Item | None:
    try:
        measure = measure_of(bench, target, setting.values[0])
    except (ValueError, ZeroDivisionError):
        return None
    if not measure.value:
        return None
    formula, names = number_formula(bench, target), number_names(bench, target)
    left = target.reading.left if target.reading else target.left
    value = setting.values[0]
    follows = tuple(follow_ons(bench, target, setting.before, "number"))
    needed = names.union(*(t.names(follow.formula) for follow in follows))
    key = NumberKey(
        measure,
        target.reading.number(value) if target.reading else value,
        formula,
        left,
        numbers_at(setting.situation, needed),
        units=(asked_unit(bench, target),),
        anticipated=tuple(_anticipated(bench, setting, target, measure, found)),
        follows=follows,
    )
    place = where_text(setting) if setting.scenery.coordinate in names else ()
    asks = spoken(setting.said, f"ask.number.{target.kind}", **{**target.slots, "left": left, "place": place})
    prompt = (Paragraph((*asks, *hint(bench, setting, target, wish.level))),)
    solution = worked(bench, setting, target, value)
    return wish.item(setting, bench.asked(target), prompt, key, 3, solution=solution, space=3)


def _anticipated(bench: Bench, setting: Setting, target: Target, right: Measure, found: tuple[Distractor, ...]):
    """What misconceptions make of it, as far as that differs in print."""
    kept = [right]
    for place, (distractor, value) in enumerate(zip(found, setting.values[1:], strict=True)):
        try:
            measure = measure_of(bench, target, value)
        except (ValueError, ZeroDivisionError):
            continue
        if all(apart(measure, other) for other in kept):
            kept.append(measure)
            formula = bench.once(("along", target.id, place), lambda d=distractor: _formula(bench, target, d))
            yield Anticipated(distractor.slip, formula, measure)


def _formula(bench: Bench, target: Target, distractor: Distractor) -> t.Node:
    formula = shown(distractor.along, bench.study)
    return target.reading.node(formula) if target.reading else formula
