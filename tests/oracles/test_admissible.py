"""What is told to rest, to be lost or to slip can be so, for the cases that once were told and could not be.

Each loss is the first zero along the motion, at twenty seeded sets of numbers: the motion is followed by its own first
integral, step by step, and looked at with plain numbers.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.field.scalar import NOTHING
from rbpsym.mechanics.demands import assuming
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.phases import stages
from rbpsym.mechanics.pushing import begins, check_start
from rbpsym.mechanics.rest import _demands
from rbpsym.mechanics.study import Study
from rbpsym.solve import _demands as told
from rbpsym.solve import solve, text
from rbpsym.statement.loader import load_problem, load_text
from tests.library.derived import NAMES, derived, problem
from tests.oracles.compare import holds
from tests.oracles.sets import drawn

CASES = Path(__file__).parent / "cases"
SETS, STEPS = 20, 400


def case(name: str) -> Study:
    return Study(load_problem(CASES / f"{name}.toml"))


def places(study: Study) -> list[tuple]:
    """(where, stable, under which conditions)"""
    return [(*(text(v, study) for v in e.at.values()), e.stable, *told(e.valid, study)) for e in study.equilibria]


def losses(study: Study) -> list[tuple]:
    return [(x.force, *(text(v, study) for v in x.at.values()), *told(x.valid, study)) for x in study.losses]


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("bead-on-sphere", [("0", False)]),  # at π it would hang below: the contact would have to pull
        ("ball-on-string", [("0", True)]),  # at π the string would have to push
        ("rod-and-pull", [("asin(m*g/(2*k*L))", False, "2*k*L - m*g > 0")]),  # it was "stable where m g - 2 k L > 0"
        ("far-range", [("-pi", False)]),  # only +π was tried
    ],
)
def test_places_of_rest(name, found):
    study = case(name)
    assert places(study) == found and study.rest.complete is True


def test_a_rod_on_a_rough_edge_does_not_rest_where_nothing_pushes_it():
    from rbpsym.mechanics.phases import known_stages

    stages, _ = known_stages(problem("rod-tipping-over-edge"))
    assert not stages[0].study.equilibria


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("loop", [("N", "acos((2*g*R - v_0**2)/(3*g*R))", "5*g*R - v_0**2 > 0", "v_0**2 - 2*g*R > 0")]),
        ("ball-on-string", [("T", "acos((2*g*R - v_0**2)/(3*g*R))", "5*g*R - v_0**2 > 0", "v_0**2 - 2*g*R > 0")]),
        ("string-released-level", []),  # it was said to go slack at its starting point
        (
            "bead-on-sphere",
            [
                ("N", "acos(2/3*cos(theta_0))", "sin(theta_0) > 0", "cos(theta_0) > 0"),
                ("N", "-acos(2/3*cos(theta_0))", "-sin(theta_0) > 0", "cos(theta_0) > 0"),
            ],
        ),
    ],
)
def test_losses_that_come_first(name, found):
    study = case(name)
    assert losses(study) == found and study.ended.complete is True


def test_a_double_root_is_no_loss():
    study = Study(problem("rod-falling-on-rough-floor"))  # N touches zero at cos θ = 1/3 and grows again
    assert study.ended == type(study.ended)()


def test_of_two_losses_the_first_alone_is_told():
    assert [x.force for x in Study(problem("ladder-with-person")).losses] == ["N_w"]


def test_what_is_not_decided_says_so():
    study = Study(problem("sliding-ladder-with-spring"))
    assert not study.losses and study.ended.complete is None
    # N_f = Mg/4 ((3 sin θ - sin θ_0)² + cos² θ_0) + 3kℓ sin θ (2 cos θ - cos θ_0)(cos θ - cos θ_0) stays positive
    assert {x.force for x in study.ended.open_} == {"N_w"}


def test_friction_against_the_motion_is_refused_at_its_place():
    with pytest.raises(StatementError, match="slips the other way") as caught:
        check_start(case("block-against-slip"))
    assert caught.value.place is not None


def test_from_rest_a_ladder_slides_only_if_friction_lets_it():
    study = case("ladder-rough")
    assert "cos(theta_0) - 2*mu*sin(theta_0) > 0" in told(begins(study), study)
    steps = derive(study.problem, simulation=False).steps
    step = next(step for step in steps if step.id == "slides.N_f")
    assert step.certificate.verdict.is_proved and step.obligations
    text = (CASES / "ladder-rough.toml").read_text(encoding="utf-8")
    steep = load_text(text.replace('"number"', '"number > 1"').replace('"theta_0"', '"pi/3"'))
    with pytest.raises(StatementError, match="no values of the parameters"):  # it was driven up the wall
        check_start(Study(steep))


def test_a_place_that_may_not_be_reached_has_its_condition():
    answer = solve(load_problem(CASES / "reaches-maybe.toml"))
    assert answer["phases"][0]["valid_where"] == ["v_0**2 - 2*g*R > 0"]
    assert answer["verdicts"]["simulation"]["max_relative_error"] < 1e-8


def test_the_energy_that_friction_took_is_not_called_nothing():
    answer = solve(problem("ball-slipping-to-rolling"), simulation=False)
    assert answer["phases"][0]["energy_lost"] is None and answer["phases"][0]["energy_taken"] == "M*v_0**2/7"


@pytest.mark.parametrize("name", NAMES)
def test_every_place_of_rest_of_the_library_is_admissible(name):
    """Exactly, and at the sample numbers of those sets at which it is told."""
    study = derived(name).study
    for item in study.equilibria:
        given = assuming(study.assumptions, item.valid)
        assert _demands(study.system, study.dynamics, item.at, given) == ()
        for numbers in [next(drawn(study, seed)) for seed in range(5)]:
            if holds(item.valid, numbers):
                at = {n: number(v, numbers) for n, v in item.at.items()}
                known = {**numbers, **at, **dict.fromkeys(study.system.speeds, 0.0)}
                for element in study.problem.constraints:
                    for force in pushes(element):
                        assert number(study.dynamics.reactions[force], known) > -1e-9, (name, force, at)


LOSING = [("cases", name) for name in ("loop", "ball-on-string", "bead-on-sphere", "string-released-level")]
LOSING += [("library", name) for name in ("ball-off-sphere", "cylinder-off-cylinder", "sliding-ladder", "ladder-with-person")]
LOSING += [("library", "ball-in-a-loop")]


@pytest.mark.parametrize(("kind", "name"), LOSING)
def test_each_loss_is_the_first_zero_along_the_motion(kind, name):
    study = case(name) if kind == "cases" else derived(name).study
    [coordinate] = study.squares
    source, seen = drawn(study, 7), 0
    for _ in range(SETS):
        numbers = next(source)
        if kind == "cases" and name == "bead-on-sphere":
            numbers["theta_0"] = math.copysign(min(abs(numbers["theta_0"]), 1.4), numbers["theta_0"])
        seen += _agrees(study, coordinate, numbers)
    assert seen >= SETS // 2


def _agrees(study: Study, name: str, numbers: dict[str, float]) -> bool:
    """Follows one coordinate from its start until a force vanishes or it turns; whether that is what is told."""
    start = number(study.system.scope.start[name], numbers)
    speed = number(study.system.scope.start.get(f"{name}_dot", NOTHING), numbers)
    known = {**numbers, name: start, f"{name}_dot": speed}
    gain = number(study.dynamics.accelerations[f"{name}_ddot"], known)
    sense = math.copysign(1.0, speed or gain or 1.0)
    forces = {n: study.reactions_along_motion[n] for e in study.problem.constraints for n in pushes(e)}
    told_at = [
        (x.force, number(x.at[name], numbers)) for x in study.losses if x.at and holds(x.valid, numbers)
    ]
    first = None
    for k in range(1, STEPS * 10):
        here = start + sense * 2 * math.pi * k / STEPS / 5
        at = {**numbers, name: here}
        low, high = study.assumptions.range_of(name)
        if (low is not None and here <= number(low, numbers)) or (high is not None and here >= number(high, numbers)):
            break
        if number(study.squares[name], at) <= 0:
            break
        down = [n for n, value in forces.items() if number(value, at) < 0]
        if down:
            first = (down[0], here)
            break
    if first is None:
        assert not told_at
    else:
        assert [force for force, _ in told_at] == [first[0]]
        assert abs(told_at[0][1] - first[1]) <= 2 * math.pi / STEPS / 4
    return True


def test_a_tilted_pair_is_not_passed_over():
    study = case("tilted-pair")
    assert places(study)[0][0] == "0" and study.rest.complete is None
    assert text(study.open_balance.force, study) == "m*g*L/2*sin(theta) - kappa*theta"


@pytest.mark.parametrize("name", ["disk-at-rest", "hinged-on-spring"])
def test_rest_is_derived_and_proved(name):
    verdicts = solve(case(name).problem)["verdicts"]
    assert verdicts["proved"] == verdicts["steps"] and verdicts["simulation"]["max_relative_error"] < 1e-8


def test_what_is_tied_rests_within_its_range_too():
    """The cylinder that climbs an edge does not hang from it below the floor, nor beyond the place where it stands on it."""
    climbing = stages(problem("cylinder-against-step"))[1].study
    assert not climbing.equilibria and climbing.rest.complete is True
