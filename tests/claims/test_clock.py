"""With a clock, coordinates and time are tied along the motion: a pair of them taken at will is no witness."""

from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Outcome
from rbpsym.claims.run import Certificates, check_claims

TRUE_ON_THE_MOTION = r"""
title = "Works in a truck"
source = "ours"
problem = "cylinder-in-truck"

[[claim]]
id = "mixed"
latex = '''W + W_\theta = m v^2'''
[claim.symbols]
'W' = "work of f on pipe, translational"
'W_\theta' = "work of f on pipe, rotational"
'v' = "speed of s"
"""


def test_a_true_claim_is_not_refuted_by_a_state_that_is_never_reached(tmp_path):
    path = tmp_path / "clock.toml"
    path.write_text(TRUE_ON_THE_MOTION, encoding="utf-8")
    [found] = check_claims(load_claims(path), Certificates(None))
    assert found.outcome in (Outcome.PROVED, Outcome.UNDECIDED), found
