"""LaTeX tokens -> what packages write: derivatives of `physics`, numbers of `siunitx`; what has no value is refused by name."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.expr.latex.formal import numeral, taken_at
from rbpsym.expr.latex.functions import whole_number
from rbpsym.expr.latex.grammar import argument
from rbpsym.expr.latex.numerals import DEGREE
from rbpsym.expr.latex.tokens import Token, closed
from rbpsym.expr.symbol_table import COMMANDS, LatexReader, begins
from rbpsym.frozen import replace


@begins(r"\dv", r"\pdv")
def _derivative(reader: LatexReader) -> t.Node:
    r"""\dv{f}{x}, \dv[2]{f}{x}, and \dv{t} in front of what it stands for; \pdv{f}{x}{y} too: as the fraction that they print."""
    begin, head, groups = reader.position, reader.take(), list[tuple[Token, ...]]()
    reader.pass_sign("*")
    order = whole_number(reader, "the order of a derivative", 1, 9) if reader.sees_sign("[") else 1
    while reader.sees_sign("{") and len(groups) < (2 if order > 1 or head.text == r"\dv" else 4):
        place, reader.position = reader.position, closed(reader.tokens, reader.position) + 1
        groups.append(reader.tokens[place + 1 : reader.position - 1])
    *of, last = groups or [()]
    by = [*of[1:], last]
    power = (replace(head, kind="sign", text="^"), replace(head, kind="digit", text=str(max(order, len(by)))))
    opening, closing, d = (replace(head, kind="sign", text=text) for text in ("{", "}", "d" if head.text == r"\dv" else "∂"))
    d = replace(d, kind="differential")
    below = [token for one in by for token in (d, *one, *(power if order > 1 else ()))]
    above = (d, *(power if max(order, len(by)) > 1 else ()), *(of[0] if of else ()))
    fraction = (replace(head, text=r"\frac"), opening, *above, closing, opening, *below, closing)
    reader.tokens, reader.position = (*reader.tokens[:begin], *fraction, *reader.tokens[reader.position :]), begin
    return COMMANDS[r"\frac"](reader)


@begins(r"\abs", r"\norm", r"\vqty")
def _magnitude(reader: LatexReader) -> t.Node:
    start = reader.take().start
    reader.pass_sign("*")
    return reader.spanned(t.Abs(argument(reader)), start)


@begins(r"\eval")
def _evaluated(reader: LatexReader) -> t.Node:
    r"""\eval{f}_{x = 0}"""
    start = reader.take().start
    reader.pass_sign("*")
    of = argument(reader)
    return taken_at(reader, of, start) if reader.sees_sign("_") else of


@begins(r"\num", r"\ang")
def _number(reader: LatexReader) -> t.Node:
    head = reader.take()
    found = numeral(reader)
    return reader.spanned(t.mul(found, DEGREE), head.start) if head.text == r"\ang" else found
