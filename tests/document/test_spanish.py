"""Spanish: every key of English with the same places, and the grammar of articles and contractions."""

from __future__ import annotations

import re
from string import Formatter

import pytest

from rbpsym.derive import derive
from rbpsym.document.looks import looks, speak
from rbpsym.document.notes import notes
from rbpsym.document.phrases import grammar, plain
from rbpsym.document.writers import writer
from rbpsym.errors import RbpsymError
from rbpsym.expr.tree import Fn, Sym
from rbpsym.languages import part_of, phrases
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.typeset.speech import WORDS

ENGLISH, SPANISH = phrases("en"), phrases("es")


def base(key: str) -> str:
    return re.sub(r"\.(masculine|feminine)$", "", key)


def is_own(key: str) -> bool:
    """Does a key tell what each language has for itself: its grammar, its functions, its letters?"""
    return key.startswith(("grammar.", "notation.", "functions.", "spoken.letters.", "sentence."))


def places(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name}


def test_the_keys_are_those_of_english() -> None:
    assert {base(key) for key in SPANISH if not is_own(key)} == {key for key in ENGLISH if not is_own(key)}


def test_the_places_are_those_of_english() -> None:
    def lower(text: str) -> set[str]:
        return {name.lower() for name in places(text)}

    shared = ((key, text) for key, text in SPANISH.items() if not is_own(key))
    assert not [key for key, text in shared if lower(text) != lower(ENGLISH[base(key)])]


def test_english_formulas_are_spoken_as_the_printer_speaks_by_itself() -> None:
    assert part_of("spoken", "en") == dict(WORDS)


def test_each_gender_has_the_other() -> None:
    assert all(base(key) + ".feminine" in SPANISH for key in SPANISH if key.endswith(".masculine"))


@pytest.mark.parametrize(
    ("noun", "found"),
    [("barra", "feminine"), ("disco", "masculine"), ("sistema doble", "masculine"), ("base", "feminine")],
)
def test_gender(noun: str, found: str) -> None:
    assert grammar("es").gender(noun) == found


def test_articles_and_contractions() -> None:
    assert plain("body.the", "es", body="barra") == "la barra"
    assert plain("point.of", "es", point="centro", body="el disco") == "el centro del disco"
    assert plain("point.of", "es", point="esquina inferior izquierda", body="la placa").startswith("la esquina")
    assert plain("statement.couple", "es", couple="C", body="el disco") == "Se aplica un par C al disco."


def test_and_before_the_sound_i() -> None:
    assert plain("part.annulus", "es", inner="x", outer=["aro", "hilo"]).endswith("aro e hilo")
    assert plain("part.annulus", "es", inner="x", outer=["aro", "hielo"]).endswith("aro y hielo")


@pytest.mark.parametrize(
    "other", ["centro de masas", "centros de masas", "barra delgada", "“", "”", " de el ", " a el ", "  "]
)
def test_one_word_for_each_thing(other: str) -> None:
    tables = {**SPANISH, **{key: text for key, text in phrases("es", "worksheets").items() if not key.startswith("sentence.")}}
    assert not [key for key, text in tables.items() if other in text.strip()]


def test_accents_that_are_often_forgotten_are_there() -> None:
    words = re.findall(r"[a-záéíóúñü]+", " ".join([*SPANISH.values(), *phrases("es", "worksheets").values()]).lower())
    plain = {"angulo", "angulos", "friccion", "segun", "tambien", "despues", "ademas", "energia", "energias", "ecuacion",
             "posicion", "razon", "unico", "numero", "vertice", "circulo", "asi", "solucion", "articulacion"}  # fmt: skip
    assert not plain & set(words)
    assert not [word for word in words if re.fullmatch(r"\w+[cs]ion", word)]


def test_values_show_themselves_in_the_language_that_was_chosen() -> None:
    speak("es")
    try:
        shown = looks(load_problem(problem_files()["sliding-ladder"]))["text/plain"]
        assert "la escalera" in shown
        assert looks(Fn("sin", Sym("theta")))["text/plain"] == "sen θ"
        with pytest.raises(RbpsymError, match="xx"):
            speak("xx")
    finally:
        speak("en")


def test_a_notebook_speaks_its_language() -> None:
    derivation = derive(load_problem(problem_files()["rod-pendulum"]), simulation=False)
    source = writer("ipynb")(notes(derivation, "es"))
    assert "speak('es')" in source
    assert "pasos demostrados" in source
