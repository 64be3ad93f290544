"""What browsers would draw badly is mended in the MathML that pages show."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

import pytest

from rbpsym.document.files import data_folder
from rbpsym.expr.tree import BodyIntegral, Num, Pow, Sym, Vec
from rbpsym.typeset.accents import accented
from rbpsym.typeset.mathml import _SLANTS, to_mathml

FONT = Path("/usr/share/texmf/fonts/opentype/public/lm-math/latinmodern-math.otf")
ITALIC, LEAST = {*range(0x1D434, 0x1D468), *range(0x1D6FC, 0x1D715)}, 0.08  # slanted Latin and small Greek letters


@pytest.mark.parametrize("name", ["V_cm", "T", "P_x"])
def test_a_power_stands_off_the_slanted_arm_of_its_base(name: str) -> None:
    found = to_mathml(Pow(Sym(name), Num(2)))
    assert re.search(r'<mrow><mspace width="0\.\d+em"/><mn>2</mn></mrow></msu', found)


def test_the_room_beside_a_letter_is_the_italic_correction_of_its_font() -> None:
    """In em of letters that are raised, which are 0.7 as large; what would not be seen is left out."""
    fonts = pytest.importorskip("fontTools.ttLib")
    if not FONT.exists():
        pytest.skip(f"{FONT} is not installed")
    font = fonts.TTFont(FONT)
    table, names = font["MATH"].table.MathGlyphInfo.MathItalicsCorrectionInfo, font.getBestCmap()
    room = {name: value.Value / 700 for name, value in zip(table.Coverage.glyphs, table.ItalicsCorrection, strict=True)}
    slanted = {unicodedata.normalize("NFKC", chr(code)): room.get(name, 0) for code, name in names.items() if code in ITALIC}
    assert {letter: round(wide, 2) for letter, wide in slanted.items() if wide > LEAST} == _SLANTS


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
