"""The display tree: every formula that rbpsym reads, computes or prints.

A tree keeps the form and the order in which a formula was written; it is never
simplified. Printers turn it into LaTeX, Typst, MathML, text and speech; `field.evaluate`
computes its exact value. All nodes are frozen and compared by value; `span` (the
characters of the source it was read from) takes no part in comparison.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import fields
from fractions import Fraction
from functools import cache
from typing import Any

from rbpsym.frozen import field, replace
from rbpsym.showing import Shown


class Node(Shown):
    """A formula or a part of one."""

    span: tuple[int, int] | None = field(default=None, compare=False, repr=False, kw_only=True)


class Num(Node):
    """An exact rational number."""

    value: Fraction | int


class Sym(Node):
    """A scalar quantity, by its name in the problem (`theta`, `ell`, `theta_dot`, `I_rod`)."""

    name: str


class Vec(Node):
    """A vector quantity, by name: printed with an arrow (or in bold)."""

    name: str


class Unit(Node):
    """A Cartesian unit vector: axis "x", "y" or "z", printed î, ĵ, k̂."""

    axis: str


class Add(Node):
    """A sum in the author's order; a subtracted term is `Neg(term)`."""

    terms: tuple[Node, ...]


class Neg(Node):
    """Minus the argument."""

    arg: Node


class Mul(Node):
    """A product, printed by juxtaposition in the author's order (a vector may be one factor)."""

    factors: tuple[Node, ...]


class Div(Node):
    """A fraction with a bar."""

    num: Node
    den: Node


class Pow(Node):
    """A power; the exponent is any tree (usually `Num`)."""

    base: Node
    exponent: Node


class Sqrt(Node):
    """The non-negative square root."""

    arg: Node


class Fn(Node):
    """A function of one argument: sin cos tan cot sec csc asin acos atan exp ln."""

    name: str
    arg: Node


class Abs(Node):
    """Absolute value of a scalar, magnitude of a vector."""

    arg: Node


class Group(Node):
    """Delimiters that the author wants to see: kind "(" or "[" (printers add needed ones alone)."""

    arg: Node
    kind: str = "("


class Cross(Node):
    """Vector product."""

    left: Node
    right: Node


class Dot(Node):
    """Scalar product."""

    left: Node
    right: Node


class Deriv(Node):
    """A derivative written as a fraction, d^n(of)/d(wrt)^n; `wrt` is "t" for the time."""

    of: Node
    wrt: str = "t"
    order: int = 1
    partial: bool = False


class Integral(Node):
    """A definite integral of `integrand` over the coordinate `var` (printed ∫_lower^upper f dvar)."""

    integrand: Node
    var: str
    lower: Node
    upper: Node


class BodyIntegral(Node):
    """∫ integrand dm over the region of the body named `body`."""

    integrand: Node
    body: str = "Omega"


class PathIntegral(Node):
    """∫ of a force along a path: `product` is "dot" (∫F·dR) or "times" (∫τ dφ); `path` is R or φ."""

    integrand: Node
    path: Node
    product: str = "dot"


class Sum(Node):
    """The sum of `term` over all particles, numbered by the symbol `index`; printed ∑_index."""

    term: Node
    index: str = "i"


class Bracket(Node):
    """[f] taken between two values of `var`: f(upper) - f(lower)."""

    arg: Node
    var: str
    lower: Node
    upper: Node


class Delta(Node):
    """The change of a quantity between start and now, printed Δ."""

    arg: Node


class At(Node):
    """A quantity at a given condition, printed f|_{cond}."""

    arg: Node
    condition: Node


class Limit(Node):
    """The limit of `arg` as the symbol `var` tends to `to`."""

    arg: Node
    var: str
    to: Node


class Word(Node):
    """An upright word inside a formula ("const", "and"); has no value."""

    text: str


class Formal(Node):
    """What is read and has no value that is computed, such as a matrix, a list, or a differential; `kind` says what."""

    kind: str
    parts: tuple[Node, ...] = ()


class Chain(Node):
    """items[0] ops[0] items[1] ops[1] ...; ops are "=", "<", ">", "<=", ">=", "!=", "~" (≈), "->".

    A plain relation is a chain of two items.
    """

    items: tuple[Node, ...]
    ops: tuple[str, ...]


class Relations(Node):
    """Several relations shown under each other (an aligned block), all asserted, perhaps under conditions.

    sources: what stands before an arrow from which they are said to follow.
    """

    rows: tuple[Node, ...]
    conditions: tuple[Node, ...] = ()
    sources: tuple[Node, ...] = ()


ZERO, ONE, TWO, HALF = Num(0), Num(1), Num(2), Num(Fraction(1, 2))


def equation(*items: Node) -> Chain:
    """items[0] = items[1] = ..."""
    return Chain(tuple(items), ("=",) * (len(items) - 1))


def relation(left: Node, op: str, right: Node) -> Chain:
    """One relation `left op right`."""
    return Chain((left, right), (op,))


def spread(integrand: Node) -> tuple[Node, str, Node] | None:
    """a, "cross" or "dot", and b of the integrand a × db/dm over a body, which is written ∫ a × db; None for others."""
    if not isinstance(integrand, Cross | Dot) or not isinstance(integrand.right, Deriv):
        return None
    rate = integrand.right
    if rate.wrt != "m" or rate.order != 1 or not isinstance(rate.of, Sym | Vec):
        return None
    return integrand.left, "cross" if isinstance(integrand, Cross) else "dot", rate.of


@cache
def parts(kind: type) -> tuple[str, ...]:
    """The names of what a kind of node consists of."""
    return tuple(item.name for item in fields(kind) if item.name != "span")


def children(node: Node) -> Iterator[Node]:
    """The direct parts of a node, in reading order."""
    kind: Any = type(node)
    for name in parts(kind):
        value = getattr(node, name)
        if isinstance(value, Node):
            yield value
        elif isinstance(value, tuple):
            yield from (part for part in value if isinstance(part, Node))


def walk(node: Node) -> Iterator[Node]:
    """The node and all its parts, parents first."""
    left = [node]
    while left:
        found = left.pop()
        yield found
        left += reversed([*children(found)])


def mapped(node: Node, change: Callable[[Node], Node]) -> Node:
    """The node with each of its direct parts changed."""
    changed: dict[str, Any] = {}
    kind: Any = type(node)
    for name in parts(kind):
        value = getattr(node, name)
        if isinstance(value, Node):
            changed[name] = change(value)
        elif isinstance(value, tuple):
            changed[name] = tuple(change(part) if isinstance(part, Node) else part for part in value)
    return replace(node, **changed) if changed else node


def renamed(node: Node, values: Mapping[str, Node]) -> Node:
    """The tree with symbols replaced."""
    return values.get(node.name, node) if isinstance(node, Sym) else mapped(node, lambda part: renamed(part, values))


def relations(statement: Node) -> Iterator[tuple[Node, str, Node]]:
    """All single relations that a statement asserts."""
    if isinstance(statement, Relations):
        for row in statement.rows:
            yield from relations(row)
    elif isinstance(statement, Chain):
        yield from zip(statement.items, statement.ops, statement.items[1:], strict=False)


def names(node: Node) -> set[str]:
    """Names of all scalar and vector quantities in the tree."""
    return {part.name for part in walk(node) if isinstance(part, (Sym, Vec))}


def add(*terms: Node) -> Node:
    """A sum without zeros and nesting; 0 for no terms."""
    flat: list[Node] = []
    for term in terms:
        flat.extend(term.terms if isinstance(term, Add) else (term,))
    kept = [term for term in flat if term != ZERO]
    return kept[0] if len(kept) == 1 else Add(tuple(kept)) if kept else ZERO


def neg(node: Node) -> Node:
    """Minus the node; a double minus is removed."""
    if isinstance(node, Neg):
        return node.arg
    if isinstance(node, Num):
        return node if node.value == 0 else Num(-node.value)
    return Neg(node)


def is_negative(node: Node) -> bool:
    """Whether a term begins with a minus."""
    return isinstance(node, Neg) or (isinstance(node, Num) and node.value < 0)


TURNED = {">": "<", ">=": "<=", "!=": "!="}


def upright(condition: Node) -> Node:
    """z < 0 for the condition −z > 0; a > b for a − b > 0; e < 1 for 1 − e > 0."""
    if not isinstance(condition, Chain) or condition.ops[0] not in TURNED or condition.items[1:] != (ZERO,):
        return condition
    left, op = condition.items[0], condition.ops[0]
    terms = left.terms if isinstance(left, Add) else (left,)
    more, less = (add(*(neg(term) if side else term for term in terms if is_negative(term) is side)) for side in (False, True))
    if less == ZERO:
        return condition
    return relation(less, TURNED[op], more) if isinstance(more, Num) else relation(more, op, less)


def mul(*factors: Node) -> Node:
    """A product without ones and nesting, the sign pulled in front; 0 if a factor is 0."""
    flat: list[Node] = []
    negative = False
    for factor in factors:
        if len(factors) > 1 and isinstance(factor, Add) and all(map(is_negative, factor.terms)):
            factor = neg(Add(tuple(map(neg, factor.terms))))
        if isinstance(factor, Neg):
            negative, factor = not negative, factor.arg
        if isinstance(factor, Num) and factor.value < 0:
            negative, factor = not negative, Num(-factor.value)
        flat.extend(factor.factors if isinstance(factor, Mul) else (factor,))
    if any(factor == ZERO for factor in flat):
        return ZERO
    kept = [factor for factor in flat if factor != ONE]
    product = kept[0] if len(kept) == 1 else Mul(tuple(kept)) if kept else ONE
    return neg(product) if negative else product


def div(num: Node, den: Node) -> Node:
    """A fraction, the sign in front, without a denominator 1."""
    if isinstance(num, Neg):
        return neg(div(num.arg, den))
    if isinstance(num, Num) and num.value < 0:
        return neg(div(Num(-num.value), den))
    return num if den == ONE else ZERO if num == ZERO else Div(num, den)


def system(rows: Sequence[Node]) -> Node:
    """Rows that hold together; a single one as it is."""
    return rows[0] if len(rows) == 1 else Relations(tuple(rows))


def rows(statement: Node) -> tuple[Any, ...]:
    """The rows of a statement, most of them chains; one that is no system is one row."""
    return statement.rows if isinstance(statement, Relations) else (statement,)


def chains(statement: Node) -> tuple[Chain, ...]:
    """The chains that a statement asserts, those of systems in systems too."""
    found = (chains(row) if isinstance(row, Relations) else (row,) for row in rows(statement))
    return tuple(row for part in found for row in part if isinstance(row, Chain))


def half_square(factor: Node, base: Node) -> Node:
    """½ m v²."""
    return mul(Div(ONE, TWO), factor, Pow(base, TWO))


def power(base: Node, exponent: int | Fraction) -> Node:
    """A power with a rational exponent; exponents 0 and 1 are resolved."""
    if exponent == 1:
        return base
    return ONE if exponent == 0 else Pow(base, Num(exponent))
