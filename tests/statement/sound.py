"""A sound statement of all kinds of things, and how one row of a table breaks it."""

from __future__ import annotations

from dataclasses import dataclass

SOUND = """\
title = { en = "All things", es = "De todo" }
origins = ["O", "disk.cm"]

[parameters]
m   = "mass: mass of the rod"
M   = "mass, nonnegative: mass of the disk"
ell = "length: length of the rod"
R   = "length: radius of the disk"
k   = "stiffness: stiffness of the spring"
kappa = "torsion stiffness"
F   = { dimension = "force", meaning = "pull", sign = "real" }
beta = "angle: slope of the line"
g   = "acceleration: gravity"

[coordinates.theta]
meaning = "angle of the rod"
start   = "pi/3"
speed   = "omega_0"
range   = ["-pi/2", "pi/2"]

[coordinates.phi]
meaning = "angle of the disk"
start   = "phi_0"

[points]
Q = ["2*ell", "0"]

[bodies.rod]
shape  = "rod"
mass   = "m"
length = "ell"
start  = ["0", "0"]
angle  = "theta - pi/2"
points = { knot = ["ell/4", "0"] }

[bodies.disk]
shape  = "disk"
mass   = "M"
radius = "R"
center = [
    "ell*sin(theta)",   # a comment, with ] in it
    "-ell*cos(theta)",
]
angle  = "phi"

[bodies.bob]
shape = "particle"
mass  = "m"

[interactions.W]
type = "gravity"

[interactions.S]
type      = "spring"
between   = ["rod.knot", "Q"]
stiffness = "k"

[interactions.T]
type      = "torsion-spring"
between   = ["ground", "rod"]
stiffness = "kappa"

[interactions.P]
type  = "force"
on    = "disk.center"
force = ["F", "0"]

[interactions.C]
type   = "couple"
on     = "disk"
couple = "F*R"

[constraints.A]
type  = "pivot"
point = "rod.start"

[constraints.N]
type   = "pin"
points = ["rod.end", "disk.center"]

[constraints.B]
type   = "pin"
points = ["disk.center", "bob.center"]

[constraints.L]
type  = "contact"
point = "rod.end"
line  = "y = x*tan(beta)"

[notation]
theta_dot = "omega"

[meanings.es]
m = "masa de la varilla"

[example]
ell = "1 m"
"""


@dataclass(frozen=True)
class Broken:
    """`old` of the sound statement becomes `new`; the error says `says` (and `hint`)."""

    name: str
    old: str
    new: str
    says: str
    hint: str = ""

    @property
    def text(self) -> str:
        """The broken statement."""
        return self._marked.replace("«", "").replace("»", "")

    @property
    def caret(self) -> tuple[int, int, int]:
        """Line, column (from 1) and width of the marked characters."""
        before, _, after = self._marked.partition("«")
        return before.count("\n") + 1, len(before) - before.rfind("\n"), len(after.partition("»")[0])

    @property
    def _marked(self) -> str:
        assert SOUND.count(self.old) == 1, f"{self.name}: {self.old!r} must stand once in SOUND"
        return SOUND.replace(self.old, self.new)
