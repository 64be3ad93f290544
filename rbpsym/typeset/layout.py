"""Display tree -> boxes: every decision of textbook typesetting, made once for all formats."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Notation
from rbpsym.expr.tree import Node
from rbpsym.typeset import algebra_layout
from rbpsym.typeset import boxes as b
from rbpsym.typeset.setting import ATOM, CROSS, PRODUCT, SUM, LayoutStyle, attach_sup, draw, draws, fenced, glyph_box, wrapped

# --- boxes of derivatives, integrals, brackets, changes and limits


@draws(t.Deriv)
def _deriv(node: t.Deriv, style: LayoutStyle) -> b.Box:
    d = _d(style, partial=node.partial)
    top = d if node.order == 1 else attach_sup(d, _number(node.order))
    wrt = glyph_box(style.notation.glyph(node.wrt))
    below = wrt if node.order == 1 else attach_sup(wrt, _number(node.order))
    bottom = b.Row((d, below))
    if isinstance(node.of, (t.Sym, t.Vec)):
        return _over(b.Row((top, draw(node.of, style))), bottom, style)
    body = draw(node.of, style)
    return b.Row(
        (
            _over(top, bottom, style),
            body if isinstance(node.of, t.Group) else fenced(body),
        )
    )


def _over(num: b.Box, den: b.Box, style: LayoutStyle) -> b.Box:
    if style.mode != "text":
        return b.Fraction(num, den)
    return b.Row((num, b.Operator("/", "mark"), den))


def _number(n: int) -> b.Letter:
    return b.Letter(str(n), "number")


def _d(style: LayoutStyle, *, partial: bool = False) -> b.Letter:
    """The d of a differential."""
    return b.Letter("∂" if partial else "d", style.notation.differential)


@draws(t.Integral)
def _integral(node: t.Integral, style: LayoutStyle) -> b.Box:
    inner = style.script
    sign = b.Script(b.Big("∫"), draw(node.lower, inner), draw(node.upper, inner))
    differential = b.Row((_d(style), glyph_box(style.notation.glyph(node.var))))
    return _integrated(sign, node.integrand, differential, style)


@draws(t.BodyIntegral)
def _body_integral(node: t.BodyIntegral, style: LayoutStyle) -> b.Box:
    name = style.notation.glyph(node.body)
    name = replace(name, style="upright") if name.base.isascii() and name.base.isalpha() else name  # no limit, a body
    sign = b.Script(b.Big("∫"), glyph_box(name))
    spread = t.spread(node.integrand)
    if spread is not None:
        return b.Row((sign, *_against(*spread, style)))
    differential = b.Row((_d(style), b.Letter("m")))
    return _integrated(sign, node.integrand, differential, style)


def _against(arm: t.Node, product: str, of: t.Node, style: LayoutStyle) -> tuple[b.Box, ...]:
    """a × db, as people write it instead of a × (db/dm) dm."""
    differential = b.Row((_d(style), draw(of, style)))
    return wrapped(arm, CROSS, style), b.Operator("·" if product == "dot" else "×"), differential


def _integrated(sign: b.Box, integrand: t.Node, d: b.Box, style: LayoutStyle) -> b.Box:
    if integrand == t.ONE:
        return b.Row((sign, d))
    return b.Row((sign, wrapped(integrand, CROSS, style), b.Thin(), d))


@draws(t.PathIntegral)
def _path_integral(node: t.PathIntegral, style: LayoutStyle) -> b.Box:
    sign = {"dot": b.Operator("·"), "cross": b.Operator("×")}.get(node.product, b.Thin())
    integrand = wrapped(node.integrand, PRODUCT, style)
    differential = b.Row((_d(style), wrapped(node.path, ATOM, style)))
    return b.Row((b.Big("∫"), integrand, sign, differential))


@draws(t.Bracket)
def _bracket(node: t.Bracket, style: LayoutStyle) -> b.Box:
    body = b.Fence("[", draw(node.arg, style), "]", tall=True)
    lower, upper = (draw(end, style.script) for end in (node.lower, node.upper))
    if node.upper != t.Sym(node.var):
        variable = glyph_box(style.notation.glyph(node.var))
        equals = b.Operator("=", "relation")
        lower, upper = (b.Row((variable, equals, end)) for end in (lower, upper))
    return b.Script(body, lower, upper)


@draws(t.Sum)
def _sum(node: t.Sum, style: LayoutStyle) -> b.Box:
    sign = b.Script(b.Big("∑"), glyph_box(style.notation.glyph(node.index)))
    return b.Row((sign, wrapped(node.term, CROSS, style)))


@draws(t.Delta)
def _delta(node: t.Delta, style: LayoutStyle) -> b.Box:
    return b.Row((b.Letter("Δ", "upright"), wrapped(node.arg, ATOM, style)))


@draws(t.At)
def _at(node: t.At, style: LayoutStyle) -> b.Box:
    body = b.Fence("", draw(node.arg, style), "|", tall=True)
    return b.Script(body, draw(node.condition, style.script))


@draws(t.Formal)
def _formal(node: t.Formal, style: LayoutStyle) -> b.Box:
    """What it is, and its parts in parentheses."""
    parts = [box for part in node.parts for box in (b.Operator(",", "mark"), b.Thin(), draw(part, style))][2:]
    return b.Row((b.Phrase(node.kind), b.Fence("(", b.Row(tuple(parts)), ")"))) if parts else b.Phrase(node.kind)


@draws(t.Limit)
def _limit(node: t.Limit, style: LayoutStyle) -> b.Box:
    variable = glyph_box(style.notation.glyph(node.var))
    arrow = b.Operator("→", "relation")
    to = draw(node.to, style.script)
    sign = b.Under(b.Function("lim"), b.Row((variable, arrow, to)))
    return b.Applied(sign, wrapped(node.arg, CROSS, style))


# ---


RELATIONS = {
    "=": "=", "<": "<", ">": ">", "<=": "≤", ">=": "≥", "!=": "≠", "~": "≈", "->": "→",
}  # fmt: skip


@draws(t.Relations)
def aligned(node: t.Node, style: LayoutStyle) -> b.Rows:
    """A chain or system as aligned rows; any other formula as one row without a left part."""
    if isinstance(node, t.Relations):
        return b.Rows(tuple(row for part in node.rows for row in aligned(part, style).rows))
    if not isinstance(node, t.Chain) or not node.ops:
        return b.Rows(((b.Row(()), draw(node, style)),))
    lefts = (draw(node.items[0], style), *(b.Row(()) for _ in node.ops[1:]))
    rights = (b.Row((_relation(op), draw(item, style))) for op, item in zip(node.ops, node.items[1:], strict=True))
    return b.Rows(tuple(zip(lefts, rights, strict=True)))


def _relation(op: str) -> b.Operator:
    return b.Operator(RELATIONS[op], "relation")


@draws(t.Chain)
def _chain(node: t.Chain, style: LayoutStyle) -> b.Box:
    items = [wrapped(node.items[0], SUM, style)]
    for op, item in zip(node.ops, node.items[1:], strict=True):
        items += [_relation(op), wrapped(item, SUM, style)]
    return b.Row(tuple(items))


DRAWN_BY = (algebra_layout,)  # loaded: they enter what they draw


@lru_cache(maxsize=4096)
def layout(node: t.Node, notation: Notation = DEFAULT, mode: str = "display") -> b.Box:
    """The boxes of a formula; `mode` is "display", "inline" or "text"."""
    return draw(node, LayoutStyle(notation, mode))


@lru_cache(maxsize=4096)
def layout_rows(node: t.Node, notation: Notation = DEFAULT) -> b.Rows:
    """A chain `a = b = c`, or a system, as rows that are aligned at their relation signs."""
    return aligned(node, LayoutStyle(notation))


# --- what all printers of formulas share: the walk over boxes, and what most of them print alike


# functions that are commands of their own in LaTeX and Typst
COMMANDS = frozenset(["sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "ln", "lim"])


class Printer:
    """A format of formulas: called with a box, it prints it by the form, or the method, that has the name of its kind.

    `forms` hold %(name)s for the print of each part; `signs` are those that the format writes in another way.
    """

    mode = "display"
    forms: Mapping[str, str] = {}
    signs: Mapping[str, str] = {}

    def __call__(self, box: b.Box) -> str:
        """The print of a box."""
        kind = type(box).__name__.lower()
        form = self.forms.get(kind)
        return str(getattr(self, kind)(box)) if form is None else form % self.parts(box)

    def parts(self, box: b.Box) -> dict[str, object]:
        """The parts of a box by name, boxes printed."""
        return {name: self(part) if isinstance(part, b.Box) else part for name, part in vars(box).items()}

    def formula(self, node: Node, notation: Notation) -> str:
        """The print of a formula."""
        return self(layout(node, notation, self.mode))

    def letter(self, box: b.Letter) -> str:
        """A letter in its style."""
        return str(getattr(self, f"in_{box.style}")(box.text))

    def operator(self, box: b.Operator) -> str:
        """A sign between what it acts on, or before it."""
        sign = self.signs.get(box.sign, box.sign)
        return sign if box.kind in ("prefix", "mark") else f" {sign} "

    def big(self, box: b.Big) -> str:
        """The sign of an integral or sum."""
        return self.signs.get(box.sign, box.sign)

    def times(self, box: b.Times) -> str:
        """What stands between factors."""
        return ""

    def function(self, box: b.Function) -> str:
        """The name of a function."""
        return box.name
