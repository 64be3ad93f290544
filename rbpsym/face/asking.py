"""The answer of a model to a question, in sympy."""

from __future__ import annotations

from dataclasses import dataclass

from rbpsym.ask.answer import Answer
from rbpsym.ask.telling import latex_of
from rbpsym.equality.verdict import Verdict
from rbpsym.face.late import sympy
from rbpsym.face.writing import alphabet
from rbpsym.solve import shown


@dataclass(frozen=True)
class SymbolicAnswer:
    """`value`: an expression, or the components along x and y of a vector as a column; `valid_where`: relations that must
    hold; `steps`: ids of the steps from which it follows; `latex` as the notes print it."""

    question: str
    value: sympy.Basic
    verdict: Verdict
    valid_where: tuple[sympy.Basic, ...]
    steps: tuple[str, ...]
    latex: str

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex}$"


def in_sympy(found: Answer) -> SymbolicAnswer:
    """The answer with its formulas in sympy."""
    names = alphabet(found.study)
    values = [names.write(shown(value, found.study)) for value in found.values]
    valid = tuple(relation for node in found.valid for relation in names.relations(node))
    value = values[0] if len(values) == 1 else sympy.Matrix(values)
    return SymbolicAnswer(found.question.text, value, found.verdict, valid, tuple(s.id for s in found.steps), latex_of(found))
