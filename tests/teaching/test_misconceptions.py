"""Misconceptions are operators on the physics: each gives the textbook's wrong answer, refuted against the right one."""

from __future__ import annotations

import re
from functools import cache

import pytest

from rbpsym.decide.dimensions import dimension_of
from rbpsym.decide.equal import equal, scalars_equal
from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.languages import languages, phrases
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.teaching.bench import ProblemBench
from rbpsym.teaching.distractors import ANY, MOST, pool
from rbpsym.teaching.misconceptions.registry import DESCRIBED, MISCONCEPTIONS, SOURCES
from rbpsym.teaching.plan import bench_of
from rbpsym.teaching.targets import KINDS
from rbpsym.teaching.wording import say

PENDULUM, BEARING = "rod-and-disk-fixed", "rod-and-disk-free"
LADDER, SPRING, INCLINE = "sliding-ladder", "sliding-ladder-with-spring", "disk-on-incline"
SLIPPING, HINGED, ROUNDABOUT = "ball-slipping-to-rolling", "ball-and-hinged-rod", "child-onto-roundabout"
SAMPLE = (PENDULUM, BEARING, LADDER, SPRING, INCLINE)


def test_a_wound_string_has_one_tension():
    """Only a body over which a string runs on has two sides on which the tension could be taken for the same."""
    sites = MISCONCEPTIONS["same-tension-on-both-sides"].sites
    wound, over = (Study(load_problem(find_problem(name))) for name in ("yo-yo", "atwood-with-massive-pulley"))
    assert not list(sites(wound)) and list(sites(over))


# problem, misconception, quantity, what it makes of it: worked out by hand
BY_HAND = [
    (BEARING, "spin-dropped", "axis-moment.rod", "m*ell**2/4"),
    (BEARING, "spin-dropped", "momentum.disk", "M*ell**2*theta_dot"),
    (BEARING, "free-taken-as-welded", "momentum.disk", "(M*ell**2 + M*R**2/2)*theta_dot"),
    (BEARING, "parallel-axis-forgotten", "axis-moment.rod", "m*ell**2/12"),
    (BEARING, "parallel-axis-twice", "axis-moment.rod", "m*ell**2/3 + m*ell**2/4"),
    (BEARING, "moment-of-another-shape", "moment.disk", "M*R**2"),
    (BEARING, "mass-dropped", "frequency.1", "3*g/(2*ell)"),
    (BEARING, "tension-is-weight", "reaction.N_y", "M*g"),
    (BEARING, "third-law-forgotten", "acceleration.theta", "-3*g/(2*ell)*sin(theta)"),
    (BEARING, "whole-length-for-lever-arm", "frequency.1", "(m + M)*g*ell/(m*ell**2/3 + M*ell**2)"),
    (PENDULUM, "welded-taken-as-free", "momentum.disk", "M*ell**2*theta_dot"),
    (PENDULUM, "small-angle-for-large", "acceleration.theta",
     "-(m/2 + M)*g*ell/(m*ell**2/3 + M*ell**2 + M*R**2/2)*theta"),
    (PENDULUM, "start-speed-forgotten", "speed.theta",
     "2*(m/2 + M)*g*ell*(cos(theta) - cos(theta_0))/(m*ell**2/3 + M*ell**2 + M*R**2/2)"),
    (LADDER, "spin-dropped", "acceleration.theta", "-g/ell*cos(theta)"),
    (LADDER, "moment-about-wrong-point", "moment.ladder", "4*M*ell**2/3"),
    (LADDER, "wrong-sense-of-rotation", "momentum.ladder", "4*M*ell**2/3*theta_dot"),
    (LADDER, "rotational-energy-left-out", "speed.theta", "2*g/ell*(sin(theta_0) - sin(theta))"),
    (LADDER, "forces-as-at-rest", "reaction.N_f", "M*g"),
    (LADDER, "orbital-part-dropped", "momentum.ladder", "-M*ell**2/3*theta_dot"),
    (LADDER, "contact-forces-do-no-work", "work.T.N_f.ladder", "0"),
    (LADDER, "centripetal-forgotten", "reaction.N_w", "3*M*g/4*sin(theta)*cos(theta)"),
    (SPRING, "works-always-cancel", "work.theta.F_s.ladder", "k*ell**2*(cos(theta) - cos(theta_0))**2"),
    (SPRING, "work-at-application-point", "work.T.F_s.ladder", "-2*k*ell**2*(cos(theta) - cos(theta_0))**2"),
    (SPRING, "weight-sign", "work.T.W.ladder", "-M*g*ell*(sin(theta_0) - sin(theta))"),
    (INCLINE, "rolling-taken-as-sliding", "acceleration.s", "g*sin(beta)"),
    (INCLINE, "friction-wrong-way", "acceleration.s", "2*g*sin(beta)"),
    (INCLINE, "friction-is-mu-n", "acceleration.s", "g*sin(beta) - mu*g*cos(beta)"),
    (INCLINE, "sine-for-cosine", "acceleration.s", "2*g/3*cos(beta)"),
    (INCLINE, "moment-of-another-shape", "acceleration.s", "g/2*sin(beta)"),
    (INCLINE, "work-at-application-point", "work.T.f.drum", "0"),
    (INCLINE, "turning-force-moves-nothing", "acceleration.s", "g*sin(beta)"),
    (INCLINE, "whole-weight-along-slope", "acceleration.s", "2*g/3"),
    (INCLINE, "normal-force-is-weight", "reaction.N", "M*g"),
    ("block-up-and-down-incline", "whole-weight-along-slope", "acceleration.s", "-g*(1 + mu*cos(beta))"),
    (INCLINE, "translational-energy-left-out", "speed.s", "4*g*s*sin(beta)"),
    (INCLINE, "half-forgotten-in-kinetic-energy", "speed.s", "2*g*s*sin(beta)/3"),
    (INCLINE, "diameter-for-radius", "moment.drum", "2*M*R**2"),
    (LADDER, "uniform-acceleration-formula", "speed.theta", "3*g/(2*ell)*cos(theta)*(theta_0 - theta)"),
    (LADDER, "instantaneous-center-for-accelerations", "reaction.N_w", "3*M*g/4*sin(theta)*cos(theta)"),
    (SPRING, "work-sign", "work.T.W.ladder", "-M*g*ell*(sin(theta_0) - sin(theta))"),
    (BEARING, "shift-by-whole-length", "axis-moment.rod", "m*ell**2/12 + m*ell**2"),
    (SLIPPING, "rolls-while-slipping", "acceleration.x", "0"),
    (SLIPPING, "kinetic-friction-left-out", "acceleration.x", "0"),
    (HINGED, "momentum-kept-at-hinge", "question.1", "m*v_0*(1 + e)/(m*b + M*ell/2)"),
    ("bullet-in-a-rod", "momentum-kept-at-hinge", "question.1", "2*m*v_0/(M*ell + 2*m*d)"),
    (HINGED, "struck-at-center-of-mass", "question.1", "m*v_0*(1 + e)/(m*b + 2*M*ell/3)"),
    ("stepped-pulley", "rim-and-hub-alike", "acceleration.phi", "g*R*(m_1 - m_2)/(M*k**2 + (m_1 + m_2)*R**2)"),
    (PENDULUM, "momentum-is-angular-velocity", "momentum.disk", "m*ell**2/3*theta_dot"),
    (ROUNDABOUT, "angular-velocity-kept", "question.1", "Omega"),
]  # fmt: skip


@cache
def bench(name: str) -> ProblemBench:
    return bench_of(load_problem(find_problem(name)))


@pytest.mark.parametrize(("problem", "name", "id", "wrong"), BY_HAND, ids=lambda x: str(x)[:40])
def test_the_engine_makes_the_textbook_mistake(problem: str, name: str, id: str, wrong: str) -> None:
    here = bench(problem)
    target = here.targets[id]
    made = [w for w in here.pool.wrongs if w.misconception.name == name and target.kind in (*w.misconception.about, ANY)]
    values = [value for w in made if (value := target.value(w.study)) is not None]
    wanted = scalar(read_infix(wrong, here.study.problem.dimensions))
    verdicts = [scalars_equal(value, wanted, here.study.assumptions) for value in values]
    assert any(verdict.is_proved for verdict in verdicts), (len(values), verdicts)


@pytest.mark.parametrize("problem", SAMPLE)
def test_accepted_ones_are_refuted_sound_and_few(problem: str) -> None:
    here = bench(problem)
    for target in list(here.targets.values())[::3]:
        found = here.pool.of(target)
        assert len(found) <= MOST
        formulas = [d.formula for d in found]
        right = target.value(here.study)
        for place, distractor in enumerate(found):
            assert scalars_equal(distractor.value, right, here.study.assumptions).is_refuted
            if distractor.formula != t.ZERO:
                assert dimension_of(distractor.formula, here.study.problem.dimensions) == target.dimension
            for other in formulas[:place]:
                assert equal(distractor.formula, other, here.study.assumptions).is_refuted


def test_the_true_study_is_never_touched() -> None:
    here = bench(LADDER)
    before = {x.id: x.value(here.study) for x in here.targets.values()}
    for target in here.targets.values():
        here.pool.of(target)
    assert before == {x.id: x.value(here.study) for x in here.targets.values()}


@pytest.mark.parametrize("name", MISCONCEPTIONS)
def test_each_has_sources_kinds_and_words(name: str) -> None:
    own = MISCONCEPTIONS[name]
    assert DESCRIBED[own.name] and all(source in SOURCES for source in DESCRIBED[own.name])
    assert own.about and own.about <= {*KINDS, "axis-moment"}
    for language in languages():
        keys = [key for key in phrases(language, "worksheets") if key.startswith(f"misconception.{name}.")]
        assert any(key.startswith(f"misconception.{name}.feedback") for key in keys)
        assert f"misconception.{name}.title" in keys


# problems of the library in which, together, each misconception makes an accepted wrong answer
COVER = (
    "stepped-pulley",
    "atwood-with-massive-pulley", "cart-and-rod", "rod-and-disk-fixed", "rod-and-disk-free", "ball-in-a-loop", "braking-wheel",
    "half-disk-rocking", "bicycle-wheelie", "disk-with-spring", "ball-slipping-to-rolling", "breaking-chimney",
    "disk-on-incline", "child-onto-roundabout", "ball-and-hinged-rod", "double-atwood", "two-gears", "ball-with-backspin",
    "rod-with-damper",
)  # fmt: skip


def test_each_makes_a_wrong_answer_somewhere() -> None:
    """Not only applied: what it makes is refuted against the right answer and its siblings, sound, and kept."""
    missing = set(MISCONCEPTIONS)
    for problem in COVER:
        here = bench(problem)
        left = pool(here.derivation, missing)
        about = {kind for wrong in left.wrongs for kind in wrong.misconception.about}
        for target in here.targets.values():
            if target.kind in about and missing & {wrong.misconception.name for wrong in left.wrongs}:
                slips = [distractor.slip for distractor in left.of(target)]
                missing -= {idea.name for slip in slips for idea in (slip, *slip.also)}
    assert not missing


def test_there_are_enough() -> None:
    assert len(MISCONCEPTIONS) >= 70
    assert set(SOURCES) == {source for sources in DESCRIBED.values() for source in sources}
    assert set(DESCRIBED) == set(MISCONCEPTIONS)


@pytest.mark.parametrize("problem", SAMPLE)
def test_feedback_is_said_in_each_site(problem: str) -> None:
    here = bench(problem)
    for place in range(len(here.pool.wrongs)):
        slip = here.pool.slip(place)
        assert say(slip.phrase, "en", here.study.problem, **slip.slots)


def test_first_wrong_steps_are_those_that_a_teacher_would_mark() -> None:
    wanted = {
        (LADDER, "wrong-sense-of-rotation"): "turning.ladder",
        (LADDER, "moment-about-wrong-point"): "moment.ladder",
        (LADDER, "rotational-energy-left-out"): "kinetic",
        (BEARING, "free-taken-as-welded"): "turning.disk",
        (BEARING, "third-law-forgotten"): "force.N.rod",
        (SPRING, "works-always-cancel"): "work.F_s.ladder",
        (INCLINE, "moment-of-another-shape"): "moment.drum",
    }
    for (problem, name), step in wanted.items():
        here = bench(problem)
        slips = [here.pool.slip(k) for k, w in enumerate(here.pool.wrongs) if w.misconception.name == name]
        assert step in {slip.first_wrong for slip in slips}, (name, slips)
        shown = next(slip.shown for slip in slips if slip.first_wrong == step)
        assert shown == here.derivation.step(step).statement


def test_sites_follow_from_the_structure_not_from_names() -> None:
    """A problem of one's own, with names of one's own: a hoop that rolls, welded to nothing."""
    text = find_problem(INCLINE).read_text(encoding="utf-8")
    renamed = re.sub(r"\bdrum\b", "wheel", text)
    own = pool(bench_of(load_text(renamed, name="mine")).derivation)
    names = {w.misconception.name for w in own.wrongs}
    assert {"rolling-taken-as-sliding", "friction-is-mu-n", "spin-dropped"} <= names
    assert not {"free-taken-as-welded", "parallel-axis-forgotten", "length-for-elongation"} & names
