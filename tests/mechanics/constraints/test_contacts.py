"""Contacts of points and round bodies with lines and circles, guides, corners."""

import pytest

from rbpsym.field.normal import is_zero
from rbpsym.mechanics.study import Study
from rbpsym.statement import build as rb
from rbpsym.statement.loader import load_text
from tests.mechanics.constraints.closed_forms import assert_same, check, stated, work_of

BEAD = "m: mass, R: length, g: acceleration"


def test_particle_off_a_sphere():
    """Leaves at cos θ = 2/3."""
    problem = stated(
        BEAD,
        coordinates={"theta": rb.coordinate(start="0", range=("0", "pi/2"))},
        bodies={"bead": rb.particle(mass="m", center=("R*sin(theta)", "R*cos(theta)"))},
        constraints={"N": rb.contact("bead.center", circle="O", radius="R", side="outside")},
    )
    study = check(problem, {"theta_ddot": "g*sin(theta)/R", "N": "m*g*cos(theta) - m*R*theta_dot**2"})
    [loss] = study.losses
    assert_same(loss.at["theta"], "acos(2/3)", study)


def test_particle_in_a_bowl():
    problem = stated(
        BEAD,
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        bodies={"bead": rb.particle(mass="m", center=("R*sin(theta)", "-R*cos(theta)"))},
        constraints={"N": rb.contact("bead.center", circle="O", radius="R", side="inside")},
    )
    check(problem, {"theta_ddot": "-g*sin(theta)/R", "N": "m*g*cos(theta) + m*R*theta_dot**2"})


def test_bead_on_a_turning_hoop():
    """A bead on a smooth hoop that hangs from a point of its rim."""
    problem = stated(
        "m: mass, M: mass, R: length, g: acceleration",
        coordinates={"phi": rb.coordinate(start="phi_0"), "theta": rb.coordinate(start="theta_0")},
        bodies={
            "hoop": rb.ring(
                "R", mass="M", center=("R*sin(phi)", "-R*cos(phi)"), angle="phi", points={"top": ("0", "R")}
            ),
            "bead": rb.particle(mass="m", center=("R*sin(phi) + R*sin(theta)", "-R*cos(phi) - R*cos(theta)")),
        },
        constraints={"P": rb.pivot("hoop.top"), "N": rb.guide("bead.center", circle="hoop.center")},
    )
    study = check(problem, {})
    assert study.dynamics.workless["N"]


def test_smooth_ball_in_a_bowl_does_not_turn():
    problem = stated(
        "M: mass, R: length, r: length, g: acceleration",
        coordinates={
            "theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2")),
            "phi": rb.coordinate(start="0", speed="omega_0"),
        },
        bodies={"ball": rb.ball("r", mass="M", center=("(R - r)*sin(theta)", "-(R - r)*cos(theta)"), angle="phi")},
        constraints={"N": rb.touch("ball", circle="O", radius="R", side="inside")},
    )
    check(problem, {"theta_ddot": "-g*sin(theta)/(R - r)", "phi_ddot": "0"})


def test_rod_over_a_corner():
    """A rod whose foot slides on a wall x = 0 while it leans on the corner (a, 0)."""
    problem = stated(
        "M: mass, ell: length, a: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("pi/6", "pi/3"))},
        points={"Q": ("a", "0")},
        bodies={"rod": rb.rod("2*ell", mass="M", start=("0", "-a*tan(theta)"), angle="theta")},
        constraints={
            "N_w": rb.contact("rod.start", "x = 0"),
            "N_c": rb.contact("Q", "y = 0", of="rod"),
        },
    )
    study = check(problem, {})
    force = next(f for f in study.system.forces if f.name == "N_c")
    assert force.on == "rod" and study.dynamics.workless == {"N_w": True, "N_c": True}


def test_bead_on_a_swinging_rod():
    """A bead that slides on a hinged rod: r'' = r θ'² + g cos θ (θ from the downward vertical)."""
    problem = stated(
        "m: mass, M: mass, ell: length, g: acceleration",
        coordinates={
            "theta": rb.coordinate(start="theta_0", range=("0", "pi/2")),
            "r": rb.coordinate(dimension="length", start="r_0", range=("0", "ell")),
        },
        bodies={
            "rod": rb.rod("ell", mass="M", start="O", angle="theta - pi/2"),
            "bead": rb.particle(mass="m", center=("r*sin(theta)", "-r*cos(theta)")),
        },
        constraints={"P": rb.pivot("rod.start"), "N": rb.guide("bead.center", "y = 0", of="rod")},
    )
    check(
        problem,
        {
            "r_ddot": "r*theta_dot**2 + g*cos(theta)",
            "theta_ddot": "-(2*m*r*r_dot*theta_dot + (M*ell/2 + m*r)*g*sin(theta))/(M*ell**2/3 + m*r**2)",
        },
    )


def test_rod_in_a_bowl():
    """Both ends on a smooth bowl: with d the distance of the rod from the middle, ω² = g d/(ℓ²/3 + d²)."""
    problem = stated(
        "M: mass, a: length, d: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        bodies={"rod": rb.rod("2*a", mass="M", center=("d*sin(theta)", "-d*cos(theta)"), angle="theta")},
        constraints={
            "N_1": rb.contact("rod.start", circle="O", radius="sqrt(a**2 + d**2)", side="inside"),
            "N_2": rb.contact("rod.end", circle="O", radius="sqrt(a**2 + d**2)", side="inside"),
        },
    )
    check(problem, {"theta_ddot": "-g*d*sin(theta)/(d**2 + a**2/3)"})


def test_block_on_a_sliding_wedge():
    """A particle on a wedge that recoils: X'' = m g sin β cos β/(M + m sin² β)."""
    problem = stated(
        "m: mass, M: mass, b: length, beta: angle, g: acceleration",
        coordinates={
            "X": rb.coordinate(dimension="length", start="0"),
            "s": rb.coordinate(dimension="length", start="0"),
        },
        bodies={
            "wedge": {
                "shape": "rectangle",
                "width": "b",
                "height": "b",
                "mass": "M",
                "center": ("X", "0"),
                "angle": "0",
            },
            "block": rb.particle(mass="m", center=("X + s*cos(beta)", "-s*sin(beta)")),
        },
        constraints={
            "S": rb.slider("wedge.center", "y = 0"),
            "N": rb.contact("block.center", "y = -x*tan(beta)", of="wedge"),
        },
    )
    study = check(
        problem,
        {
            "X_ddot": "-m*g*sin(beta)*cos(beta)/(M + m*sin(beta)**2)",
            "s_ddot": "(M + m)*g*sin(beta)/(M + m*sin(beta)**2)",
            "N": "M*m*g*cos(beta)/(M + m*sin(beta)**2)",
        },
    )
    assert study.dynamics.workless == {"S": True, "tau_S": True, "N": True}


def test_ladder_on_a_rough_floor_sticks():
    """A rod that falls about its foot on rough ground; the friction that holds it."""
    problem = stated(
        "M: mass, ell: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("0", "pi/2"))},
        bodies={"rod": rb.rod("2*ell", mass="M", start="O", angle="pi/2 - theta")},
        constraints={"N": rb.sticking("rod.start", "y = 0")},
    )
    check(
        problem,
        {
            "theta_ddot": "3*g*sin(theta)/(4*ell)",
            "f_N": "M*(3*g*sin(theta)*cos(theta)/4 - ell*theta_dot**2*sin(theta))",
        },
    )


def test_sliding_friction_on_an_incline():
    problem = stated(
        "m: mass, mu: number, beta: angle, g: acceleration",
        coordinates={"s": rb.coordinate(dimension="length", start="0", speed="v_0")},
        bodies={"block": rb.particle(mass="m", center=("s*cos(beta)", "-s*sin(beta)"))},
        constraints={"N": rb.contact("block.center", "y = -x*tan(beta)", coefficient="mu")},
    )
    study = check(problem, {"s_ddot": "g*sin(beta) - mu*g*cos(beta)", "N": "m*g*cos(beta)"})
    assert study.dynamics.workless == {"N": True, "f_N": False}
    along, _ = work_of(study, "f_N", "block")
    assert_same(along, "-mu*m*g*s*cos(beta)", study)


def test_ball_that_slips():
    """A ball set down sliding: v' = -μ g, ω' = 5 μ g/(2 R)."""
    problem = stated(
        "M: mass, R: length, mu: number, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0", speed="v_0"), "phi": rb.coordinate(start="0")},
        bodies={"ball": rb.ball("R", mass="M", center=("x", "R"), angle="-phi")},
        constraints={"N": rb.touch("ball", "y = 0", coefficient="mu", slip="forward")},
    )
    check(problem, {"x_ddot": "-mu*g", "phi_ddot": "5*mu*g/(2*R)", "N": "M*g"})


def test_ladder_with_friction_at_both_ends():
    """Kinetic friction on floor and wall: the normal forces depend on the acceleration."""
    problem = stated(
        "M: mass, ell: length, mu: number, nu: number, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("0", "pi/2"))},
        bodies={"ladder": rb.rod("2*ell", mass="M", center=("ell*cos(theta)", "ell*sin(theta)"), angle="pi - theta")},
        constraints={
            "N_w": rb.contact("ladder.end", "x = 0", coefficient="nu", slip="forward"),
            "N_f": rb.contact("ladder.start", "y = 0", coefficient="mu", slip="forward"),
        },
    )
    study = check(problem, {})
    assert study.dynamics.workless == {"N_w": True, "f_N_w": False, "N_f": True, "f_N_f": False}


ON_A_CIRCLE = """
[parameters]
M = "mass"
R = "length"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
range = ["-pi/2", "pi/2"]
[bodies.disk]
shape = "disk"
radius = "R/4"
mass = "M"
center = ["{way}*R*sin(theta)", "{up}*R*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "disk"
circle = "O"
radius = "R"
friction = "F"
"""


@pytest.mark.parametrize(("way", "up", "side"), [("3/4", "-3/4", "inside"), ("5/4", "5/4", "outside")])
def test_without_a_word_it_touches_from_the_side_where_its_centre_is(way, up, side):
    text = ON_A_CIRCLE.format(way=way, up=up)
    silent, said = (Study(load_text(text + more)).dynamics.reactions["N"] for more in ("", f'side = "{side}"\n'))
    assert is_zero(silent - said)
