"""LaTeX tokens -> functions, roots, magnitudes; functions with or without parentheses around what they are taken of.

Without parentheses, the argument is a number and the factors side by side behind it: cos ωt, sin 2θ, sin(θ/2).
It ends at a further function, a sign, a spacing command, a parenthesis or a dotted symbol, as in sin θ φ̇ and
cos θ (1 + x). Dimensions tell where it ends otherwise: in cos ωt only ωt is a number, in sin θ mg only θ.

Relations, a = b = c; and what depends on what: x(t) and V(θ) are no products, and d/dt in front of a product is of all
of it. Decided by what the symbols are declared to be (`SymbolTable.varies`) and by dimensions; else refused.
"""

from __future__ import annotations

from fractions import Fraction as Rational
from itertools import dropwhile

from rbpsym.errors import Incomplete, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.hyperbolic import FUNCTION_WORDS, HYPERBOLIC
from rbpsym.expr.latex.grammar import (
    SPACING,
    argument,
    atom,
    bare_atom,
    begins_factor,
    between,
    ends_integrand,
    expression,
    factor,
    refuse_number,
)
from rbpsym.expr.latex.names import begins_name, read_name
from rbpsym.expr.latex.numerals import measured, number
from rbpsym.expr.latex.scripts import label_after
from rbpsym.expr.latex.spelled import by_command
from rbpsym.expr.latex.tokens import Token, closed
from rbpsym.expr.limits import MAX_EXPONENT, number_of
from rbpsym.expr.symbol_table import COMMANDS, Drawn, LatexReader, begins

SIGNS = {
    "=": "=", "<": "<", ">": ">", r"\le": "<=", r"\ge": ">=", r"\ne": "!=", r"\approx": "~",
    r"\to": "->",
}  # fmt: skip


def relation(reader: LatexReader) -> t.Node:
    """A chain, or an expression alone."""
    start = reader.token.start
    first = t.Formal("continued", span=(start, start + 1)) if reader.sees_sign("=", r"\approx") else expression(reader)
    return reader.spanned(chained(reader, [first], []), start)


def chained(reader: LatexReader, items: list[t.Node], ops: list[str]) -> t.Node:
    """The chain that goes on with the signs that follow."""
    while reader.sees_sign(*SIGNS):
        sign = reader.take()
        ops.append(SIGNS[sign.text])
        _pass_word(reader, sign)
        ends = reader.token.kind == "end"
        items.append(t.Formal("unfinished", span=(sign.start, sign.end)) if ends else measured(reader, expression(reader)))
    found = t.Chain(tuple(items), tuple(ops)) if ops else items[0]
    if not reader.sees_sign(*by_command("loose")):
        return found
    loose = by_command("loose")[_pass_word(reader, reader.take())]
    others, start = chained(reader, [expression(reader)], []), (items[0].span or (0, 0))[0]
    if loose == ":" and isinstance(others, t.Formal) and others.kind == ":" and isinstance(others.parts[0], t.Chain):  # a:b = c:d
        sides = (found, *others.parts[0].items, *others.parts[1:])
        if len(sides) == 4 and not any(isinstance(side, (t.Add, t.Chain)) for side in sides):
            return reader.spanned(t.Chain((t.Div(*sides[:2]), t.Div(*sides[2:])), others.parts[0].ops), start)
    return reader.spanned(t.Formal(loose, (found, others)), start)


def _pass_word(reader: LatexReader, sign: Token) -> str:
    """Pass what stands on an arrow or another sign, which says how; the sign. What is above = may belong to a name."""
    while reader.sees_sign("_") or (sign.text in (r"\to", *by_command("loose")) and reader.sees_sign("^")):
        label_after(reader)
    return sign.text


MOST_ASKED = 6  # of such questions in a formula; behind them, what varies is a function
_CALLED = "is this a product, or a value of a function?"
_WRITE = r"Say in the symbols what all of it means, or write a product without the parenthesis."


COMMANDS["relation"] = relation


@begins("name")
def _name(reader: LatexReader) -> t.Node:
    """A name; O(θ²) are terms left out."""
    left_out = reader.token.text in ("o", "O") and reader.ahead().text == "(" and reader.ahead(-1).text in ("+", "-", r"\pm")
    if left_out and Drawn(reader.token.text) not in reader.table.names:
        start = reader.take().start
        return reader.spanned(t.Formal("order", (COMMANDS["("](reader),)), start)
    if reader.table.open and reader.token.text == "δ" and begins_name(reader.ahead()):
        start = reader.take().start
        return reader.spanned(t.Formal("varied", (t.Sym("delta"), read_name(reader))), start)
    return read_name(reader)


_NAMED = (t.Sym, t.Vec, t.Deriv)
_VALUES = ("binomial", "factorial", "measured", "state", "mean", "…", "log", "unit")  # no functions


def called(reader: LatexReader, node: t.Node) -> t.Node:
    """In a text of which nothing is known: with what stands in brackets behind it, of which it may be a function."""
    parts = (node.num, node.den) if isinstance(node, t.Div) else (node,)
    may = reader.table.open and not (isinstance(node, t.Formal) and node.kind == "differential")
    may = may and all(isinstance(one, (*_NAMED, t.Pow, t.Formal, t.Delta)) for one in parts)
    may = may and not any(isinstance(one, t.Formal) and one.kind in _VALUES for one in parts)
    while may and reader.sees_sign("(", "["):
        if reader.sees_sign("[") and reader.ahead(len(_inside(reader))).text == "_":
            break
        may = reader.ahead().text != r"\cdot"  # du[·] [a + b]
        node = _value(reader, node)
    return node


def applied(reader: LatexReader, name: t.Node, first: int, raised: bool = False) -> t.Node:
    """What begins at `first`, perhaps raised to a power, and in brackets behind it what it may depend on: in x(t) and V(θ, φ)
    a name stands for its value there; of a quotient of names that vary neither reading is more usual."""
    parts = (name.num, name.den) if isinstance(name, t.Div) else (name,)
    if reader.table.open or not (reader.sees_sign("(", "[") and all(isinstance(one, _NAMED) for one in parts)):
        return called(reader, name)
    varies, begin, inner = _varies(reader, name), reader.position, _inside(reader)
    texts = [token.text for token in inner]
    if texts[0] == "[":  # S[q], X[0], E[x²]; factors in brackets are sums, fractions or functions
        alone = not {"+", "-", r"\frac", *FUNCTIONS}.intersection(texts) and reader.ahead(len(inner)).text != "_"
        return _value(reader, name) if alone else name
    if raised and varies is None:
        return name
    found = _arguments(reader)
    end, reader.position = reader.position, begin
    if found is None:
        later = texts[1] == "t" and texts[2] in ("+", "-") and varies  # v(t + Δt)
        is_value = _holds_several(inner) or (not raised and (later or (varies and _is_value(reader, first, inner))))
        return _value(reader, name) if is_value else name
    constant = any(isinstance(one, t.Num) for one in found) or (len(found) == 1 and _varies(reader, found[0]) is False)
    if found != [t.ZERO] and (varies is False or (raised and constant)):
        return name
    elsewhere = any(rest[:1] == ["("] and rest[: len(texts)] != texts for rest in _others(reader, first, begin))
    if constant or elsewhere:  # its values differ: V(x) - V(y)
        return _value(reader, name)
    clear = len(found) > 1 or found[0] == _TIME or len(reader.met) >= MOST_ASKED
    usual = varies is True and not isinstance(name, t.Div)
    if clear or reader.decide(_CALLED, _WRITE, yes=int(usual)) == (varies is None):
        reader.position = end
    return name


def _inside(reader: LatexReader) -> tuple[Token, ...]:
    """The tokens from the bracket that opens here to the one that closes it."""
    return reader.tokens[reader.position : closed(reader.tokens, reader.position) + 1]


def _holds_several(inner: tuple[Token, ...]) -> bool:
    """Is there a comma in the brackets, or a relation: f(2x, y), f(x = 0)?"""
    place = 1
    while place < len(inner) - 1:
        token = inner[place]
        if token.text == "," or token.text in SIGNS or token.text in by_command("loose"):
            return True
        place = closed(inner, place) + 1
    return False


def _is_value(reader: LatexReader, first: int, inner: tuple[Token, ...]) -> bool:
    """Is in the parentheses behind a name a number, or one term that makes no product by its dimension: θ(π/2), v(2R)?

    A product that is all of a side would not be said to be 0 or another number.
    """
    if all(token.kind == "digit" or token.text in _NUMERIC for token in inner):
        return True
    if any(rest[:1] + rest[2:3] == ["(", ")"] for rest in _others(reader, first, reader.position)):  # f(a), said elsewhere
        return True
    single = not any(token.text in ("+", "-", *SIGNS) for token in inner) and len(reader.met) < MOST_ASKED
    sign, other, behind = (reader.ahead(len(inner) + k) for k in range(3))
    begins = not first or reader.tokens[first - 1].kind == "row" or reader.tokens[first - 1].text in SIGNS
    if single and begins and sign.text in SIGNS and other.kind == "digit" and behind.kind in ("row", "end"):
        return True
    return single and reader.table.faults is not None and reader.decide(_CALLED, _WRITE, yes=1)


_NUMERIC = frozenset(("(", ")", "{", "}", "-", ".", "/", r"\frac", "π"))


def _value(reader: LatexReader, name: t.Node) -> t.Node:
    """f(0), f(x + y, 2): a product, or the value of a function that nothing is known of."""
    start, inner = reader.token.start, between(reader, {"(": ")", "[": "]"}[reader.token.text])
    return reader.spanned(t.Formal("value", (name, inner)), (name.span or (start, 0))[0])


def _others(reader: LatexReader, first: int, begin: int) -> list[list[str]]:
    """What follows where the same name or f' stands elsewhere."""
    texts = [token.text for token in reader.tokens]
    name = [text for text in texts[first:begin] if text != "'"]
    starts = (k for k in range(len(texts)) if k != first and texts[k : k + len(name)] == name)
    ends = (k + len(name) for k in starts if texts[k - 1] not in ("_", *_DOTTED) and texts[max(k - 2, 0) : k] != ["_", "{"])
    return [list(dropwhile("'".__eq__, texts[end:])) for end in ends]


_TIME = t.Sym("t")


def _varies(reader: LatexReader, node: t.Node) -> bool | None:
    """Is it no constant? None where nothing is known."""
    if node is _TIME or reader.table.varies is None:
        return True if node is _TIME else None
    return any(reader.table.varies(name) for name in t.names(node) - {"pi"})


def _arguments(reader: LatexReader) -> list[t.Node] | None:
    """Names with commas between them, the time, or a number, in parentheses, which are passed; None for anything else."""
    found: list[t.Node] = []
    while reader.pass_sign(*((",",) if found else ("(",))):
        argument = _applied_to(reader)
        if argument is None:
            return None
        found.append(argument)
    return found if found and reader.pass_sign(")") else None


def _applied_to(reader: LatexReader) -> t.Node | None:
    token, digits = reader.token, ""
    while reader.token.kind == "digit":
        digits += reader.take().text
    if digits:
        return t.Num(int(digits))
    if not begins_name(token):
        return None
    try:
        name = read_name(reader)
        given = not reader.sees_sign("(") or _arguments(reader) is not None  # V(z(t))
        return name if given and isinstance(name, (t.Sym, t.Vec)) else None
    except RbpsymError:
        is_time = token.kind == "letter" and token.text == "t" and reader.tokens[reader.position - 1] is token
        return _TIME if is_time else None


def operand(reader: LatexReader) -> t.Node:
    r"""What \frac{d}{dt} in front stands for: a factor in parentheses, or the whole product side by side.

    Raises ReadError where it matters which of several factors that change is meant.
    """
    start, closed = reader.token, reader.sees_sign("(", "[", "{", r"\{")
    factors = [factor(reader)]
    while not closed and begins_factor(reader):
        refuse_number(reader)
        factors.append(factor(reader))
    several = len([node for node in factors if _varies(reader, node) is not False and t.names(node) - {"pi"}]) > 1
    goes_on = not closed and reader.sees_sign("/", r"\cdot", r"\times", "*") and not ends_integrand(reader)
    whole = factors[0] if len(factors) == 1 else reader.spanned(t.Mul(tuple(factors)), start.start)
    return reader.spanned(t.Formal("several", (whole,)), start.start) if several or goes_on else whole


COMMANDS |= {"operand": operand, "applied": applied, "called": called}
FUNCTIONS = {rf"\{word}": name for word, name in FUNCTION_WORDS.items()}
_INVERSE_POWER = frozenset({"asin", "acos", "atan", "exp", "ln"})
_CLOSED = ("(", "[", "{", r"\{")
_ROOTS = (r"\frac", r"\sqrt", r"\ang", r"\num")
_DOTTED = (r"\dot", r"\ddot", r"\dddot")
_ENDING = (r"\vec", r"\hat", r"\boldsymbol")


@begins(*FUNCTIONS)
def _function(reader: LatexReader) -> t.Node:
    token = reader.take()
    name = FUNCTIONS[token.text]
    base = argument(reader) if token.text == r"\log" and reader.pass_sign("_") else None
    exponent = None
    if [reader.ahead(k).text for k in (0, 2, 3)] == ["[", "]", "("]:  # \sin[2](x) of physics is sin² x
        exponent = COMMANDS["["](reader)
    if reader.pass_sign("^"):
        exponent = argument(reader)
        if exponent == t.Neg(t.ONE) and f"a{name}" in FUNCTION_WORDS.values():
            asked = f"this power of {name} can be read in two ways", rf"Write \arc{name}, or ({token.text} x)^n."
            name, exponent = (name, exponent) if reader.decide(*asked) else (f"a{name}", None)
        elif name in _INVERSE_POWER or (number_of(exponent) is None and not t.names(exponent)):  # sin^n x is no n-th inverse
            instead = f"Write ({token.text} x)^n." if name in _INVERSE_POWER else rf"Write \arc{name}, or ({token.text} x)^n."
            raise reader.error(f"this power of {name} can be read in two ways", instead, token)
    arg = _argument(reader, token)
    if token.text == r"\log" and base is None:
        return reader.spanned(t.Formal("log", (arg,)), token.start)
    made: t.Node = t.Group(HYPERBOLIC[name](arg)) if name in HYPERBOLIC else t.Fn(name, arg)
    made = made if base is None else t.Div(made, t.Fn(name, base))
    call = reader.spanned(made, token.start)
    return reader.power(call, exponent, token.start) if exponent else call


def _argument(reader: LatexReader, head: Token) -> t.Node:
    """(expression), {expression}, or factors side by side."""
    start = reader.token.start
    if reader.sees_sign(*_CLOSED, r"\lvert", "|"):
        return COMMANDS[reader.token.text](reader)
    if reader.token.text in FUNCTIONS:
        return _function(reader)
    if reader.sees_differential() or not (_is_simple(reader) or begins_name(reader.token)):
        raise reader.error(f"{head.text} needs its argument here", "", head, Incomplete)
    factors = [_part(reader, head)]
    while _is_number(factors[-1]) and _is_simple(reader) and not _is_apart(reader, factors[-1]):
        if reader.token.kind == "digit":
            break
        factors.append(_part(reader, head))
    while _goes_on(reader, factors[-1]):
        closes = reader.sees_sign(*_CLOSED)
        other = called(reader, factors[-1])
        factors[-1:] = [other] if other is not factors[-1] else [other, _part(reader, head)]
        if closes:
            break
    whole = factors[0] if len(factors) == 1 else reader.spanned(t.Mul(tuple(factors)), start)
    return _divided(reader, whole, start)


def _is_number(node: t.Node) -> bool:
    """Is it a number or π, of which one hardly takes a sine or cosine if more follows? π/4 is an angle."""
    return node == t.Sym("pi") or all(isinstance(part, (t.Num, t.Div)) for part in t.walk(node))


def _is_simple(reader: LatexReader) -> bool:
    """Does a number, a symbol, a fraction or a root follow, which may be a factor of a bare argument?"""
    token = reader.token
    if token.kind == "digit" or token.text in _ROOTS:
        return True
    return begins_name(token) and not reader.sees_differential() and token.text not in _ENDING


def _part(reader: LatexReader, head: Token) -> t.Node:
    node = bare_atom(reader) if reader.table.open else atom(reader)
    if reader.sees_sign("^"):
        raise reader.error("is the argument or the function raised to this power?",
                           f"Write {head.text}^2 x or {head.text}(x^2).")  # fmt: skip
    return node


def _goes_on(reader: LatexReader, before: t.Node) -> bool:
    """Does the next factor belong to the argument?"""
    if not (_is_simple(reader) or reader.sees_sign("(", "[", r"\{")) or not begins_factor(reader):
        return False
    if reader.token.kind == "digit":
        raise reader.error("a number can't follow here without a sign", r"Write \cdot.")
    question = r"Put the argument in parentheses: \sin(x) y, or \sin(x y)."
    named = reader.table.open and isinstance(before, _NAMED) and reader.sees_sign("(", "[")  # ln f(x), sin x (1 + y)
    unusual = _is_apart(reader, before) and not named
    return reader.decide("does this belong to the function's argument?", question, yes=int(unusual))


def _is_apart(reader: LatexReader, before: t.Node) -> bool:
    """Would one hardly take what follows for a part of the argument?"""
    gap = reader.source.text[reader.previous_end : reader.token.start]
    apart = (isinstance(before, (t.Div, t.Sqrt)) and not _is_number(before)) or reader.token.text in _DOTTED
    return apart or reader.sees_sign(*_CLOSED) or bool(SPACING.search(gap))


def _divided(reader: LatexReader, whole: t.Node, start: int) -> t.Node:
    """The argument, or its quotient where a slash follows."""
    if not reader.sees_sign("/"):
        return whole
    hint = r"Write \frac{\sin x}{2} or \sin\frac{x}{2}."
    unusual = reader.ahead().text in _CLOSED
    if not reader.decide("is the function's argument divided here, or its value?", hint, yes=int(unusual)):
        return whole
    reader.take()
    return reader.spanned(t.Div(whole, factor(reader)), start)


@begins(r"\lvert", "|", r"\Vert")
def _absolute(reader: LatexReader) -> t.Node:
    start = reader.token
    if start.text in (r"\lvert", "|") and (state := COMMANDS["|⟩"](reader)) is not None:
        return state
    double = start.text == reader.ahead().text == "|"
    reader.position += double
    node = between(reader, r"\rvert" if start.text == r"\lvert" else start.text)
    if double:
        reader.expect("|", start)
    return reader.spanned(t.Abs(node), start.start)


@begins(r"\sqrt")
def _root(reader: LatexReader) -> t.Node:
    start = reader.take().start
    order = whole_number(reader, "the order of a root", 2, MAX_EXPONENT) if reader.sees_sign("[") else 2
    arg = argument(reader)
    whole = t.Sqrt(arg) if order == 2 else t.Pow(arg, t.Num(Rational(1, order)))
    return reader.spanned(whole, start)


def whole_number(reader: LatexReader, what: str, least: int, most: int) -> int:
    """n of \\sqrt[n]{x}: a whole number in brackets, between these."""
    opening = reader.take()
    node = number(reader) if reader.token.kind == "digit" else None
    if not isinstance(node, t.Num) or not isinstance(node.value, int) or not least <= node.value <= most:
        raise reader.error(f"{what} is a number from {least} to {most}", "", opening)
    reader.expect("]", opening)
    return node.value
