"""What is said of results: the right things of the paper's problems, and nothing false of any."""

from __future__ import annotations

import re
from functools import cache

import pytest

from rbpsym.ask.asking import ask
from rbpsym.decide.bounds import of_symbol
from rbpsym.decide.samples import chosen, samples_of
from rbpsym.decide.verdict import proved, undecided
from rbpsym.derive import derive
from rbpsym.document.model import Math
from rbpsym.document.notes import words_of
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.field.calculus import names_in
from rbpsym.field.evaluate import scalar
from rbpsym.pictures.plots.following import at
from rbpsym.remarks.choosing import KINDS, Made, guarded, monotone, remarks, results
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.text import to_text


@cache
def derived(name):
    return derive(load_problem(problem_files()[name]), simulation=False)


def said(name, detail="standard", language="en"):
    found = derived(name)
    speech = words_of(found, frozenset(), language)
    rows = remarks(found, detail)[0]
    return {id: [plain(speech.say(step.phrase, **step.slots)) for step in steps] for id, steps in rows.items()}


def plain(inlines):
    return "".join(to_text(one.node) if isinstance(one, Math) else one.text for one in inlines)


def test_what_drops_out_is_told_with_its_pair():
    begins = "τ does not enter: it and its opposite act on the disk and the rod"
    assert said("rod-and-disk-fixed")["motion.theta"][0].startswith(begins)
    assert said("rod-and-disk-free")["motion.theta"][1] == "θ̈ is independent of R."
    assert "the translational and the rotational work of each cancel" in said("sliding-ladder")["motion.theta"][0]
    assert "it does no work" in said("bead-on-parabola")["motion.x"][0], "a particle has no rotational work"


def test_dimensions_tell_why():
    ladder = said("sliding-ladder")
    assert ladder["motion.theta"][1].startswith("θ̈ is independent of M: nothing else")
    assert ladder["loss.N_w"] == ["sin θ is a pure number, and none can be made from M, ℓ and g: it is independent of them."]


def test_no_square_becomes_negative():
    """Without its spring a damped mass has no frequency, whose square would be -c²/4m²."""
    text = """
parameters = { m = "mass", k = "stiffness", c = "damping", L = "length" }
coordinates.x = { dimension = "length", start = "x_0" }
bodies.block = { shape = "particle", mass = "m", center = ["x", "0"] }
interactions.S = { type = "spring", between = [["-L", "0"], "block.center"], stiffness = "k", natural_length = "L" }
interactions.D = { type = "damper", between = [["-L", "0"], "block.center"], coefficient = "c" }
constraints.N = { type = "guide", point = "block.center", line = "y = 0" }
"""
    found = derive(load_text(text, "block"), simulation=False)
    told = [step for steps in remarks(found, "full")[0].values() for step in steps]
    assert told
    squares = [step for step in told if isinstance(step.slots.get("quantity"), t.Pow) and step.phrase == "remark.without"]
    assert all(not t.is_negative(step.slots["value"]) for step in squares)


def test_what_would_be_without_an_interaction():
    assert "Without Fₛ, when k tends to zero, θ̈ becomes −(3g/(4ℓ)) cos θ." in said("sliding-ladder-with-spring")["motion.theta"]


def test_what_would_be_without_sliding_friction():
    assert "Without f, when μ tends to zero, s̈ becomes −g sin β." in said("block-up-and-down-incline")["motion.s"]


def test_a_size_is_taken_before_a_mass():
    assert any(one.startswith("When R tends to zero") for one in said("rod-and-disk-fixed")["motion.theta"])


def test_a_force_by_which_friction_goes_is_needed():
    assert not any("does not enter" in one for told in said("bowling-with-overspin", "full").values() for one in told)


def test_a_value_of_a_parameter_is_not_said_to_be_independent_of_it():
    assert not any("independent of c" in one for told in said("rod-with-damper", "full").values() for one in told)


FALLS = """
title = "A rod that falls with a speed"
[parameters]
M = "mass: rod"
ell = "length: its length"
omega_0 = "angular speed: at first"
g = "acceleration: gravity"
[coordinates.phi]
meaning = "angle from the vertical"
start = "0"
speed = "omega_0"
range = ["0", "pi"]
[bodies.rod]
shape = "rod"
mass = "M"
length = "ell"
start = "O"
angle = "pi/2 - phi"
[interactions.W]
type = "gravity"
[constraints.F]
type = "pivot"
point = "rod.start"
"""


def test_a_speed_that_is_given_grows_with_nothing_at_the_start():
    made = {result.step.id: [*monotone(result)] for result in results(derive(load_text(FALLS)))}
    assert {node.name for one in made["square.phi"] for node in (*one.slots["grow"], *one.slots["fall"])} <= {"omega_0"}
    assert not made["motion.phi"]  # it is proportional to g, as everyone sees


def test_full_notes_say_all_and_shorter_ones_what_matters_most():
    assert all(len(told) <= 2 for told in said("rod-and-disk-fixed", "brief").values())
    numbers = [sum(map(len, said("rod-and-disk-fixed", detail).values())) for detail in ("standard", "full")]
    assert numbers[0] < numbers[1]
    assert all(len(told) <= 3 for told in said("rod-and-disk-fixed").values())


@pytest.mark.parametrize(("verdict", "phrase"), [(proved("x"), "remark.free_of"), (undecided("x"), "")])
def test_only_what_is_proved_is_said(verdict, phrase):
    assert Made("remark.free_of", {}, verdict, ()).said().phrase == phrase


# and those that declare a bound by another letter
BY_OTHERS = re.compile(r'^\w+ *= *"[a-z ]+ <=? *[^:]*/', re.M)
BOUND = {name for name, path in problem_files().items() if BY_OTHERS.search(path.read_text(encoding="utf-8"))}
NAMES = [name for k, name in enumerate(sorted(problem_files())) if k % 12 == 5 or name in BOUND]
POINTS = 4


@pytest.mark.parametrize("name", NAMES)
def test_numbers_agree_with_what_is_said(name):
    for result in results(derived(name)):
        for made in (made for kind in KINDS for made in guarded(kind, result)):
            is_seen = SEEN.get(made.key, lambda *_: True)
            assert not made.verdict.is_proved or is_seen(result, made), (made.key, to_text(result.name))


def numbers(result, **changed):
    """Numbers of all letters that agree with what is declared, at some points."""
    samples = samples_of(result.given)
    for k in range(min(POINTS, len(samples.points))):
        yield {name: chosen(samples, name, k) for name in names_in(result.value)} | changed


def _is_free(result, made):
    for node in made.slots["names"]:
        one, other = ([at(result.value, place) for place in numbers(result, **{node.name: size})] for size in (0.4, 0.9))
        if one != pytest.approx(other, nan_ok=True):
            return False
    return True


def _goes_so(result, made):
    for node, sense in [(node, way) for key, way in (("grow", 1), ("fall", -1)) for node in made.slots[key]]:
        for place in numbers(result):
            before, after = (abs(at(result.value, {**place, node.name: place[node.name] * share})) for share in (1, 1.0001))
            if sense * (after - before) < -1e-12:
                return False
    return True


def _tends_so(result, made):
    name = made.slots["name"].name
    for place in numbers(result, **{name: 1e-9}):
        there, near = at(scalar(made.slots["value"]), place), at(result.value, place)
        if near != pytest.approx(there, rel=1e-3, abs=1e-6, nan_ok=True) or not _has_room(result, name, place):
            return False
    return True


def _has_room(result, name, place):
    """Is there a value in its declared range for each other letter?"""
    bounds = (of_symbol(other, result.given) for other in names_in(result.value) - {name})
    widths = [one.upper - one.lower for one in bounds if None not in (one.lower, one.upper)]
    return all(at(width, {**place, name: 1e-9}) > 1e-6 for width in widths if names_in(width) <= place.keys())


SEEN = {
    **dict.fromkeys(("remark.free_of", "remark.only_mass", "remark.no_number"), _is_free),
    **dict.fromkeys(("remark.grows", "remark.falls", "remark.both"), _goes_so),
    **dict.fromkeys(("remark.small", "remark.much", "remark.without"), _tends_so),
}


def test_what_goes_with_others_is_not_left_out_alone() -> None:
    """Both frictions have the coefficient μ: "without f_A" says that f_B is still there."""
    told = " ".join(sentence for row in said("block-sliding-or-tipping", "full").values() for sentence in row)
    assert "μ tends to zero" in told and "Without" not in told


def test_no_limit_where_it_is_another_one() -> None:
    """Of (g (2 M + m) + …) sin θ/(2 M + m sin² θ) nothing is told for M → 0: at sin θ = 0 it is 0 and not 1/sin θ."""
    told = [sentence for row in said("bead-in-rolling-hoop", "full").values() for sentence in row]
    assert told and not [sentence for sentence in told if "approaches" in sentence and "sin θ" in sentence.split("/")[-1]]


def test_no_limit_in_which_a_declared_range_leaves_no_value() -> None:
    """Of A = m g (L - b + μ h)/L with μ < b/h nothing is told for b → 0, where μ goes to zero too."""
    told = " ".join(sentence for row in said("braking-car", "full").values() for sentence in row)
    assert "h tends to zero" in told and "b tends to zero" not in told
    for limit in ("b -> 0", "h -> oo", "L -> 0"):
        with pytest.raises(StatementError, match="no value in its declared range"):
            ask(load_problem("braking-car"), f"A in the limit {limit}")


def test_nothing_is_said_of_what_holds_a_place_that_only_an_equation_tells():
    """Where m g (ℓ/2) sin θ_e = k (π/2 - θ_e), θ_e depends on the mass, so neither side is free of it."""
    names = {row.step.id: names_in(row.value) for row in results(derive(load_text(SPRUNG), simulation=False))}
    assert "pi" in names["motion.theta"] and not {"balance", "open_frequency"} & names.keys()


SPRUNG = """
title = "A hinged rod with a torsion spring that is slack where it lies level"
[parameters]
m = "mass"
ell = "length"
g = "acceleration"
k = "torsion stiffness"
[coordinates.theta]
meaning = "angle"
start = "theta_0"
speed = "0"
range = ["-pi/2", "pi/2"]
[bodies.rod]
shape = "rod"
mass = "m"
length = "ell"
start = "O"
angle = "theta - pi/2"
[constraints.F]
type = "pivot"
point = "rod.start"
[interactions]
W = { type = "gravity" }
K = { type = "torsion-spring", between = ["ground", "rod"], stiffness = "k" }
"""


TWO_WEIGHTS = """
title = "Two weights"
[parameters]
m = "mass"
M = "mass > m"
d = "length"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "0"
[coordinates.z]
dimension = "length"
start = "0"
[bodies.heavy]
shape = "particle"
mass = "M"
center = ["d", "y"]
[bodies.light]
shape = "particle"
mass = "m"
center = ["-d", "z"]
[interactions.W]
type = "gravity"
[constraints]
G = { type = "guide", point = "heavy.center", line = "x = d" }
H = { type = "guide", point = "light.center", line = "x = -d" }
T = { type = "string", path = ["heavy.center", { around = ["0", "2*d"], radius = "d", sense = "ccw" }, "light.center"] }
"""


def test_no_limit_is_told_to_which_the_declared_ranges_leave_no_way():
    """With M > m there is no m ≫ M, in a remark or in an answer; the other one there is."""
    problem = load_text(TWO_WEIGHTS)
    result = next(one for one in results(derive(problem, simulation=False)) if one.step.id == "motion.y")
    told = [made.slots["great"].name for kind in KINDS for made in guarded(kind, result) if made.key == "remark.much"]
    assert told == ["M"]
    with pytest.raises(StatementError, match="no value in its declared range"):
        ask(problem, "acceleration of y for m >> M")


def test_no_limit_in_which_the_condition_of_the_motion_fails() -> None:
    """A bucket sinks against a friction couple C as long as m g R > C, which no m -> 0 leaves (it was told to rise then)."""
    found = derive(load_text(WINDLASS, "windlass"), simulation=False)
    steps = (step for rows in remarks(found, "full")[0].values() for step in rows if "name" in step.slots)
    told = [(step.phrase, step.slots["name"].name) for step in steps]
    assert ("remark.much", "M") in told and ("remark.much", "m") not in told


WINDLASS = """
parameters = { m = "mass", M = "mass", R = "length", C = "torque", h = "length", g = "acceleration" }
coordinates.y = { dimension = "length", start = "h" }
coordinates.phi = {}
bodies.drum = { shape = "disk", mass = "M", radius = "R", center = "O", angle = "phi" }
bodies.bucket = { shape = "particle", mass = "m", center = ["-R", "y - 2*h"] }
interactions.W = { type = "gravity" }
interactions.C_b = { type = "resisting-couple", between = ["ground", "drum"], size = "C", sense = "ccw" }
constraints.F = { type = "pivot", point = "drum.center" }
constraints.T = { type = "string", path = ["ccw drum", "bucket.center"] }
"""
