"""A blow into a phase whose coordinates stay tied by a condition: the same as with the joint that the blow acts through."""

import re

from rbpsym.algebra.normal import same
from rbpsym.algebra.scalar import symbol
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.pushing import start_valid
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
    asked = start_valid(touching.study)  # the edge only pushes, which the pivot does not tell
    assert asked and all(isinstance(one, Demand) for one in asked)
