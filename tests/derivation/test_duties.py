"""What must not vanish is told without the factors that do not."""

from rbpsym.derive import derive
from rbpsym.notation.machine import to_machine
from tests.library.derived import problem


def test_factors_that_do_not_vanish_are_left_out_and_nothing_is_told_twice():
    found = derive(problem("rod-tipping-over-edge"), simulation=False)
    told = {
        to_machine(one.relation) for step in found.all_steps for one in step.certificate.verdict.open_obligations
    }
    assert "b + s != 0" in told and not any("ell**2" in text for text in told)
