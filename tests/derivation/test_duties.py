"""What must not vanish is told without the factors that do not."""

import pytest

from rbpsym.derive import derive
from rbpsym.notation.machine import to_machine
from tests.library.derived import NAMES, derived, problem


def test_factors_that_do_not_vanish_are_left_out_and_nothing_is_told_twice():
    found = derive(problem("rod-tipping-over-edge"), simulation=False)
    told = {
        to_machine(one.relation) for step in found.all_steps for one in step.certificate.verdict.open_obligations
    }
    assert "b + s != 0" in told and not any("ell**2" in text for text in told)


@pytest.mark.parametrize("name", NAMES)
def test_who_divides_by_a_speed_says_so(name: str) -> None:
    """From θ̇ [...] = 0 the equation of motion follows where θ̇ is not zero, and what stands still satisfies the former."""
    for step in derived(name).all_steps:
        if step.id.endswith("motion.from_energy"):
            told = {to_machine(one.relation) for one in step.certificate.verdict.open_obligations}
            assert any("_dot" in text and text.endswith("!= 0") for text in told), told
