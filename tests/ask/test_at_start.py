"""What is asked at the start alone is found there: no free place is left in it, in its steps or in its conditions."""

import pytest

from rbpsym.ask.asking import answered, ask
from rbpsym.decide.equal import equal
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.statement.loader import load_text
from rbpsym.typeset.machine import to_machine
from tests.ask.test_answers import asked

CORD = """
[parameters]
m = "mass"
L = "length"
a = "length < L/2"
h = "length"
g = "acceleration"
[coordinates]
theta = { start = "0" }
x = { dimension = "length", start = "0" }
y = { dimension = "length", start = "-h" }
[points]
C = ["-a", "0"]
[bodies.bar]
shape = "rod"
mass = "m"
length = "L"
center = ["x", "y"]
angle = "theta"
points = { A = ["-a", "0"] }
[interactions.W]
type = "gravity"
[constraints.S]
type = "string"
path = ["C", "bar.A"]
"""
NAMES = ("m", "L", "a", "h", "g")
ASKED = {
    "acceleration of theta at the start": "-12*a*g/(L**2 + 12*a**2)",
    "S at the start": "L**2*g*m/(L**2 + 12*a**2)",
    "y component of acceleration of bar.end at the start": "-6*a*g*(L + 2*a)/(L**2 + 12*a**2)",
}


@pytest.mark.parametrize("question", ASKED)
def test_the_laws_are_solved_at_the_start_where_their_solution_for_every_place_is_long(question: str) -> None:
    [found] = ask(load_text(CORD), question)
    assert found.verdict.is_proved and equal(*(read_infix(text, NAMES) for text in (found.text, ASKED[question]))).is_proved
    assert not found.valid, [to_machine(node) for node in found.valid]
    assert all(len(list(t.walk(step.statement))) < 80 for step in found.steps)


def test_no_speed_is_left_in_the_conditions_of_a_linkage() -> None:
    found = answered(asked("four-bar-linkage"), "instantaneous centre of rocker at the start")
    assert found.verdict.is_proved and not any(name.endswith("_dot") for node in found.valid for name in t.names(node))
