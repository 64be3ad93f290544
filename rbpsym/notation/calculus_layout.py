"""Boxes of derivatives, integrals, brackets, changes and limits."""

from __future__ import annotations

from dataclasses import replace

from rbpsym.notation import boxes as b
from rbpsym.notation import tree as t
from rbpsym.notation.setting import ATOM, CROSS, PRODUCT, Style, attach_sup, draw, draws, fenced, glyph_box, wrapped


@draws(t.Deriv)
def _deriv(node: t.Deriv, style: Style) -> b.Box:
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


def _over(num: b.Box, den: b.Box, style: Style) -> b.Box:
    if style.mode != "text":
        return b.Fraction(num, den)
    return b.Row((num, b.Operator("/", "mark"), den))


def _number(n: int) -> b.Letter:
    return b.Letter(str(n), "number")


def _d(style: Style, *, partial: bool = False) -> b.Letter:
    """The d of a differential."""
    return b.Letter("∂" if partial else "d", style.notation.differential)


@draws(t.Integral)
def _integral(node: t.Integral, style: Style) -> b.Box:
    inner = style.script
    sign = b.Script(b.Big("∫"), draw(node.lower, inner), draw(node.upper, inner))
    differential = b.Row((_d(style), glyph_box(style.notation.glyph(node.var))))
    return _integrated(sign, node.integrand, differential, style)


@draws(t.BodyIntegral)
def _body_integral(node: t.BodyIntegral, style: Style) -> b.Box:
    name = style.notation.glyph(node.body)
    name = replace(name, style="upright") if name.base.isascii() and name.base.isalpha() else name  # no limit, a body
    sign = b.Script(b.Big("∫"), glyph_box(name))
    spread = t.spread(node.integrand)
    if spread is not None:
        return b.Row((sign, *_against(*spread, style)))
    differential = b.Row((_d(style), b.Letter("m")))
    return _integrated(sign, node.integrand, differential, style)


def _against(arm: t.Node, product: str, of: t.Node, style: Style) -> tuple[b.Box, ...]:
    """a × db, as people write it instead of a × (db/dm) dm."""
    differential = b.Row((_d(style), draw(of, style)))
    return wrapped(arm, CROSS, style), b.Operator("·" if product == "dot" else "×"), differential


def _integrated(sign: b.Box, integrand: t.Node, d: b.Box, style: Style) -> b.Box:
    if integrand == t.ONE:
        return b.Row((sign, d))
    return b.Row((sign, wrapped(integrand, CROSS, style), b.Space(), d))


@draws(t.PathIntegral)
def _path_integral(node: t.PathIntegral, style: Style) -> b.Box:
    sign = {"dot": b.Operator("·"), "cross": b.Operator("×")}.get(node.product, b.Space())
    integrand = wrapped(node.integrand, PRODUCT, style)
    differential = b.Row((_d(style), wrapped(node.path, ATOM, style)))
    return b.Row((b.Big("∫"), integrand, sign, differential))


@draws(t.Bracket)
def _bracket(node: t.Bracket, style: Style) -> b.Box:
    body = b.Fence("[", draw(node.arg, style), "]", tall=True)
    lower, upper = (draw(end, style.script) for end in (node.lower, node.upper))
    if node.upper != t.Sym(node.var):
        variable = glyph_box(style.notation.glyph(node.var))
        equals = b.Operator("=", "relation")
        lower, upper = (b.Row((variable, equals, end)) for end in (lower, upper))
    return b.Script(body, lower, upper)


@draws(t.Sum)
def _sum(node: t.Sum, style: Style) -> b.Box:
    sign = b.Script(b.Big("∑"), glyph_box(style.notation.glyph(node.index)))
    return b.Row((sign, wrapped(node.term, CROSS, style)))


@draws(t.Delta)
def _delta(node: t.Delta, style: Style) -> b.Box:
    return b.Row((b.Letter("Δ", "upright"), wrapped(node.arg, ATOM, style)))


@draws(t.At)
def _at(node: t.At, style: Style) -> b.Box:
    body = b.Fence("", draw(node.arg, style), "|", tall=True)
    return b.Script(body, draw(node.condition, style.script))


@draws(t.Limit)
def _limit(node: t.Limit, style: Style) -> b.Box:
    variable = glyph_box(style.notation.glyph(node.var))
    arrow = b.Operator("→", "relation")
    to = draw(node.to, style.script)
    sign = b.Under(b.Function("lim"), b.Row((variable, arrow, to)))
    return b.Applied(sign, wrapped(node.arg, CROSS, style))
