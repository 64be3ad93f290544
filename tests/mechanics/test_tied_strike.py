"""A blow into a phase whose coordinates stay tied by a condition: the same as with the joint that the blow acts through."""

import re

import pytest

from rbpsym.decide.equal import equal
from rbpsym.derive import derive
from rbpsym.expr.infix import read_infix
from rbpsym.field.normal import same
from rbpsym.field.scalar import symbol
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.pushing import begins
from rbpsym.present.forms import present
from rbpsym.statement import load_text
from rbpsym.statement.library import problem_files

NAME = "cylinder-against-step"
EDGE = 'constraints = { E = { type = "rolling", body = "cylinder", circle = "Q", radius = "0" } }'
PLACE = '[points]\nQ = ["sqrt(2*R*h - h**2)", "h"]\n\n[coordinates.x]'


def test_the_edge_of_a_step_is_a_pivot_or_a_corner_over_which_it_rolls() -> None:
    text = problem_files()[NAME].read_text(encoding="utf-8").partition("[[ask]]")[0]
    rolled = re.sub(r"constraints = \{ E = .*", EDGE, text).replace("[coordinates.x]", PLACE)
    [_, held], [_, touching] = (stages(load_text(one)) for one in (text, rolled))
    assert same(held.began.energy_lost, touching.began.energy_lost)
    assert same(touching.began.speeds["x"], held.began.speeds["phi"] * (symbol("R") - symbol("h")))
    asked = begins(touching.study)  # the edge only pushes, which the pivot does not tell
    assert asked and all(isinstance(one, Demand) for one in asked)


BOB = """
title = "A bob falls until its string is taut"
[parameters]
m = "mass"
L = "length: of the string"
h = "length < L: how far beside the end of the string"
g = "acceleration"
[coordinates]
x = { dimension = "length", start = "h", speed = "0" }
y = { dimension = "length", start = "0", speed = "0" }
[bodies.bob]
shape = "particle"
mass = "m"
center = ["x", "-y"]
[interactions.W]
type = "gravity"
[[phases]]
name = "swing"
event = "begins"
of = "S"
constraints = { S = { type = "string", path = ["O", "bob.center"], length = "L" } }
"""


@pytest.mark.parametrize("beside", ["h", "0"])
def test_a_string_that_becomes_taut_takes_the_speed_along_it(beside: str) -> None:
    """Beside its end the bob keeps of √(2 g y₁) what is across the string, below it nothing; it may start at the end."""
    text = BOB if beside == "h" else "\n".join(line for line in BOB.replace('"h"', '"0"').splitlines() if line[:1] != "h")
    derivation = derive(load_text(text), simulation=True)
    assert all(step.certificate.verdict.is_proved for step in derivation.all_steps)
    assert derivation.simulation.max_relative_error < 1e-6
    [_, swing] = stages(load_text(text))
    depth = f"sqrt(L**2 - {beside}**2)"
    expected = read_infix(f"m*g*{depth}*(1 - {beside}**2/L**2)", ["m", "g", "L", "h"])
    assert equal(present(swing.began.energy_lost), expected, swing.study.assumptions).is_proved
