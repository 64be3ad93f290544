"""`rbpsym derive NAME --why STEP` tells what the verdict of each step rests on."""

from __future__ import annotations

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.commands.derive import document_of
from rbpsym.commands.why import readings, why
from tests.library.derived import derived

NAMES = ("sliding-ladder", "ball-slipping-to-rolling", "rod-with-damper")


@pytest.mark.parametrize("name", NAMES)
def test_every_step_is_traced_to_its_premises(name: str) -> None:
    derivation = derived(name)
    document = document_of(derivation, "full", "all", "en")
    for _, prefix, steps in readings(derivation):
        for step in steps.values():
            told = list(why(derivation, prefix + step.id, document, "en"))
            rest = [line.split()[0] for line in told if line.startswith("    ")]
            assert rest == [*step.premises, *step.cites], step.id
            assert sum(line.startswith("  needs ") for line in told) == len(step.certificate.verdict.obligations)


def test_a_number_leads_to_the_same_lines() -> None:
    run = [CliRunner().invoke(main, ["derive", "sliding-ladder", "--why", word]).output for word in ("(8)", "motion.theta")]
    shown = [[line.split(" in ")[0] for line in output.splitlines()] for output in run]
    assert shown[0] == shown[1] and "balance.ladder (7)" in run[0]


@pytest.mark.parametrize("wrong", ["99", "motion.thta", "phase2.motion.theta"])
def test_what_is_no_step_gets_a_sentence(wrong: str) -> None:
    found = CliRunner().invoke(main, ["derive", "sliding-ladder", "--why", wrong])
    assert found.exit_code == 2 and f"“{wrong}” is neither a number nor a step" in found.output
