"""What holds only after the start, or only as long as a contact presses, is proved on that condition, and so written."""

from __future__ import annotations

import pytest

from rbpsym.kernel.certify import Written, written
from rbpsym.kernel.claim import AHEAD
from rbpsym.kernel.coqc import compiled
from tests.kernel.test_certify import needs_coqc
from tests.library.derived import unsimulated

pytestmark = pytest.mark.heavy


@needs_coqc
@pytest.mark.parametrize(
    ("name", "ids"),
    [
        ("rod-tipping-over-edge", ("holds.N", "friction.N")),  # the range is open at the start: N > 0 only from then on
        ("cylinder-off-cylinder", ("friction.N",)),  # what stands below is N by a factor, and N > 0 is the condition
        ("crate-on-truck", ("friction.N_r",)),  # a sum of forces stands below
        pytest.param("rod-on-turntable", ("position.rod", "reaction.A_x"), marks=pytest.mark.thorough),  # ωt here, tω there
        ("bead-on-rotating-rod", ("theorem.T.rod",)),  # at the start the angle is 0·Ω
        ("boat-coasting", ("course.x",)),  # a linear equation has one solution from a start
        ("falling-stick", ("square.theta", "holds.N")),  # what is conserved has a coordinate below; 3 (cos θ - 1)² + 1 > 0
        ("wheel-over-kerb", ("asks.N", "reaction.F")),  # what stands below a root is positive by a range
        ("cart-pulled-over-pulley", ("work.S.cart",)),  # a root that does not vanish stands below in an integrand
        ("rod-falling-on-rough-floor", ("holds.N",)),  # a square is at least 0
        ("two-drums-on-a-ribbon", ("alone.upper", "alone.lower")),  # what a work is is a fact, of both
        pytest.param("rod-on-two-strings", ("energy", "asks.T"), marks=pytest.mark.thorough),  # factors with sines of sums
        pytest.param("rod-on-two-strings", ("modes.1", "shape.1.2"), marks=pytest.mark.thorough),  # a - √b is positive
        ("ladder-with-person", ("holds.N_f",)),  # as long as another force presses
        ("cylinder-in-cylinder", ("holds.N", "friction.N")),  # as no square of a speed is negative; and with what that says
        ("ring-with-point-mass", ("friction.N",)),  # what stands below is a force by factors of known sign
        ("scotch-yoke", ("square.theta",)),  # a sign for all values of what is integrated over
        ("two-gears", ("energy",)),  # a sum of two products is replaced
        ("rod-with-damper", ("decay.1", "damped.1", "critical.1")),  # where what dies out as the cosine and the sine solves
        ("disk-on-viscous-bearing", ("dissipation.D",)),  # a square times what is not negative
        ("cylinder-on-wedge", ("friction.N",)),  # below a force there is a difference that is positive
        ("leaning-sticks", ("friction.N",)),  # 1/cos - cos is sin²/cos
        ("ball-on-rod-against-cube", ("loss.K",)),  # what stands below the square of a speed moves
        ("four-bar-linkage", ("instant.second.C",)),  # a condition is differentiated twice, then seen at the start
        ("yo-yo-held-up", ("dependent.phi",)),  # the tied speed of a hand that is driven is a premise
        ("hexagonal-prism", ("linear.2", "equilibrium.2")),  # sin 150°; the arctangent of 1/√3 is π/6
        ("swinging-parallelogram", ("done.T.A.left",)),  # a work up to now, as long as the cosine has not vanished
    ],
)
def test_coqc_accepts_it(name: str, ids: tuple[str, ...]) -> None:
    whole = written(unsimulated(name), ids)
    told = compiled(Written(whole.source, {id: whole.lemmas[id] for id in ids}))
    assert not told.refused


def test_a_range_that_holds_from_the_start_on_makes_its_conclusion_hold_only_then() -> None:
    [lemma] = written(unsimulated("rod-tipping-over-edge")).lemmas["holds.N"]
    assert lemma.claim.given == (AHEAD,)
