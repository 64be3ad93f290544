"""Questions of textbooks about parameters, with their published answers; problems that do not ship stand here.

The answers were written down from the sources before the engine was asked.
"""

HEAD = '''
[parameters]
m = "mass: mass"
M = "mass: another mass"
L = "length: length"
R = "length: radius"
d = "length: distance"
g = "acceleration: gravity"
{more}
'''

SWING = '''
[coordinates.theta]
meaning = "angle from the downward vertical"
start = "0"
speed = "{speed}"
range = ["-pi", "2*pi"]
[interactions.W]
type = "gravity"
'''

BOB = (
    HEAD.format(more='v_0 = "speed: speed at the lowest place"')
    + SWING.format(speed="v_0/L")
    + '''
[bodies.bob]
shape = "particle"
mass = "m"
center = ["L*sin(theta)", "-L*cos(theta)"]
[points]
P = ["0", "0"]
[constraints.T]
type = "{kind}"
{joins}
'''
)
ON_STRING = BOB.format(kind="string", joins='path = ["P", "bob.center"]')
ON_ROD = BOB.format(kind="guide", joins='point = "bob.center"\ncircle = "O"\nradius = "L"')

HANGING_ROD = (
    HEAD.format(more='omega_0 = "angular speed: at the lowest place"')
    + SWING.format(speed="omega_0")
    + '''
[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "theta - pi/2"
[constraints.F]
type = "pivot"
point = "rod.start"
'''
)

ROD_OFF_CENTER = '''
[parameters]
m = "mass: mass"
L = "length: length"
d = "length < L/2: distance of the pivot from the centre"
g = "acceleration: gravity"
[coordinates.theta]
meaning = "angle from the downward vertical"
start = "theta_0"
speed = "0"
range = ["-pi", "pi"]
[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
angle = "theta - pi/2"
points = { pin = ["-d", "0"] }
pin = "O"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "rod.pin"
'''

OFF_SPHERE = (
    HEAD.format(more='v_0 = "speed: speed at the top"')
    + '''
[coordinates.theta]
meaning = "angle from the upward vertical"
start = "0"
speed = "{speed}"
range = ["0", "pi"]
[bodies.bead]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "R*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "bead.center"
circle = "O"
radius = "R"
side = "outside"
'''
)

LOOP = (
    HEAD.format(more='h = "length: height of the start above the lowest place"')
    + SWING.format(speed="sqrt(2*g*h)/R")
    + '''
[bodies.car]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "-R*cos(theta)"]
[constraints.N]
type = "contact"
point = "car.center"
circle = "O"
radius = "R"
side = "inside"
'''
)

PULLED_BLOCK = '''
[parameters]
m = "mass: mass"
P = "force: pull"
phi = "angle, acute: of the pull over the horizontal"
mu = "number: coefficient of static friction"
g = "acceleration: gravity"
[bodies.block]
shape = "particle"
mass = "m"
center = ["0", "0"]
[interactions.W]
type = "gravity"
[interactions.P]
type = "force"
on = "block.center"
force = ["P*cos(phi)", "P*sin(phi)"]
[constraints.N]
type = "sticking"
point = "block.center"
line = "y = 0"
limit = "mu"
friction = "f"
'''

TALL_BOX = '''
[parameters]
m = "mass: mass"
b = "length: width"
h = "length: height"
beta = "angle, acute: slope"
mu = "number: coefficient of static friction"
g = "acceleration: gravity"
[bodies.box]
shape = "rectangle"
mass = "m"
width = "b"
height = "h"
bottom = "O"
angle = "-beta"
[interactions.W]
type = "gravity"
[constraints.N_low]
type = "sticking"
point = "box.bottom_right"
line = "y = -x*tan(beta)"
limit = "mu"
friction = "f"
[constraints.N_high]
type = "contact"
point = "box.bottom_left"
line = "y = -x*tan(beta)"
'''

INCLINE = '''
[parameters]
m = "mass: mass"
beta = "angle, acute: slope"
mu = "number: coefficient of static friction"
g = "acceleration: gravity"
[bodies.block]
shape = "particle"
mass = "m"
center = ["0", "0"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "sticking"
point = "block.center"
line = "y = -x*tan(beta)"
limit = "mu"
friction = "f"
'''

HANGING_MASS = '''
[parameters]
M = "mass: mass on the slope"
m = "mass: hanging mass"
beta = "angle, acute: slope"
mu = "number: coefficient of static friction"
a = "length: height of the pulley"
g = "acceleration: gravity"
[bodies.block]
shape = "particle"
mass = "M"
center = ["-a*cos(beta)", "-a*sin(beta)"]
[bodies.weight]
shape = "particle"
mass = "m"
center = ["0", "-a"]
[points]
Q = ["0", "0"]
[interactions.W]
type = "gravity"
[constraints.S]
type = "string"
path = ["block.center", { around = "Q" }, "weight.center"]
[constraints.N]
type = "sticking"
point = "block.center"
line = "y = x*tan(beta)"
limit = "mu"
friction = "f"
'''

UPRIGHT = '''
[parameters]
m = "mass: mass"
L = "length: length"
k = "torsion stiffness: stiffness"
g = "acceleration: gravity"
[coordinates.theta]
meaning = "angle from the upward vertical"
start = "theta_0"
range = ["-pi", "pi"]
[bodies.rod]
shape = "rod"
mass = "m"
length = "L"
start = "O"
angle = "theta + pi/2"
[interactions.W]
type = "gravity"
[interactions.S]
type = "torsion-spring"
between = ["ground", "rod"]
stiffness = "k"
rest_angle = "pi/2"
[constraints.F]
type = "pivot"
point = "rod.start"
'''

TURNING_HOOP = '''
[parameters]
m = "mass: mass of the bead"
R = "length: radius of the hoop"
Omega = "angular speed: of the hoop about the vertical"
g = "acceleration: gravity"
[coordinates.theta]
meaning = "angle from the lowest place"
start = "theta_0"
speed = "0"
range = ["-pi", "pi"]
[bodies.bead]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "-R*cos(theta)"]
[interactions.W]
type = "gravity"
[interactions.Z]
type = "force"
on = "bead.center"
force = ["m*Omega**2*R*sin(theta)", "0"]
[constraints.N]
type = "guide"
point = "bead.center"
circle = "O"
radius = "R"
'''

ROLLING = '''
[parameters]
m = "mass: mass"
R = "length: radius"
c = "number: I/(m R^2)"
beta = "angle, acute: slope"
mu = "number: coefficient of static friction"
g = "acceleration: gravity"
[coordinates.s]
meaning = "way down the slope"
dimension = "length"
start = "0"
speed = "0"
[coordinates.phi]
meaning = "angle turned, clockwise"
[bodies.body]
shape = "given"
mass = "m"
moment = "c*m*R**2"
cm = ["s*cos(beta) + R*sin(beta)", "-s*sin(beta) + R*cos(beta)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "body"
rim = "R"
line = "y = -x*tan(beta)"
friction = "f"
limit = "mu"
'''

VIBRATING_PLANK = '''
[parameters]
m = "mass: mass of the block"
A = "length: amplitude"
w = "angular speed: angular frequency"
g = "acceleration: gravity"
[coordinates.y]
meaning = "height of the block"
dimension = "length"
start = "0"
speed = "0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["0", "y"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "prescribed"
point = "block.center"
distance = "A*sin(w*t)"
along = ["0", "1"]
'''

PULLED_CYLINDER = '''
[parameters]
m = "mass: mass"
R = "length: radius"
P = "force: pull"
h = "length < R: height of the pull over the centre"
mu = "number: coefficient of static friction"
g = "acceleration: gravity"
[coordinates.x]
meaning = "place"
dimension = "length"
start = "0"
speed = "0"
[coordinates.phi]
meaning = "angle turned, clockwise"
[bodies.roller]
shape = "cylinder"
mass = "m"
radius = "R"
center = ["x", "R"]
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.P]
type = "force"
on = "roller.center"
force = ["P", "0"]
[interactions.C]
type = "couple"
on = "roller"
couple = "-P*h"
[constraints.N]
type = "rolling"
body = "roller"
line = "y = 0"
friction = "f"
limit = "mu"
'''

# problem, question, published answer (None: the sentence must hold this word instead), source
QUESTIONS = (
    (ON_STRING, "smallest v_0 for which theta reaches pi", "sqrt(5*g*L)", "Halliday & Resnick 8; Irodov 1.122"),
    (ON_STRING, "smallest v_0 for which T stays positive until theta = pi", "sqrt(5*g*L)", "Taylor 4"),
    (ON_STRING, "smallest v_0 for which theta reaches pi/2", "sqrt(2*g*L)", "Halliday & Resnick 8"),
    (ON_ROD, "smallest v_0 for which theta reaches pi", "2*sqrt(g*L)", "Halliday & Resnick 8; Goldstein 1"),
    (ON_ROD, "v_0 for which T where theta = pi vanishes", "sqrt(5*g*L)", "Morin 5"),
    (HANGING_ROD, "smallest omega_0 for which theta reaches pi", "sqrt(6*g/L)", "Halliday & Resnick 10; Spiegel 9"),
    (HANGING_ROD, "smallest omega_0 for which theta reaches pi/2", "sqrt(3*g/L)", "Beer & Johnston 17"),
    (ROD_OFF_CENTER, "d for which period of theta is least", "L/(2*sqrt(3))", "Irodov 4.42; Morin 8"),
    (ROD_OFF_CENTER, "least period of theta over d", "2*pi*sqrt(L/(sqrt(3)*g))", "Irodov 4.42"),
    (ROD_OFF_CENTER, "d and d_2 with equal period of theta", "L**2/(12*d)", "Kleppner & Kolenkow 6 (Kater)"),
    (ROD_OFF_CENTER, "period of theta with d = L/6", "2*pi*sqrt(2*L/(3*g))", "Halliday & Resnick 15"),
    (ROD_OFF_CENTER, "period of theta in the limit d -> L/2", "2*pi*sqrt(2*L/(3*g))", "Halliday & Resnick 15"),
    (OFF_SPHERE.format(speed="0"), "theta for which N vanishes", "acos(2/3)", "Kleppner & Kolenkow 5; Irodov 1.123"),
    (OFF_SPHERE.format(speed="v_0/R"), "smallest v_0 for which N at the start vanishes", "sqrt(g*R)", "Taylor 4"),
    (OFF_SPHERE.format(speed="v_0/R"), "theta for which N vanishes", "acos(2/3 + v_0**2/(3*g*R))", "Morin 5"),
    (LOOP, "smallest h for which theta reaches pi", "5*R/2", "Kleppner & Kolenkow 5; Halliday & Resnick 8"),
    (LOOP, "h for which N at the start = 6*m*g", "5*R/2", "Halliday & Resnick 8"),
    (PULLED_BLOCK, "largest P for which it does not slip", "mu*m*g/(cos(phi) + mu*sin(phi))", "Meriam & Kraige, Statics 6"),
    (PULLED_BLOCK, "smallest mu for which it does not slip", "P*cos(phi)/(m*g - P*sin(phi))", "Meriam & Kraige, Statics 6"),
    (TALL_BOX, "largest beta for which N_high stays positive", "atan(b/h)", "Meriam & Kraige, Statics 6"),
    (INCLINE, "largest beta for which it does not slip", "atan(mu)", "Kleppner & Kolenkow 2; Halliday & Resnick 6"),
    (HANGING_MASS, "smallest m for which it does not slip", "M*(sin(beta) - mu*cos(beta))", "Halliday & Resnick 6"),
    (HANGING_MASS, "largest m for which it does not slip", "M*(sin(beta) + mu*cos(beta))", "Halliday & Resnick 6"),
    (UPRIGHT, "smallest k for which theta = 0 is stable", "m*g*L/2", "Meriam & Kraige, Dynamics 8"),
    (UPRIGHT, "k for which theta = 0 is stable", "m*g*L/2", "Beer & Johnston 19"),
    (TURNING_HOOP, "largest Omega for which theta = 0 is stable", "sqrt(g/R)", "Goldstein 2; Taylor 7"),
    (ROLLING, "acceleration of s with c = 2/5", "5*g*sin(beta)/7", "Halliday & Resnick 11"),
    (ROLLING, "acceleration of s with c = 1/2 and beta = pi/6", "g/3", "Kleppner & Kolenkow 6"),
    (ROLLING, "smallest mu for which it does not slip", "c*tan(beta)/(1 + c)", "Morin 7; Goldstein 1"),
    (ROLLING, "largest beta for which it does not slip", "atan(mu*(1 + c)/c)", "Beer & Johnston 16"),
    (ROLLING, "acceleration of s in the limit c -> 0", "g*sin(beta)", "Morin 7"),
    (ROLLING, "does acceleration of s depend on m", "no", "Halliday & Resnick 11"),
    (VIBRATING_PLANK, "largest A for which N stays positive", "g/w**2", "Irodov 4.19; Halliday & Resnick 15"),
    (PULLED_CYLINDER, "h for which f vanishes", "R/2", "Kleppner & Kolenkow 6; Morin 7"),
    (PULLED_CYLINDER, "smallest mu for which it does not slip", "P*(R - 2*h)/(3*m*g*R)", "Beer & Johnston 16"),
    (PULLED_CYLINDER, "acceleration of x with h = 0", "2*P/(3*m)", "Halliday & Resnick 11"),
    ("ball-in-a-loop", "smallest v_0 for which theta reaches pi", "sqrt(27*g*(R - a)/7)", "Kleppner & Kolenkow 6"),
    ("ball-in-a-loop", "smallest v_0 for which theta reaches pi/2", "sqrt(10*g*(R - a)/7)", "Meriam & Kraige, Dynamics 6"),
    ("bicycle-wheelie", "A at which N_f vanishes", "g*b/h", "Beer & Johnston 16"),
    ("rear-wheel-drive", "F at which N_f vanishes", "m*g*b/h", "Beer & Johnston 16"),
    ("breaking-chimney", "s for which magnitude of couple of C on upper is greatest", "ell/3", "Madsen, AJP 45 (1977) 182"),
    ("wheel-over-kerb", "P at which N vanishes", "M*g*sqrt(2*R*h - h**2)/(R - h)", "Meriam & Kraige, Statics 3"),
    ("disk-off-center", "d for which period of theta is least", "R/sqrt(2)", "Morin 8; Irodov 4.43"),
    ("ladder-with-friction", "largest d for which it does not slip", "(mu*(M + m)*ell*tan(beta) - M*ell/2)/m", "Spiegel 9"),
    ("ladder-with-friction", "smallest mu for which it does not slip", "(M/2 + m*d/ell)/((M + m)*tan(beta))",
     "Meriam & Kraige, Statics 6"),
    ("ring-on-incline", "smallest mu for which it does not slip", "tan(beta)/2", "Irodov 1.254"),
    ("cylinder-off-cylinder", "theta for which N vanishes", "acos(4/7)", "Goldstein 2; Meriam & Kraige 6"),
    ("spool-pulled-at-angle", "beta for which acceleration of x vanishes", "acos(b/R)", "Kleppner & Kolenkow 6"),
    ("wheel-pulled-by-axle", "largest P for which it does not slip", "mu_s*m*g*(1 + r**2/k**2)", "Beer & Johnston 16"),
    ("block-sliding-or-tipping", "P for which A vanishes", "m*g*(c - mu*b)/(2*h - b)", "Beer & Johnston 16"),
    ("atwood-with-massive-pulley", "acceleration of x for M_1 >> M_2", "M_1*g/(M_1 + M_p/2)", "Morin 3"),
    ("atwood-with-massive-pulley", "acceleration of x with M_p = 0", "g*(M_1 - M_2)/(M_1 + M_2)", "Kleppner & Kolenkow 2"),
    ("center-of-percussion", "b for which impulse of F_x when struck begins vanishes", "2*ell/3",
     "Kleppner & Kolenkow 6; Goldstein 5"),
    ("billiard-ball-struck-high", "h for which speed of phi when rolling begins = 0", "there is no such h", "Sommerfeld IV"),
    ("ball-with-backspin", "omega_0 for which speed of x when rolling begins vanishes", "5*v_0/(2*r)", "Kleppner & Kolenkow 6"),
    ("sliding-ladder", "theta for which N_w vanishes", "asin(2*sin(theta_0)/3)", "Morin 8; Goldstein"),
    (INCLINE, "smallest beta for which it slips", "atan(mu)", "Halliday & Resnick 6"),
    (INCLINE, "for which beta does it not slip?", "atan(mu)", "Halliday & Resnick 6"),
    (PULLED_BLOCK, "smallest P for which it slips", "mu*m*g/(cos(phi) + mu*sin(phi))", "Meriam & Kraige, Statics 6"),
    (TALL_BOX, "smallest beta for which it tips", "atan(b/h)", "Meriam & Kraige, Statics 6"),
    (ON_STRING, "what is the smallest v_0 for which theta just reaches pi?", "sqrt(5*g*L)", "Halliday & Resnick 8"),
    (ON_STRING, "largest T over theta between 0 and pi", "m*(g + v_0**2/L)", "Halliday & Resnick 8"),
    (ROD_OFF_CENTER, "for which d is the period shortest", "L/(2*sqrt(3))", "Irodov 4.42"),
    (ROD_OFF_CENTER, "d and d_2 with equal periods", "L**2/(12*d)", "Kleppner & Kolenkow 6 (Kater)"),
    (UPRIGHT, "for which k is theta = 0 stable", "m*g*L/2", "Meriam & Kraige, Dynamics 8"),
    ("rod-pendulum", "largest kinetic energy over theta", "M*g*ell*(1 - cos(theta_0))/2", "Halliday & Resnick 10"),
    ("rod-pendulum", "largest magnitude of velocity of rod.end over theta", "sqrt(3*g*ell*(1 - cos(theta_0)))",
     "Halliday & Resnick 10"),
    ("bullet-in-a-rod", "smallest v_0 for which theta reaches pi",
     "sqrt(2*g*(M*ell + 2*m*d)*(M*ell**2 + 3*m*d**2)/3)/(m*d)", "Kleppner & Kolenkow 6; Halliday & Resnick 11"),
    ("center-of-percussion", "smallest J for which theta reaches pi", "M*ell*sqrt(6*g*ell)/(3*b)", "Beer & Johnston 17"),
    ("cart-and-rod", "theta_dot^2 for M >> m", "3*g*(cos(theta) - cos(theta_0))/ell", "Morin 5"),
)  # fmt: skip
