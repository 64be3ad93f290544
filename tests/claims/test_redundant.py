"""Claims about problems with more coordinates than degrees of freedom, or with conditions that stay."""

from dataclasses import replace

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.ground import EqualityQuestion, glossary
from rbpsym.claims.model import Claim, Meaning, Outcome, Printed, Setting
from rbpsym.claims.refute import refutation
from rbpsym.claims.run import Worlds
from rbpsym.field.scalar import NOTHING, UNITY, symbol

LADDER = """
[parameters]
M   = "mass: mass"
ell = "length: half the length"
g   = "acceleration: gravity"
[coordinates.theta]
start = "theta_0"
speed = "0"
range = ["0", "pi/2"]
[coordinates.x]
dimension = "length"
[coordinates.y]
dimension = "length"
[bodies.ladder]
shape  = "rod"
mass   = "M"
length = "2*ell"
center = ["x", "y"]
angle  = "pi - theta"
[interactions.W]
type = "gravity"
[constraints.N_w]
type  = "contact"
point = "ladder.end"
line  = "x = 0"
[constraints.N_f]
type  = "contact"
point = "ladder.start"
line  = "y = 0"
"""
SYMBOLS = {
    "x": "x", r"\dot x": "speed of x", r"\ddot x": "x_ddot", r"\theta": "theta", r"\omega": "speed of theta",
    r"\alpha": "acceleration of theta", r"\ell": "ell", "g": "g", r"\vec R": "position of ladder.cm",
}  # fmt: skip
ROWS = [
    (r"x=\ell\cos\theta", Outcome.PROVED),
    (r"x=\ell\sin\theta", Outcome.REFUTED),
    (r"\dot x=-\ell\omega\sin\theta", Outcome.PROVED),
    (r"\ddot x=-\ell\alpha\sin\theta-\ell\omega^2\cos\theta", Outcome.PROVED),
    (r"\alpha=-\frac{3g}{4\ell}\cos\theta", Outcome.PROVED),
    (r"\vec R<\ell", Outcome.NOT_COMPUTED),
]


@pytest.mark.parametrize(("latex", "wanted"), ROWS, ids=[row[0] for row in ROWS])
def test_coordinates_that_depend_on_others(tmp_path, latex, wanted):
    (tmp_path / "ladder.toml").write_text(LADDER)
    setting = Setting("s", "ladder.toml", symbols={key: Meaning(value) for key, value in SYMBOLS.items()})
    assert Checker(Worlds(tmp_path)).check_safely(Claim("a", setting, Printed(latex))).outcome is wanted


def test_where_conditions_stay_nothing_is_refuted_by_a_state_that_they_exclude():
    setting = Setting("s", "sliding-ladder", symbols={"g": Meaning("g")})
    ground = Checker(Worlds()).ground(setting, glossary(setting.symbols))
    place = symbol("theta")
    assert refutation(NOTHING, place, EqualityQuestion(ground)).is_refuted
    tied = replace(ground.motion, is_tied=True)
    object.__setattr__(ground, "motion", tied)
    assert not refutation(NOTHING, place, EqualityQuestion(ground)).is_refuted
    assert refutation(NOTHING, UNITY, EqualityQuestion(ground)).is_refuted  # in any state
