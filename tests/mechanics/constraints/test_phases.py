"""Slipping that turns into rolling, blows, collisions, points suddenly held."""

import pytest

from rbpsym.errors import NotApplicable, StatementError
from rbpsym.field import atoms
from rbpsym.field.calculus import substitute
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.study import Study
from rbpsym.solve import results
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, check, stated, value

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


def test_a_phase_that_sample_numbers_do_not_reach():
    """With a coefficient that is large enough it would be: nothing says that it never is."""
    problem = stated(
        BALL + ", beta: angle",
        coordinates={"s": rb.coordinate(dimension="length", start="0", speed="v_0"), "phi": rb.coordinate(start="0")},
        bodies={"ball": rb.ball("R", mass="M", center=("s", "R"), angle="-phi")},
        interactions={"F": rb.force("ball.center", ("10*M*g", "0"))},
        constraints={"N": rb.touch("ball", "y = 0", coefficient="mu/100")},
        phases=ROLLING,
    )
    with pytest.raises(StatementError, match="not reached at any of the numbers that were tried: “N” does not stop slipping"):
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
    assert phase["time"] == "2*v_0/(7*mu*g)"


def thrown(at, event="reaches", of="y"):
    """A particle thrown upwards, and what ends its flight."""
    return stated(
        "m: mass, v_0: speed, h: length, g: acceleration",
        coordinates={"y": rb.coordinate(dimension="length", start="0", speed="v_0"), "x": {"dimension": "length"}},
        bodies={"stone": rb.particle(mass="m", center=("x", "y"))},
        constraints={"N": rb.contact("stone.center", "x = 0")},
        phases=[{"name": "there", "event": event, "of": of, "at": at}],
    )


def test_a_coordinate_reaches_a_value_in_uniform_motion():
    """Back on the ground after 2 v/g, with the speed it had; on its way down at -h: the later root."""
    _, second = stages(thrown("0"))
    assert_same(second.began.before.time, "2*v_0/g", second.study)
    assert_same(second.began.speeds["y"], "-v_0", second.study)
    _, second = stages(thrown("-h"))
    assert_same(second.began.before.time, "(v_0 + sqrt(v_0**2 + 2*g*h))/g", second.study)


def test_a_coordinate_reaches_a_value_with_a_first_integral():
    """A pendulum let go level: ω² = 3 g/ℓ below."""
    problem = stated(
        "M: mass, ell: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="pi/2", range=("-pi", "pi"))},
        bodies={"rod": rb.rod("ell", mass="M", start="O", angle="theta - pi/2")},
        constraints={"P": rb.pivot("rod.start")},
        phases=[{"name": "below", "event": "reaches", "of": "theta", "at": "0"}],
    )
    _, second = stages(problem)
    assert second.began.before.time is None
    assert_same(second.began.speeds["theta"] ** 2, "3*g/ell", second.study)


def test_a_value_that_is_never_reached():
    with pytest.raises(StatementError, match="never reached"):
        stages(thrown("10000*h + 1000*v_0**2/g"))


def test_static_friction_reaches_its_limit():
    """A rod laid over an edge slips where tan θ = μ ℓ²/(ℓ² + 36 b²); then kinetic friction takes over."""
    problem = stated(
        "M: mass, ell: length, b: length, mu: number, g: acceleration",
        coordinates={
            "theta": rb.coordinate(start="0", range=("0", "pi/2")),
            "s": rb.coordinate(dimension="length", start="0"),
        },
        bodies={"rod": rb.rod("ell", mass="M", center=("(b + s)*cos(theta)", "-(b + s)*sin(theta)"), angle="-theta")},
        constraints={
            "N": {"type": "sticking", "point": "O", "of": "rod", "line": "y = 0", "side": "negative", "limit": "mu"}
        },
        phases=[
            {
                "name": "slipping",
                "event": "slips",
                "of": "N",
                "constraints": {"N": {"type": "contact", "coefficient": "mu", "slip": "backward"}},
            }
        ],
    )
    _, second = stages(problem)
    assert_same(second.began.before.places["theta"], "atan(mu*ell**2/(ell**2 + 36*b**2))", second.study)
    assert second.study.system.independent == ("theta", "s")


def test_kinetic_friction_turns_into_static():
    """A block that slides to rest stays there: its friction is static and, on the level, nothing."""
    problem = stated(
        "m: mass, v_0: speed, mu: number, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0", speed="v_0")},
        bodies={"block": rb.particle(mass="m", center=("x", "0"))},
        constraints={"N": rb.contact("block.center", "y = 0", coefficient="mu")},
        phases=[{"name": "still", "event": "no slip", "of": "N", "constraints": {"N": {"type": "sticking"}}}],
    )
    _, second = stages(problem)
    assert_same(second.began.before.time, "v_0/(mu*g)", second.study)
    assert_same(second.began.before.places["x"], "v_0**2/(2*mu*g)", second.study)
    assert_same(second.study.dynamics.reactions["f_N"], "0", second.study)
    assert second.study.system.independent == ()


def test_energy_lost_holds_no_squared_root():
    problem = stated(
        "M: mass, m: mass, ell: length, e: number, g: acceleration",
        coordinates={
            "theta": rb.coordinate(start="pi/2", range=("-pi", "pi")),
            "x": rb.coordinate(dimension="length", start="0"),
        },
        bodies={
            "rod": rb.rod("ell", mass="M", start="O", angle="-pi/2 - theta"),
            "ball": rb.particle(mass="m", center=("x", "-ell")),
        },
        constraints={"P": rb.pivot("rod.start"), "N": rb.contact("ball.center", "y = -ell")},
        phases=[
            {
                "name": "hit",
                "event": "reaches",
                "of": "theta",
                "at": "0",
                "impulses": {
                    "J": {
                        "type": "collision",
                        "points": ["rod.end", "ball.center"],
                        "along": ["1", "0"],
                        "restitution": "e",
                    }
                },
            }
        ],
    )
    _, second = stages(problem)
    lost = second.began.energy_lost
    assert_same(lost, "(1 - e**2)*M*m*3*g*ell/(2*(M + 3*m))", second.study)
    assert not any(atoms.atom(i).kind == "root" for i in lost.atoms())


def test_slip_ends_where_a_spring_brings_it_to_rest():
    """A block on a spring, let go at x_0, slides back against μ m g and stops at -x_0 + 2 μ m g/k."""
    problem = stated(
        "m: mass, k: stiffness, mu: number, d: length, x_0: length, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="2*mu*m*g/k + x_0", range=("-d", ""))},
        bodies={"block": rb.particle(mass="m", center=("d + x", "0"))},
        interactions={"S": rb.spring(["O", "block.center"], "k", natural_length="d")},
        constraints={"N": rb.contact("block.center", "y = 0", coefficient="mu", slip="backward")},
        phases=[{"name": "still", "event": "no slip", "of": "N", "constraints": {"N": {"type": "sticking"}}}],
    )
    _, second = stages(problem)
    assert_same(second.began.before.places["x"], "-x_0", second.study)
    assert second.began.before.time is None


def test_one_of_two_supports_is_taken_away():
    """The other one then bears m g/4."""
    problem = stated(
        "m: mass, L: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0")},
        bodies={"beam": rb.rod("L", mass="m", start="O", angle="-theta")},
        constraints={"A": rb.pivot("beam.start"), "B": rb.contact("beam.end", "y = 0")},
        phases=[{"name": "released", "without": ["B"]}],
    )
    first, second = stages(problem)
    assert_same(first.study.dynamics.reactions["A_y"], "m*g/2", first.study)
    assert first.study.system.independent == ()
    still = {"theta": value("0", second.study), "theta_dot": value("0", second.study)}
    assert_same(substitute(second.study.dynamics.reactions["A_y"], still), "m*g/4", second.study)


def test_two_disks_meet_with_their_rims():
    """Of round bodies the centres will do: J = (1 + e) m M/(m + M) v along the line of centres."""
    problem = stated(
        "m: mass, M: mass, r: length, R: length, v: speed, e: number",
        coordinates={
            "x": rb.coordinate(dimension="length", start="0", speed="v"),
            "a": rb.coordinate(start="0"),
            "u": rb.coordinate(dimension="length", start="r + R"),
            "b": rb.coordinate(start="0"),
        },
        bodies={
            "one": rb.disk("r", mass="m", center=("x", "0"), angle="a"),
            "two": rb.disk("R", mass="M", center=("u", "0"), angle="b"),
        },
        phases=[
            {
                "name": "apart",
                "impulses": {
                    "J": {
                        "type": "collision",
                        "points": ["one.center", "two.center"],
                        "along": ["1", "0"],
                        "restitution": "e",
                    }
                },
            }
        ],
    )
    _, second = stages(problem)
    assert_same(second.began.impulses["J"], "(1 + e)*m*M/(m + M)*v", second.study)


def test_the_answer_says_which_phase_has_no_closed_form():
    """A ball that rolls off a sphere, pushed, slips where |f| = μ N, which has no closed form here: the rest is told."""
    problem = stated(
        "m: mass, a: length, R: length, mu: number, g: acceleration, omega_0: angular speed",
        coordinates={"theta": rb.coordinate(start="0", speed="omega_0", range=("0", "pi/2")), "phi": {}},
        bodies={"ball": rb.ball("a", mass="m", center=("(R + a)*sin(theta)", "(R + a)*cos(theta)"), angle="-phi")},
        constraints={
            "N": {"type": "rolling", "body": "ball", "circle": "O", "radius": "R", "side": "outside", "limit": "mu"}
        },
        phases=[
            {
                "name": "slipping",
                "event": "slips",
                "of": "N",
                "constraints": {"N": {"type": "touch", "coefficient": "mu", "slip": "forward"}},
            }
        ],
    )
    answer = results(Study(problem))
    assert answer["accelerations"]["theta"]
    assert answer["phases"] == [{"name": "slipping", "reason": "no closed form was found for the place where “N” slips"}]
