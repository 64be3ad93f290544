"""The tutor: every line of a derivation is accepted in any order, a single slip is wrong and named, hints lead to the end."""

from __future__ import annotations

import json
import random
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.notation.latex import to_latex
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from rbpsym.studio.tutor import ACCEPTED, TRUE, UNJUSTIFIED, UNUSED, WRONG, Tutor
from rbpsym.verify.claims_check import relations
from tests.library.derived import NAMES, derived

PAPER = tuple(part.name for part in load_course(course_files()["paper"]).parts if part.kind == "problem")
OTHERS = random.Random(16).sample([name for name in NAMES if name not in PAPER], 10)


@cache
def tutor(name: str) -> Tutor:
    return Tutor(derived(name))


@pytest.mark.parametrize("name", [*PAPER, *OTHERS])
def test_every_line_is_accepted_in_three_orders(name: str) -> None:
    """Spaces are added, so that lines are read and not only recognised as texts."""
    found = tutor(name)
    lines = [to_latex(row, found.notation) for step in found.steps.values() for row in relations(step.statement)]
    for order in (lines, lines[::-1], random.Random(name).sample(lines, len(lines))):
        judged = [found.judge(line, order[:3]) for line in order]
        assert [one for one in judged if one.verdict not in ACCEPTED] == []


LINES = {
    "theta_ddot = -3*g/(4*ell)*cos(theta)": TRUE,
    r"\alpha = -\frac{3 g \cos\theta}{4 \ell}": UNJUSTIFIED,
    "omega^2 = 3*g/(2*ell)*(sin(theta_0) - sin(theta))": UNJUSTIFIED,
    "N_f = M*g - M*ell*sin(theta)*theta_dot^2 + M*ell*cos(theta)*theta_ddot + 0*g*M": UNUSED,
    "N_f - M*g = -M*ell*sin(theta)*theta_dot^2 + M*ell*cos(theta)*theta_ddot": UNUSED,
    "I = M*ell^2/3": UNUSED,
    "I = M*ell^2/12": WRONG,
    "theta_ddot = 3*g/(4*ell)*cos(theta)": WRONG,
    "theta =": "unread",
    "3*g": "unread",
    "q = 3": "unread",
    "theta_ddot = M*g": WRONG,
}


@pytest.mark.parametrize(("line", "verdict"), LINES.items())
def test_a_line_is_judged(line: str, verdict: str) -> None:
    found = tutor("sliding-ladder").judge(line)
    assert found.verdict in ((verdict,) if verdict not in (TRUE, UNJUSTIFIED) else (TRUE, UNJUSTIFIED))
    assert found.says


def test_a_slip_is_named() -> None:
    found = tutor("sliding-ladder").judge("theta_ddot = -3*g/(2*ell)*cos(theta)")
    assert found.verdict == WRONG
    assert "factor 1/2" in found.says


def test_a_result_asks_for_what_it_follows_from() -> None:
    own = tutor("sliding-ladder")
    line = r"\alpha = -\frac{3 g \cos\theta}{4 \ell}"
    step = own.judge(line).step
    reasons = [to_latex(own.steps[id].statement, own.notation) for id in own.steps[step].reasons if id in own.steps]
    assert own.judge(line).verdict == UNJUSTIFIED
    assert own.judge(line, reasons).verdict == TRUE


def test_hints_lead_to_the_end() -> None:
    own, lines = tutor("sliding-ladder"), list[str]()
    while (step := own.next_step(lines)) is not None:
        assert own.hint(lines, 1) and own.hint(lines, 3)
        lines.append(to_latex(step.statement, own.notation))
        assert len(lines) <= len(own.steps)
    assert own.record(lines)["steps"] == len(lines)


def test_in_the_terminal(tmp_path: Path) -> None:
    typed = "?\ntheta_ddot = 3*g/(4*ell)*cos(theta)\ntheta_ddot = -3*g/(4*ell)*cos(theta)\n\n"
    done = CliRunner().invoke(main, ["tutor", "sliding-ladder", "--record", str(tmp_path / "a.json")], input=typed)
    assert "wrong. sign of" in done.output
    verdicts = [row["verdict"] for row in json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))["lines"]]
    assert verdicts[0] == WRONG and verdicts[1] in (TRUE, UNJUSTIFIED)
