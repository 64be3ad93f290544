"""Vector equations as equations of their components: the same tree, without arrows."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rbpsym.expr import tree as t

AT_START = t.Chain((t.Sym("t"), t.ZERO), ("=",))
OTHERS = {"x": "yz", "y": "zx", "z": "xy"}
START = "@0"  # ends the name of a quantity's value at the start


def started(node: t.Node, moving: Callable[[str], bool]) -> t.Node:
    """The tree as it is at the start."""
    return t.renamed(node, {name: t.Sym(name + START) for name in t.names(node) if moving(name)})


class Components:
    """Components of vectors. `turns`: names of vectors that stand out of the plane."""

    def __init__(self, turns: Callable[[str], bool], moving: Callable[[str], bool]) -> None:
        self.turns, self.moving = turns, moving

    def equations(self, left: t.Node, right: t.Node) -> Iterator[tuple[t.Node, t.Node]]:
        """The scalar equations that one equation is."""
        axes = sorted(self.axes(left) | self.axes(right))
        for axis in axes:
            yield self.part(left, axis), self.part(right, axis)
        if not axes:
            yield self.plain(left), self.plain(right)

    def axes(self, node: t.Node) -> set[str]:
        """Along which axes a vector may point; none for a scalar."""
        if isinstance(node, t.Vec):
            return {"z"} if self.turns(node.name) else {"x", "y"}
        if isinstance(node, t.Unit):
            return {node.axis}
        if isinstance(node, t.Cross):
            return {"x", "y"} if "z" in self.axes(node.left) | self.axes(node.right) else {"z"}
        if isinstance(node, t.Add | t.Neg | t.Mul | t.Div | t.Group | t.Deriv | t.BodyIntegral):
            return set().union(*map(self.axes, t.children(node)))
        return set()

    def part(self, node: t.Node, axis: str) -> t.Node:
        """The component along an axis."""
        found = self.axes(node)
        if axis not in found:
            return t.ZERO
        if isinstance(node, t.Vec):
            return t.Sym(node.name if axis == "z" else f"{node.name}_{axis}")
        if isinstance(node, t.Unit):
            return t.ONE
        if isinstance(node, t.Cross):
            return self._determinant(node, *OTHERS[axis])
        if isinstance(node, t.Mul):
            return t.mul(*(self.part(f, axis) if self.axes(f) else self.plain(f) for f in node.factors))
        if isinstance(node, t.Add):
            return t.add(*(self.part(term, axis) for term in node.terms))
        return t.mapped(node, lambda part: self.part(part, axis) if self.axes(part) else self.plain(part))

    def _determinant(self, node: t.Cross, first: str, second: str) -> t.Node:
        (a, b), (c, d) = ((self.part(side, first), self.part(side, second)) for side in (node.left, node.right))
        return t.Add((t.Mul((a, d)), t.Neg(t.Mul((b, c)))))

    def product(self, left: t.Node, right: t.Node) -> t.Node:
        """The scalar product."""
        shared = sorted(self.axes(left) & self.axes(right))
        return t.Add(tuple(t.Mul((self.part(left, a), self.part(right, a))) for a in shared)) if shared else t.ZERO

    def plain(self, node: t.Node) -> t.Node:
        """A scalar without vectors in it; a change as a difference, with the start's values named."""
        if isinstance(node, t.Dot):
            return self.product(node.left, node.right)
        if isinstance(node, t.Pow) and self.axes(node.base):
            return self.product(node.base, node.base)
        if isinstance(node, t.Delta):
            now = self.plain(node.arg)
            return t.Add((now, t.Neg(started(now, self.moving))))
        if isinstance(node, t.At) and node.condition == AT_START:
            return started(self.plain(node.arg), self.moving)
        return t.mapped(node, self.plain)
