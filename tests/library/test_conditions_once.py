"""No list of conditions says one twice: not with the other sign, times a number, or with a factor of known sign; nor one and
its opposite."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.signs import sign
from rbpsym.document.needless import owed_by
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_relation
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero
from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.elimination import short
from rbpsym.proof.duties import merged
from rbpsym.proof.step import Derivation
from rbpsym.solve import answer_of
from tests.library.derived import NAMES, answers_to, unsimulated

Value = Callable[[t.Node], Scalar]


def twins(conditions: Iterable[t.Node], value: Value, given: Assumptions) -> list[tuple[t.Node, t.Node]]:
    """Pairs of which one says what the other does, or a part of it."""
    return [(one, other) for one, other in combinations(conditions, 2) if _are_twins(one, other, value, given)]


def _are_twins(one: t.Node, other: t.Node, value: Value, given: Assumptions) -> bool:
    """Of one sign, so that one of them would do, or of opposite ones, so that both together are never met."""
    try:
        first, second = value(one.items[0]), value(other.items[0])
    except RbpsymError:  # of another phase
        return False
    return not (is_zero(first) or is_zero(second)) and sign(short(first / second), given).is_nonzero


def lists(derivation: Derivation) -> Iterator[Sequence[t.Node]]:
    """The conditions that stand together on a page of each level."""
    for level in (1, 2, 3):
        shown = {step.id for step in derivation.steps if step.is_result or step.level <= level}
        yield from owed_by(derivation.steps, shown, derivation.study.assumptions).values()


@pytest.mark.parametrize("name", NAMES)
def test_no_condition_stands_twice(name: str) -> None:
    derivation = unsimulated(name)
    for own in (derivation, *(phase.derivation for phase in derivation.phases)):
        value, given = own.letters.value, own.study.assumptions
        assert not [pair for told in lists(own) for pair in twins(told, value, given)]
    value, given, answer = derivation.letters.value, derivation.study.assumptions, answer_of(derivation)
    for told in (answer, *answer["phases"]):
        read = [read_relation(text, answer["symbols"]) for text in told["valid_where"]]
        assert not twins(read, value, given)
    for found in answers_to(derivation.study):
        assert not twins(found.valid, value, given), found.question.text


def test_it_sees_twins() -> None:
    a, b, m = map(t.Sym, "abm")
    given = Assumptions({"m": "positive"})
    gap, turned = t.add(a, t.neg(b)), t.add(b, t.neg(a))
    for one, other, are in (
        (t.relation(gap, "!=", t.ZERO), t.relation(turned, "!=", t.ZERO), True),
        (t.relation(gap, ">", t.ZERO), t.relation(turned, ">", t.ZERO), True),
        (t.relation(gap, ">", t.ZERO), t.relation(t.mul(m, gap), ">=", t.ZERO), True),
        (t.relation(gap, "!=", t.ZERO), t.relation(a, "!=", t.ZERO), False),
    ):
        assert bool(twins((one, other), scalar, given)) is are


def test_what_is_not_negative_and_not_zero_is_positive() -> None:
    a, b = t.Sym("a"), t.Sym("b")
    found = merged(t.relation(node, op, t.ZERO) for node, op in ((a, ">="), (b, "!="), (a, "!="), (b, "!=")))
    assert found == (t.relation(a, ">", t.ZERO), t.relation(b, "!=", t.ZERO))
