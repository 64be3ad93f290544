"""The library: every problem is told in full, derived in full, and bears out what its source says.

That the claims of each file come out as expected is tests/claims/test_shipped.py.
"""

import tomllib
from functools import cache

import pytest

from rbpsym.commands.arguments import entry
from rbpsym.commands.list import LEVELS
from rbpsym.languages import languages, phrases
from rbpsym.statement.library import library_folder, problem_files
from tests.library.derived import AT_START, NAMES, derived, problem

by_name = pytest.mark.parametrize("name", NAMES)


@cache
def bound():
    """The problems that some claims file speaks of."""
    files = [tomllib.loads(file.read_text()) for file in (library_folder() / "claims").glob("*.toml")]
    settings = [setting for file in files for setting in (file, *file.get("settings", {}).values())]
    return {setting["problem"] for setting in settings if "problem" in setting}


@by_name
def test_it_is_told_in_every_language(name):
    """By its file, or by what the language knows of the library's words."""
    head, found = entry("problem", name, problem_files()[name]), problem(name)
    quantities = {*found.parameters, *(coordinate.quantity for coordinate in found.coordinates)}
    own = {quantity.name: quantity.meaning for quantity in quantities if quantity.name not in found.implicit}
    own |= {body.name: body.meaning for body in found.bodies}
    assert all(own[coordinate.name] for coordinate in found.coordinates)
    for language in set(languages()) - {"en"}:
        texts = [*(told.get(language) or told["en"] for told in (head.titles, head.topics, head.levels) if language not in told)]
        texts += [meaning for of, meaning in own.items() if meaning and of not in found.meanings.get(language, {})]
        texts += [f"asked.{text}" for text, told in found.questions.items() if language not in told]
        assert not set(texts) - phrases(language, "library").keys()


@by_name
def test_it_has_its_place_in_the_library(name):
    head = entry("problem", name, problem_files()[name])
    assert head.source and head.level() in LEVELS
    assert name in bound(), "no claims file speaks of it"


def test_the_problems_of_a_folder_have_one_topic():
    topics = {}
    for name, file in problem_files().items():
        head = entry("problem", name, file)
        topics.setdefault(file.parent, set()).add(tuple(head.topic(language) for language in languages()))
    assert all(len(found) == 1 for found in topics.values()), topics


@by_name
def test_no_file_is_longer_than_a_page(name):
    text = problem_files()[name].read_text(encoding="utf-8")
    stated = text.split("[notation]")[0].split("[meanings")[0].split("[example]")[0].splitlines()
    assert len([line for line in stated if line.strip() and not line.startswith("#")]) <= 60


@by_name
def test_every_step_is_proved(name):
    verdicts = {step.id: step.certificate.verdict for step in derived(name).steps}
    assert verdicts and not {id: verdict.reason for id, verdict in verdicts.items() if not verdict.is_proved}


@by_name
def test_methods_and_oracles_agree(name):
    found = derived(name).summary()
    study = derived(name).study
    assert study.at_start == (name in AT_START)
    still = study.at_start or not study.system.independent  # statics, or one moment: no acceleration on which methods could agree
    assert (found["methods"] or still) and found["methods_agree"], found["methods"]
    assert found["lagrange"] == "PROVED"
    if study.problem.is_at_rest:  # bodies alone: their second road is the quadrature of tests/ask/test_spread.py
        assert found["simulation"] is None
        return
    assert found["simulation"] is not None and found["simulation"]["max_relative_error"] <= 1e-8
