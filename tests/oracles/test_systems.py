"""Systems of every kind of element, put to both oracles: loops, dampers, body-fixed forces, redundant angles."""

import pytest

from benchmarks.chains import statement
from rbpsym.decide.verdict import PROVED
from rbpsym.mechanics.study import Study
from rbpsym.oracles.lagrange import lagrange_verdict
from rbpsym.oracles.simulation import Derived, known_works, simulate
from rbpsym.statement.loader import load_problem

PARAMETERS = """
[parameters]
m = "mass"
M = "mass"
ell = "length"
L = "length"
R = "length"
g = "acceleration"
k = "stiffness"
kappa = "torsion stiffness"
c = "damping"
b = "rotary damping"
F_0 = "force"
tau_0 = "torque"
beta = "angle"
"""

# text, degrees of freedom
SYSTEMS = {
    "cart in three coordinates, its angle held at zero by two contacts": (
        """
[coordinates.x]
dimension = "length"
[coordinates.y]
dimension = "length"
[coordinates.phi]
[coordinates.theta]
[bodies.cart]
shape = "rectangle"
mass = "M"
width = "L"
height = "R"
center = ["x", "y"]
angle = "phi"
[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
angle = "theta - pi/2"
[interactions.W]
type = "gravity"
[constraints.N_1]
type = "contact"
point = "cart.bottom_left"
line = "y = 0"
[constraints.N_2]
type = "contact"
point = "cart.bottom_right"
line = "y = 0"
[constraints.B]
type = "pin"
points = ["cart.center", "rod.start"]
""",
        2,
    ),
    "crank, link and piston: a closed loop, driven by a couple": (
        """
[coordinates.a]
start = "a_0"
speed = "omega_0"
[coordinates.x]
dimension = "length"
[bodies.crank]
shape = "rod"
mass = "m"
length = "ell"
start = "O"
angle = "a"
[coordinates.b1]
[bodies.link]
shape = "rod"
mass = "M"
length = "3*ell"
angle = "b1"
[bodies.piston]
shape = "particle"
mass = "M"
center = ["x", "0"]
[constraints.A]
type = "pivot"
point = "crank.start"
[constraints.B]
type = "pin"
points = ["crank.end", "link.start"]
[constraints.C]
type = "pin"
points = ["link.end", "piston.center"]
[constraints.N]
type = "contact"
point = "piston.center"
line = "y = 0"
[interactions.T]
type = "couple"
on = "crank"
couple = "tau_0"
""",
        1,
    ),
    "rod and slider with damper, rotary damper, spring and a force fixed in the rod": (
        """
[coordinates.theta]
start = "theta_0"
speed = "0"
[coordinates.x]
dimension = "length"
start = "L"
speed = "0"
[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
start = "O"
angle = "theta"
[bodies.bob]
shape = "particle"
mass = "M"
center = ["L + x", "-2*L"]
[interactions.W]
type = "gravity"
bodies = ["rod"]
[interactions.D]
type = "damper"
between = ["rod.end", "bob.center"]
coefficient = "c"
[interactions.E]
type = "rotary-damper"
between = ["ground", "rod"]
coefficient = "b"
[interactions.S]
type = "spring"
between = ["rod.center", "bob.center"]
stiffness = "k"
natural_length = "L/3"
[interactions.P]
type = "force"
on = "rod.end"
force = ["F_0*cos(theta)", "F_0"]
frame = "body"
[constraints.A]
type = "pivot"
point = "rod.start"
[constraints.N]
type = "contact"
point = "bob.center"
line = "y = -2*L"
""",
        2,
    ),
    "two rods welded at an angle, a bob pinned on, a torsion spring": (
        """
[coordinates.theta]
start = "theta_0"
speed = "omega_0"
[bodies.one]
shape = "rod"
mass = "m"
length = "ell"
start = "O"
angle = "theta"
[bodies.two]
shape = "rod"
mass = "M"
length = "L"
[bodies.bob]
shape = "particle"
mass = "M"
[interactions.W]
type = "gravity"
[interactions.K]
type = "torsion-spring"
between = ["ground", "one"]
stiffness = "kappa"
rest_angle = "pi/6"
[constraints.A]
type = "pivot"
point = "one.start"
[constraints.B]
type = "weld"
points = ["one.end", "two.start"]
angle = "pi/3"
[constraints.C]
type = "pin"
points = ["two.end", "bob.center"]
""",
        1,
    ),
    "block on an inclined line with a spring": (
        """
[coordinates.s]
dimension = "length"
start = "s_0"
speed = "0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["s*cos(beta)", "-s*sin(beta)"]
[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
natural_length = "L"
[constraints.N]
type = "contact"
point = "block.center"
line = "x*sin(beta) + y*cos(beta) = 0"
""",
        1,
    ),
    "triangle in the air, forces that depend on speeds": (
        """
[coordinates.x]
dimension = "length"
start = "0"
speed = "v_0"
[coordinates.y]
dimension = "length"
start = "0"
speed = "0"
[coordinates.phi]
start = "0"
speed = "omega_0"
[bodies.plate]
shape = "triangle"
base = "L"
height = "ell"
offset = "L/5"
mass = "m"
cm = ["x", "y"]
angle = "phi"
[interactions.W]
type = "gravity"
direction = ["sin(beta)", "-cos(beta)"]
[interactions.P]
type = "force"
on = "plate.top"
force = ["F_0", "-c*x_dot"]
[interactions.Q]
type = "couple"
on = "plate"
couple = "tau_0*sin(phi) - b*phi_dot"
""",
        3,
    ),
    "rod hung from a built-in beam": (
        """
[coordinates.theta]
[bodies.bob]
shape = "rod"
mass = "M"
length = "ell"
angle = "theta"
[bodies.beam]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "beta"
[interactions.W]
type = "gravity"
[constraints.A]
type = "weld"
points = ["O", "beam.start"]
[constraints.B]
type = "pin"
points = ["beam.end", "bob.start"]
""",
        1,
    ),
}


def studied(text: str) -> Study:
    return Study(load_problem(PARAMETERS + text))


def complaints(study: Study, freedom: int) -> list[str]:
    """What the oracles do not confirm."""
    verdict = lagrange_verdict(study.system, study.dynamics, study.assumptions)
    along = study.reactions_along_motion or {}
    works = known_works(study.works)
    report = simulate(Derived(study.system, study.dynamics, study.first_integral, study.squares, along, works))
    wrong = [] if verdict.kind is PROVED else [f"Lagrange: {verdict}"]
    wrong += [f"{name}: {error}" for name, error in report.errors.items() if not error <= 1e-8]
    wrong += [f"drift: {report.drift}"] if report.drift is not None and not report.drift <= 1e-8 else []
    return wrong + ([f"{report.freedom} degrees of freedom"] if report.freedom != freedom else [])


@pytest.mark.parametrize("name", SYSTEMS)
def test_oracles_agree(name: str) -> None:
    text, freedom = SYSTEMS[name]
    study = studied(text)
    assert len(study.system.independent) == freedom
    assert not complaints(study, freedom)


def test_a_chain_too_long_for_formulas() -> None:
    """Where M q̈ = f stays unsolved, Lagrange's equations are compared row by row, and det M is not zero."""
    study = Study(load_problem(statement(5)))
    assert study.dynamics.accelerations is None
    assert lagrange_verdict(study.system, study.dynamics).kind is PROVED
    report = simulate(Derived(study.system, study.dynamics, study.first_integral))
    assert report.max_relative_error <= 1e-8
    assert report.freedom == 5


def test_works_are_compared() -> None:
    """A work that is wrong by a factor is seen."""
    from dataclasses import replace

    from rbpsym.statement.library import problem_files

    study = Study(load_problem(next(iter(problem_files().values()))))
    doubled = [replace(w, translational=replace(w.translational, value=w.translational.value * 2)) for w in study.works]
    fine = simulate(Derived(study.system, study.dynamics, works=known_works(study.works)))
    assert fine.max_relative_error <= 1e-8
    assert any(error.startswith("work") for error in fine.errors)
    assert simulate(Derived(study.system, study.dynamics, works=known_works(doubled))).max_relative_error > 0.1
