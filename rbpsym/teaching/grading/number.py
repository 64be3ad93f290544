"""Judging a number: its value, its unit and its significant figures, each apart.

A unit or figures earn points only beside a value that is right, or wrong in a way that is recognised:
a guess with a fitting unit earns nothing, and neither does a zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from math import floor, isfinite, log10, pi

from rbpsym.errors import RbpsymError
from rbpsym.frozen import Frozen, replace
from rbpsym.statement.units import PURE, UnitOf, read_unit
from rbpsym.teaching.grading import judgement as j
from rbpsym.teaching.grading.judgement import Judgement, Remark, Status
from rbpsym.teaching.grading.quantity import Typed, read_quantity
from rbpsym.teaching.model import Anticipated, NumberKey, Tolerance

SHARES = {"value": Fraction(6, 10), "unit": Fraction(2, 10), "figures": Fraction(2, 10)}
MOST_TENS = 9
RADIAN = (("rad", Fraction(1)),)


class ExpectedNumber(Frozen):
    """What a number is compared with; `exact` in SI units, `unit` the one that is printed.

    carried: values (SI) that follow from the student's own earlier answers.
    """

    exact: float
    unit: UnitOf = PURE
    tolerance: Tolerance = Tolerance()
    anticipated: tuple[Anticipated, ...] = ()
    carried: tuple[float, ...] = ()
    language: str = "en"


def wanted(key: NumberKey, carried: Iterable[float] = (), language: str = "en") -> ExpectedNumber:
    """What a number key asks for."""
    return ExpectedNumber(key.exact, read_unit(key.measure.unit), key.tolerance, key.anticipated, tuple(carried), language)


def judge_number(text: str, sought: ExpectedNumber) -> Judgement:
    """The judgement on a typed number. Errors of the student are judgements, never exceptions."""
    if not text.strip():
        return j.EMPTY
    try:
        typed = read_quantity(text, sought.language)
    except RbpsymError as error:
        return j.invalid(error)
    if not isfinite(typed.si):
        return j.invalid(RbpsymError("this number is too large"))
    return _judged(typed, sought)


def _judged(typed: Typed, sought: ExpectedNumber) -> Judgement:
    unit, meant = _unit_remark(typed, sought), _meant(typed, sought)
    if not meant.value and sought.exact:
        known = _slip(meant, sought)
        told = j.slip_remarks(known.slots["slip"]) if known else (Remark("zero"),)
        nothing = _marked(Status.WRONG, Fraction(0), Fraction(0), Fraction(0), sought, *told)
        return replace(nothing, slip=known.slots["slip"] if known else None)
    if is_near(meant, sought.exact, sought.tolerance):
        return _right(typed, unit, sought, Status.RIGHT, ())
    if typed.unit is None and sought.unit.powers == RADIAN and is_near(typed, sought.exact, sought.tolerance):
        return _right(typed, None, sought, Status.RIGHT, ())
    for own in sought.carried:
        if _is_worth_carrying(own, sought) and is_near(meant, own, sought.tolerance):
            return _right(typed, unit, sought, Status.CARRIED, (Remark("carried"),))
    return _missed(meant, unit, sought)


def _meant(typed: Typed, sought: ExpectedNumber) -> Typed:
    """The number with the unit that was asked for, where its own is missing or of another kind."""
    fits = typed.unit is not None and typed.unit.dimension == sought.unit.dimension
    return typed if fits else replace(typed, unit=sought.unit)


def is_near(typed: Typed, exact: float, tolerance: Tolerance) -> bool:
    """Within the tolerance, or rightly rounded to no fewer figures than are accepted (all in SI units)."""
    gap = abs(typed.si - exact)
    return _is_rounded(typed, exact, tolerance) or gap <= float(tolerance.relative) * abs(exact) * (1 + 1e-12)


def _is_rounded(typed: Typed, exact: float, tolerance: Tolerance) -> bool:
    """Is it the exact value, rounded to as many figures as are accepted and typed?"""
    fewest = max(tolerance.digits - tolerance.fewer, typed.fewest, 1)
    return bool(exact and typed.most) and any(_is_rounded_to(typed, exact, k) for k in range(fewest, typed.most + 1))


def _is_rounded_to(typed: Typed, exact: float, figures: int) -> bool:
    value = exact / (typed.unit.factor if typed.unit else 1.0)
    place = 10.0 ** (floor(log10(abs(value))) - figures + 1)
    steps = typed.value / place
    return abs(steps - round(steps)) < 1e-6 and abs(typed.value - value) <= 0.5000001 * place


def _is_worth_carrying(own: float, sought: ExpectedNumber) -> bool:
    """Guard: what follows from the own answer is a number that is not zero, and not the key itself."""
    return isfinite(own) and own != 0 and abs(own - sought.exact) > 1e-9 * abs(sought.exact)


def _right(typed: Typed, unit: Remark | None, sought: ExpectedNumber, status: Status, remarks: tuple[Remark, ...]) -> Judgement:
    figures = _figures_remark(typed, sought.tolerance) or _coarse(typed, sought)
    told = (*remarks, *(remark for remark in (unit, figures) if remark))
    share = FIGURES.get(figures.key, Fraction(0)) if figures else Fraction(1)
    found = _marked(status, Fraction(1), Fraction(unit is None), share, sought, *told)
    return found if found.credit == 1 else replace(found, status=Status.PARTLY)


def _marked(
    status: Status, value: Fraction, unit: Fraction, figures: Fraction, sought: ExpectedNumber, *remarks: Remark
) -> Judgement:
    """The parts with their credits; of a pure number the unit is no part."""
    parts = {"value": value, "unit": unit, "figures": figures}
    if not sought.unit.powers:
        parts.pop("unit")
        parts["figures"] = min(figures, unit) if unit == 0 and value else figures
    whole = sum(SHARES[name] for name in parts)
    credit = sum((SHARES[name] * part for name, part in parts.items()), Fraction(0)) / whole
    return Judgement(status, credit, remarks, parts=tuple(parts.items()))


def _unit_remark(typed: Typed, sought: ExpectedNumber) -> Remark | None:
    """What is wrong with the unit; None if nothing is. Radians need not be written."""
    if typed.unit is None:
        bare = not sought.unit.dimension and sought.unit.factor == 1
        return None if bare else Remark("unit missing")
    if typed.unit.dimension != sought.unit.dimension:
        return Remark("unit wrong")
    if typed.unit.counts_cycles != sought.unit.counts_cycles and (
        typed.unit.is_angular or sought.unit.is_angular or sought.unit.counts_cycles
    ):
        return Remark("unit cycles")
    return None


def _figures_remark(typed: Typed, tolerance: Tolerance) -> Remark | None:
    low, high = tolerance.digits - tolerance.fewer, tolerance.digits + tolerance.more
    if not typed.most or not typed.value:
        return None
    if typed.most < low:
        return Remark("too few figures", {"digits": str(tolerance.digits)})
    return Remark("too many figures", {"digits": str(tolerance.digits)}) if typed.fewest > high else None


FIGURES = {"one figure fewer": Fraction(1, 2)}  # what a remark on the figures leaves of their share, where it is not nothing


def _coarse(typed: Typed, sought: ExpectedNumber) -> Remark | None:
    """Right as far as it goes, but rounded to a figure less than is asked for; 0.5 m is 0.500 m, where that is right."""
    digits = sought.tolerance.digits
    if not typed.most or not typed.value or typed.most >= digits or not sought.exact:
        return None
    if _is_rounded_to(replace(_meant(typed, sought), most=digits), sought.exact, digits):
        return None
    return Remark("one figure fewer", {"digits": str(digits)})


def _missed(meant: Typed, unit: Remark | None, sought: ExpectedNumber) -> Judgement:
    """A wrong value: a known slip, or a sign, a power of ten, degrees for radians."""
    known = next((found for look in LOOKS if (found := look(meant, sought))), None)
    told = j.slip_remarks(known.slots["slip"]) if known and known.key == "slip" else (known or Remark("wrong value"),)
    remarks = (*told, *((unit,) if unit else ()))
    seen = Fraction(known is not None and known.key != "too few figures")
    figures = Fraction(_figures_remark(meant, sought.tolerance) is None)
    judged = _marked(Status.WRONG, Fraction(0), seen * (unit is None), seen * figures, sought, *remarks)
    slip = known.slots.get("slip") if known else None
    return replace(judged, status=Status.PARTLY if judged.credit else Status.WRONG, slip=slip)


Look = Callable[[Typed, ExpectedNumber], Remark | None]


def _too_coarse(meant: Typed, sought: ExpectedNumber) -> Remark | None:
    """The exact value, rounded to fewer figures than can be accepted: no slip that comes near it is meant."""
    digits, fewest = sought.tolerance.digits, sought.tolerance.digits - sought.tolerance.fewer
    is_meant = 0 < meant.fewest < fewest and sought.exact and _is_rounded_to(meant, sought.exact, meant.fewest)
    return Remark("too few figures", {"digits": str(digits)}) if is_meant else None


def _slip(meant: Typed, sought: ExpectedNumber) -> Remark | None:
    for known in sought.anticipated:
        if known.number is None:
            continue
        expected = float(known.number.value) * read_unit(known.number.unit).factor
        if is_near(meant, expected, sought.tolerance):
            return Remark("slip", {"slip": known.slip})
    return None


def _scaled(meant: Typed, factor: float) -> Typed:
    """The number times a factor, without the licence of its rounding."""
    return replace(meant, value=meant.value * factor, most=0)


def _sign(meant: Typed, sought: ExpectedNumber) -> Remark | None:
    return Remark("sign") if is_near(_scaled(meant, -1), sought.exact, sought.tolerance) else None


def _power_of_ten(meant: Typed, sought: ExpectedNumber) -> Remark | None:
    ratio = meant.si / sought.exact if sought.exact else 0.0
    power = round(log10(ratio)) if ratio > 0 else 0
    if not 0 < abs(power) <= MOST_TENS:
        return None
    near = is_near(_scaled(meant, 10.0**-power), sought.exact, sought.tolerance)
    return Remark("power of ten", {"power": str(power)}) if near else None


def _degrees(meant: Typed, sought: ExpectedNumber) -> Remark | None:
    if sought.unit.powers != RADIAN:
        return None
    mixed = (is_near(_scaled(meant, factor), sought.exact, sought.tolerance) for factor in (pi / 180, 180 / pi))
    return Remark("degrees") if any(mixed) else None


LOOKS: tuple[Look, ...] = (_too_coarse, _slip, _sign, _power_of_ten, _degrees)
