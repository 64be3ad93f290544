"""Rolling without slipping, against the closed forms of textbooks."""

import pytest

from rbpsym.field.normal import is_zero
from rbpsym.mechanics.study import Study
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, check, stated, work_of

INCLINE = "M: mass, R: length, beta: angle, g: acceleration"
ON_INCLINE = ("s*cos(beta) + R*sin(beta)", "-s*sin(beta) + R*cos(beta)")


def on_incline(shape, **keys):
    return stated(
        INCLINE + keys.pop("more", ""),
        coordinates={"s": rb.coordinate(dimension="length", start="0")},
        bodies={"body": {**shape, "center": ON_INCLINE}},
        constraints={"N": rb.rolling("body", "y = -x*tan(beta)", **keys)},
    )


@pytest.mark.parametrize(
    ("shape", "c"),
    [
        (rb.disk("R", mass="M"), "1/2"),
        (rb.ring("R", mass="M"), "1"),
        (rb.ball("R", mass="M"), "2/5"),
        (rb.shell("R", mass="M"), "2/3"),
    ],
)
def test_round_bodies_on_an_incline(shape, c):
    """Kleppner & Kolenkow 7.6: a = g sin β/(1 + c), f = M g sin β c/(1 + c)."""
    study = check(
        on_incline(shape),
        {
            "s_ddot": f"g*sin(beta)/(1 + {c})",
            "N": "M*g*cos(beta)",
            "f_N": f"M*g*sin(beta)*({c})/(1 + {c})",
        },
    )
    along, turning = work_of(study, "f_N", "body")
    assert_same(along, f"-M*g*s*sin(beta)*({c})/(1 + {c})", study)
    assert is_zero(along + turning)


def test_spool_on_its_axle():
    """An annulus that rolls on a rail with a rim of its own: a = g sin β/(1 + I/(M r²))."""
    shape = rb.annulus("a", "b", mass="M")
    problem = on_incline(shape, rim="R", more=", a: length, b: length")
    check(problem, {"s_ddot": "g*sin(beta)/(1 + (a**2 + b**2)/(2*R**2))"})


def test_redundant_coordinates_with_a_pull():
    """x and φ of a disk, pulled at the top: a = 4F/(3M), f = F/3 forward."""
    problem = stated(
        "M: mass, R: length, F: force, g: acceleration",
        coordinates={
            "x": rb.coordinate(dimension="length", start="x_0", speed="v_0"),
            "phi": rb.coordinate(start="phi_0"),
        },
        bodies={"disk": rb.disk("R", mass="M", center=("x", "R"), angle="phi", points={"top": ("0", "R")})},
        interactions={"P": rb.force("disk.center", ("F", "0")), "Q": rb.couple("disk", "-F*R")},
        constraints={"N": rb.rolling("disk", "y = 0")},
    )
    study = check(problem, {"N": "M*g", "f_N": "F/3"})
    assert study.system.independent == ("x",)


def test_centre_left_to_the_constraint():
    problem = stated(
        "M: mass, R: length, g: acceleration, F: force",
        coordinates={"phi": rb.coordinate(start="0")},
        bodies={"disk": rb.disk("R", mass="M", angle="-phi")},
        interactions={"P": rb.force("disk.center", ("F", "0"))},
        constraints={"N": rb.rolling("disk", "y = 0")},
    )
    check(problem, {"phi_ddot": "2*F/(3*M*R)", "f_N": "-F/3", "N": "M*g"})


def test_cylinder_in_a_cylinder():
    """(R - r) θ'' = -2/3 g sin θ; Spiegel, ch. 9."""
    problem = stated(
        "M: mass, R: length, r: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        bodies={"disk": rb.disk("r", mass="M", center=("(R - r)*sin(theta)", "-(R - r)*cos(theta)"))},
        constraints={"N": rb.rolling("disk", circle="O", radius="R", side="inside")},
    )
    check(
        problem,
        {
            "theta_ddot": "-2*g*sin(theta)/(3*(R - r))",
            "N": "M*g*cos(theta) + M*(R - r)*theta_dot**2",
            "f_N": "M*g*sin(theta)/3",
        },
    )


def test_cylinder_off_a_cylinder():
    """Leaves where cos θ = 4/7 (Meriam & Kraige): N = M g (7 cos θ - 4)/3."""
    problem = stated(
        "M: mass, R: length, r: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", range=("0", "pi/2"))},
        bodies={"disk": rb.disk("r", mass="M", center=("(R + r)*sin(theta)", "(R + r)*cos(theta)"))},
        constraints={"N": rb.rolling("disk", circle="O", radius="R")},
    )
    study = check(problem, {"theta_ddot": "2*g*sin(theta)/(3*(R + r))", "f_N": "-M*g*sin(theta)/3"})
    assert_same(study.reactions_along_motion["N"], "M*g*(7*cos(theta) - 4)/3", study)
    [loss] = study.losses
    assert_same(loss.at["theta"], "acos(4/7)", study)


PLANK = "m: mass, M: mass, R: length, h: length, b: length, g: acceleration, F: force"


def test_cylinder_on_a_plank():
    """A plank on rollers pulled by F: A = F/(M + m/3), a cylinder of mass m on it moves with A/3."""
    problem = stated(
        PLANK,
        coordinates={
            "X": rb.coordinate(dimension="length", start="0"),
            "x": rb.coordinate(dimension="length", start="0"),
        },
        bodies={
            "plank": rb.rectangle("b", "h", mass="M", center=("X", "h/2"), angle="0"),
            "disk": rb.disk("R", mass="m", center=("x", "h + R")),
        },
        interactions={"P": rb.force("plank.center", ("F", "0"))},
        constraints={
            "S": rb.slider("plank.bottom", "y = 0"),
            "N": rb.rolling("disk", "y = h/2", of="plank"),
        },
    )
    check(problem, {"X_ddot": "F/(M + m/3)", "x_ddot": "F/(3*M + m)", "f_N": "m*F/(3*M + m)", "N": "m*g"})


def test_cylinder_on_a_sliding_wedge():
    """The wedge recoils: X'' = -m g sin 2β/(3(M + m) - 2 m cos²β) for a disk (Spiegel-type)."""
    problem = stated(
        "m: mass, M: mass, R: length, beta: angle, g: acceleration",
        coordinates={
            "X": rb.coordinate(dimension="length", start="0"),
            "s": rb.coordinate(dimension="length", start="0"),
        },
        bodies={
            "wedge": {
                "shape": "rectangle",
                "width": "R",
                "height": "R",
                "mass": "M",
                "center": ("X", "0"),
                "angle": "0",
            },
            "disk": rb.disk("R", mass="m", center=("X + s*cos(beta) + R*sin(beta)", "-s*sin(beta) + R*cos(beta)")),
        },
        constraints={"S": rb.slider("wedge.center", "y = 0"), "N": rb.rolling("disk", "y = -x*tan(beta)", of="wedge")},
    )
    check(
        problem,
        {
            "X_ddot": "-m*g*2*sin(beta)*cos(beta)/(3*(M + m) - 2*m*cos(beta)**2)",
            "s_ddot": "2*(M + m)*g*sin(beta)/(3*(M + m) - 2*m*cos(beta)**2)",
        },
    )


def test_cylinder_on_a_turning_cylinder():
    """Two cylinders side by side, the large one on a fixed axle: rims move together."""
    problem = stated(
        "m: mass, M: mass, R: length, r: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="0", range=("0", "pi/2")), "psi": rb.coordinate(start="0")},
        bodies={
            "drum": rb.disk("R", mass="M", center="O", angle="psi"),
            "disk": rb.disk("r", mass="m", center=("(R + r)*sin(theta)", "(R + r)*cos(theta)")),
        },
        constraints={"A": rb.pivot("drum.center"), "N": rb.rolling("disk", circle="drum.center")},
    )
    study = check(problem, {})
    assert study.system.independent == ("theta", "psi")
    assert_same(study.dynamics.accelerations["theta_ddot"], "2*(M + m)*g*sin(theta)/((R + r)*(3*M + 2*m))", study)


def test_how_much_friction_rolling_needs():
    """A disk rolls down without slipping if μ ≥ tan β/3."""
    study = Study(on_incline(rb.disk("R", mass="M"), limit="mu", more=", mu: number"))
    [need] = study.friction_needs
    assert_same(need.ratio, "tan(beta)/3", study)
    assert_same(need.limit, "mu", study)
    assert need.holds is None


def test_enough_friction_is_proved():
    """A disk pulled at its centre needs F/(3 M g)."""
    problem = stated(
        "M: mass, R: length, F: force, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0")},
        bodies={"disk": rb.disk("R", mass="M", center=("x", "R"))},
        interactions={"P": rb.force("disk.center", ("F", "0"))},
        constraints={"N": rb.rolling("disk", "y = 0", limit="F/(2*M*g)")},
    )
    study = Study(problem)
    [need] = study.friction_needs
    assert_same(need.needed, "F/(3*M*g)", study)
    assert need.holds is True


def test_half_disk_that_rocks():
    """ω² = 8 g/((9π - 16) R)."""
    problem = stated(
        "M: mass, R: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        bodies={
            "bowl": {
                "shape": "half-disk",
                "radius": "R",
                "mass": "M",
                "center": ("-R*theta", "R"),
                "angle": "theta + pi",
            }
        },
        constraints={"N": rb.rolling("bowl", "y = 0", rim="R")},
    )
    study = check(problem, {})
    [place] = [item for item in study.equilibria if item.stable]
    assert_same(place.frequencies_squared[0], "8*g/((9*pi - 16)*R)", study)


def test_ring_with_a_point_mass():
    """A ring of mass M with a bob m on its rim rolls on a floor (centre from the contact)."""
    problem = stated(
        "m: mass, M: mass, R: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi", "pi"))},
        bodies={
            "ring": {
                "shape": "composite",
                "points": {"center": ("0", "0")},
                "angle": "theta - pi/2",
                "parts": [
                    {"shape": "ring", "radius": "R", "mass": "M"},
                    {"shape": "particle", "mass": "m", "at": ["R", "0"]},
                ],
            }
        },
        constraints={"N": rb.rolling("ring", "y = 0", rim="R")},
    )
    check(
        problem,
        {
            "theta_ddot": "-m*sin(theta)*(R*theta_dot**2 + g)/(2*R*(M + m - m*cos(theta)))",
        },
    )


def test_disk_in_a_bowl_in_four_coordinates():
    """x, y, φ: the contact is an equation, rolling a condition for the speeds alone."""
    problem = stated(
        "M: mass, R: length, r: length, g: acceleration",
        coordinates={
            "phi": rb.coordinate(start="0"),
            "x": rb.coordinate(dimension="length", range=("0", "r")),
            "y": rb.coordinate(dimension="length", range=("-R", "-r")),
        },
        bodies={"disk": rb.disk("r", mass="M", center=("x", "y"), angle="phi")},
        constraints={"N": rb.rolling("disk", circle="O", radius="R", side="inside")},
    )
    study = check(problem, {})
    assert len(study.system.independent) == 1
    assert len(study.system.speed_ties) == 1


def test_spool_pulled_at_an_angle():
    """Thread from the bottom of the inner drum at an angle α: it rolls forward if cos α > r/R."""
    problem = stated(
        "M: mass, I: moment of inertia, R: length, r: length, F: force, alpha: angle, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0")},
        bodies={"spool": {"shape": "given", "mass": "M", "moment": "I", "center": ("x", "R")}},
        interactions={"P": rb.force("spool.center", ("F*cos(alpha)", "F*sin(alpha)")), "Q": rb.couple("spool", "F*r")},
        constraints={"N": rb.rolling("spool", "y = 0", rim="R")},
    )
    check(problem, {"x_ddot": "F*(cos(alpha) - r/R)/(M + I/R**2)", "N": "M*g - F*sin(alpha)"})


def test_two_gears_on_bearings():
    """A couple T on one: its angular acceleration is 2 T/((M + m) R²); teeth push along the tangent only."""
    problem = stated(
        "M: mass, m: mass, R: length, r: length, T: torque",
        coordinates={"a": rb.coordinate(start="0"), "b": {}},
        bodies={
            "one": rb.disk("R", mass="M", center="O", angle="a"),
            "two": rb.disk("r", mass="m", center=("R + r", "0"), angle="b"),
        },
        interactions={"C": rb.couple("one", "T")},
        constraints={
            "A": rb.pivot("one.center"),
            "B": rb.pivot("two.center"),
            "F": {"type": "gear", "body": "two", "circle": "one.center"},
        },
    )
    check(problem, {"a_ddot": "2*T/((M + m)*R**2)", "B_x": "0"})


def test_rack_and_pinion():
    """A couple T on the pinion moves the rack: 2 T/(r (2 M + m))."""
    problem = stated(
        "M: mass, m: mass, r: length, L: length, T: torque, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0"), "b": {}},
        bodies={
            "rack": rb.rod("L", mass="M", center=("x", "0"), angle="0"),
            "pinion": rb.disk("r", mass="m", center=("0", "r"), angle="b"),
        },
        interactions={"C": rb.couple("pinion", "T")},
        constraints={
            "S": rb.slider("rack.center", "y = 0"),
            "B": rb.pivot("pinion.center"),
            "F": {"type": "gear", "body": "pinion", "line": "y = 0", "of": "rack"},
        },
    )
    check(problem, {"x_ddot": "2*T/(r*(2*M + m))"})


def test_planetary_gear():
    """A crank drives a planet round a fixed sun: 6 T/((2 M + 9 m) (R + r)²)."""
    problem = stated(
        "M: mass, m: mass, R: length, r: length, T: torque",
        coordinates={"a": rb.coordinate(start="0"), "b": {}},
        bodies={
            "arm": rb.rod("R + r", mass="M", start="O", angle="a"),
            "planet": rb.disk("r", mass="m", angle="b"),
        },
        interactions={"C": rb.couple("arm", "T")},
        constraints={
            "A": rb.pivot("arm.start"),
            "B": {"type": "pin", "points": ["arm.end", "planet.center"]},
            "F": {"type": "gear", "body": "planet", "circle": "O", "radius": "R"},
        },
    )
    check(problem, {"a_ddot": "6*T/((2*M + 9*m)*(R + r)**2)"})
