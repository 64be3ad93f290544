"""The public functions: names, files and texts are opened, what fits nowhere is told in a sentence."""

from __future__ import annotations

import datetime
import pickle

import pytest
import sympy

import rbpsym
from rbpsym.errors import RbpsymError
from rbpsym.expr.tree import Sym
from rbpsym.mechanics.study import Study
from rbpsym.statement.library import problem_files

NAME = "rod-pendulum"
WRONG = [3, None, 2.5, ["x"], {"a": 1}, object(), sympy.Symbol("x"), datetime.date(2020, 1, 1), b"rod-pendulum"]
TAKE_A_PROBLEM = ("solve", "derive", "notes", "load_problem")


def test_a_name_of_the_library_is_a_problem() -> None:
    problem = rbpsym.load_problem(NAME)
    assert problem == rbpsym.load_problem(problem_files()[NAME])
    assert rbpsym.solve(NAME, simulation=False) == rbpsym.solve(problem, simulation=False)
    assert rbpsym.derive(NAME, simulation=False).summary()["proved"] == rbpsym.derive(problem).summary()["proved"]
    assert rbpsym.derive(str(problem_files()[NAME])).summary() == rbpsym.derive(problem).summary()
    assert rbpsym.notes(NAME).title
    assert rbpsym.compiled_accelerations(NAME, {"M": 1.0, "ell": 1.0, "g": 9.81, "m": 1.0})
    assert rbpsym.load_course("rigid-bodies" if "rigid-bodies" in _courses() else _courses()[0]).parts


def test_the_mechanics_of_a_problem_stand_for_it() -> None:
    study = Study(rbpsym.load_problem(NAME))
    assert rbpsym.derive(study, simulation=False).summary() == rbpsym.derive(NAME, simulation=False).summary()


def _courses() -> list[str]:
    from rbpsym.statement.library import course_files

    return list(course_files())


@pytest.mark.parametrize("name", TAKE_A_PROBLEM)
@pytest.mark.parametrize("value", WRONG, ids=lambda value: type(value).__name__)
def test_what_is_no_problem(name: str, value: object) -> None:
    with pytest.raises(RbpsymError) as found:
        getattr(rbpsym, name)(value)
    assert found.value.instead
    assert "date or time" not in str(found.value) or isinstance(value, datetime.date)


@pytest.mark.parametrize("name", ["load_course", "derive_course", "course_notes"])
@pytest.mark.parametrize("value", [3, None, object()], ids=lambda value: type(value).__name__)
def test_what_is_no_course(name: str, value: object) -> None:
    with pytest.raises(RbpsymError):
        getattr(rbpsym, name)(value)


def test_formulas_as_text() -> None:
    assert rbpsym.equal("a+a", "2*a").is_proved
    assert rbpsym.equal("a", "2*a").is_refuted
    assert rbpsym.equal("sqrt(a**2)", "a", {"a": "positive"}).is_proved
    assert rbpsym.equal(Sym("a"), "a").is_proved
    assert rbpsym.equal(sympy.Symbol("a") * 2, "a + a").is_proved
    assert rbpsym.equal(2, "1 + 1").is_proved
    for left, right, more in (("a+", "a", ()), ([], "a", ()), ("a", "a", (3,)), ("a", "a", ({"a": "big"},))):
        with pytest.raises(RbpsymError):
            rbpsym.equal(left, right, *more)


def test_expressions_of_a_computer_algebra_system() -> None:
    """sympy prints what our reader reads; a value that is no expression is called by its type."""
    ell, m = sympy.symbols("ell m")

    def stated(length: object) -> rbpsym.Problem:
        return rbpsym.problem(
            "pendulum",
            parameters={"m": "mass", "ell": "length", "g": "acceleration"},
            coordinates={"theta": rbpsym.coordinate()},
            bodies={"rod": rbpsym.rod(length, mass=m, start=("0", "0"), angle="theta")},
            constraints={"P": rbpsym.pivot("rod.start")},
        )

    assert stated(2 * ell) == stated("2*ell")
    with pytest.raises(RbpsymError, match="a value of type object"):
        stated(object())
    with pytest.raises(RbpsymError, match="a date or time"):
        stated(datetime.date(2020, 1, 1))


def test_public_functions_can_be_sent_to_other_processes() -> None:
    for name in ("solve", "derive", "notes", "equal"):
        assert pickle.loads(pickle.dumps(getattr(rbpsym, name))) is getattr(rbpsym, name)
