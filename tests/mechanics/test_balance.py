"""Positions of rest that no formula gives: what is said of them without solving."""

from dataclasses import replace
from pathlib import Path

import pytest

from rbpsym.derive import derive
from rbpsym.expr import tree as t
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.study import Study
from rbpsym.proof.rules import certify
from rbpsym.statement.loader import load_problem, load_text

DOOR = (Path(__file__).parents[1] / "proof/systems/trapdoor-with-spring.toml").read_text(encoding="utf-8")


def balance(text: str):
    return Study(load_text(text)).open_balance


def test_one_stable_place_between_the_ends():
    found = balance(DOOR)
    assert (found.name, found.place, found.stable, len(found.ends)) == ("theta", "theta_e", True, 2)


def test_the_frequency_is_that_of_a_motion_close_to_the_place():
    found, numbers = balance(DOOR), {"M": 1.3, "a": 0.7, "kappa": 2.1, "g": 9.8}
    low, high = 0.0, 1.6
    for _ in range(60):
        middle = (low + high) / 2
        inside = number(found.force, {**numbers, "theta": middle}) > 0
        low, high = (middle, high) if inside else (low, middle)
    step, inertia = 1e-5, 1.3 * 0.7**2 / 3
    pull = [number(found.force, {**numbers, "theta": low + side * step}) for side in (-1, 1)]
    assert number(found.frequency_squared, {**numbers, "theta_e": low}) == pytest.approx(
        (pull[0] - pull[1]) / (2 * step) / inertia, rel=1e-8
    )


def test_without_a_range_there_is_at_most_one_place():
    text = DOOR.replace('range = ["0","pi/2"]\n', "").replace("torsion stiffness:", "torsion stiffness > M*g*a:")
    found = balance(text)
    assert (found.stable, found.ends) == (True, ())


def test_nothing_is_said_of_stability_where_the_slope_has_no_sign():
    found = balance(DOOR.replace('range = ["0","pi/2"]\n', ""))
    assert (found.stable, found.frequency_squared) == (None, None)


def test_a_place_in_closed_form_is_no_open_balance():
    slack = DOOR.replace('[interactions.W]\ntype = "gravity"\n', "")
    assert balance(slack) is None
    assert len(Study(load_text(slack)).equilibria) == 1  # the stated start, θ = 0, belongs to the range
    assert not Study(load_text(slack.replace('start = "0"', 'start = "pi/4"'))).equilibria  # other ends do not
    assert len(Study(load_text(slack.replace('["0","pi/2"]', '["-1","pi/2"]'))).equilibria) == 1


def test_a_damped_system_gets_no_frequency():
    damped = load_problem(Path(__file__).parents[1] / "proof/systems/damped-trapdoor.toml")
    found = Study(damped).open_balance
    assert (found.stable, found.frequency_squared) == (True, None)


def test_a_small_motion_about_a_damped_balance_is_told_to_die_out():
    damped = load_problem(Path(__file__).parents[1] / "proof/systems/damped-trapdoor.toml")
    found = derive(damped, simulation=False)
    [step] = [step for step in found.steps if step.rule == "open_linear"]
    assert step.phrase == "oscillations.open.damped" and step.certificate.verdict.is_proved
    left, right = step.statement.items
    undamped = t.Chain((left, right.terms[0]), step.statement.ops)
    assert not certify(found.letters, replace(step, statement=undamped)).verdict.is_proved
