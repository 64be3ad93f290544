"""The steps of a derivation as sympy's relations, with their LaTeX, premises, verdicts and obligations."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rbpsym.derivation.step import Derivation
from rbpsym.document.notes import notation_of
from rbpsym.equality.verdict import Verdict, undecided
from rbpsym.face.late import sympy
from rbpsym.face.writing import alphabet
from rbpsym.notation.latex import to_latex


@dataclass(frozen=True)
class StepRelation:
    """A step: the `relations` that it asserts, in order; `latex` as the notes print it; the ids of the steps and facts
    from which it follows; what became of its check; what must hold for it to have a meaning, as relations."""

    id: str
    relations: tuple[sympy.Basic, ...]
    latex: str
    premises: tuple[str, ...]
    verdict: Verdict
    obligations: tuple[sympy.Basic, ...]

    @property
    def relation(self) -> sympy.Basic:
        """All that is asserted: one relation, or the conjunction of several."""
        return self.relations[0] if len(self.relations) == 1 else sympy.And(*self.relations, evaluate=False)

    def _repr_latex_(self) -> str:
        return rf"$\displaystyle {self.latex}$"


def relations_of(derivation: Derivation) -> Iterator[StepRelation]:
    """The steps of all phases, those of later ones with phase2. before their ids."""
    later = ((phase.derivation, (*phase.begins, *phase.derivation.steps)) for phase in derivation.phases)
    for number, (own, steps) in enumerate(((derivation, derivation.steps), *later), 1):
        names, notation = alphabet(own.study, own.letters), notation_of(own)
        for step in steps:
            verdict = step.certificate.verdict if step.certificate else undecided("it was not checked")
            duties = dict.fromkeys((*step.obligations, *(duty.relation for duty in verdict.open_obligations)))
            yield StepRelation(
                f"phase{number}.{step.id}" if number > 1 else step.id,
                names.relations(step.statement),
                to_latex(step.statement, notation),
                step.premises,
                verdict,
                tuple(relation for duty in duties for relation in names.relations(duty)),
            )
