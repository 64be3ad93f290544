"""Each language: every key of English with the same places; the grammar of articles, cases and contractions."""

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
from rbpsym.languages import languages, part_of, phrases
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.typeset.speech import WORDS

SPANISH = phrases("es")
FOREIGN = [language for language in languages() if language != "en"]
PARTS = ("notes", "worksheets", "studio")


def base(key: str) -> str:
    return re.sub(r"\.(masculine|feminine|neuter)$", "", key)


def told(language: str, part: str) -> dict[str, str]:
    """The texts but those that each language has for itself: its grammar, its functions, its letters."""
    own = ("grammar.", "notation.", "functions.", "spoken.letters.", "sentence.")
    return {key: text for key, text in phrases(language, part).items() if not key.startswith(own)}


def places(text: str) -> set[str]:
    return {name.lower() for _, name, _, _ in Formatter().parse(text) if name}


def cases(text: str) -> set[str]:
    return {case for _, _, case, _ in Formatter().parse(text) if case}


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("language", FOREIGN)
def test_keys_and_places_are_those_of_english(language: str, part: str) -> None:
    english, own = told("en", part), told(language, part)
    assert {base(key) for key in own} == english.keys()
    assert not [key for key, text in own.items() if places(text) != places(english[base(key)])]
    assert {case for text in own.values() for case in cases(text)} <= grammar(language).cases.keys()


@pytest.mark.parametrize("part", PARTS[:2])
@pytest.mark.parametrize("language", FOREIGN)
def test_all_translate_the_same_sentences(language: str, part: str) -> None:
    assert part_of("sentence", language, part).keys() == part_of("sentence", FOREIGN[0], part).keys()


def test_english_formulas_are_spoken_as_the_printer_speaks_by_itself() -> None:
    assert part_of("spoken", "en") == dict(WORDS)


@pytest.mark.parametrize("language", FOREIGN)
def test_each_gender_has_the_others(language: str) -> None:
    keys = [key.rpartition(".") for key in told(language, "notes") if base(key) != key]
    genders = {gender for _, _, gender in keys}
    assert all((of, ".", gender) in keys for of, _, _ in keys for gender in genders)


@pytest.mark.parametrize(
    ("noun", "nominative", "accusative", "dative", "genitive"),
    [
        ("Stab", "der Stab", "den Stab", "dem Stab", "des Stabes"),
        ("untere Scheibe", "die untere Scheibe", "die untere Scheibe", "der unteren Scheibe", "der unteren Scheibe"),
        ("linkes Vorderrad", "das linke Vorderrad", "das linke Vorderrad", "dem linken Vorderrad", "des linken Vorderrades"),
        ("oberer Zylinder", "der obere Zylinder", "den oberen Zylinder", "dem oberen Zylinder", "des oberen Zylinders"),
        ("Stab 2", "Stab 2", "Stab 2", "Stab 2", "von Stab 2"),
    ],
)
def test_german_cases(noun: str, nominative: str, accusative: str, dative: str, genitive: str) -> None:
    said = plain("body.named" if noun[-1] == "2" else "body.the", "de", body=noun)
    told_in = [grammar("de").declined(said, case) for case in ("acc", "dat", "gen")]
    assert [said, *told_in] == [nominative, accusative, dative, genitive]
    assert grammar("de").declined("der Stab und der obere Stab", "acc") == "den Stab und den oberen Stab"


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
