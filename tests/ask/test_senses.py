"""What is the same in whichever sense the motion sets out is told without a condition on the sense."""

import math

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered, ask
from rbpsym.ask.numbers import read_numbers
from rbpsym.ask.telling import record
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.numbers import number, samples
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.machine import to_machine
from tests.ask.test_unseen import HERE

EVEN = (  # of a rod of 1 m and 1 kg, let go at theta_0
    ("speed of rod.end where theta = 0", lambda a: math.sqrt(3 * 9.81 * (1 - math.cos(a)))),
    ("F_y where theta = 0", lambda a: 9.81 * (5 - 3 * math.cos(a)) / 2),
    ("kinetic energy of rod where theta = 0", lambda a: 9.81 * (1 - math.cos(a)) / 2),
)


@pytest.mark.parametrize(("question", "value"), EVEN, ids=[question for question, _ in EVEN])
@pytest.mark.parametrize("degrees", [-100, -60, 60])
def test_a_value_that_is_even_in_the_start_holds_on_both_sides_of_it(question: str, value, degrees: int) -> None:
    problem = load_problem("rod-pendulum")
    found = answered(Asked(problem), question)
    assert found.verdict.is_proved and [to_machine(node) for node in found.valid] in ([], ["sin(theta_0) != 0"])
    numbers = read_numbers(f"M = 1 kg, ell = 1 m, g = 9.81 m/s^2, theta_0 = {degrees} deg", problem)
    assert record(found, numbers)["value"] == pytest.approx(value(math.radians(degrees)), rel=1e-3)


ODD = ("angular velocity of rod where theta = 0", "x component of velocity of rod.cm where theta = 0")


@pytest.mark.parametrize("question", ODD)
def test_a_value_that_is_odd_in_the_speed_keeps_the_sense(question: str) -> None:
    [found] = ask(load_problem("rod-pendulum"), question)
    assert [to_machine(node) for node in found.valid] == ["sin(theta_0) > 0"]


PLACE = """
[parameters]
m = "mass: block"
k = "stiffness: spring"
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
force = ["-k*x", "0"]
"""


def test_a_sense_that_a_length_of_either_sign_tells_is_left_out_too() -> None:
    [found] = ask(load_text(PLACE), "kinetic energy of block where x = 0")
    assert found.text == "k*x_0**2/2" and [to_machine(node) for node in found.valid] == ["x_0 != 0"]


def test_a_phase_goes_as_it_begins() -> None:
    """Back from the spring it goes where it does not stay: the sense is that of the motion as it is stated."""
    problem = load_text((HERE / "block-against-spring.toml").read_text(encoding="utf-8"))
    [found] = ask(problem, "x where x comes to rest in phase back")
    assert to_machine(found.nodes[0]) == "(3*mu*m*g - sqrt(m*(mu**2*m*g**2 + k*v_0**2)))/k"
    conditions = [scalar(node.items[0]) for node in found.valid]
    assert any(all(number(value, numbers) > 0 for value in conditions) for numbers in samples(found.study.problem))


BULLET = (  # m v²/2 before, M m v²/(2 (M + 2 m)) lost
    ("m for which energy lost = kinetic energy at the start/2", ["M/2"]),
    ("m for which energy lost = kinetic energy just before stuck/2", ["M/2"]),
    ("m for which kinetic energy when stuck begins = kinetic energy at the start/2", ["M/2"]),
    ("m for which energy lost = kinetic energy at the start", []),
)


@pytest.mark.parametrize(("question", "answer"), BULLET)
def test_a_moment_behind_a_quantity_is_its_own(question: str, answer: list[str]) -> None:
    [found] = ask(load_text((HERE / "bullet-in-rim.toml").read_text(encoding="utf-8")), question)
    assert [to_machine(node) for node in found.nodes] == answer
