"""Physical pendulums of every shape, against the closed forms of textbooks."""

import pytest

from tests.mechanics.textbook import Textbook, complaints, differences


def pendulum(lengths: str, body: str, hung: str, angle: str = "theta") -> str:
    """A body of mass M hung at one of its points at O, turned by theta."""
    sizes = "\n".join(f'{name} = "length: a size"' for name in lengths.split())
    return f"""
[parameters]
M = "mass: mass"
{sizes}
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle"
start = "theta_0"
speed = "0"

[bodies.body]
{body}
{hung} = "O"
angle = "{angle}"

[interactions.W]
type = "gravity"

[constraints.F]
type = "pivot"
point = "body.{hung}"
"""


SYSTEMS = [
    Textbook(
        "rod at its end",
        pendulum("L", 'shape = "rod"\nmass = "M"\nlength = "L"', "start", "theta - pi/2"),
        {
            "moments_of_inertia/body": "M*L**2/12",
            "accelerations/theta": "-3*g/(2*L)*sin(theta)",
            "speed_squared/theta": "3*g/L*(cos(theta) - cos(theta_0))",
            "equilibria/0/frequencies_squared/0": "3*g/(2*L)",
            "angular_momentum/O/body/orbital": "M*L**2/4*theta_dot",
            "kinetic_energy/total": "M*L**2*theta_dot**2/6",
        },
        (True, False),
    ),
    Textbook(
        "rod hung beside its centre",
        pendulum(
            "L a", 'shape = "rod"\nmass = "M"\nlength = "L"\npoints = { nail = ["-a", "0"] }', "nail", "theta - pi/2"
        ),
        {"accelerations/theta": "-12*g*a*sin(theta)/(L**2 + 12*a**2)"},
        (True, False),
    ),
    Textbook(
        "disk on its rim",
        pendulum("R", 'shape = "disk"\nmass = "M"\nradius = "R"\npoints = { rim = ["0", "R"] }', "rim"),
        {
            "moments_of_inertia/body": "M*R**2/2",
            "accelerations/theta": "-2*g/(3*R)*sin(theta)",
            "equilibria/0/frequencies_squared/0": "2*g/(3*R)",
        },
        (True, False),
    ),
    Textbook(
        "hoop on its rim",
        pendulum("R", 'shape = "hoop"\nmass = "M"\nradius = "R"\npoints = { rim = ["0", "R"] }', "rim"),
        {"moments_of_inertia/body": "M*R**2", "accelerations/theta": "-g/(2*R)*sin(theta)"},
        (True, False),
    ),
    Textbook(
        "annulus on a knife edge",
        pendulum(
            "a b", 'shape = "annulus"\nmass = "M"\ninner = "a"\nouter = "b"\npoints = { edge = ["0", "a"] }', "edge"
        ),
        {
            "moments_of_inertia/body": "M*(a**2 + b**2)/2",
            "accelerations/theta": "-2*g*a*sin(theta)/(3*a**2 + b**2)",
        },
    ),
    Textbook(
        "ball on a wire",
        pendulum("R L", 'shape = "ball"\nmass = "M"\nradius = "R"\npoints = { hook = ["0", "L"] }', "hook"),
        {
            "moments_of_inertia/body": "2*M*R**2/5",
            "accelerations/theta": "-g*L*sin(theta)/(L**2 + 2*R**2/5)",
            "angular_momentum/O/body/spin": "2*M*R**2/5*theta_dot",
        },
    ),
    Textbook(
        "spherical shell on a wire",
        pendulum("R L", 'shape = "shell"\nmass = "M"\nradius = "R"\npoints = { hook = ["0", "L"] }', "hook"),
        {"moments_of_inertia/body": "2*M*R**2/3", "accelerations/theta": "-g*L*sin(theta)/(L**2 + 2*R**2/3)"},
    ),
    Textbook(
        "square plate at a corner",
        pendulum("a", 'shape = "rectangle"\nmass = "M"\nwidth = "a"\nheight = "a"', "top_left", "theta - pi/4"),
        {
            "moments_of_inertia/body": "M*a**2/6",
            "accelerations/theta": "-3*sqrt(2)*g/(4*a)*sin(theta)",
            "equilibria/0/frequencies_squared/0": "3*sqrt(2)*g/(4*a)",
        },
        (True, False),
    ),
    Textbook(
        "rectangle at a corner",
        pendulum("a b", 'shape = "rectangle"\nmass = "M"\nwidth = "a"\nheight = "b"', "top_left"),
        {
            "moments_of_inertia/body": "M*(a**2 + b**2)/12",
            "accelerations/theta": "-3*g*(a*cos(theta) + b*sin(theta))/(2*(a**2 + b**2))",
        },
    ),
    Textbook(
        "sign board hung at the middle of its upper side",
        pendulum("a b", 'shape = "rectangle"\nmass = "M"\nwidth = "a"\nheight = "b"', "top"),
        {"accelerations/theta": "-6*g*b*sin(theta)/(a**2 + 4*b**2)"},
    ),
    Textbook(
        "triangle at its apex",
        pendulum("b h", 'shape = "triangle"\nmass = "M"\nbase = "b"\nheight = "h"', "top"),
        {
            "moments_of_inertia/body": "M*(b**2/24 + h**2/18)",
            "accelerations/theta": "-16*g*h*sin(theta)/(12*h**2 + b**2)",
            "equilibria/0/frequencies_squared/0": "16*g*h/(12*h**2 + b**2)",
        },
        (True, False),
    ),
    Textbook(
        "equilateral triangle at its apex",
        pendulum("a", 'shape = "triangle"\nmass = "M"\nbase = "a"\nheight = "sqrt(3)*a/2"', "top"),
        {
            "moments_of_inertia/body": "M*a**2/12",
            "equilibria/0/frequencies_squared/0": "4*sqrt(3)*g/(5*a)",
        },
    ),
    Textbook(
        "half disk at the middle of its straight edge",
        pendulum("R", 'shape = "half-disk"\nmass = "M"\nradius = "R"', "center", "theta + pi"),
        {
            "moments_of_inertia/body": "M*R**2*(1/2 - 16/(9*pi**2))",
            "accelerations/theta": "-8*g/(3*pi*R)*sin(theta)",
        },
        (True, False),
    ),
    Textbook(
        "semicircular wire at the middle of its arc",
        pendulum("R", 'shape = "half-ring"\nmass = "M"\nradius = "R"', "top"),
        {
            "moments_of_inertia/body": "M*R**2*(1 - 4/pi**2)",
            "accelerations/theta": "-g/(2*R)*sin(theta)",
        },
    ),
    Textbook(
        "disk with a round hole, at its centre",
        pendulum(
            "R",
            'shape = "composite"\nmass = "M"\nparts = [{ shape = "disk", radius = "R" },\n'
            '  { shape = "disk", radius = "R/2", at = ["0", "R/2"], removed = true }]',
            "origin",
        ),
        {
            "moments_of_inertia/body": "13*M*R**2/24 - M*R**2/36",
            "accelerations/theta": "-4*g/(13*R)*sin(theta)",
        },
        (True, False),
    ),
    Textbook(
        "T of two equal rods, at the middle of its bar",
        pendulum(
            "L",
            'shape = "composite"\nparts = [{ shape = "rod", mass = "M", length = "L" },\n'
            '  { shape = "rod", mass = "M", length = "L", at = ["0", "-L/2"], angle = "pi/2" }]',
            "origin",
        ),
        {"accelerations/theta": "-6*g/(5*L)*sin(theta)", "masses/body": "2*M"},
        (True, False),
    ),
    Textbook(
        "rod whose density grows from its end",
        pendulum("L", 'shape = "rod"\ndensity = "2*M*s/L**2"\nlength = "L"', "start", "theta - pi/2"),
        {
            "masses/body": "M",
            "moments_of_inertia/body": "M*L**2/18",
            "accelerations/theta": "-4*g/(3*L)*sin(theta)",
        },
    ),
    Textbook(
        "dumbbell at its lighter end",
        pendulum(
            "L",
            'shape = "composite"\nparts = [{ shape = "particle", mass = "M", at = ["0", "0"] },\n'
            '  { shape = "particle", mass = "2*M", at = ["0", "-L"] }]',
            "origin",
        ),
        {"moments_of_inertia/body": "2*M*L**2/3", "accelerations/theta": "-g/L*sin(theta)"},
        (True, False),
    ),
]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_pendulum(system: Textbook) -> None:
    assert not differences(system)
    assert not complaints(system.text)


def test_katers_pendulum() -> None:
    """A rod swings as fast about its end as about its centre of oscillation, two thirds down."""
    rod = 'shape = "rod"\nmass = "M"\nlength = "L"\npoints = { other = ["L/6", "0"] }'
    first = Textbook(
        "end", pendulum("L", rod, "start", "theta - pi/2"), {"accelerations/theta": "-3*g/(2*L)*sin(theta)"}
    )
    second = Textbook("two thirds", pendulum("L", rod, "other", "theta + pi/2"), first.results)
    assert not differences(first)
    assert not differences(second)
    assert not complaints(second.text)
