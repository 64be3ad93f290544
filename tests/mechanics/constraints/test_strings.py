"""Strings over pulleys and round drums, against the closed forms of textbooks."""

from rbpsym.field.normal import is_zero
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, check, stated, work_of

DOWN = {"dimension": "length", "start": "0"}


def atwood(**more):
    return stated(
        "m_1: mass, m_2: mass, M: mass, R: length, b: length, c: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN), **more.get("coordinates", {})},
        bodies={
            "left": rb.particle(mass="m_1", center=("-R", "-b - y")),
            "pulley": rb.disk("R", mass="M", center="O", **more.get("pulley", {})),
            "right": rb.particle(mass="m_2", center=("R", more.get("right", "-c + y"))),
        },
        constraints={"A": rb.pivot("pulley.center"), "T": rb.string(["left.center", "cw pulley", "right.center"])},
    )


def test_atwood_with_a_massive_pulley():
    """Kleppner & Kolenkow 6.5: a = (m1 - m2) g/(m1 + m2 + I/R²)."""
    study = check(
        atwood(),
        {
            "y_ddot": "(m_1 - m_2)*g/(m_1 + m_2 + M/2)",
            "T_1": "m_1*(2*m_2 + M/2)*g/(m_1 + m_2 + M/2)",
            "T_2": "m_2*(2*m_1 + M/2)*g/(m_1 + m_2 + M/2)",
        },
    )
    assert study.dynamics.workless == {"A": True, "T_1": True, "T_2": True}
    along, _ = work_of(study, "T_1", "left")
    _, turning = work_of(study, "T_1", "pulley")
    assert is_zero(along + turning)


def test_atwood_in_redundant_coordinates():
    """Two heights and an angle: the string ties them."""
    more = {
        "coordinates": {"z": rb.coordinate(**DOWN), "phi": rb.coordinate(start="0")},
        "pulley": {"angle": "phi"},
        "right": "-c - z",
    }
    study = check(atwood(**more), {})
    assert len(study.system.independent) == 1
    assert len(study.system.dependent) == 2


def test_double_atwood():
    """A massless second pulley on the first string's end (a point of a carriage of mass m)."""
    problem = stated(
        "m_1: mass, m_2: mass, m_3: mass, m: mass, r: length, R: length, a: length, g: acceleration",
        coordinates={"x": rb.coordinate(**DOWN), "y": rb.coordinate(**DOWN)},
        bodies={
            "one": rb.particle(mass="m_1", center=("-R", "-a + x")),
            "cage": rb.particle(mass="m", center=("R", "-a - x")),
            "two": rb.particle(mass="m_2", center=("R - r", "-2*a - x - y")),
            "three": rb.particle(mass="m_3", center=("R + r", "-2*a - x + y")),
        },
        constraints={
            "T": rb.string(["one.center", {"around": "O", "radius": "R", "sense": "cw"}, "cage.center"]),
            "S": rb.string(["two.center", {"around": "cage.center", "radius": "r", "sense": "cw"}, "three.center"]),
        },
    )
    study = check(problem, {})
    m = "(m_2 + m_3)*(m_1 + m) + 4*m_2*m_3"
    assert_same(study.dynamics.accelerations["x_ddot"], f"g*(4*m_2*m_3 + (m - m_1)*(m_2 + m_3))/({m})", study)


def test_yo_yo():
    """A disk that unrolls from a vertical string: a = 2g/3, T = M g/3."""
    problem = stated(
        "M: mass, R: length, h: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN)},
        bodies={"disk": rb.disk("R", mass="M", center=("R", "-h - y"))},
        constraints={"T": rb.string(["O", "ccw disk"])},
    )
    study = check(problem, {"y_ddot": "2*g/3", "T": "M*g/3"})
    along, turning = work_of(study, "T", "disk")
    assert_same(along, "-M*g*y/3", study)
    assert is_zero(along + turning)


def test_yo_yo_with_an_axle():
    problem = stated(
        "M: mass, R: length, r: length, h: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN)},
        bodies={"disk": rb.disk("R", mass="M", center=("r", "-h - y"))},
        constraints={"T": rb.string(["O", {"around": "disk", "radius": "r", "sense": "ccw"}])},
    )
    check(problem, {"y_ddot": "g/(1 + R**2/(2*r**2))"})


def test_block_incline_pulley_and_bob():
    problem = stated(
        "m: mass, M: mass, I: moment of inertia, R: length, b: length, beta: angle, mu: number, g: acceleration",
        coordinates={"s": rb.coordinate(dimension="length", start="0", speed="v_0")},
        bodies={
            "block": rb.particle(
                mass="M", center=("-(b - s)*cos(beta) - R*sin(beta)", "-(b - s)*sin(beta) + R*cos(beta)")
            ),
            "pulley": {"shape": "given", "mass": "M", "moment": "I", "center": "O"},
            "bob": rb.particle(mass="m", center=("R", "-b - s")),
        },
        constraints={
            "A": rb.pivot("pulley.center"),
            "N": rb.contact("block.center", "y = x*tan(beta) + R/cos(beta)", coefficient="mu"),
            "T": rb.string(["block.center", {"around": "pulley", "radius": "R", "sense": "cw"}, "bob.center"]),
        },
    )
    check(
        problem,
        {
            "s_ddot": "(m - M*sin(beta) - mu*M*cos(beta))*g/(m + M + I/R**2)",
            "N": "M*g*cos(beta)",
        },
    )


def test_falling_spool_and_bob():
    """A disk that unrolls from a string over a fixed massive pulley to a bob (a string with two tensions)."""
    problem = stated(
        "m: mass, M: mass, R: length, a: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN), "x": rb.coordinate(**DOWN)},
        bodies={
            "pulley": rb.disk("R", mass="M", center="O"),
            "spool": rb.disk("R", mass="M", center=("2*R", "-a - y")),
            "bob": rb.particle(mass="m", center=("-R", "-a - x")),
        },
        constraints={"A": rb.pivot("pulley.center"), "T": rb.string(["bob.center", "cw pulley", "ccw spool"])},
    )
    check(
        problem,
        {
            "x_ddot": "g*(6*m - 2*M)/(6*m + 5*M)",
            "y_ddot": "g*(2*m + 4*M)/(6*m + 5*M)",
            "T_2": "M*g*(4*m + M)/(6*m + 5*M)",
        },
    )


def test_rod_on_two_strings():
    """Parallel strings of one length: the rod swings without turning, as a simple pendulum."""
    problem = stated(
        "M: mass, a: length, ell: length, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        points={"P": ("-a", "0"), "Q": ("a", "0")},
        bodies={"rod": rb.rod("2*a", mass="M", center=("ell*sin(theta)", "-ell*cos(theta)"), angle="0")},
        constraints={"T": rb.string(["P", "rod.start"], "ell"), "S": rb.string(["Q", "rod.end"], "ell")},
    )
    study = check(problem, {"theta_ddot": "-g*sin(theta)/ell"})
    total = study.dynamics.reactions["T"] + study.dynamics.reactions["S"]
    assert_same(total, "M*g*cos(theta) + M*ell*theta_dot**2", study)


def test_string_pendulum_in_two_coordinates():
    """x and y of a bob on a string of given length: one equation ties them."""
    problem = stated(
        "m: mass, ell: length, g: acceleration",
        coordinates={
            "x": rb.coordinate(dimension="length", start="x_0", range=("0", "ell/2")),
            "y": rb.coordinate(dimension="length", range=("-ell", "-ell/2")),
        },
        bodies={"bob": rb.particle(mass="m", center=("x", "y"))},
        constraints={"T": rb.string(["O", "bob.center"], "ell")},
    )
    study = check(problem, {})
    assert len(study.system.implicit) == 1


def test_string_between_two_drums():
    """A disk that unrolls from a string that unrolls from an equal disk on an axle: a = 4g/5, T = M g/5."""
    problem = stated(
        "M: mass, R: length, b: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN), "phi": rb.coordinate(start="0")},
        bodies={
            "upper": rb.disk("R", mass="M", center="O", angle="-phi"),
            "lower": rb.disk("R", mass="M", center=("2*R", "-b - y")),
        },
        constraints={"A": rb.pivot("upper.center"), "T": rb.string(["cw upper", "ccw lower"])},
    )
    check(problem, {"y_ddot": "4*g/5", "phi_ddot": "2*g/(5*R)", "T": "M*g/5"})


def test_swinging_atwood():
    """Two pegs as points: r'' (m + M) = m r θ'² + g (m cos θ - M)."""
    problem = stated(
        "m: mass, M: mass, a: length, ell: length, g: acceleration",
        coordinates={
            "r": rb.coordinate(dimension="length", start="r_0", range=("0", "ell")),
            "theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2")),
        },
        bodies={
            "bob": rb.particle(mass="m", center=("r*sin(theta)", "-r*cos(theta)")),
            "load": rb.particle(mass="M", center=("-a", "-ell + r")),
        },
        constraints={"T": rb.string(["load.center", {"around": ["-a", "0"]}, {"around": "O"}, "bob.center"])},
    )
    check(
        problem,
        {
            "r_ddot": "(m*r*theta_dot**2 + g*(m*cos(theta) - M))/(m + M)",
            "theta_ddot": "-(2*r_dot*theta_dot + g*sin(theta))/r",
            "T": "m*M*(r*theta_dot**2 + g*(1 + cos(theta)))/(m + M)",
        },
    )


def test_massless_pulley():
    """A pulley without mass has equal tensions on both sides."""
    problem = stated(
        "m_1: mass, m_2: mass, R: length, b: length, g: acceleration",
        coordinates={"y": rb.coordinate(**DOWN)},
        bodies={
            "left": rb.particle(mass="m_1", center=("-R", "-b - y")),
            "pulley": rb.disk("R", mass="0", center="O"),
            "right": rb.particle(mass="m_2", center=("R", "-b + y")),
        },
        constraints={"A": rb.pivot("pulley.center"), "T": rb.string(["left.center", "cw pulley", "right.center"])},
    )
    tension = "2*m_1*m_2*g/(m_1 + m_2)"
    check(problem, {"T_1": tension, "T_2": tension}, simulated=False)
