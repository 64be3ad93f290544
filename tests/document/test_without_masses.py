"""Where masses are not stated, no letter is printed that the statement does not have; what is shown is how things move."""

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.expr import tree as t
from rbpsym.mechanics.at_start import study_of
from rbpsym.solve import answer_of
from rbpsym.statement.checks import unknowns_of
from rbpsym.studio import api
from rbpsym.teaching.plan import plan_of
from tests.library.derived import derived_from, stated

FILES = {file.stem: file for file in sorted((Path(__file__).parents[1] / "ask" / "given").glob("*.toml"))}
COMMANDS = {  # of all outputs, those that write files into a folder, and those that print
    "notes": ("notes", "--format", "md,html,tex,typ,ipynb", "--detail", "full", "--lang", "en"),
    "brief": ("notes", "--format", "md,beamer", "--detail", "brief", "--lang", "de"),
    "papers": ("worksheet", "--format", "html,tex,moodle,qti,canvas,prairielearn,gift", "--solution"),
    "explorer": ("explore",),
    "plot": ("plot",),
    "solve": ("solve",),
    "solve --json": ("solve", "--json"),
    "derive": ("derive", "--detail", "full"),
    "roads": ("derive", "--roads"),
}
WRITES = ("notes", "brief", "papers", "explorer", "plot")
OPERATIONS = ("glance", "notes", "letters")
UNSAID = re.compile(r"unknown (?:force|normal|couple|tension)|not stated:|of mass \$|unbekannte Kraft|moment of inertia\b")


def invented(name: str) -> re.Pattern[str]:
    """Any print of the letters that stand for masses and for what holds or leads."""
    problem = stated(FILES[name])
    forces = {letter for e in problem.constraints for letter in unknowns_of(e)} - {e.name for e in problem.constraints}
    stems = {tuple(letter.split("_", 1)) for letter in (*problem.unstated, *forces)}
    return re.compile("|".join(rf"\b{stem}_+{{?(?:\\mathrm{{)?{mark}\b" for stem, mark in stems))


def told(name: str, command: str, folder: Path) -> dict[str, str]:
    words, out = list(COMMANDS[command]), ["-o", str(folder / "out")] if command in WRITES else []
    found = CliRunner().invoke(main, [words[0], str(FILES[name]), *words[1:], *out], catch_exceptions=False)
    assert found.exit_code == 0, found.output
    files = [file for file in folder.rglob("*") if file.is_file() and file.suffix not in (".pdf", ".zip", ".png")]
    return {command: found.output, **{str(file.relative_to(folder)): file.read_text() for file in files}}


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("name", [name for name in FILES if name != "rod"])
def test_no_letter_is_printed_that_the_statement_does_not_have(name: str, command: str, tmp_path: Path) -> None:
    pattern = invented(name)
    for file, text in told(name, command, tmp_path).items():
        assert not pattern.search(text), (file, pattern.search(text))
        assert command == "solve --json" or not UNSAID.search(text), (file, UNSAID.search(text))


@pytest.mark.parametrize("name", FILES)
def test_no_formula_holds_a_mass_or_a_force(name: str) -> None:
    """In the derivation, in what machines are told, and in the studio."""
    derivation = derived_from(FILES[name])
    problem = derivation.study.problem
    assert problem.unstated
    hidden = {*problem.unstated, *(letter for e in problem.constraints for letter in (e.name, *unknowns_of(e)))}
    for step in derivation.steps:
        assert hidden.isdisjoint(t.names(step.statement)), step.id
        assert step.certificate.verdict.is_proved, step.id
    record = answer_of(derivation)
    assert hidden.isdisjoint(record["symbols"])
    values = json.dumps({key: value for key, value in record.items() if key != "masses"})
    assert not any(re.search(rf"\b{name}\b", values) for name in problem.unstated)
    for operation in OPERATIONS:
        assert not invented(name).search(json.dumps(getattr(api, operation)(FILES[name].read_text())))


SHOWN = {
    "wheel": {"velocity.wheel", "acceleration.wheel", "turning.wheel", "angular_acceleration.wheel", "centre.wheel"},
    "ladder": {"velocity.ladder", "acceleration.ladder", "turning.ladder", "angular_acceleration.ladder", "centre.ladder"},
    "wedge": {"velocity.wedge", "velocity.block", "acceleration.wedge", "acceleration.block"},
    "planet": {"turning.sun", "turning.spider", "turning.planet", "centre.planet", "velocity.planet"},
    "slider-crank": {"turning.rod", "centre.rod", "velocity.rod"},
}


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_shown_without_questions_is_how_things_move(name: str) -> None:
    assert {step.id for step in derived_from(FILES[name]).steps if step.is_result} >= SHOWN[name]


@pytest.mark.parametrize("name", SHOWN)
def test_papers_ask_how_things_move(name: str) -> None:
    sheet = plan_of(stated(FILES[name])).worksheet()
    about = {item.asked.quantity.split(".")[0] for part in sheet.parts for item in part.items}
    assert about == {"given"}


def test_the_instantaneous_centre_is_at_rest() -> None:
    """By the velocity of the point of the body that is there, not by the formula that gave it."""
    for name in SHOWN:
        system = study_of(stated(FILES[name])).system
        context = derived_from(FILES[name]).letters
        for step in (step for step in derived_from(FILES[name]).steps if step.id.startswith("centre.")):
            state = system.bodies[step.id.removeprefix("centre.")]
            place = context.vectors[step.statement.items[0].name].plane
            there = state.velocity + (place - state.center).turned() * state.omega
            assert context.vectors and not there.x and not there.y, step.id


def test_a_speed_that_is_taken_to_be_kept_is_told_in_the_notes(tmp_path: Path) -> None:
    text = "".join(told("ladder", "notes", tmp_path).values())
    assert r"it is taken that $\dot{x} = v$ all the time" in text
    assert "which is taken to be kept, follows" in text
    text = "".join(told("wheel", "notes", tmp_path).values())
    assert r"All the time, $\ddot{x} = a$" in text
