"""Phrases: every key is found or told, places are filled, no formula hides in a language file."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from string import Formatter

import pytest

from rbpsym.document.model import DocumentError, Emph, Math, Ref, Text
from rbpsym.document.phrases import grammar, has_phrase, phrase, plain, usual_notation
from rbpsym.document.words import Words
from rbpsym.errors import RbpsymError
from rbpsym.expr.tree import Fn, Sym
from rbpsym.languages import FOLDER, languages, phrases
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.typeset.latex import to_latex
from rbpsym.typeset.speech import to_speech

THETA, OMEGA, ELL = Sym("theta"), Sym("omega"), Sym("ell")


@pytest.fixture
def table(monkeypatch: pytest.MonkeyPatch) -> None:
    own = {
        "list.separator": ", ",
        "list.last": " and ",
        "we": "We use {what}.",
        "stress": "It is *not {what}*, but {other}.",
        "body.one": "one body",
        "body.many": "{count} bodies",
        "disk.feminine": "la {name}",
        "disk.masculine": "el {name}",
    }
    monkeypatch.setattr("rbpsym.document.phrases.phrases", lambda language, part="notes": own)


@pytest.mark.usefixtures("table")
def test_a_node_becomes_a_formula_and_a_reference_stays() -> None:
    assert phrase("we", what=THETA) == (Text("We use "), Math(THETA), Text("."))
    assert phrase("we", what=Ref("eq:a")) == (Text("We use "), Ref("eq:a"), Text("."))


@pytest.mark.usefixtures("table")
def test_a_list_is_joined_by_the_rule_of_the_language() -> None:
    assert phrase("we", what=[THETA, OMEGA, ELL]) == (
        Text("We use "),
        Math(THETA),
        Text(", "),
        Math(OMEGA),
        Text(" and "),
        Math(ELL),
        Text("."),
    )
    assert plain("we", what=["a", "b"]) == "We use a and b."


@pytest.mark.usefixtures("table")
def test_a_phrase_may_fill_a_place_of_another() -> None:
    assert phrase("we", what=phrase("we", what=THETA))[1] == Math(THETA)


@pytest.mark.usefixtures("table")
def test_emphasis() -> None:
    assert phrase("stress", what=THETA, other="x")[1] == Emph((Text("not "), Math(THETA)))


@pytest.mark.usefixtures("table")
def test_variants_by_count_and_by_name() -> None:
    assert plain("body", count=1) == "one body"
    assert plain("body", count=3) == "3 bodies"
    assert plain("disk", variant="feminine", name="x") == "la x"
    assert has_phrase("body")
    assert not has_phrase("bod")


@pytest.mark.usefixtures("table")
@pytest.mark.parametrize(
    ("key", "slots", "told"),
    [
        ("wee", {}, "we"),
        ("we", {}, "what"),
        ("body", {}, "body"),
        ("disk", {"variant": "neuter", "name": "x"}, "disk.neuter"),
    ],
)
def test_a_missing_key_variant_or_place_is_an_error(key: str, slots: dict, told: str) -> None:
    with pytest.raises(DocumentError, match=told):
        phrase(key, **slots)


def test_an_unknown_language_is_told_with_the_known_ones() -> None:
    with pytest.raises(RbpsymError, match="xx") as error:
        phrase("list.last", "xx")
    assert "en" in str(error.value)


@pytest.mark.parametrize("language", languages())
def test_no_formula_and_no_markup_stands_in_a_phrase(language: str) -> None:
    for key, text in phrases(language).items():
        bare = re.sub(r"\{\w+(:\w+)?\}", "", text)
        if key.startswith("grammar."):
            continue
        assert not re.search(r"[\\$=^<>{}]|\d[a-z]|[α-ω]", bare), key
        assert text.count("*") % 2 == 0, key
        assert all(name != "" for _, name, _, _ in Formatter().parse(text)), key


def test_a_further_language_is_one_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Grammar, functions, marks and spoken words come from the folder alone, and what the library's authors said."""
    shutil.copytree(FOLDER, tmp_path, dirs_exist_ok=True)
    shutil.copytree(FOLDER / "en", tmp_path / "qfr")
    own = (FOLDER / "en" / "notes.toml").read_text(encoding="utf-8")
    own = own.replace('decimal = "."', 'decimal = ","').replace('singular = "1"', 'singular = "0 1"')
    own = own.replace('statement = "The problem"', 'statement = "Le problème"').replace('sin = "sine"', 'sin = "sinus"')
    own += '\n[functions]\ntan = "tg"\n\n[grammar.contractions]\n"de le" = "du"\n'
    (tmp_path / "qfr" / "notes.toml").write_text(own, encoding="utf-8")
    (tmp_path / "qfr" / "library.toml").write_text('"Sliding ladder" = "Échelle"\nladder = "échelle"\n', encoding="utf-8")
    monkeypatch.setattr("rbpsym.languages.FOLDER", tmp_path)
    assert "qfr" in languages()
    ladder = Words("qfr", load_problem(problem_files()["sliding-ladder"]))
    assert ladder.title(ladder.problem.title) == "Échelle"
    assert plain("body.the", "qfr", body=ladder.body("ladder")) == "the échelle"
    assert phrases("qfr", "worksheets")["paper.key"] == "Key"
    known = usual_notation("qfr")
    assert to_latex(Fn("tan", THETA), known) == r"\operatorname{tg}\theta"
    assert to_speech(Fn("sin", THETA), known) == "sinus of theta"
    assert known.decimal == ","
    assert grammar("qfr").number(0) == "one"
    assert plain("point.of", "qfr", point="centre", body="x") == "the centre of x"
    assert grammar("qfr").contracted("de le disque") == "du disque"
    assert phrase("section.statement", "qfr") == (Text("Le problème"),)
