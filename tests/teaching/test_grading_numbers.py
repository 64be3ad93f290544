"""Numbers: value, unit and significant figures are marked apart; what earns nothing earns nothing."""

from __future__ import annotations

from fractions import Fraction

import pytest

from rbpsym.errors import RbpsymError, ReadError
from rbpsym.expr import tree as t
from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading.answer import grade_number
from rbpsym.teaching.grading.number import judge_number, wanted
from rbpsym.teaching.grading.quantity import read_quantity, significant_figures
from rbpsym.teaching.model import Anticipated, Measure, NumberKey, Slip, Tolerance

# answer, value, unit, figures: which of value, unit, figures are right
PARTS = [
    ("5 V", 5, "V", 1, "vuf"),
    ("0 V·m/A", 5, "V", 1, ""),
    ("0 V", 5, "V", 1, ""),
    ("0", 5, "V", 1, ""),
    ("5 V·m/A", 5, "V", 1, "vf"),
    ("5", 5, "V", 1, "vf"),
    ("5 mV", 5, "V", 1, "uf"),
    ("1 V", 5, "V", 1, ""),
    ("4.24 m/s", 4.2426, "m/s", 3, "vuf"),
    ("4.2 m/s", 4.2426, "m/s", 3, "vuf"),
    ("4 m/s", 4.2426, "m/s", 3, ""),
    ("4.24264 m/s", 4.2426, "m/s", 3, "vu"),
    ("-4.24 m/s", 4.2426, "m/s", 3, "uf"),
    ("4,24 m/s", 4.2426, "m/s", 3, "vuf"),
    ("424 cm/s", 4.2426, "m/s", 3, "vuf"),
    ("15.3 km/h", 4.2426, "m/s", 3, "vuf"),
    ("4.24 m s^-1", 4.2426, "m/s", 3, "vuf"),
    ("4.24 m·s⁻¹", 4.2426, "m/s", 3, "vuf"),
    ("v = 4.24 m/s", 4.2426, "m/s", 3, "vuf"),
    (r"4.24\,\mathrm{m/s}", 4.2426, "m/s", 3, "vuf"),
    (r"4.24\ \frac{\text{m}}{\text{s}}", 4.2426, "m/s", 3, "vuf"),
    ("0.424e1 m/s", 4.2426, "m/s", 3, "vuf"),
    ("42.4·10^-1 m/s", 4.2426, "m/s", 3, "vuf"),
    ("4.24 m/s²", 4.2426, "m/s", 3, "vf"),
    ("42.4 m/s", 4.2426, "m/s", 3, "uf"),
    ("7 m/s", 4.2426, "m/s", 3, ""),
    ("1,2·10^3 N", 1200, "N", 2, "vuf"),
    ("1200 N", 1200, "N", 2, "vuf"),
    ("1,200 N", 1200, "N", 2, "vuf"),
    ("1.2 kN", 1200, "N", 2, "vuf"),
    ("12 m/s²", 12, "m/s^2", 2, "vuf"),
    ("12 N/kg", 12, "m/s^2", 2, "vuf"),
    ("12.3 J", 12.3, "N*m", 3, "vuf"),
    ("30°", 30, "deg", 2, "vuf"),
    ("30 deg", 30, "deg", 2, "vuf"),
    ("0.524 rad", 30, "deg", 3, "vuf"),
    ("pi/6", 30, "deg", 2, "vuf"),
    ("30", 30, "deg", 2, "vf"),
    ("0.00914 rad", 30, "deg", 3, "uf"),
    ("4.2 rad/s", 4.2, "rad/s", 2, "vuf"),
    ("4.2 s^-1", 4.2, "rad/s", 2, "vuf"),
    ("4.2 1/s", 4.2, "rad/s", 2, "vuf"),
    ("4.2 Hz", 4.2, "rad/s", 2, "vf"),
    ("40.1 rpm", 4.2, "rad/s", 2, "vuf"),
    ("sqrt(3)/2 m", 0.8660254, "m", 3, "vuf"),
    ("3/4", 0.75, "", 2, "vf"),
    ("0.75", 0.75, "", 2, "vf"),
    ("0.75 m", 0.75, "", 2, "v"),
    ("1.2E3*N", 1200, "N", 2, "vuf"),
    ("(3.1)*m", 3.1, "m", 2, "vuf"),
    ("~5.0 m/s", 5, "m/s", 2, "vuf"),
    ("9.81*m*s^-2", 9.81, "m/s^2", 3, "vuf"),
    ("1 234,5 N", 1234.5, "N", 5, "vuf"),
    ("28.6 deg", 0.5, "rad", 3, "vuf"),
    ("0 N", 0, "N", 2, "vuf"),
    ("3 N", 0, "N", 2, ""),
    ("1.1 m/s", 1.0783, "m/s", 3, "vuf"),  # a figure fewer; with a zero it is another number
    ("1.10 m/s", 1.0783, "m/s", 3, ""),
]


@pytest.mark.parametrize(("answer", "value", "unit", "figures", "right"), PARTS, ids=lambda part: str(part))
def test_parts(answer: str, value: float, unit: str, figures: int, right: str) -> None:
    found = grade_number(answer, value, unit, figures=figures)
    assert "".join(name[0] for name, credit in found.parts if credit) == right, found
    assert (found.credit == 1) == all(credit == 1 for _, credit in found.parts)
    assert bool(found.credit) == bool(right)


@pytest.mark.parametrize(
    "answer",
    ["abc", "12 foo", "1e400", "9^9^9", "3 m^99", "12 m/s kg", "100!", "1_000", "0x10", "nan", "inf", "2..3", "--", "m",
     "5 m/s/", "=cmd|' /C calc'!A0", "__import__('os')", "5 \u202em", "1e-400 m", "5 m^(2", "5 (m", "5 ms^",
     "5 mps", "5 M/S", "5.0±m"],
)  # fmt: skip
def test_what_is_no_number_gets_a_sentence(answer: str) -> None:
    found = grade_number(answer, 5, "m")
    assert found.status.value == "invalid" and found.credit == 0
    assert str(found.remarks[0].slots["why"])


@pytest.mark.parametrize(
    ("digits", "expected"),
    [("4", (1, 1)), ("0.0420", (3, 3)), ("1500", (2, 4)), ("1500.", (4, 4)), ("3.14", (3, 3)), ("0.5", (1, 1)),
     ("10", (1, 2)), ("0", (1, 1)), ("0.00", (1, 2)), ("007", (1, 1)), ("100.0", (4, 4))],
)  # fmt: skip
def test_significant_figures(digits: str, expected: tuple[int, int]) -> None:
    assert significant_figures(digits) == expected


@pytest.mark.parametrize(
    ("one", "other"),
    [("N", "kg m/s^2"), ("N m", "J"), ("Nm", "N·m"), ("kgm/s", "N s"), ("m/s/s", "m s^-2"), ("m/(s^2)", "m/s²"),
     ("km/h", "1000 m/h"), ("metros/segundo", "m/s"), ("W", "J/s"), ("kg·m²", "kg m^2"), ("µm", "um"), ("N/m", "kg/s^2")],
)  # fmt: skip
def test_units_that_are_the_same(one: str, other: str) -> None:
    first, second = read_unit(one), read_quantity(other if other[0].isdigit() else f"1 {other}")
    assert first.powers == second.unit.powers
    assert first.factor == pytest.approx(second.si)


def test_an_unknown_unit_names_the_nearest() -> None:
    with pytest.raises(RbpsymError, match="newton"):
        read_unit("newtton")


KEY = NumberKey(
    Measure(Fraction("4.24"), "m/s", 3), 4.2426, t.Sym("v"), t.Sym("v"), {}, Tolerance(),
    anticipated=(Anticipated(Slip("half"), None, Measure(Fraction("3.00"), "m/s", 3)),),
)  # fmt: skip


def test_a_slip_is_recognised() -> None:
    found = judge_number("3.0 m/s", wanted(KEY))
    assert found.slip == Slip("half") and found.remarks[0].key == "slip"


def test_an_error_carried_forward() -> None:
    assert judge_number("8.49 m/s", wanted(KEY, [8.4852])).status.value == "carried forward"
    for trivial in (0.0, float("nan"), float("inf"), 4.2426):
        assert judge_number("8.49 m/s", wanted(KEY, [trivial])).status.value == "wrong"
    assert judge_number("0 m/s", wanted(KEY, [0.0])).credit == 0


def test_a_tolerance_that_makes_no_sense_is_refused() -> None:
    with pytest.raises(RbpsymError):
        grade_number("5", 5, tolerance=2)


ABOUT = [
    "1.42±0.01 s",
    r"1.42 \pm 0.01\,\mathrm{s}",
    "1.42 s (approx.)",
    "ca. 1,42 s",
    "aprox. 1,42 s",
    "etwa 1,42 Sekunden",
    "(1.42 s)",
    "$1.42$ s",
]


@pytest.mark.parametrize("text", [*ABOUT, r"2\pi\sqrt{0.5/9.81}\,\mathrm{s}"])
def test_words_and_uncertainties_beside_a_number(text: str) -> None:
    assert grade_number(text, 1.4185, "s").credit == 1


@pytest.mark.parametrize("text", ["30 Grad", "ungefähr 30 grad", "30 degrees", "30 grados", "0,5236 Radiant"])
def test_angles_in_the_words_of_each_language(text: str) -> None:
    assert grade_number(text, 0.5236, "rad").credit == 1


@pytest.mark.parametrize("text", ["2 m/s nach oben", "2 rad/s im Uhrzeigersinn", "2 m/s hacia arriba", "2 rad/s clockwise"])
def test_a_sense_in_words_is_not_read(text: str) -> None:
    with pytest.raises(ReadError, match="a direction in words is not read"):
        read_quantity(text)


@pytest.mark.parametrize("text", ["1 1/2 s", "1½ s", "-1 1/2 s"])
def test_mixed_numbers(text: str) -> None:
    assert grade_number(text, -1.5 if text.startswith("-") else 1.5, "s").credit == 1
