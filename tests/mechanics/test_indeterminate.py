"""Statements that do not determine a motion, or contradict themselves: a sentence that names the culprits."""

import pytest

from rbpsym.errors import RbpsymError, StatementError
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_problem

ROD = """
[parameters]
M = "mass: mass"
L = "length: length"
g = "acceleration: gravity"

[coordinates.theta]
meaning = "angle"

[bodies.rod]
shape = "rod"
mass = "M"
length = "L"
start = "O"
angle = "theta - pi/2"

[interactions.W]
type = "gravity"

[constraints.F]
type = "pivot"
point = "rod.start"
"""
BOB = '\n[bodies.bob]\nshape = "particle"\nmass = "M"\n'
DISK = (
    '\n[bodies.disk]\nshape = "disk"\nmass = "M"\nradius = "L"\nangle = "theta"\n'
    'center = ["L*sin(theta)", "-L*cos(theta)"]\n'
)


def constraint(name: str, **keys: str) -> str:
    """A section of a constraint."""
    lines = [f"{key} = {value}" for key, value in keys.items()]
    return "\n".join([f"\n[constraints.{name}]", *lines, ""])


ROWS = {
    "two pivots at one point": (ROD + constraint("G", type='"pivot"', point='"rod.start"'), ("F_x", "G_x")),
    "welded twice": (
        ROD
        + DISK
        + constraint("N", type='"weld"', points='["rod.end", "disk.center"]')
        + constraint("P", type='"weld"', points='["rod.end", "disk.center"]'),
        ("N_x", "P_x", "tau_N", "tau_P"),
    ),
    "weld and pin": (
        ROD
        + DISK
        + constraint("N", type='"weld"', points='["rod.end", "disk.center"]')
        + constraint("P", type='"pin"', points='["rod.end", "disk.center"]'),
        ("N_x", "P_x"),
    ),
    "pivot and wall at one point": (
        ROD + constraint("A", type='"contact"', point='"rod.start"', line='"x = 0"'),
        ("F_x", "A"),
    ),
    "pivot at a point that moves": (ROD + constraint("G", type='"pivot"', point='"rod.end"'), ("“G”", "rod.end")),
    "contact that the pose does not keep": (
        ROD + constraint("A", type='"contact"', point='"rod.end"', line='"y = 0"'),
        ("“A”", "rod.end"),
    ),
    "contact beside the point": (
        ROD + constraint("A", type='"contact"', point='"rod.start"', line='"y = -L"'),
        ("“A”", "rod.start"),
    ),
    "pivot elsewhere": (
        ROD.replace('point = "rod.start"', 'point = "rod.start"\nat = ["L", "0"]'),
        ("“F”", "rod.start"),
    ),
    "pin of points that are apart": (
        ROD + DISK + constraint("N", type='"pin"', points='["rod.center", "disk.center"]'),
        ("“N”", "rod.center"),
    ),
    "weld of bodies that turn against each other": (
        ROD
        + DISK.replace('angle = "theta"', 'angle = "2*theta"')
        + constraint("N", type='"weld"', points='["rod.end", "disk.center"]', angle='"0"'),
        ("“N”",),
    ),
    "coordinate without mass": (
        ROD.replace("[bodies.rod]", '[coordinates.phi]\nmeaning = "idle"\n\n[bodies.rod]').replace(
            "[interactions.W]",
            '[bodies.idle]\nshape = "disk"\nmass = "0"\nradius = "L"\ncenter = "O"\nangle = "phi"\n\n[interactions.W]',
        )
        + constraint("H", type='"pivot"', point='"idle.center"'),
        ("phi",),
    ),
    "body without place": (ROD + BOB, ("“bob”",)),
    "body without angle": (ROD + DISK.replace('angle = "theta"\n', ""), ("“disk”",)),
}


@pytest.mark.parametrize("name", ROWS)
def test_a_sentence_that_names_them(name: str) -> None:
    text, named = ROWS[name]
    with pytest.raises(StatementError) as caught:
        _ = Study(load_problem(text.lstrip() + "\n")).dynamics
    sentence = str(caught.value)
    assert all(word in sentence for word in named), sentence
    assert caught.value.instead


def test_a_coordinate_that_nothing_uses() -> None:
    text = ROD.replace("[bodies.rod]", '[coordinates.phi]\nmeaning = "idle"\n\n[bodies.rod]')
    with pytest.raises(RbpsymError, match="phi"):
        _ = Study(load_problem(text.lstrip() + "\n")).dynamics


def test_two_supports_across_are_no_fault() -> None:
    """A pivot and a pull are: what has as many equations as forces is solved."""
    study = Study(load_problem(ROD.lstrip() + "\n"))
    assert set(study.dynamics.reactions) == {"F_x", "F_y"}
