"""Errors of one token are caught, and nearly all are repaired in the author's own LaTeX."""

import random
from collections import Counter

import pytest

from rbpsym.claims.check import Checker
from rbpsym.claims.diagnosis import diagnosis
from rbpsym.claims.diagnosis_edits import corrected
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome, Printed
from rbpsym.claims.run import Worlds
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.frozen import replace
from rbpsym.statement.library import library_folder
from tests.claims.errata import run
from tests.claims.injected import injected

FOLDER = library_folder() / "claims"
FILES = ("atwood-with-massive-pulley", "ball-on-incline", "disk-on-moving-plank", "rod-with-spring", "yo-yo", "rod-pendulum")
COUNT = 40
SEEN = (Outcome.REFUTED, Outcome.UNDECIDED, Outcome.PROVED)


def drawn(seed):
    """Claims with an error each, drawn from all of them."""
    rows = []
    for name in FILES:
        file, checker = load_claims(FOLDER / f"{name}.toml"), Checker(Worlds(FOLDER), diagnosis)
        for claim in file.claims:
            if claim.expect == "proved" and claim.printed and "=" in claim.printed.latex:
                letters = [symbol for symbol in claim.setting.symbols if len(symbol) < 7 and r"\vec" not in symbol]
                rows += [(checker, claim, kind, latex) for kind, latex in injected(claim.printed.latex, letters[:5])]
    random.Random(seed).shuffle(rows)
    return rows


def test_errors_of_one_token_are_caught_and_repaired():
    counts, left = Counter(), []
    for checker, claim, kind, latex in drawn(3):
        if counts["tried"] == COUNT:
            break
        try:
            found = checker.check(claim, Printed(latex))
        except RbpsymError:
            continue
        if found.outcome not in SEEN:
            continue
        counts["tried"] += 1
        counts[found.outcome] += 1
        if found.outcome is Outcome.REFUTED:
            counts["repaired"] += bool(found.fix)
            left += [] if found.fix else [(kind, latex, found.diagnosis)]
            again = checker.check(claim, Printed(found.fix)) if found.fix else None
            assert again is None or found.links[0].outcome is not Outcome.REFUTED or again.links[0].outcome is Outcome.PROVED
    assert counts["tried"] == COUNT and counts[Outcome.UNDECIDED] <= 1, counts
    assert counts[Outcome.PROVED] <= 1, counts  # an error that leaves the formula true is none
    assert counts["repaired"] >= 0.85 * counts[Outcome.REFUTED], left


LOST = [  # a claims file, a claim, what is printed, and the repair
    ("block-on-table", "acceleration", r"a = \frac{m_2 g}{m_1 +\frac{1}{2}M}", r"a = \frac{m_2 g}{m_1 +\frac{1}{2}M + m_2}"),
    ("spool-on-rails", "acceleration", r"a = \frac{g\sin\theta}{1 }", r"a = \frac{g\sin\theta}{1 + \frac{k^2}{r^2}}"),
    ("cylinder-in-rolling-pipe", "rolling", r"r\dot\psi = -v-(R )\dot\theta", r"r\dot\psi = -v-(R - r)\dot\theta"),
    ("ball-and-hinged-rod", "spin", r"\omega = \frac{(1) m v_0 b}{I + m b^2}", r"\omega = \frac{(1 + e) m v_0 b}{I + m b^2}"),
    ("braking-wheel", "friction", r"F = -\frac{m B}{I + m r^2}", r"F = -\frac{m B r}{I + m r^2}"),
    ("scotch-yoke", "motion", r"(I+MR^2\sin\theta)\alpha = T-MR^2\omega^2\sin\theta\cos\theta",
     r"(I+MR^2\sin^2\theta)\alpha = T-MR^2\omega^2\sin\theta\cos\theta"),
    ("rod-dropped-on-rough-floor", "energy", r"\Delta K = \frac{M v^2}{8} (1 + 3 \cos^2\beta)",
     r"\Delta K = \frac{M v^2}{8} (1 + 3 \sin^2\beta)"),
    ("ring-with-bob", "energy-integral", r"\theta^2 = \frac{g}{R}(\cos\theta - \cos\theta_0)",
     r"\dot{\theta}^2 = \frac{g}{R}(\cos\theta - \cos\theta_0)"),
    ("spool-on-rails", "acceleration", r"a = \frac{gg\sin\theta}{1 + \frac{k^2}{r^2}}",
     r"a = \frac{g\sin\theta}{1 + \frac{k^2}{r^2}}"),
    ("block-on-table", "acceleration", r"a = \frac{m_2 g}{m_1 +\frac{1}{22}M + m_2}",
     r"a = \frac{m_2 g}{m_1 +\frac{1}{2}M + m_2}"),
    ("scotch-yoke", "motion", r"(I+MR^2\sin^2\theta)\alpha = -MR^2\omega^2\sin\theta\cos\theta",
     r"(I+MR^2\sin^2\theta)\alpha = T-MR^2\omega^2\sin\theta\cos\theta"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "claimed", "latex", "repair"), LOST, ids=[f"{row[0]}: {row[2]}" for row in LOST])
def test_what_is_lost_is_put_where_it_stood(name, claimed, latex, repair):
    (claim,) = [claim for claim in load_claims(FOLDER / f"{name}.toml").claims if claim.id == claimed]
    found = Checker(Worlds(FOLDER), diagnosis).check(claim, Printed(latex))
    assert found.outcome is Outcome.REFUTED and "".join(found.fix.split()) == "".join(repair.split())


@pytest.mark.thorough
def test_errata_of_all_that_ships():
    said = []
    assert run(300, 1, said.append), said


X, Y = t.Sym("x", span=(4, 5)), t.Sym("y", span=(8, 9))
SUM = t.Chain((t.Sym("a", span=(0, 1)), t.Add((X, Y), span=(4, 9))), ("=",))


@pytest.mark.parametrize(
    ("repaired", "text"),
    [
        (t.Add((X, t.Neg(Y))), "a = x - y"),
        (t.Add((t.Neg(X), Y)), "a = -x + y"),
        (t.Add((X, t.Sym("z"))), r"a = x + \zeta"),
        (t.Add((X, t.Pow(Y, t.TWO))), "a = x + y^2"),
        (X, "a = x"),
    ],
)  # fmt: skip
def test_what_is_not_changed_stays_as_it_is_printed(repaired, text):
    new = t.Chain((SUM.items[0], repaired), ("=",))
    assert corrected("a = x + y", SUM, new, {"z": r"\zeta", "x": "x", "y": "y"}).replace("\\zeta ", "\\zeta") == text


@pytest.mark.parametrize(("over", "under", "text"), [("1", "z", r"a = \frac1{z + 2}x"), ("z", "2", r"a = \frac{1 + z}2x")])
def test_what_a_fraction_takes_without_braces_gets_them(over, under, text):
    one, two, x = replace(t.ONE, span=(9, 10)), replace(t.TWO, span=(10, 11)), t.Sym("x", span=(11, 12))
    half, grown = t.Div(one, two, span=(4, 11)), t.Div(t.Add((one, t.Sym("z"))) if over == "z" else one, two)
    grown = grown if under == "2" else t.Div(one, t.Add((t.Sym("z"), two)))
    old, new = (t.Chain((SUM.items[0], t.Mul((part, x), span=(4, 12))), ("=",)) for part in (half, grown))
    assert corrected(r"a = \frac12x", old, new, {"z": "z", "x": "x"}) == text
