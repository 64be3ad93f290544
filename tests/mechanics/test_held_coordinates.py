"""A coordinate that the constraints hold in place: allowed where it is meant, a contradiction where it is not."""

import pytest

from rbpsym.errors import StatementError
from rbpsym.field.scalar import NOTHING, PI
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from tests.mechanics.constraints.closed_forms import check

CART = """
[parameters]
m = "mass"
w = "length: width"
h = "length: height"
g = "acceleration"
F = "force"

[coordinates.x]
dimension = "length"
[coordinates.y]
dimension = "length"
[coordinates.phi]
{phi}

[bodies.cart]
shape = "rectangle"
mass = "m"
width = "w"
height = "h"
center = ["x", "y"]
angle = "phi"

[interactions.W]
type = "gravity"
[interactions.P]
type = "force"
on = "cart.center"
force = ["F", "0"]

[constraints.N_1]
type = "contact"
point = "cart.bottom_left"
line = "y = 0"
[constraints.N_2]
type = "contact"
point = "cart.bottom_right"
line = "y = 0"
"""


@pytest.mark.parametrize(
    ("phi", "place"), [("", NOTHING), ('range = ["-1", "1"]', NOTHING), ('range = ["1", "4"]', PI)]
)
def test_two_contacts_hold_the_angle(phi: str, place) -> None:
    """w sin φ = 0: the zero in the range, the one nearest to 0 if there are several."""
    study = Study(load_text(CART.format(phi=phi)))
    assert study.system.independent == ("x",)
    assert study.system.dependent["phi"] == place
    assert str(study.dynamics.accelerations["x_ddot"]) == str(
        study.dynamics.forcing[0] / study.dynamics.mass_matrix[0][0]
    )


def test_normal_forces_of_the_cart() -> None:
    """Half the weight each, as the pull has no torque about the centre."""
    check(load_text(CART.format(phi="")), {"x_ddot": "F/m", "N_1": "m*g/2", "N_2": "m*g/2"})


@pytest.mark.parametrize("phi", ['start = "phi_0"', 'start = "1/2"', 'range = ["1", "2"]'])
def test_a_coordinate_that_should_move_is_a_contradiction(phi: str) -> None:
    with pytest.raises(StatementError, match=r"N_2.*contradicts the poses"):
        Study(load_text(CART.format(phi=phi))).system.independent
