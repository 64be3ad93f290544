"""The ledger keeps a force and a couple apart: each is an entry, with its torque about cm and its works for itself."""

import pytest

from rbpsym.derive import derive
from rbpsym.field.normal import is_zero
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.solve import solve
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from tests.library.derived import derived


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_no_entry_is_both(name: str) -> None:
    for force in derived(name).study.system.forces:
        assert not (force.vector and force.couple), force


def test_the_force_of_a_weld_at_the_centre_has_no_torque_there() -> None:
    """Rod and fixed disk: N acts at the centre of the disk; what turns the disk is the couple."""
    study = derived("rod-and-disk-fixed").study
    disk = study.system.bodies["disk"]
    torques = {f.name: torque_about_center(f, disk) for f in study.system.on("disk")}
    assert is_zero(torques["N"])
    assert not is_zero(torques["tau"])
    works = {(item.force, item.on): item for item in study.works}
    assert not works["N", "disk"].rotational.parts
    assert not works["tau", "disk"].translational.parts
    assert works["tau", "disk"].rotational.parts
    assert study.dynamics.workless == {"F": True, "N": True, "tau": True}


def test_in_the_answer_for_machines() -> None:
    found = solve(load_problem(problem_files()["rod-and-disk-fixed"]), simulation=False)
    assert found["forces"]["N"]["disk"] == {"x": "N_x", "y": "N_y", "couple": "0", "torque_about_center": "0"}
    assert found["forces"]["tau"]["rod"] == {"x": "0", "y": "0", "couple": "-tau", "torque_about_center": "-tau"}
    assert found["works"]["N"]["disk"]["rotational"] == {"integrand": "0", "value": "0"}
    assert found["works"]["tau"]["disk"]["rotational"]["integrand"] == "tau"


MOTOR = """
title = "A motor winds up a load"
[parameters]
m = "mass"
M = "mass"
R = "length"
tau = "torque"
omega_m = "angular speed"
g = "acceleration"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.phi]
[bodies.drum]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "phi"
[bodies.load]
shape = "rod"
mass = "m"
length = "R"
center = ["R", "x"]
angle = "pi/2"
[interactions.W]
type = "gravity"
[interactions.T]
type = "couple"
on = "drum"
couple = "tau*(1 - phi_dot/omega_m)"
[constraints.P]
type = "pivot"
point = "drum.center"
[constraints.S]
type = "slider"
point = "load.center"
line = "x = R"
[constraints.F]
type = "gear"
body = "drum"
line = "y = 0"
of = "load"
"""


@pytest.mark.parametrize("couple", ["tau*(1 - phi_dot/omega_m)", "tau*cos(phi)"])
def test_what_depends_on_a_coordinate_that_follows_is_no_constant(couple: str) -> None:
    """The angle follows from the height; a couple that is a function of it, or of its rate, has no energy -τφ."""
    found = derive(load_text(MOTOR.replace("tau*(1 - phi_dot/omega_m)", couple)))
    assert not [step.id for step in found.all_steps if not step.certificate.verdict.is_proved]
