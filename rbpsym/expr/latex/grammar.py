"""LaTeX tokens -> tree: sums, vector products, products, powers, functions."""

from __future__ import annotations

import re
from dataclasses import replace

from rbpsym.errors import Incomplete, RbpsymError, UnknownName
from rbpsym.expr import tree as t
from rbpsym.expr.directed import is_vector
from rbpsym.expr.latex.names import begins_name, between_points, is_capital, letter_run, read_name
from rbpsym.expr.latex.numerals import number
from rbpsym.expr.latex.rows import OPEN
from rbpsym.expr.latex.scripts import label_after, mark_above
from rbpsym.expr.latex.small import is_small
from rbpsym.expr.latex.spelled import by_command
from rbpsym.expr.latex.tokens import END_COLUMN, Token
from rbpsym.expr.limits import number_of
from rbpsym.expr.symbol_table import COMMANDS, LatexReader, begins

SPACING = re.compile(r"\\[,;:> ]|\\q?quad(?![A-Za-z])|~")
BELOW = "is this factor above or below the slash?"
_PLAIN_BARS = frozenset({"|", r"\Vert"})


def expression(reader: LatexReader) -> t.Node:
    """term + term - term"""
    start = reader.token.start
    with reader.deeper():
        terms, own = [_evaluated(reader, term_of(reader))], False
        while goes_on(reader, "-") or reader.sees_sign("+", *_SIGNED):
            sign = reader.take()
            own = own or _is_taken(terms[-1])  # each term has its own bar
            term = _evaluated(reader, term_of(reader), None if own else start)
            terms.append(_signed(reader, term, sign) if sign.text != "+" else term)
    if _is_differential(terms[-1]) and any(isinstance(part, t.PathIntegral | t.Integral) for part in t.walk(t.Add(tuple(terms)))):
        what = "does this belong to the integral?"
        raise reader.source.error(what, start, reader.previous_end, "Put the integrand in parentheses.")
    return terms[0] if len(terms) == 1 else reader.spanned(t.Add(tuple(terms)), start)


def _is_taken(term: t.Node) -> bool:
    """Is it, or a part of it, taken at a place?"""
    return any(isinstance(part, t.At) or (isinstance(part, t.Formal) and part.kind in ("at", "between")) for part in t.walk(term))


_SIGNED = {"-": "", r"\pm": "±", r"\mp": "∓"}


def _signed(reader: LatexReader, term: t.Node, sign: Token) -> t.Node:
    kind = _SIGNED[sign.text]
    return reader.spanned(t.Formal(kind, (term,)) if kind else t.Neg(term), sign.start)


def _is_differential(term: t.Node) -> bool:
    term = term.arg if isinstance(term, t.Neg) else term
    parts = term.factors if isinstance(term, t.Mul) else (term,)
    return any(map(is_small, parts))


def term_of(reader: LatexReader) -> t.Node:
    """A product, with perhaps signs in front."""
    if reader.sees_sign(*_SIGNED):
        sign = reader.take()
        with reader.deeper():
            return _signed(reader, term_of(reader), sign)
    reader.pass_sign("+")
    return multiplied(reader)


def _sees_evaluation(reader: LatexReader) -> bool:
    """Does a bar follow behind which is said where what stands before it is taken: f|_{x=0}?"""
    return not reader.bars and reader.sees_sign(r"\lvert", *_PLAIN_BARS) and reader.ahead().text == "_"


def _evaluated(reader: LatexReader, term: t.Node, first: int | None = None) -> t.Node:
    """The term, or its value where a bar behind it says."""
    while _sees_evaluation(reader):
        if first is not None:
            raise reader.error("how much of this sum is taken there?", r"Write \left. ... \right|_{...}, or parentheses.")
        reader.take()
        term = COMMANDS["at"](reader, term, reader.previous_end)
    return term


def multiplied(reader: LatexReader) -> t.Node:
    """Products joined by a dot or cross; between vectors these are Dot and Cross."""
    start = reader.token.start
    node = _product(reader)
    while reader.sees_sign(r"\cdot", r"\times", "*", *_OPERATORS) and not ends_integrand(reader):
        sign = reader.take()
        if sign.text in _OPERATORS and reader.sees_sign("_"):
            label_after(reader)  # ⊗_A
        begin, negative = reader.token.start, reader.pass_sign("-")
        right = reader.spanned(t.Neg(_product(reader)), begin) if negative else _product(reader)
        while sign.text == r"\cdot" and reader.sees_sign(r"\times"):  # a · b × c
            cross = reader.take()
            right = reader.spanned(_joined(reader, right, _product(reader), cross), begin)
        wedge = sign.text == r"\wedge" and is_vector(node) and is_vector(right)  # how French and Italian texts print a cross
        formal = t.Formal(_OPERATORS[sign.text], (node, right)) if sign.text in _OPERATORS and not wedge else None
        node = reader.spanned(formal or _joined(reader, node, right, sign), start)
    return node


_OPERATORS = by_command("products")


def ends_integrand(reader: LatexReader) -> bool:
    """Does `\\cdot d\\vec R` follow, which belongs to the integral around?"""
    return bool(reader.integrals) and reader.sees_differential(1)


def _joined(reader: LatexReader, left: t.Node, right: t.Node, sign: Token) -> t.Node:
    if is_vector(left) and is_vector(right) and sign.text != "*":
        return (t.Dot if sign.text == r"\cdot" else t.Cross)(left, right)
    directed = [is_vector(side) or any(map(reader.table.directed, t.names(side))) for side in (left, right)]
    half = is_vector(left) != is_vector(right) and bool(t.names(left) and t.names(right))
    unknown = reader.table.open and all(t.names(side) or isinstance(side, t.Formal) for side in (left, right))
    if sign.text == r"\times" and (half or unknown or all(directed)):
        return t.Formal("crossed", (left, right))
    if sign.text == r"\cdot" and unknown:
        return t.Formal("dotted", (left, right))
    factors = [part for side in (left, right) for part in (side.factors if isinstance(side, t.Mul) else (side,))]
    return t.Mul(tuple(factors))


def _product(reader: LatexReader) -> t.Node:
    """Factors side by side, with perhaps a slash."""
    start = reader.token.start
    factors = [factor(reader)]
    while True:
        if reader.sees_sign("/"):
            factors = [_slash(reader, _one(reader, factors, start), start)]
        elif goes_on(reader) or begins_factor(reader):
            refuse_number(reader)
            factors.append(factor(reader))
        else:
            return _one(reader, factors, start)


def goes_on(reader: LatexReader, sign: str = "") -> bool:
    """Does a sum (with this sign) or product go on where rows or gaps may part two relations? The parting is passed then."""
    token, place = reader.token, reader.position
    if token.kind != "row" or token.text != OPEN or (reader.ahead().text == "-") != bool(sign):
        return False
    question, hint = "is this one formula, or are these two?", "Write a comma between two relations."
    if reader.decide(question, hint, no=int(not sign)):
        reader.position += 1
        return True
    reader.tokens = (*reader.tokens[:place], replace(token, text=""), *reader.tokens[place + 1 :])
    return False


def _one(reader: LatexReader, factors: list[t.Node], start: int) -> t.Node:
    factors = between_points(reader, factors) if reader.table.open else factors
    if len(factors) == 1:
        return factors[0]
    for place, part in enumerate(factors):
        path = part.path if isinstance(part, t.PathIntegral) else t.Sym(part.var) if isinstance(part, t.Integral) else None
        if path and any(reader.table.open or t.names(path) & t.names(one) for one in factors[place + 1 :]):  # ∫ r dr e^{−r²}
            raise reader.error("does this belong to the integral?", "Put the integrand in parentheses.")
    return reader.spanned(t.Mul(tuple(factors)), start)


def _slash(reader: LatexReader, num: t.Node, start: int) -> t.Node:
    """num / den: what stands side by side behind the slash may belong below it."""
    reader.take()
    closed, begin = reader.sees_sign("(", "[", "{", r"\{"), reader.token.start
    below = [factor(reader)]
    while not closed and begins_factor(reader):
        refuse_number(reader)
        if not _is_below(reader, num, below):
            break
        below.append(factor(reader))
    return reader.spanned(t.Div(num, _one(reader, below, begin)), start)


def _is_below(reader: LatexReader, num: t.Node, below: list[t.Node]) -> bool:
    """Does the next factor stand below the slash? In v²/2g it does, in 1/2 m it hardly does; 1/2π can be either."""
    coefficient = len(below) == 1 and isinstance(below[0], t.Num)
    half = coefficient and number_of(num) is not None
    if half and reader.token.text != "π" and reader.table.faults is None:
        return False
    question, hint = BELOW, "Use parentheses, or \\frac."
    close = reader.token.kind == "letter" and reader.token.start == reader.previous_end
    if reader.table.open and close and reader.token.text.isupper() and is_capital(reader, below[-1]):
        return True
    if half:
        return reader.decide(question, hint, yes=int(reader.token.text != "π"))
    return reader.decide(question, hint, no=int(coefficient and close))


UNKNOWN_COMMAND = r"Define it in the text with \newcommand, or write the formula without it."


def begins_factor(reader: LatexReader) -> bool:
    """Does something that can be multiplied follow?"""
    token = reader.token
    if reader.sees_differential():
        return not reader.integrals
    if (reader.bars and token.text in _PLAIN_BARS) or _sees_evaluation(reader):
        return False
    known = token.kind in ("digit", "letter", "text") or begins_name(token)
    return known or (token.text in COMMANDS and token.text not in _OPERATORS)


def refuse_number(reader: LatexReader) -> None:
    """Raise ReadError for 2 3."""
    before, place = reader.tokens[reader.position - 1], reader.position
    behind = before.text in ("}", END_COLUMN) and reader.ahead(-2).text != "^"
    scripted = before.kind == "digit" and reader.ahead(-2).text in ("^", "_") and before.end < reader.token.start  # k^3 2ω
    while scripted and reader.token.kind == "digit":
        reader.take()
    while before.kind in ("letter", "text") and reader.token.kind == "digit":
        reader.take()
    behind, reader.position = behind or (reader.position > place and begins_factor(reader)), place  # B2\pi f
    if reader.token.kind == "digit" and not behind and reader.token.end == reader.token.start + 1:  # a zero in bold is no digit
        raise reader.error("a number can't follow here without a sign", r"Write \cdot.")


def factor(reader: LatexReader) -> t.Node:
    """An atom with its powers."""
    start, first, is_open = reader.token.start, reader.position, reader.table.open
    closed = reader.sees_sign("(", "[", r"\{", r"\frac", r"\dv", r"\pdv")
    base = atom(reader)
    while closed and _sees_evaluation(reader):
        reader.take()
        base = COMMANDS["at"](reader, base, start)
    while reader.sees_sign("^"):
        if (not isinstance(base, t.Num) or base == t.ZERO) and (mark := mark_above(reader, isinstance(base, (t.Sym, t.Vec)))):
            base = base if is_open else COMMANDS["applied"](reader, base, first)  # q^T(t)
            whole = t.Formal("marked", (base, t.Word(mark))) if mark != "transposed" else t.Formal(mark, (base,))
            base = COMMANDS["called"](reader, reader.spanned(whole, start))
            continue
        reader.take()
        exponent, named = _exponent(reader), isinstance(base, (t.Sym, t.Vec))
        base = COMMANDS["applied"](reader, base, first, raised=True) if named and not is_open else base  # r²(z)
        is_value = isinstance(base, t.Formal) and base.kind == "value"  # b(t - u)² may be the square of the brackets alone
        is_sign = named or isinstance(base, t.Delta) or (isinstance(base, t.Formal) and base.kind in ("∂", "∇", "varied"))
        several = isinstance(exponent, t.Num) and isinstance(exponent.value, int) and exponent.value > 9  # g^{12}
        counted = number_of(exponent) is not None and not isinstance(exponent, t.Num) and _COUNTED.search(reader.source.text)
        listed = reader.tokens[first].text == "[" and isinstance(exponent, t.Sym) and exponent.name in "ijkmn"  # [D_t u]^n
        named_above = bool(t.names(exponent) - {"pi"}) or several or counted
        index = is_open and (is_value or listed or (is_sign and named_above))
        power = t.Formal("raised", (base, exponent)) if index else reader.power(base, exponent, start)
        base = COMMANDS["called"](reader, reader.spanned(power, start)) if named else power
    while reader.sees_sign("_", "'", "!", r"\prime"):
        label = (t.Word(label_after(reader)),) if reader.sees_sign("_") else ()
        kind = "marked" if label or reader.take().text != "!" else "factorial"
        base = COMMANDS["called"](reader, reader.spanned(t.Formal(kind, (base, *label)), start))
        if reader.pass_sign("^"):
            base = reader.power(base, argument(reader), start)
    return base


_COUNTED = re.compile(r"[A-Za-df-z}]\s*\^\s*(?:\{\s*)?[01](?![\d/.])")  # where u^0 stands, u^{-1} is no 1/u


def _exponent(reader: LatexReader) -> t.Node:
    """What is raised; in a typed x^1/2 it may be one half, since nobody writes a first power."""
    node = argument(reader)
    half = node == t.ONE and reader.sees_sign("/") and reader.ahead().kind == "digit" and reader.table.faults
    if not half or not reader.decide("is the exponent a fraction?", "Write x^{1/2}.", yes=1):
        return node
    reader.take()
    return t.Div(node, number(reader))


def atom(reader: LatexReader) -> t.Node:
    """A number, a name, or what a command begins; with what it is taken of in parentheses behind it."""
    first = reader.position
    run = letter_run(reader) if reader.table.open else None
    return COMMANDS["applied"](reader, run or bare_atom(reader), first)


def bare_atom(reader: LatexReader) -> t.Node:
    """The same without what stands in parentheses behind it."""
    token = reader.token
    if token.kind == "digit":
        return number(reader)
    with reader.deeper():
        if reader.sees_differential() and (derivative := COMMANDS["d/"](reader)):
            return derivative
        if reader.sees_differential() and not reader.integrals:
            return _differential(reader)
        if token.text in COMMANDS and token.kind in ("sign", "command"):
            return COMMANDS[token.text](reader)
        if token.text == r"\cdot" and reader.ahead().text in (")", "]", ","):  # f(x, ·)
            return reader.spanned(t.Formal("·"), reader.take().start)
        if (power := _exponential(reader)) is not None:
            return power
        if begins_name(token):
            return COMMANDS["name"](reader)
    raise _missing(reader)


def _differential(reader: LatexReader) -> t.Node:
    """dx, d²x or d(xy) that stands alone."""
    place, italic, start = reader.position, reader.token.kind == "letter", reader.take().start
    if reader.sees_sign("_"):
        return reader.spanned(t.Formal("∂", (t.Word(label_after(reader)),)), start)
    order = (argument(reader),) if reader.pass_sign("^") else (t.Word("inexact"),) if reader.pass_sign("'") else ()
    inner = atom(reader) if begins_factor(reader) else None
    above = reader.ahead(1 + (reader.ahead().text == "{")).kind if inner is not None and reader.sees_sign("^") else ""
    if inner is not None and above == "letter":
        reader.take()
        inner = reader.power(inner, argument(reader), start)  # dx^i is (dx)^2 with a number only
    if inner is None and italic:  # a length d: nothing follows that could change
        reader.position = place
        return COMMANDS["name"](reader)
    if inner is None:
        raise reader.error("a differential alone has no value", r"Write rates: \frac{dW}{dt} = ...")
    return reader.spanned(t.Formal("differential", (inner, *order)), start)


def _exponential(reader: LatexReader) -> t.Node | None:
    """e^{...} where e is no symbol: an upright e, or an exponent that holds symbols; else nothing is passed."""
    token, begin = reader.token, reader.position
    if token.text != "e" or token.kind not in ("letter", "text") or reader.ahead().text != "^" or reader.table.has_e:
        return None
    braces = reader.ahead(2).text == "{"
    if reader.ahead(2 + braces).text in ("+", "-") and (not braces or reader.ahead(4).text == "}"):  # e^{+}, a particle
        return None
    reader.position += 2
    exponent = argument(reader)
    if token.kind == "text" or t.names(exponent) - {"pi"}:
        return reader.spanned(t.Fn("exp", exponent), token.start)
    reader.position = begin
    return None


def _missing(reader: LatexReader) -> RbpsymError:
    token = reader.token
    if token.kind == "end":
        return reader.error("the formula ends too early", "A number or symbol is missing here.", kind=Incomplete)
    if token.kind == "command":
        return reader.error(f"the command “{token.text}” is not known here", UNKNOWN_COMMAND, kind=UnknownName)
    return reader.error(f"“{token.text}” stands where a number or symbol is expected", kind=Incomplete)


def argument(reader: LatexReader) -> t.Node:
    """What a command or `^` acts on: a group in braces, one digit, or one symbol."""
    if reader.sees_sign("{"):
        return braced(reader)
    if reader.token.kind == "digit":
        token = reader.take()
        return t.Num(int(token.text), span=(token.start, token.end))
    letter = reader.token.kind == "letter" or (begins_name(reader.token) and not reader.sees_differential())
    return read_name(reader) if letter else atom(reader)


@begins("{")
def braced(reader: LatexReader) -> t.Node:
    """{expression}, or {}^A before a name"""
    if reader.ahead().text == "}" and reader.ahead(2).text in ("^", "_"):
        return COMMANDS["{}^"](reader)
    return between(reader, "}")


@begins(r"\{")
def _curly(reader: LatexReader) -> t.Node:
    return between(reader, r"\}")


def between(reader: LatexReader, closing: str) -> t.Node:
    """An expression up to the closing sign; what waits outside waits meanwhile."""
    opening = reader.take()
    waiting = reader.integrals, reader.bars
    reader.integrals, reader.bars = 0, closing in _PLAIN_BARS
    node = COMMANDS["relation"](reader) if closing in _LISTS else expression(reader)
    related = isinstance(node, t.Chain) or (isinstance(node, t.Formal) and node.kind in by_command("loose").values())
    if closing in _LISTS and (related or reader.sees_sign(",", ";")):
        node = _listed(reader, node, _LISTS[closing], opening.start)
    reader.integrals, reader.bars = waiting
    two = isinstance(node, t.Formal) and node.kind in ("list", "brackets") and len(node.parts) == 2
    if not (two and closing in (")", "]") and reader.pass_sign(")", "]")):  # [0, 1)
        reader.expect(closing, opening)
    return reader.spanned(node, opening.start) if isinstance(node, t.Formal) and node.kind in _LISTS.values() else node


_LISTS = {")": "list", "⟩": "list", "]": "brackets", "}": "list", r"\}": "braces"}


def _listed(reader: LatexReader, first: t.Node, kind: str, start: int) -> t.Node:
    """What commas part."""
    found, before, comma = [first], reader.tokens[reader.position - 1], reader.token
    decimal = before.kind == reader.ahead().kind == "digit" and before.end == comma.start and comma.end == reader.ahead().start
    if decimal and reader.source.text[start] == "{":
        raise reader.error("is this a decimal comma?", "Write 1.5, or a blank.", comma)
    while reader.pass_sign(",", ";"):
        found.append(COMMANDS["relation"](reader))
    if given := next((one for one in found if isinstance(one, t.Formal) and one.kind == "|"), None):  # P(x, y | z, u)
        place = found.index(given)
        sides = (*found[:place], given.parts[0]), (given.parts[1], *found[place + 1 :])
        found = [t.Formal("|", tuple(side[0] if len(side) == 1 else t.Formal("list", side) for side in sides))]
    return reader.spanned(t.Formal(kind, tuple(found)), start)
