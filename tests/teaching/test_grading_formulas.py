"""Formulas that people type are judged rightly: none wrongly called equal, nearly all decided, quickly."""

from __future__ import annotations

from collections import Counter
from functools import cache

import pytest

from rbpsym.expr import tree as t
from rbpsym.expr.infix import read_infix
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
from rbpsym.teaching.grading.answer import grade_answer
from rbpsym.teaching.grading.formula import Sought, judge_formula
from rbpsym.teaching.grading.ground import GradingGround, bare_ground, ground_of
from rbpsym.teaching.grading.judgement import Judgement, Status
from rbpsym.teaching.model import Anticipated, Slip
from tests.teaching.made_answers import SIGNS, made_answers
from tests.teaching.typed_answers import Row, rows

ROWS = rows()
_grounds: dict[tuple, GradingGround] = {}


def judged(row: Row) -> Judgement:
    ground = _grounds.setdefault(row.symbols, bare_ground(dict(row.symbols)))
    return grade_answer(row.answer, row.key, ground)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row.key} {row.answer}"[:70])
def test_typed_answer(row: Row) -> None:
    found = judged(row)
    assert found.status.value == row.expected, found
    assert found.credit == (row.expected == "right")
    is_no_equation = any(remark.key in ("equation wanted", "identity") for remark in found.remarks)
    assert (found.witness is not None) == (row.expected == "wrong" and not is_no_equation)


def test_the_tables_are_large() -> None:
    made = made_answers()
    assert len(set(ROWS)) == len(ROWS) >= 350
    assert len(made) >= 1000
    kinds = Counter(answer.is_right for answer in made)
    assert min(kinds.values()) >= 400


def test_made_answers() -> None:
    """None is wrongly called right or wrong; 99 % and more are decided (of the time: test_grading_holdout)."""
    ground, undecided = bare_ground(SIGNS), 0
    made = made_answers()
    for answer in made:
        found = grade_answer(answer.answer, answer.key, ground)
        assert found.status in (Status.RIGHT, Status.WRONG, Status.UNDECIDED), (answer, found)
        undecided += found.status is Status.UNDECIDED
        if found.status is not Status.UNDECIDED:
            assert (found.status is Status.RIGHT) == answer.is_right, answer
    assert undecided <= len(made) / 100


# --- on the ground of a problem


@cache
def ground(name: str) -> GradingGround:
    return ground_of(Study(load_problem(find_problem(name))))


FIXED = "rod-and-disk-fixed"
KEY = "-(m/2 + M)*g*ell*sin(theta)/(m*ell**2/3 + M*ell**2 + M*R**2/2)"
SPINLESS = "-(m/2 + M)*g*ell*sin(theta)/(m*ell**2/3 + M*ell**2)"


def sought() -> Sought:
    on = ground(FIXED)
    slip = Anticipated(Slip("spin", first_wrong="x", shown=t.Sym("I_disk")), read_infix(SPINLESS, on.book.names))
    key = read_infix(KEY, on.book.names)
    return Sought(key, on, t.Sym("theta_ddot"), frozenset(["m", "M", "g", "ell", "R", "theta"]), (slip,))


def remarks(text: str) -> tuple[Status, tuple[str, ...]]:
    found = judge_formula(text, sought())
    return found.status, tuple(remark.key for remark in found.remarks)


@pytest.mark.parametrize(
    ("text", "status", "keys"),
    [
        ("α = -3(m+2M)gℓ sin(θ)/(2mℓ²+6Mℓ²+3MR²)", Status.RIGHT, ()),
        (r"\ddot\theta = -\frac{3(m+2M)g\ell\sin\theta}{2m\ell^2+6M\ell^2+3MR^2}", Status.RIGHT, ()),
        ("theta'' = " + KEY, Status.RIGHT, ()),
        ("-(m/2+M) g l sin θ/(I_rod + m l²/4 + M l² + I_disk)", Status.RIGHT, ()),
        (SPINLESS, Status.WRONG, ("slip", "first wrong")),
        (KEY[1:], Status.WRONG, ("sign",)),
        (f"3*({KEY})/2", Status.WRONG, ("factor",)),
        ("θ''", Status.WRONG, ("circular",)),
        ("α = α", Status.WRONG, ("circular",)),
        ("0*alpha + 1", Status.WRONG, ("circular",)),
        ("-g sin θ", Status.WRONG, ("dimension",)),
        ("m + g", Status.WRONG, ("dimensions",)),
        ("-g/ell*sin(theta)", Status.WRONG, ("wrong",)),
        ("(m l²/3+M l²+M R²/2) α = -(m/2+M) g l sin θ", Status.UNFINISHED, ("unsolved",)),
        ("(m l²/3+M l²) α = -(m/2+M) g l sin θ", Status.WRONG, ("wrong",)),
        ("α - α = 0", Status.WRONG, ("identity",)),
        ("1/(m - m)", Status.INVALID, ("zero division",)),
        ("m g ell*sin(theta)/Irodd", Status.INVALID, ("invalid",)),
        ("", Status.EMPTY, ("empty",)),
        (f"α = {KEY} = -g/ell", Status.WRONG, ("wrong",)),
        (f"α = -g/ell = {KEY}", Status.RIGHT, ("chain",)),
    ],
)
def test_answers_about_a_problem(text: str, status: Status, keys: tuple[str, ...]) -> None:
    assert remarks(text) == (status, keys)


def test_unknown_symbol_names_the_nearest() -> None:
    found = judge_formula("m g ell sin(theta)/I_diskk", sought())
    assert "Did you mean “I_disk”?" in found.remarks[0].slots["why"]


def test_the_motion_may_not_be_presumed() -> None:
    """A force that is still in the answer: true on the motion, not the result."""
    on = ground(FIXED)
    torque = "(N_x*ell*cos(theta) + N_y*ell*sin(theta) + tau + m*g*ell*sin(theta)/2)"
    key = read_infix(KEY, on.book.names)
    rows_ = [(f"-{torque}/(m*ell**2/3)", "unfinished"), (f"{torque}/(m*ell**2/3)", "unfinished")]
    found = [judge_formula(text, Sought(key, on, t.Sym("theta_ddot"))).status.value for text, _ in rows_]
    assert sorted(found) == ["unfinished", "wrong"]  # one of the two senses of N is the right one


def test_rolling_constraint_may_be_used() -> None:
    """v = ωR may be used where it holds."""
    text = """
title = { en = "cylinder" }
[parameters]
M = "mass: mass"
R = "length: radius"
g = "acceleration: gravity"
beta = "angle: slope"
[coordinates.x]
dimension = "length"
meaning = "way down the slope"
start = "0"
[coordinates.phi]
meaning = "angle"
start = "0"
[bodies.disk]
shape = "disk"
mass = "M"
radius = "R"
center = ["x*cos(beta) + R*sin(beta)", "-x*sin(beta) + R*cos(beta)"]
angle = "-phi"
[interactions.W]
type = "gravity"
[constraints.N]
type = "rolling"
body = "disk"
line = "y = -x*tan(beta)"
friction = "f"
"""
    from rbpsym.statement.loader import load_text

    on = ground_of(Study(load_text(text)))
    for answer in (
        "3/4 M x'^2",
        "3/4 M R^2 phi'^2",
        "M x'^2/2 + M R^2 phi'^2/4",
        "M R x' phi' * 3/4",
        "3/4 M (R \\dot\\phi)^2",
    ):
        assert grade_answer(answer, "M*x_dot**2/2 + M*R**2/2*phi_dot**2/2", on).status is Status.RIGHT, answer
    for answer in ("M x'^2/2", "3/4 M R phi'^2", "M x'^2"):
        assert grade_answer(answer, "M*x_dot**2/2 + M*R**2/2*phi_dot**2/2", on).status is Status.WRONG, answer


def test_error_carried_forward_is_guarded() -> None:
    on = ground(FIXED)
    names = on.book.names
    key, own = read_infix("M*ell*g*sin(theta)", names), read_infix("M*ell*g*cos(theta)", names)
    assert judge_formula("M g l cos θ", Sought(key, on, carried=(own,))).status is Status.CARRIED
    for trivial in ("0", "1", "m - m", "theta"):
        carried = (read_infix(trivial, names),)
        assert judge_formula(trivial, Sought(key, on, carried=carried)).credit == 0, trivial


LADDER_KEY = "-3*g*cos(theta)/(4*ell)"


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("-3g cosθ/4l", Status.RIGHT),  # by its dimension 3g cosθ/(4ℓ)
        (r"-3g\cos\theta/4\ell", Status.RIGHT),
        ("-3/4 g/l cos(theta)", Status.RIGHT),
        ("-3/4 g/l cosθ", Status.RIGHT),
        ("-3g/4*l*cos(theta)", Status.WRONG),
        ("3g/4l cosθ", Status.WRONG),  # wrong in every reading
        ("-3g/2l cosθ", Status.WRONG),
        ("theta'' = -3g cosθ/(4l)", Status.RIGHT),
        (r"\frac{d^2\theta}{dt^2} = -\frac{3g\cos\theta}{4\ell}", Status.RIGHT),
    ],
)
def test_dimensions_tell_what_is_meant(text: str, status: Status) -> None:
    ground = ground_of(Study(load_problem(find_problem("sliding-ladder"))))
    assert grade_answer(text, LADDER_KEY, ground).status is status


@pytest.mark.parametrize("text", ["3g/4l", "3g/4 l", r"3g/4\ell"])
def test_without_dimensions_two_readings_are_refused(text: str) -> None:
    ground = bare_ground({"g": "positive", "ell": "positive"})
    assert grade_answer(text, "3*g/(4*ell)", ground).status is Status.INVALID
    assert grade_answer(text, "3*g/(2*ell)", ground).status is Status.WRONG


def test_an_equation_for_something_else_is_no_wrong_result() -> None:
    ground = bare_ground({"m": "positive", "k": "positive", "x": "real", "g": "positive", "a": "real"})
    found = grade_answer("m a = k x - m g", "k*x - m*g", ground)
    assert found.status is Status.INVALID and found.remarks[0].key == "equation"
    assert grade_answer("m a = k x + m g", "k*x - m*g", ground).status is Status.WRONG


def test_names_of_the_only_body_and_units_behind_a_formula() -> None:
    ground = ground_of(Study(load_problem(find_problem("sliding-ladder"))))
    for text in ("-M g l cosθ/(I + M l^2)", "-M g l cosθ/(I_cm + M l^2)", "ω̇ = -3g cosθ/(4l)", "-3g cosθ/(4l) [rad/s²]",
                 "-(3/4)*(g/l)*cos(theta) rad/s^2", "α=-3g/4l · cosθ ≈ -0.75 g/l cosθ"):  # fmt: skip
        assert grade_answer(text, LADDER_KEY, ground, target="theta_ddot").status is Status.RIGHT, text


@pytest.mark.parametrize("text", ["I*omega^2/2", "I_O*omega^2/2", "(I_cm + M (l/2)^2)*omega^2/2", "M l^2 omega^2/6"])
def test_a_bare_moment_of_inertia_is_about_the_centre_of_mass_or_a_fixed_point(text: str) -> None:
    """Who says what turns about a hinge has energy Iω²/2 is right; no other factor makes it so."""
    ground = ground_of(Study(load_problem(find_problem("rod-pendulum"))))
    assert grade_answer(text, "M*ell**2*omega**2/6", ground).status is Status.RIGHT
    assert grade_answer(f"2*({text})", "M*ell**2*omega**2/6", ground).status is Status.WRONG
