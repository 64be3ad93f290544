"""A result of a derivation as a quantity with its value, for what is to be said of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.verdict import Verdict
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import ZERO
from rbpsym.field import Scalar, is_zero, names_in
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study
from rbpsym.proof.assertions import told
from rbpsym.proof.step import Certificate, Derivation, Step
from rbpsym.quantities import Quantity


class Made(Frozen):
    """key and slots of its phrase; `about`: what it says, so that it is said once in a text."""

    key: str
    slots: Mapping[str, Any]
    verdict: Verdict
    about: tuple[str, ...]

    def said(self) -> Step:
        """As a step with a sentence that is true: none if it is not proved."""
        certificate = Certificate(("remark",), self.verdict)
        return told(Step("remark", "remark", ZERO, "remarks", self.key, self.slots, certificate=certificate))


BALANCES = ("conservation", "work", "asked")  # rules of results that relate quantities, and give none
CAUSED = ("solution", "first_integral")  # those of how the system moves


class Result(Frozen):
    """A boxed step that gives a quantity: its name as it is printed, its value."""

    step: Step
    study: Study
    name: t.Node
    value: Scalar

    @property
    def given(self) -> Assumptions:
        """What is declared of the letters."""
        return self.study.assumptions

    @property
    def declared(self) -> Mapping[str, Quantity]:
        """The parameters that the author declares, by name; starts are none of them."""
        problem = self.study.problem
        starts = self.study.system.scope.start.values()
        begun = {name for value in starts for name in names_in(value)}
        return {q.name: q for q in problem.parameters if q.name not in {*problem.implicit, *begun}}


def results(derivation: Derivation) -> Iterator[Result]:
    """The results of a derivation that give a quantity which is not zero, as a function of the place or of the state."""
    for step in derivation.steps:
        found = result_of(step, derivation)
        if found is not None:
            yield found


def result_of(step: Step, derivation: Derivation) -> Result | None:
    """A step as a result; None for what is none."""
    row = step.statement
    if not step.is_result or step.rule in BALANCES or not isinstance(row, t.Chain) or set(row.ops) != {"="}:
        return None
    try:
        value = derivation.letters.value(row.items[-1])
    except RbpsymError:
        return None
    if not isinstance(value, Scalar) or is_zero(value):
        return None
    names, study = names_in(value), derivation.study
    rates = study.system.scope.rates.keys()
    known = rates if step.rule == "solution" else set(study.system.coordinates)
    if names - known - {"pi", "t", *(q.name for q in study.problem.parameters)} or names & (rates - known):
        return None  # unknown forces, a place of rest that an equation tells: these may depend on anything
    found = Result(step, study, row.items[0], value)
    return None if step.rule == "first_integral" and not names & {*found.declared, *known} else found
