"""Small parts of steps, each by what it states: no row of several is lost, no sign of a side, no word for its opposite."""

import gc
from dataclasses import replace
from types import SimpleNamespace as Told

import pytest

from rbpsym import frozen
from rbpsym.chapters import conditions
from rbpsym.chapters.conditions import _where, as_taken
from rbpsym.chapters.contact import _with_tangent
from rbpsym.chapters.impulses import _positive
from rbpsym.chapters.methods import conservation
from rbpsym.chapters.methods.balances import _crossing
from rbpsym.chapters.methods.known_works import _begins_with_start, since_start
from rbpsym.chapters.momentum import _phrase
from rbpsym.chapters.places import coordinates_of
from rbpsym.decide.assumptions import Assumptions
from rbpsym.derive import derive
from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.expr import tree as t
from rbpsym.field.calculus import function
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import is_zero, same
from rbpsym.field.scalar import NOTHING, PI, UNITY, lift, symbol
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import ORIGIN, cartesian
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.endings import at_start, is_before
from rbpsym.mechanics.roots import _principal
from rbpsym.mechanics.solved import without_logarithms
from rbpsym.proof.checks.places import _holds
from rbpsym.proof.draft import Draft
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.statement.model import PointRef
from tests.library.derived import unsimulated


def rows(name: str, id: str) -> int:
    statement = unsimulated(name).step(id).statement
    return len(statement.rows) if isinstance(statement, t.Relations) else 1


@pytest.mark.parametrize(
    ("name", "id", "number"),
    [
        ("atwood-with-massive-pulley", "free_body.first", 1),
        ("block-on-table", "free_body.block", 2),
        ("atwood-with-massive-pulley", "free_body.pulley", 3),
        ("rod-and-disk-fixed", "condition.N", 2),
    ],
)
def test_a_step_states_all_of_its_rows(name, id, number):
    assert rows(name, id) == number


@pytest.mark.parametrize(
    ("orbital", "spin", "key"),
    [(UNITY, UNITY, "both"), (UNITY, NOTHING, "orbital"), (NOTHING, UNITY, "spin")],
)
def test_which_part_of_the_angular_momentum_there_is(orbital, spin, key):
    assert _phrase(orbital, spin) == f"momentum.{key}"


def test_a_ratio_of_sine_and_cosine_is_a_tangent():
    draft, beta, mu = Draft(unsimulated("ball-on-incline").study), symbol("beta"), symbol("m")
    ratio = sine(beta) / cosine(beta)
    assert _with_tangent(draft, ratio) == t.Fn("tan", t.Sym("beta"))
    assert _with_tangent(draft, mu * ratio) == t.mul(t.Sym("m"), t.Fn("tan", t.Sym("beta")))


def test_two_signs_of_a_speed_go_away():
    e, v = t.Sym("e"), t.Sym("v")
    assert _positive(t.neg(t.Mul((e, t.neg(v))))) == t.mul(e, v)
    assert _positive(t.neg(t.Mul((e, v)))) == t.neg(t.Mul((e, v)))


def test_what_can_only_push_or_only_pull():
    pushing = {kind for kind in CONSTRAINTS if kind != "link" and JOINTS[kind].is_one_sided}
    assert pushing == {"contact", "touch", "rolling", "sticking", "string"}


@pytest.mark.parametrize(("turns", "principal"), [(3, 1), (-1, 1), (-3, 1), (2, 0), (-2, 0), (4, 0)])
def test_angles_are_brought_into_one_turn(turns, principal):
    assert _principal(PI * turns) == PI * principal


def test_a_line_may_be_written_with_either_sign():
    text, line = problem_files()["ball-on-incline"].read_text(encoding="utf-8"), '"y = -x*tan(beta)"'
    assert line in text
    found = derive(load_text(text.replace(line, '"-y = x*tan(beta)"')), simulation=False).summary()
    assert found["proved"] == found["steps"]


@pytest.mark.parametrize("name", ["sliding-ladder", "planet-wheel", "ball-with-backspin"])
def test_a_derivation_makes_no_circle_of_references(name, monkeypatch):
    """What it no longer needs goes at once: the collector, whose rounds take time, finds nothing."""
    monkeypatch.setattr(frozen, "OFTEN", 0)  # a constructor that is written out meanwhile leaves what wrote it
    problem = load_problem(problem_files()[name])
    derive(problem, simulation=False)  # warms the imports
    gc.collect()
    derive(problem, simulation=False)
    assert gc.collect() == 0


CIRCLES = {"ball-off-sphere": 1, "cylinder-in-cylinder": 1, "hoop-on-its-rim": 0, "rod-pendulum": 0, "rod-in-bowl": 0}


@pytest.mark.parametrize(("name", "count"), CIRCLES.items())
def test_a_circle_is_told_of_a_centre_that_does_not_turn_with_its_body(name, count):
    assert sum(step.id.startswith("circle.") for step in unsimulated(name).steps) == count


def test_steps_of_one_name_are_counted_from_two():
    draft, known = Draft(unsimulated("rod-pendulum").study), set()
    for wanted in ("work", "work_2", "work_3", "work_4"):
        assert draft._unique("work", known) == wanted
        known.add(wanted)


LINES = [((1, 2, 3, -1), (4, -3, 1, 2)), ((0, 5, 1, 0), (7, 0, 0, 1)), ((2, 2, 1, 1), (3, 1, -2, 5))]


@pytest.mark.parametrize(("first", "second"), LINES)
def test_lines_of_action_cross_on_both_lines(first, second):
    a, b = (Told(point=cartesian(*map(lift, f[:2])), vector=cartesian(*map(lift, f[2:]))) for f in (first, second))
    place = _crossing(a, b)
    assert all(is_zero((place - force.point).cross(force.vector)) for force in (a, b))
    assert _crossing(a, a) is None


TOLD = [("sliding-ladder", "along.N_w"), ("ball-off-sphere", "along.N"), ("rod-in-bowl", "along.N_1")]


@pytest.mark.parametrize(("name", "id"), TOLD)
def test_a_force_along_the_motion_follows_from_what_was_told_of_it(name, id):
    """From the reaction at a place and a speed, and the square of the speed; not from the laws once more."""
    premises = set(unsimulated(name).step(id).premises)
    assert {id.replace("along", "reaction"), "square.theta"} <= premises
    assert not premises & {"law.motion", "start.theta"}


def test_where_a_point_is_follows_from_the_pose_of_its_body():
    """A plate placed by a corner: x' cos φ - y' sin φ, x' sin φ + y' cos φ."""
    placed = ("corner", (t.Sym("X"), t.Sym("Y")))
    body = Told(placed=placed, angle=t.Sym("phi"), points={"corner": (t.ONE, t.TWO), "P": (t.Num(4), t.Num(7))})
    draft = Told(study=Told(problem=Told(body=lambda name: body)))
    x, y = (scalar(node) for node in coordinates_of(draft, PointRef("plate.P", "plate", "P")))
    phi = symbol("phi")
    assert same(x, symbol("X") + 3 * cosine(phi) - 5 * sine(phi))
    assert same(y, symbol("Y") + 3 * sine(phi) + 5 * cosine(phi))


def test_on_which_side_of_a_circle_it_is_told_to_be():
    for values, key in (({"side": "inside"}, "inside"), ({"side": "outside"}, "outside"), ({}, "body")):
        element = Told(values=values)
        assert _where(element, None, ORIGIN).key == f"kinematics.on.{key}"


def test_a_body_that_keeps_its_stated_angle_is_told_not_to_turn():
    yoke = unsimulated("scotch-yoke").step("turning.yoke")
    assert yoke.statement.items[-1] == t.ZERO


@pytest.mark.parametrize(("name", "told"), [("rod-pendulum", True), ("hoop-on-its-rim", True), ("sliding-ladder", False)])
def test_where_a_body_turns_about_a_point_its_momentum_has_the_moment_about_it(name, told):
    momenta = [step.statement for step in unsimulated(name).steps if step.rule == "angular_momentum"]
    assert momenta and any("I_O" in t.names(node) for node in momenta) == told


@pytest.mark.parametrize(("driven", "reason"), [(True, "driven"), (False, "no_integral")])
def test_why_no_energy_is_conserved(driven, reason, monkeypatch):
    for name in ("_without_potential", "_rough"):
        monkeypatch.setattr(conservation, name, lambda draft: [])
    for name in ("_potentials", "_changes"):
        monkeypatch.setattr(conservation, name, lambda *given: None)
    said = []
    conservation._not_conserved(Told(study=Told(system=Told(has_clock=driven)), skip=lambda name, why: said.append(why)))
    assert said == [f"skipped.{reason}"]


def test_a_centre_of_mass_has_both_coordinates():
    corners = 'shape = "polygon"\nmass = "M"\nvertices = [["0", "0"], ["a", "0"], ["0", "b"]]'
    problem = load_text(f'[parameters]\nM = "mass"\na = "length"\nb = "length"\n[bodies.plate]\n{corners}')
    found = derive(problem, simulation=False).step("center.plate").statement
    assert isinstance(found, t.Relations) and len(found.rows) == 2


def test_a_point_of_a_body_is_a_label_and_a_fixed_one_a_letter():
    steps = {step.id: step for step in unsimulated("spoked-wheel-moments").steps}
    assert steps["moment.wheel.O"].slots["point"] == t.Sym("O")
    assert steps["moment.wheel.wheel.bottom"].slots["point"] == ["wheel.bottom"]


@pytest.mark.parametrize("name", ["ball-on-incline", "block-on-table", "rod-and-disk-fixed", "cylinder-on-wedge"])
def test_brackets_stand_round_sums_alone(name):
    nodes = (node for step in unsimulated(name).steps if step.rule != "work_energy" for node in t.walk(step.statement))
    assert all(isinstance(node.arg, t.Add) for node in nodes if isinstance(node, t.Group))


def test_a_state_comes_with_itself():
    study = unsimulated("rod-hits-ball-at-bottom").study
    state = at_start(study)
    assert is_before(study, state, state) and is_before(study, replace(state, time=None), replace(state, time=None))


def test_logarithms_in_exponents_are_powers():
    x = symbol("x")
    for power in (2, -1, 3):
        assert is_zero(without_logarithms(function("exp", function("ln", x) * power)) - x**power)


def test_a_balance_rests_on_the_laws_of_its_body_and_not_on_the_motion_of_all():
    """The nearest premises are tried first: they are what a reader would name."""
    assert {"law.force.ball", "law.torque.ball"} == {*unsimulated("ball-in-a-loop").step("balance.ball").premises}


@pytest.mark.parametrize("sign", [1, -1])
def test_a_change_is_told_as_what_is_less_what_was(sign):
    draft = Draft(unsimulated("sliding-ladder").study)
    change = (sine(symbol("theta_0")) - sine(symbol("theta"))) * symbol("M") * symbol("g") * symbol("ell") * sign
    shown = since_start(draft, change)
    assert is_zero(draft.context.value(shown) - change) and not _begins_with_start(draft, shown)


@pytest.mark.parametrize(("place", "rests"), [(NOTHING, True), (PI, False)])
def test_nothing_rests_where_its_contact_would_have_to_pull(place, rests):
    """At the highest place of a loop the forces on the ball balance, too."""
    found = unsimulated("ball-in-a-loop")
    step = found.step("equilibrium.1")
    [said] = _holds(found.letters, replace(step, data={**step.data, "at": {"theta": place}}), [])
    assert said.is_proved is rests


def test_where_it_rests_it_touches_on_its_side_and_is_pushed():
    found = unsimulated("half-disk-rocking")
    said = [*_holds(found.letters, found.step("equilibrium.1"), [])]
    assert len(said) == 2 and all(verdict.is_proved for verdict in said)


def test_a_centre_that_keeps_its_distance_is_told_to_go_on_a_circle():
    ids = {step.id for step in unsimulated("sliding-ladder").steps}
    assert "circle.ladder" in ids
    assert not any(id.startswith("circle.") for id in (step.id for step in unsimulated("ladder-in-equilibrium").steps))


@pytest.mark.parametrize(("name", "letters"), [("disk-on-incline", {"mu_min"}), ("cylinder-in-corner", set())])
def test_the_friction_that_is_needed_has_a_name(name, letters):
    found = unsimulated(name)
    assert {s.slots["letter"].name for s in found.steps if s.id.startswith("friction.") and "letter" in s.slots} == letters


@pytest.mark.parametrize(("kept", "begun", "told"), [("", "u", "u"), ("x", "ux", "x"), ("xy", "", "xy"), ("m", "u", "")])
def test_a_side_is_asked_for_in_each_position_or_else_at_the_start(kept, begun, told, monkeypatch):
    for name, values in (("ways_kept", kept), ("ways_taken", begun)):
        pairs = [("other", symbol("v")), *(("own", symbol(value)) for value in values)]
        monkeypatch.setattr(conditions, name, lambda study, pairs=pairs: pairs)
    study = Told(assumptions=Assumptions({"m": "positive"}))
    asked = as_taken(Told(study=study, show=lambda value: value), "own")
    assert [relation.items[0] for relation in asked] == [symbol(name) for name in told]


@pytest.mark.parametrize(("name", "variant"), [("cylinder-on-wedge", "whole"), ("ball-on-rod-against-cube", "one")])
def test_the_forces_on_several_bodies_are_told_as_those_on_the_whole(name, variant):
    pushes = [step for step in unsimulated(name).steps if step.id.startswith("push.")]
    assert pushes and all(step.slots["variant"] == variant for step in pushes)
