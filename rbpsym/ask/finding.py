"""What was found for a question about parameters: values or a region, with what it rests on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.verdict import Verdict, all_of
from rbpsym.errors import there
from rbpsym.expr.tree import ZERO, Node
from rbpsym.field import Scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.study import Study
from rbpsym.proof.checks.of_steps import guarded, weakest
from rbpsym.proof.context import Context
from rbpsym.proof.rules import RULES
from rbpsym.proof.step import Step
from rbpsym.statement.model import Problem


class Finding(Frozen):
    """symbol: what was asked for ("" for a plain value). values: of it, each with what it asks for beyond `valid`.

    relation: how the symbol stands to the one value: "=", "<", ">", "<=", ">=", "between" two, or "approaches". says: a
    sentence instead of a value, or beside it. equation: what vanishes at the symbol where it has no closed form. place: where
    an extremum lies, (name, place). holds: yes or no. met: what the moments
    ask for stands in `valid` already. grounds: how it was checked, rules of derivations with their data, the first of which
    see what is stated; parted: each value is stated by its own ground; form: how it is made of other quantities; steps: of a
    chapter, the last of which says it. Without a verdict, it is what these find; without any of them, nothing is proved.
    """

    verdict: Verdict | None = None
    symbol: str = ""
    values: tuple[Scalar, ...] = ()
    relation: str = "="
    valid: tuple[Demand, ...] = ()
    asked: tuple[tuple[Demand, ...], ...] = ()
    says: str = ""
    equation: Scalar | None = None
    place: tuple[str, Scalar | None] | None = None
    holds: bool | None = None
    met: bool = False
    grounds: tuple[tuple[str, Mapping[str, Any]], ...] = ()
    parted: bool = False
    form: Node | None = None
    steps: tuple[Step, ...] = ()

    @property
    def rule(self) -> str:
        """The rule that sees what is stated; "" without one."""
        return self.grounds[0][0] if self.grounds else ""

    @property
    def is_none(self) -> bool:
        """Whether no value of the symbol does."""
        return not self.values and any(said in self.says for said in (NO_SUCH, FOR_NONE))


NO_SUCH, FOR_NONE, FOR_EVERY = "there is no such", "holds for no values", "holds for all values"


NOWHERE = Study(Problem("", {}, (), (), ()))  # for checks that look at their data alone


def checked(rule: str, study: Study = NOWHERE, /, **data: Any) -> dict[str, Any]:
    """The verdict of the checks of a rule, with the rule and its data, as parts of a finding."""
    context = Context(study)
    verdict = weakest(guarded(partial(check, context, ground((rule, data)))) for check in RULES[rule])
    return {"verdict": verdict, "grounds": ((rule, data),)}


def kept_said(
    values: Iterable[Scalar], along: str | None, places: Sequence[Scalar | None], given: Assumptions, *, holds: bool
) -> dict[str, Any]:
    """That all values are nowhere negative, or that one of them is negative at one of the places, checked."""
    parts = tuple((value, place, value) for value in values for place in places or (None,))
    return checked("least_on_way", parts=parts, along=along, given=given, holds=holds)


def ground(of: tuple[str, Mapping[str, Any]], statement: Node = ZERO) -> Step:
    """A rule and its data as a step."""
    said = "divides" if of[0] == "holds_for" and of[1].get("opposite") else of[0]
    return Step("answer", of[0], statement, "ask", f"ask.found.{said}", data=of[1])


def together(*parts: Finding) -> dict[str, Any]:
    """What checked several findings, as parts of one."""
    return {"verdict": all_of(there(one.verdict) for one in parts), "grounds": tuple(g for one in parts for g in one.grounds)}
