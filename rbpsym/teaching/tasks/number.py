"""Number: a quantity at the student's numbers, with unit and significant figures."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rbpsym.algebra import atoms
from rbpsym.algebra.scalar import Scalar
from rbpsym.document.model import Paragraph
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, Prepared, Setting, asked_unit, asks_for, is_number, numbers_at
from rbpsym.teaching.distractors import Distractor, apart, shown
from rbpsym.teaching.model import Anticipated, FollowOn, Item, Measure, NumberKey
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

    values = (right, *(d.along for d in found))
    is_placed = scenery.coordinate in names_in(right)
    return Prepared(
        "number",
        target,
        values,
        make,
        target.kind == "frequency",
        is_placed,
        Content(numbers=asks_for(bench, target).asks),
    )


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
    key = NumberKey(
        measure,
        target.reading.number(value) if target.reading else value,
        formula,
        left,
        numbers_at(setting.situation, names),
        units=(asked_unit(bench, target),),
        anticipated=tuple(_anticipated(bench, setting, target, measure, found)),
        follows=tuple(_follows(bench, setting, target)),
    )
    place = where_text(setting) if setting.scenery.coordinate in names else ()
    prompt = spoken(setting.said, f"ask.number.{target.kind}", **{**target.slots, "left": left, "place": place})
    return Item(
        setting.id,
        "number",
        (Paragraph((*prompt, *hint(bench, setting, target, wish.level))),),
        key,
        bench.asked(target),
        wish.points if wish.points is not None else Fraction(3),
        solution=worked(bench, setting, target, value),
        level=wish.level,
        space=Fraction(3),
    )


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


def _follows(bench: Bench, setting: Setting, target: Target) -> Iterator[FollowOn]:
    """In terms of a speed that an earlier item asks for: F(θ, ω²) from the student's own ω."""
    value = (
        target.value(bench.study) if target.kind != "reaction" else bench.study.dynamics.reactions.get(target.id[9:])
    )
    if value is None or target.reading is not None:
        return
    for item in setting.before:
        if item.kind == "number" and item.asked.problem == bench.name and item.asked.quantity.startswith("speed."):
            name = f"{item.asked.quantity[6:]}_dot"
            if name in names_in(value) and is_even(value, name):
                yield FollowOn(item.id, name, bench.once(("follow", target.id), lambda: shown(value, bench.study)))


def _in_the_state(bench: Bench, target: Target) -> Scalar | None:
    """The value in terms of the speeds too; None where the number is read off it."""
    if target.reading is not None:
        return None
    if target.kind == "reaction":
        return bench.study.dynamics.reactions.get(target.id.removeprefix("reaction."))
    return target.value(bench.study)


def is_even(value: Scalar, name: str) -> bool:
    """Whether a value holds even powers of a name only (then the sense of a speed does not matter)."""
    index = atoms.intern("symbol", name)
    return all(not power % 2 for poly in (value.num, value.den) for power in poly.by_power(index))
