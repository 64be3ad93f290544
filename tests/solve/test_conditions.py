"""The conditions that stand under the formulas of the results on a page stand in the answer for machines too."""

import pytest

from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import Scalar
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.elimination import short
from rbpsym.notation.infix import read_infix
from rbpsym.solve import answer_of, solve
from rbpsym.statement import load_text
from tests.library.derived import NAMES, unsimulated

FALLING = """
[parameters]
m = "mass, nonnegative"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "0"
speed = "0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["0", "-y"]
[interactions.W]
type = "gravity"
"""


def test_a_divisor_that_cancels_is_told():
    found = solve(load_text(FALLING), simulation=False)
    assert found["accelerations"] == {"y": "g"} and found["valid_where"] == ["m != 0"]


def under_results(derivation):
    """The values, with their relations, that are open under the equations of motion, the forces and the first integral."""
    for step in derivation.steps:
        if step.id.startswith("motion.from_") or not step.id.startswith(("motion.", "reaction.", "square.")):
            continue
        for duty in step.certificate.verdict.open_obligations:
            yield derivation.letters.value(duty.relation.items[0]), duty.relation.ops[0]


@pytest.mark.parametrize("name", NAMES)
def test_what_a_page_asks_for_the_answer_asks_for(name):
    found = unsimulated(name)
    told = answer_of(found)
    names = {*found.letters.scalars, *found.study.letters.quantities, *found.study.system.scope.rates, "t"}
    known = [Demand(found.letters.value(read_infix(text.rpartition(" ")[0].rpartition(" ")[0], names)), text.split()[-2])
             for text in (*told["valid_where"], *told["start_valid_where"])]  # fmt: skip
    for value, op in under_results(found):
        assert any(_follows(value, op, one) for one in known), (name, value, op)


def _follows(value: Scalar, op: str, one: Demand) -> bool:
    return any(is_zero(short(value - one.value * way)) for way in ((1, -1) if op == "!=" else (1,)))
