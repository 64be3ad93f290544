"""“The problem” of a page tells what is stated: every formula of every element, of later phases and impacts too."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from rbpsym.document.model import Inlines, Math
from rbpsym.document.notes_sentences import element_sentences
from rbpsym.document.notes_statement import _bodies, _phases, _start
from rbpsym.document.words import Words
from rbpsym.document.writers.page import plain_text
from rbpsym.elements.events import STATED
from rbpsym.elements.impulses import IMPULSES
from rbpsym.expr import tree as t
from rbpsym.languages import phrases
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.study import Study
from rbpsym.pictures.pose import DrawnPose
from rbpsym.proof.assertions import Said
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.statement.model import Element, Problem
from rbpsym.statement.phases import KINDS
from tests.library.derived import derived
from tests.proof.test_assertions import said_in

EXAMPLES = Path(__file__).parents[2] / "docs" / "examples"
FILES = {**problem_files(), **{path.stem: path for path in EXAMPLES.glob("*.toml")}}
FIELDS = {kind: entry.fields for table in (*KINDS.values(), IMPULSES) for kind, entry in table.items()}
UNTOLD = {"pivot": "at", "weld": "angle"}  # they follow from the poses, and a finished element always has them
NONE = (t.ZERO, t.ZERO)
IN_WORDS = ((t.ONE, t.ZERO), (t.ZERO, t.ONE))  # “to the right”, “upwards”
AS_USUAL = {"direction": (t.ZERO, t.Neg(t.ONE)), "medium": NONE, "rest_angle": t.ZERO, "natural_length": t.ZERO,
            "tangential": t.ZERO}  # fmt: skip


def elements(problem: Problem) -> Iterator[Element]:
    yield from (*problem.constraints, *problem.interactions)
    for phase in problem.phases:
        yield from (*phase.impulses, *phase.problem.constraints, *phase.problem.interactions)


def facts(element: Element) -> Iterator[tuple[str, t.Node]]:
    """The formulas of an element by their key, without what is as usual."""
    for field in FIELDS[element.kind]:
        value = element.values.get(field.name)
        in_words = field.name == "along" and value in IN_WORDS and not element.values.get("of")
        if value != AS_USUAL.get(field.name) and UNTOLD.get(element.kind) != field.name and not in_words:
            nodes = value if isinstance(value, tuple) else (value,)
            yield from ((field.name, node) for node in nodes if isinstance(node, t.Node))


def text(sentence: Inlines) -> str:
    return plain_text(sentence, Words("en").notation, "en")


def told(study: Study, language: str) -> list[Inlines]:
    problem, pose = study.problem, DrawnPose(study)
    said = Words(language, problem)
    return [_bodies(problem, said, Said(study)), *element_sentences(pose, said), *_phases(pose, said)]


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("language", ("en", "es"))
def test_each_stated_formula_is_told(name: str, language: str) -> None:
    problem = load_problem(FILES[name])
    parts = [part for sentence in told(study_of(problem), language) for part in sentence]
    seen = {node for part in parts if isinstance(part, Math) for node in t.walk(part.node)}
    stated = {(element.name, key, node) for element in elements(problem) for key, node in facts(element)}
    stated |= {(phase.name, "at", phase.value) for phase in problem.phases if phase.value is not None}
    assert not {fact for fact in stated if fact[-1] not in seen}


@pytest.mark.parametrize("name", [name for name, path in FILES.items() if "[[phases]]" in path.read_text()])
def test_each_event_and_what_is_gone_is_told(name: str) -> None:
    problem = load_problem(FILES[name])
    sentences = told(study_of(problem), "en")
    formulas = {part.node for sentence in sentences for part in sentence if isinstance(part, Math)}
    before = problem
    for phase in problem.phases:
        assert any(f"The phase “{phase.name}” begins" in text(sentence) for sentence in sentences)
        now = {e.name for e in (*phase.problem.constraints, *phase.problem.interactions)}
        for element in (*before.constraints, *before.interactions):
            assert element.name in now or formulas & {t.Sym(element.name), t.Vec(element.name)}
        before = phase.problem


@pytest.mark.parametrize("language", ("en", "es"))
def test_there_are_words_for_each_event(language: str) -> None:
    for event in (*STATED, "taut"):
        assert phrases(language)[f"statement.event.{event.replace(' ', '_')}"]


@pytest.mark.parametrize("language", ("en", "es"))
def test_each_kind_has_its_sentence(language: str) -> None:
    told = {key.split(".")[1].partition("_")[0] for key in phrases(language) if key.startswith("statement.")}
    assert {*FIELDS} - told == {"link"}  # told as a string that may push


TAUT = '[phases.impulses.S]\ntype = "bounce"\npath = ["tow.center", "tug.center"]\nlength = "L"\nrestitution = "e"\n'
E = 'L   = "length: length of the rope"'
VARIANTS = {  # problem, what is written else, what is then said
    "as usual": ("rod-pendulum", (), "Gravity acts downwards with the acceleration g."),
    "usual, written": ("rod-pendulum", (('"gravity"', '"gravity"\ndirection = ["0", "-1"]'),), "Gravity acts downwards"),
    "gravity": ("rod-pendulum", (('type = "gravity"', 'type = "gravity"\ndirection = ["1", "0"]'),), "in the direction (1, 0)"),
    "to the right": ("crate-on-truck", (), "of the truck is driven to the right"),
    "of some": ("cart-and-rod", (('type = "gravity"', 'type = "gravity"\nbodies = ["rod"]'),), "It acts on the rod alone."),
    "smooth": ("ball-bouncing-with-spin", (('coefficient = "mu"\nslip        = "none"', ""),), "There is no friction in this."),
    "rough": ("ball-bouncing-with-spin", (('"none"', '"backward"'),), "The coefficient of friction is μ."),
    "string": ("slack-tow-rope", (("constraints = { S = ", TAUT + "#"), (E, f'{E}\ne = "number"')), "restitution is e"),
}


@pytest.mark.parametrize("name", VARIANTS)
def test_what_is_stated_else_is_said_else(name: str) -> None:
    problem, changes, sentence = VARIANTS[name]
    changed = problem_files()[problem].read_text()
    for old, new in changes:
        assert old in changed
        changed = changed.replace(old, new, 1)
    assert any(sentence in text(each) for each in told(study_of(load_text(changed)), "en"))


def test_short_notes_say_under_which_condition_it_sets_out() -> None:
    """A roller with rolling resistance leaves its place of rest on a slope that is steep enough only."""
    found = derived("cylinder-with-rolling-resistance")
    assert "It moves that way only as long as this is positive" in said_in(found, "standard")


def test_what_is_tied_has_no_speed_of_its_own_at_the_start() -> None:
    """The start of a weight on a string was told with z_dot = 0, where the block on its other end moves."""
    path = EXAMPLES / "constraints" / "string.toml"
    changed = path.read_text().replace('start = "0"', 'start = "0"\nspeed = "v_0"', 1)
    study = study_of(load_text(changed))
    begins = next(_start(study.problem, Words("en", study.problem), Said(study)))
    assert text(begins).endswith("with ẏ = v₀.")
