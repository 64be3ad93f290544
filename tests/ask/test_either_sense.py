"""Where the sense of a slip depends on what is asked for, the motions with either sense are looked at."""

import pytest

from rbpsym.ask.asking import ask
from rbpsym.statement.loader import load_text
from rbpsym.typeset.text import to_text
from tests.ask.test_tipping import ROLLING
from tests.ask.test_unseen import HERE

THROWN = """
[parameters]
m = "mass: block"
v = "speed: forward"
u = "speed: backward"
mu = "number: friction"
g = "acceleration: gravity"
[coordinates.x]
dimension = "length"
start = "0"
speed = "v - u"
[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "block.center"
line = "y = 0"
coefficient = "mu"
"""
PULLED = """
[parameters]
m = "mass: block"
k = "stiffness: spring"
F = "force: pull"
x_0 = "length: first"
[coordinates.x]
dimension = "length"
start = "x_0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.P]
type = "force"
on = "block.center"
force = ["F - k*x", "0"]
"""
ASKED = (
    (PULLED, "F for which x where x comes to rest = 2*x_0", ("3kx₀/2",), "="),
    (PULLED, "F for which x where x comes to rest = x_0/2", ("3kx₀/4",), "="),
    (PULLED, "F for which x where x comes to rest >= 2*x_0", ("3kx₀/2",), ">="),
    (ROLLING, "w_0 for which speed of x when rolling begins = 2*v_0", ("9v₀/(2R)",), "="),
    (ROLLING, "w_0 for which speed of x when rolling begins >= 2*v_0", ("9v₀/(2R)",), ">="),
    (ROLLING, "w_0 for which energy lost until rolling = m*v_0**2", ("v₀(1 + √7)/R",), "="),
    (ROLLING, "w_0 for which energy lost until rolling = m*v_0**2/100",
     ("v₀(10 − √7)/(10R)", "v₀(10 + √7)/(10R)"), "="),
    (ROLLING, "w_0 for which speed of x when rolling begins = v_0/7", (), "="),
    (THROWN, "v for which time until x comes to rest = u/g", ("u(1 − μ)", "u(1 + μ)"), "="),
    (THROWN, "largest v for which time until x comes to rest <= u/g", ("u(1 + μ)",), "="),
    (THROWN, "smallest v for which time until x comes to rest <= u/g", ("u(1 − μ)",), "="),
    (THROWN, "v for which x where x comes to rest = u**2/g", ("u(1 + √(2μ))",), "="),
)  # fmt: skip


@pytest.mark.parametrize(("text", "question", "values", "relation"), ASKED, ids=lambda value: str(value)[-30:])
def test_the_other_sense_of_the_slip_is_looked_at(text: str, question: str, values: tuple[str, ...], relation: str) -> None:
    [found] = ask(load_text(text), question)
    assert found.verdict.is_proved and found.relation == relation
    assert tuple(to_text(node) for node in found.nodes) == values and not found.valid[len(values) :]
    assert values or found.says.startswith("there is no such")


def test_of_a_range_in_both_motions_only_one_is_told_and_nothing_is_proved() -> None:
    [found] = ask(load_text(THROWN), "v for which time until x comes to rest <= u/g")
    assert not found.verdict.is_proved and not found.verdict.is_refuted and "other sense" in found.verdict.reason


def test_a_motion_that_sets_out_the_other_way_is_not_denied() -> None:
    [found] = ask(load_text((HERE / "puck-and-weight.toml").read_text()), "v_0 for which r where r comes to rest = 2*r_0")
    assert [to_text(node) for node in found.nodes] == ["2 √(2Mgr₀/(3m))"] and not found.verdict.is_refuted


def test_what_holds_at_the_bound_that_is_asked_for_is_not_denied_of_the_other() -> None:
    [found] = ask(load_text(THROWN), "smallest v for which time until x comes to rest <= u/g")
    assert not found.says
