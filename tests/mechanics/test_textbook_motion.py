"""Systems of textbooks other than physical pendulums: springs, carts, falls, applied forces."""

import pytest

from tests.mechanics.textbook import Textbook, complaints, differences

SYSTEMS = [
    Textbook(
        "torsion pendulum",
        """
[parameters]
M = "mass: mass"
R = "length: radius"
kappa = "torsion stiffness: of the wire"

[coordinates.theta]
meaning = "angle"
start = "theta_0"
speed = "0"

[bodies.disk]
shape = "disk"
mass = "M"
radius = "R"
angle = "theta"

[interactions.wire]
type = "torsion-spring"
between = ["ground", "disk"]
stiffness = "kappa"

[constraints.F]
type = "pivot"
point = "disk.center"
at = "O"
""",
        {
            "accelerations/theta": "-2*kappa/(M*R**2)*theta",
            "potential_energy": "kappa*theta**2/2",
            "speed_squared/theta": "2*kappa/(M*R**2)*(theta_0**2 - theta**2)",
            "equilibria/0/frequencies_squared/0": "2*kappa/(M*R**2)",
            "reactions/F_x": "0",
        },
        (True,),
    ),
    Textbook(
        "two rotors on a shaft",
        """
[parameters]
J_1 = "moment of inertia: of the first"
J_2 = "moment of inertia: of the second"
M = "mass: of each"
kappa = "torsion stiffness: of the shaft"

[coordinates.phi]
meaning = "angle of the first"
[coordinates.psi]
meaning = "angle of the second"

[bodies.first]
shape = "given"
mass = "M"
moment = "J_1"
angle = "phi"
[bodies.second]
shape = "given"
mass = "M"
moment = "J_2"
angle = "psi"

[interactions.shaft]
type = "torsion-spring"
between = ["first", "second"]
stiffness = "kappa"

[constraints.A]
type = "pivot"
point = "first.center"
at = "O"
[constraints.B]
type = "pivot"
point = "second.center"
at = "O"
""",
        {
            "accelerations/phi": "kappa*(psi - phi)/J_1",
            "accelerations/psi": "-kappa*(psi - phi)/J_2",
            "kinetic_energy/rotational": "J_1*phi_dot**2/2 + J_2*psi_dot**2/2",
            "potential_energy": "kappa*(psi - phi)**2/2",
        },
    ),
    Textbook(
        "rod that falls about a hinge",
        """
[parameters]
M = "mass: mass"
L = "length: length"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle over the horizontal"
start = "0"
speed = "0"

[bodies.rod]
shape = "rod"
mass = "M"
length = "L"
start = "O"
angle = "theta"

[interactions.W]
type = "gravity"

[constraints.F]
type = "pivot"
point = "rod.start"
""",
        {
            "accelerations/theta": "-3*g/(2*L)*cos(theta)",
            "speed_squared/theta": "-3*g/L*sin(theta)",
            "reactions_along_motion/F_x": "9*M*g/4*sin(theta)*cos(theta)",
            "reactions_along_motion/F_y": "M*g*(1 - 3/4*cos(theta)**2 + 3/2*sin(theta)**2)",
            "works/W/rod/translational/value": "-M*g*L/2*sin(theta)",
            "works/F/rod/rotational/value": "-M*g*L/8*sin(theta)",
        },
    ),
    Textbook(
        "stick that falls on a smooth floor",
        """
[parameters]
M = "mass: mass"
b = "length: half the length"
g = "acceleration: gravity"

[coordinates.x]
meaning = "place of the centre"
dimension = "length"
[coordinates.theta]
meaning = "angle with the floor"
start = "theta_0"
speed = "0"
range = ["0", "pi/2"]

[bodies.stick]
shape = "rod"
mass = "M"
length = "2*b"
center = ["x", "b*sin(theta)"]
angle = "theta"

[interactions.W]
type = "gravity"

[constraints.N]
type = "contact"
point = "stick.start"
line = "y = 0"
""",
        {
            "accelerations/x": "0",
            "accelerations/theta": "3*cos(theta)*(b*theta_dot**2*sin(theta) - g)/(b*(1 + 3*cos(theta)**2))",
            "reactions/N": "M*(g - b*theta_dot**2*sin(theta))/(1 + 3*cos(theta)**2)",
        },
    ),
    Textbook(
        "block on an incline with a spring",
        """
[parameters]
M = "mass: mass"
k = "stiffness: of the spring"
s_0 = "length: natural length"
beta = "angle: of the incline"
g = "acceleration: gravity"

[coordinates.s]
dimension = "length"
meaning = "distance from the top, down the incline"
start = "s_0"
speed = "0"

[bodies.block]
shape = "particle"
mass = "M"
center = ["-s*cos(beta)", "-s*sin(beta)"]

[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
natural_length = "s_0"

[constraints.N]
type = "contact"
point = "block.center"
line = "y = x*tan(beta)"
side = "positive"
""",
        {
            "accelerations/s": "g*sin(beta) - k/M*(s - s_0)",
            "equilibria/0/at/s": "s_0 + M*g*sin(beta)/k",
            "equilibria/0/frequencies_squared/0": "k/M",
            "reactions/N": "M*g*cos(beta)",
            "speed_squared/s": "2*g*sin(beta)*(s - s_0) - k/M*(s - s_0)**2",
            "works/N/block/translational/value": "0",
        },
        (True,),
    ),
    Textbook(
        "rod on a hinge with a spiral spring",
        """
[parameters]
M = "mass: mass"
L = "length: length"
kappa = "torsion stiffness: of the spring"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the upward vertical, counter-clockwise"

[bodies.rod]
shape = "rod"
mass = "M"
length = "L"
start = "O"
angle = "theta + pi/2"

[interactions.W]
type = "gravity"
[interactions.S]
type = "torsion-spring"
between = ["ground", "rod"]
stiffness = "kappa"
rest_angle = "pi/2"

[constraints.F]
type = "pivot"
point = "rod.start"
""",
        {
            "accelerations/theta": "3*g/(2*L)*sin(theta) - 3*kappa/(M*L**2)*theta",
            "potential_energy": "M*g*L/2*cos(theta) + kappa*theta**2/2",
        },
    ),
    Textbook(
        "inverted pendulum held by a spring from above",
        """
[parameters]
M = "mass: mass"
L = "length: length"
h = "length: height of the upper end of the spring"
k = "stiffness: of the spring"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the upward vertical, counter-clockwise"

[bodies.rod]
shape = "rod"
mass = "M"
length = "L"
start = "O"
angle = "theta + pi/2"

[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = [["0", "h"], "rod.end"]
stiffness = "k"

[constraints.F]
type = "pivot"
point = "rod.start"
""",
        {
            "accelerations/theta": "(3*g/(2*L) - 3*k*h/(M*L))*sin(theta)",
            "equilibria/0/frequencies_squared/0": "3*k*h/(M*L) - 3*g/(2*L)",
        },
        (None, None),
    ),
    Textbook(
        "rod with a mass welded to its end",
        """
[parameters]
m = "mass: of the rod"
M = "mass: of the bob"
L = "length: of the rod"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the downward vertical"
start = "theta_0"
speed = "0"

[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "theta - pi/2"
[bodies.bob]
shape = "particle"
mass = "M"

[interactions.W]
type = "gravity"

[constraints.F]
type = "pivot"
point = "rod.start"
[constraints.N]
type = "pin"
points = ["rod.end", "bob.center"]
""",
        {
            "accelerations/theta": "-3*g*(m + 2*M)*sin(theta)/(2*L*(m + 3*M))",
            "angular_momentum/O/bob/orbital": "M*L**2*theta_dot",
            "equilibria/0/frequencies_squared/0": "3*g*(m + 2*M)/(2*L*(m + 3*M))",
            "works/N/bob/translational/value": "m*M*g*L*(cos(theta) - cos(theta_0))/(2*(m + 3*M))",
        },
        (True, False),
    ),
    Textbook(
        "simple pendulum, its rod without mass",
        """
[parameters]
M = "mass: of the bob"
L = "length: of the rod"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle from the downward vertical"
start = "theta_0"
speed = "0"

[bodies.rod]
shape = "rod"
mass = "0"
length = "L"
start = "O"
angle = "theta - pi/2"
[bodies.bob]
shape = "particle"
mass = "M"

[interactions.W]
type = "gravity"
bodies = ["bob"]

[constraints.F]
type = "pivot"
point = "rod.start"
[constraints.N]
type = "pin"
points = ["rod.end", "bob.center"]
""",
        {
            "accelerations/theta": "-g/L*sin(theta)",
            "reactions_along_motion/F_y": "M*g*cos(theta)*(3*cos(theta) - 2*cos(theta_0))",
            "reactions_along_motion/F_x": "-M*g*sin(theta)*(3*cos(theta) - 2*cos(theta_0))",
        },
        (True, False),
    ),
    Textbook(
        "dumbbell that slides between wall and floor",
        """
[parameters]
M = "mass: of each end"
L = "length: between the ends"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle with the floor"
start = "theta_0"
speed = "0"
range = ["0", "pi/2"]

[bodies.dumbbell]
shape = "composite"
parts = [{ shape = "particle", mass = "M", at = ["-L/2", "0"] }, { shape = "particle", mass = "M", at = ["L/2", "0"] }]
points = { foot = ["-L/2", "0"], head = ["L/2", "0"] }
angle = "pi - theta"

[interactions.W]
type = "gravity"

[constraints.A]
type = "contact"
point = "dumbbell.head"
line = "x = 0"
[constraints.B]
type = "contact"
point = "dumbbell.foot"
line = "y = 0"
""",
        {
            "moments_of_inertia/dumbbell": "M*L**2/2",
            "accelerations/theta": "-g/L*cos(theta)",
            "speed_squared/theta": "2*g/L*(sin(theta_0) - sin(theta))",
            "reactions_along_motion/A": "M*g*cos(theta)*(3*sin(theta) - 2*sin(theta_0))",
            "conditions/0/at/theta": "asin(2/3*sin(theta_0))",
        },
    ),
    Textbook(
        "rod in a right-angled groove",
        """
[parameters]
M = "mass: mass"
b = "length: half the length"
g = "acceleration: gravity"

[coordinates.phi]
meaning = "angle with the horizontal"
range = ["-pi/4", "pi/4"]

[bodies.rod]
shape = "rod"
mass = "M"
length = "2*b"
angle = "phi"

[interactions.W]
type = "gravity"

[constraints.A]
type = "contact"
point = "rod.start"
line = "y = -x"
[constraints.B]
type = "contact"
point = "rod.end"
line = "y = x"
""",
        {
            "accelerations/phi": "3*g/(4*b)*sin(phi)",
            "equilibria/0/at/phi": "0",
            "equilibria/0/frequencies_squared/0": "-3*g/(4*b)",
        },
        (False,),
    ),
]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_motion(system: Textbook) -> None:
    assert not differences(system)
    assert not complaints(system.text)
