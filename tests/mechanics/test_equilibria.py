"""Where the forces balance: every factor counts, and a coordinate may stay arbitrary."""

from itertools import permutations

import pytest

from rbpsym.field.calculus import depends_on, substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero, same
from rbpsym.field.scalar import NOTHING, symbol
from rbpsym.field.trig import sine
from rbpsym.mechanics.rest import resting_forces, unfit
from rbpsym.mechanics.roots import common_zeros
from rbpsym.mechanics.study import Study
from rbpsym.statement import load_text
from tests.library.derived import FOLLOWED, problem

K, L, R, W, X, Y, Z = (symbol(name) for name in ("k", "l", "r", "w", "x", "y", "z"))


def test_a_product_vanishes_with_each_of_its_factors():
    """r sin θ = 0 was once solved by r = 0 alone, and the elastic pendulum had no place of rest."""
    found = common_zeros([R * sine(symbol("theta")), K * (R - L) - W], ("r", "theta")).found
    assert any(is_zero(at["theta"]) and same(at["r"], L + W / K) for at in found)


def test_what_floats_freely_may_rest_anywhere():
    [at] = common_zeros([K * (Y - X - L), K * (X - 2 * Y + Z), K * (Z - Y - L)], ("x", "y", "z")).found
    [free] = {"x", "y", "z"} - at.keys()
    assert free == "z" and same(at["x"], Z - 2 * L) and same(at["y"], Z - L)


def start_at_rest(study):
    """The stated start, if it is one without speed at which nothing accelerates; None if not."""
    system, start, gains = study.system, study.system.scope.start, study.dynamics.accelerations
    forces = resting_forces(system, study.dynamics)
    names = [name for name in system.independent if any(depends_on(force, name) for force in forces)]
    moving = any(not is_zero(start.get(speed, NOTHING)) for speed in system.speeds)
    if gains is None or moving or not names or not set(names) <= start.keys() or unfit(system, study.dynamics):
        return None
    there = {**dict.fromkeys(system.speeds, NOTHING), **start}
    driven = any(not is_zero(substitute(value, there)) for value in gains.values())
    return None if driven else {name: start[name] for name in names}


def test_a_stated_start_that_rests_is_a_place_of_rest_be_it_an_end_of_its_range():
    seen = set()
    for name in FOLLOWED:
        study = Study(problem(name))
        at = start_at_rest(study)
        if at is not None:
            seen.add(name)
            places = [place for place, _ in study.rest.places]
            assert any(all(is_zero(place[n] - at[n]) for n in at.keys() & place.keys()) for place in places), name
    assert {"ball-off-sphere", "cylinder-off-cylinder", "falling-stick", "rod-falling-on-rough-floor"} <= seen


HUNG = """
[parameters]
m = "mass"
k = "stiffness"
L = "length"
g = "acceleration"
[coordinates.r]
dimension = "length"
[coordinates.theta]
meaning = "angle"
[bodies.b]
shape = "particle"
mass = "m"
center = ["r*sin(theta)", "-r*cos(theta)"]
[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "b.center"]
stiffness = "k"
natural_length = "L"
"""


def test_a_spring_has_no_negative_length_where_something_rests():
    """Upright on the spring there is a place of rest only where k L > m g: else r would be negative."""
    hanging, upright = Study(load_text(HUNG)).equilibria
    assert hanging.valid == () and hanging.stable
    [demand] = upright.valid
    assert demand.op == ">" and is_zero(demand.value - (K * symbol("L") - symbol("m") * symbol("g"))) and upright.stable is False


FREE = """
[parameters]
m = "mass"
k = "stiffness"
b = "length"
[coordinates.x]
dimension = "length"
start = "0"
[coordinates.y]
dimension = "length"
start = "b"
[bodies.left]
shape = "particle"
mass = "m"
center = ["x", "0"]
[bodies.right]
shape = "particle"
mass = "m"
center = ["y", "0"]
[interactions.S]
type = "spring"
between = ["left.center", "right.center"]
stiffness = "k"
natural_length = "b"
"""


def test_a_stated_place_of_a_family_is_not_listed_again():
    [(place, _)] = Study(load_text(FREE)).rest.places
    assert len(place) == 1


@pytest.mark.parametrize("name", FOLLOWED)
def test_no_place_belongs_to_another_and_none_is_where_the_first_phase_ends(name):
    study = Study(problem(name))
    places = [place for place, _ in study.rest.places]
    for one, other in permutations(places, 2):
        if other.keys() <= one.keys():
            assert not all(is_zero(one[n] - substitute(other[n], one)) for n in other)
    for phase in study.problem.phases[:1]:
        if phase.event == "reaches":
            assert not any(is_zero(at[phase.subject] - scalar(phase.value)) for at in places if phase.subject in at)
