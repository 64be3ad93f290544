"""Choose: the right formula or number among what misconceptions make of it."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.document.model import Math, Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, asked_unit, asks_for, formula_of, is_number, word
from rbpsym.teaching.distractors import Distractor, apart
from rbpsym.teaching.model import ChoiceKey, Item, Measure, Option
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.solving import number_names, where_text, worked
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.units import measured
from rbpsym.teaching.wording import spoken

FEWEST = 3


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity. Raises an error if there are too few wrong answers."""
    if not 2 <= wish.options <= 6:
        raise wish.error(f"a choice among {wish.options} is not offered", "write options = 3, 4 or 5.")
    is_asked = (lambda x: is_number(bench, x, scenery)) if wish.answers == "number" else (lambda x: True)
    for target in wanted(bench, wish, is_asked, "it has no number at the place that is asked about"):
        yield from _prepared(bench, scenery, wish, target)


def _prepared(bench: Bench, scenery: Scenery, wish: Wish, target: Target) -> Iterator[Prepared]:
    found = tuple(d for d in bench.pool.of(target) if wish.answers != "number" or _has_number(d, bench, scenery))
    if len(found) < wish.options - 1:
        if not wish.about:
            return
        raise wish.error(
            f"there are only {len(found)} wrong answers to “{target.id}” that are proved wrong, different from each other "
            f"and of the right dimension; {wish.options - 1} are needed",
            f"write options = {len(found) + 1}." if len(found) + 1 >= FEWEST else "ask for another quantity.",
        )
    values = (target.value(bench.study), *(d.value for d in found))
    if wish.answers == "number":
        values = (target.along(bench.study), *(d.along for d in found))
    right = formula_of(bench, target)

    def make(setting: Setting) -> Item | None:
        kept = chosen(setting, target, wish, found)
        return None if kept is None else _item(bench, setting, target, wish, right, kept)

    yield Prepared("choose", target, values, make, asks_for(bench, target))


def _has_number(distractor: Distractor, bench: Bench, scenery: Scenery) -> bool:
    known = set(scenery.ranges) | {scenery.coordinate or ""}
    return distractor.along is not None and names_in(distractor.along) <= known


def chosen(setting: Setting, target: Target, wish: Wish, found: tuple[Distractor, ...]):
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


def preferred(setting: Setting, count: int) -> list[int]:
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


def _item(bench: Bench, setting: Setting, target: Target, wish: Wish, right: t.Node, kept) -> Item:
    numbers = wish.answers == "number"
    options = tuple(_option(bench, setting, target, right, d, m, numbers) for _, d, m in kept)
    key = ChoiceKey(options, next(at for at, (place, _, _) in enumerate(kept) if place == 0))
    left = target.reading.left if numbers and target.reading else target.left
    place = where_text(setting) if numbers and setting.scenery.coordinate in number_names(bench, target) else ()
    prompt = spoken(setting.said, f"ask.choose.{target.kind}", **{**target.slots, "left": left, "place": place})
    solution = worked(bench, setting, target, setting.values[0] if numbers else None)
    return wish.item(setting, bench.asked(target), (Paragraph(prompt),), key, 2, solution=solution)


def _option(
    bench: Bench, setting: Setting, target: Target, right: t.Node, d: Distractor | None, m: Measure, numbers: bool
) -> Option:
    slip = None if d is None else d.slip
    formula = right if d is None else d.formula
    if not numbers:
        return Option((Math(formula),), slip, formula)
    measure = Measure(m.value, asked_unit(bench, target), m.digits)
    return Option((Math(word(measure, setting.said.notation)),), slip, None, measure)
