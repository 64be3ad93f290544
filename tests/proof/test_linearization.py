"""What is said of small motions sees every term of first order: whatever is left out or changed is not PROVED."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from rbpsym.derive import derive
from rbpsym.expr import tree as t
from rbpsym.field.scalar import NOTHING
from rbpsym.proof import expansion
from rbpsym.proof.checks import oscillations as checks_oscillations
from rbpsym.proof.checks import stability as checks_stability
from rbpsym.proof.draft import Draft
from rbpsym.proof.rules import certify
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_text
from tests.library.derived import unsimulated
from tests.proof.conftest import drafted

RULES = {"linearization", "linear_system"}
DAMPED = ("rod-on-damped-cart", "rods-with-rotary-damper", "disk-on-viscous-bearing", "rod-with-damper")
MORE = ("cart-and-rod", "spring-coupled-pendulums", "elastic-pendulum", "linear-molecule")


def steps_of(name, rules):
    draft = drafted(name)
    found = [step for step in draft.steps if step.rule in rules]
    assert found, name
    return draft, found


def terms(node):
    return node.terms if isinstance(node, t.Add) else (node,)


def without_a_term(statement):
    """The statement with one term of one side of one row left out, in every way; what becomes 0 = 0 … stays a row."""
    rows = statement.rows if isinstance(statement, t.Relations) else (statement,)
    for k, row in enumerate(rows):
        for side, item in enumerate(row.items):
            for place in range(len(terms(item))):
                left = t.add(*(term for n, term in enumerate(terms(item)) if n != place))
                items = tuple(left if n == side else other for n, other in enumerate(row.items))
                changed = (*rows[:k], t.Chain(items, row.ops), *rows[k + 1 :])
                yield t.Relations(changed) if isinstance(statement, t.Relations) else changed[0]


@pytest.mark.parametrize("name", [*DAMPED, *MORE])
def test_a_linear_equation_that_lacks_a_term_is_not_proved(name):
    draft, steps = steps_of(name, RULES)
    for step in steps:
        assert certify(draft.context, step).verdict.is_proved
        spoilt = [w for w in without_a_term(step.statement) if w != step.statement]
        assert spoilt
        for wrong in spoilt:
            assert not certify(draft.context, replace(step, statement=wrong)).verdict.is_proved, (step.id, wrong)


@pytest.mark.parametrize("name", ["rod-on-damped-cart", "disk-on-viscous-bearing"])
def test_a_pendulum_whose_support_is_damped_does_not_swing_alone(name):
    """The statement that was once proved: θ̈ ≈ -ϑ² θ, with the speed of the other coordinate forgotten."""
    draft = drafted(name)
    item = draft.study.equilibria[0]
    assert item.frequencies_squared == () and item.linear.is_damped
    square = item.stiffness[1][1] if name == "rod-on-damped-cart" else item.stiffness[0][0]
    alone = t.relation(t.Sym("theta_ddot"), "~", t.neg(t.mul(Draft(draft.study).show(square), t.Sym("theta"))))
    step = next(s for s in draft.steps if s.id == "linear.1")
    wrong = replace(step, rule="linearization", statement=alone, data={"name": "theta", "at": item.at})
    assert not certify(draft.context, wrong).verdict.is_proved


@pytest.mark.parametrize("name", DAMPED)
def test_modes_and_conditions_follow_from_all_of_the_equations(name):
    """Of a mode, of a condition, of the stability: what belongs to other numbers is not proved."""
    draft, steps = steps_of(name, {"motion_of_mode", "hurwitz", "polynomial", "equilibrium"})
    for step in steps:
        for change in CHANGES[step.rule](step):
            assert not certify(draft.context, replace(step, data=step.data | change)).verdict.is_proved, (step, change)


CHANGES = {
    "motion_of_mode": lambda step: [{"square": step.data["square"] * 2}, {"decay": step.data["decay"] + 1}],
    "hurwitz": lambda step: [{"powers": (*step.data["powers"][:-1], step.data["powers"][-1] * 2)}],
    "polynomial": lambda step: [],
    "equilibrium": lambda step: [{"proved": kind} for kind in OTHERS[step.data["proved"]]],
}
OTHERS = {"asymptotic": ["unstable"], "minimum": ["unstable", "asymptotic"], "unstable": ["minimum", "asymptotic"]}


@pytest.mark.parametrize("module", [expansion, checks_oscillations, checks_stability])
def test_makers_and_checkers_share_no_linearisation(module):
    """The checkers use nothing by which linear equations, polynomials and conditions are made; the expansion no
    derivative and no substitution either."""
    text = Path(module.__file__).read_text(encoding="utf-8")
    assert not [made for made in ("mechanics.oscillation", "mechanics.stability") if made in text]
    assert "determinant" not in vars(module)
    assert module is not expansion or not {"derivative", "substitute"} & vars(module).keys()


def test_no_period_is_asked_for_where_the_motion_is_damped():
    from rbpsym.teaching.targets import targets

    for name in DAMPED:
        found = targets(unsimulated(name))
        assert not [target for target in found if target.kind == "frequency"], name


def test_the_expansion_keeps_what_is_of_first_order():
    from rbpsym.field.calculus import root
    from rbpsym.field.scalar import UNITY, symbol
    from rbpsym.field.trig import cosine, sine

    theta, speed = symbol("theta"), symbol("theta_dot")
    images = {
        "theta": expansion.FirstOrder(NOTHING, symbol("theta away")),
        "theta_dot": expansion.FirstOrder(NOTHING, symbol("theta _dot")),
    }
    value = sine(theta) * 3 + cosine(theta) * speed + speed * speed + root(UNITY + theta) / (UNITY + theta) ** 3
    found = expansion.expanded(value, images)
    assert expansion.part(found.slope, "theta _dot") == UNITY
    assert expansion.part(found.slope, "theta away") * 2 == UNITY
    assert found.value == UNITY


WORKING = """
title = "A hinged rod that a torsion spring holds at a slant"
[parameters]
M     = "mass"
ell   = "length"
kappa = "torsion stiffness"
c     = "rotary damping"
g     = "acceleration"
[coordinates.theta]
start = "pi/6"
range = ["-pi/2", "pi/2"]
[bodies.rod]
shape  = "rod"
mass   = "M"
length = "ell"
start  = "O"
angle  = "theta"
[interactions.W]
type = "gravity"
[interactions.S]
type          = "torsion-spring"
between       = ["ground", "rod"]
stiffness     = "kappa"
rest_angle    = "pi/6 + M*g*ell*cos(pi/6)/(2*kappa)"
[interactions.D]
type        = "rotary-damper"
between     = ["ground", "rod"]
coefficient = "c"
[constraints.F]
type  = "pivot"
point = "rod.start"
"""


def test_about_a_stated_working_position():
    """κ(θ - θ_n) = -(Mgℓ/2) cos θ has no closed solution; the stated start is one."""
    from rbpsym.decide.equal import scalars_equal
    from rbpsym.expr.infix import read_infix
    from rbpsym.field.evaluate import scalar
    from rbpsym.mechanics.study import Study

    study = Study(load_text(WORKING))
    [item] = study.equilibria
    [[stiffness]] = item.stiffness
    wanted = scalar(read_infix("kappa - M*g*ell/4", ["kappa", "M", "g", "ell"]))
    assert scalars_equal(item.at["theta"], scalar(read_infix("pi/6", []))).is_proved
    assert scalars_equal(stiffness, wanted).is_proved
    assert item.frequencies_squared == () and item.nature.proved == "open"
    assert scalars_equal(item.where / wanted, item.where / stiffness).is_proved


SLANTED = """
[parameters]
m = "mass"
n = "mass"
k = "stiffness"
c = "damping"
L = "length"
ell = "length"
g = "acceleration"
[points]
Q = ["L", "0"]
[coordinates.x]
dimension = "length"
[coordinates.q]
meaning = "angle"
[bodies.cart]
shape = "particle"
mass = "n"
center = ["x", "0"]
[bodies.bob]
shape = "particle"
mass = "m"
center = ["x + ell*sin(q)", "-ell*cos(q)"]
[constraints.N]
type = "guide"
point = "cart.center"
line = "y = 0"
[constraints.T]
type = "string"
path = ["cart.center", "bob.center"]
length = "ell"
[interactions.W]
type = "gravity"
[interactions.S]
type = "spring"
between = ["O", "cart.center"]
stiffness = "k"
[interactions.D]
type = "damper"
between = ["Q", "bob.center"]
coefficient = "c"
"""


def test_a_polynomial_with_roots_in_its_coefficients_is_compared_part_by_part():
    found = derive(load_text(SLANTED), simulation=False)
    step = found.step("characteristic.1")
    assert step.certificate.verdict.is_proved
    (rows,) = step.statement.items[:1]
    for place in range(len(rows.terms)):  # each coefficient matters
        spoilt = replace(step, statement=t.equation(t.add(*(x for k, x in enumerate(rows.terms) if k != place)), t.ZERO))
        assert checks_oscillations.polynomial(found.letters, spoilt).is_refuted


def test_a_closed_loop_swings_with_what_its_conditions_allow():
    """h sin φ + ℓ sin ψ = 0 is not solved; ψ moves with φ by -(r/ℓ) there."""
    draft = drafted("systems/guided-rod")
    [item] = draft.study.equilibria
    assert set(item.linear.tied) == {"psi"}
    step = next(step for step in draft.steps if step.rule == "linear_system")
    [factor] = item.linear.tied["psi"]
    wrong = replace(step, data={**step.data, "tied": {"psi": (factor * 2,)}})
    assert certify(draft.context, step).verdict.is_proved
    assert not certify(draft.context, wrong).verdict.is_proved


FADING = """
title = "A rod that swings beside a disk that a rotary damper slows down"
[parameters]
M     = "mass"
m     = "mass"
ell   = "length"
R     = "length"
c     = "rotary damping"
g     = "acceleration"
[points]
Q = ["3*ell", "0"]
[coordinates.theta]
start = "theta_0"
range = ["-pi/2", "pi/2"]
[coordinates.phi]
start = "0"
[bodies.rod]
shape  = "rod"
mass   = "M"
length = "ell"
start  = "O"
angle  = "theta - pi/2"
[bodies.disk]
shape  = "disk"
mass   = "m"
radius = "R"
center = "Q"
angle  = "phi"
[interactions.W]
type = "gravity"
[interactions.D]
type        = "rotary-damper"
between     = ["ground", "disk"]
coefficient = "c"
[constraints.F]
type  = "pivot"
point = "rod.start"
[constraints.G]
type  = "pivot"
point = "disk.center"
at    = "Q"
"""
CHARACTERISTIC = ("spring-coupled-pendulums", "linear-molecule", "rod-on-damped-cart", "rods-with-rotary-damper")


def moved(statement, left, right):
    """The equation with something added to each side."""
    return t.equation(*(t.add(side, more) for side, more in zip(statement.items, (left, right), strict=True)))


@pytest.mark.parametrize("name", CHARACTERISTIC)
def test_a_characteristic_equation_is_told_by_both_of_its_sides(name):
    """What is added to both sides changes nothing, what is added to one side does."""
    draft, steps = steps_of(name, {"secular", "polynomial"})
    for step in steps:
        for more in (t.ONE, t.neg(t.TWO)):
            same, other = moved(step.statement, more, more), moved(step.statement, t.ZERO, more)
            assert certify(draft.context, replace(step, statement=same)).verdict.is_proved
            assert not certify(draft.context, replace(step, statement=other)).verdict.is_proved


def test_a_characteristic_equation_shows_its_factors():
    for name, number in (("linear-molecule", 3),):
        [step] = steps_of(name, {"secular"})[1]
        moving = [factor for factor in step.statement.items[0].factors if step.slots["letter"].name in t.names(factor)]
        assert len(moving) == number


@pytest.mark.parametrize("name", ["rod-on-damped-cart", "rods-with-rotary-damper"])
def test_a_characteristic_equation_may_be_multiplied_by_what_does_not_vanish(name):
    draft, steps = steps_of(name, {"polynomial"})
    for step in steps:
        left, right = step.statement.items
        for factor in (t.TWO, t.Sym("c"), t.Pow(t.Sym("g"), t.TWO)):
            times = t.equation(t.mul(factor, t.Group(left)), right)
            assert certify(draft.context, replace(step, statement=times)).verdict.is_proved
        [letter] = {step.slots["letter"]}
        wrong = t.equation(t.mul(letter, t.Group(left)), right)
        assert not certify(draft.context, replace(step, statement=wrong)).verdict.is_proved


def test_a_rate_at_which_motion_dies_out_is_that_of_its_damper():
    from rbpsym.decide.equal import scalars_equal
    from rbpsym.expr.infix import read_infix
    from rbpsym.field.evaluate import scalar

    [step] = [step for step in derive(load_text(FADING), simulation=False).steps if step.rule == "rate_of_mode"]
    assert step.certificate.verdict.is_proved
    told, wanted = step.statement.items[-1], read_infix("2*c/(m*R^2)", ["c", "m", "R"])
    assert scalars_equal(scalar(told), scalar(wanted)).is_proved


DAMPED_BLOCK = """
[parameters]
m = "mass"
k = "stiffness{bound}"
c = "damping"
[coordinates.x]
dimension = "length"
start = "x_0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["x", "0"]
[interactions.S]
type = "spring"
between = ["O", "block.center"]
stiffness = "k"
[interactions.D]
type = "damper"
between = ["O", "block.center"]
coefficient = "c"
"""


@pytest.mark.parametrize(("bound", "said", "other"), [(" > c**2/(4*m)", "surely", "never"), (" < c**2/(4*m)", "never", "surely")])
def test_whether_a_damped_motion_swings_is_checked(bound, said, other):
    found = derive(load_text(DAMPED_BLOCK.format(bound=bound)), simulation=False)
    [step] = [step for step in found.steps if step.id.startswith("damped.")]
    assert step.data["swings"] == said and step.certificate.verdict.is_proved
    assert not certify(found.letters, replace(step, data={**step.data, "swings": other})).verdict.is_proved


def test_what_grows_does_not_die_out():
    """Two rods upright, joined by a rotary damper: Routh's table has a row that begins with zero, and their motion against
    each other grows whatever the damping."""
    from rbpsym.commands.solve import lines
    from rbpsym.solve import answer_of

    text = load_text(problem_files()["rods-with-rotary-damper"].read_text().replace("range", "# range"))
    found = derive(text, simulation=False)
    answer = answer_of(found)
    upright = next(place for place in answer["equilibria"] if set(place["at"].values()) == {"pi"})
    assert all(step.certificate.verdict.is_proved for step in found.steps)
    assert upright["stable"] is False and not upright["damping"]
    assert not [line for line in lines(answer, text) if "unstable" in line and "dies out" in line]
