"""LaTeX tokens -> what packages write: derivatives of `physics`, numbers of `siunitx`; what has no value is refused by name."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.expr.latex.formal import formal, numeral, taken_at
from rbpsym.expr.latex.functions import operand, whole_number
from rbpsym.expr.latex.grammar import argument
from rbpsym.expr.latex.numerals import DEGREE
from rbpsym.expr.symbol_table import LatexReader, begins


@begins(r"\dv", r"\pdv")
def _derivative(reader: LatexReader) -> t.Node:
    r"""\dv{f}{x}, \dv[2]{f}{x}, and \dv{t} in front of what it stands for; \pdv{f}{x}{y} too."""
    head = reader.take()
    reader.pass_sign("*")
    order = _option(reader)
    begin, parts = reader.position, list[str | t.Node]()
    empty = reader.sees_sign("{") and reader.ahead().text == "}"
    reader.position += 2 * empty
    of = None if empty else argument(reader)
    while reader.sees_sign("{") and len(parts) < (1 if order > 1 or head.text == r"\dv" else 3):
        parts.append(_variable(reader))
    if not parts:
        reader.position = begin
        parts, of = [_variable(reader)], None
    of = operand(reader) if of is None else of
    named = [wrt for wrt in parts if isinstance(wrt, str)]
    if len(named) < len(parts):
        return formal(reader, head.start, "differential", of, *(one for one in parts if not isinstance(one, str)))
    for wrt in reversed(named):
        of = reader.spanned(t.Deriv(of, wrt, order, head.text == r"\pdv"), head.start)
    return of


def _option(reader: LatexReader) -> int:
    """The order in brackets, 1 without."""
    if not reader.sees_sign("["):
        return 1
    return whole_number(reader, "the order of a derivative", 1, 9)


def _variable(reader: LatexReader) -> str | t.Node:
    """The name of a symbol, or what else stands there, by which nothing is derived."""
    time = [reader.ahead(count).text for count in range(3)] == ["{", "t", "}"]
    reader.position += 3 * time
    node = t.Sym("t") if time else argument(reader)
    return node.name if isinstance(node, t.Sym) else node


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
