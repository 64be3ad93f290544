"""How one side of a relation that is too wide is cut: before the signs of its sum, then within parentheses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen
from rbpsym.typeset import boxes as b
from rbpsym.typeset.layout import layout

# --- how wide a formula is, in em: estimates from the boxes that `typeset.layout` makes of the display tree


@lru_cache(maxsize=4096)
def width(box: b.Box) -> float:
    """The width of a box in display style, in em."""
    return WIDTHS[type(box)](box)


def script_width(box: b.Script) -> float:
    """The base, and the wider of its two small scripts."""
    scripts = [width(part) for part in (box.sub, box.sup) if part]
    return width(box.base) + 0.7 * max(scripts, default=0.0)


OPERATORS = {"binary": 1.15, "prefix": 0.8, "relation": 1.35, "mark": 0.4}

WIDTHS: Mapping[type, Callable[..., float]] = {
    b.Letter: lambda box: sum(0.72 if char.isupper() else 0.53 for char in box.text),
    b.Script: script_width,
    b.Fence: lambda box: width(box.body) + (0.5 if box.tall else 0.4) * sum(map(bool, (box.opening, box.closing))),
    b.Phrase: lambda box: 0.5 * len(box.text) + 0.6,
    b.Operator: lambda box: OPERATORS.get(box.kind, 1.0),
    b.Big: lambda box: 1.0,
    b.Thin: lambda box: 0.17,
    b.Times: lambda box: 0.08,
    b.Accent: lambda box: width(box.body),
    b.Prime: lambda box: 0.3 * box.count,
    b.Under: lambda box: max(width(box.base), 0.7 * width(box.under)),
    b.Fraction: lambda box: max(width(box.num), width(box.den)) + 0.25,
    b.Radical: lambda box: width(box.body) + 0.9,
    b.Function: lambda box: 0.5 * len(box.name) + 0.17,
    b.Applied: lambda box: width(box.head) + 0.1 + width(box.arg),
    b.Row: lambda box: sum(map(width, box.items)),
    b.Rows: lambda box: max(width(left) + width(right) for left, right in box.rows),
}


# ---


INDENT = 2.0  # em, of a line that goes on with the sum of the line above
SIGNS = frozenset("+−-")

ONE = b.Letter("1", "number")


def opened(box: b.Box, room: float) -> tuple[b.Row, ...]:
    """The terms of a sum; one that is too wide is cut within its longest parentheses, and so on."""
    return tuple(piece for term in terms(box) for piece in pieces(term, room - INDENT))


def pieces(term: b.Row, room: float) -> tuple[b.Row, ...]:
    """A term, or what it is cut into, level by level, until each piece has room (or can't be cut)."""
    if width(term) <= room:
        return (term,)
    found = cut(with_slash(term, room))
    return found if len(found) == 1 else tuple(piece for part in found for piece in pieces(part, room))


def cut(term: b.Row) -> tuple[b.Row, ...]:
    """A term cut at the signs within its longest parentheses, the term itself if there are none."""
    items = tuple(part for item in term.items for part in spelled(item))
    inner = [(k, item, inside(item)) for k, item in enumerate(items) if isinstance(item, b.Fence)]
    longer = [found for found in inner if len(found[2]) > 1]
    if not longer:
        return (term,)
    place, fence, (first, *middle, last) = max(longer, key=lambda found: width(found[1]))
    before = b.Row((*items[:place], *half(fence.opening, first, "", fence.tall)))
    after = b.Row((*half("", last, fence.closing, fence.tall), *items[place + 1 :]))
    return before, *middle, after


def inside(fence: b.Fence) -> tuple[b.Row, ...]:
    """The terms within parentheses; where there is one, what it is cut into."""
    found = terms(fence.body)
    return found if len(found) > 1 else cut(b.Row(tuple(flat(fence.body))))


def half(opening: str, body: b.Row, closing: str, tall: bool) -> tuple[b.Box, ...]:
    """One of a pair of parentheses with what stands at it; a sign before it keeps its spaces outside."""
    if not opening and not closing:
        return body.items
    sign = 1 if not opening and isinstance(body.items[0], b.Operator) else 0
    return (*body.items[:sign], b.Fence(opening, b.Row(body.items[sign:]), closing, tall))


def spelled(item: b.Box) -> tuple[b.Box, ...]:
    """A long sum over a denominator as one over the denominator times the sum."""
    if isinstance(item, b.Fraction) and len(terms(item.num)) > 2:
        one = b.Fraction(ONE, item.den)
        return one, b.Times(), b.Fence("(", item.num, ")", b.is_tall(item.num))
    return (item,)


def with_slash(term: b.Row, room: float) -> b.Row:
    """A fraction over a sum that is too wide itself is written with a slash, at the end of its term."""
    items = term.items
    for k, item in enumerate(items):
        if isinstance(item, b.Fraction) and room and width(item.den) > 0.8 * room:
            sign = k if all(isinstance(other, b.Operator) for other in items[:k]) else 0
            above: tuple[b.Box, ...]
            above = (b.Fence("(", item.num, ")", b.is_tall(item.num)),) if len(terms(item.num)) > 1 else (item.num,)
            below = b.Fence("(", item.den, ")", b.is_tall(item.den))
            behind = items[k + 1 :]
            if item.num == ONE and behind:  # one over something, times what follows it
                above, behind = (), behind[isinstance(behind[0], b.Times) :]
            factors = tuple(flat(b.Row((*items[sign:k], *above, *behind))))
            if isinstance(factors[-1], b.Applied):  # what the slash divides is not the argument
                factors = (b.Fence("[", b.Row(factors), "]", b.is_tall(b.Row(factors))),)
            return b.Row((*items[:sign], *factors, b.Operator("/", "mark"), below))
    return term


def flat(box: b.Box) -> Iterator[b.Box]:
    """The boxes side by side, rows within rows opened."""
    if isinstance(box, b.Row):
        for item in box.items:
            yield from flat(item)
    else:
        yield box


def terms(box: b.Box) -> tuple[b.Row, ...]:
    """The terms of a sum, each with the sign before it (the first with its relation sign)."""
    groups: list[list[b.Box]] = [[]]
    for item in flat(box):
        if isinstance(item, b.Operator) and item.kind == "binary" and item.sign in SIGNS:
            groups.append([])
        groups[-1].append(item)
    return tuple(b.Row(tuple(group)) for group in groups if group)


def packed(parts: tuple[b.Row, ...], room: float) -> Iterator[b.Row]:
    """The terms in groups that each fit the room (one that does not stands alone)."""
    groups: list[tuple[b.Box, ...]] = [()]
    for part in parts:
        if groups[-1] and width(b.Row((*groups[-1], *part.items))) > room:
            groups.append(())
        groups[-1] = (*groups[-1], *part.items)
    depth = 0
    for group in groups:
        row, depth = fenced_together(group, depth)
        yield row


def fenced_together(items: tuple[b.Box, ...], depth: int) -> tuple[b.Row, int]:
    """A line whose cut parentheses hold all that stands between them on this line, so that they grow with it.

    `depth` pairs were opened on the lines before; the second value is how many are open after it.
    """
    sign = items[:1] if isinstance(items[0], b.Operator) else ()  # it keeps its spaces outside
    frames: list[list[b.Box]] = [[]]
    opened_here: list[b.Fence] = []
    closed = 0
    for item in halves(items[len(sign) :]):
        if not isinstance(item, Half):
            frames[-1].append(item)
        elif item.opens:
            opened_here.append(item.fence)
            frames.append([])
        elif opened_here:
            inner, fence = frames.pop(), opened_here.pop()
            frames[-1].append(b.Fence(fence.opening, b.Row(tuple(inner)), item.fence.closing, fence.tall))
        else:
            closed += 1
            frames[0] = [b.Fence("", b.Row(tuple(frames[0])), item.fence.closing, item.fence.tall)]
    left = len(opened_here)
    while opened_here:
        inner, fence = frames.pop(), opened_here.pop()
        frames[-1].append(b.Fence(fence.opening, b.Row(tuple(inner)), "", fence.tall))
    return b.Row((*sign, *frames[0])), depth - closed + left


class Half(Frozen):
    """One of a pair of parentheses that was cut: where it opens or closes."""

    fence: b.Fence
    opens: bool


def halves(items: tuple[b.Box, ...]) -> Iterator[b.Box | Half]:
    """The boxes of a line, cut parentheses (also those within others) as marks."""
    for item in items:
        if not isinstance(item, b.Fence) or (item.opening and item.closing):
            yield item
            continue
        if item.opening:
            yield Half(item, True)
        yield from halves(tuple(flat(item.body)))
        if item.closing:
            yield Half(item, False)


def node_width(node: Node, notation: Notation = DEFAULT) -> float:
    """The width of a formula on one line, in em."""
    return width(layout(node, notation))


def node_height(node: Node, notation: Notation = DEFAULT) -> float:
    """The height of a formula, in em."""
    return height(layout(node, notation))


def height(box: b.Box) -> float:
    """A line is one em high; fractions stand on each other, scripts reach out a little."""
    inner = max(map(height, b.parts(box)), default=1.0)
    if isinstance(box, b.Fraction):
        return height(box.num) + height(box.den) + 0.2
    return inner + 0.25 if isinstance(box, (b.Script, b.Accent, b.Radical)) else inner
