"""Units of the numbers in a problem file: "25 cm", "9.81 m/s^2", "N m/rad"."""

from __future__ import annotations

import math
import re

from rbpsym.quantities import DIMENSIONS, NUMBER, TIME, Dimension

# unit -> (dimension, SI units)
BASIC: dict[str, tuple[Dimension, float]] = {
    "rad": (NUMBER, 1.0),
    "deg": (NUMBER, math.pi / 180),
    "°": (NUMBER, math.pi / 180),
    "rev": (NUMBER, 2 * math.pi),
    "g": (DIMENSIONS["mass"], 1e-3),
    "t": (DIMENSIONS["mass"], 1e3),
    "m": (DIMENSIONS["length"], 1.0),
    "s": (TIME, 1.0),
    "min": (TIME, 60.0),
    "h": (TIME, 3600.0),
    "Hz": (TIME**-1, 1.0),
    "rpm": (TIME**-1, math.pi / 30),
    "N": (DIMENSIONS["force"], 1.0),
    "J": (DIMENSIONS["energy"], 1.0),
    "W": (DIMENSIONS["power"], 1.0),
}
PREFIXES = {"k": 1e3, "c": 1e-2, "d": 1e-1, "m": 1e-3, "µ": 1e-6, "M": 1e6}
PREFIXED = ("g", "m", "s", "N", "J", "W")
POWERS = str.maketrans("⁻¹²³⁴", "-1234")
PART = re.compile(r"([^\W\d_]+|°)\s*(?:\^?\s*(-?\d+))?")


def unit_named(text: str) -> tuple[Dimension, float] | None:
    """(dimension, how many SI units) of a unit, a product or a quotient of units; None if it is not known.

    >>> unit_named("km/h")[1] == 1000 / 3600
    True
    """
    above, *below = text.translate(POWERS).replace("·", " ").replace("*", " ").split("/")
    dimension, size = NUMBER, 1.0
    for part, sign in ((above, 1), *((part, -1) for part in below)):
        words = PART.findall(part.strip().removeprefix("1 ") if part.strip() != "1" else "")
        if PART.sub("", part).strip() not in ("", "1", "()", "( )"):
            return None
        for word, power in words:
            found = _single(word)
            if found is None:
                return None
            exponent = sign * int(power or 1)
            dimension, size = dimension * found[0] ** exponent, size * found[1] ** exponent
    return dimension, size


def _single(word: str) -> tuple[Dimension, float] | None:
    """A unit with or without a prefix."""
    if word in BASIC:
        return BASIC[word]
    prefix, rest = word[:1], word[1:]
    if prefix not in PREFIXES or rest not in PREFIXED:
        return None
    dimension, size = BASIC[rest]
    return dimension, size * PREFIXES[prefix]
