"""What the problem asks stands first in its notes, with an honest answer."""

import pytest

from rbpsym.ask.asking import own_answers
from rbpsym.ask.found import Answer
from rbpsym.commands.written import KeptDerivations
from rbpsym.derive import derive
from rbpsym.document.model import Display, Math, Paragraph, Ref, Text, numbered, parts
from rbpsym.document.notes import DETAILS, notes
from rbpsym.document.words import Words, question
from rbpsym.expr import tree as t
from rbpsym.statement.library import find_problem, problem_files
from rbpsym.statement.loader import load_problem, load_text
from tests.library.derived import unsimulated

ASKED = find_problem("rod-pendulum").read_text(encoding="utf-8").partition("[[ask]]")[0]


def asking(*questions, said=""):
    tables = "".join(f'[[ask]]\nquestion = "{question}"\n{said}\n' for question in questions)
    return derive(load_text(f"{ASKED}\n{tables}"), simulation=False)


def text(found):
    return "".join(part.text for part in parts(found) if isinstance(part, Text))


@pytest.mark.parametrize("detail", DETAILS)
def test_the_question_comes_first_and_its_answer_is_boxed_once(detail):
    page = notes(asking("F_y in equilibrium"), "en", detail)
    assert "in equilibrium" in text(page.sections[0])
    there = [part.node.items[-1] for part in parts(page.sections) if isinstance(part, Display) and part.boxed]
    assert there.count(t.mul(t.Sym("M"), t.Sym("g"))) == 1 and (detail == "full" or len(there) == 1)


def test_an_answer_that_stands_in_the_text_is_boxed_there_and_referred_to():
    page = numbered(notes(asking("acceleration of theta", "period of theta")))
    boxed = [part for part in parts(page) if isinstance(part, Display) and part.boxed]
    assert [part.label.startswith("ask") for part in boxed] == [False, True]
    marks = [part.label for part in parts(page.sections[0]) if isinstance(part, Ref)]
    assert marks[:1] == [boxed[0].label] and "The answer, " not in text(page.sections[:-2])


def test_several_answers_have_letters_of_their_own():
    page = notes(asking("F_y in equilibrium", "period of theta"))
    [answer] = [found for found in page.sections if found.label == "section.answer"]
    boxed = [part.node.items[0] for part in parts(answer) if isinstance(part, Display) and part.boxed]
    assert boxed == [t.Sym("F_y_1"), t.Sym("T")]  # a force keeps its letter, a period has the usual one


@pytest.mark.parametrize(("name", "other"), [("rod-with-damper", "Omega"), ("ladder-with-friction", "mu")])
def test_one_quantity_has_one_letter(name, other):
    """The damped frequency ϑ_d is no Ω beside it, the least μ is told once, as μ_min."""
    boxed = [part.node for part in parts(notes(unsimulated(name))) if isinstance(part, Display) and part.boxed]
    assert len(boxed) == 2 and t.Sym(other) not in [node.items[0] for node in boxed]


def test_small_oscillations_are_told_where_they_are_asked_for():
    told = [text(notes(asking(question))) for question in ("F_y in equilibrium", "period of theta", "acceleration of theta")]
    assert ["small oscillations" in page for page in told] == [False, True, False]


def test_a_question_without_an_answer_is_told_with_its_reason():
    said = text(notes(asking("speed of theta where theta = 4")))
    assert "To this no answer is found" in said and "proved, as each of its steps is" not in said


def test_the_words_of_another_language_and_their_formulas():
    derivation = asking("F_y in equilibrium", said='said = { es = "`F_y` donde `theta = 0`" }')
    page = notes(derivation, "es").sections[0]
    [asked] = [p for p in page.blocks if isinstance(p, Paragraph) and text(p).startswith("Se pide: ")]
    told = [part.node if isinstance(part, Math) else part.text for part in asked.inlines if not isinstance(part, Ref)]
    assert told[1:4] == [t.Sym("F_y"), " donde ", t.equation(t.Sym("theta"), t.ZERO)]


def test_yes_and_no():
    page = notes(asking("does period of theta depend on M"))
    assert any(text(part).startswith("No. This answer is proved") for part in parts(page) if isinstance(part, Paragraph))


def test_of_several_forces_the_one_that_is_asked_for_stands_in_the_box():
    page = notes(unsimulated("ladder-in-equilibrium"))
    boxed = [part.node for part in parts(page) if isinstance(part, Display) and part.boxed]
    assert [t.rows(node)[0].items[0] for node in boxed] == [t.Sym("N_w"), t.Sym("d")]
    assert all(len(t.rows(node)) == 1 for node in boxed)


def test_of_a_last_phase_only_the_beginning_is_told_if_no_more_is_asked():
    names = [found.label for found in parts(notes(unsimulated("box-against-ridge"))) if isinstance(found, Display)]
    later = [name for name in names if name.startswith("phase2.")]
    assert "phase2.moment.box.O" in later and later.index("phase2.moment.box.O") < later.index("phase2.after.speeds")
    assert not {"phase2.motion.theta", "phase2.state.place", "energy"} & {*names}


def test_what_is_not_asked_of_a_given_motion_is_left_out():
    names = {found.label for found in parts(notes(unsimulated("slider-crank"))) if isinstance(found, Display)}
    assert "tied_speed.psi" in names and not any(name.startswith(("reaction.", "work.", "theorem.")) for name in names)


def test_a_question_that_no_language_knows_is_quoted_as_it_is_asked():
    words = Words("de", load_problem(find_problem("sliding-ladder")))
    assert text(question("speed of ladder where theta = 0", words)).startswith("the speed of the ladder where")


def test_why_there_is_no_answer_is_said_in_the_language_of_the_page():
    said = text(notes(asking("speed of theta where theta = 4", "tension T"), "es"))
    assert "no alcanza este valor en este movimiento" in said and "no actúa ninguna fuerza «T»" in said
    assert "does not" not in said and "acts on" not in said


HANGING = """
title = "A plank held by a rope that is cut"
[parameters]
M = "mass: mass of the plank"
ell = "length: its length"
g = "acceleration: gravity"
[coordinates.phi]
meaning = "angle of the plank below the horizontal"
start = "0"
[bodies.plank]
shape = "rod"
mass = "M"
length = "ell"
start = "O"
angle = "-phi"
[points]
H = ["ell", "ell"]
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "plank.start"
[constraints.T]
type = "string"
path = ["H", "plank.end"]
[[phases]]
name = "cut"
event = "at once"
without = ["T"]
[[ask]]
question = "T at the start"
[[ask]]
question = "F_y when cut begins"
[[ask]]
question = "F where phi = pi/2 in phase cut"
"""


def roads(page):
    """The parts of the section of answers, one for each question that stands there."""
    found = [section.blocks for section in page.sections if section.label == "section.answer"]
    heads = [k for k, block in enumerate(found[0]) if isinstance(block, Paragraph) and block.is_question] if found else []
    return [found[0][k:end] for k, end in zip(heads, [*heads, None][1:], strict=True)]


def test_the_road_to_each_answer_stands_on_the_page():
    """What is asked before a cut at once is derived there; of a later phase the energy that gives a speed, and the moment of
    inertia, are told; what a level of detail leaves out is referred to by that from which it follows."""
    page = numbered(notes(derive(load_text(HANGING), simulation=False)))
    shown = [part.node for part in parts(page) if isinstance(part, Display)]
    rules = ("I_O", "E", "phi_dot")  # moment of inertia about the pivot, energy, the square of the speed
    assert all(any(name in t.names(node) for node in shown) for name in rules)
    assert [bool([p for p in parts(road) if isinstance(p, Ref)]) for road in roads(page)] == [True, True]


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_an_answer_that_follows_from_steps_says_from_which(name):
    derivation = unsimulated(name)
    answers = [found for found in own_answers(derivation.study) if isinstance(found, Answer)]
    led = {found.question.text: len(found.steps) > (found.steps[-1:] != () and found.steps[-1].is_result) for found in answers}
    page = notes(derivation)
    bare = [road for road in roads(page) if not any(isinstance(part, Ref) for part in parts(road))]
    alone = [road for road in bare if sum(isinstance(part, Display) for part in parts(road)) < 2]
    assert len(alone) <= sum(not is_led for is_led in led.values())


@pytest.mark.parametrize("asked", ["the speed of the rod where theta = 0", "speed of rod where theta = 0"])
def test_articles_of_a_question_are_not_doubled(asked: str) -> None:
    told = question(asked, Words("en", load_problem(find_problem("rod-pendulum"))))
    assert text(told).startswith("the speed of the rod where")


@pytest.mark.parametrize(("name", "letter"), [("kater-pendulum", "T"), ("disk-off-center", "T"), ("breaking-chimney", "tau")])
def test_where_a_quantity_is_extreme_its_slope_vanishes(name, letter):
    *_, found = own_answers(unsimulated(name).study)
    [slope] = [step for step in found.steps if step.phrase == "ask.slope"]
    assert slope.certificate.verdict.is_proved and slope.statement.items[0] == t.Deriv(t.Sym(letter), found.symbol)
    assert slope.id in found.steps[-1].cites and not isinstance(slope.statement.items[-1], t.Num)


def test_what_is_asked_of_the_release_is_told_of_the_release():
    path = find_problem("rod-on-two-strings")
    alone, whole = (KeptDerivations(False, is_whole).derivation(path) for is_whole in (False, True))
    assert alone.study.at_start and not whole.study.at_start
    assert [step.statement.items[-1] for step in alone.steps if step.id == "instant.force.T"] == [
        answer.nodes[0] for answer in own_answers(whole.study)
    ]


@pytest.mark.parametrize("name", ["falling-stick", "cart-and-rod"])
def test_conserved_momenta_are_put_into_the_energy(name):
    found = unsimulated(name)
    assert {"energy", "speed_at.x"} <= {*found.step("square.theta").reasons}
