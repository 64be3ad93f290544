"""The dimension of a formula, from the dimensions of its quantities.

Zero has every dimension. Adding, comparing, or taking a function of what does not fit is a
`DimensionError` whose place holds the column (from 1) and width of the part in its text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from rbpsym.errors import DimensionError, Place
from rbpsym.expr import tree
from rbpsym.expr.limits import number_of
from rbpsym.expr.tree import Node
from rbpsym.quantities import MASS, NUMBER, TIME, Dimension

Dimensions = Mapping[str, Dimension]


class Unsettled(dict[str, Dimension]):
    """Dimensions of which some have unknown exponents: of what would have to agree, the quotient is noted."""

    def __init__(self, known: Dimensions, agreeing: list[Dimension]) -> None:
        super().__init__(known)
        self.agreeing = agreeing


def _differ(found: Dimension, other: Dimension, dimensions: Dimensions) -> bool:
    if isinstance(dimensions, Unsettled):
        dimensions.agreeing.append(found / other)
        return False
    return found != other


_Found = Dimension | None  # None: zero, of any dimension


def dimension_of(node: Node, dimensions: Dimensions) -> Dimension:
    """The dimension of `node`; that of a plain zero is NUMBER. Raises DimensionError."""
    found = _find(node, dimensions)
    return NUMBER if found is None else found


def require_dimension(node: Node, dimensions: Dimensions, wanted: Dimension, what: str) -> None:
    """Raise DimensionError unless `node` (called `what` in the sentence) has the wanted dimension."""
    found = _find(node, dimensions)
    if found is not None and _differ(found, wanted, dimensions):
        raise _error(node, f"{what} must be {a(wanted)}, but this is {a(found)}")


def a(dimension: Dimension) -> str:
    """The dimension with its article: "a length", "an angle or a number", "a quantity of M L^3"."""
    if dimension == NUMBER:
        return "an angle or a number"
    name = str(dimension)
    if not name.islower():
        return f"a quantity of dimension {name}"
    return f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def _error(node: Node, what: str, instead: str = "") -> DimensionError:
    span = node.span
    place = Place(column=span[0] + 1, width=max(span[1] - span[0], 1)) if span else None
    return DimensionError(what, instead=instead, place=place)


def _find(node: Node, dimensions: Dimensions) -> _Found:
    return _RULES[type(node)](node, dimensions)


def _symbol(node: tree.Sym | tree.Vec, dimensions: Dimensions) -> _Found:
    if node.name == "pi":
        return NUMBER
    if node.name not in dimensions:
        raise _error(node, f"“{node.name}” has no dimension here")
    return dimensions[node.name]


def _same(nodes: Iterable[Node], dimensions: Dimensions, verb: str) -> _Found:
    """The one dimension of all nodes."""
    common: _Found = None
    for node in nodes:
        found = _find(node, dimensions)
        if found is not None and common is not None and _differ(found, common, dimensions):
            blamed = node.arg if isinstance(node, tree.Neg) else node
            raise _error(blamed, f"{a(found)} is {verb} {a(common)}", "terms of a sum must have one dimension.")
        common = found if common is None else common
    return common


def _sum(node: tree.Add, dimensions: Dimensions) -> _Found:
    return _same(node.terms, dimensions, "added to")


def _chain(node: tree.Chain, dimensions: Dimensions) -> _Found:
    return _same(node.items, dimensions, "compared with")


def _times(*found: _Found) -> _Found:
    product: _Found = NUMBER
    for factor in found:
        product = None if factor is None or product is None else product * factor
    return product


def _product(parts: Callable[[Any], Iterable[Node]]) -> Callable[[Node, Dimensions], _Found]:
    return lambda node, dimensions: _times(*[_find(part, dimensions) for part in parts(node)])


def _quotient(node: tree.Div, dimensions: Dimensions) -> _Found:
    num, den = _find(node.num, dimensions), _find(node.den, dimensions)
    return None if num is None else num / (den or NUMBER)


def _pure(node: Node, dimensions: Dimensions, what: str) -> None:
    found = _find(node, dimensions)
    if found is not None and _differ(found, NUMBER, dimensions):
        raise _error(node, f"{what} must be an angle or a number, but this is {a(found)}")


def _power(node: tree.Pow, dimensions: Dimensions) -> _Found:
    base = _find(node.base, dimensions)
    _pure(node.exponent, dimensions, "an exponent")
    if base in (None, NUMBER):
        return base
    exponent = number_of(node.exponent)
    if exponent is None:
        raise _error(node.exponent, f"the exponent of {a(base)} must be a plain number")
    return base**exponent


def _root(node: tree.Sqrt, dimensions: Dimensions) -> _Found:
    found = _find(node.arg, dimensions)
    return None if found is None else found ** Fraction(1, 2)


def _function(node: tree.Fn, dimensions: Dimensions) -> _Found:
    _pure(node.arg, dimensions, f"the argument of {node.name}")
    return NUMBER


def _derivative(node: tree.Deriv, dimensions: Dimensions) -> _Found:
    of = _find(node.of, dimensions)
    wrt = TIME if node.wrt == "t" else dimensions.get(node.wrt, NUMBER)
    return None if of is None else of / wrt**node.order


def _integral(node: tree.Integral, dimensions: Dimensions) -> _Found:
    variable = dimensions.get(node.var)
    if variable is None:
        variable = _same((node.lower, node.upper), dimensions, "compared with") or NUMBER
    inner = {**dimensions, node.var: variable}
    return _times(_find(node.integrand, inner), variable)


def _inner(node: Any, dimensions: Dimensions) -> _Found:
    return _find(node.arg, dimensions)


def _path(node: tree.PathIntegral, dimensions: Dimensions) -> _Found:
    return _times(_find(node.integrand, dimensions), _find(node.path, dimensions))


def _system(node: tree.Relations, dimensions: Dimensions) -> _Found:
    for row in node.rows:
        _find(row, dimensions)
    return NUMBER


_RULES: dict[type[Node], Callable[[Any, Dimensions], _Found]] = {
    tree.Num: lambda node, _: None if node.value == 0 else NUMBER,
    tree.Sym: _symbol,
    tree.Vec: _symbol,
    tree.Unit: lambda node, _: NUMBER,
    tree.Add: _sum,
    tree.Mul: _product(lambda node: node.factors),
    tree.Div: _quotient,
    tree.Pow: _power,
    tree.Sqrt: _root,
    tree.Fn: _function,
    tree.Cross: _product(lambda node: (node.left, node.right)),
    tree.Dot: _product(lambda node: (node.left, node.right)),
    tree.Deriv: _derivative,
    tree.Integral: _integral,
    tree.BodyIntegral: lambda node, dimensions: _times(_find(node.integrand, dimensions), MASS),
    tree.PathIntegral: _path,
    tree.Sum: lambda node, dimensions: _find(node.term, dimensions),
    tree.Word: lambda node, _: None,
    tree.Formal: lambda node, _: None,
    tree.Chain: _chain,
    **dict.fromkeys((tree.Neg, tree.Abs, tree.Group, tree.Bracket, tree.Delta, tree.At, tree.Limit), _inner),
    tree.Relations: _system,
}
