"""Answers to questions, asked of Rocq: certified, or with another mark and the reason."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from rbpsym.ask.asked import Asked
from rbpsym.ask.asking import answered
from rbpsym.ask.found import Answer
from rbpsym.cli import main
from rbpsym.commands.certify import report_on_answer
from rbpsym.expr import tree as t
from rbpsym.frozen import replace
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.kernel.test_certify import needs_coqc

CERTIFIED = ("theta_ddot at the start", "N_w at the start", "N_w as a function of theta")


def answer(question: str) -> Answer:
    return answered(Asked(load_problem(problem_files()["sliding-ladder"])), question)


def told(*words: str) -> str:
    return CliRunner().invoke(main, ["ask", "sliding-ladder", *words], standalone_mode=False).output


@needs_coqc
@pytest.mark.parametrize("question", CERTIFIED)
def test_a_value_is_certified_and_twice_the_value_is_not(question: str) -> None:
    right = answer(question)
    assert report_on_answer(right).is_whole
    own = right.derivations[-1]
    last = own.steps[-1]
    assert last.id == "answer" and isinstance(last.statement, t.Chain)
    left, *_, value = last.statement.items
    wrong = replace(last, statement=t.Chain((left, t.Mul((t.TWO, value))), ("=",)))
    spoilt = replace(own, steps=(*own.steps[:-1], wrong))
    assert "answer" in report_on_answer(replace(right, steps=spoilt.steps, derivations=(spoilt,))).refused


@needs_coqc
def test_what_is_not_certified_has_another_mark_than_a_check() -> None:
    """What is concluded has no lemma; and without the option nothing is asked."""
    assert "✓" in told("theta_ddot at the start", "--certified")
    question = "is N_w at the start > 0"
    assert "○" not in told(question)
    shown = told(question, "--certified")
    assert "○" in shown and "✓" not in shown and "has no words yet" in shown
    record = json.loads(told(question, "--certified", "--json"))
    assert record["verdict"] == "PROVED" and record["certified"]["not_certified"]


def test_without_coqc_nothing_is_certified(monkeypatch) -> None:
    monkeypatch.setattr("rbpsym.kernel.coqc.has_coqc", lambda: False)
    shown = told("theta_ddot at the start", "--certified")
    assert "✓" not in shown and "there is no coqc" in shown
