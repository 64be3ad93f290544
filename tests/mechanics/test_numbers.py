"""Sample numbers keep what is declared; lines have unit normals; a motion goes ahead in its sense."""

import math
import random
from fractions import Fraction

import pytest

from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import PI, lift, symbol
from rbpsym.mechanics.events import Way
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import components
from rbpsym.mechanics.numbers import NoNumber, number, sample, samples
from rbpsym.mechanics.pushing import begun_numbers
from rbpsym.mechanics.rest import turns_within
from rbpsym.mechanics.roots import zeros
from rbpsym.mechanics.study import Study
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Line
from tests.library.derived import NAMES, problem


def bounds(quantity, at):
    for node in (quantity.lower, quantity.upper):
        try:
            yield None if node is None else number(scalar(node), at)
        except NoNumber:
            yield None


@pytest.mark.parametrize("name", NAMES)
def test_sample_numbers_keep_what_is_declared(name):
    stated = problem(name)
    for at in samples(stated, 5):
        for quantity in (*stated.parameters, *stated.coordinates):
            low, high = bounds(quantity, at)
            assert low is None or at[quantity.name] > low - 1e-12, quantity
            assert high is None or at[quantity.name] < high + 1e-12, quantity
        assert all(at[q.name] > 0 for q in stated.parameters if q.sign == "positive")
        for coordinate in stated.coordinates:
            begin = getattr(coordinate.start, "name", None)
            if begin in stated.implicit:
                low, high = bounds(coordinate, at)
                assert (low is None or at[begin] > low) and (high is None or at[begin] < high), begin
    assert sample(stated) == next(samples(stated))
    others = list(samples(stated, 4))
    assert not stated.parameters or all(one != other for one, other in zip(others, others[1:], strict=False))


@pytest.mark.parametrize("seed", range(4))
def test_a_line_has_a_unit_normal_and_its_distances(seed):
    source = random.Random(seed)
    a, b, c = (source.randint(1, 9) * source.choice((-1, 1)) for _ in range(3))
    x, y, z = (number(part, {}) for part in components(Line("", t.Num(a), t.Num(b), t.Num(c))))
    assert math.isclose(math.hypot(x, y), 1.0)
    assert math.isclose(x * b, y * a) and math.isclose(x * c, z * a)


def test_a_slope_has_its_angle():
    beta = t.Sym("beta")
    x, y, z = components(Line("", t.Fn("tan", beta), t.ONE, t.ZERO))
    assert [number(part, {"beta": 0.3}) for part in (x, y, z)] == pytest.approx([math.sin(0.3), math.cos(0.3), 0])


@pytest.mark.parametrize("sense", [1, -1])
def test_what_lies_ahead(sense):
    start, place = symbol("a"), symbol("b")
    way = Way("x", start, sense, lift(1))
    assert way.ahead(start + sense * place) == place
    known = way.until(place, NONE).range_of("x")
    assert known == ((start, place) if sense > 0 else (place, start))


WAVES = (
    "a*sin(theta) + b", "a*cos(theta) + b", "a*cos(2*theta + c) - b", "sin(theta)", "cos(3*theta)",
    "a*sin(theta/2) - b*cos(theta/2)",
)  # fmt: skip


@pytest.mark.parametrize("text", WAVES)
def test_zeros_of_waves_are_two_and_zeros(text):
    value, at = scalar(read_infix(text, ("a", "b", "c", "theta"))), {"a": 2.0, "b": 1.1, "c": 0.4}
    found = [number(place, at) for place in zeros(value, "theta")]
    assert len({round(place, 9) for place in found}) == 2
    for place in found:
        assert abs(number(value, {**at, "theta": place})) < 1e-12


PENDULUM = """
[parameters]
m = "mass"
ell = "length"
g = "acceleration"
mu = "number"
[coordinates.theta]
meaning = "angle"
start = "theta_0"
[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
angle = "theta - pi/2"
[interactions.W]
type = "gravity"
[constraints.A]
type = "pivot"
point = "rod.start"
at = "O"
"""


@pytest.mark.parametrize(
    ("name", "text", "value"),
    [("ell", "25 cm", 0.25), ("ell", "3", 3.0), ("mu", "0.3", 0.3), ("theta_0", "60 deg", math.pi / 3), ("m", "2 kg", 2.0)],
)
def test_the_authors_own_numbers_are_read_with_their_units(name, text, value):
    assert math.isclose(sample(load_text(PENDULUM), {name: text})[name], value)


@pytest.mark.parametrize(("example", "side"), [("", 1), ("20 deg", 1), ("-20 deg", -1)])
def test_an_example_says_on_which_side_it_starts(example, side):
    own = f'[example]\ntheta_0 = "{example}"\n' if example else ""
    assert sample(load_text(PENDULUM + own))["theta_0"] * side > 0


def test_other_samples_have_other_sizes_both_ways():
    first, *others = samples(load_text(PENDULUM))
    for name in ("m", "ell", "g", "mu"):
        sizes = [at[name] / first[name] for at in others]
        assert 1 / 50 <= min(sizes) < 1 / 5 and 5 < max(sizes) <= 50, name


def test_the_sign_of_a_value_at_the_sample_numbers():
    seen = geometry_of(Study(load_text(PENDULUM)).system).sign
    assert [seen(value) for value in (symbol("ell"), -symbol("ell"), symbol("m") - symbol("m"))] == [1, -1, 0]
    assert seen(symbol("of no problem")) == 0


TURNS = [(None, None), (0, None), (None, 1), (0, 1), (-2, 3), (Fraction(1, 2), 4)]


@pytest.mark.parametrize(("low", "high"), TURNS)
@pytest.mark.parametrize("period", [1, 2, Fraction(2, 3), 4])
@pytest.mark.parametrize("root", [0, Fraction(1, 4), -1])
def test_a_zero_stands_for_all_its_turns_within_the_range(low, high, period, root):
    """All in units of π; without bounds a range is one turn, or one period where that is longer."""
    ends = tuple(None if end is None else PI * end for end in (low, high))
    given = Assumptions({}, {} if ends == (None, None) else {"x": ends})
    found = [number(place, {}) / math.pi for place in turns_within(given, "x", PI * root, PI * period)]
    turn = max(2, period)
    if low is None and high is None:
        low, high = -turn / 2, turn / 2
    low, high = (high - turn if low is None else low), (low + turn if high is None else high)
    wanted = [float(root + period * k) for k in range(-20, 21) if low < root + period * k < high]
    assert [place for place in found if low + 1e-9 < place < high - 1e-9] == pytest.approx(wanted)
    assert len(found) <= len(wanted) + 1


FALLING = """
[parameters]
m = "mass"
R = "length"
g = "acceleration"
[coordinates.theta]
start = "theta_0"
range = ["0", "pi/2"]
[bodies.block]
shape  = "particle"
mass   = "m"
center = ["R*{0}(theta)", "R*{1}(theta)"]
[interactions.W]
type = "gravity"
[constraints.N]
type   = "contact"
point  = "block.center"
circle = "O"
radius = "R"
side   = "outside"
"""


@pytest.mark.parametrize(("x", "y", "is_near_zero"), [("sin", "cos", True), ("cos", "sin", False)])
def test_pictures_begin_where_the_motion_goes_far(x: str, y: str, is_near_zero: bool) -> None:
    """On top of a dome, whether the angle is counted from the vertical or from the level."""
    numbers = begun_numbers(Study(load_text(FALLING.format(x, y))), far=True)
    assert (numbers["theta_0"] < math.pi / 4) is is_near_zero
