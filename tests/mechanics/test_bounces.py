"""Bounces with friction, strings that go taut, contacts that begin: closed forms of the literature, and the simulation."""

import pytest

from rbpsym.mechanics.phases import stages
from rbpsym.oracles.simulation_phases import followed
from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, stated

BALL = "M: mass, R: length, v: speed, u: speed, omega: angular speed, e: number, mu: number, g: acceleration"


def thrown(height="R", begins="at once", **more):
    """A ball that comes down with v, -u and spin ω, counter-clockwise; what more is said of its bounce J."""
    of = {"of": "J"} if begins == "begins" else {}
    return stated(
        BALL,
        coordinates={
            "x": rb.coordinate(dimension="length", start="0", speed="v"),
            "y": rb.coordinate(dimension="length", start=height, speed="-u"),
            "phi": rb.coordinate(start="0", speed="omega"),
        },
        bodies={"ball": rb.ball("R", mass="M", center=("x", "y"), angle="phi")},
        phases=[{"name": "off", "event": begins, **of,
                 "impulses": {"J": {"type": "bounce", "body": "ball", "line": "y = 0", **more}}}],
    )  # fmt: skip


def after(problem):
    """How the last phase begins; the simulation agrees with it."""
    *_, last = parts = stages(problem)
    assert max(followed(problem, parts).values()) < 1e-7
    return last.began, last.study


def assert_asked(began, study, name, *wanted):
    """The conditions of a contact are these, each ≥ 0 up to a positive factor that is given with it."""
    assert len(began.held[name]) == len(wanted)
    for demand, expected in zip(began.held[name], wanted, strict=True):
        assert_same(demand.value, expected, study)


def test_a_ball_that_grips():
    """Cross, Am. J. Phys. 70 (2002) 1093: v' = (5v - 2Rω)/7, μ ≥ 2(v + Rω)/(7(1 + e)u)."""
    began, study = after(thrown(restitution="e", coefficient="mu", slip="none"))
    assert_same(began.speeds["x"], "(5*v - 2*R*omega)/7", study)
    assert_same(began.speeds["y"], "e*u", study)
    assert_same(began.impulses["f_J"], "-2*M*(v + R*omega)/7", study)
    assert_same(began.energy_lost, "M*u**2*(1 - e**2)/2 + M*(v + R*omega)**2/7", study)
    assert_asked(began, study, "J", "7*mu*(1 + e)*u - 2*(v + R*omega)")


def test_a_ball_that_slips_throughout():
    """v' = v - μ(1 + e)u, ω' = ω - 5μ(1 + e)u/(2R), as long as it slips: the other side of the same condition."""
    began, study = after(thrown(restitution="e", coefficient="mu"))
    assert_same(began.speeds["x"], "v - mu*(1 + e)*u", study)
    assert_same(began.speeds["phi"], "omega - 5*mu*(1 + e)*u/(2*R)", study)
    assert_asked(began, study, "J", "2*(v + R*omega) - 7*mu*(1 + e)*u")


def test_a_superball_keeps_its_energy():
    """Garwin, Am. J. Phys. 37 (1969) 88."""
    began, study = after(thrown(restitution="1", slip="none", tangential="1"))
    assert_same(began.speeds["x"], "(3*v - 4*R*omega)/7", study)
    assert_same(began.speeds["phi"], "-(10*v + 3*R*omega)/(7*R)", study)
    assert_same(began.energy_lost, "0", study)


def test_it_bounces_where_it_comes_down():
    """From the height h it comes down with √(u² + 2g(h - R))."""
    began, study = after(thrown("R + u**2/(2*g)", "begins", restitution="e"))
    assert_same(began.before.time, "u*(sqrt(2) - 1)/g", study)
    assert_same(began.speeds["y"], "e*u*sqrt(2)", study)
    assert_same(began.speeds["x"], "v", study)


def test_a_ball_against_a_wall_on_its_right():
    """The side of the wall is that where the ball is before."""
    problem = stated(
        "M: mass, d: length, v: speed, e: number",
        coordinates={"x": rb.coordinate(dimension="length", start="0", speed="v")},
        bodies={"ball": rb.particle(mass="M", center=("x", "0"))},
        phases=[{"name": "back", "event": "begins", "of": "J",
                 "impulses": {"J": {"type": "bounce", "point": "ball.center", "line": "x = d", "restitution": "e"}}}],
    )  # fmt: skip
    began, study = after(problem)
    assert_same(began.before.time, "d/v", study)
    assert_same(began.speeds["x"], "-e*v", study)
    assert_same(began.impulses["J"], "(1 + e)*M*v", study)


SPINS = [("none", "3*v*cos(beta)/(2*ell)"), (None, "6*v*cos(beta)/(ell*(1 + 3*cos(beta)**2))")]


@pytest.mark.parametrize(("slip", "spin"), SPINS)
def test_a_rod_that_falls_on_its_end(slip, spin):
    """Beer & Johnston, chapter 17: on a rough floor it turns about its end; on a smooth one the middle goes straight down."""
    told = {"slip": slip, "coefficient": "mu"} if slip else {}
    problem = stated(
        "M: mass, ell: length, v: speed, beta: angle, mu: number",
        coordinates={
            "x": rb.coordinate(dimension="length", start="0"),
            "y": rb.coordinate(dimension="length", start="ell*sin(beta)/2", speed="-v"),
            "theta": rb.coordinate(start="beta"),
        },
        bodies={"rod": rb.rod("ell", mass="M", center=("x", "y"), angle="theta")},
        phases=[{"name": "hit", "impulses": {
            "J": {"type": "bounce", "point": "rod.start", "line": "y = 0", "side": "positive", "restitution": "0", **told}}}],
    )  # fmt: skip
    began, study = after(problem)
    assert_same(began.speeds["theta"], f"-{spin}", study)


def tied(**more):
    """A puck on a smooth table, tied to a peg by a slack string."""
    problem = {
        "coordinates": {
            "x": rb.coordinate(dimension="length", start="0", speed="v"),
            "y": rb.coordinate(dimension="length", start="3*L/5"),
        },
        "bodies": {"puck": rb.particle(mass="m", center=("x", "y"))},
    }
    phases = [{"name": "taut", "event": "begins", "of": "S", **more}]
    return stated("m: mass, L: length, v: speed, e: number", **problem, phases=phases)


STRING = {"path": ["O", "puck.center"], "length": "L"}


def test_a_string_goes_taut_and_stays_so():
    """Meriam & Kraige, chapter 3: what is left of the speed is that across the string, v d/L."""
    began, study = after(tied(constraints={"S": {"type": "string", **STRING}}))
    assert_same(began.before.time, "4*L/(5*v)", study)
    assert_same(began.speeds["x"], "9*v/25", study)
    assert_same(began.impulses["S"], "4*m*v/5", study)
    assert_same(began.energy_lost, "8*m*v**2/25", study)


def test_a_string_that_springs_back():
    """The speed along the string is turned round, times e."""
    began, study = after(tied(impulses={"S": {"type": "bounce", **STRING, "restitution": "e"}}))
    assert_same(began.speeds["x"], "9*v/25 - 16*e*v/25", study)
    assert_same(began.speeds["y"], "-12*(1 + e)*v/25", study)


def test_a_weight_falls_beside_its_peg():
    """It falls √(L² - d²); its speed across the string is then that times d/L, whose vertical part is v d²/L²."""
    problem = stated(
        "m: mass, d: length, g: acceleration",
        coordinates={
            "x": rb.coordinate(dimension="length", start="3*d"),
            "y": rb.coordinate(dimension="length", start="0"),
        },
        bodies={"weight": rb.particle(mass="m", center=("x", "-y"))},
        phases=[{"name": "taut", "event": "begins", "of": "S",
                 "constraints": {"S": {"type": "string", "path": ["O", "weight.center"], "length": "5*d"}}}],
    )  # fmt: skip
    began, study = after(problem)
    assert_same(began.before.time, "2*sqrt(2)*sqrt(d*g)/g", study)
    assert_same(began.before.speeds["y"], "2*sqrt(2)*sqrt(g*d)", study)
    assert_same(began.speeds["y"], "18*sqrt(2)*sqrt(g*d)/25", study)
    assert_same(began.impulses["S"], "8*m*sqrt(2)*sqrt(g*d)/5", study)


def test_what_lands_and_slips_takes_friction_from_its_impulse():
    """A wheel that comes down spinning, and does not bounce: v = μu, as long as Rω > 3μu."""
    constraints = {"N": {"type": "touch", "body": "wheel", "line": "y = 0", "coefficient": "mu"}}
    problem = stated(
        "M: mass, R: length, h: length, omega: angular speed, mu: number, g: acceleration",
        coordinates={
            "x": rb.coordinate(dimension="length", start="0"),
            "y": rb.coordinate(dimension="length", start="R + h"),
            "phi": rb.coordinate(start="0", speed="omega"),
        },
        bodies={"wheel": rb.disk("R", mass="M", center=("x", "y"), angle="-phi")},
        phases=[{"name": "landed", "event": "begins", "of": "N", "constraints": constraints}],
    )
    began, study = after(problem)
    assert_same(began.speeds["x"], "mu*sqrt(2)*sqrt(g*h)", study)
    assert_same(began.speeds["phi"], "omega - 2*mu*sqrt(2)*sqrt(g*h)/R", study)
    assert len(began.held["N"]) == 1


def test_static_friction_of_a_landing_has_its_limit():
    """A wheel that rolls at once where it lands needs f̂ = MRω/3 of N̂ = Mu: 3μu ≥ Rω."""
    constraints = {"N": {"type": "rolling", "body": "wheel", "line": "y = 0", "limit": "mu"}}
    problem = stated(
        "M: mass, R: length, u: speed, omega: angular speed, mu: number",
        coordinates={
            "x": rb.coordinate(dimension="length", start="0"),
            "y": rb.coordinate(dimension="length", start="R", speed="-u"),
            "phi": rb.coordinate(start="0", speed="omega"),
        },
        bodies={"wheel": rb.disk("R", mass="M", center=("x", "y"), angle="-phi")},
        phases=[{"name": "landed", "constraints": constraints}],
    )
    began, study = after(problem)
    assert_same(began.speeds["x"], "R*omega/3", study)
    assert_asked(began, study, "N", "3*mu*u - R*omega")
