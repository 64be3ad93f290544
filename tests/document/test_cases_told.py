"""A condition that was told of another case is told again."""

from rbpsym.derive import derive
from rbpsym.document.needless import owed_by
from rbpsym.statement.loader import load_text
from rbpsym.typeset.text import to_text

BEAD = """
title = "Bead on a cylinder"
[parameters]
m = "mass"
R = "length"
v_0 = "speed, real"
g = "acceleration"
[coordinates.theta]
start = "0"
speed = "v_0/R"
range = ["-pi", "pi"]
[bodies.bead]
shape = "particle"
mass = "m"
center = ["R*sin(theta)", "R*cos(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type = "contact"
point = "bead.center"
circle = "O"
radius = "R"
side = "outside"
"""


def test_each_case_has_all_that_it_asks_for() -> None:
    """It comes off on the right where v₀ > 0 and on the left where v₀ < 0, in both cases where it does not so at once."""
    derivation = derive(load_text(BEAD), simulation=False)
    steps = derivation.steps
    owed = owed_by(steps, {step.id for step in steps}, derivation.study.assumptions)
    told = ({to_text(node) for node in nodes} for nodes in owed.values())
    lost = [one for one in told if any("v₀" in text for text in one)]
    assert sorted(map(len, lost)) == [2, 2] and len(set.intersection(*lost)) == 1
