"""Declared signs and ranges are premises: what contradicts them is refused where it stands."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.shapes import SHAPES
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.statement import load_text
from rbpsym.statement.premises import LEFT_OPEN, Declared, contradicts, sign_of, surely_above, without_value
from tests.statement.sound import SOUND

SIGNS = {"a": "positive", "b": "positive", "c": "real", "n": "nonnegative"}
GIVEN = Declared(SIGNS)


def tree(text: str):
    return read_infix(text, SIGNS)


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("a", "positive"),
        ("-a", "negative"),
        ("2*a*b", "positive"),
        ("-2*a/b", "negative"),
        ("a + b", "positive"),
        ("-a - b", "negative"),
        ("a - b", None),
        ("c", None),
        ("c**2", "nonnegative"),
        ("n", "nonnegative"),
        ("a + n", "positive"),
        ("sqrt(a)", "positive"),
        ("a**3", "positive"),
        ("0*c", "zero"),
        ("a - 2*a", "negative"),
        ("b - b", "zero"),
        ("1 - 1", "zero"),
        ("22/7 - pi", "positive"),
        ("3 - pi", "negative"),
        ("pi/2 - 1.5707963267948966", "positive"),
        ("pi/2 - 1.57079632679489662", "negative"),
        ("(a)", "positive"),
        ("sin(a)", None),
        ("sin(a) - 2", "negative"),
        ("1/(a - a)", None),
    ],
)
def test_sign(text: str, sign: str | None) -> None:
    assert sign_of(tree(text), GIVEN) == sign


@pytest.mark.parametrize(
    ("text", "wanted", "found"),
    [
        ("a - 2*a", "positive", "negative"),
        ("-c**2", "positive", "never positive"),
        ("-c**2", "nonnegative", LEFT_OPEN),
        ("a - b", "positive", LEFT_OPEN),
        ("c", "nonnegative", LEFT_OPEN),
        ("a**2 - a*b + b**2", "positive", ""),
        ("b - b", "positive", "zero"),
        ("b - b", "nonnegative", ""),
        ("-a", "", ""),
    ],
)
def test_contradicts(text: str, wanted: str, found: str) -> None:
    assert contradicts(tree(text), wanted, GIVEN) == found


def test_above() -> None:
    assert surely_above(tree("2*a"), tree("a"), GIVEN)
    assert surely_above(tree("a"), tree("a"), GIVEN, or_equal=True)
    assert not surely_above(tree("a"), tree("a"), GIVEN)
    assert not surely_above(tree("a"), tree("b"), GIVEN, or_equal=True)
    assert not surely_above(None, tree("b"), GIVEN)


@pytest.mark.parametrize("text", ["asin(2)", "acos(-1 - n)*0 + acos(-1 - a)", "sqrt(-a)", "ln(b - b)", "1/(c - c)",
                                  "tan(pi/2)", "(-a)**(1/2)", "ln(-c**2)", "0**(-1)"])  # fmt: skip
def test_no_value(text: str) -> None:
    assert without_value(tree(text), GIVEN)


@pytest.mark.parametrize("text", ["asin(c)", "sqrt(a - b)", "ln(c)", "1/c", "tan(a)", "c**(1/2)", "asin(1)"])
def test_may_have_a_value(text: str) -> None:
    assert without_value(tree(text), GIVEN) is None


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('length = "ell"', 'length = "«ell - ell»"', "“length” of the body “rod” must be positive, but this is zero"),
        ('mass   = "m"', 'mass   = "«m - 2*m»"', "must be nonnegative, but this is negative"),
        ('mass   = "m"', 'mass   = "«m - M»"', LEFT_OPEN),
        ('angle  = "theta - pi/2"', 'angle  = "«asin(2)» + theta"', "takes asin of what is outside its domain"),
        ('stiffness = "k"\n', 'stiffness = "«-k*cos(0)»"\n', "must be positive, but this is negative"),
    ],
)
def test_refused_at_its_place(old: str, new: str, says: str) -> None:
    assert old in SOUND
    row = new.replace("«", "").replace("»", "")
    text = SOUND.replace(old, row, 1)
    with pytest.raises(RbpsymError, match=r"file\.toml") as found:
        load_text(text, file="file.toml")
    assert says in found.value.what
    assert found.value.instead
    place = found.value.place
    assert (
        text.split("\n")[place.line - 1][place.column - 1 :][: place.width] == new[new.index("«") + 1 : new.index("»")]
    )



SIZES = {f.name for table in (SHAPES, INTERACTIONS, CONSTRAINTS) for kind in table.values() for f in kind.fields if f.sign}
SIZED = re.compile(rf'^(mass|{"|".join(sorted(SIZES))})( *= *)"(?!O")(.*)"', re.M)
EXAMPLES = Path(__file__).parents[2] / "docs" / "examples"


def _is_sized(text: str, found: re.Match) -> bool:
    """Whether the kind of the table asks for a sign of what stands there."""
    table = text[text.rfind("\n[", 0, found.start()) : found.end()]
    kind = {**INTERACTIONS, **CONSTRAINTS}.get((re.findall(r'^type *= *"([\w-]+)"', table, re.M) or [""])[-1])
    return kind is None or any(field.name == found[1] and field.sign for field in kind.fields)


STATED = [
    (path, found)
    for path in sorted(EXAMPLES.rglob("*.toml"))
    for found in SIZED.finditer(path.read_text("utf-8"))
    if _is_sized(path.read_text("utf-8"), found)
]


@pytest.mark.parametrize(("path", "found"), STATED, ids=[f"{path.stem} {found[1]} {k}" for k, (path, found) in enumerate(STATED)])
def test_a_size_of_either_sign_is_refused(path: Path, found: re.Match) -> None:
    """Every size of every kind, as a multiple of a difference that what is declared does not settle."""
    text = path.read_text("utf-8")
    changed = f'{text[: found.start()]}{found[1]}{found[2]}"({found[3]})*(n_1 - n_2)"{text[found.end() :]}'
    with pytest.raises(RbpsymError, match=LEFT_OPEN):
        load_text(changed.replace("[parameters]\n", '[parameters]\nn_1 = "number: one"\nn_2 = "number: two"\n', 1))


def test_a_bound_settles_the_sign() -> None:
    bounded = SOUND.replace('M   = "mass, nonnegative:', 'M   = "mass > m:').replace('mass   = "M"', 'mass   = "M - m"')
    assert bounded != SOUND
    load_text(bounded)
