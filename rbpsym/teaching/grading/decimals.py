"""Decimals in a formula: a number with its unit behind it (`√(3g/ℓ) ≈ 5.42 rad/s`), and coefficients that are rounded."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from rbpsym.equality.dimensions import dimension_of
from rbpsym.equality.enclosure import ends
from rbpsym.errors import DimensionError, RbpsymError
from rbpsym.notation import tree as t
from rbpsym.teaching.grading.book import Book
from rbpsym.teaching.grading.ground import Ground
from rbpsym.teaching.grading.intervals import enclosed
from rbpsym.teaching.grading.judgement import Judgement, wrong
from rbpsym.teaching.grading.quantity import Typed, read_quantity
from rbpsym.teaching.grading.typed import unframed
from rbpsym.teaching.grading.words import WORD, lookup, spelled

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


def agrees(number: Typed, key: t.Node, ground: Ground) -> bool:
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
    return abs(float(sum(ends(enclosed(key))) / 2) - number.si) <= number.place


def rounded(answer: t.Node, key: t.Node, ground: Ground) -> Judgement | None:
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
