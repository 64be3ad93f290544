"""What questions tell in the form of a textbook, and what they tell at all: samples of kinds that were refused or open."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered, own_answers
from rbpsym.expr import tree as t
from rbpsym.mechanics.at_start import study_of
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem, load_text
from rbpsym.typeset.text import to_text
from tests.ask.test_unseen import HERE

CRANK = """
[parameters]
a = "length: crank"
d = "length > a: distance of the pivots"
Omega = "angular speed: crank"
J = "moment of inertia: rocker"
[coordinates.phi]
[coordinates.psi]
range = ["-pi/2", "pi/2"]
[points]
P = ["d", "0"]
[bodies.crank]
shape = "rod"
mass = "0"
length = "a"
start = "O"
angle = "pi - phi"
[bodies.rocker]
shape = "given"
mass = "J/d**2"
moment = "J"
center = "P"
angle = "pi + psi"
[constraints]
A = { type = "pivot", point = "crank.start" }
B = { type = "pivot", point = "rocker.center" }
C = { type = "prescribed-angle", body = "crank", angle = "pi - Omega*t" }
N = { type = "guide", point = "crank.end", of = "rocker", line = "y = 0" }
"""
CHANGED = {  # a problem, what stands in its file, and what is put in its place
    "disk with a limit": ("disk-with-spring", ('friction = "f"', 'friction = "f"\nlimit = "mu"'),
                          ("\n[coordinates.x]", 'mu = "number: limit"\nx_0 = "length < d: start"\n\n[coordinates.x]')),
}  # fmt: skip
TOLD = (
    # vectors with values, in limits, and on what they depend
    ("plate-pins", "does acceleration of plate.cm when swinging begins depend on m", ()),
    ("plate-pins", "acceleration of plate.cm when swinging begins with c = b", ("−3g/8", "−3g/8")),
    ("plate-pins", "force A on plate when swinging begins for b << c", ("−3mgb/(4c)", "mg")),
    # all places of rest of one kind
    ("bead-on-turning-hoop", "equilibria of theta", ("arccos(g/(RΩ²))", "−arccos(g/(RΩ²))")),
    ("bead-on-turning-hoop", "unstable equilibrium of theta", ("0", "π")),
    # one of several coordinates that move for themselves; what the time gives
    ("rod-hits-ball-at-bottom", "theta where theta comes to rest in phase hit",
     ("arccos(−3m(1 + e)(3em − 2M − 3m)/(M + 3m)²)",)),
    ("crank", "speed of psi where phi = pi", ("aΩ/(d − a)",)),
    # conditions at a moment, and on one side of a value
    ("hemisphere-rocking", "mu for which it does not slip at the start", None),
    ("ball-in-a-loop", "largest v_0 for which theta stays below pi/2", ("√((10g/7)(R − a))",)),
    ("ball-in-a-loop", "largest v_0 for which N stays below 4*m*g until theta = pi/2", ("√(3g(R − a))",)),
    ("cylinder-on-wedge", "is acceleration of x negative", ()),
    # energies A sin x + B (cos x - 1), and bounds of a way whose ends depend on what is asked
    ("rod-in-accelerating-truck", "speed of theta where theta = pi/6", ("√(3(A + 2g − g √3)/(2ℓ))",)),
    ("disk with a limit", "largest x_0 for which it does not slip", ("3μmg/k",)),
    # a sum of known sign is printed as positive; roots that a denominator is a multiple of; exponentials in a product
    ("cylinder-on-wedge", "acceleration of x", ("−(2mg/(3(M + m) − 2m cos² β)) sin β cos β",)),
    ("rod-in-bowl", "period of theta", ("2π √((3R² − 2a²)/(3g √(R² − a²)))",)),
    ("rod-in-bowl", "N_1 at the start",
     ("MgR(a √(R² − a²) sin θ₀ + (3R² − 2a²) cos θ₀)/(2(3R² − 2a²) √(R² − a²))",)),
    ("bead-on-rotating-rod", "energy as a function of t", ("−mr₀²Ω²/2",)),
    ("disk-in-oil", "time until theta = 0 underdamped", ("(MR²/√(2MκR² − c²))(π − arctan(√(2MκR² − c²)/c))",)),
    # an arccos of what is negative is that of a difference
    ("loop-slide", "theta where N vanishes", ("arccos((2gR − v₀²)/(3gR))",)),
    # a start on the one side and on the other; what is said in other words
    ("pend-link", "phi_0 for which T where phi = 0 is 2*m*g", ("π/3", "−π/3")),
    ("braking-car", "stopping distance of x", ("v₀²/(2μg)",)),
    ("hexagonal-prism", "ratio of energy lost when next begins to kinetic energy just before next", ("168/289",)),
    ("leaning-sticks", "smallest theta for which it does not slip", ("arctan(1/√μ)",)),
    # values before the end of the question
    ("cylinder-on-wedge", "acceleration of x with m = M for small beta", ("−βg/2",)),
)  # fmt: skip


@cache
def asked(name: str) -> Asked:
    if name == "crank":
        return Asked(load_text(CRANK, "crank.toml"))
    known, *changes = CHANGED.get(name, (name,))
    own = HERE / f"{known}.toml"
    text = (own if own.exists() else Path(find_problem(known))).read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return Asked(load_text(text, f"{known}.toml"))


@pytest.mark.parametrize(("name", "text", "told"), TOLD)
def test_it_is_told(name: str, text: str, told: tuple[str, ...] | None) -> None:
    found = answered(asked(name), text)
    assert found.verdict.is_proved, found.verdict
    assert told is None or tuple(map(to_text, found.nodes)) == told
    assert found.question.text == text


def test_conditions_that_others_leave_are_not_told() -> None:
    found = answered(asked("disk-in-oil"), "time until theta = 0 underdamped")
    assert {to_text(node) for node in found.valid} == {"θ₀ ≠ 0", "2MκR² − c² > 0"}
    found = answered(asked("rod-in-bowl"), "N_1 at the start")
    assert [to_text(node) for node in found.valid] == [
        "a √(R² − a²) sin θ₀ + (3R² − 2a²) cos θ₀ ≥ 0", "(3R² − 2a²) cos θ₀ − a √(R² − a²) sin θ₀ ≥ 0",
    ]  # fmt: skip
    found = answered(asked("drum-and-load"), "speed of y as a function of y")  # it only goes down: the string does not run out
    assert [to_text(node) for node in found.valid] == ["v₀²(mr² + I) + 2r(mgr − M_f) y ≥ 0"]


def test_a_frequency_has_the_form_of_its_square():
    """√(Ω² − g²/(R²Ω²)), as the line before tells ϑ²."""
    [found] = own_answers(study_of(load_problem(find_problem("bead-on-turning-hoop"))))
    [told] = [right for step in found.steps[:-1] for _, op, right in t.relations(step.statement) if isinstance(right, t.Add)][-1:]
    assert found.nodes == (t.Sqrt(told),)
