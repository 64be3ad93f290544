"""A shape from its data and its sizes: the mass elements, the points, the parts of a composite."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any

from rbpsym.elements.kinds import ElementText, ShapeKind
from rbpsym.errors import StatementError
from rbpsym.expr import tree
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import ZERO, Fn, Node, Num, Sym, add, div, mul, neg
from rbpsym.frozen import Frozen, field, replace
from rbpsym.statement.model import MassElement, Pair, PlacedShape, Range, Shape

if TYPE_CHECKING:
    from rbpsym.field.scalar import Scalar

# --- names replaced by formulas in a tree, with the numbers of fractions put together


def put_in(node: Node, values: Mapping[str, Node]) -> Node:
    """The tree with each symbol of `values` replaced; sums, products and fractions tidied."""
    if isinstance(node, tree.Sym):
        return values.get(node.name, node)
    found = replace(tree.mapped(node, lambda part: put_in(part, values)), span=None)
    rule = _TIDY.get(type(node))
    return rule(found) if rule else found


def put_into(part: Any, values: Mapping[str, Node]) -> Any:
    """A part of a statement with each symbol of `values` replaced in all its formulas."""
    if isinstance(part, Node):
        return put_in(part, values)
    if isinstance(part, tuple):
        return tuple(put_into(item, values) for item in part)
    if isinstance(part, Mapping):
        return {key: put_into(item, values) for key, item in part.items()}
    if is_dataclass(part) and not isinstance(part, type):
        return replace(part, **{one.name: put_into(getattr(part, one.name), values) for one in fields(part) if one.init})
    return part


def quotient(num: Node, den: Node) -> Node:
    """num / den, where numbers cancel: 2 ell / 2 is ell, M / (M) stays."""
    if isinstance(num, tree.Neg):
        return neg(quotient(num.arg, den))
    (a, top), (b, bottom) = _split(num), _split(den)
    number = a / b
    return div(mul(Num(number.numerator), top), mul(Num(number.denominator), bottom))


def _split(node: Node) -> tuple[Fraction, Node]:
    """A number and the rest of a product."""
    if isinstance(node, Num) and node.value:
        return Fraction(node.value), tree.ONE
    if isinstance(node, tree.Mul) and isinstance(node.factors[0], Num):
        return Fraction(node.factors[0].value), mul(*node.factors[1:])
    return Fraction(1), node


def _power(node: tree.Pow) -> Node:
    number = node.exponent.value if isinstance(node.exponent, Num) else None
    return tree.power(node.base, number) if number is not None and number in (0, 1) else node


_TIDY = {
    tree.Add: lambda node: add(*node.terms),
    tree.Neg: lambda node: neg(node.arg),
    tree.Mul: lambda node: mul(*node.factors),
    tree.Div: lambda node: quotient(node.num, node.den),
    tree.Group: lambda node: node.arg,
    tree.Pow: _power,
}


# ---


# What a variable of integration is called, and if the problem uses that name itself.
_VARIABLE_NAMES = {
    "s": ("s", "xi", "u"),
    "x": ("x", "xi", "u"),
    "y": ("y", "eta", "v"),
    "z": ("z", "zeta", "w"),
    "r": ("r", "rho", "q"),
    "u": ("u", "xi", "p"),
    "v": ("v", "eta", "q"),
    "phi": ("phi", "varphi", "chi"),
}


class Material(Frozen):
    """What fills a shape: a mass spread evenly, or the author's own density; with a mass this gives its proportions alone."""

    mass: Node | None = None
    density: Node | None = None
    taken: Collection[str] = field(default_factory=frozenset)


@cache
def _text(text: str) -> Node:
    """The tree of a text of the shape tables."""
    words = set(re.findall(r"[a-z_]+", text)) - {"sqrt", "sin", "cos", "pi"}
    return read_infix(text, dict.fromkeys(words))


def variables_of(kind: ShapeKind, taken: Collection[str]) -> dict[str, Node]:
    """The names of the variables of the kind's element in a problem that has `taken` its own."""
    return {name: Sym(_free_name(name, taken)) for name, _, _ in (kind.element.ranges if kind.element else ())}


def _free_name(name: str, taken: Collection[str]) -> str:
    choices = (*_VARIABLE_NAMES[name], *(f"{name}_{n}" for n in range(1, 1000)))
    return next(choice for choice in choices if choice not in taken)


def shape_of(kind: ShapeKind, sizes: Mapping[str, Node], material: Material) -> Shape:
    """The shape of a kind with its sizes and its material."""
    variables = variables_of(kind, material.taken)
    own, mass, density = kind.element, material.mass, material.density
    share = quotient(mass, size_of(kind, sizes)) if own and mass and not density else ZERO
    found = (_element(own, {**piece, **variables}, density, share, kind.density) for piece in _pieces(sizes) if own)
    elements = tuple(element for element in found if element.measure != ZERO)
    if mass and density:
        elements = spread_of(elements, mass)
    points = {name: (put_in(_text(x), sizes), put_in(_text(y), sizes)) for name, x, y in kind.points}
    return Shape(kind.name, dict(sizes), elements, points, sizes.get("moment") if not kind.element else None)


def size_of(kind: ShapeKind, sizes: Mapping[str, Node]) -> Node:
    """The length, area or volume of a shape."""
    return add(*(put_in(_text(kind.size), piece) for piece in _pieces(sizes)))


def _pieces(sizes: Mapping[str, Node]) -> list[Mapping[str, Node]]:
    """The sizes of each piece of which a shape consists: of a polygon, of each edge from (x_p, y_p) to (x_q, y_q)."""
    count = sum(name.startswith("x_") for name in sizes)
    ends = [(k, k % count + 1) for k in range(1, count + 1)]
    sides = [{f"{axis}_{end}": sizes[f"{axis}_{k}"] for axis in "xy" for end, k in zip("pq", pair, strict=True)} for pair in ends]
    return [*sides] or [sizes]


def _element(
    element: ElementText, values: Mapping[str, Node], own: Node | None, share: Node, letters: Iterable[tuple[str, str]]
) -> MassElement:
    """The mass per length, area or volume is the same everywhere, a `share`, or the author's `own`, in letters of the element."""
    density = share if own is None else put_in(own, {name: put_in(_text(text), values) for name, text in letters})
    x, y, measure = (put_in(_text(text), values) for text in (element.x, element.y, element.measure))
    ranges = tuple(_range(row, values) for row in element.ranges)
    return MassElement(ranges, x, y, measure, density, element.kind)


def _range(row: tuple[str, str, str], values: Mapping[str, Node]) -> Range:
    (name, lower, upper), letters = row, {name: node.name for name, node in values.items() if isinstance(node, Sym)}
    return Range(letters[name], put_in(_text(lower), values), put_in(_text(upper), values))


def integrate_ranges(integrand: Scalar, element: MassElement) -> Scalar:
    """The integral over the variables of the element, from the innermost outwards."""
    from rbpsym.field.evaluate import scalar
    from rbpsym.field.integration import definite
    from rbpsym.field.normal import tidy

    for item in reversed(element.ranges):
        found = definite(integrand, item.variable, scalar(item.lower), scalar(item.upper))
        if found is None:
            what = f"the mass of this density can't be integrated in closed form over {item.variable}"
            raise StatementError(what, instead="use a polynomial density, or the shape “given” with its moment of inertia.")
        integrand = tidy(found)
    return integrand


def spread_of(elements: tuple[MassElement, ...], mass: Node) -> tuple[MassElement, ...]:
    """The elements with densities in the same proportions, and this mass in all."""
    from rbpsym.field.evaluate import scalar
    from rbpsym.present.forms import present

    amounts = (integrate_ranges(scalar(e.density) * scalar(e.measure), e) for e in elements)
    share = scalar(mass) / sum(amounts, start=scalar(ZERO))
    return tuple(replace(e, density=present(scalar(e.density) * share)) for e in elements)


# --- composites


def compose(parts: tuple[PlacedShape, ...]) -> Shape:
    """The composite of parts that are placed in its frame."""
    # of a repeated part two halves opposite to each other: they have the mass, the centre and ∫ r² dm of all of them
    elements = tuple(_moved(element, one) for part in parts for one in ((part,) if part.count is None else copies(part, 2))
                     for element in part.shape.elements)
    return Shape("composite", {}, elements, {"origin": (ZERO, ZERO)}, parts=parts)


def copies(part: PlacedShape, number: int) -> Iterator[PlacedShape]:
    """A part as often as it is there, each time turned about its hub."""
    arm = add(part.at[0], neg(part.hub[0])), add(part.at[1], neg(part.hub[1]))
    for k in range(number):
        turn = quotient(mul(Num(2 * k), Sym("pi")), Num(number)) if k else ZERO
        yield replace(part, at=moved(arm, part.hub, turn), angle=add(part.angle, turn))


def total_mass(parts: Iterable[PlacedShape]) -> Node | None:
    """The sum of the masses of the parts, without those cut out; None if one has a density."""
    parts = tuple(parts)
    masses = [mul(weight(part.removed, part.count), part.mass) for part in parts if part.mass is not None]
    return add(*masses) if len(masses) == len(parts) else None


def weight(removed: bool, count: Node | None) -> Node:
    """How often a part counts: -1 for one that is cut out."""
    times = tree.ONE if count is None else count
    return neg(times) if removed else times


def shares(total: Node, pieces: Iterable[tuple[Node, Node]]) -> list[Node]:
    """The masses of pieces (size, weight) of one material whose whole has the mass `total`."""
    pieces = list(pieces)
    size = add(*(mul(times, size) for size, times in pieces))
    return [quotient(mul(total, size_i), size) for size_i, _ in pieces]


def _moved(element: MassElement, part: PlacedShape) -> MassElement:
    x, y = moved((element.x, element.y), part.at, part.angle)
    density = element.density if part.count is None else quotient(mul(part.count, element.density), Num(2))
    return replace(element, x=x, y=y, density=density, sign=-element.sign if part.removed else element.sign)


def leaves(shape: Shape) -> Iterator[PlacedShape]:
    """The parts of a composite that are no composites themselves, as they lie in its frame."""
    for part in shape.parts:
        for inner in leaves(part.shape) if part.shape.parts else ():
            at, angle = moved(inner.at, part.at, part.angle), add(part.angle, inner.angle)
            hub = moved(inner.hub, part.at, part.angle)
            yield replace(inner, at=at, angle=angle, removed=part.removed != inner.removed, hub=hub)
        if not part.shape.parts:
            yield part


def moved(point: Pair, at: Pair, angle: Node) -> Pair:
    """The place of a point of a frame whose origin is `at` and whose x' axis is at `angle`."""
    x, y = point
    if angle == ZERO:
        return add(at[0], x), add(at[1], y)
    cos, sin = Fn("cos", angle), Fn("sin", angle)
    return add(at[0], mul(x, cos), neg(mul(y, sin))), add(at[1], mul(x, sin), mul(y, cos))
