"""Systems of several degrees of freedom, with applied forces, dampers and conditions that stay."""

import pytest

from tests.mechanics.textbook import Textbook, complaints, differences

RODS = """
[parameters]
m = "mass: of each rod"
L = "length: of each rod"
g = "acceleration: gravity"

[coordinates.p]
meaning = "angle of the first rod"
[coordinates.q]
meaning = "angle of the second rod"

[bodies.upper]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "p - pi/2"
[bodies.lower]
shape = "rod"
mass = "m"
length = "L"
angle = "ANGLE"

[interactions.W]
type = "gravity"

[constraints.F]
type = "pivot"
point = "upper.start"
[constraints.N]
type = "pin"
points = ["upper.end", "lower.start"]
"""

LINE = """
[parameters]
m_1 = "mass: of the first"
m_2 = "mass: of the second"
k = "stiffness: of the spring"
s = "length: natural length"

[coordinates.x]
dimension = "length"
meaning = "place of the first"
start = "0"
[coordinates.y]
dimension = "length"
meaning = "place of the second"
start = "s"

[bodies.first]
shape = "particle"
mass = "m_1"
center = ["x", "0"]
[bodies.second]
shape = "particle"
mass = "m_2"
center = ["y", "0"]

[interactions.S]
type = "spring"
between = ["first.center", "second.center"]
stiffness = "k"
natural_length = "s"
"""

SYSTEMS = [
    Textbook(
        "double pendulum of rods, absolute angles",
        RODS.replace("ANGLE", "q - pi/2"),
        {
            "equations_of_motion/mass_matrix/0/0": "4*m*L**2/3",
            "equations_of_motion/mass_matrix/0/1": "m*L**2/2*cos(p - q)",
            "equations_of_motion/mass_matrix/1/1": "m*L**2/3",
            "equations_of_motion/forcing/0": "-m*L**2/2*sin(p - q)*q_dot**2 - 3*m*g*L/2*sin(p)",
            "equations_of_motion/forcing/1": "m*L**2/2*sin(p - q)*p_dot**2 - m*g*L/2*sin(q)",
            "equilibria/0/frequencies_squared/0": "(3 - 6/sqrt(7))*g/L",
            "equilibria/0/frequencies_squared/1": "(3 + 6/sqrt(7))*g/L",
            "potential_energy": "-m*g*L*(3*cos(p) + cos(q))/2",
        },
        (True, False, False, False),
    ),
    Textbook(
        "double pendulum of rods, angle between the rods",
        RODS.replace("ANGLE", "p + q - pi/2"),
        {
            "equations_of_motion/mass_matrix/0/0": "m*L**2*(5/3 + cos(q))",
            "equations_of_motion/mass_matrix/0/1": "m*L**2*(1/3 + cos(q)/2)",
            "equations_of_motion/mass_matrix/1/1": "m*L**2/3",
            "equations_of_motion/forcing/1": "-m*L**2/2*sin(q)*p_dot**2 - m*g*L/2*sin(p + q)",
            "equilibria/0/frequencies_squared/0": "(3 - 6/sqrt(7))*g/L",
        },
    ),
    Textbook(
        "cart with a hinged rod",
        """
[parameters]
M = "mass: of the cart"
m = "mass: of the rod"
b = "length: half the length of the rod"
g = "acceleration: gravity"

[coordinates.x]
dimension = "length"
meaning = "place of the cart"
[coordinates.theta]
meaning = "angle from the downward vertical"

[bodies.cart]
shape = "rectangle"
mass = "M"
width = "2*b"
height = "b"
center = ["x", "0"]
angle = "0"
[bodies.rod]
shape = "rod"
mass = "m"
length = "2*b"
angle = "theta - pi/2"

[interactions.W]
type = "gravity"

[constraints.A]
type = "contact"
point = "cart.bottom_left"
line = "y = -b/2"
[constraints.B]
type = "contact"
point = "cart.bottom_right"
line = "y = -b/2"
[constraints.N]
type = "pin"
points = ["cart.center", "rod.start"]
""",
        {
            "equations_of_motion/mass_matrix/0/0": "M + m",
            "equations_of_motion/mass_matrix/0/1": "m*b*cos(theta)",
            "equations_of_motion/mass_matrix/1/1": "4*m*b**2/3",
            "equations_of_motion/forcing/0": "m*b*sin(theta)*theta_dot**2",
            "equations_of_motion/forcing/1": "-m*g*b*sin(theta)",
            "accelerations/x": "m*sin(theta)*(4*b*theta_dot**2 + 3*g*cos(theta))/(4*(M + m) - 3*m*cos(theta)**2)",
            "equilibria/0/frequencies_squared/0": "3*g*(M + m)/(b*(4*M + m))",
        },
        (True, False),
    ),
    Textbook(
        "two masses and a spring on a line",
        LINE,
        {
            "accelerations/x": "k*(y - x - s)/m_1",
            "accelerations/y": "-k*(y - x - s)/m_2",
            "potential_energy": "k*(y - x - s)**2/2",
            "angular_momentum/O/first/orbital": "0",
        },
    ),
    Textbook(
        "elastic pendulum",
        """
[parameters]
m = "mass: of the bob"
k = "stiffness: of the spring"
s = "length: natural length"
g = "acceleration: gravity"

[coordinates.r]
dimension = "length"
meaning = "length of the spring"
start = "s"
[coordinates.theta]
meaning = "angle from the downward vertical"

[bodies.bob]
shape = "particle"
mass = "m"
center = ["r*sin(theta)", "-r*cos(theta)"]

[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "bob.center"]
stiffness = "k"
natural_length = "s"
""",
        {
            "accelerations/r": "r*theta_dot**2 + g*cos(theta) - k/m*(r - s)",
            "accelerations/theta": "-(g*sin(theta) + 2*r_dot*theta_dot)/r",
        },
    ),
    Textbook(
        "free rod pushed across its end",
        """
[parameters]
M = "mass: of the rod"
L = "length: of the rod"
P = "force: that pushes"

[coordinates.x]
dimension = "length"
meaning = "place of the centre"
[coordinates.y]
dimension = "length"
meaning = "height of the centre"
[coordinates.phi]
meaning = "angle of the rod"

[bodies.rod]
shape = "rod"
mass = "M"
length = "L"
center = ["x", "y"]
angle = "phi"

[interactions.push]
type = "force"
on = "rod.end"
force = ["0", "P"]
frame = "body"
""",
        {
            "accelerations/x": "-P/M*sin(phi)",
            "accelerations/y": "P/M*cos(phi)",
            "accelerations/phi": "6*P/(M*L)",
        },
    ),
    Textbook(
        "flywheel with a motor and a rotary damper",
        """
[parameters]
M = "mass: of the wheel"
R = "length: its radius"
T = "torque: of the motor"
c = "rotary damping: of the bearing"

[coordinates.phi]
meaning = "angle of the wheel"

[bodies.wheel]
shape = "disk"
mass = "M"
radius = "R"
angle = "phi"

[interactions.motor]
type = "couple"
on = "wheel"
couple = "T"
[interactions.drag]
type = "rotary-damper"
between = ["ground", "wheel"]
coefficient = "c"

[constraints.F]
type = "pivot"
point = "wheel.center"
at = "O"
""",
        {"accelerations/phi": "2*(T - c*phi_dot)/(M*R**2)"},
    ),
    Textbook(
        "damped oscillator",
        """
[parameters]
m = "mass: of the block"
k = "stiffness: of the spring"
c = "damping: of the damper"
s = "length: natural length"

[coordinates.x]
dimension = "length"
meaning = "length of the spring"
start = "s"

[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]

[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
natural_length = "s"
[interactions.D]
type = "damper"
between = ["O", "block.center"]
coefficient = "c"
""",
        {"accelerations/x": "-(k*(x - s) + c*x_dot)/m"},
    ),
    Textbook(
        "pendulum pulled by a constant force",
        """
[parameters]
m = "mass: of the rod"
L = "length: of the rod"
P = "force: to the right, at the end"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the downward vertical"

[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "theta - pi/2"

[interactions.W]
type = "gravity"
[interactions.pull]
type = "force"
on = "rod.end"
force = ["P", "0"]

[constraints.F]
type = "pivot"
point = "rod.start"
""",
        {
            "accelerations/theta": "3*(2*P*cos(theta) - m*g*sin(theta))/(2*m*L)",
            "potential_energy": "-m*g*L/2*cos(theta) - P*L*sin(theta)",
            "equilibria/0/at/theta": "atan(2*P/(m*g))",
        },
    ),
    Textbook(
        "projectile",
        """
[parameters]
m = "mass: mass"
g = "acceleration: gravity"

[coordinates.x]
dimension = "length"
meaning = "range"
[coordinates.y]
dimension = "length"
meaning = "height"

[bodies.shot]
shape = "particle"
mass = "m"
center = ["x", "y"]

[interactions.W]
type = "gravity"
""",
        {
            "accelerations/x": "0",
            "accelerations/y": "-g",
            "angular_momentum/O/shot/orbital": "m*(x*y_dot - y*x_dot)",
            "first_integral": "m*(x_dot**2 + y_dot**2)/2 + m*g*y",
        },
    ),
    Textbook(
        "three springs and two masses",
        """
[parameters]
m = "mass: of each"
k = "stiffness: of each spring"
s = "length: natural length"

[coordinates.x]
dimension = "length"
meaning = "place of the first"
start = "s"
[coordinates.y]
dimension = "length"
meaning = "place of the second"
start = "2*s"

[bodies.first]
shape = "particle"
mass = "m"
center = ["x", "0"]
[bodies.second]
shape = "particle"
mass = "m"
center = ["y", "0"]

[interactions.S_1]
type = "spring"
between = ["O", "first.center"]
stiffness = "k"
natural_length = "s"
[interactions.S_2]
type = "spring"
between = ["first.center", "second.center"]
stiffness = "k"
natural_length = "s"
[interactions.S_3]
type = "spring"
between = ["second.center", ["3*s", "0"]]
stiffness = "k"
natural_length = "s"
""",
        {
            "equilibria/0/at/x": "s",
            "equilibria/0/at/y": "2*s",
            "equilibria/0/frequencies_squared/0": "k/m",
            "equilibria/0/frequencies_squared/1": "3*k/m",
        },
        (True,),
    ),
    Textbook(
        "two pendulums joined by a spring of no length",
        """
[parameters]
m = "mass: of each rod"
L = "length: of each rod"
d = "length: between the pivots"
k = "stiffness: of the spring"
g = "acceleration: gravity"

[coordinates.p]
meaning = "angle of the left rod"
[coordinates.q]
meaning = "angle of the right rod"

[bodies.left]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "p - pi/2"
[bodies.right]
shape = "rod"
mass = "m"
length = "L"
start = ["d", "0"]
angle = "q - pi/2"

[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["left.end", "right.end"]
stiffness = "k"

[constraints.F]
type = "pivot"
point = "left.start"
[constraints.G]
type = "pivot"
point = "right.start"
""",
        {
            "equations_of_motion/forcing/0": "-m*g*L/2*sin(p) + k*L*(d*cos(p) + L*sin(q - p))",
            "equations_of_motion/forcing/1": "-m*g*L/2*sin(q) - k*L*(d*cos(q) + L*sin(q - p))",
        },
    ),
    Textbook(
        "bob on a rod, mass welded on, couple in the weld",
        """
[parameters]
m = "mass: of the ring"
R = "length: radius of the ring"
L = "length: of the massless arm"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the downward vertical"
start = "theta_0"
speed = "0"

[bodies.arm]
shape = "rod"
mass = "0"
length = "L"
start = "O"
angle = "theta - pi/2"
[bodies.ring]
shape = "ring"
mass = "m"
radius = "R"

[interactions.W]
type = "gravity"
bodies = ["ring"]

[constraints.F]
type = "pivot"
point = "arm.start"
[constraints.N]
type = "weld"
points = ["arm.end", "ring.center"]
couple = "tau"
""",
        {
            "accelerations/theta": "-g*L*sin(theta)/(L**2 + R**2)",
            "reactions/tau": "-m*g*L*R**2*sin(theta)/(L**2 + R**2)",
        },
        (True, False),
    ),
]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_coupled(system: Textbook) -> None:
    assert not differences(system)
    assert not complaints(system.text)


CRANK = """
[parameters]
J = "moment of inertia: of the crank"
M = "mass: of the crank"
m = "mass: of the piston"
r = "length: of the crank"
b = "length: of the connecting rod"
P = "force: on the piston"

[coordinates.theta]
meaning = "angle of the crank"
start = "pi/3"
[coordinates.phi]
meaning = "angle of the connecting rod under the line"
start = "asin(r*sin(pi/3)/b)"
[coordinates.x]
dimension = "length"
meaning = "place of the piston"

[bodies.crank]
shape = "given"
moment = "J"
mass = "M"
angle = "theta"
points = { pin = ["r", "0"] }
[bodies.link]
shape = "rod"
mass = "0"
length = "b"
angle = "-phi"
[bodies.piston]
shape = "particle"
mass = "m"
center = ["x", "0"]

[interactions.gas]
type = "force"
on = "piston.center"
force = ["-P", "0"]

[constraints.F]
type = "pivot"
point = "crank.center"
at = "O"
[constraints.A]
type = "pin"
points = ["crank.pin", "link.start"]
[constraints.B]
type = "pin"
points = ["link.end", "piston.center"]
[constraints.N]
type = "contact"
point = "piston.center"
line = "y = 0"

[example]
J = "1 kg*m^2"
M = "2 kg"
m = "1 kg"
r = "0.3 m"
b = "1 m"
P = "5 N"
"""


def test_slider_crank() -> None:
    """x = r cos θ + b cos φ with b sin φ = r sin θ: the speed of the piston, and the work that the gas does."""
    ratio = "(-r*sin(theta) - r*cos(theta)*sin(phi)/cos(phi))"
    system = Textbook(
        "slider-crank",
        CRANK,
        {
            "kinetic_energy/total": f"(J + m*{ratio}**2)*theta_dot**2/2",
            "equations_of_motion/mass_matrix/0/0": f"J + m*{ratio}**2",
            "dependent_coordinates/x": "r*cos(theta) + b*cos(phi)",
        },
    )
    assert not differences(system)
    assert not complaints(CRANK)
