"""The machine contract, and the paper's results read back from it by our equality."""

import json

import pytest

from rbpsym.ask.asking import own_answers
from rbpsym.ask.telling import record
from rbpsym.expr.infix import read_infix
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import same
from rbpsym.solve import solve
from rbpsym.statement.library import problem_files
from tests.library.derived import answered, derived, problem

KEYS = {
    "problem",
    "degrees_of_freedom",
    "coordinates",
    "moments_of_inertia",
    "accelerations",
    "reactions",
    "kinetic_energy",
    "potential_energy",
    "first_integral",
    "speed_squared",
    "reactions_along_motion",
    "angular_momentum",
    "works",
    "equilibria",
    "conditions",
    "verdicts",
}
NAMES = {*"m M R g k ell theta phi theta_dot phi_dot theta_0 omega_0 beta_0 phi_0".split()}
NAMES |= {*"N_w N_f N_x N_y F_x F_y tau".split()}
_ANSWERS = {}


def answer(name):
    if name not in _ANSWERS:
        _ANSWERS[name] = json.loads(json.dumps(answered(name)))
    return _ANSWERS[name]


def value(text):
    return scalar(read_infix(text, NAMES))


def at(found, path):
    for key in path.split("/"):
        found = found[int(key)] if isinstance(found, list) else found[key]
    return found


@pytest.mark.parametrize("name", ["sliding-ladder", "ball-slipping-to-rolling"])
def test_the_answer_is_that_of_the_derivation(name):
    found = solve(problem(name), simulation=False)
    assert found.pop("questions") == [record(one) for one in own_answers(derived(name).study)]
    assert found == answered(name)


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_keys_and_verdicts(name):
    found = answer(name)
    assert found.keys() >= KEYS
    verdicts = found["verdicts"]
    assert verdicts["steps"] == verdicts["proved"] >= 10
    assert verdicts["refuted"] == verdicts["undecided"] == 0
    assert verdicts["methods_agree"] is True
    assert verdicts["lagrange"] == "PROVED"


@pytest.mark.parametrize("name", sorted(problem_files()))
def test_forces_are_solved_and_a_damped_motion_has_no_undamped_frequency(name):
    found = answer(name)
    for one in (found, *found["phases"]):
        if one.get("accelerations"):
            assert not any("_ddot" in text for text in (one["reactions"] or {}).values())
    for item in found["equilibria"]:
        assert not (item["damping"] and item["frequencies_squared"])


I1, I2 = "(m*ell**2/3 + M*ell**2 + M*R**2/2)", "(m*ell**2/3 + M*ell**2)"
PAPER = [
    ("rod-and-disk-fixed", "accelerations/theta", f"-g*ell*(m/2 + M)*sin(theta)/{I1}"),
    ("rod-and-disk-fixed", "moments_of_inertia/disk", "M*R**2/2"),
    ("rod-and-disk-fixed", "angular_momentum/O/disk/orbital", "M*ell**2*theta_dot"),
    ("rod-and-disk-fixed", "angular_momentum/O/disk/spin", "M*R**2/2*theta_dot"),
    ("rod-and-disk-fixed", "reactions/tau", f"-M*R**2/2*g*ell*(m/2 + M)*sin(theta)/{I1}"),
    ("rod-and-disk-fixed", "equilibria/0/frequencies_squared/0", f"g*ell*(m/2 + M)/{I1}"),
    ("rod-and-disk-free", "accelerations/theta", f"-g*ell*(m/2 + M)*sin(theta)/{I2}"),
    ("rod-and-disk-free", "accelerations/phi", "0"),
    ("rod-and-disk-free", "works/N/disk/translational/value", "m*M*g*ell*(cos(theta) - cos(theta_0))/(2*(m + 3*M))"),
    ("rod-and-disk-free", "works/N/disk/rotational/value", "0"),
    ("rod-and-disk-free", "equilibria/0/frequencies_squared/0", f"g*ell*(m/2 + M)/{I2}"),
    ("sliding-ladder", "accelerations/theta", "-3*g/(4*ell)*cos(theta)"),
    ("sliding-ladder", "moments_of_inertia/ladder", "M*ell**2/3"),
    ("sliding-ladder", "kinetic_energy/total", "2/3*M*ell**2*theta_dot**2"),
    ("sliding-ladder", "first_integral", "2/3*M*ell**2*theta_dot**2 + M*g*ell*sin(theta)"),
    ("sliding-ladder", "speed_squared/theta", "3*g/(2*ell)*(sin(theta_0) - sin(theta))"),
    ("sliding-ladder", "reactions_along_motion/N_w", "3/4*M*g*cos(theta)*(3*sin(theta) - 2*sin(theta_0))"),
    ("sliding-ladder", "reactions_along_motion/N_f", "M*g/4*(1 - 6*sin(theta)*sin(theta_0) + 9*sin(theta)**2)"),
    ("sliding-ladder", "works/N_w/ladder/translational/integrand", "-ell*N_w*sin(theta)"),
    ("sliding-ladder", "works/N_w/ladder/translational/value", "3/4*M*g*ell*sin(theta)**2*(sin(theta_0) - sin(theta))"),
    (
        "sliding-ladder",
        "works/N_f/ladder/rotational/value",
        "M*g*ell/4*(sin(theta_0) - sin(theta))*(1 + 3*sin(theta)**2)",
    ),
    ("sliding-ladder", "angular_momentum/O/ladder/orbital", "M*ell**2*theta_dot"),
    ("sliding-ladder", "angular_momentum/O/ladder/spin", "-M*ell**2*theta_dot/3"),
    ("sliding-ladder", "conditions/0/at/theta", "asin(2/3*sin(theta_0))"),
    ("sliding-ladder-with-spring", "works/F_s/ladder/translational/value", "-k*ell**2*(cos(theta) - cos(theta_0))**2"),
    ("sliding-ladder-with-spring", "works/F_s/ladder/rotational/value", "-k*ell**2*(cos(theta) - cos(theta_0))**2"),
]


@pytest.mark.parametrize(("name", "path", "expected"), PAPER, ids=[f"{n}/{p}" for n, p, _ in PAPER])
def test_the_papers_results(name, path, expected):
    assert same(value(at(answer(name), path)), value(expected))


def test_loss_of_contact_is_the_papers():
    [condition] = answer("sliding-ladder")["conditions"]
    assert condition["force"] == "N_w"
    ratio = value(condition["vanishes"]) / value("3*sin(theta) - 2*sin(theta_0)")
    assert ratio.number()


def test_stability():
    stable = [item["stable"] for item in answer("rod-and-disk-fixed")["equilibria"]]
    assert stable == [True, False]
