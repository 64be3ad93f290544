"""Slipping that turns into rolling, blows, collisions, points suddenly held."""

import pytest

from rbpsym.errors import NotApplicable, StatementError
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study
from rbpsym.solve import results
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, check, stated

BALL = "M: mass, R: length, mu: number, g: acceleration"
ROLLING = [{"name": "rolling", "event": "no slip", "of": "N", "constraints": {"N": {"type": "rolling"}}}]


def slipping(speed="v_0", spin="0", more=""):
    return stated(
        f"{BALL}, {more}".rstrip(", "),
        coordinates={
            "x": rb.coordinate(dimension="length", start="0", speed=speed),
            "phi": rb.coordinate(start="0", speed=spin),
        },
        bodies={"ball": rb.ball("R", mass="M", center=("x", "R"), angle="-phi")},
        constraints={"N": rb.touch("ball", "y = 0", coefficient="mu")},
        phases=ROLLING,
    )


def test_ball_from_slipping_to_rolling():
    """Kleppner & Kolenkow, ch. 7: t = 2 v/(7 μ g), x = 12 v²/(49 μ g), v' = 5 v/7."""
    first, second = stages(slipping())
    began, study = second.began, second.study
    assert_same(began.before.time, "2*v_0/(7*mu*g)", study)
    assert_same(began.before.places["x"], "12*v_0**2/(49*mu*g)", study)
    assert_same(began.speeds["x"], "5*v_0/7", study)
    assert_same(began.speeds["phi"], "5*v_0/(7*R)", study)
    assert_same(began.energy_lost, "0", study)
    assert_same(study.dynamics.accelerations[f"{study.system.independent[0]}_ddot"], "0", study)
    for stage in (first, second):
        check(stage.study.problem, {})


def test_ball_with_backspin():
    """v' = (5 v - 2 R ω)/7."""
    _, second = stages(slipping("v", "-omega", "v: speed, omega: angular speed"))
    assert_same(second.began.speeds["x"], "(5*v - 2*R*omega)/7", second.study)


FREE_ROD = {
    "x": {"dimension": "length", "start": "0"},
    "y": {"dimension": "length", "start": "0"},
    "theta": {"start": "0"},
}


def test_centre_of_percussion():
    """A rod hinged at its end, struck at a distance b: the hinge feels J (3b/(2ℓ) - 1), nothing at b = 2ℓ/3."""
    problem = stated(
        "M: mass, ell: length, b: length, J: impulse, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0")},
        bodies={"rod": rb.rod("ell", mass="M", start="O", angle="theta - pi/2", points={"mark": ("b - ell/2", "0")})},
        constraints={"P": rb.pivot("rod.start")},
        phases=[{"name": "struck", "impulses": {"B": {"type": "blow", "on": "rod.mark", "impulse": ["J", "0"]}}}],
    )
    _, second = stages(problem)
    assert_same(second.began.speeds["theta"], "3*J*b/(M*ell**2)", second.study)
    assert_same(second.began.impulses["P_x"], "J*(3*b/(2*ell) - 1)", second.study)
    assert_same(second.study.squares["theta"], "(3*J*b/(M*ell**2))**2 - 3*g*(1 - cos(theta))/ell", second.study)


def test_ball_against_a_free_rod():
    """A ball of mass m hits a free rod at a distance b from its middle, with restitution e."""
    problem = stated(
        "m: mass, M: mass, ell: length, b: length, e: number",
        coordinates={**FREE_ROD, "s": rb.coordinate(dimension="length", start="0", speed="v_0")},
        bodies={
            "rod": rb.rod("ell", mass="M", center=("x", "y"), angle="theta + pi/2", points={"spot": ("b", "0")}),
            "ball": rb.particle(mass="m", center=("s", "b")),
        },
        constraints={"T": rb.contact("ball.center", "y = b")},
        phases=[
            {
                "name": "apart",
                "impulses": {
                    "J": {
                        "type": "collision",
                        "points": ["ball.center", "rod.spot"],
                        "along": ["1", "0"],
                        "restitution": "e",
                    }
                },
            }
        ],
    )
    _, second = stages(problem)
    expected = "(1 + e)*v_0/(1/m + 1/M + 12*b**2/(M*ell**2))"
    assert_same(second.began.impulses["J"], expected, second.study)
    assert_same(second.began.speeds["x"], f"{expected}/M", second.study)
    assert_same(second.began.energy_lost, "(1 - e**2)*v_0**2/2/(1/m + 1/M + 12*b**2/(M*ell**2))", second.study)


def test_end_suddenly_held():
    """A rod that spins about its middle is caught at one end: ω falls to a quarter."""
    problem = stated(
        "M: mass, a: length",
        coordinates={
            "x": {"dimension": "length", "start": "0"},
            "y": {"dimension": "length", "start": "0"},
            "theta": {"start": "0", "speed": "omega_0"},
        },
        bodies={"rod": rb.rod("2*a", mass="M", center=("x", "y"), angle="theta")},
        phases=[{"name": "caught", "constraints": {"P": {"type": "pivot", "point": "rod.start", "at": ["-a", "0"]}}}],
    )
    _, second = stages(problem)
    assert_same(second.began.speeds["theta"], "omega_0/4", second.study)
    assert_same(second.began.impulses["P_y"], "M*a*omega_0/4", second.study)
    assert_same(second.began.energy_lost, "M*a**2*omega_0**2/8", second.study)


def test_particle_that_leaves_a_sphere():
    problem = stated(
        "m: mass, R: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", range=("0", "pi/2")), "r": rb.coordinate(dimension="length")},
        bodies={"bead": rb.particle(mass="m", center=("r*sin(theta)", "r*cos(theta)"))},
        constraints={"N": rb.contact("bead.center", circle="O", radius="R", side="outside")},
        phases=[{"name": "flight", "event": "lost", "of": "N", "without": ["N"]}],
    )
    _, second = stages(problem)
    began, study = second.began, second.study
    assert_same(began.before.places["theta"], "acos(2/3)", study)
    assert_same(began.speeds["theta"] ** 2, "2*g/(3*R)", study)
    assert study.system.independent == ("theta", "r")


def test_a_phase_that_is_never_reached():
    problem = stated(
        BALL + ", beta: angle",
        coordinates={"s": rb.coordinate(dimension="length", start="0", speed="v_0"), "phi": rb.coordinate(start="0")},
        bodies={"ball": rb.ball("R", mass="M", center=("s", "R"), angle="-phi")},
        interactions={"F": rb.force("ball.center", ("10*M*g", "0"))},
        constraints={"N": rb.touch("ball", "y = 0", coefficient="mu/100")},
        phases=ROLLING,
    )
    with pytest.raises(StatementError, match="never reached"):
        stages(problem)


def test_an_end_without_a_closed_form():
    problem = stated(
        "M: mass, R: length, r: length, mu: number, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", speed="omega_0"), "phi": rb.coordinate(start="0")},
        bodies={"ball": rb.ball("r", mass="M", center=("(R - r)*sin(theta)", "-(R - r)*cos(theta)"), angle="phi")},
        constraints={"N": rb.touch("ball", circle="O", radius="R", side="inside", coefficient="mu")},
        phases=ROLLING,
    )
    with pytest.raises(NotApplicable, match="no closed form"):
        stages(problem)


def test_ball_against_a_hinged_rod():
    """A ball that sticks (e = 0) to a hinged rod at a distance b: ω = m v b/(M ℓ²/3 + m b²)."""
    problem = stated(
        "m: mass, M: mass, ell: length, b: length, v: speed, g: acceleration",
        coordinates={
            "theta": rb.coordinate(start="0"),
            "s": rb.coordinate(dimension="length", start="0", speed="v"),
            "h": rb.coordinate(dimension="length", start="0"),
        },
        bodies={
            "rod": rb.rod("ell", mass="M", start="O", angle="theta - pi/2", points={"spot": ("b - ell/2", "0")}),
            "ball": rb.particle(mass="m", center=("s", "h - b")),
        },
        constraints={"P": rb.pivot("rod.start")},
        phases=[
            {
                "name": "after",
                "impulses": {
                    "J": {
                        "type": "collision",
                        "points": ["ball.center", "rod.spot"],
                        "along": ["1", "0"],
                        "restitution": "0",
                    }
                },
            }
        ],
    )
    _, second = stages(problem)
    omega = "m*v*b/(M*ell**2/3 + m*b**2)"
    assert_same(second.began.speeds["theta"], omega, second.study)
    assert_same(second.began.speeds["s"], f"b*{omega}", second.study)


def test_phases_in_the_answer():
    """`rbpsym solve --json` tells how each phase begins."""
    [phase] = results(Study(slipping()))["phases"]
    assert phase["name"] == "rolling"
    assert phase["time"] == "2*v_0/(7*g*mu)"
