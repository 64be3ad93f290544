"""The grammar of a book's English: what it makes of a question, and that what was refused for a reason stays refused."""

from __future__ import annotations

import random
import re
from itertools import product
from pathlib import Path

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered, ask
from rbpsym.ask.words.chart import Chart, compiled, tokens
from rbpsym.ask.words.means import MEANINGS
from rbpsym.ask.words.motions import MOTIONS
from rbpsym.ask.words.reader import NAMED, VALUES, grammar, read
from rbpsym.errors import RbpsymError, StatementError
from rbpsym.statement.loader import load_problem
from tests.library.derived import problem

# (problem, a book's words, what they mean in the engine's)
MEANT = [
    ("ball-in-a-loop", "how long does it take until the ball stops?", "time until ball comes to rest"),
    ("ball-in-a-loop", "smallest v_0 such that the ball does not leave the loop", "smallest v_0 for which ball stays in contact"),
    ("rod-pendulum", "What is the angular velocity of the rod when theta has reached pi/2?",
     "angular velocity of rod where theta = pi/2"),
    ("rod-pendulum", "at what theta does the rod come to rest", "theta where rod comes to rest"),
    ("sliding-ladder", "how fast is the ladder turning when it is horizontal",
     "angular velocity of ladder where ladder is horizontal"),
    ("sliding-ladder", "the horizontal velocity of ladder.end at the instant when theta = pi/6",
     "horizontal component of velocity of ladder.end where theta = pi/6"),
    ("rod-pendulum", "with what speed does the rod come to rest", "speed of rod where rod comes to rest"),
    ("braking-car", "how long does it take until the car has stopped", "time until car comes to rest"),
    ("braking-car", "for what value of mu does the car slip", "mu for which car slips"),
    ("braking-car", "greatest speed that the car reaches", "largest speed of car"),
    ("braking-car", "mu for which tipping impends", "mu for which it tips"),
    ("two-gears", "ratio of the angular velocity of small to that of large",
     "ratio of angular velocity of small to angular velocity of large"),
    ("sliding-ladder", "colour of the ladder where it is warmest", None),
]  # fmt: skip


READ = [tuple(line.split("\t")) for line in Path(__file__).with_name("read_as.tsv").read_text("utf-8").splitlines()[1:]]


@pytest.mark.parametrize(("name", "said", "meant"), [*MEANT, *READ])
def test_words_are_read(name: str, said: str, meant: str | None) -> None:
    assert (meant in read(problem(name), said)) if meant else read(problem(name), said) == []


CHANGES = (
    ["half", "twice", "average", "maximum", "minimum", "initial", "final", "tangential", "relative", "not", "net", "never"],
    ["when it rains", "on the way back", "in the second phase", "per unit mass", "about the other end", "on average", "twice",
     "without friction", "if mu = 0", "in the opposite direction", "not", "not at all"],
)  # fmt: skip


@pytest.mark.parametrize("seed", range(6))
def test_no_word_that_changes_a_question_is_swallowed(seed: int) -> None:
    """With one word more that says something a question means another thing, or nothing."""
    draw, swallowed = random.Random(seed), []
    for name, said, meant in draw.sample([*MEANT, *READ], 60):
        words = said.rstrip("?").split()
        place = draw.randrange(len(words))
        spoilt = " ".join([*words[:place], draw.choice(CHANGES[0]), *words[place:]])
        for other in (spoilt, f"{said.rstrip('?')} {draw.choice(CHANGES[1])}"):
            if meant and meant in read(problem(name), other):
                swallowed.append((name, other))
    assert not swallowed


def test_every_name_of_the_grammar_is_defined_and_every_function_used() -> None:
    """A row that names what nobody reads would never be read; a function that no row names would not be tried."""
    rows, used = grammar(), set()

    def names(node: tuple) -> None:
        kind, what = node
        if kind == "named":
            used.add(what[0])
        for part in what if kind in ("either", "all") else [what[0]] if kind == "caught" else []:
            names(part)

    for row in (row for rows_ in rows.values() for row in rows_):
        names(row[0])
    assert used - rows.keys() <= {*NAMED, *VALUES, "Value", "Formula", "Raw", "Stranger"}
    assert rows.keys() - used == {"Question"}
    said = {meaning[1:] for rows_ in rows.values() for _, meaning, _ in rows_ if meaning.startswith("@")}
    assert said == {*MEANINGS, *MOTIONS, "it"}
    for node, meaning, _ in (row for rows_ in rows.values() for row in rows_):
        assert set(re.findall(r"{(\w+)}", meaning)) <= {*labels(node), "Subj"}, meaning


def labels(node: tuple) -> set[str]:
    """The names by which a pattern hands on what it has read."""
    kind, what = node
    inner = what if kind in ("either", "all") else [what[0]] if kind == "caught" else []
    own = {what[1]} if kind in ("named", "caught") else set()
    return own.union(*(labels(part) for part in inner))


def test_the_chart_finds_every_reading() -> None:
    rules = {"S": [(compiled("A [b] (c|d):x"), "{A}{x}", 0)], "A": [(compiled("a"), "1", 0), (compiled("a b"), "2", 1)]}
    assert Chart("a b c", rules, {}).read("S") == {"1c": 0, "2c": 1}
    assert Chart("a c", rules, {}).read("S") == {"1c": 0} and Chart("b c", rules, {}).read("S") == {}
    assert [one.word for one in tokens("x_1 = 2*pi, rod.end")] == ["x_1", "=", "2", "*", "pi", ",", "rod.end"]


NOWHERE = [  # refused as it was read: no other meaning is looked for
    ("ball-in-a-loop", "time until theta = -5"),
    ("yo-yo", "how far does it fall"),  # until when?
    ("block-up-and-down-incline", "final speed of the block"),
    ("ball-and-hinged-rod", "angular velocity of the rod when it is hit by the ball"),
    ("rod-pendulum", "speed of the zeppelin when it comes to rest"),
    ("sliding-ladder", "largest mu for which the ladder does not slide up"),
    ("braking-car", "angular velocity of the car wheel"),
    ("braking-car", "acceleration after it starts rolling"),
    ("rod-pendulum", "angular velocity right after the rod is released from theta = pi/3"),
    ("rod-pendulum", "time until it stops again"),
    ("rod-pendulum", "x " * 5000),
    ("rod-caught-at-end", "energy lost when it hits the ground"),
    ("falling-stick", "angular velocity of the stick if it is released from rest when it is horizontal"),
    ("rod-pendulum", "angular velocity of the rod in its equilibrium"),
    ("cylinder-on-belt", "heat produced"),
    ("rod-pendulum", "period of small oscillations about the upright position"),
    ("bullet-in-a-rod", "energy lost on the way"),
    ("bullet-in-a-rod", "fraction of the energy lost to friction"),
    ("block-up-and-down-incline", "acceleration on the way down"),
    ("rod-hits-ball-at-bottom", "speed of the ball then"),
    ("crate-on-truck", "A required to move"),
    ("ring-on-incline", "velocity at the bottom of an incline of length L"),
    ("spring-coupled-pendulums", "ratio of the amplitudes"),
    ("rod-pendulum", "speed of rod.end if the rod were twice as long"),
]


@pytest.mark.parametrize(("name", "said"), NOWHERE)
def test_what_is_not_understood_is_refused(name: str, said: str) -> None:
    with pytest.raises(RbpsymError):
        answered(Asked(problem(name)), said)


WORDS = ("speed", "velocity", "acceleration", "kinetic energy", "angular velocity")
MOMENTS = {"at the start": "at start", "when released": "at start", "at the moment of release": "at start"}


@pytest.mark.parametrize(("noun", "moment"), list(product(WORDS, MOMENTS)))
def test_each_quantity_goes_with_each_moment(noun: str, moment: str) -> None:
    """In front or behind, with or without an opening: it is one question."""
    own, orders = problem("rod-pendulum"), ("{q} {m}", "{m}, {q}", "what is {q} {m}?", "find {q} {m}.")
    said = {tuple(read(own, order.format(q=f"the {noun} of the rod", m=moment))) for order in orders}
    assert said == {(f"{noun} of rod {MOMENTS[moment]}",)}


def test_what_was_read_is_told() -> None:
    [found] = ask(load_problem("rod-pendulum"), "how fast is the rod turning when theta has reached pi/2")
    assert found.read_as == "angular velocity of rod where theta = pi/2" and found.question.text.startswith("how fast")
    assert not ask(load_problem("rod-pendulum"), "F_y at the start")[0].read_as


LETTERS = [  # a letter that the question brings with it, and what tells what it is
    ("yo-yo", "speed after falling h", "2*b*sqrt(g*h/(R**2 + 2*b**2))"),
    ("ball-on-incline", "time to roll down a length L", "sqrt(14*L/(5*g*sin(beta)))"),
    ("torsion-pendulum", "kappa for which the period is T", "2*pi**2*M*R**2/T**2"),
    ("planet-wheel", "angular velocity of the arm after n revolutions", "2*sqrt(6*pi*n*T/((R + r)**2*(9*m + 2*M)))"),
    ("boat-coasting", "speed after it has gone a distance d", "v_0 - c*d/m"),
]


@pytest.mark.parametrize(("name", "said", "value"), LETTERS)
def test_a_letter_may_come_with_the_question(name: str, said: str, value: str) -> None:
    [found] = ask(load_problem(name), said)
    assert found.text == value and found.verdict.is_proved


def test_a_question_in_the_plural_is_asked_of_each() -> None:
    assert len(ask(load_problem("two-gears"), "angular acceleration of each gear")) == 2
    found = ask(load_problem("atwood-with-massive-pulley"), "tensions on both sides")
    assert [one.question.text for one in found] == ["T_1", "T_2"]


def test_a_refusal_says_what_is_not_understood() -> None:
    with pytest.raises(StatementError, match="“when it rains” is not understood behind “normal force at front wheel”") as told:
        ask(load_problem("rear-wheel-drive"), "normal force at the front wheel when it rains")
    assert "at the start" in (told.value.instead or "")


def test_several_meanings_are_refused_by_name() -> None:
    with pytest.raises(StatementError, match="may mean several things"):
        answered(Asked(problem("brake-drum")), "vertical component of the reaction at the hinge at the start")
