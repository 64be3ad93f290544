"""Numbers with units in questions: read, put in, refused."""

from __future__ import annotations

import json
import math

import pytest
import sympy
from click.testing import CliRunner

from rbpsym.ask.numbers import read_numbers
from rbpsym.cli import main
from rbpsym.errors import RbpsymError
from tests.ask.test_answers import asked

READ = [
    ("M = 2 kg", "M", 2.0),
    ("M = 2", "M", 2.0),
    ("M=500 g", "M", 0.5),
    ("M = 2 lb", "M", 0.90718474),
    ("M = 1 slug", "M", 14.59390294),
    ("ell = 2.5 ft", "ell", 0.762),
    ("ell = 10 in", "ell", 0.254),
    ("ell = 1 yd", "ell", 0.9144),
    ("theta_0 = 30 deg", "theta_0", math.pi / 6),
    ("theta_0 = 30°", "theta_0", math.pi / 6),
    ("theta_0 = 0.5 rev", "theta_0", math.pi),
    ("theta_dot = 120 rpm", "theta_dot", 4 * math.pi),
    ("theta_dot = 2 Hz", "theta_dot", 4 * math.pi),
    ("g = 32.174 ft/s^2", "g", 9.8066352),
    ("g = 981 cm/s²", "g", 9.81),
    ("F_x = 10 lbf", "F_x", 44.482216152605),
    ("F_x = 2 kN", "F_x", 2000.0),
]
REFUSED = [
    ("M", "gives no number"),
    ("M = kg", "no number for “M”"),
    ("m = 2 kg", "no letter of this problem"),
    ("M = 2 m", "does not fit “M”, which is a mass"),
    ("M = 2 kgs/foo", "is no unit"),
    ("M = -2 kg", "declared to be positive"),
    ("M = 0", "declared to be positive"),
    ("theta_0 = 3 kg", "does not fit"),
    ("theta = 10..20 deg step 7 deg", "no whole number of steps"),
    ("theta = 10..10 deg", "no whole number of steps"),
    ("theta = 10..20 deg, ell = 1..2 m step 0.5 m", "two ranges have different numbers of places"),
    ("M = 1e999 kg", "no size of a thing"),
]


@pytest.mark.parametrize(("text", "name", "size"), READ)
def test_numbers_are_read_in_si_units(text: str, name: str, size: float) -> None:
    assert read_numbers(text, asked("rod-pendulum").problem).values[name][0] == pytest.approx(size)


@pytest.mark.parametrize(("text", "told"), REFUSED)
def test_what_is_no_number_of_the_problem_is_refused(text: str, told: str) -> None:
    with pytest.raises(RbpsymError) as caught:
        read_numbers(text, asked("rod-pendulum").problem)
    assert told in str(caught.value) and caught.value.exit_code == 2


def run(*arguments: str, code: int = 0):
    found = CliRunner().invoke(main, ["ask", *arguments], standalone_mode=True)
    assert found.exit_code == code, found.output
    return found.output


def test_json_has_the_promised_keys_and_sympy_reads_the_answer() -> None:
    told = json.loads(run("sliding-ladder", "N_w at the start", "--json", "--with", "example"))
    assert {"question", "answer", "latex", "verdict", "valid_where", "steps", "symbols", "value", "unit"} <= told.keys()
    numbers = {"M": 10, "g": 9.81, "theta_0": math.radians(70)}
    assert told["value"] == pytest.approx(float(sympy.sympify(told["answer"]).subs(numbers))) and told["unit"] == "N"
    assert told["verdict"] == "PROVED" and told["steps"]


def test_several_questions_give_a_list_and_a_range_a_table() -> None:
    told = json.loads(run("sliding-ladder", "N_w", "N_f", "--json", "--with", "example, theta = 50..70 deg step 5 deg"))
    assert [len(each["table"]) for each in told] == [5, 5]
    assert told[0]["table"][-1]["theta"] == pytest.approx(math.radians(70))


def test_a_question_without_an_answer_leaves_the_others_theirs() -> None:
    questions = ("N_w at the start", "N_q at the start", "N_f at the start")
    told = json.loads(run("sliding-ladder", *questions, "--json", code=2))
    assert ["error" in each for each in told] == [False, True, False]
    assert [each["verdict"] for each in told] == ["PROVED", "UNDECIDED", "PROVED"] and "N_q" in told[1]["error"]
    assert told[1]["error"].splitlines()[0] in run("sliding-ladder", *questions, code=2)


def test_what_has_no_closed_form_is_integrated_and_that_is_said() -> None:
    given = "ell = 1.5 m, g = 9.81 m/s^2, theta_0 = 5 deg, M = 1 kg"
    told = json.loads(run("rod-pendulum", "time until theta = pi/72", "--json", "--with", given, code=1))
    assert told["answer"] is None and told["verdict"] == "UNDECIDED" and told["unit"] == "s"
    modulus, here = (sympy.sin(math.radians(angle) / 2) for angle in (5, 2.5))
    gone = sympy.elliptic_k(modulus**2) - sympy.elliptic_f(sympy.asin(here / modulus), modulus**2)
    assert told["value"] == pytest.approx(float(gone) / math.sqrt(3 * 9.81 / (2 * 1.5)), rel=1e-8)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("M = 10 kg", "a number is missing for g (acceleration)"),
        ("example, theta_0 = 20 deg", "needs"),
        ("example, theta_0 = 100 deg", "contradicts the statement"),
    ],
)
def test_numbers_that_do_not_fit_are_told(given: str, told: str) -> None:
    found = CliRunner().invoke(main, ["ask", "sliding-ladder", "N_w where theta = pi/6", "--with", given])
    assert found.exit_code == 2 and told in found.output


def test_a_file_holds_its_own_questions(tmp_path) -> None:
    text = _silent() + '\n[[ask]]\nquestion = "F_y in equilibrium"\n'
    file = tmp_path / "asked.toml"
    file.write_text(text, encoding="utf-8")
    assert json.loads(run(str(file), "--json"))["answer"] == "M*g"


def _silent() -> str:
    """The text of a problem without its questions."""
    return asked("rod-pendulum").problem.text.partition("[[ask]]")[0]


def test_a_problem_without_questions_says_so(tmp_path) -> None:
    file = tmp_path / "silent.toml"
    file.write_text(_silent(), encoding="utf-8")
    assert "nothing is asked about" in run(str(file), code=2)
