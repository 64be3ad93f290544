"""Spanish: every key of English with the same places, and the grammar of articles and contractions."""

from __future__ import annotations

import re
from string import Formatter

import pytest

from rbpsym.document.phrases import gender, phrases, plain

ENGLISH, SPANISH = phrases("en"), phrases("es")


def base(key: str) -> str:
    return re.sub(r"\.(masculine|feminine)$", "", key)


def places(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_the_keys_are_those_of_english() -> None:
    assert {base(key) for key in SPANISH} == set(ENGLISH)


def test_the_places_are_those_of_english() -> None:
    def lower(text: str) -> set[str]:
        return {name.lower() for name in places(text)}

    assert not [key for key, text in SPANISH.items() if lower(text) != lower(ENGLISH[base(key)])]


def test_each_gender_has_the_other() -> None:
    assert all(base(key) + ".feminine" in SPANISH for key in SPANISH if key.endswith(".masculine"))


@pytest.mark.parametrize(
    ("noun", "found"),
    [("barra", "feminine"), ("disco", "masculine"), ("sistema doble", "masculine"), ("base", "feminine")],
)
def test_gender(noun: str, found: str) -> None:
    assert gender(noun, "es") == found


def test_articles_and_contractions() -> None:
    assert plain("body.the", "es", body="barra") == "la barra"
    assert plain("point.of", "es", point="centro", body="el disco") == "el centro del disco"
    assert plain("point.of", "es", point="esquina inferior izquierda", body="la placa").startswith("la esquina")
    assert plain("statement.couple", "es", couple="C", body="el disco") == "Se aplica un par C al disco."


def test_and_before_the_sound_i() -> None:
    assert plain("part.annulus", "es", inner="x", outer=["aro", "hilo"]).endswith("aro e hilo")
    assert plain("part.annulus", "es", inner="x", outer=["aro", "hielo"]).endswith("aro y hielo")
