"""What browsers would draw badly is mended in the MathML that pages show."""

from __future__ import annotations

import re

import pytest

from rbpsym.document.accents import accented
from rbpsym.document.files import data_folder
from rbpsym.notation.mathml import to_mathml
from rbpsym.notation.tree import BodyIntegral, Num, Pow, Sym, Vec


@pytest.mark.parametrize("name", ["V_cm", "T", "P_x"])
def test_a_power_stands_off_the_slanted_arm_of_its_base(name: str) -> None:
    found = to_mathml(Pow(Sym(name), Num(2)))
    assert re.search(r'<mrow><mspace width="0\.\d+em"/><mn>2</mn></mrow></msu', found)


@pytest.mark.parametrize("name", ["R", "omega", "ell"])
def test_a_power_of_an_upright_letter_needs_no_room(name: str) -> None:
    assert "mspace" not in to_mathml(Pow(Sym(name), Num(2)))


def test_dots_keep_off_their_letter_and_an_integral_has_no_gap_behind_its_lower_limit() -> None:
    sheet = (data_folder("templates") / "notes.css").read_text(encoding="utf-8")
    dotted = accented(to_mathml(Sym("theta_dot")))
    assert 'class="dot-accent">˙</mo>' in dotted
    assert ".dot-accent{" in sheet
    whole = BodyIntegral(Vec("r"))
    found = accented(to_mathml(whole))
    assert '<msub class="limit"><mo>∫</mo>' in found
    assert ".limit{margin-right:-" in sheet
