r"""Units as students type them: m/s², m s^-2, N·m, Nm, km/h, rad/s, °, rpm, \mathrm{m/s^2}, metros.

A unit is a factor to SI and powers of base units. Nothing is evaluated; an unknown unit is a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from fractions import Fraction
from functools import cache, lru_cache
from math import pi
from types import MappingProxyType

from rbpsym.errors import Place, ReadError
from rbpsym.frozen import Frozen
from rbpsym.languages import languages, part_of
from rbpsym.quantities import Dimension

# --- units in words, as siunitx has them, and written close together: metres per second squared, \per\second, ms^-1


_STEPS = (
    (r"\\(?:square)\s*\\([A-Za-z]+)", r"\1^2"),
    (r"\\(?:cubic)\s*\\([A-Za-z]+)", r"\1^3"),
    (r"\\squared(?![A-Za-z])", "^2"),
    (r"\\cubed(?![A-Za-z])", "^3"),
    (r"\\per(?![A-Za-z])", "/"),
    (r"\\(?=[A-Za-z])", " "),
    (r"\s*\b(?:per|por|entre)\b\s*", "/"),
    (r"\s+(?:squared|al cuadrado|cuadrados?)\b", "^2"),
    (r"\s+(?:cubed|al cubo|cúbicos?)\b", "^3"),
    (r"\bsquare\s+([A-Za-z]+)", r"\1^2"),
    (r"\bcubic\s+([A-Za-z]+)", r"\1^3"),
    (r"(?<![A-Za-z])ms(?=\s*(?:\^|\*\*)?\s*[({]?\s*[-−⁻])", "m s"),  # of m/s, never one over milliseconds
    (r"(?<=[A-Za-z])-(?=[A-Za-z])", "·"),
    (r"\[", "("),
    (r"\]", ")"),
)
PREFIXES = {"kilo": "k", "mega": "M", "giga": "G", "milli": "m", "mili": "m", "centi": "c", "deci": "d", "micro": "µ"}


def in_signs(text: str) -> str:
    """The unit with signs instead of words.

    >>> in_signs("meters per second squared")
    'meters/second^2'
    """
    for pattern, sign in _STEPS:
        text = re.sub(pattern, sign, text)
    return text


def unprefixed(word: str) -> tuple[str, str] | None:
    """(sign of the prefix, the rest) of kilonewton; None if it begins with no prefix."""
    return next(((sign, word[len(name) :]) for name, sign in PREFIXES.items() if word.lower().startswith(name)), None)


# ---


Powers = tuple[tuple[str, Fraction], ...]
MOST_POWER, LONGEST = 12, 120


class UnitOf(Frozen):
    """`factor` times the SI unit with these powers of base units.

    “rad” and “cycle” are counted as bases, so that hertz and radians per second can be told apart;
    `dimension` leaves them out.
    """

    factor: float
    powers: Powers = ()

    def __mul__(self, other: UnitOf) -> UnitOf:
        both = dict(self.powers)
        for name, power in other.powers:
            both[name] = both.get(name, Fraction(0)) + power
        return UnitOf(self.factor * other.factor, tuple(sorted(item for item in both.items() if item[1])))

    def __pow__(self, power: Fraction) -> UnitOf:
        return UnitOf(self.factor ** float(power), tuple((name, p * power) for name, p in self.powers if power))

    @property
    def dimension(self) -> Powers:
        """The powers of the base units that have a dimension."""
        return tuple(item for item in self.powers if item[0] not in ("rad", "cycle"))

    @property
    def of_mechanics(self) -> Dimension | None:
        """The dimension in mass, length and time; None where it has others."""
        bases = dict(self.dimension)
        found = Dimension(*(bases.pop(base, 0) for base in ("kg", "m", "s")))
        return None if bases else found

    @property
    def counts_cycles(self) -> bool:
        """Is it a number of turns a time (Hz), not an angle a time?"""
        return any(name == "cycle" for name, _ in self.powers)

    @property
    def is_angular(self) -> bool:
        """Does it hold an angle?"""
        return any(name == "rad" for name, _ in self.powers)


def _unit(factor: float, **powers: int) -> UnitOf:
    return UnitOf(factor, tuple(sorted((name, Fraction(p)) for name, p in powers.items())))


PURE = UnitOf(1.0)
_METRIC: Mapping[str, UnitOf] = MappingProxyType({
    "m": _unit(1, m=1), "g": _unit(1e-3, kg=1), "s": _unit(1, s=1), "A": _unit(1, A=1), "K": _unit(1, K=1),
    "mol": _unit(1, mol=1), "N": _unit(1, kg=1, m=1, s=-2), "J": _unit(1, kg=1, m=2, s=-2),
    "W": _unit(1, kg=1, m=2, s=-3), "Pa": _unit(1, kg=1, m=-1, s=-2), "Hz": _unit(1, s=-1, cycle=1),
    "V": _unit(1, kg=1, m=2, s=-3, A=-1), "C": _unit(1, s=1, A=1), "Ω": _unit(1, kg=1, m=2, s=-3, A=-2),
    "F": _unit(1, kg=-1, m=-2, s=4, A=2), "T": _unit(1, kg=1, s=-2, A=-1), "rad": _unit(1, rad=1),
    "L": _unit(1e-3, m=3), "l": _unit(1e-3, m=3), "eV": _unit(1.602176634e-19, kg=1, m=2, s=-2), "t": _unit(1e3, kg=1),
})  # fmt: skip
_OTHER: Mapping[str, UnitOf] = MappingProxyType({
    "°": _unit(pi / 180, rad=1), "deg": _unit(pi / 180, rad=1), "rev": _unit(2 * pi, rad=1),
    "rpm": _unit(2 * pi / 60, rad=1, s=-1), "min": _unit(60, s=1), "h": _unit(3600, s=1), "d": _unit(86400, s=1),
    "ft": _unit(0.3048, m=1),
    "in": _unit(0.0254, m=1), "mi": _unit(1609.344, m=1), "lb": _unit(0.45359237, kg=1),
    "lbf": _unit(4.4482216152605, kg=1, m=1, s=-2), "mph": _unit(0.44704, m=1, s=-1),
    "yd": _unit(0.9144, m=1), "slug": _unit(14.593902937206, kg=1), "oz": _unit(0.028349523125, kg=1),
    "kip": _unit(4448.2216152605, kg=1, m=1, s=-2), "hp": _unit(745.6998715822702, kg=1, m=2, s=-3), "%": _unit(0.01),
})  # fmt: skip
_PREFIXES: Mapping[str, float] = MappingProxyType({
    "p": 1e-12, "n": 1e-9, "µ": 1e-6, "μ": 1e-6, "u": 1e-6, "m": 1e-3, "c": 1e-2, "d": 1e-1, "da": 1e1,
    "h": 1e2, "k": 1e3, "M": 1e6, "G": 1e9,
})  # fmt: skip
_POWER = r"[⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+|(?:\^|\*\*)\s*\(\s*[-−]?\s*\d+\s*\)|(?:\^|\*\*)?\s*[-−]?\s*\d+"
_TOKEN = re.compile(rf"\s*(?:(?P<name>[A-Za-zµμΩΩáéíóú°%]+)|(?P<power>{_POWER})|(?P<sign>\*\*|[*/^()·⋅×.\-−+]))")
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺−", "0123456789-+-")


@cache
def _words() -> Mapping[str, str]:
    """The words for units, in all languages: "Sekunden" is "s"."""
    tables = (part_of("units", language, "answers") for language in languages())
    return {word: unit for table in tables for unit, words in table.items() for word in words.split()}


def _single(name: str) -> UnitOf | None:
    """The unit of a symbol or word, with its prefix; None if there is none."""
    name = "Ω" if name == "\u2126" else name
    word = _words().get(name) or _words().get(name.lower())
    if word and name not in _METRIC:
        return read_unit(word)
    spelled = unprefixed(name)
    if not _signed(name) and spelled and (stem := _words().get(spelled[1].lower(), "")) in _METRIC:
        return _single(spelled[0] + stem)
    return _signed(name)


def _signed(name: str) -> UnitOf | None:
    """One unit in its own signs: km, µs, rad."""
    known = _METRIC.get(name) or _OTHER.get(name)
    stems = ((factor, _METRIC.get(name[len(prefix) :])) for prefix, factor in _PREFIXES.items() if name.startswith(prefix))
    return known or next((UnitOf(stem.factor * factor, stem.powers) for factor, stem in stems if stem), None)


@lru_cache(maxsize=1024)
def unit_named(text: str) -> tuple[Dimension, float] | None:
    """Dimension and SI size of a unit of mechanics in its own signs, as "cm" or "N m/rad"; None for anything else.

    >>> unit_named("km/h")[1] == 1000 / 3600
    True
    """
    if not all(map(_signed, re.findall(r"[A-Za-zµμΩΩ°%]+", text))):
        return None
    try:
        found = read_unit(text)
    except ReadError:
        return None
    dimension = found.of_mechanics
    return None if dimension is None else (dimension, found.factor)


def read_unit(text: str) -> UnitOf:
    """The unit of a text; "" is a pure number. Raises ReadError for what is none."""
    if len(text) > LONGEST:
        raise ReadError("this is too long for a unit", instead="Write it as in m/s^2.", place=Place(text=text[:60]))
    told = in_signs(text)
    tokens = list(_tokens(told))
    found, rest = _product(tokens, told)
    if rest:
        raise _refused(told, rest[0][1])
    return found


Tokens = list[tuple[str, str]]


def _tokens(text: str) -> Iterator[tuple[str, str]]:
    position, text = 0, text.rstrip()
    while position < len(text):
        found = _TOKEN.match(text, position)
        if not found:
            raise _refused(text, text[position:].strip()[:1])
        kind = found.lastgroup or ""
        yield kind, found[kind]
        position = found.end()


def _refused(text: str, what: str) -> ReadError:
    known = [*_METRIC, *_OTHER, *_words(), "kg", "km", "cm", "mm"]
    near = get_close_matches(what, known, n=1)
    hint = f"Did you mean “{near[0]}”?" if near else "Write the unit as in m/s^2, rad/s, N m."
    place = Place(text=text[:200], column=max(text.find(what), 0) + 1, width=max(len(what), 1))
    return ReadError(f"“{what[:40]}” is no unit that is known here", instead=hint, place=place)


def _product(tokens: Tokens, text: str) -> tuple[UnitOf, Tokens]:
    """factor · factor / factor: one bar, or several of single units; m/s kg is refused."""
    total, divided, joined = PURE, False, False
    while tokens and tokens[0][1] != ")":
        sign = tokens[0][1] if tokens[0][0] == "sign" else ""
        below = sign == "/"
        if below or sign in ("*", "·", "⋅", "×", "."):
            tokens, joined = tokens[1:], True
        elif divided and not joined:
            raise ReadError("is this unit above or below the bar?", instead="Write m/(s kg).", place=Place(text=text))
        factor, tokens = _factor(tokens, text)
        total = total * (factor ** Fraction(-1) if below else factor)
        divided, joined = divided or below, False
    return total, tokens


def _factor(tokens: Tokens, text: str) -> tuple[UnitOf, Tokens]:
    if not tokens:
        raise ReadError("the unit ends too early", instead="Write it as in m/s^2.", place=Place(text=text[:200]))
    (kind, what), *rest = tokens
    if what == "(":
        found, rest = _product(rest, text)
        if not rest:
            raise _refused(text, "(")
        return _raised(found, rest[1:], text)
    if kind == "power" and what == "1":
        return PURE, rest
    units = _units_of(what) if kind == "name" else None
    if units is None:
        raise _refused(text, what)
    *before, last = units
    raised, rest = _raised(last, rest, text)
    for unit in before:
        raised = unit * raised
    return raised, rest


def _units_of(word: str) -> tuple[UnitOf, ...] | None:
    """A word as one unit, or as two written together (Nm, kgm)."""
    whole = _single(word)
    if whole:
        return (whole,)
    for cut in range(1, min(len(word), 8)):
        first, second = _single(word[:cut]), _METRIC.get(word[cut:])
        if first and second:
            return first, second
    return None


def _raised(unit: UnitOf, tokens: Tokens, text: str) -> tuple[UnitOf, Tokens]:
    """The unit with the exponent that follows: ^2, ², 2, -2, **(-2)."""
    if not tokens or tokens[0][0] != "power":
        return unit, tokens
    power = re.sub(r"[\s^*()]", "", tokens[0][1].translate(_SUPERSCRIPTS))
    if len(power) > 4 or abs(int(power)) > MOST_POWER:
        raise ReadError("this exponent of a unit can't be read", instead="Write it as in s^-2.", place=Place(text=text))
    return unit ** Fraction(int(power)), tokens[1:]


# --- units as they are printed and offered: the usual one of a dimension, its size, its signs


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
