"""The phases of the library followed in numbers: events located, impulses solved; what is wrong is seen."""

from dataclasses import replace
from functools import cache

import pytest

from rbpsym.field.scalar import Scalar
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.phases import Stage, stages
from rbpsym.mechanics.study import Study
from rbpsym.oracles.simulation import Derived, angular_momenta, simulate, simulate_study
from rbpsym.oracles.simulation_phases import followed, simulate_problem
from rbpsym.statement import build as rb
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem
from tests.library.derived import AT_START

LIMIT, SEEN = 1e-8, 1e-4


def _has_phases(text: str) -> bool:
    return any(line.startswith("[[phases]]") for line in text.splitlines())


NAMES = sorted(name for name, file in problem_files().items() if _has_phases(file.read_text(encoding="utf-8")))


@cache
def problem(name: str) -> Problem:
    return load_problem(problem_files()[name])


@cache
def parts(name: str) -> tuple[Stage, ...]:
    return stages(problem(name))


@pytest.mark.parametrize("name", NAMES)
def test_events_and_impulses_agree(name: str) -> None:
    report = simulate_problem(study_of(problem(name)))
    wrong = {key: error for key, error in report.errors.items() if not error <= LIMIT}
    assert not wrong
    assert any(": speed after" in key for key in report.errors)


def _spoilt(stage: Stage) -> dict[str, Stage]:
    """The hand-over with one value wrong at a time."""
    began, found = stage.began, {}

    def wrong(value: Scalar) -> Scalar:
        return value + value / 100

    if began.before.time:
        before = replace(began.before, time=wrong(began.before.time))
        found["time"] = replace(stage, began=replace(began, before=before))
    for name, value in began.speeds.items():
        if value:
            speeds = {**began.speeds, name: wrong(value)}
            found[f"speed of {name}"] = replace(stage, began=replace(began, speeds=speeds))
    for name, value in began.impulses.items():
        if value:
            impulses = {**began.impulses, name: -value}
            found[f"impulse {name}"] = replace(stage, began=replace(began, impulses=impulses))
    if began.energy_lost:
        found["energy"] = replace(stage, began=replace(began, energy_lost=began.energy_lost * 2))
    return found


@pytest.mark.parametrize("name", NAMES)
def test_a_wrong_hand_over_is_seen(name: str) -> None:
    first, second, *_ = parts(name)
    spoilt = _spoilt(second)
    assert spoilt or name in ("brake-drum", *AT_START)
    for what, stage in spoilt.items():
        assert max(followed(problem(name), (first, stage)).values()) > SEEN, what


def test_a_contact_that_is_lost_is_seen_from_a_start_at_rest() -> None:
    """A bead on top of a sphere leaves it in no finite time: it is followed from half-way on."""
    stated = rb.problem(
        "bead",
        parameters={"m": "mass", "R": "length", "g": "acceleration"},
        coordinates={"theta": rb.coordinate(start="0", range=("0", "pi/2")), "r": rb.coordinate(dimension="length")},
        bodies={"bead": rb.particle(mass="m", center=("r*sin(theta)", "r*cos(theta)"))},
        interactions={"W": rb.gravity()},
        constraints={"N": rb.contact("bead.center", circle="O", radius="R", side="outside")},
        phases=[{"name": "flight", "event": "lost", "of": "N", "without": ["N"]}],
    )
    errors = followed(stated, stages(stated))
    assert errors and max(errors.values()) <= LIMIT


@pytest.mark.parametrize("name", ["sliding-ladder", "ball-off-sphere", "loaded-wheel"])
def test_angular_momentum_is_followed(name: str) -> None:
    study = Study(problem(name))
    report = simulate_study(study)
    assert report.momentum_drift <= LIMIT
    assert report.gap <= LIMIT
    doubled = {key: (origin, value * 2) for key, (origin, value) in angular_momenta(study).items()}
    assert simulate(Derived(study.system, study.dynamics, momenta=doubled)).momentum_drift > SEEN
