"""An energy is printed as half of a moment of inertia times the square of a speed."""

import pytest

from rbpsym.document.notes import notation_of
from rbpsym.typeset.text import to_text
from tests.library.derived import unsimulated

ENERGY = {
    "rod-and-disk-fixed": "½(mℓ²/3 + Mℓ² + MR²/2) ω²",
    "rod-and-disk-free": "¼MR² β² + ½(mℓ²/3 + Mℓ²) ω²",
    "sliding-ladder": "⅔Mℓ² ω²",
}


@pytest.mark.parametrize("name", ENERGY)
def test_kinetic_energy_is_half_an_inertia_times_a_square(name):
    derivation = unsimulated(name)
    kinetic = next(step for step in derivation.steps if step.id == "kinetic")
    said = to_text(kinetic.statement.items[-1], notation_of(derivation))
    assert said.replace(" ", "") == ENERGY[name].replace(" ", "")
