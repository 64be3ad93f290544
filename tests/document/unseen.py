"""Problems that no part of the program knows, for tests of the notes: title, then the file."""

HEAD = """
title = "{title}"
[parameters]
M = "mass: mass"
m = "mass: smaller mass"
R = "length: length"
k = "stiffness: stiffness"
kappa = "torsion stiffness: stiffness of the wire"
beta = "angle: slope"
g = "acceleration: gravity"
"""

TORSION = """
[coordinates.phi]
meaning = "angle of twist"
start = "phi_0"
[bodies.plate]
shape = "rectangle"
mass = "M"
width = "R"
height = "2*R"
center = "O"
angle = "phi"
[interactions.T]
type = "torsion-spring"
between = ["ground", "plate"]
stiffness = "kappa"
[constraints.P]
type = "pivot"
point = "plate.center"
"""

DOUBLE = """
[coordinates.a]
meaning = "angle of the first rod"
start = "a_0"
[coordinates.b]
meaning = "angle of the second rod"
start = "b_0"
[bodies.rod_1]
shape = "rod"
mass = "M"
length = "R"
start = "O"
angle = "a - pi/2"
[bodies.rod_2]
shape = "rod"
mass = "m"
length = "R"
angle = "b - pi/2"
[interactions.W]
type = "gravity"
[constraints.P]
type = "pivot"
point = "rod_1.start"
[constraints.Q]
type = "pin"
points = ["rod_1.end", "rod_2.start"]
"""

INCLINE = """
[coordinates.s]
dimension = "length"
meaning = "distance along the slope"
start = "s_0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["s*cos(beta)", "s*sin(beta)"]
[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
natural_length = "R"
[constraints.N]
type = "contact"
point = "block.center"
line = "y = x*tan(beta)"
"""

HOLED = """
[coordinates.theta]
meaning = "angle"
start = "theta_0"
speed = "omega_0"
[bodies.plate]
shape = "composite"
mass = "M"
angle = "theta + pi/2"
origin = "O"
[[bodies.plate.parts]]
shape = "disk"
radius = "R"
at = ["0", "0"]
[[bodies.plate.parts]]
shape = "disk"
radius = "R/2"
at = ["R/2", "0"]
removed = true
[interactions.W]
type = "gravity"
[constraints.P]
type = "pivot"
point = "plate.origin"
"""

TRIANGLE = """
[coordinates.theta]
meaning = "angle of the base with the horizontal"
start = "theta_0"
[bodies.plate]
shape = "triangle"
mass = "M"
base = "R"
height = "2*R"
left = "O"
angle = "theta"
[interactions.W]
type = "gravity"
[interactions.Q]
type = "force"
on = "plate.right"
force = ["m*g", "0"]
[constraints.P]
type = "pivot"
point = "plate.left"
"""

FALLING = """
[coordinates.x]
dimension = "length"
meaning = "place of the centre"
start = "0"
[coordinates.theta]
meaning = "angle with the floor"
start = "theta_0"
range = ["0", "pi/2"]
[bodies.stick]
shape = "rod"
mass = "M"
length = "R"
center = ["x", "R/2*sin(theta)"]
angle = "theta"
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "stick.start"
line = "y = 0"
"""

BODIES = {
    "torsion pendulum": TORSION,
    "double pendulum": DOUBLE,
    "block on a slope": INCLINE,
    "disk with a hole": HOLED,
    "triangle with a force": TRIANGLE,
    "falling stick": FALLING,
}
UNSEEN = {title: HEAD.format(title=title) + body for title, body in BODIES.items()}
