"""The kinds of tasks by name. A new kind is a module with `prepare`, an entry here and a key class in `model`."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.teaching.tasks import choose, compare, explain, fill_in, order, results, signs, slip
from rbpsym.teaching.tasks.wish import Prepare

TASKS: Mapping[str, Prepare] = {
    "fill-in": fill_in.prepare,
    "choose": choose.prepare,
    "order": order.prepare,
    "find-the-slip": slip.prepare,
    "signs": signs.prepare,
    "formula": results.formulas,
    "number": results.numbers,
    "compare": compare.prepare,
    "explain": explain.prepare,
}
