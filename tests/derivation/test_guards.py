"""What no one knows is not taken for a constant: rates of unknown forces and of accelerations."""

import pytest

from rbpsym.derivation.context import Context
from rbpsym.errors import Undecided
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.statement.loader import load_problem
from tests.derivation.conftest import FILES


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
