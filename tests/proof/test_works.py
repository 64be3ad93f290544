"""Steps of the chapter on work: about a fixed axis, body by body, all forces together, springs of any length."""

from dataclasses import replace

import pytest

from rbpsym.chapters.methods import work_energy
from rbpsym.decide.verdict import undecided
from rbpsym.derive import BEFORE
from rbpsym.expr import tree as t
from rbpsym.mechanics.study import Study
from rbpsym.proof.draft import Draft
from rbpsym.proof.rules import certify
from rbpsym.proof.step import FULL, STANDARD, Certificate
from rbpsym.statement import load_text
from tests.library.derived import derived

AXIS, ALONE, TOGETHER, SPRING = "axis.", "alone.", "together.", "spring."
WORKS = (t.Sym("cal_w_c"), t.Sym("cal_w_N"))


def ids(name: str, prefix: str) -> list[str]:
    return [step.id for step in derived(name).steps if step.id.startswith(prefix)]


def step(name: str, id: str):
    return derived(name).step(id)


@pytest.mark.parametrize("name", ["rod-pendulum", "rod-and-disk-fixed", "breaking-chimney", "drawbridge"])
def test_about_a_fixed_axis_the_torque_does_the_whole_work(name):
    assert ids(name, AXIS) == ["axis.O"]


@pytest.mark.parametrize("name", ["sliding-ladder", "rod-and-disk-free", "torsion-pendulum", "disk-on-incline"])
def test_no_axis_where_nothing_turns_about_it_or_the_centre_stays_on_it(name):
    assert ids(name, AXIS) == []


def test_moments_of_inertia_about_a_common_axis_add():
    whole = step("rod-and-disk-fixed", "moment.together.O").statement
    assert len(whole.items[1].terms) == 2
    assert ids("rod-and-disk-free", "moment.together") == []


def test_the_works_between_two_bodies_go_away_when_their_theorems_are_added():
    first, second, total = (step("rod-and-disk-free", f"alone.{part}") for part in ("disk", "rod", "added"))
    assert "cal_w_N" in t.names(first.statement) & t.names(second.statement)
    assert "cal_w_N" not in t.names(total.statement)
    assert first.level == second.level == total.level == STANDARD


def test_three_bodies_are_a_matter_for_full_detail():
    assert {step("stepped-pulley", id).level for id in ids("stepped-pulley", ALONE)} == {FULL}


@pytest.mark.parametrize("name", ["rod-and-disk-fixed", "rod-pendulum", "disk-on-viscous-bearing"])
def test_bodies_are_not_taken_alone_where_that_says_nothing_new(name):
    """Rigidly joined about one axis; a single one; with a work that is not known as a function of position."""
    assert ids(name, ALONE) == []


def test_both_contact_forces_of_the_ladder_are_one_work_with_two_signs():
    found = [step("sliding-ladder", id).statement for id in ids("sliding-ladder", TOGETHER)]
    assert len(found) == 5
    assert all(t.names(chain) & {"cal_w_c"} for chain in found[:4])
    assert found[2].items[-1] == t.neg(WORKS[0])
    assert "cal_w_c" not in t.names(found[4])


@pytest.mark.parametrize("name", ["rod-pendulum", "disk-on-incline", "ladder-with-friction", "rod-with-damper"])
def test_a_single_ideal_force_or_friction_is_not_taken_together(name):
    assert ids(name, TOGETHER) == []


def test_the_spring_is_told_for_any_natural_length_where_its_own_is_chosen():
    general = step("sliding-ladder-with-spring", "spring.F_s").statement
    assert "l_0" in t.names(general)
    assert ids("elastic-pendulum", SPRING) == ids("disk-with-spring", SPRING) == []


@pytest.mark.parametrize(("name", "id"), [("sliding-ladder", "together.theta"), ("rod-and-disk-free", "alone.disk")])
def test_the_opposite_sign_is_not_proved(name, id):
    own, context = step(name, id), _drafted(name).context
    assert certify(context, own).verdict.is_proved
    wrong = t.equation(*(_swapped(item) for item in own.statement.items))
    assert not certify(context, replace(own, statement=wrong)).verdict.is_proved


def test_what_follows_from_a_step_that_is_not_proved_is_not_proved():
    own, context = step("rod-and-disk-free", "alone.added"), _drafted("rod-and-disk-free").context
    assert certify(context, own).verdict.is_proved
    first = context.steps["alone.disk"]
    context.steps["alone.disk"] = replace(first, certificate=Certificate(first.certificate.checks, undecided("it is doubted")))
    assert not certify(context, own).verdict.is_proved


CRANK = """
title = "A crank whose link ends on a line"
[parameters]
m = "mass"
ell = "length"
g = "acceleration"
[coordinates]
q = { meaning = "angle", start = "q_0", speed = "0" }
p = { meaning = "angle" }
[bodies]
crank = { shape = "rod", mass = "m", length = "ell", angle = "q" }
link = { shape = "rod", mass = "m", length = "3*ell", angle = "p" }
[constraints]
A = { type = "pivot", point = "crank.start", at = "O" }
B = { type = "pin", points = ["crank.end", "link.start"] }
N = { type = "guide", point = "link.end", line = "y = 0" }
[interactions.W]
type = "gravity"
"""


def test_nothing_is_told_since_a_start_at_which_a_tied_coordinate_has_no_place():
    """What the angle of the link is at the start is not known: no formula may have it as it is now."""
    draft = Draft(Study(load_text(CRANK)))
    for write in (*BEFORE, work_energy.write):
        write(draft)
    assert all(one.certificate.verdict.is_proved for one in draft.steps)
    assert not [one.id for one in draft.steps if one.id.startswith(ALONE)]


def _drafted(name: str) -> Draft:
    """A draft in which the names of the chapter on work have their meaning."""
    draft = Draft(derived(name).study)
    for write in (*BEFORE, work_energy.write):
        write(draft)
    return draft


def _swapped(node: t.Node) -> t.Node:
    """The work of the ideal forces with the other sign."""
    if node in (*WORKS, *map(t.neg, WORKS)):
        return t.neg(node)
    return t.Add(tuple(map(_swapped, node.terms))) if isinstance(node, t.Add) else node
