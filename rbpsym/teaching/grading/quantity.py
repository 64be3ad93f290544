"""A typed number with its unit and significant figures: 4.2 rad/s, 1,2·10^3 N, 12 m s^-2, π/6, 30°."""

from __future__ import annotations

import re
from fractions import Fraction

from rbpsym.decide import enclosure
from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.enclosure import ends
from rbpsym.errors import DimensionError, Place, RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.frozen import Frozen, replace
from rbpsym.languages import in_any
from rbpsym.statement.units import UnitOf, read_unit
from rbpsym.teaching.grading.ground import Book, GradingGround
from rbpsym.teaching.grading.intervals import value_at
from rbpsym.teaching.grading.judgement import Judgement, wrong
from rbpsym.teaching.grading.reading import is_latex, unframed, with_decimal_points
from rbpsym.teaching.grading.words import MADE, WORD, lookup, spelled

LONGEST, LARGEST_POWER = 200, 30


class Typed(Frozen):
    """A number in `unit` (None if none is typed).

    fewest, most: how many significant figures it may be meant to have (0 for an exact form such as
    π/6); place: the unit of its last digit.
    """

    value: float
    unit: UnitOf | None
    fewest: int = 0
    most: int = 0
    place: float = 0.0

    @property
    def si(self) -> float:
        """The value in SI units."""
        return self.value * (self.unit.factor if self.unit else 1)


_BLANK = "[ \u00a0\u2009\u202f]"
_DECIMAL = rf"\d{{1,3}}(?:{_BLANK}\d{{3}})+(?:\.\d+)?|\d+(?:\.\d*)?|\.\d+"
_TEN = r"\s*(?:[*x×·⋅.]|\\cdot|\\times)?\s*10\s*(?:\^|\*\*)\s*[({]?\s*([+\-−]?\d{1,4})\s*[)}]?"
_RAISED = r"\s*[*x×·⋅]\s*10([⁻⁺]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,4})"
_NUMBER = re.compile(rf"([+\-−]?)\s*({_DECIMAL})(?:[eE]([+\-−]?\d{{1,4}})(?![\d.])|{_TEN}|{_RAISED})?")
_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺−", "0123456789-+-")


_FACTOR = re.compile(r"\s*(?:[*·]\s*)?(?:\(\s*)*(?:pi|sin|cos|tan|sen|sqrt|\d)")  # behind a number what is no unit


_SENSE = re.compile(rf"\b(?:{in_any('sense')})\b|\b(?:{in_any('way')})\s*$", re.IGNORECASE)


def read_quantity(text: str, language: str = "en") -> Typed:
    """The number of an answer; what stands before a sign = is passed. Raises ReadError with a caret."""
    if len(text) > LONGEST:
        raise ReadError(f"this is too long for a number: {len(text)} characters", instead="Enter the number alone.")
    if _SENSE.search(text):
        raise ReadError("a direction in words is not read", instead="Give the number with its sign and unit.")
    told = _bare(text, language)
    if not told:
        raise ReadError("there is no answer", instead="Enter a number with its unit, as in 4.2 m/s^2.")
    found = _NUMBER.match(told)
    rest = told[found.end() :] if found else ""
    if found and re.match(r"[.,]\d", rest):
        raise ReadError(
            "there are two decimal marks",
            instead="Write the number as in 4.2.",
            place=Place(text=told[:200], column=found.end() + 1),
        )
    if found and re.match(r"\s+1\s*/\s*[A-Za-z(]", rest):
        return _decimal(found, _unit(rest))
    if found and not re.match(r"\s*(?:[*/^(+\-−√π!]|sqrt|pi|\d)", rest):
        return _decimal(found, _unit(rest))
    if found and re.match(r"\s*[/*·]\s*[A-Za-zΩµμ°(]", rest) and not _FACTOR.match(rest):
        return _decimal(found, read_unit("1" + rest if rest.strip().startswith("/") else rest.strip()[1:]))
    return _bracketed(found, rest) or _exact(told)


def _bracketed(found: re.Match[str] | None, rest: str) -> Typed | None:
    """A number with a unit that begins with a parenthesis: 4.2 (m)/(s)."""
    if not found or not re.match(r"\s*\(\s*[A-Za-zΩµμ]", rest):
        return None
    try:
        return _decimal(found, read_unit(rest.strip()))
    except RbpsymError:
        return None


_ABOUT = in_any("about")
_BESIDE = (
    (re.compile(rf"^\s*(?:{_ABOUT})\b\.?\s*", re.IGNORECASE), ""),
    (re.compile(rf"\s*\(?\b(?:{_ABOUT})\b\.?\)?\s*$", re.IGNORECASE), ""),
    (re.compile(r"\s*(?:±|\+/?-|\\pm(?![A-Za-z]))\s*\d+(?:[.,]\d+)?(?=\s*(?:\\|[A-Za-zµΩ°]|$))"), ""),  # an uncertainty
    (re.compile(r"^\$([^$]*)\$"), r"\1 "),
    (re.compile(r"^\(([^()]*)\)$"), r"\1"),
    (re.compile(r"^([+\-−]?)(\d+)\s?([¼½¾⅐-⅞])"), r"\1(\2+\3)"),
    (re.compile(r"^([+\-−]?)(\d+)\s+(\d+)\s*/\s*(\d+)(?![\w.])"), r"\1(\2+\3/\4)"),
)


def _bare(text: str, language: str) -> str:
    """The number and unit alone, LaTeX taken off."""
    told = unframed(re.split(r"[=≈≃]", unframed(text))[-1]).lstrip("~ ")
    if is_latex(told) or "\\" in told or "^{" in told:
        told = _without_latex(told)
    for pattern, plain in _BESIDE:
        told = pattern.sub(plain, told.strip())
    told = re.sub(r"(?<=\d)['’](?=\d{3}(?!\d))", "", told.replace("º", "°"))
    return with_decimal_points(told, language).strip()


_LATEX = (
    (re.compile(r"\\(?:SI|qty)\s*(?:\[[^\]]*\])?\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"\1 \2"),
    (re.compile(r"\\sqrt\s*\{([^{}]*)\}"), r" sqrt(\1)"),
    (re.compile(r"\\(?:mathrm|text|mbox|textrm|unit|si|operatorname)\s*\{([^{}]*)\}"), r" \1 "),
    (re.compile(r"\\(?:d|t)?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"(\1)/(\2)"),
    (re.compile(r"\^\s*\{?\s*\\circ\s*\}?|\\degree(?![A-Za-z])"), "°"),
    (re.compile(r"\\(?=(?:sin|cos|tan)(?![A-Za-z]))"), ""),
    (re.compile(r"\\(?:cdot|times)(?![A-Za-z])"), "·"),
    (re.compile(r"\\pi(?![A-Za-z])"), "π "),
    (re.compile(r"\\Omega(?![A-Za-z])"), "Ω"),
    (re.compile(r"\\(?:left|right|displaystyle|rm)(?![A-Za-z])"), ""),
    (re.compile(r"\\[,;:! ]|~|\\q?quad(?![A-Za-z])"), " "),
    (re.compile(r"\^\s*\{([^{}]*)\}"), r"^(\1)"),
)


def _without_latex(text: str) -> str:
    for pattern, plain in _LATEX:
        text = pattern.sub(plain, text)
    return text


def _unit(text: str) -> UnitOf | None:
    return read_unit(text.strip()) if text.strip() else None


def _decimal(found: re.Match[str], unit: UnitOf | None) -> Typed:
    sign, digits = found[1], re.sub(_BLANK, "", found[2])
    power = int((found[3] or found[4] or found[5] or "0").translate(_SUPERSCRIPTS))
    if abs(power) > LARGEST_POWER:
        raise ReadError(f"10^{power} is beyond what can be meant here", instead="Check the exponent.")
    value = float(digits) * 10.0**power * (-1 if sign in ("-", "−") and sign else 1)
    fewest, most = significant_figures(digits)
    decimals = len(digits.partition(".")[2])
    return Typed(value, unit, fewest, most, 10.0 ** (power - decimals))


def significant_figures(digits: str) -> tuple[int, int]:
    """(fewest, most) significant figures of a decimal number: 0.0420 has 3, 1500 has 2 to 4."""
    whole, _, decimals = digits.partition(".")
    significant = (whole + decimals).lstrip("0")
    if not significant:
        return 1, max(len(decimals), 1)
    if "." in digits:
        return len(significant), len(significant)
    return len(significant.rstrip("0")), len(significant)


_DEG = rf"(\d+(?:\.\d+)?)\s*(?:°|(?:{in_any('degrees')})\b)"
_DEGREES = re.compile(rf"(?<=sin|cos|tan|sen)(\s*){_DEG}|(\b){_DEG}(?=\s*\))", re.IGNORECASE)  # of a function, or in parentheses


def _exact(told: str) -> Typed:
    """A number written as a formula: π/6 rad, sqrt(3)/2 m, 3/4."""
    first: RbpsymError | None = None
    for end in _cuts(told):
        try:
            number = _DEGREES.sub(lambda f: f"({f[2] or f[4]}*pi/180)", told[:end].rstrip(" *·"))
            node = read_infix(number, (), functions=MADE)
            unit = _unit(told[end:])
            low, high = enclosure.ends(value_at(node))
            return Typed(float((low + high) / 2), unit)
        except RbpsymError as error:
            first = first or error
        except (ArithmeticError, KeyError) as error:
            raise ReadError("this has no value", place=Place(text=told[:200], column=1)) from error
    raise ReadError("a number is expected here", instead="Write it as in 4.2 m/s^2, 1.2e3 N, or pi/6 rad.",
                    place=Place(text=told[:200], column=1)) from first  # fmt: skip


def _cuts(told: str) -> list[int]:
    """Where a unit may begin: at the end, or at a letter after what is no letter."""
    inner = [at.start() for at in re.finditer(r"(?<![A-Za-z])[A-Za-zΩµμ°]", told) if at.start()]
    return [len(told), *inner[:12]]


# --- decimals in a formula: a number with its unit behind it (`√(3g/ℓ) ≈ 5.42 rad/s`), and coefficients that are rounded


_BEHIND = re.compile(r"(.*\S)\s*(?:[=≈≃~]|\\(?:approx|simeq)(?![A-Za-z]))\s*([^=≈≃~]*\d[^=≈≃~]*)", re.DOTALL)
_SENSITIVITY = Fraction(3, 2)  # a function may change by more than the share by which its argument is rounded
COARSEST = Fraction(1, 20)


def without_number(text: str, book: Book) -> tuple[str, Typed | None]:
    """(the answer, the decimal number with its unit behind a formula); (the answer, None) if there is none.

    A name alone before the sign is no formula, and a name of the problem behind the number makes it one.
    """
    found = _BEHIND.fullmatch(unframed(text))
    alone = re.sub(r"\\(?:d?dot|vec|mathrm|text)?|[{}\s]", "", found[1]) if found else ""
    if found is None or (WORD.fullmatch(alone) and (lookup(alone, book) or spelled(alone, book) == alone)):
        return text, None
    words = [word for word in WORD.findall(found[2]) if word != "e"]
    if words and all(lookup(word, book) for word in words):
        return text, None
    try:
        number = read_quantity(found[2], book.language)
    except RbpsymError:
        return text, None
    is_result = number.unit or number.place < 1 or "=" not in text[len(found[1]) :]  # what is set equal to 0 is an equation
    return (found[1], number) if number.most and number.value and is_result else (text, None)


def agrees(number: Typed, key: t.Node, ground: GradingGround) -> bool:
    """May the number be the value of the key, as far as its unit and the key tell?"""
    try:
        wanted = dimension_of(key, ground.dimensions)
        found = number.unit.of_mechanics if number.unit else wanted
    except DimensionError:
        found = wanted = None
    if found != wanted:
        return False
    if t.names(key) - {"pi"}:
        return True
    return abs(float(sum(ends(value_at(key))) / 2) - number.si) <= number.place


def rounded(answer: t.Node, key: t.Node, ground: GradingGround) -> Judgement | None:
    """What is said of an answer that is equal to the key but for the rounding of its decimals; None for others."""
    shares = {part: _share(part) for part in t.walk(answer) if isinstance(part, t.Num)}
    share, first = sum(shares.values()) * _SENSITIVITY, next((part for part, share in shares.items() if share), None)
    if first is None or share > COARSEST or not ground.sampling.are_near(answer, key, share):
        return None
    return replace(wrong("rounded", number=first), teacher=True)


def _share(number: t.Num) -> Fraction:
    """The share by which a typed decimal may be rounded: half of its last digit; 0 for a whole number or a fraction."""
    value, digits = Fraction(number.value), 1
    while digits < 20 and (value * 10**digits).denominator != 1:
        digits += 1
    return Fraction(0) if value.denominator == 1 or digits == 20 else Fraction(1, 2 * 10**digits) / abs(value)
