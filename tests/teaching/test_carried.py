"""Errors carried forward along chains of parts, formulas and numbers; trivial answers earn nothing by it."""

from __future__ import annotations

from functools import cache
from math import cos, sin

import pytest

from rbpsym.statement.units import read_unit
from rbpsym.teaching.grading.desk import Desk, Mark, grade_worksheet
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.plan import plan_of

SHEET = """
title = "A chain of parts"
[[problem]]
name = "sliding-ladder"
""" + "".join(
    f'[[problem.task]]\nkind = "{kind}"\nabout = "{about}"\n'
    for kind, about in (
        ("formula", "moment.ladder"), ("formula", "acceleration.theta"), ("formula", "speed.theta"),
        ("formula", "reaction.N_w"), ("number", "acceleration.theta"), ("number", "speed.theta"), ("number", "reaction.N_f"),
    )
)  # fmt: skip
DESK = Desk()


@cache
def sheet(folder: str) -> Worksheet:
    from pathlib import Path

    path = Path(folder) / "chain.toml"
    path.write_text(SHEET, encoding="utf-8")
    return plan_of(str(path)).worksheet(Student("ana"), "secret")


@pytest.fixture(scope="module")
def chain(tmp_path_factory) -> Worksheet:
    return sheet(str(tmp_path_factory.mktemp("chain")))


def marked(worksheet: Worksheet, **answers: str) -> dict[str, Mark]:
    return {m.item: m for m in grade_worksheet(worksheet, {k[1:]: v for k, v in answers.items()}, DESK)}


def given(worksheet: Worksheet) -> dict[str, float]:
    return {n: float(m.value) * read_unit(m.unit).factor for n, m in worksheet.item("7").key.given.items()}


def test_a_chain_of_formulas(chain: Worksheet) -> None:
    """I = Mℓ²/12 (the length taken for half of it): θ̈ and θ̇² with this I, and N_w with this θ̈, are right."""
    found = marked(
        chain,
        q1="M l^2/12",
        q2="-M g l cosθ/(M l^2 + M l^2/12)",
        q3="24/13 g/l (sin(theta_0) - sin(theta))",
        q4="M(3g/2 (sinθ - sin(theta_0)) cosθ + 12/13 g cosθ sinθ)",
    )
    assert [found[n].judgement.status.value for n in "1234"] == ["wrong", *["carried forward"] * 3]
    assert all(found[n].points == found[n].most for n in "234")


def test_each_part_alone_is_wrong(chain: Worksheet) -> None:
    found = marked(chain, q2="-M g l cosθ/(M l^2 + M l^2/12)")
    assert found["2"].judgement.status.value == "wrong"


def test_two_earlier_answers_together(chain: Worksheet) -> None:
    """N_w = M(-ℓ θ̈ sin θ - ℓ θ̇² cos θ) with both of one's own."""
    found = marked(chain, q2="-g cosθ/l", q3="g/l (sin(theta_0) - sin(theta))",
                   q4="M(g cosθ sinθ - g cosθ (sin(theta_0) - sinθ))")  # fmt: skip
    assert [found[n].judgement.status.value for n in "234"] == ["wrong", "wrong", "carried forward"]


@pytest.mark.parametrize("own", ["0", "1", "", "g", "g/l - g/l", "-g cosθ/(l sin(", "theta''", "0*g/l", "M"])
def test_trivial_formulas_carry_nothing(chain: Worksheet, own: str) -> None:
    """With θ̈ = 0 the force would be -Mℓθ̇² cos θ: easy, and worth nothing."""
    rest = "-M*3*g/2*(sin(theta_0) - sin(theta))*cos(theta)"
    assert marked(chain, q2=own, q4=rest)["4"].points == 0


def test_what_cancels_carries_nothing(chain: Worksheet) -> None:
    """An acceleration that is made so that the force vanishes."""
    own = "3 g (sinθ - sin(theta_0)) cosθ/(2 l sinθ)"
    found = marked(chain, q2=own, q4="0")
    assert found["2"].judgement.status.value == "wrong" and found["4"].points == 0


def test_numbers(chain: Worksheet) -> None:
    """N_f from the own θ̈ and θ̇, each alone and both together, in other units too."""
    values = given(chain)
    mass, length, theta, start = (values[name] for name in ("M", "ell", "theta", "theta_0"))
    alpha, omega = -1.5, 2.5
    right_square = 1.5 * 9.81 / length * (sin(start) - sin(theta))
    right_alpha = -0.75 * 9.81 / length * cos(theta)

    def force(alpha: float, square: float) -> str:
        return f"{mass * (9.81 + length * (alpha * cos(theta) - square * sin(theta))):.3g} N"

    alone = marked(chain, q5=f"{alpha} rad/s^2", q7=force(alpha, right_square))
    assert alone["5"].judgement.credit < 1 and alone["7"].judgement.status.value == "carried forward"
    alone = marked(chain, q6=f"{omega} rad/s", q7=force(right_alpha, omega**2))
    assert alone["7"].judgement.status.value == "carried forward"
    both = marked(chain, q5="-85.9437 °/s²", q6=f"{omega} rad/s", q7=force(alpha, omega**2))
    assert both["7"].judgement.status.value == "carried forward"
    for trivial in ("0 rad/s^2", "0", "", "rad/s^2", "5 kg", "nan"):
        found = marked(chain, q5=trivial, q7=force(0.0, right_square))
        assert found["7"].judgement.status.value in ("wrong", "partly right"), trivial
