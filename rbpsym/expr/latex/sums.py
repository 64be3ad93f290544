"""LaTeX tokens -> sums: over an index, over what is named, or the terms written out."""

from __future__ import annotations

import re
from dataclasses import replace

from rbpsym.expr import tree as t
from rbpsym.expr.latex.formal import bounded, is_below, over_an_index
from rbpsym.expr.latex.grammar import argument, begins_factor, multiplied, term_of
from rbpsym.expr.latex.names import begins_name, read_name
from rbpsym.expr.latex.tokens import Token
from rbpsym.expr.symbol_table import LatexReader, begins

MOST_TERMS = 12
_COUNTED = re.compile(r"_\s*\{\s*([a-z])\s*=\s*(\d)\s*\}\s*\^\s*(?:\{\s*(?:\1\s*=\s*)?(\d+)\s*\}|(\d))")


@begins(r"\sum")
def _sum(reader: LatexReader) -> t.Node:
    """A sum over an index; without one, ΣF is a name."""
    first, sign = reader.position, reader.take()
    if not reader.sees_sign("_", "^"):
        if not begins_name(reader.token):
            return over_an_index(reader, "sum", sign.start)
        reader.position = first
        name = read_name(reader)
        if not (reader.table.open and begins_factor(reader)):  # ΣF_x, and no Σ m_i v_i
            return reader.spanned(name, sign.start)
        reader.position = first + 1
        return over_an_index(reader, "sum", sign.start)
    begin = reader.position
    reader.pass_sign("_")
    braces, index = reader.pass_sign("{"), reader.take()
    whole = not (braces and reader.pass_sign("=")) or reader.take().text == "1"
    whole = whole and (not braces or reader.pass_sign("}"))
    if [reader.ahead(k).text for k in range(4)] == ["^", "{", index.text, "="]:  # up to i = N
        reader.tokens = (*reader.tokens[: reader.position + 2], *reader.tokens[reader.position + 4 :])
    upper = argument(reader) if whole and reader.pass_sign("^") else None
    counts = isinstance(upper, t.Sym) and upper.span and is_below(reader, reader.source.text[slice(*upper.span)])
    if index.kind == "letter" and whole and isinstance(upper, (t.Sym, type(None))) and not counts:
        return reader.spanned(t.Sum(bounded(reader, term_of(reader), begin), index.text), sign.start)
    reader.position = begin
    return _written_out(reader, sign) or over_an_index(reader, "sum", sign.start)


def _written_out(reader: LatexReader, sign: Token) -> t.Node | None:
    """The terms of a sum from a number to a number whose index stands in subscripts alone; else None, and nothing is passed."""
    begin, tokens, terms = reader.position, reader.tokens, []
    counted = _COUNTED.match(reader.source.text, reader.token.start)
    last = counted.end() if counted else 0
    index, low, high = (counted[1], int(counted[2]), int(counted[3] or counted[4])) if counted else ("", 0, -1)
    for count in range(low, high + 1 if high - low < MOST_TERMS else low):
        reader.position = behind = next(k for k in range(begin, len(tokens)) if tokens[k].start >= last)
        reader.tokens = _numbered(tokens, behind, index, str(count))
        terms.append(multiplied(reader))
        if index in {token.text for token in reader.tokens[behind : reader.position]}:
            reader.tokens, reader.position = tokens, begin
            return None
    reader.tokens = tokens
    return reader.spanned(t.Group(t.Add(tuple(terms))) if len(terms) > 1 else terms[0], sign.start) if terms else None


def _numbered(tokens: tuple[Token, ...], begin: int, index: str, count: str) -> tuple[Token, ...]:
    """The tokens with a number for an index that stands in a subscript, alone or beside letters."""
    found, depth = list(tokens), 0
    for k in range(begin, len(tokens) - 1):
        before, behind = tokens[k - 1].text, tokens[k + 1].text
        depth += (tokens[k].text == "{" and (depth > 0 or before == "_")) - (depth > 0 and tokens[k].text == "}")
        if tokens[k].text == index and (before == "_" or depth) and not {"+", "-", "/"}.intersection((before, behind)):
            found[k] = replace(tokens[k], kind="digit", text=count)
    return tuple(found)
