"""Laws over the paper of every problem of the library."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from rbpsym.decide.equal import scalars_equal
from rbpsym.document.model import Display, Math, Paragraph
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.phases import followable, known_stages
from rbpsym.mechanics.study import Study
from rbpsym.teaching import model as m
from rbpsym.teaching.compiled import compiled
from rbpsym.teaching.ranges import si
from rbpsym.teaching.spoilers import is_telling, meaning
from tests.teaching.library_papers import NAMES, NONE, bench_of, paper

pytestmark = pytest.mark.heavy(of=12)

by_name = pytest.mark.parametrize("name", [name for name in NAMES if name not in NONE])


@by_name
def test_no_answer_is_given_away(name: str) -> None:
    """Neither as it is nor with the other sign, under whatever name, in the statement or in any task of the paper."""
    plan, sheet = paper(name)
    study = plan.parts[0].bench.study
    shown = {item.id: list(printed(item)) for item in sheet.items}
    shown[""] = [node for block in sheet.parts[0].statement for node in formulas(block)]
    values = {place: [v for node in nodes for v in values_in(study, node)] for place, nodes in shown.items()}
    plain = {place: [v for node in nodes for v in values_in(study, node, t.walk)] for place, nodes in shown.items()}
    for item in sheet.items:
        for answer in answers(item.key):
            value = meaning(study, answer) if is_telling(answer) else None
            if not isinstance(value, Scalar):
                continue
            others = {place: found for place, found in values.items() if place != item.id}
            if isinstance(item.key, m.BlanksKey):  # in its own derivation a line with a vector may lead to it
                others[item.id] = plain[item.id]
            for place, found in others.items():
                assert not any(same(value, other) or same(value, -other) for other in found), (item.id, place, answer)


@by_name
def test_its_motion_begins_as_it_is_told_and_comes_to_all_phases(name: str) -> None:
    plan, sheet = paper(name)
    problem, numbers = plan.parts[0].bench.study.problem, {n: si(measure) for n, measure in sheet.parts[0].given.items()}
    asked = [demand.value for demand in followable(known_stages(problem)[0]) if demand.op != "!="]
    assert all(floating(value, numbers, 0.0) >= 0 for value in asked)


@by_name
def test_no_blank_follows_from_a_solution_below_it(name: str) -> None:
    """An equation with a blank is no question where a line of the same derivation is its solution: m ÿ = □ above ÿ = −g."""
    plan, sheet = paper(name)
    for item in sheet.items:
        if isinstance(item.key, m.BlanksKey):
            bench = bench_of(plan, item)
            study, steps = bench.study, {step.id: step for step in bench.derivation.steps}
            lines = {row for node in printed(item) for row in t.rows(node) if isinstance(row, t.Chain)}
            ends = {row.items[0].name: scalar(row.items[-1]) for row in lines if is_solution(study, row)}
            for row in (row for blank in item.key.blanks for row in t.rows(steps[blank.step].statement)):
                sides = [meaning(study, side) for side in (row.items[0], row.items[-1])]
                if row not in lines and all(isinstance(side, Scalar) for side in sides) and ends:
                    assert not same(substitute(sides[0] - sides[1], ends), NOTHING) or same(*sides), (item.id, row)


def is_solution(study: Study, row: t.Chain) -> bool:
    known = isinstance(row.items[0], t.Sym) and row.items[0].name.endswith("_ddot")
    return known and isinstance(meaning(study, row.items[-1]), Scalar)


def values_in(study: Study, node: t.Node, see=None) -> Iterator[Scalar]:
    for part in (see or with_bare_products)(node):
        value = meaning(study, part) if is_telling(part) else None
        if isinstance(value, Scalar):
            yield value


def with_bare_products(node: t.Node) -> Iterator[t.Node]:
    """All parts, and the torque before its direction, the moment of inertia before the acceleration."""
    for part in t.walk(node):
        yield part
        if isinstance(part, t.Mul):
            bare = (f for f in part.factors if not isinstance(f, t.Unit) and not getattr(f, "name", "").endswith("_ddot"))
            yield t.mul(*bare)


def answers(key: m.Key) -> list[t.Node]:
    """The formulas that a student is to find; a number may be asked of a formula that is printed."""
    match key:
        case m.FormulaKey():
            return [key.value]
        case m.ChoiceKey() if key.options[key.right].formula is not None:
            return [key.options[key.right].formula]
        case m.BlanksKey():
            return [blank.value for blank in key.blanks]
        case m.SlipKey():
            return [row.items[-1] for row in t.rows(key.corrected) if isinstance(row, t.Chain)]
    return []


def printed(item: m.Item) -> Iterator[t.Node]:
    """All formulas that stand in a task."""
    for block in item.prompt:
        yield from formulas(block)
    match item.key:
        case m.ChoiceKey() | m.ComparisonKey():
            yield from (option.formula for option in item.key.options if option.formula is not None)
        case m.OrderKey():
            yield from (piece.statement for piece in item.key.pieces)
        case m.SlipKey():
            yield from (line.statement for line in item.key.lines)


def formulas(block) -> Iterator[t.Node]:
    if isinstance(block, Display):
        yield block.node
    elif isinstance(block, Paragraph):
        yield from (part.node for part in block.inlines if isinstance(part, Math))


@by_name
def test_a_sign_is_asked_with_the_blank(name: str) -> None:
    """No minus stands before a blank, nor before the bracket in which it is alone."""
    for item in paper(name)[1].items:
        for node in printed(item):
            for part in t.walk(node):
                if isinstance(part, t.Neg):
                    inner = part.arg.arg if isinstance(part.arg, t.Group) else part.arg
                    factors = inner.factors if isinstance(inner, t.Mul) else (inner,)
                    assert not any(isinstance(f, t.Sym) and f.name.startswith(m.BLANK) for f in factors), (item.id, node)


@by_name
def test_each_sentence_names_an_idea_that_gives_just_this_value(name: str) -> None:
    """The operator of each sentence is applied anew, and what it makes of the quantity is the wrong value itself."""
    plan, sheet = paper(name)
    for item in sheet.items:
        bench = bench_of(plan, item)
        for formula, slip in known_slips(item.key):
            target = target_of(bench, item, formula)
            value = meaning(bench.study, formula)
            for idea in (slip, *slip.also):
                made = [w for w in bench.pool.wrongs if (w.misconception.name, w.site.slots) == (idea.name, idea.slots)]
                values = [v for w in made if (v := target.value(w.study)) is not None]
                assert any(equal(value, other, bench.study) for other in values), (item.id, formula, idea.name)


def equal(first: Scalar, second: Scalar, study: Study) -> bool:
    return same(first, second) or scalars_equal(first, second, study.assumptions).is_proved


def known_slips(key: m.Key) -> list[tuple[t.Node, m.Slip]]:
    """Wrong formulas with what is said of them."""
    match key:
        case m.ChoiceKey():
            return [(o.formula, o.slip) for o in key.options if o.slip is not None and o.formula is not None]
        case m.FormulaKey():
            return [(a.formula, a.slip) for a in key.anticipated]
        case m.BlanksKey():
            return [(a.formula, a.slip) for blank in key.blanks for a in blank.anticipated]
    return []


def target_of(bench, item: m.Item, formula: t.Node):
    """What is asked: the quantity of the item; of a blank with that wrong formula, that of the step in which it stands."""
    if not isinstance(item.key, m.BlanksKey):
        return bench.targets[item.asked.quantity]
    step = next(b.step for b in item.key.blanks if any(a.formula is formula for a in b.anticipated))
    return next(target for target in bench.targets.values() if target.step == step)


@by_name
def test_a_number_does_not_hang_on_the_rounding_of_another(name: str) -> None:
    """Where a given number is a half per cent greater, an answer is not another one by half: it is not near zero."""
    for item in paper(name)[1].items:
        if isinstance(item.key, m.NumberKey):
            given = {n: si(measure) for n, measure in item.key.given.items()}
            values = compiled([scalar(item.key.formula)])
            for moved in given:
                [other] = values({**given, moved: given[moved] * 1.005})
                assert abs(other - item.key.exact) < 0.5 * abs(item.key.exact), (item.id, item.asked.quantity, moved)


@by_name
def test_the_questions_of_the_problem_are_asked(name: str) -> None:
    """The question that a problem is known for stands on its paper."""
    plan, sheet = paper(name)
    bench = plan.parts[0].bench
    own = {id: target for id, target in bench.targets.items() if target.kind == "question"}
    asked = {item.asked.quantity for item in sheet.items}
    found = [meaning(bench.study, answer) for item in sheet.items for answer in answers(item.key)]
    found += [bench.targets[id].value(bench.study) for id in asked if id in bench.targets]
    for id in own.keys() - asked:  # a derivation to be filled in ends in it
        assert any(isinstance(v, Scalar) and same(v, own[id].value(bench.study)) for v in found), id


@by_name
def test_each_solution_of_a_result_ends_with_a_check(name: str) -> None:
    for item in paper(name)[1].items:
        if item.kind in ("formula", "number") or (item.kind == "choose" and item.solution):
            assert isinstance(item.solution[-1], Paragraph) and item.solution[-1].inlines
