"""What a task prints and what it asks for: no part of a worksheet may give away the answer to another.

An answer is given away wherever its value stands, whatever that is called there and with either sign: a couple has one
torque about all points, and a force is as great as the one against it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from rbpsym.decide.rooted import neat
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, Value, has_roots, short, value
from rbpsym.frozen import Frozen
from rbpsym.mechanics.study import Study

Claim = tuple[t.Node, t.Node] | frozenset[Scalar]  # both ends of a row, or a value with its opposite
COMMON = 3  # parts of a formula that stands everywhere, as the weight M g does: it gives nothing away
PROSE = (t.Integral, t.BodyIntegral, t.PathIntegral, t.Word, t.Vec, t.Unit, t.Delta, t.Sum)


class Content(Frozen):
    """What a task prints, what it wants to be found, what as a number, and of what it wants the sign.

    A formula that is printed may well be asked for as a number: that is how a lesson goes on.
    """

    prints: frozenset[Claim] = frozenset()
    asks: frozenset[Claim] = frozenset()
    numbers: frozenset[Claim] = frozenset()
    signs: frozenset[Claim] = frozenset()

    def spoils(self, other: Content) -> bool:
        """Whether one of the two gives away what the other asks for, or asks for the same."""
        wanted = self.asks & (other.asks | other.prints | other.numbers)
        told = self.prints & other.signs or self.signs & other.prints
        return bool(wanted or told or (self.prints | self.numbers) & other.asks or self.numbers & other.numbers)


def claims(statements: Iterable[t.Node]) -> frozenset[Claim]:
    """What statements say, row by row; 0 = 0 and the like give nothing away."""
    return frozenset(claim for statement in statements for claim in _claims(statement))


def _claims(statement: t.Node) -> Iterator[Claim]:
    for row in t.rows(statement):
        if isinstance(row, t.Chain) and len(row.items) > 1 and (row.items[-1] != t.ZERO or isinstance(row.items[0], t.Add)):
            yield row.items[0], row.items[-1]


def printed(study: Study, nodes: Iterable[t.Node], see: Callable[[t.Node], Iterable[t.Node]] | None = None) -> frozenset[Claim]:
    """The values of formulas and of all their parts (or of those that `see` gives), as far as they are worth asking for."""
    return wanted(study, (part for node in nodes for part in (see or parts)(node)))


def parts(node: t.Node) -> Iterator[t.Node]:
    """All parts of a formula; of products also what stands before directions and rates: the torque, the moment of inertia."""
    for part in t.walk(node):
        yield part
        if isinstance(part, t.Mul):
            kept = [factor for factor in part.factors if not _is_rate(factor)]
            if len(kept) < len(part.factors):
                yield t.mul(*kept)


def _is_rate(node: t.Node) -> bool:
    return isinstance(node, t.Unit) or (isinstance(node, t.Sym) and node.name.endswith(("_dot", "_ddot")))


def wanted(study: Study, answers: Iterable[t.Node]) -> frozenset[Claim]:
    """The values of answers that give something away where they stand again."""
    return frozenset(found for node in answers if (found := _claim(study, node)) is not None)


def _claim(study: Study, node: t.Node) -> Claim | None:
    """The value of an answer that gives something away, looked up where the same formula stood before."""
    found: dict[t.Node, Claim | None] = study.meanings
    if node not in found:
        value = meaning(study, node) if is_telling(node) else None
        value = neat(value, study.assumptions) if isinstance(value, Scalar) and has_roots(value) else value
        found[node] = unsigned(value) if isinstance(value, Scalar) and value else None
    return found[node]


def is_telling(node: t.Node) -> bool:
    """Whether a formula is more than a name, a number or a product of two."""
    return not isinstance(node, (t.Chain, t.Relations)) and _length(node) > COMMON and bool(t.names(node))


def _length(node: t.Node) -> int:
    """How many parts it has, signs aside; 0 for what is no formula in quantities of the problem."""
    found = list(t.walk(node))
    return 0 if any(isinstance(part, PROSE) for part in found) else sum(not isinstance(p, (t.Neg, t.Group)) for p in found)


def unsigned(value: Scalar) -> frozenset[Scalar]:
    """A value with its opposite."""
    return frozenset((short(value), short(-value)))


def given(study: Study) -> Content:
    """What the statement of a problem prints: sizes of forces and couples, where and how the motion starts."""
    problem = study.problem
    held = [part for element in problem.elements for part in element.values.values()]
    held += [part for c in problem.coordinates for part in (c.start, c.speed)]
    return Content(prints=printed(study, (part for part in held if isinstance(part, t.Node))))


def meaning(study: Study, node: t.Node) -> Value | None:
    """The value of a part in the names of the problem; None if it holds names that the derivation defined."""
    known = {*study.problem.dimensions, *study.system.unknowns, "pi"}
    bound = {part.var for part in t.walk(node) if isinstance(part, t.Integral)}
    if not t.names(node) <= known | bound:
        return None
    try:
        return value(node, study.system.scope)
    except (RbpsymError, ZeroDivisionError):
        return None
