"""One form for one quantity: what a derivation has printed once it prints so again."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Value, substitute, value
from rbpsym.field.evaluate import scalar
from rbpsym.proof.step import Step

# of these alone: what stands under an integral, a Δ or a derivative is no value of its own
PLAIN = (t.Sym, t.Num, t.Add, t.Neg, t.Mul, t.Div, t.Pow, t.Sqrt, t.Fn, t.Group)

LETTERED = "kinematics.length"  # the phrase of a step that gives a root its letter


def lettered(steps: Iterable[Step]) -> dict[str, t.Node]:
    """The roots that have a letter in these."""
    rows = (step.statement.items for step in steps if step.phrase == LETTERED and isinstance(step.statement, t.Chain))
    return {row[0].name: row[-1] for row in rows if isinstance(row[0], t.Sym)}


class Forms:
    """The forms in which rows end, by their value in the letters that are printed, each with the number of its step."""

    def __init__(self, steps: Iterable[Step] = ()) -> None:
        """Those of a derivation that stands."""
        self.found: dict[Value, tuple[t.Node, int]] = {}
        self.meant: dict[str, Scalar] = {}  # letters by which roots are printed
        for step in steps:
            self.meant |= {name: scalar(root) for name, root in lettered([step]).items()}
            self.kept(step.statement)

    def kept(self, statement: t.Node, number: int = -1) -> Any:
        """The statement of a step of that number (-1 is never forgotten); what was printed before ends its rows in that form."""
        if isinstance(statement, t.Relations):
            return t.Relations(tuple(self.kept(row, number) for row in statement.rows))
        if not isinstance(statement, t.Chain) or set(statement.ops) != {"="} or not _is_plain(statement.items[-1]):
            return statement
        *before, last = statement.items
        said = value(last)
        said = substitute(said, self.meant) if self.meant and isinstance(said, Scalar) else said
        form, _ = self.found.setdefault(said, (last, number))
        if form == before[0]:
            return statement
        items = (*before[: before.index(form)], form) if form in before else (*before, form)
        return t.Chain(items, statement.ops[: len(items) - 1])

    def forget(self, kept: int) -> None:
        """Takes back the forms of all steps but the first ones."""
        self.found = {value: (form, number) for value, (form, number) in self.found.items() if number < kept}


def _is_plain(node: t.Node) -> bool:
    return not isinstance(node, (t.Sym, t.Num)) and all(isinstance(part, PLAIN) for part in t.walk(node))
