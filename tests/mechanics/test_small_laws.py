"""Small parts of mechanics, each by what it states: what is joined, what slips, what does no work, what is left of speeds."""

from fractions import Fraction
from types import SimpleNamespace as Told

import pytest

from rbpsym.chapters.methods import known_works
from rbpsym.decide.assumptions import Assumptions
from rbpsym.elements.constraints.weld.law import _angles
from rbpsym.errors import LimitError
from rbpsym.expr import tree as t
from rbpsym.field.calculus import root
from rbpsym.field.normal import is_zero, same
from rbpsym.field.scalar import NOTHING, UNITY, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import cartesian
from rbpsym.mechanics import oscillation
from rbpsym.mechanics.contacts import slip_speed
from rbpsym.mechanics.dynamics import LARGEST_TRIED, _solved_block
from rbpsym.mechanics.energy import effective_potential
from rbpsym.mechanics.forms import AccelerationForm
from rbpsym.mechanics.motion import from_integral
from rbpsym.mechanics.numbers import NoNumber, number
from rbpsym.mechanics.placing import _join_angle
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.solved import _terminal
from rbpsym.mechanics.study import Study
from rbpsym.proof.checks.of_steps import _by_equations_of_motion
from rbpsym.proof.checks.stability import _along
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import PointRef
from tests.library.derived import NAMES, problem

m, g, x, y, u, v = (symbol(name) for name in ("m", "g", "x", "y", "x_dot", "y_dot"))


@pytest.mark.parametrize("name", NAMES[::6])
def test_what_is_defined_are_the_coordinates_and_speeds_that_are_not_independent(name):
    system = Study(problem(name)).system
    tied = {*system.coordinates, *system.dependent} - {*system.independent}
    assert {n for n in system.defined if n.endswith("_dot")} == {f"{n}_dot" for n in tied}
    assert system.defined.keys() - {f"{n}_dot" for n in tied} == system.dependent.keys()


def test_a_support_that_is_driven_does_work_though_its_force_is_ideal():
    driven = Study(problem("pendulum-on-oscillating-support"))
    found = driven.dynamics
    assert any(ideal and not found.workless[name] for name, ideal in found.ideal.items())
    still = Study(problem("sliding-ladder")).dynamics
    assert still.workless == still.ideal and all(still.ideal.values())


def test_the_slip_is_the_speed_of_one_body_over_the_other():
    speeds = {"block": cartesian(u, v), "plank": cartesian(symbol("w"), NOTHING)}
    geometry = Told(velocity=lambda body, place: speeds[body])
    for forward, slip in ((cartesian(UNITY, NOTHING), u - symbol("w")), (cartesian(NOTHING, UNITY), v)):
        met = Told(on="block", by="plank", place=None, forward=forward)
        assert same(slip_speed(geometry, met), slip)


@pytest.mark.parametrize("known", ["first", "second"])
def test_joined_angles_differ_by_the_offset_of_the_joint(known):
    angles, join = {known: symbol("phi")}, Told(first="first", second="second", offset=symbol("beta"))
    assert _join_angle(join, angles) and not _join_angle(join, angles)
    assert same(angles["second"] - angles["first"], symbol("beta"))


def test_a_speed_that_is_known_leaves_the_first_integral():
    """½ m (ẋ² + ẏ²) + m g y with ẋ² = w, which is known."""
    system = Told(scope=Told(start={"x": NOTHING, "y": NOTHING, "x_dot": symbol("c"), "y_dot": NOTHING}), coordinates=("x", "y"))
    energy = m * (u * u + v * v) / 2 + m * g * y
    found = from_integral(system, energy, "y", {"x": symbol("c") ** 2})
    assert same(found, -2 * g * y)


def test_a_resistance_has_no_potential():
    system = Told(independent=("x",), speeds=("x_dot",), implicit=())
    for force, potential in ((-m * g, m * g * x), (-m * g - symbol("b") * u, None), (-m * g * symbol("t"), None)):
        dynamics = Told(ideal={}, forcing=(force,), mass_matrix=((m,),))
        found = effective_potential(system, dynamics)
        assert (found is None) if potential is None else same(found, potential)


@pytest.mark.parametrize("twist", [1, 2])
def test_forces_along_several_coordinates_have_a_potential_where_they_are_its_slopes(twist):
    """Q_x = -k y, Q_y = -k x come from k x y; Q_y = -2 k x goes round and has none. In polar places the inertia takes no part."""
    x, y, k = symbol("x"), symbol("y"), symbol("k")
    system = Told(independent=("x", "y"), speeds=("x_dot", "y_dot"), implicit=())
    forces = (-k * y + m * x * v * v, -k * x * twist - m * x * u * v * 2)
    dynamics = Told(ideal={}, forcing=forces, mass_matrix=((m, NOTHING), (NOTHING, m * x * x)))
    found = effective_potential(system, dynamics)
    assert same(found, k * x * y) if twist == 1 else found is None


def is_real(place) -> bool:
    try:
        number(place, {})
    except NoNumber:
        return False
    return True


@pytest.mark.parametrize("constant", [Fraction(-5, 2), Fraction(-9, 4), -2, Fraction(-7, 2)])
def test_zeros_where_both_waves_stand_in_squares(constant):
    """3 cos² θ + 2 sin² θ + 2 cos θ + c = (cos θ + 1)² + 1 + c, and the same with the waves exchanged."""
    theta = symbol("theta")
    for first, second in ((cosine(theta), sine(theta)), (sine(theta), cosine(theta))):
        value = 3 * first**2 + 2 * second**2 + 2 * first + constant
        seen = [number(place, {}) for place in zeros(value, "theta") if is_real(place)]
        assert len({round(place, 9) for place in seen}) == 2
        assert all(abs(number(value, {"theta": place})) < 1e-9 for place in seen)


PINNED = """
[parameters]
M = "mass"
ell = "length"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
[coordinates.phi]
start = "phi_0"
[bodies.upper]
shape = "rod"
mass = "M"
length = "ell"
start = "O"
angle = "theta - pi/2"
[bodies.lower]
shape = "rod"
mass = "M"
length = "ell"
angle = "phi - pi/2"
{place}
[interactions.W]
type = "gravity"
[constraints.A]
type = "pivot"
point = "upper.start"
[constraints.B]
type = "pin"
points = ["upper.end", "lower.start"]
"""


def test_a_body_is_where_its_pin_is():
    silent, said = (
        Study(load_text(PINNED.format(place=place))).system.bodies["lower"].center
        for place in ("", 'start = ["ell*sin(theta)", "-ell*cos(theta)"]')
    )
    assert is_zero((silent - said).x) and is_zero((silent - said).y)


def test_where_a_determinant_is_too_long_nothing_is_said_of_its_factors(monkeypatch):
    def too_long(matrix):
        raise LimitError("too long")

    monkeypatch.setattr(oscillation, "determinant", too_long)
    assert oscillation._factors(((m,),), ((NOTHING,),), ((g,),), None) == ((), 0)


def test_at_the_terminal_speed_the_resistance_balances_what_is_constant():
    b, c = symbol("b"), symbol("c")
    for damping, drag, speed in ((b, NOTHING, g / b), (NOTHING, c, root(g / c)), (NOTHING, NOTHING, None)):
        known = Told(form=AccelerationForm(g, NOTHING, damping, drag), root=root, sense=lambda value: 1)
        found = _terminal(known)
        assert found is None if speed is None else same(found, speed)
        assert _terminal(Told(form=AccelerationForm(g, m, damping, drag), root=root, sense=lambda value: 1)) is None


def test_a_weld_turns_the_second_against_the_first():
    beta, rod, ground = t.Sym("beta"), PointRef("rod.start", "rod", "start"), PointRef("O", at=(t.ZERO, t.ZERO))
    for points, angle in (((ground, rod), symbol("beta")), ((rod, ground), -symbol("beta"))):
        [join], known = _angles({"points": points, "angle": beta}), {}
        assert _join_angle(join, known) and same(known["rod"], angle)


def tied_system():
    """θ is independent, and x = R θ is tied to it."""
    speed = symbol("theta_dot")
    rates = {"theta": speed, "x": symbol("R") * speed}
    scope = Told(rates=rates, start={})
    return Told(scope=scope, coordinates=("theta", "x"), independent=("theta",), speeds=("theta_dot",))


def test_a_force_has_its_slope_through_what_is_tied():
    k, c, theta = symbol("k"), symbol("c"), symbol("theta")
    force, system = -k * x - c * theta, tied_system()
    slope = c + k * symbol("R")
    assert same(_along(Told(study=Told(system=system)), force, "theta_dot"), -slope)
    dynamics = Told(forcing=(force,), mass_matrix=((m,),))
    found = oscillation.linearized(system, dynamics, Assumptions(dict.fromkeys("kcRm", "positive"), {}), lambda value: value)
    assert same(found.stiffness[0][0], slope) and found.tied == {"x": (symbol("R"),)}


@pytest.mark.parametrize("sign", [1, -1])
def test_an_equation_of_motion_and_nothing_else_follows_from_those_that_are_not_solved(sign):
    rows, power = (m * symbol("x_ddot") + x, m * symbol("y_ddot") - y), (u * x,)
    context = Told(study=Told(motion_rows=rows, power_balance=power[0]))
    assert all(_by_equations_of_motion(context, row * sign).is_proved for row in (*rows, *power))
    assert not any(_by_equations_of_motion(context, row * sign + x).is_proved for row in (*rows, *power))


@pytest.mark.parametrize("begun", [True, False])
def test_where_no_start_is_said_a_change_is(begun, monkeypatch):
    monkeypatch.setattr(known_works, "started", lambda draft: begun)
    monkeypatch.setattr(known_works, "moment_about", lambda draft, label: t.Sym("I_O"))
    monkeypatch.setattr(known_works, "at_start", lambda value, scope: NOTHING)
    system = Told(bodies={"rod": Told(omega=symbol("omega"))}, scope=None)
    grown = known_works._growth(Told(study=Told(system=system), show=lambda value: t.Sym("shown")), "O")
    assert isinstance(grown, t.Delta) is not begun


def test_coupled_coordinates_are_solved_for_up_to_a_number():
    for size in range(1, LARGEST_TRIED + 1):
        rows = tuple(tuple(m if i == j else UNITY for j in range(size)) for i in range(size))
        assert all(same(value, g / (m + size - 1)) for value in _solved_block(rows, [g] * size))
    more = LARGEST_TRIED + 1
    assert _solved_block(((UNITY,) * more,) * more, [g] * more) is None


ROLLED_BY = """
[parameters]
M = "mass"
R = "length"
k = "stiffness"
[coordinates]
x = { dimension = "length" }
phi = {}
[bodies.disk]
shape = "disk"
mass = "M"
radius = "R"
center = ["x", "R"]
angle = "-phi"
[interactions.P]
type = "force"
on = "disk.center"
force = ["FORCE", "0"]
[constraints.N]
type = "rolling"
body = "disk"
line = "y = 0"
"""


@pytest.mark.parametrize("force", ["-k*x", "-k*R*phi", "-k*(x + R*phi)/2"])
def test_a_force_is_one_of_what_is_free_however_it_is_stated(force):
    study = Study(load_text(ROLLED_BY.replace("FORCE", force)))
    assert same(study.dynamics.accelerations["phi_ddot"], symbol("k") * symbol("phi") * -2 / (symbol("M") * 3))
