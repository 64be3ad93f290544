"""[names.es]: what bodies, points and phases are called in another language."""

from __future__ import annotations

import pytest

from rbpsym.errors import StatementError
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_text

LADDER = problem_files()["sliding-ladder"].read_text(encoding="utf-8")


def named(section: str) -> str:
    return LADDER.replace("[example]", f"{section}\n\n[example]")


def test_a_meaning_of_one_word_names_a_body_in_formulas() -> None:
    assert load_text(LADDER).names_in("es") == {"ladder": "escalera"}
    assert load_text(LADDER).names_in("en") == {}


def test_a_name_of_its_own_goes_before_the_meaning() -> None:
    assert load_text(named('[names.es]\nladder = "E"')).names_in("es") == {"ladder": "E"}


@pytest.mark.parametrize(
    ("section", "says", "cure"),
    [
        ('[names.es]\nlader = "x"', "speaks of “lader”", "ladder"),
        ('[names.es]\nladder = "la escalera"', "can't stand in a formula", "one word"),
        ('[names.es]\nladder = "N_w"', "both “ladder” and “N_w” are called “N_w”", "[names.es]"),
        ('[names.spanish]\nladder = "x"', "is no language", "[names.es]"),
    ],
)
def test_wrong_names_get_a_sentence(section: str, says: str, cure: str) -> None:
    with pytest.raises(StatementError) as found:
        load_text(named(section))
    assert says in found.value.what
    assert cure in found.value.instead
    assert found.value.place is not None
