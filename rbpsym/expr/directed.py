"""Which trees are vectors, by their form alone."""

from __future__ import annotations

from rbpsym.expr import tree as t


def is_vector(node: t.Node) -> bool:
    """Is the value of the node a vector?"""
    if isinstance(node, (t.Dot, t.Abs)):
        return False
    if isinstance(node, (t.Vec, t.Unit, t.Cross)):
        return True
    if isinstance(node, t.Div):
        return is_vector(node.num)
    if isinstance(node, t.Formal) and node.kind in _SHAPED:
        return node.kind == "∇"
    return any(is_vector(part) for part in t.children(node))


_SHAPED = frozenset(("∇", "matrix", "transposed", "determinant", "row", "mean"))
