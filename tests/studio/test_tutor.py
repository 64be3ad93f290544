"""The tutor: every line of a derivation is accepted in any order, a single slip is wrong and named, hints lead to the end."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from click.testing import CliRunner

from rbpsym.claims.check import relations
from rbpsym.cli import main
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import Notation
from rbpsym.expr.places import put, sites
from rbpsym.languages import languages, phrases
from rbpsym.statement.course import load_course
from rbpsym.statement.library import course_files
from rbpsym.studio.sheet import PhaseSheet
from rbpsym.studio.tutor import ACCEPTED, NARRATES, TELLS, TRUE, UNDECIDED, UNJUSTIFIED, UNUSED, WRONG, Tutor
from rbpsym.typeset.latex import to_latex
from tests.library.derived import NAMES, derived

PAPER = tuple(part.name for part in load_course(course_files()["paper"]).parts if part.kind == "problem")
OTHERS = random.Random(16).sample([name for name in NAMES if name not in PAPER], 10)


@cache
def tutor(name: str) -> Tutor:
    return Tutor(derived(name))


def turned(row: t.Chain, notation: Notation) -> str:
    """An equation with its sides exchanged, as another hand writes it: no printed line of the derivation is that text."""
    other = t.Chain(tuple(reversed(row.items)), row.ops) if set(row.ops) == {"="} else row
    text = to_latex(other, notation)
    for printed, typed in ((r"\frac", r"\dfrac"), (r"\left(", "("), (r"\right)", ")"), (r"\,", " ")):
        text = text.replace(printed, typed)
    return text


@pytest.mark.parametrize("name", [*PAPER, *OTHERS])
def test_every_line_is_accepted_in_three_orders(name: str) -> None:
    """Each is read and decided: with its sides exchanged it is the text of no step."""
    found = tutor(name)
    rows = [(sheet, row) for sheet in found.sheets.values() for step in sheet.steps.values() for row in relations(step.statement)]
    lines = [turned(row, sheet.notation) for sheet, row in rows if row.items[0] != row.items[-1]]
    for order in (lines, lines[::-1], random.Random(name).sample(lines, len(lines))):
        judged = [found.judge(line, order[:3]) for line in order]
        assert [one for one in judged if one.verdict not in ACCEPTED] == []


def test_lines_are_judged_where_only_the_start_is_known() -> None:
    """A line that is a multiple of a step was answered with an error of the mechanics."""
    own = tutor("four-bar-linkage")
    assert {own.judge(turned(row, sheet.notation)).verdict for sheet, row in rows_of(own)} <= ACCEPTED


def slips(row: t.Chain) -> Iterator[t.Chain]:
    """The equation with one slip: a sign, a number, an exponent, a function, a term that is lost."""
    for path, node in sites(row):
        if not path or any(name in ("lower", "upper", "exponent") for name, _ in path):
            continue
        if isinstance(node, t.Fn) and node.name in ("sin", "cos"):
            yield put(row, path, replace(node, name="cos" if node.name == "sin" else "sin"))
        elif isinstance(node, t.Add):
            yield put(row, path, replace(node, terms=(*node.terms[:-1], t.Neg(node.terms[-1]))))
            yield put(row, path, node.terms[0] if len(node.terms) == 2 else replace(node, terms=node.terms[:-1]))
        elif isinstance(node, t.Num) and isinstance(node.value, int) and node.value > 1:
            yield put(row, path, t.Num(node.value + 1))
        elif isinstance(node, t.Pow) and node.exponent == t.Num(2):
            yield put(row, path, node.base)


def rows_of(own: Tutor) -> Iterator[tuple[PhaseSheet, t.Chain]]:
    """Each relation of each step, with its phase; none that says that a thing is itself."""
    for sheet in own.sheets.values():
        for step in sheet.steps.values():
            yield from ((sheet, row) for row in relations(step.statement) if row.items[0] != row.items[-1])


def check_true_lines_are_never_refuted(name: str) -> None:
    """What refutes lines refutes no relation of a step, although it does not know the steps' text."""
    bad = [sheet.line(row) for sheet, row in rows_of(tutor(name)) if sheet.refutation(row).is_refuted]
    assert bad == [], name


def slips_named(name: str, most: int) -> tuple[int, int, int]:
    """(slips that make a line false, of these: named, WRONG)."""
    own, rng, said = tutor(name), random.Random(16), []
    for sheet, row in rows_of(own):
        changed = list(slips(row)) if set(row.ops) == {"="} else []
        said += [own.judge(to_latex(wrong, sheet.notation)) for wrong in rng.sample(changed, min(most, len(changed)))]
    false = [one for one in said if one.verdict not in ACCEPTED]  # else it is as true as before: 0 = −0
    named = [one for one in false if not one.says.startswith(UNNAMED)]
    return len(false), len(named), sum(one.verdict == WRONG for one in false)


UNNAMED = ("It does not hold", "Right are", "It could not be decided")
SLICE = random.Random(2026).sample(NAMES, 12)


@pytest.mark.parametrize("name", SLICE)
def test_true_lines_are_never_refuted(name: str) -> None:
    check_true_lines_are_never_refuted(name)


def test_slips_are_named_and_most_are_wrong() -> None:
    """95 % of the single slips that make a line false are named, and nine of ten are refuted on the motion."""
    found = [slips_named(name, 2) for name in ("sliding-ladder", *OTHERS[:2])]
    false, named, wrong = (sum(each) for each in zip(*found, strict=True))
    assert false > 100
    assert named >= 0.95 * false
    assert wrong >= 0.85 * false


@pytest.mark.thorough
def test_the_whole_library() -> None:
    """No true line of any problem is refuted; 95 % of all single slips are named."""
    found = []
    for name in NAMES:
        check_true_lines_are_never_refuted(name)
        found.append(slips_named(name, 1))
    false, named, wrong = (sum(each) for each in zip(*found, strict=True))
    assert named >= 0.95 * false
    assert wrong >= 0.85 * false


def test_a_line_for_a_moment_is_not_wrong() -> None:
    """What holds where the contact ends, or in a rest, is not refuted by the rest of the motion; a slip of it is."""
    own = tutor("sliding-ladder")
    assert own.judge("3*sin(theta) = 2*sin(theta_0)").verdict in (*ACCEPTED, UNDECIDED)
    assert own.judge("3*sin(theta)^2 = 2*sin(theta_0)*sin(theta)").verdict in (*ACCEPTED, UNDECIDED)
    assert own.judge("3*sin(theta) = sin(theta_0)").verdict == WRONG
    hoop = tutor("bead-on-turning-hoop")
    assert hoop.judge("R*Omega^2*cos(theta) = g").verdict in (*ACCEPTED, UNDECIDED)
    assert hoop.judge("R*Omega^2*cos(theta) = 2*g").verdict == WRONG


FALSE = {  # one side of each is a side of a step; the other is what it is not, has no value of its own, or is so at a rest alone
    "hoop-on-its-rim": (
        r"\vec{R}_{\mathrm{cm}} \times \vec{P}_{\mathrm{cm}} = (M R^2 \omega + M R^2 \omega) \, \hat{k}",
        r"M R^2 \omega \, \hat{k} = I_O \vec{\omega}_{\mathrm{hoop}}",
    ),
    "ball-off-sphere": (
        r"\tau_{O,W} = -m g (a - R) \sin\theta", r"\vec{V}_{\mathrm{cm}} = (a + R)^2 \omega^2", r"\phi = \theta",
    ),
    "rod-pendulum": (r"\int_{\mathrm{rod}} r \, dm = \frac{M}{\ell} \int_0^{\ell} \left( s - \frac{\ell}{2} \right)^2 \, ds",),
}  # fmt: skip


@pytest.mark.parametrize("name", FALSE)
def test_a_false_line_is_not_true_by_its_other_side(name: str) -> None:
    assert [line for line in FALSE[name] if tutor(name).judge(line).verdict in ACCEPTED] == []


def test_a_factor_in_brackets_is_no_unit() -> None:
    """“v [m a - F]” at the end of a line was read as “v”, in a unit."""
    assert tutor("rear-wheel-drive").judge("0 = v [m a - F]").verdict in ACCEPTED


def test_an_inequality_is_not_proved_by_equal_rates() -> None:
    assert tutor("sliding-ladder").judge(r"\ddot{\theta} > -\frac{3 g}{4 \ell}\cos\theta").verdict not in ACCEPTED


LINES = {
    "theta_ddot = -3*g/(4*ell)*cos(theta)": TRUE,
    r"\alpha = -\frac{3 g \cos\theta}{4 \ell}": UNJUSTIFIED,
    "omega^2 = 3*g/(2*ell)*(sin(theta_0) - sin(theta))": UNJUSTIFIED,
    "N_f = M*g - M*ell*sin(theta)*theta_dot^2 + M*ell*cos(theta)*theta_ddot + 0*g*M": TRUE,
    "N_f - M*g = -M*ell*sin(theta)*theta_dot^2 + M*ell*cos(theta)*theta_ddot": TRUE,
    "I = M*ell^2/3": TRUE,
    "I = M*ell^2/12": WRONG,
    "theta_ddot = 3*g/(4*ell)*cos(theta)": WRONG,
    "theta =": "unread",
    "3*g": "unread",
    "q = 3": "unread",
    "theta_ddot = M*g": WRONG,
    "omega = -sqrt(3*g/(2*ell)*(sin(theta_0) - sin(theta)))": "true, not used",  # as far as the motion goes from its start
    "omega = sqrt(3*g/(2*ell)*(sin(theta_0) - sin(theta)))": UNDECIDED,
    "N_w = M x_cm_ddot": TRUE,
    "N_f - M g = M d^2y_cm/dt^2": TRUE,
    "alpha = -3g/(4l) cos theta": TRUE,  # L is the angular momentum there, l the length
    "z = ell cos(theta)": "unread",
    "F = m*a": TRUE,
    r"\tau = I\alpha": TRUE,
    "tau = -I*alpha": TRUE,  # counter-clockwise, while the angle grows clockwise
    "tau_cm = 2*I*alpha": WRONG,
    "N_w = M*a_y": WRONG,
    "dL/dt = tau": TRUE,
    "U = M*g*y": TRUE,
    "v = ell*omega": UNUSED,
}


@pytest.mark.parametrize(("line", "verdict"), LINES.items())
def test_a_line_is_judged(line: str, verdict: str) -> None:
    found = tutor("sliding-ladder").judge(line)
    assert found.verdict in ((verdict,) if verdict not in (TRUE, UNJUSTIFIED) else (TRUE, UNJUSTIFIED))
    assert found.says


def test_a_slip_is_named() -> None:
    found = tutor("sliding-ladder").judge("theta_ddot = -3*g/(2*ell)*cos(theta)")
    assert found.verdict == WRONG
    assert "is 2 times what it should be" in found.says


def test_what_cannot_be_read_or_decided_is_told_to_a_student() -> None:
    """The letters of the statement and not sixty; the sign that is wrong; no word of the program's."""
    own = tutor("sliding-ladder")
    unread, open_ = own.judge("q = 2*g").says, own.judge("omega = sqrt(3*g/(2*ell)*(sin(theta_0) - sin(theta)))").says
    assert "“q”" in unread and "theta_0" in unread and len(unread) < 120 and "input:" not in unread
    assert "sign of" in open_ and "division" not in open_


def test_a_result_asks_for_what_it_follows_from() -> None:
    own = tutor("sliding-ladder")
    line = r"\alpha = -\frac{3 g \cos\theta}{4 \ell}"
    step = own.judge(line).step
    reasons = [to_latex(own.steps[id].statement, own.notation) for id in own.steps[step].reasons if id in own.steps]
    assert own.judge(line).verdict == UNJUSTIFIED
    assert own.judge(line, reasons).verdict == TRUE


@pytest.mark.parametrize(
    ("name", "line", "is_so"),
    [("rod-pendulum", "I = M*ell^2/3", True), ("rod-pendulum", "I = M*ell^2/12", True), ("rod-pendulum", "I = M*ell^2/2", False),
     ("rod-pendulum", "I*theta_ddot = -M*g*ell/2*sin(theta)", True), ("sliding-ladder", "K + U = M*g*ell*sin(theta_0)", True),
     ("sliding-ladder", "K + U = M*g*ell*cos(theta_0)", False)],
)  # fmt: skip
def test_letters_that_nobody_told_are_read_as_students_mean_them(name: str, line: str, is_so: bool) -> None:
    """I of the only body is that about its centre of mass or about where it is held; U is the only potential energy."""
    judged = tutor(name).judge(line)
    assert (judged.verdict in ACCEPTED) is is_so and (is_so or judged.verdict == WRONG)
    assert "I_O" in tutor("rod-pendulum").letters


def test_what_untold_letters_mean_is_told() -> None:
    assert tutor("sliding-ladder").judge("M*a_x = N_w").says.endswith("Meant: a (ladder, along x).")
    assert (
        "2 times" in tutor("rod-pendulum").judge("tau = -M*g*ell*sin(theta)").says
    )  # about O; about cm it would be another torque
    assert tutor("disk-on-incline").judge("tau = f*R").says.endswith("Meant: τ (drum, about cm, clockwise).")


@pytest.mark.parametrize(
    ("line", "verdict", "says"),
    [("v = omega*ell", WRONG, "ωℓ is 2 times"), ("K = 1/2*M*v^2", WRONG, "3/4 times"), ("F_x = 3*M*g", WRONG, "does not hold"),
     ("omega = sqrt(3*g*(cos(theta) - cos(theta_0))/ell)", WRONG, "sign of the root"),
     ("omega = -sqrt(6*g*(cos(theta) - cos(theta_0))/ell)", WRONG, "2 times"),
     ("a_cm = ell/2 alpha", UNUSED, "Meant: a_cm = (ℓ/2)α."), ("tau = -M g ell/2 sin(theta)", TRUE, "(Mgℓ/2) sin θ."),
     ("omega^2 = 6 g/ell (cos theta - cos theta_0)", WRONG, "2 times"), ("v = g/ell alpha", WRONG, "does not hold")],
)  # fmt: skip
def test_what_students_write_of_a_pendulum(line: str, verdict: str, says: str) -> None:
    """A speed is followed from a start at rest; of what can be read in two ways the true one is meant; no answer is told."""
    judged = tutor("rod-pendulum").judge(line)
    assert judged.verdict == verdict and says in judged.says


@pytest.mark.parametrize(
    ("name", "line", "verdict", "says"),
    [("rod-pendulum", "T = 2 pi sqrt(2 ell/(3 g))", TRUE, "of θ"), ("rod-pendulum", "T = 2 pi sqrt(ell/g)", WRONG, "not hold"),
     ("ball-slipping-to-rolling", "t = 2 v_0/(7 mu g)", TRUE, "an answer"),
     ("ball-slipping-to-rolling", "t = 2 v_0/(5 mu g)", WRONG, "7/5"), ("ball-slipping-to-rolling", "f = -mu N", TRUE, "along x"),
     ("ball-slipping-to-rolling", "f = mu M g", UNUSED, "its magnitude"),
     ("ball-slipping-to-rolling", "f = mu^2 N", WRONG, "not hold")],
)  # fmt: skip
def test_letters_of_what_is_asked_and_of_friction_are_read(name: str, line: str, verdict: str, says: str) -> None:
    judged = tutor(name).judge(line)
    assert judged.verdict == verdict and says in judged.says


@pytest.mark.parametrize("name", ["brake-drum", *SLICE])
def test_hints_lead_to_the_end(name: str) -> None:
    """What a hint tells is done when it is written, although another phase or step is printed so; a hint is no fragment."""
    own, lines = tutor(name), list[str]()
    while (step := own.next_step(lines)) is not None:
        said, line = own.hint(lines, 1)[0], own.hint(lines, 3)[1]
        assert not re.match("[a-z]{2}", said) and said[-1] in ".…" and line
        lines.append(line)
        assert step is not own.next_step(lines)
        assert len(lines) <= len(own.steps)


@pytest.mark.parametrize("form", ["2 {0} = 2 {1}", r"\frac{{{0}}}{{3}} = \frac{{{1}}}{{3}}", "-{0} = -{1}", "{0} - {1} = 0"])
def test_a_multiple_of_a_work_is_that_of_its_integral(form: str) -> None:
    """Twice a work was not zero at the start, and a true line was called wrong."""
    work, integral = r"\mathcal{W}_{\theta,S}", r"\int\tau_{\mathrm{cm},S} \, d\varphi_{\mathrm{disk}}"
    assert tutor("torsion-pendulum").judge(form.format(work, integral)).verdict == UNUSED


@pytest.mark.parametrize("end", ["\n", ""])
def test_in_the_terminal(end: str, tmp_path: Path) -> None:
    """An empty line or the end of input ends; the record is written in both cases."""
    typed = "?\ntheta_ddot = 3*g/(4*ell)*cos(theta)\ntheta_ddot = -3*g/(4*ell)*cos(theta)\n" + end
    done = CliRunner().invoke(main, ["tutor", "sliding-ladder", "--record", str(tmp_path / "a.json")], input=typed)
    assert "wrong. The sign of" in done.output
    verdicts = [row["verdict"] for row in json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))["lines"]]
    assert verdicts[0] == WRONG and verdicts[1] in (TRUE, UNJUSTIFIED)


# --- what its sentences assert


@pytest.mark.parametrize("language", languages())
def test_each_sentence_asserts_with_a_verdict_or_narrates(language):
    """No third kind: what asserts something of a line is said with the verdict that says so."""
    heads = {key.split(".")[1] for key in phrases(language) if key.startswith("tutor.")}
    assert heads == TELLS.keys() | NARRATES and not TELLS.keys() & NARRATES


def test_a_sentence_is_not_said_with_another_verdict():
    with pytest.raises(ValueError, match="is not said of what is undecided"):
        tutor("rod-pendulum")._told(UNDECIDED, "wrong")
