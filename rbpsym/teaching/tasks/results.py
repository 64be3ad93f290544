"""The result of a derivation is asked: as a formula in the quantities of the problem, as a number at the student's numbers,
or to be chosen among what misconceptions make of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from rbpsym.document.model import Math, Paragraph
from rbpsym.expr import tree as t
from rbpsym.field import Poly, Scalar
from rbpsym.teaching import bench as b
from rbpsym.teaching.distractors import Distractor, apart, shown
from rbpsym.teaching.model import Anticipated, ChoiceKey, FormulaKey, Item, Measure, NumberKey, Option
from rbpsym.teaching.ranges import measured
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.solving import follow_ons, hint, measure_of, number_formula, number_names, where_text, worked
from rbpsym.teaching.spoilers import Content, printed
from rbpsym.teaching.target import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

# --- formula: a result to be entered, in the quantities of the problem


def formulas(bench: b.ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[b.Prepared]:
    """One item a quantity."""
    for target in wanted(bench, wish, lambda target: True, ""):
        yield _formula_task(bench, wish, target)


def _formula_task(bench: b.ProblemBench, wish: Wish, target: Target) -> b.Prepared:
    found = bench.pool.of(target)
    right = b.formula_of(bench, target)
    names = in_order(bench, names_in(target.known(bench.study)))
    asked = "formula" if names else "number"  # of a pure number it is not said of what it is made

    def make(setting: b.ItemSetting) -> Item:
        follows = tuple(follow_ons(bench, target, setting.before, "formula"))
        slots = {**target.slots, "left": target.left, "names": [t.Sym(name) for name in names], "place": ()}
        asks = spoken(setting.said, f"ask.{asked}.{target.kind}", **slots)
        prompt = (Paragraph((*asks, *hint(bench, setting, target, wish.level))),)
        real = (d for d, value in zip(found, setting.values, strict=True) if in_print(value, target, True) is not None)
        anticipated = tuple(Anticipated(d.slip, d.formula) for d in real)
        key = FormulaKey(right, target.left, names, anticipated, follows)
        solution = worked(bench, setting, target, None)
        return wish.item(setting, bench.asked(target), prompt, key, 3, solution=solution, space=4)

    return b.Prepared("formula", target, tuple(d.value for d in found), make, content=b.asks_for(bench, target))


def in_order(bench: b.ProblemBench, names: frozenset[str]) -> tuple[str, ...]:
    """Names in the order of the statement: parameters, starts, coordinates, then speeds."""
    problem = bench.study.problem
    order = [q.name for q in problem.parameters] + [c.name for c in problem.coordinates]
    return tuple(sorted(names, key=lambda name: (order.index(name) if name in order else len(order), name)))


# --- number: a quantity at the student's numbers, with unit and significant figures


def numbers(bench: b.ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[b.Prepared]:
    """One item a quantity that is a number at the place that is asked about."""
    fits = lambda x: b.is_number(bench, x, scenery)  # noqa: E731
    for target in wanted(bench, wish, fits, "it has no number at the place that is asked about"):
        yield _number_task(bench, scenery, wish, target)


def _number_task(bench: b.ProblemBench, scenery: Scenery, wish: Wish, target: Target) -> b.Prepared:
    found = _with_numbers(bench, scenery, target)
    right = target.known(bench.study, along=True)

    asked = b.asks_for(bench, target).asks
    rows = frozenset(row for row in asked if isinstance(row, tuple))  # all that is to be found, where nothing in it moves
    is_moving = names_in(right) & bench.study.system.scope.rates.keys()
    content = Content(asks=frozenset() if is_moving else rows, numbers=asked)
    values = (right, *(d.along for d in found if d.along is not None), *terms(right))
    return b.Prepared("number", target, values, lambda setting: _number_item(bench, setting, target, wish, found), content)


NEAR_ZERO = 0.03  # of the largest term: there it changes its sign or has hardly begun, and a rounded number decides
MOST_TERMS = 40


def terms(value: Scalar) -> tuple[Scalar, ...]:
    """The terms of the sum over its denominator; none of a very long one."""
    parts = value.num.terms
    return tuple(Scalar(Poly({m: c}), value.den) for m, c in parts.items()) if len(parts) <= MOST_TERMS else ()


def _number_item(
    bench: b.ProblemBench, setting: b.ItemSetting, target: Target, wish: Wish, found: tuple[Distractor, ...]
) -> Item | None:
    try:
        measure = measure_of(bench, target, setting.values[0])
    except (ValueError, ZeroDivisionError):
        return None
    largest = max(map(abs, setting.values[1 + len(found) :]), default=0.0)
    if not measure.value or abs(setting.values[0]) < NEAR_ZERO * largest:
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
        b.numbers_at(setting.situation, needed),
        units=(b.asked_unit(target),),
        anticipated=tuple(_anticipated(bench, setting, target, measure, found)),
        follows=follows,
    )
    place = where_text(setting) if setting.scenery.coordinate in names else ()
    asks = spoken(setting.said, f"ask.number.{target.kind}", **{**target.slots, "left": left, "place": place})
    prompt = (Paragraph((*asks, *hint(bench, setting, target, wish.level))),)
    solution = worked(bench, setting, target, value)
    return wish.item(setting, bench.asked(target), prompt, key, 3, solution=solution, space=3)


def _anticipated(
    bench: b.ProblemBench, setting: b.ItemSetting, target: Target, right: Measure, found: tuple[Distractor, ...]
) -> Iterator[Anticipated]:
    """What misconceptions make of it, as far as that differs in print."""
    kept = [right]
    for place, (distractor, value) in enumerate(zip(found, setting.values[1:], strict=False)):
        try:
            measure = measure_of(bench, target, value)
        except (ValueError, ZeroDivisionError):
            continue
        if all(apart(measure, other) for other in kept):
            kept.append(measure)
            formula = bench.once(("along", target.id, place), partial(_formula, bench, target, distractor))
            yield Anticipated(distractor.slip, formula, measure)


def _formula(bench: b.ProblemBench, target: Target, distractor: Distractor) -> t.Node | None:
    formula = None if distractor.along is None else shown(distractor.along, bench.study)
    return target.reading.node(formula) if target.reading and formula else formula


# --- choose: the right formula or number among what misconceptions make of it


FEWEST = 3


def choices(bench: b.ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[b.Prepared]:
    """One item a quantity. Raises an error if there are too few wrong answers."""
    if not 2 <= wish.options <= 6:
        raise wish.error(f"a choice among {wish.options} is not offered", "write options = 3, 4 or 5.")
    is_asked = (lambda x: b.is_number(bench, x, scenery)) if wish.answers == "number" else (lambda x: True)
    for target in wanted(bench, wish, is_asked, "it has no number at the place that is asked about"):
        yield from _choices_of(bench, scenery, wish, target)


def _choices_of(bench: b.ProblemBench, scenery: Scenery, wish: Wish, target: Target) -> Iterator[b.Prepared]:
    found = _with_numbers(bench, scenery, target) if wish.answers == "number" else bench.pool.of(target)
    if len(found) < wish.options - 1:
        if not wish.about:
            return
        raise wish.error(
            f"there are only {len(found)} wrong answers to “{target.id}” that are proved wrong, different from each other "
            f"and of the right dimension; {wish.options - 1} are needed",
            f"write options = {len(found) + 1}." if len(found) + 1 >= FEWEST else "ask for another quantity.",
        )
    values = (target.known(bench.study), *(d.value for d in found))
    if wish.answers == "number":
        values = (target.known(bench.study, along=True), *(d.along for d in found if d.along is not None))
    right = b.formula_of(bench, target)

    def make(setting: b.ItemSetting) -> Item | None:
        kept = chosen(setting, target, wish, found)
        return None if kept is None else _choice_item(bench, setting, target, wish, right, kept)

    options = printed(bench.study, (right, *(d.formula for d in found))) if wish.answers == "formula" else frozenset()
    yield b.Prepared("choose", target, values, make, replace(b.asks_for(bench, target), prints=options))


def _with_numbers(bench: b.ProblemBench, scenery: Scenery, target: Target) -> tuple[Distractor, ...]:
    """The known wrong values that are numbers at the place that is asked about, which is told only where the right one asks."""
    known = b.known_names(bench, scenery) if scenery.coordinate in number_names(bench, target) else set(scenery.ranges)
    return tuple(d for d in bench.pool.of(target) if d.along is not None and names_in(d.along) <= known)


Kept = tuple[int, Distractor | None, Measure]


def chosen(setting: b.ItemSetting, target: Target, wish: Wish, found: tuple[Distractor, ...]) -> list[Kept] | None:
    """(place in values, distractor or None for the key, measure) in a drawn order; None if too few differ in print."""
    measures = [in_print(value, target, wish.answers == "number") for value in setting.values]
    if measures[0] is None:
        return None
    kept: list[tuple[int, Measure]] = [(0, measures[0])]
    for place in preferred(setting, len(found)):
        own = measures[place + 1]
        if own is not None and all(apart(own, other) for _, other in kept):
            kept.append((place + 1, own))
        if len(kept) == wish.options:
            break
    if len(kept) < wish.options:
        return None
    return [(place, found[place - 1] if place else None, m) for place, m in setting.draws.shuffled(kept)]


def preferred(setting: b.ItemSetting, count: int) -> list[int]:
    """The best half in any order, then the rest in any order."""
    first = (count + 1) // 2
    best, rest = list(range(first)), list(range(first, count))
    return [*setting.draws.shuffled(best), *setting.draws.shuffled(rest)]


def in_print(value: float, target: Target, reads: bool) -> Measure | None:
    """The number as it would be printed; None where there is none."""
    try:
        value = target.reading.number(value) if reads and target.reading else value
        return measured(value, "", 3)
    except (ValueError, ZeroDivisionError):
        return None


def _choice_item(
    bench: b.ProblemBench, setting: b.ItemSetting, target: Target, wish: Wish, right: t.Node, kept: list[Kept]
) -> Item:
    numbers = wish.answers == "number"
    options = tuple(_option(bench, setting, target, right, d, m, numbers) for _, d, m in kept)
    key = ChoiceKey(options, next(at for at, (place, _, _) in enumerate(kept) if place == 0))
    left = target.reading.left if numbers and target.reading else target.left
    place = where_text(setting) if numbers and setting.scenery.coordinate in number_names(bench, target) else ()
    prompt = spoken(setting.said, f"ask.choose.{target.kind}", **{**target.slots, "left": left, "place": place})
    solution = worked(bench, setting, target, setting.values[0] if numbers else None)
    return wish.item(setting, bench.asked(target), (Paragraph(prompt),), key, 2, solution=solution)


def _option(
    bench: b.ProblemBench, setting: b.ItemSetting, target: Target, right: t.Node, d: Distractor | None, m: Measure, numbers: bool
) -> Option:
    slip = None if d is None else d.slip
    formula = right if d is None else d.formula
    if not numbers:
        return Option((Math(formula),), slip, formula)
    measure = Measure(m.value, b.asked_unit(target), m.digits)
    return Option((Math(b.word(measure, setting.said.notation)),), slip, None, measure)
