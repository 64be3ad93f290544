"""Notes of the library in Spanish: nothing is left in English, and the grammar holds in every sentence."""

from __future__ import annotations

import re
from functools import cache

import pytest

from rbpsym.document.notes import notes
from rbpsym.document.phrases import grammar
from rbpsym.document.writers import writer
from rbpsym.expr.glyphs import spaced
from rbpsym.expr.letters import LETTERS
from rbpsym.languages import languages, phrases
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.library.derived import NAMES, derived, problem

pytestmark = pytest.mark.heavy(of=6)

ENGLISH = re.compile(
    r"\b(the|which|with|whose|equals|and|of|is|are|for|from|about|by|at|on|to|not|its?|their|this|that|"
    r"force|torque of|rod|disk|ball|wheel|ring|point|centre|center|rate|speed|work|start|end)\b",
    re.IGNORECASE,
)
MASCULINE = re.compile(r"\b(?:el|del|al|un|este|ese|ningún) (\w+)", re.IGNORECASE)
FEMININE = re.compile(r"\b(?:la|una|esta|esa|ninguna) (\w+)", re.IGNORECASE)
PASSED = frozenset(["que", "de", "del", "cual", "más", "menor", "mayor", "vez", "ejerce", "hay"])  # these are no nouns


@cache
def text_of(name: str) -> str:
    return str(writer("md")(notes(derived(name), "es", "full")))


@cache
def prose(name: str) -> tuple[str, ...]:
    """The lines of the notes without formulas and without the source, whose title stays as it is."""
    bare = re.sub(r"\$\$.*?\$\$|\$[^$]*\$", "⟨⟩", text_of(name), flags=re.DOTALL)
    lines = (line for line in bare.splitlines() if not re.match(r"\*[A-Z]|\*arXiv|!|\|? ?:|#", line))
    return tuple(cell.strip() for line in lines for cell in line.split("|") if cell.strip())


@pytest.mark.parametrize("name", NAMES)
def test_notes_are_spanish(name: str) -> None:
    assert not [line for line in prose(name) if ENGLISH.search(line)]


@pytest.mark.parametrize("name", NAMES)
def test_words_are_contracted_spaced_and_quoted_as_spanish_asks(name: str) -> None:
    for line in prose(name):
        assert not re.search(r"\b(de|a) el\b", line, re.IGNORECASE), line
        assert not re.search(r"\b[yY] h?i(?![aeo])", line), line
        assert not re.search(r"(?<=\S)  (?=\S)| [,;:.](?=\s|$)|,,|;;|“|”|\(\)", line), line
        assert not re.search(r"\d\.\d", re.sub(r"arXiv\S*", "", line)), line


@pytest.mark.parametrize("name", NAMES)
def test_articles_agree_with_their_nouns(name: str) -> None:
    for pattern, gender in ((MASCULINE, "masculine"), (FEMININE, "feminine")):
        for line in prose(name):
            for noun in pattern.findall(line):
                assert noun.lower() in PASSED or grammar("es").gender(noun) == gender, f"{noun}: {line}"


@pytest.mark.parametrize("name", NAMES)
def test_what_reads_as_an_english_word_has_a_name_in_each_language(name: str) -> None:
    found = problem(name)
    own = [*found.body_names, *(element.name for element in (*found.constraints, *found.interactions))]
    own += [point for body in found.bodies for point in body.points if point not in SHAPE_POINTS]
    own += [phase.name for phase in found.phases]
    for language in set(languages()) - {"en"}:
        known = {*found.names_in(language), *phrases(language, "library")}
        assert not [word for word in own if is_a_word(word) and not {word, spaced(word)} & known and word not in SAME]


SHAPE_POINTS = frozenset(
    "center start end cm middle origin left right top bottom top_left top_right bottom_left bottom_right".split()
)
SAME = frozenset({"chasis"})


def is_a_word(name: str) -> bool:
    """Letters of three or more that are no name of a letter."""
    return any(part.isalpha() and len(part) > 2 and part not in LETTERS for part in re.split("[_ ]", name))


def test_the_names_of_the_library_are_drawn() -> None:
    assert r"\mathrm{disco}" in text_of("rod-and-disk-free")
    assert r"\operatorname{sen}\theta" in text_of("rod-and-disk-free")
    assert load_problem(problem_files()["two-gears"]).names_in("es")["large"] == "grande"
