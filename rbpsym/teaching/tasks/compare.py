"""Compare: two variants of a problem; which is faster is proved for all values, and the student says why."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial
from typing import Any

from rbpsym.decide.signs import sign
from rbpsym.document.model import Display, Math, Paragraph
from rbpsym.document.words import Words
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import UNITY, Scalar, is_zero, names_in, short, substitute, symbol
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import BodyRef
from rbpsym.quantities import LENGTH, MASS
from rbpsym.teaching.bench import ItemSetting, Prepared, ProblemBench, formula_of
from rbpsym.teaching.distractors import Wrong, shown
from rbpsym.teaching.misconceptions.inertia import ROUND
from rbpsym.teaching.model import ComparisonKey, Criterion, Item, Option
from rbpsym.teaching.situations import Scenery
from rbpsym.teaching.target import Target
from rbpsym.teaching.tasks.wish import Wish, wanted
from rbpsym.teaching.wording import spoken

ASKED = ("frequency", "speed", "acceleration")
FIRST, SECOND, SAME = 0, 1, 2
USUAL = 3  # points
MOST_STEPS = 20  # of the way to a quantity that are looked through for what was changed


class Variant(Frozen):
    """Another system than that of the problem: how it is called, and the value of a target in it."""

    phrase: str
    slots: Mapping[str, Any]
    value: Callable[[ProblemBench, Target], Scalar | None]


Decided = tuple[Variant, int, Scalar]  # with the place of the right answer, and the value


def prepare(bench: ProblemBench, scenery: Scenery, wish: Wish) -> Iterator[Prepared]:
    """One item a quantity for which a variant can be compared for all values of the parameters."""
    fits = lambda x: x.kind in ASKED  # noqa: E731
    for target in wanted(bench, wish, fits, "a frequency, a speed or an acceleration can be compared"):
        found = tuple(_decided(bench, target))
        joined = tuple(pair for pair in found if "body" in pair[0].slots)  # another system, not another size
        if found:
            yield _prepared(bench, wish, target, joined or found)


def _decided(bench: ProblemBench, target: Target) -> Iterator[Decided]:
    """Variants with the place of the right answer, proved, and their values."""
    right = target.value(bench.study)
    for variant in variants(bench):
        value = None
        with suppress(RbpsymError, ZeroDivisionError):
            value = variant.value(bench, target)
        answer = None if value is None or right is None else _answer(right, value, bench.study)
        if value is not None and answer is not None and (answer != SAME or _is_involved(bench, target, variant)):
            yield variant, answer, value


def _is_involved(bench: ProblemBench, target: Target, variant: Variant) -> bool:
    """Whether what is changed stands in the equations of motion, or on the way to the target: only then it is worth asking that
    it drops out."""
    if "name" in variant.slots:
        dynamics = bench.study.dynamics
        parts = (*dynamics.forcing, *(entry for row in dynamics.mass_matrix for entry in row))
        return any(variant.slots["name"].name in names_in(part) for part in parts)
    way, body = bench.way_to(target.step, MOST_STEPS) if target.step else (), variant.slots["body"].name
    return len(bench.study.system.bodies) == 1 or any(body in step.id.split(".") for step in way)


def _answer(right: Scalar, other: Scalar, study: Study) -> int | None:
    """SAME if they are equal; FIRST or SECOND if one is greater in size for all values; None if that is not proved."""
    if is_zero(other - right):
        return SAME
    ratio = short(other / right)
    if sign(ratio, study.assumptions).kind != "positive":
        return None
    return {"positive": SECOND, "negative": FIRST}.get(sign(ratio - UNITY, study.assumptions).kind or "")


def variants(bench: ProblemBench) -> Iterator[Variant]:
    """A constant doubled; another round shape; a bearing for a weld and a weld for a bearing."""
    for quantity in bench.study.problem.parameters:
        if quantity.dimension in (MASS, LENGTH) and quantity.sign == "positive":
            yield Variant("compare.doubled", {"name": t.Sym(quantity.name)}, partial(_doubled, name=quantity.name))
    for wrong in _made_so(bench, "moment-of-another-shape"):
        body = wrong.site.slots["body"].name
        own = bench.study.problem.body(body).shape.kind
        slots = {"body": BodyRef(body), "first": own if own in ROUND else "disk", "second": wrong.site.slots["variant"]}
        yield Variant("compare.shape", slots, partial(_of_study, study=wrong.study))
    for name, phrase in (("free-taken-as-welded", "compare.welded"), ("welded-taken-as-free", "compare.free")):
        for wrong in _made_so(bench, name):
            if phrase == "compare.free" and not _would_keep_its_spin(bench.study, wrong.site.slots["body"].name):
                continue
            yield Variant(phrase, {"body": wrong.site.slots["body"]}, partial(_of_study, study=wrong.study))


def _would_keep_its_spin(study: Study, name: str) -> bool:
    """Does nothing but its weld turn a body about its centre of mass, so that on a bearing only its mass would count?"""
    state = study.system.bodies[name]
    arms = [(force.point - state.center).cross(force.vector) for force in study.system.on(name)]
    couples = [force.couple for force in study.system.on(name) if not force.unknowns]
    return bool(state.omega) and all(map(is_zero, (*arms, *couples)))


def _made_so(bench: ProblemBench, name: str) -> list[Wrong]:
    """The studies that a misconception makes: what is wrong of this system is right of another one."""
    return [wrong for wrong in bench.pool.wrongs if wrong.misconception.name == name]


def _of_study(bench: ProblemBench, target: Target, study: Study) -> Scalar | None:
    return target.value(study)


def _doubled(bench: ProblemBench, target: Target, name: str) -> Scalar | None:
    value = target.value(bench.study)
    return None if value is None else short(substitute(value, {name: symbol(name) * 2}))


def _prepared(bench: ProblemBench, wish: Wish, target: Target, found: tuple[Decided, ...]) -> Prepared:
    return Prepared("compare", target, (), lambda setting: _item(bench, setting, wish, target, setting.draws.one_of(found)))


def _item(bench: ProblemBench, setting: ItemSetting, wish: Wish, target: Target, chosen: Decided) -> Item:
    said, (variant, right, value) = setting.said, chosen
    slots = {k: spoken(said, f"shape.{v}") if k in ("first", "second") else v for k, v in variant.slots.items()}
    change = spoken(said, variant.phrase, **slots)
    prompt = spoken(said, f"ask.compare.{target.kind}", **{**target.slots, "left": target.left, "change": change})
    options = tuple(Option(spoken(said, f"compare.{name}")) for name in ("first", "second", "same"))
    other = bench.once(("compared", target.id, variant.phrase, str(variant.slots)), lambda: shown(value, bench.study))
    pair = (formula_of(bench, target), other)
    why = Paragraph(spoken(said, f"compare.why.{('first', 'second', 'same')[right]}", left=target.left))
    return wish.item(
        setting, bench.asked(target), (Paragraph(prompt),), ComparisonKey(options, right), USUAL,
        rubric=_rubric(setting, target, wish.worth(USUAL), pair), solution=(why, *_pair(said, target, pair)), space=3,
    )  # fmt: skip


def _pair(said: Words, target: Target, pair: tuple[t.Node, t.Node]) -> Iterator[Paragraph | Display]:
    for name, formula in zip(("one", "other"), pair, strict=True):
        yield Paragraph(spoken(said, f"compare.{name}"))
        yield Display(t.equation(target.left, formula), numbered=False)


def _rubric(setting: ItemSetting, target: Target, points: Fraction, pair: tuple[t.Node, t.Node]) -> Iterator[Criterion]:
    """A third for the choice, a third for each of the two formulas or the words that say the same."""
    yield Criterion(points / 3, spoken(setting.said, "rubric.choice"))
    for name, formula in zip(("one", "other"), pair, strict=True):
        relation = t.equation(target.left, formula)
        yield Criterion(points / 3, (*spoken(setting.said, f"rubric.{name}"), Math(relation)), relation)
