"""Units as they are printed and offered: the usual one of a dimension, its size, its signs."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from rbpsym.quantities import Dimension
from rbpsym.statement.units import unit_named

# the units that papers print and fields offer, the usual one of a dimension first
OFFERED = (
    "", "rad", "deg", "°", "kg", "g", "t", "m", "cm", "mm", "km", "s", "ms", "min", "m/s", "cm/s", "km/h",
    "m/s^2", "cm/s^2", "rad/s", "1/s", "Hz", "rad/s^2", "1/s^2", "N", "kN", "mN", "J", "N*m", "kJ", "mJ",
    "N/m", "N/cm", "kN/m", "N*m/rad", "N*s/m", "kg/s", "N*m*s", "N*m*s/rad", "kg*m^2", "g*cm^2", "kg*m/s", "N*s",
    "kg*m^2/s", "J*s", "m^2", "cm^2", "kg/m", "kg/m^2", "kg/m^3", "W", "kW",
)  # fmt: skip


@cache
def offered() -> Mapping[str, tuple[Dimension, float]]:
    """What each of these units is."""
    return {unit: known for unit in OFFERED if (known := unit_named(unit))}


# names of dimensions whose unit is not the first of that dimension above
BY_NAME: Mapping[str, str] = {"torque": "N*m", "angle": "deg"}


def unit_of(dimension: Dimension, name: str = "") -> str:
    """The unit in which a quantity is printed: by the name of what it is, else the first of its dimension."""
    if name in BY_NAME:
        return BY_NAME[name]
    found = next((unit for unit, (known, _) in offered().items() if known == dimension), None)
    return _composed(dimension) if found is None else found


def _composed(dimension: Dimension) -> str:
    """kg*m^2*s^-3 for a dimension without a name."""
    parts = zip(("kg", "m", "s"), (dimension.mass, dimension.length, dimension.time), strict=True)
    return "*".join(unit if n == 1 else f"{unit}^{n}" for unit, n in parts if n)


def scale_of(unit: str) -> float:
    """How many SI units a unit is; 1 for one that nobody knows."""
    if unit in OFFERED:
        return offered()[unit][1]
    found = unit_named(unit)
    return 1.0 if found is None else found[1]


RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit_text(unit: str) -> str:
    """The unit as printed: kg·m², m/s², °."""
    base = unit.replace("*", "·").replace("deg", "°")
    found, rest = "", base
    while "^" in rest:
        head, _, rest = rest.partition("^")
        end = 1 + (rest[:1] == "-")
        found, rest = found + head + rest[:end].translate(RAISED), rest[end:]
    return found + rest
