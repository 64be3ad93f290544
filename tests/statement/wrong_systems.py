"""Systems that can't be meant: impossible geometry, contradictions, two names for one thing, too little said.

Each row edits one of three sound statements.
"""

from __future__ import annotations

from dataclasses import dataclass

BALL = """\
title = "A ball that slips until it rolls"

[parameters]
M   = "mass: mass"
R   = "length: radius"
mu  = "number: coefficient of friction"
v_0 = "speed: speed at first"
h   = "length: a length"
g   = "acceleration: gravity"

[coordinates.x]
meaning   = "place"
dimension = "length"
start     = "0"
speed     = "v_0"

[coordinates.phi]
meaning = "angle"
start   = "0"

[bodies.ball]
shape  = "ball"
mass   = "M"
radius = "R"
center = ["x", "R"]
angle  = "-phi"

[interactions.W]
type = "gravity"

[constraints.N]
type        = "touch"
body        = "ball"
line        = "y = 0"
coefficient = "mu"

[[phases]]
name        = "rolling"
event       = "no slip"
of          = "N"
constraints = { N = { type = "rolling" } }
"""

IMPACT = """\
title = "A ball against a hanging rod"

[parameters]
M   = "mass: mass of the rod"
m   = "mass: mass of the ball"
ell = "length: length"
b   = "length < ell: distance of the path from the pivot"
v_0 = "speed: speed of the ball"
e   = "number: restitution"
J   = "impulse: a blow"
g   = "acceleration: gravity"

[coordinates.theta]
meaning = "angle of the rod"
start   = "0"

[coordinates.x]
meaning   = "place of the ball"
dimension = "length"
start     = "0"
speed     = "v_0"

[coordinates.y]
meaning   = "height of the ball"
dimension = "length"
start     = "0"

[bodies.rod]
shape  = "rod"
mass   = "M"
length = "ell"
start  = "O"
angle  = "theta - pi/2"
points = { spot = ["b - ell/2", "0"] }

[bodies.ball]
shape  = "particle"
mass   = "m"
center = ["x", "y - b"]

[interactions.W]
type = "gravity"

[constraints.F]
type  = "pivot"
point = "rod.start"

[[phases]]
name = "bounced"

[phases.impulses.K]
type        = "collision"
points      = ["ball.center", "rod.spot"]
along       = ["1", "0"]
restitution = "e"
"""

WHEEL = """\
title = "A wheel on a slope, held by static friction"

[parameters]
M    = "mass: mass"
R    = "length: radius"
r    = "length: another radius"
beta = "angle, acute: slope"
mu   = "number: coefficient of friction"
c    = "stiffness: stiffness"
g    = "acceleration: gravity"

[coordinates.s]
meaning   = "distance"
dimension = "length"
start     = "0"

[coordinates.phi]
meaning = "angle"

[bodies.wheel]
shape  = "disk"
mass   = "M"
radius = "R"
center = ["s*cos(beta) + R*sin(beta)", "-s*sin(beta) + R*cos(beta)"]
angle  = "-phi"

[interactions.W]
type = "gravity"

[constraints.N]
type     = "rolling"
body     = "wheel"
line     = "y = -x*tan(beta)"
friction = "f"
limit    = "mu"
"""


@dataclass(frozen=True)
class Wrong:
    """`old` of the statement becomes `new`; the error says `says`, and `cure`."""

    name: str
    base: str
    old: str
    new: str
    says: str
    cure: str = ""

    @property
    def text(self) -> str:
        """The wrong statement."""
        assert self.base.count(self.old) == 1, f"{self.name}: {self.old!r} must stand once"
        return self.base.replace(self.old, self.new)


ROLLING = """\
[[phases]]
name        = "rolling"
event       = "no slip"
of          = "N"
constraints = { N = { type = "rolling" } }
"""
EVENT = 'event       = "no slip"\nof          = "N"'
LINE = 'line     = "y = -x*tan(beta)"'
COLLISION = """\
[phases.impulses.K]
type        = "collision"
points      = ["ball.center", "rod.spot"]
along       = ["1", "0"]
restitution = "e"
"""


def phase(name: str, old: str, new: str, says: str, cure: str = "") -> Wrong:
    return Wrong(name, BALL, old, new, says, cure)


BOUNCE = '''
[parameters]
M = "mass: mass"
R = "length: radius"
v = "speed: along the floor"
u = "speed: of falling"
e = "number < 1: restitution"
mu = "number: friction"

[coordinates]
x = { dimension = "length", start = "0", speed = "v" }
y = { dimension = "length", start = "R", speed = "-u" }
phi = { start = "0" }

[bodies.ball]
shape = "ball"
mass = "M"
radius = "R"
center = ["x", "y"]
angle = "phi"

[[phases]]
name = "bounced"
impulses = { J = { type = "bounce", body = "ball", line = "y = 0", restitution = "e", coefficient = "mu", slip = "none" } }
'''


def bounce(name: str, old: str, new: str, says: str, then: str = "", other: str = "") -> Wrong:
    """`then` becomes `other` too."""
    return Wrong(name, BOUNCE.replace(then, other) if then else BOUNCE, old, new, says)


def impact(name: str, old: str, new: str, says: str, cure: str = "") -> Wrong:
    return Wrong(name, IMPACT, old, new, says, cure)


def wheel(name: str, old: str, new: str, says: str, cure: str = "") -> Wrong:
    return Wrong(name, WHEEL, old, new, says, cure)


ROWS = [
    # --- bounds of parameters
    wheel(
        "bound of another dimension", '"length: another', '"length > M: another', "must be a length, but this is a mass"
    ),
    wheel("bound of nobody's name", '"length: another', '"length > q: another', "unknown symbol “q”"),
    wheel("bound that moves", '"length: another', '"length > s: another', "unknown symbol “s”"),
    wheel("bound by itself", '"length: another', '"length > r: another', "its own bound"),
    wheel(
        "bounds in a circle",
        '"length: radius"\nr    = "length:',
        '"length > r: radius"\nr    = "length > R:',
        "contradict",
    ),
    wheel("bound without a value", '"length: another', '"length >: another', "ends too early", "missing here"),
    wheel("acute length", '"length: another', '"length, acute: another', "can't be acute", "only an angle"),
    wheel("range that is no list", '"length: another radius"', '{ dimension = "length", range = "R" }', "list of two"),
    # --- geometry
    wheel(
        "wheel in the air",
        'center = ["s*cos(beta) + R*sin(beta)", "-s*sin(beta) + R*cos(beta)"]',
        'center = ["s*cos(beta) + r*sin(beta)", "-s*sin(beta) + r*cos(beta)"]',
        "does not touch the curve",
        "place",
    ),
    wheel(
        "wheel that rolls on its hub in the air", 'limit    = "mu"', 'rim = "r"', "does not touch the curve", "place"
    ),
    wheel("wheel without a place or a line", LINE, "", "touches nothing", "line ="),
    wheel("wheel beside its circle", LINE, 'circle = "O"\nradius = "r"', "does not touch the curve", "place"),
    wheel("line upright and slanted", LINE, 'line = "x = x"', "is not a straight line"),
    wheel("wheel that can't turn", 'angle  = "-phi"', 'angle  = "0"', "no body's pose uses the coordinate “phi”"),
    wheel("radius that is negative", 'radius = "R"', 'radius = "-R"', "must be positive"),
    # --- one thing twice
    wheel(
        "rolls and slides",
        "[constraints.N]",
        f'[constraints.S]\ntype = "touch"\nbody = "wheel"\n{LINE}\n\n[constraints.N]',
        "says again what “S” says",
        "remove one",
    ),
    wheel(
        "rolls twice",
        "[constraints.N]",
        f'[constraints.S]\ntype = "rolling"\nbody = "wheel"\n{LINE}\n\n[constraints.N]',
        "says again",
    ),
    wheel(
        "gravity twice",
        "[interactions.W]",
        '[interactions.V]\ntype = "gravity"\n\n[interactions.W]',
        "acts already",
        "remove one",
    ),
    wheel("friction called like the normal force", 'friction = "f"', 'friction = "N"', "“N”"),
    wheel("friction called like a parameter", 'friction = "f"', 'friction = "mu"', "“mu”"),
    wheel("friction called like a coordinate", 'friction = "f"', 'friction = "phi"', "“phi”"),
    wheel("force called like a body", "[constraints.N]", "[constraints.wheel]", "“wheel”"),
    # --- friction
    wheel(
        "rolling with a kinetic coefficient",
        'limit    = "mu"',
        'coefficient = "mu"',
        "unknown key “coefficient”",
        "limit",
    ),
    wheel("limit that is negative", 'limit    = "mu"', 'limit    = "-mu"', "negative"),
    phase("coefficient that is negative", 'coefficient = "mu"', 'coefficient = "-mu"', "negative"),
    phase("sliding with a static limit", 'coefficient = "mu"', 'limit = "mu"', "unknown key “limit”", "coefficient"),
    phase("nothing slips", 'speed     = "v_0"', 'speed     = "0"', "nothing slips there", "slip ="),
    phase("slip in an unknown sense", 'coefficient = "mu"', 'coefficient = "mu"\nslip = "left"', "must be one of", ""),
    # --- too little or too much said
    wheel("gravity without g", 'g    = "acceleration: gravity"', "", "unknown symbol “g”", "The symbols are"),
    wheel("wheel without an angle", 'angle  = "-phi"\n', "", "no body's pose uses the coordinate “phi”", "angle"),
    wheel("held and let go", 'start     = "0"', 'start     = "0"\nspeed = "1"', "speed"),
    wheel(
        "held at two places",
        "[constraints.N]",
        '[constraints.P]\ntype = "pivot"\npoint = "wheel.center"\n\n[constraints.N]',
        "lets it move with “s”",
        "at =",
    ),
    wheel(
        "nothing left to move",
        "[constraints.N]",
        '[constraints.P]\ntype = "prescribed-angle"\nbody = "wheel"\nangle = "sqrt(c/M)*t"\n\n[constraints.C]\n'
        'type = "prescribed"\npoint = "wheel.center"\ndistance = "R"\nalong = ["1", "0"]\n\n[constraints.N]',
        "contradict",
    ),
    impact(
        "ball without a place", 'center = ["x", "y - b"]\n', "", "no body's pose uses the coordinate “x”", "in a place"
    ),
    # --- phases
    phase("event of nobody", EVENT, 'event = "no slip"\nof = "P"', "there is no constraint “P”", "N"),
    phase("event unknown", EVENT, 'event = "rolls"', "unknown event “rolls”", "no slip"),
    phase(
        "value without a coordinate", EVENT, 'event = "reaches"\nof = "N"\nat = "h"', "there is no coordinate “N”", "x"
    ),
    phase("coordinate without a value", EVENT, 'event = "reaches"\nof = "x"', "has no “at”", "reaches"),
    phase(
        "value of another dimension",
        EVENT,
        'event = "reaches"\nof = "x"\nat = "v_0"',
        "must be a length, but this is a speed",
    ),
    phase("value that moves", EVENT, 'event = "reaches"\nof = "x"\nat = "R*phi"', "must not depend on “phi”"),
    phase(
        "value reached too late",
        EVENT,
        'event = "reaches"\nof = "x"\nat = "-h"',
        "after “N” has stopped slipping",
        "no slip",
    ),
    phase("value of an event that has none", EVENT, EVENT + '\nat = "h"', "asks for no “at”", "leave it out"),
    phase(
        "subject of an event that has none", EVENT, 'event = "at once"\nof = "N"', "asks for no “of”", "leave it out"
    ),
    phase("rolling lost by a pivot", EVENT, 'event = "slips"\nof = "N"', "static friction has no limit", "limit ="),
    impact(
        "pivot that is lost", 'name = "bounced"', 'name = "bounced"\nevent = "lost"\nof = "F"', "holds to both sides"
    ),
    impact(
        "no slip of what has no friction",
        'name = "bounced"',
        'name = "bounced"\nevent = "no slip"\nof = "F"',
        "no kinetic friction",
        "coefficient",
    ),
    phase(
        "without what is not there",
        "constraints = { N",
        'without = ["P"]\nconstraints = { N',
        "there is no constraint or interaction “P”",
        "N",
    ),
    phase("without a list", "constraints = { N", 'without = "N"\nconstraints = { N', "list"),
    phase(
        "phase with an unknown key", "constraints = { N", "constraint = { N", "unknown key “constraint”", "constraints"
    ),
    phase(
        "two phases of one name",
        ROLLING,
        ROLLING + ROLLING.replace('"no slip"\nof          = "N"', '"at once"'),
        "two phases",
        "another name",
    ),
    phase(
        "phase of which the start is not known",
        '[coordinates.phi]\nmeaning = "angle"\nstart   = "0"\n',
        '[coordinates.phi]\nmeaning = "angle"\n',
        "where “phi” starts",
        "start =",
    ),
    phase(
        "new constraint that does not hold there",
        "{ N = { type",
        '{ P = { type = "pivot", point = "ball.center", at = ["h", "R"] }, N = { type',
        "where the bodies are",
    ),
    # --- impulses
    impact(
        "impulses outside of a phase",
        '[[phases]]\nname = "bounced"\n\n[phases.impulses.K]',
        "[impulses.K]",
        "unknown key “impulses”",
        "phases",
    ),
    impact(
        "collision of bodies that do not meet",
        'points = { spot = ["b - ell/2", "0"] }',
        'points = { spot = ["b", "0"] }',
        "do not meet",
    ),
    impact("collision of bodies that part", 'along       = ["1", "0"]', 'along       = ["-1", "0"]', "do not approach"),
    impact("collision of bodies at rest", 'speed     = "v_0"', 'speed     = "0"', "do not approach"),
    impact("collision without a direction", 'along       = ["1", "0"]\n', "", "has no “along”"),
    impact("normal that is no unit vector", 'along       = ["1", "0"]', 'along       = ["1", "1"]', "no unit vector"),
    impact("restitution above one", 'restitution = "e"', 'restitution = "2"', "between 0 and 1"),
    impact("restitution below zero", 'restitution = "e"', 'restitution = "-1/2"', "between 0 and 1"),
    impact(
        "restitution with a dimension",
        'restitution = "e"',
        'restitution = "v_0"',
        "must be an angle or a number, but this is a speed",
    ),
    impact(
        "collision of a body with itself",
        '"ball.center", "rod.spot"',
        '"rod.end", "rod.spot"',
        "points of one body",
        "two bodies",
    ),
    impact("collision of three", '"ball.center", "rod.spot"', '"ball.center", "rod.spot", "rod.end"', "two"),
    impact(
        "collision with a point that is not there", '"ball.center", "rod.spot"', '"ball.center", "rod.mark"', "mark"
    ),
    impact(
        "blow on nobody",
        COLLISION,
        '[phases.impulses.K]\ntype = "blow"\non = "O"\nimpulse = ["J", "0"]\n',
        "fixed place",
        "point of a body",
    ),
    impact(
        "blow of a force",
        COLLISION,
        '[phases.impulses.K]\ntype = "blow"\non = "rod.spot"\nimpulse = ["M*g", "0"]\n',
        "must be a momentum, but this is a force",
    ),
    impact(
        "blow of nothing",
        COLLISION,
        '[phases.impulses.K]\ntype = "blow"\non = "rod.spot"\nimpulse = ["0", "0"]\n',
        "no impulse at all",
    ),
    impact(
        "impulse of an unknown kind",
        'type        = "collision"',
        'type        = "crash"',
        "unknown type “crash”",
        "collision",
    ),
    # --- bounces and what begins
    *(bounce(*case) for case in (
        ("bounce of nobody", 'body = "ball", ', "", "must say what meets"),
        ("bounce from nothing", 'line = "y = 0", ', "", "touches nothing"),
        ("bounce in the air", 'start = "R"', 'start = "2*R"', "does not meet"),
        ("bounce of what flies off", 'speed = "-u"', 'speed = "u"', "does not approach"),
        ("bounce on the other side", 'line = "y = 0", ', 'line = "y = 0", side = "negative", ', "does not meet"),
        ("bounce that gains energy", 'restitution = "e"', 'restitution = "3/2"', "between 0 and 1"),
        ("bounce with a negative tangential restitution", 'slip = "none"', 'slip = "none", tangential = "-1/3"',
         "between 0 and 1"),
        ("bounce that slips and turns round", 'slip = "none"', 'slip = "forward", tangential = "1"',
         "slips, and has a tangential"),
        ("bounce with a sense but no friction", 'coefficient = "mu", slip = "none"', 'slip = "forward"', "has no friction"),
        ("bounce that slips the wrong way", 'slip = "none"', 'slip = "backward"', "slip the other way"),
        ("bounce where nothing slips before", 'speed = "v" }', 'speed = "0" }', "nothing slips there",
         'slip = "none"', 'slip = "auto"'),
        ("bounce on a string without a length", 'body = "ball", line = "y = 0", ', 'path = ["O", "ball.center"], ', "how long"),
        ("a beginning of what is not there", '[[phases]]', '[[phases]]\nevent = "begins"\nof = "K"', "no constraint or bounce"),
        ("a beginning of what never comes", '[[phases]]', '[[phases]]\nevent = "begins"\nof = "J"', "does not begin"),
    )),
    impact("impulse called like a parameter", "[phases.impulses.K]", "[phases.impulses.J]", "“J”"),
    # --- a quantity and a force of one name
    Wrong(
        "force called like another quantity",
        BALL,
        "[constraints.N]",
        '[interactions.h]\ntype  = "force"\non    = "ball.center"\nforce = ["M*g*h/R", "0"]\n\n[constraints.N]',
        "a force that has not this size",
        "another name",
    ),
    Wrong(
        "spring of no length",
        IMPACT,
        "[constraints.F]",
        '[interactions.S]\ntype = "spring"\nstiffness = "M*g/b"\nnatural_length = "b"\n'
        'between = ["O", "rod.start"]\n\n[constraints.F]',
        "always in one place",
        "points that are apart",
    ),
    Wrong(
        "damper of no length",
        IMPACT,
        "[constraints.F]",
        '[interactions.S]\ntype = "damper"\ncoefficient = "M*v_0/b"\n'
        'between = ["O", "rod.start"]\n\n[constraints.F]',
        "always in one place",
        "points that are apart",
    ),
    Wrong(
        "string of no length",
        IMPACT,
        "[constraints.F]",
        '[constraints.S]\ntype = "string"\npath = ["O", "rod.start"]\n\n[constraints.F]',
        "always in one place",
        "points that are apart",
    ),
]
