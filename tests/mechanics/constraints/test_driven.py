"""Supports and bodies whose motion is a given function of time."""

from rbpsym.statement import build as rb
from tests.mechanics.constraints.closed_forms import assert_same, check, stated

ROD = "M: mass, ell: length, g: acceleration"


def test_rod_in_an_accelerating_truck():
    """θ'' = -3 (g sin θ + a cos θ)/(2 ℓ): it hangs at rest where tan θ = -a/g."""
    problem = stated(
        ROD + ", a: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0", range=("-pi/2", "pi/2"))},
        bodies={"rod": rb.rod("ell", mass="M", start=("a*t**2/2", "0"), angle="theta - pi/2")},
        constraints={"P": rb.pivot("rod.start")},
    )
    study = check(problem, {"theta_ddot": "-3*(g*sin(theta) + a*cos(theta))/(2*ell)"})
    assert study.first_integral is not None
    assert_same(study.squares["theta"], "3*(g*(cos(theta) - cos(theta_0)) + a*(sin(theta_0) - sin(theta)))/ell", study)


def test_rod_on_a_driven_cart():
    """The same with the truck as a body: the force that drives it."""
    problem = stated(
        ROD + ", a: acceleration, m: mass",
        coordinates={"x": rb.coordinate(dimension="length"), "theta": rb.coordinate(start="theta_0")},
        bodies={
            "cart": rb.particle(mass="m", center=("x", "0")),
            "rod": rb.rod("ell", mass="M", start=("x", "0"), angle="theta - pi/2"),
        },
        constraints={
            "F": rb.prescribed("cart.center", "a*t**2/2"),
            "N": rb.contact("cart.center", "y = 0"),
            "P": rb.pin(["cart.center", "rod.start"]),
        },
    )
    study = check(problem, {"theta_ddot": "-3*(g*sin(theta) + a*cos(theta))/(2*ell)"})
    assert study.system.independent == ("theta",)


def test_swinging_support():
    """A support that moves up and down: θ'' = -3 (g - A Ω² cos Ωt) sin θ/(2 ℓ)."""
    problem = stated(
        ROD + ", A: length, Omega: angular speed",
        coordinates={"theta": rb.coordinate(start="theta_0")},
        bodies={"rod": rb.rod("ell", mass="M", angle="theta - pi/2")},
        constraints={"P": rb.pivot("rod.start", ["0", "A*cos(Omega*t)"])},
    )
    check(problem, {"theta_ddot": "-3*(g - A*Omega**2*cos(Omega*t))*sin(theta)/(2*ell)"})


def test_bead_on_a_turning_rod():
    """No gravity: r'' = Ω² r, N = 2 m Ω r', and the couple that keeps Ω is 2 m Ω r r'."""
    problem = stated(
        "m: mass, M: mass, ell: length, Omega: angular speed",
        coordinates={"r": rb.coordinate(dimension="length", start="r_0"), "phi": rb.coordinate()},
        bodies={
            "rod": rb.rod("ell", mass="M", start="O", angle="phi"),
            "bead": rb.particle(mass="m", center=("r*cos(phi)", "r*sin(phi)")),
        },
        constraints={
            "P": rb.pivot("rod.start"),
            "tau": rb.prescribed_angle("rod", "Omega*t"),
            "N": rb.guide("bead.center", "y = 0", of="rod"),
        },
    )
    study = check(problem, {"r_ddot": "Omega**2*r", "N": "2*m*Omega*r_dot", "tau": "2*m*Omega*r*r_dot"})
    assert_same(study.squares["r"], "Omega**2*(r**2 - r_0**2)", study)
    item = next(w for w in study.works if w.force == "tau")
    assert set(item.rotational.parts) == {"t"}


def test_disk_on_an_accelerated_plank():
    """A plank with acceleration A: the disk on it gains A/3 against the ground."""
    problem = stated(
        "m: mass, M: mass, R: length, b: length, A: acceleration, g: acceleration",
        coordinates={"x": rb.coordinate(dimension="length", start="0")},
        bodies={
            "plank": rb.rectangle("b", "b", mass="M", center=("A*t**2/2", "-b/2"), angle="0"),
            "disk": rb.disk("R", mass="m", center=("x", "R")),
        },
        constraints={
            "S": rb.slider("plank.bottom", "y = -b"),
            "F": rb.prescribed("plank.center", "A*t**2/2"),
            "N": rb.rolling("disk", "y = b/2", of="plank"),
        },
    )
    check(problem, {"x_ddot": "A/3", "f_N": "m*A/3", "F": "(M + m/3)*A"})


def test_static_friction_of_a_moving_support_works():
    """A block carried by a truck, a rod hung on it: the friction does net work, ∫ f a t dt."""
    problem = stated(
        "m: mass, M: mass, ell: length, b: length, a: acceleration, g: acceleration",
        coordinates={"theta": rb.coordinate(start="theta_0"), "s": rb.coordinate(dimension="length", start="0")},
        bodies={
            "truck": rb.rectangle("b", "b", mass="M", center=("a*t**2/2", "-b/2"), angle="0"),
            "crate": rb.particle(mass="m", center=("s", "0")),
            "rod": rb.rod("ell", mass="M", start=("s", "0"), angle="theta - pi/2"),
        },
        constraints={
            "S": rb.slider("truck.bottom", "y = -b"),
            "F": rb.prescribed("truck.center", "a*t**2/2"),
            "N": rb.sticking("crate.center", "y = b/2", of="truck"),
            "P": rb.pin(["crate.center", "rod.start"]),
        },
    )
    study = check(problem, {})
    assert study.system.independent == ("theta",)
    [item] = [w for w in study.works if (w.force, w.on) == ("f_N", "crate")]
    assert_same(item.translational.parts["t"], "f_N*a*t", study)
