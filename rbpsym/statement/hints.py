"""What to write instead, for the words and units that people bring along from elsewhere."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from rbpsym.quantities import DIMENSIONS, NUMBER, Dimension
from rbpsym.statement.printed_units import unit_of
from rbpsym.statement.units import unit_named

SIGNS = ("positive", "nonnegative", "nonzero", "real", "acute")  # acute: an angle between 0 and π/2

# word of ours -> the usual ones for which it may stand
OTHER_WORDS: Mapping[str, str] = {
    "rod": "bar stick beam ladder pendulum",
    "rectangle": "plate square block box",
    "ring": "circle",
    "disk": "wheel pulley circle",
    "particle": "point bead pendulum",
    "pivot": "hinge axle fixed",
    "pin": "hinge joint revolute",
    "weld": "fixed clamp",
    "contact": "roller floor wall friction",
    "touch": "friction",
    "guide": "wire track rail",
    "link": "rod",
    "string": "cable belt",
    "gravity": "weight",
    "couple": "torque moment motor",
    "prescribed-angle": "motor",
    "damper": "dashpot",
    "coefficient": "mu friction_coefficient",
    "limit": "mu friction_coefficient",
    "stiffness": "k",
    "mass": "m",
    "center": "position",
    "speed": "velocity omega",
    "interactions": "forces loads",
    "constraints": "joints supports",
    "coordinates": "variables",
    "parameters": "constants",
}
FUNCTIONS = {"cosine": "cos", "cosinus": "cos", "sine": "sin", "sinus": "sin", "tangent": "tan", "squareroot": "sqrt"}
_AFTER_A_NUMBER = re.compile(r"(?:^|[^\w.])\d+(?:\.\d+)?\s*°?$")
FULL_TURN = 6.3


def other_word(word: str, known: Collection[str]) -> str:
    """The word of ours for a usual one: "write “rod”" for "stick"; "" if there is none."""
    found = [name for name, usual in OTHER_WORDS.items() if name in known and word.lower() in usual.split()]
    return "write " + " or ".join(f"“{name}”" for name in found) + "." if found else ""


def unknown_symbol(text: str, name: str, column: int, hint: str, dimension: Dimension | None) -> str:
    """What to do about a name that the problem does not have; `hint` is what the reader of formulas proposes."""
    if name.lower() in FUNCTIONS:
        return f"Write {FUNCTIONS[name.lower()]}(x)."
    if _AFTER_A_NUMBER.search(text[: column - 1]) and unit_named(name) is not None:
        return _number_with_unit(name)
    if "Did you mean" in hint or "Write" in hint or "write" in hint:
        return hint
    kind = _name_of(dimension) if text.strip() == name else ""
    return f'Declare it under [parameters]: {name} = "{kind or "length"}: what it is". {hint}'


def _number_with_unit(unit: str) -> str:
    if unit in ("deg", "°"):
        return 'Angles are in radians: pi/3. Or write a name, as in start = "theta_0", and its number in [example].'
    return "Formulas hold names: write one, say what it is under [parameters], and give its number in [example]."


def in_radians(value: float, dimension: Dimension | None) -> str:
    """For a large number where an angle is wanted."""
    if dimension == NUMBER and abs(value) > FULL_TURN:
        return f" Angles are in radians: {value:g}° is {value:g}*pi/180."
    return ""


def for_a_dimension(word: str, hint: str) -> str:
    """Where a number with its unit, a sign, or the meaning alone, stands for a dimension."""
    if word in SIGNS:
        return f'“{word}” is a sign and stands after the dimension: "{"angle" if word == "acute" else "length"}, {word}: ..."'
    number, _, unit = word.strip().partition(" ")
    if re.match(r"[-+]?\d", number):
        found = unit_named(unit) if unit else None
        return f'numbers stand in [example]; here stands what it is: "{_name_of(found[0] if found else None) or "length"}: ..."'
    found = unit_named(word)
    if found is not None:
        return f"write the dimension, not its unit: “{_name_of(found[0])}”."
    first = next((name for name in sorted(DIMENSIONS, key=len, reverse=True) if word.startswith(name + " ")), None)
    return f'write a colon after the dimension: "{first}: {word}"' if first else hint


def _name_of(dimension: Dimension | None) -> str:
    return next((name for name, found in DIMENSIONS.items() if found == dimension), "")


def unit_example(dimension: Dimension) -> str:
    """How a number of this dimension is written."""
    unit = unit_of(dimension)
    return f'write a number and, after a space, a unit: "{f"2 {unit}" if unit else "0.3"}"'
