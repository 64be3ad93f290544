"""What was found for a question about parameters: values or a region, with what it rests on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.checks import weakest
from rbpsym.derivation.rules import RULES
from rbpsym.derivation.step import Step
from rbpsym.equality.verdict import Verdict
from rbpsym.mechanics.demands import Demand
from rbpsym.notation.tree import ZERO


@dataclass(frozen=True, slots=True)
class Finding:
    """symbol: what was asked for ("" for a plain value). values: of it, each with what it asks for beyond `valid`.

    relation: how the symbol stands to the one value: "=", "<", ">", "<=", ">=", "between" two, or "approaches". says: a
    sentence instead of a value, or beside it. equation: what vanishes at the symbol where it has no closed form. place: where
    an extremum lies, (name, place). holds: yes or no. met: what the moments
    ask for stands in `valid` already. rule, data: how it was checked, by a rule of derivations.
    """

    verdict: Verdict
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
    rule: str = ""
    data: Mapping[str, Any] = field(default_factory=dict)

    @property
    def is_none(self) -> bool:
        """Whether no value of the symbol does."""
        return not self.values and any(said in self.says for said in (NO_SUCH, FOR_NONE))


NO_SUCH, FOR_NONE = "there is no such", "holds for no values"

def checked(rule: str, **data: Any) -> dict[str, Any]:
    """The verdict of the checks of a rule, with the rule and its data, as parts of a finding."""
    step = Step("answer", rule, ZERO, "ask", "ask.found", data=data)
    return {"verdict": weakest([check(None, step) for check in RULES[rule]]), "rule": rule, "data": data}


def verdict_of(rule: str, **data: Any) -> Verdict:
    """The verdict alone."""
    return checked(rule, **data)["verdict"]
