"""What must not vanish is told without the factors that do not."""

from types import SimpleNamespace

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.domain import Condition
from rbpsym.decide.signs import sign
from rbpsym.derive import derive
from rbpsym.expr import tree as t
from rbpsym.field import short
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.mechanics.friction import slips
from rbpsym.present.forms import PLAIN
from rbpsym.proof.duties import _core, _is_said, _open
from rbpsym.typeset.machine import to_machine
from tests.library.derived import NAMES, derived, problem

X, Y = symbol("x"), symbol("y")


def test_factors_that_do_not_vanish_are_left_out_and_nothing_is_told_twice():
    found = derive(problem("rod-tipping-over-edge"), simulation=False)
    told = {
        to_machine(one.relation) for step in found.all_steps for one in step.certificate.verdict.open_obligations
    }
    assert "theta_dot != 0" in told and not any("ell**2" in text for text in told)


@pytest.mark.parametrize("name", NAMES)
def test_who_divides_by_a_speed_says_so(name: str) -> None:
    """From θ̇ [...] = 0 the equation of motion follows where θ̇ is not zero, and what stands still satisfies the former."""
    for step in derived(name).all_steps:
        if step.id.endswith("motion.from_energy"):
            told = {to_machine(one.relation) for one in step.certificate.verdict.open_obligations}
            assert any("_dot" in text and text.endswith("!= 0") for text in told), told


@pytest.mark.parametrize("name", NAMES)
def test_what_is_positive_is_not_said_to_be_not_negative_beside(name: str) -> None:
    for step in derived(name).all_steps:
        open_ = [one.relation for one in step.certificate.verdict.open_obligations]
        strict = [relation.items[0] for relation in open_ if relation.ops == (">",)]
        assert not [r for r in open_ if r.ops == (">=",) and r.items[0] in strict], step.id


def test_what_never_vanishes_is_no_condition() -> None:
    """16 - 9 cos²(θ - ψ), as it comes in sines of θ, ψ and θ - ψ: no step divides by what may vanish but the speeds."""
    steps = derived("hinged-rods-struck").all_steps
    told = {to_machine(one.relation) for step in steps for one in step.certificate.verdict.open_obligations}
    assert not [text for text in told if "!= 0" in text and "_dot" not in text]


@pytest.mark.parametrize(("op", "value", "said"), [(">=", X, True), ("!=", X, True), (">=", X * Y, False), ("!=", Y, False)])
def test_one_condition_is_told_for_two(op: str, value: Scalar, said: bool) -> None:
    """x > 0 says x ≥ 0 and x ≠ 0, and nothing of y."""
    assert _is_said(Condition(t.ZERO, op, value), [X]) is said


def test_a_condition_has_one_form() -> None:
    """Of the other sign, times a number or a factor of known sign it is the condition that was there before."""
    whole = SimpleNamespace(assumptions=Assumptions({"m": "positive"}), style=PLAIN)
    view, m = SimpleNamespace(steps={}, rows={}, whole=whole), symbol("m")
    first = _open(view, Condition(t.Sym("a"), "!=", X - Y)).relation
    assert first == t.relation(t.Sym("a"), "!=", t.ZERO)
    for value in (Y - X, (X - Y) * 3, (Y - X) * m):
        assert _open(view, Condition(t.Sym("b"), "!=", value)).relation == first
    assert _open(view, Condition(t.Sym("b"), ">", Y - X)).relation != t.relation(t.Sym("a"), ">", t.ZERO)


@pytest.mark.parametrize("value", [X - Y, Y - X])
def test_what_is_not_zero_gives_no_sign_to_what_is_positive(value: Scalar) -> None:
    """A form that stands for both signs of what does not vanish is not that of a condition on the sign."""
    whole = SimpleNamespace(assumptions=Assumptions(), style=PLAIN)
    view, long = SimpleNamespace(steps={}, rows={}, whole=whole), t.mul(*map(t.Sym, "abcde"))
    for op in ("!=", ">", ">="):
        told = scalar(_open(view, Condition(long, op, value)).relation.items[0])
        assert told == value or (op == "!=" and told == -value)


def test_a_factor_of_known_sign_is_no_part_of_a_condition() -> None:
    given, m, gap = Assumptions({"m": "positive"}), symbol("m"), X - Y
    assert _core(gap * m * 2, given) == gap and _core(gap * m * -3, given) == -gap and _core(gap / (m + 1), given) == gap
    assert _core(gap**2 * m, given) == gap**2 * m and _core(m / gap, given) == m / gap


@pytest.mark.parametrize("name", NAMES)
def test_what_is_against_a_motion_says_that_this_keeps_its_sense(name: str) -> None:
    """The formula of kinetic friction, as that of a resistance, is another one when the slip has turned round."""
    for own in (derived(name), *(phase.derivation for phase in derived(name).phases)):
        ledger = [step for step in own.steps if step.chapter == "forces"]
        told = [own.letters.value(one.relation.items[0]) for step in ledger for one in step.certificate.verdict.open_obligations]
        for slip in slips(own.study.system).values():
            known = sign(slip, own.study.assumptions).is_nonnegative
            assert known or any(sign(short(value / slip), own.study.assumptions).kind == "positive" for value in told)
