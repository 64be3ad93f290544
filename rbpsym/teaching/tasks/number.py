"""Number: a quantity at the student's numbers, with unit and significant figures."""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.document.model import Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, asked_unit, asks_for, is_number, numbers_at
from rbpsym.teaching.distractors import Distractor, apart, shown
from rbpsym.teaching.following import follow_ons
from rbpsym.teaching.model import Anticipated, Item, Measure, NumberKey
from rbpsym.teaching.situations import Scenery, names_in
from rbpsym.teaching.solving import hint, measure_of, number_formula, number_names, where_text, worked
from rbpsym.teaching.spoilers import Content
from rbpsym.teaching.targets import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken


def prepare(bench: Bench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity that is a number at the place that is asked about."""
    fits = lambda x: is_number(bench, x, scenery)  # noqa: E731
    for target in wanted(bench, wish, fits, "it has no number at the place that is asked about"):
        yield _prepared(bench, scenery, wish, target)


def _prepared(bench: Bench, scenery: Scenery, wish: Wish, target: Target) -> Prepared:
    known = set(scenery.ranges) | {scenery.coordinate or ""}
    found = tuple(d for d in bench.pool.of(target) if d.along is not None and names_in(d.along) <= known)
    right = target.along(bench.study)

    def make(setting: Setting) -> Item | None:
        return _item(bench, setting, target, wish, found)

    values, content = (right, *(d.along for d in found)), Content(numbers=asks_for(bench, target).asks)
    return Prepared("number", target, values, make, content)


def _item(bench: Bench, setting: Setting, target: Target, wish: Wish, found: tuple[Distractor, ...]) -> Item | None:
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
