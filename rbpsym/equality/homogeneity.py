"""How many parts of a formula do not fit by their dimensions: what a reader of ambiguous formulas goes by."""

from __future__ import annotations

from rbpsym.equality.dimensions import Dimensions, dimension_of
from rbpsym.errors import DimensionError
from rbpsym.notation import tree as t

CHECKED = (t.Chain, t.Add, t.Fn, t.Pow)


def faults(node: t.Node, dimensions: Dimensions) -> int:
    """The number of sums, relations, functions and powers in which something does not fit (0: it is homogeneous).

    A formula with a name of unknown dimension is judged by its other parts.
    """
    return sum(_is_faulty(part, dimensions) for part in t.walk(node) if isinstance(part, CHECKED))


def _is_faulty(node: t.Node, dimensions: Dimensions) -> bool:
    if not _is_known(node, dimensions):
        return False
    try:
        dimension_of(node, dimensions)
    except DimensionError:
        return True
    return False


def _is_known(node: t.Node, dimensions: Dimensions) -> bool:
    return all(name == "pi" or name in dimensions for name in t.names(node))
