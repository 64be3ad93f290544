"""The general theory in the words of Rocq: each step from what its text takes for granted, and a body for which that holds."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache

import pytest
from click.testing import CliRunner

from rbpsym.chapters.theory import plane_motion
from rbpsym.cli import main
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.kernel.coqc import AXIOMS, BODY, MODEL, with_prelude
from rbpsym.kernel.rocq import REFUSED
from rbpsym.kernel.theory import ShownClaim, Theory
from tests.kernel.test_certify import needs_coqc

SPOILT = {  # the lemma, what is wrong with it, and with what
    "linear'1": ("(M * ", "(2 * M * "), "euler'2": ("= (I_cm", "= (- I_cm"), "energy'2": ("(1 / 2) * I_cm", "I_cm"),
    "steiner'1": ("(I_cm + ", "(- I_cm + "), "ideal_pivot'1": ("(cal_w_T t) + ", "(cal_w_T t) + - "),
    "torque'1": ("alpha", "omega"),
}  # fmt: skip
TAKEN = {  # and premises that are left out
    "conserved'2": "conserved'w1", "fixed_momentum'2": "steiner'1", "angular_momentum'2": "moments'", "euler'2": "torque_sum'",
}  # fmt: skip


@cache
def theory() -> Theory:
    return Theory(plane_motion())


def only(lemmas: list[ShownClaim], claims: dict[str, str] | None = None) -> Theory:
    """The theory with these lemmas alone."""
    found = Theory(plane_motion())
    found.claims |= claims or {}
    found.lemmas = {lemma.name: [lemma] for lemma in lemmas}
    return found


def test_every_step_is_written_and_nothing_is_assumed_but_as_a_premise() -> None:
    body = theory().text()
    assert all(theory().lemmas.values()) and len(theory().lemmas) == len(plane_motion().steps)
    files = (body, *(path.read_text(encoding="utf-8") for path in (BODY, MODEL)))
    assert not any(re.search(r"\b(Admitted|Axiom|Parameter|admit|Conjecture|Hypothesis)\b", text) for text in files)
    for step in plane_motion().steps:
        allowed = {step.id, *step.premises}
        for lemma in theory().lemmas[step.id]:
            assert {re.split(r"'[wd]?\d+$", premise)[0] for premise in lemma.premises} <= allowed, lemma.name


def test_what_does_not_read_as_its_tree_is_not_written() -> None:
    found = Theory(plane_motion())
    found.terms = replace(found.terms, time="u")
    with pytest.raises(RbpsymError, match="does not read"):
        [*found._named("wrong.", [(t.Vec("L"), t.BodyIntegral(t.Cross(t.Vec("r"), t.Vec("v_prime"))))])]


@needs_coqc
@pytest.mark.heavy(of=4)
@pytest.mark.parametrize("quarter", range(4))
def test_coqc_accepts_every_step_and_a_body_of_particles(quarter: int) -> None:
    lemmas = [lemma for each in theory().lemmas.values() for lemma in each][quarter::4]
    [done] = with_prelude([only(lemmas).text()])
    assert not done.returncode, done.stderr[-400:]
    assert {*re.findall(r"^([\w.']+)\s*:", done.stdout.partition("Axioms:")[2], re.MULTILINE)} <= AXIOMS


@needs_coqc
def test_coqc_refuses_what_is_spoilt() -> None:
    own = {lemma.name: lemma for each in theory().lemmas.values() for lemma in each}
    claims, lemmas = {}, []
    for name, (right, wrong) in SPOILT.items():
        assert right in theory().claims[name], name
        claims[f"{name}'spoilt"] = theory().claims[name].replace(right, wrong)
        lemmas.append(replace(own[name], name=f"{name}'spoilt"))
    for name, gone in TAKEN.items():
        kept = tuple(premise for premise in own[name].premises if not premise.startswith(gone))
        assert len(kept) < len(own[name].premises), name
        claims[f"{name}'less"] = theory().claims[name]
        lemmas.append(ShownClaim(f"{name}'less", kept))
    [done] = with_prelude([only(lemmas, claims).text(trial=True)])
    assert {*re.findall(rf"^{REFUSED}(\S+)", done.stdout, re.MULTILINE)} == {lemma.name for lemma in lemmas}, done.stderr[-400:]


def test_the_command_writes_the_theory_and_what_it_stands_on(tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.kernel.coqc.has_coqc", lambda: False)
    done = CliRunner().invoke(main, ["certify", "theory", "-o", str(tmp_path)], standalone_mode=False)
    assert {path.name for path in tmp_path.iterdir()} == {"Prelude.v", "Body.v", "Particles.v", "theory.v"}
    assert "of 32 steps written as 50 lemmas" in done.output
