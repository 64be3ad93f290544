"""What is written for Rocq is read back by a reader of its own, and is the tree that was meant."""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.errors import RbpsymError
from rbpsym.kernel.certify import Written, written
from rbpsym.kernel.reading import read, read_back
from tests.library.derived import unsimulated

PROBLEMS = ("sliding-ladder", "dog-on-flatboat", "ring-on-incline")
SPOILINGS = (
    (" + ", " - "), (" * ", " + "), (" / ", " * "), ("(- ", "("), ("sin", "cos"), (" ^ 2", " ^ 3"), (" t)", " 0)"),
    (" < ", " = "),
)  # fmt: skip


@cache
def found(name: str) -> Written:
    return written(unsimulated(name))


@pytest.mark.parametrize("name", PROBLEMS)
def test_another_text_does_not_read_as_what_was_meant(name: str) -> None:
    """One sign, function, exponent or moment changed anywhere, and brackets left out."""
    whole, spoilt = found(name), 0
    assert not whole.refused, "each statement was read back"
    for lemma in (lemma for each in whole.lemmas.values() for lemma in each):
        text = whole.writer.said(lemma.claim)
        assert read_back(text, lemma.claim, whole.source) == text
        head, arrow, said = text.rpartition(" -> ")
        for old, new in SPOILINGS:
            if old in said:
                spoilt += 1
                with pytest.raises(RbpsymError):
                    read_back(head + arrow + said.replace(old, new, 1), lemma.claim, whole.source)
    assert spoilt > 100


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("a - b - c", "(a - b) - c", True),
        ("a - b - c", "a - (b - c)", False),
        ("a / b * c", "(a / b) * c", True),
        ("a / b * c", "a / (b * c)", False),
        ("- a ^ 2", "- (a ^ 2)", True),
        ("- a ^ 2", "(- a) ^ 2", False),
        ("/ a * b", "(/ a) * b", True),
        ("- a * b", "- (a * b)", False),
        ("sin x ^ 2", "(sin x) ^ 2", True),
        ("RInt (fun x : R => x) 0 a", "RInt (fun y : R => y) 0 a", True),
        ("RInt (fun x : R => y) 0 a", "RInt (fun y : R => y) 0 a", False),
    ],
)
def test_the_reader_has_the_precedences_of_rocq(one: str, other: str, same: bool) -> None:
    assert (read(one) == read(other)) == same


@pytest.mark.parametrize("text", ["a +", "(a", "a)", "a ; b", "", "RInt (fun x => x) 0 a"])
def test_what_is_no_term_is_not_read(text: str) -> None:
    with pytest.raises(RbpsymError):
        read(text)
