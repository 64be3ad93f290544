"""What no one knows is not taken for a constant: rates of unknown forces and of accelerations."""

from dataclasses import replace

import pytest

from rbpsym.errors import Undecided
from rbpsym.expr import tree as t
from rbpsym.mechanics.study import Study
from rbpsym.proof.context import Context
from rbpsym.proof.rules import certify
from rbpsym.statement.loader import load_problem
from tests.library.derived import derived
from tests.proof.conftest import FILES


@pytest.fixture(scope="module")
def context():
    return Context(Study(load_problem(FILES["systems/incline"])))


@pytest.mark.parametrize("name", ["N", "f", "s_ddot"])
def test_the_rate_of_an_unknown_is_refused(context, name):
    unknown = t.mul(t.TWO, t.Sym(name))
    with pytest.raises(Undecided, match=name):
        context.value(t.Deriv(unknown))
    with pytest.raises(Undecided, match=name):
        context.rate(t.add(t.Sym("s"), unknown))
    with pytest.raises(Undecided, match=name):
        context.rate_of(context.value(unknown))


def test_known_rates_are_found(context):
    assert context.value(t.Deriv(t.Sym("s"))) == context.value(t.Sym("s_dot"))


# --- what is not granted is not constant

THETA = t.Sym("theta")
UNCHANGED = {
    "change": lambda x: t.equation(t.Delta(x), t.ZERO),
    "rate": lambda x: t.equation(t.Deriv(x), t.ZERO),
    "second rate": lambda x: t.equation(t.Deriv(x, order=2), t.ZERO),
    "slope": lambda x: t.equation(t.Deriv(x, "theta"), t.ZERO),
    "between": lambda x: t.equation(t.Bracket(x, "theta", t.ZERO, THETA), t.ZERO),
    "limit": lambda x: t.equation(t.Limit(x, "theta", t.ZERO), x),
    "integral": lambda x: t.equation(t.Integral(x, "theta", t.ZERO, THETA), t.Mul((x, THETA))),
    "changes": lambda x: t.equation(t.Delta(x), t.Delta(t.Mul((t.TWO, x)))),
}


@pytest.mark.parametrize("how", UNCHANGED)
@pytest.mark.parametrize("name", ["K", "I_cm", "omega_ladder", "U_W", "N_w", "theta_ddot"])
@pytest.mark.parametrize("rule", ["identity", "work", "work_energy", "balance", "substitution"])
def test_what_is_not_granted_is_not_constant(rule: str, name: str, how: str) -> None:
    """A letter without its definition, an unknown force, an acceleration: nothing is known of how it changes."""
    derivation = derived("sliding-ladder")
    step = replace(
        derivation.step("kinetic"), id="new", rule=rule, statement=UNCHANGED[how](t.Sym(name)), premises=(), cites=(),
        obligations=(),
    )  # fmt: skip
    assert not certify(derivation.letters, step).verdict.is_proved
