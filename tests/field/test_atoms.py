"""An atom's index says what it is: what is printed does not depend on what was met before."""

import subprocess
import sys

import pytest

from rbpsym.expr.infix import read_infix
from rbpsym.field import atoms
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import symbol

FORMS = """
import sys
from rbpsym.field.evaluate import scalar
from rbpsym.field.normal import short
from rbpsym.present.forms import present
from rbpsym.decide.domain import divisors
from rbpsym.expr.infix import read_infix
from rbpsym.typeset.machine import to_machine
names = "M g L theta theta_0 mu b".split()
for text in sys.argv[1:]:
    scalar(read_infix(text, names))
def told(text):
    return scalar(read_infix(text, names))
print(to_machine(present(short(told("2 + sin(theta)**2 + 3*cos(theta)**2 - sin(theta)*sin(theta_0)")))))
print(to_machine(present(told("M/(g*theta - L*theta_0)"))))
print(to_machine(present(told("sqrt(mu**2*L**4 + (L**2 + 36*b**2)**2)"))))
print([to_machine(present(one)) for one in divisors(told("1/(M*L*sin(theta)*(M + g))"))])
"""
MET = ((), ("sin(theta)", "L", "cos(theta_0)"), ("cos(theta_0)", "sin(theta)", "M"), ("theta_0", "L*g"),
       ("sqrt((L**2 + 36*b**2)**2 + mu**2*L**4)",))  # fmt: skip

STEPS = """
import sys
from rbpsym.field.scalar import symbol
from rbpsym.derive import derive
from rbpsym.typeset.latex import to_latex
from rbpsym.expr.glyphs import Notation
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem
for name in sys.argv[2:]:
    symbol(name)
problem = load_problem(find_problem(sys.argv[1]))
for step in derive(problem, simulation=False).all_steps:
    asked = [to_latex(one.relation, Notation(problem.notation)) for one in step.certificate.verdict.obligations]
    print(step.id, to_latex(step.statement, Notation(problem.notation)), asked)
"""


def said(*words: str) -> str:
    return subprocess.run([sys.executable, "-c", *words], capture_output=True, text=True, check=True).stdout


def test_forms_signs_and_conditions_do_not_depend_on_what_was_met_before():
    told = {said(FORMS, *texts) for texts in MET}
    assert len(told) == 1 and all(told)


@pytest.mark.parametrize("name", ["hoop-on-its-rim", "ring-on-incline"])
def test_what_is_derived_does_not_depend_on_what_was_met_before(name):
    names = "theta_0 theta_dot theta s R r M m g alpha mu N f x x_dot".split()
    told = {said(STEPS, name, *met) for met in ((), names, names[::-1])}
    assert len(told) == 1 and all(told)


def test_inner_atoms_come_first_then_names_by_their_letters():
    names = ["pi", "g", "m", "M", "theta", "theta_0", "phi", "phi_0", "omega", "ell"]
    inner = [atoms.intern("symbol", name) for name in names]
    outer = [index for text in ("cos(theta)", "cos(phi)", "sqrt(cos(phi) + 2)")
             for index in scalar(read_infix(text, names)).atoms()]  # fmt: skip
    assert [*inner, *outer] == sorted({*inner, *outer})
    assert [atoms.symbol_name(index) for index in inner] == names


def test_two_of_one_number_are_told_apart(monkeypatch):
    monkeypatch.setattr(atoms, "_own", lambda kind, arg: 5)
    first, second = symbol("told apart 1"), symbol("told apart 2")
    assert first != second and {atoms.symbol_name(i) for one in (first, second) for i in one.atoms()} == {
        "told apart 1", "told apart 2"}  # fmt: skip
