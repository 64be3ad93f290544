"""The worksheet that is made of a problem: no task prints the answer to another."""

from __future__ import annotations

import pytest

from rbpsym.expr import tree as t
from rbpsym.proof.draft import length
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.lines import shares
from rbpsym.teaching.model import BlanksKey, FormulaKey, OrderKey, SlipKey, Student
from rbpsym.teaching.plan import bench_of, plan_of
from rbpsym.teaching.sheet import LONGEST
from rbpsym.teaching.spoilers import Content, claims, wanted
from rbpsym.teaching.spoilers import printed as told_by

M, G, A = (t.Sym(name) for name in ("m", "g", "a"))
WEIGHT, OTHER = claims([t.equation(A, t.Mul((M, G)))]), claims([t.equation(A, t.Mul((M, A)))])


def test_what_spoils_what() -> None:
    asks, prints, numbers = Content(asks=WEIGHT), Content(prints=WEIGHT), Content(numbers=WEIGHT)
    assert asks.spoils(asks) and asks.spoils(prints) and prints.spoils(asks) and numbers.spoils(asks)
    assert numbers.spoils(numbers) and not numbers.spoils(prints) and not prints.spoils(prints)
    assert not asks.spoils(Content(OTHER, OTHER, OTHER))


def test_a_value_is_given_away_under_any_name_and_with_either_sign() -> None:
    study = bench_of(load_problem(find_problem("rod-pendulum"))).study
    weight = t.Mul((t.Sym("M"), G, t.Sym("ell"), t.Fn("sin", t.Sym("theta"))))
    asked, told = wanted(study, [weight]), told_by(study, [t.equation(t.Sym("tau"), t.neg(t.Mul((t.TWO, *weight.factors))))])
    assert asked and not asked & told
    assert asked & told_by(study, [t.equation(t.Sym("tau"), t.neg(weight))])
    assert not wanted(study, [t.Mul((t.Sym("M"), G))])


@pytest.mark.parametrize("name", ["rod-pendulum", "atwood-with-massive-pulley"])
def test_no_answer_is_printed_in_another_task(name: str) -> None:
    plan = plan_of(name)
    sheet = plan.worksheet(Student("a"))
    by_id = {step.id: step for step in plan.parts[0].bench.derivation.steps}
    kinds = {item.kind for item in sheet.items}
    assert len(kinds) >= 7
    for item in sheet.items:
        for other in sheet.items:
            if other is not item:
                assert not answers(item, by_id) & printed(other), (item.kind, other.kind)


def answers(item, by_id) -> frozenset:
    key = item.key
    if isinstance(key, FormulaKey):
        return claims([t.equation(key.left, key.value)])
    if isinstance(key, SlipKey):
        return claims([key.corrected])
    steps = {blank.step for blank in key.blanks} if isinstance(key, BlanksKey) else set()
    return claims(by_id[id].statement for id in steps)


def printed(item) -> frozenset:
    key = item.key
    if isinstance(key, OrderKey):
        return claims(piece.statement for piece in key.pieces)
    if isinstance(key, SlipKey):
        return claims(line.statement for line in key.lines)
    return claims(block.node for block in item.prompt if hasattr(block, "node"))


def test_points_go_by_weight_in_halves() -> None:
    from fractions import Fraction

    for points in (Fraction(2), Fraction(5, 2), Fraction(7)):
        for weights in ([1], [4, 4], [5, 1, 3], [1, 1, 1, 1]):
            found = shares(points, weights)
            assert sum(found) == points and all(share > 0 and (2 * share).denominator == 1 for share in found)
            order = sorted(range(len(weights)), key=lambda k: weights[k])
            assert all(found[a] <= found[b] for a, b in zip(order, order[1:], strict=False) if weights[a] < weights[b])
    assert sum(shares(Fraction(1, 3), [1, 2])) == Fraction(1, 3)


def test_no_one_is_asked_to_write_a_formula_of_half_a_page() -> None:
    """The forces at the hinge of this system are some 600 parts long."""
    sheet = plan_of("rod-with-spring").worksheet(Student("a"))
    keys = [item.key.value for item in sheet.items if isinstance(item.key, FormulaKey)]
    assert all(length(key) <= LONGEST for key in keys)
    assert "number" in {item.kind for item in sheet.items}
