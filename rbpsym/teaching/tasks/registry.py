"""The kinds of tasks by name. A new kind is a function `(bench, scenery, wish)`, an entry here and a key class in `model`."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.teaching.tasks import compare, derivations, results, signs, slip
from rbpsym.teaching.tasks.wish import Prepare

TASKS: Mapping[str, Prepare] = {
    "fill-in": derivations.blanks,
    "choose": results.choices,
    "order": derivations.orders,
    "find-the-slip": slip.prepare,
    "signs": signs.prepare,
    "formula": results.formulas,
    "number": results.numbers,
    "compare": compare.prepare,
    "explain": derivations.explanations,
}
