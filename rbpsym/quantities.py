"""A physical quantity: a name with its dimension, sign assumption, meaning and notation."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from rbpsym.errors import DimensionError
from rbpsym.frozen import Frozen


class Dimension(Frozen):
    """Exponents of mass, length and time."""

    mass: Fraction | int = 0
    length: Fraction | int = 0
    time: Fraction | int = 0

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.mass + other.mass, self.length + other.length, self.time + other.time)

    def __pow__(self, power: Fraction | int) -> Dimension:
        return Dimension(self.mass * power, self.length * power, self.time * power)

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    def __str__(self) -> str:
        """The name of the dimension if it has one ("length"), else "M L^2 T^-2"."""
        for name, dimension in DIMENSIONS.items():
            if dimension == self:
                return name
        parts = zip("MLT", (self.mass, self.length, self.time), strict=True)
        return " ".join(u if n == 1 else f"{u}^{n}" for u, n in parts if n) or "number"


NUMBER = Dimension()
MASS, LENGTH, TIME = Dimension(mass=1), Dimension(length=1), Dimension(time=1)
SPEED = LENGTH / TIME
ACCELERATION = SPEED / TIME
FORCE = MASS * ACCELERATION
ENERGY = FORCE * LENGTH

DIMENSIONS: dict[str, Dimension] = {
    "number": NUMBER,
    "angle": NUMBER,
    "mass": MASS,
    "length": LENGTH,
    "time": TIME,
    "speed": SPEED,
    "acceleration": ACCELERATION,
    "angular speed": TIME**-1,
    "angular acceleration": TIME**-2,
    "force": FORCE,
    "torque": ENERGY,
    "energy": ENERGY,
    "stiffness": FORCE / LENGTH,
    "torsion stiffness": ENERGY,
    "damping": FORCE / SPEED,
    "rotary damping": ENERGY * TIME,
    "moment of inertia": MASS * LENGTH**2,
    "momentum": MASS * SPEED,
    "impulse": MASS * SPEED,
    "angular momentum": MASS * LENGTH * SPEED,
    "area": LENGTH**2,
    "linear density": MASS / LENGTH,
    "surface density": MASS / LENGTH**2,
    "density": MASS / LENGTH**3,
    "power": ENERGY / TIME,
}


_OTHERS = {
    "speed": ("velocity",),
    "angular speed": ("angular velocity", "angular frequency", "frequency"),
    "force": ("weight", "tension"),
    "torque": ("couple", "moment"),
    "energy": ("work",),
    "stiffness": ("spring constant",),
    "torsion stiffness": ("torsion constant",),
    "damping": ("damping coefficient",),
    "length": ("distance", "radius", "width", "height"),
    "time": ("duration",),
    "number": ("coefficient", "dimensionless"),
}
OTHER_NAMES = {other: name for name, others in _OTHERS.items() for other in others}


def dimension_named(name: str) -> Dimension:
    """The dimension called `name` ("velocity" is another name of "speed"). Raises DimensionError with the nearest known name."""
    from difflib import get_close_matches

    found = DIMENSIONS.get(OTHER_NAMES.get(name, name))
    if found is not None:
        return found
    near = get_close_matches(name, (*DIMENSIONS, *OTHER_NAMES), n=1)
    hint = f"did you mean “{near[0]}”?" if near else "known: " + ", ".join(DIMENSIONS) + "."
    raise DimensionError(f"unknown dimension “{name}”", instead=hint)


class Quantity(Frozen):
    """A named quantity of a problem.

    `sign` is "positive", "nonnegative", "nonzero" or "real". `glyph` overrides how the name
    is printed: the name of another glyph ("omega"), see `expr.glyphs`. `lower` and `upper`
    are the bounds of an open interval in which it lies (display trees), None where there is none.
    """

    name: str
    dimension: Dimension
    meaning: str = ""
    sign: str = "positive"
    glyph: str | None = None
    lower: Any = None
    upper: Any = None
