"""The setting of a formula: who needs brackets, what is drawn how, and what the printers share while they lay it out."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction as Rational
from typing import TypeGuard, TypeVar

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Glyph, Notation
from rbpsym.frozen import Frozen, replace
from rbpsym.typeset import boxes as b


class LayoutStyle(Frozen):
    """`mode` is "display" (fractions with bars), "inline" (exponents: 3/2) or "text" (one line)."""

    notation: Notation = DEFAULT
    mode: str = "display"

    @property
    def script(self) -> LayoutStyle:
        """The style of exponents and limits: no fractions with bars."""
        return replace(self, mode="inline")


Draw = Callable[..., b.Box]
Entered = TypeVar("Entered", bound=Draw)
TABLE: dict[type, Draw] = {}


def draws(*kinds: type) -> Callable[[Entered], Entered]:
    """Enter a function `(node, style) -> Box` into the table for these node types."""

    def enter(function: Entered) -> Entered:
        TABLE.update(dict.fromkeys(kinds, function))
        return function

    return enter


def draw(node: t.Node, style: LayoutStyle) -> b.Box:
    """The boxes of a formula."""
    return TABLE[type(node)](node, style)


def fenced(box: b.Box, opening: str = "(", closing: str = ")") -> b.Fence:
    """The box between delimiters that grow if it is tall."""
    return b.Fence(opening, box, closing, b.is_tall(box))


def wrapped(node: t.Node, least: int, style: LayoutStyle) -> b.Box:
    """The boxes of a part, in parentheses if it binds less than `least`."""
    box = draw(node, style)
    return fenced(box) if level(node, style.mode) < least else box


CHAIN, SUM, CROSS, PRODUCT, APPLIED, POWER, ATOM = range(7)

_LEVELS: dict[type, int] = {
    t.Chain: CHAIN, t.Relations: CHAIN, t.Add: SUM, t.Neg: SUM, t.Cross: CROSS, t.Dot: CROSS,
    t.Mul: PRODUCT, t.Integral: PRODUCT, t.BodyIntegral: PRODUCT, t.PathIntegral: PRODUCT,
    t.Limit: PRODUCT, t.Sum: PRODUCT, t.Fn: APPLIED, t.Delta: APPLIED, t.Deriv: APPLIED,
    t.Sqrt: POWER, t.Pow: POWER,
}  # fmt: skip
_OPEN = (t.Integral, t.BodyIntegral, t.PathIntegral, t.Limit, t.Sum)


def level(node: t.Node, mode: str = "display") -> int:
    """The binding level of a node as it is printed (fractions bind less in one line)."""
    if isinstance(node, (t.Neg, t.Mul)) or _is_single(node):
        return _signed_level(node, mode)
    if isinstance(node, t.Num):
        return SUM if node.value < 0 else PRODUCT if mode != "display" and plain_fraction(node) else ATOM
    if isinstance(node, t.Div):
        return ATOM if mode == "display" else PRODUCT
    return _LEVELS.get(type(node), ATOM)


def _signed_level(node: t.Node, mode: str) -> int:
    """The level of a term after its signs are gathered: -(-x) is x."""
    negative, body = signed(node)
    if negative:
        return SUM
    return PRODUCT if isinstance(body, t.Mul) else level(body, mode)


def is_open(node: t.Node) -> bool:
    """Does the node have no visible end, so that a factor after it would slip in?"""
    if isinstance(node, t.Mul) and node.factors:
        return is_open(node.factors[-1])
    return isinstance(node, _OPEN)


def plain_fraction(node: t.Node) -> bool:
    """Is it printed as a fraction: a Div or a positive number that is not whole?"""
    if isinstance(node, t.Num):
        return Rational(node.value).denominator != 1 and not is_decimal(node.value)
    return isinstance(node, (t.Div, t.Deriv))


def is_decimal(value: Rational | int) -> bool:
    """Is it a number that only a measurement has (9.81), which is printed as a decimal?"""
    rest = Rational(value).denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1 and Rational(value).denominator > 20


def signed(node: t.Node) -> tuple[bool, t.Node]:
    """(is it negative, the rest): gathers the signs of Neg, negative numbers, first factors."""
    if isinstance(node, t.Neg):
        negative, body = signed(node.arg)
        return not negative and body != t.ZERO, body
    if isinstance(node, t.Num):
        return node.value < 0, t.Num(-node.value if node.value < 0 else node.value)
    if isinstance(node, t.Mul):
        return _signed_product(node)
    return signed(node.terms[0]) if _is_single(node) else (False, node)


def _is_single(node: t.Node) -> TypeGuard[t.Add]:
    """Is it a sum of one term, which is printed as that term?"""
    return isinstance(node, t.Add) and len(node.terms) == 1


def _signed_product(node: t.Mul) -> tuple[bool, t.Node]:
    if not node.factors:
        return False, t.ONE
    negative, first = signed(node.factors[0])
    rest = node.factors[1:]
    if rest and first == t.ONE:
        deeper, body = signed(t.Mul(rest))
        return negative != deeper, body
    return negative, t.Mul((first, *rest)) if rest else first


def factors_of(node: t.Mul) -> list[t.Node]:
    """The factors, those of products inside and without ones."""
    bare = [_unsigned(factor) for factor in node.factors]
    flat = [part for f in bare for part in (factors_of(f) if isinstance(f, t.Mul) else [f])]
    kept = [factor for factor in flat if factor != t.ONE]
    return kept or [t.ONE]


def _unsigned(node: t.Node) -> t.Node:
    """The node without a double minus."""
    negative, body = signed(node)
    return t.Neg(body) if negative else body


_DOTS = {1: "dot", 2: "ddot", 3: "dddot"}
_UNITS = {"x": "ı", "y": "ȷ", "z": "k"}


def glyph_box(glyph: Glyph, vector: str = "") -> b.Box:
    """The boxes of a glyph; `vector` is "vec", "bold" or "" for a scalar."""
    box: b.Box = b.Letter(glyph.base, glyph.style)
    dots = _DOTS.get(glyph.dots, "dddot" if glyph.dots else "")
    for accent in (glyph.accent, vector, dots):
        box = b.Accent(accent, box) if accent else box
    sup = b.Prime(glyph.primes) if glyph.primes else None
    box = b.Script(box, _subscripts(glyph), sup) if sup or glyph.subs else box
    return b.Row((b.Letter(glyph.prefix, "upright"), box)) if glyph.prefix else box


def _subscripts(glyph: Glyph) -> b.Box | None:
    """All subscripts of a glyph, with commas between."""
    items: list[b.Box] = []
    for sub in glyph.subs:
        items += [b.Operator(",", "mark")] if items else []
        items.append(glyph_box(sub))
    return (items[0] if len(items) == 1 else b.Row(tuple(items))) if items else None


def unit_box(axis: str) -> b.Box:
    """î, ĵ or k̂."""
    return b.Accent("hat", b.Letter(_UNITS[axis]))


def attached(box: b.Box) -> bool:
    """Can a superscript be put on the box without parentheses?"""
    if isinstance(box, b.Script):
        return box.sup is None or isinstance(box.sup, b.Prime)
    return not isinstance(box, b.Row)


def attach_sup(box: b.Box, sup: b.Box) -> b.Box:
    """The box with a superscript, over its subscript and after its primes."""
    if not isinstance(box, b.Script):
        return b.Script(box, None, sup)
    return replace(box, sup=b.Row((box.sup, sup)) if box.sup else sup)
