"""The short answer of `rbpsym solve` names bodies as the notes do: a body called hat puts no hat on its moment."""

from rbpsym.commands.solve import lines
from rbpsym.solve import solve
from rbpsym.statement import load_text

SWING = """
[parameters]
m = "mass"
b = "length"
g = "acceleration"
[coordinates.theta]
[bodies.hat]
shape  = "rod"
mass   = "m"
length = "b"
start  = "O"
angle  = "theta"
[interactions.W]
type = "gravity"
[constraints.F]
type  = "pivot"
point = "hat.start"
"""


def test_a_body_called_hat_is_a_subscript():
    problem = load_text(SWING)
    answer = {**solve(problem, simulation=False)}
    assert "  Iₕₐₜ = mb²/12" in list(lines(answer, problem))
