"""LaTeX tokens -> functions, roots, magnitudes; functions with or without parentheses around what they are taken of.

Without parentheses, the argument is a number and the factors side by side behind it: cos ωt, sin 2θ, sin(θ/2).
It ends at a further function, a sign, a spacing command, a parenthesis or a dotted symbol, as in sin θ φ̇ and
cos θ (1 + x). Dimensions tell where it ends otherwise: in cos ωt only ωt is a number, in sin θ mg only θ.
"""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.notation import tree as t
from rbpsym.notation.hyperbolic import HYPERBOLIC
from rbpsym.notation.latex_grammar import SPACING, argument, atom, begins_factor, between, factor, number, power_of
from rbpsym.notation.latex_names import begins_name
from rbpsym.notation.latex_tokens import FUNCTION_WORDS, Token
from rbpsym.notation.limits import MAX_EXPONENT
from rbpsym.notation.symbol_table import COMMANDS, Reader, begins

FUNCTIONS = {rf"\{word}": name for word, name in FUNCTION_WORDS.items()}
_INVERSE_POWER = frozenset({"asin", "acos", "atan", "exp", "ln"})
_CLOSED = ("(", "[", "{", r"\{")
_ROOTS = (r"\frac", r"\sqrt")
_DOTTED = (r"\dot", r"\ddot", r"\dddot")
_ENDING = (r"\vec", r"\hat", r"\boldsymbol")


@begins(*FUNCTIONS)
def _function(reader: Reader) -> t.Node:
    token = reader.take()
    name = FUNCTIONS[token.text]
    exponent = None
    if reader.pass_sign("^"):
        exponent = argument(reader)
        if name in _INVERSE_POWER or not isinstance(exponent, t.Num):
            raise reader.error(f"this power of {name} can be read in two ways",
                               rf"Write \arc{name}, or ({token.text} x)^n.", token)  # fmt: skip
    arg = _argument(reader, token)
    made = t.Group(HYPERBOLIC[name](arg)) if name in HYPERBOLIC else t.Fn(name, arg)
    call = reader.spanned(made, token.start)
    return power_of(reader, call, exponent, token.start) if exponent else call


def _argument(reader: Reader, head: Token) -> t.Node:
    """(expression), {expression}, or factors side by side."""
    start = reader.token.start
    if reader.sees_sign(*_CLOSED):
        return COMMANDS[reader.token.text](reader)
    if reader.sees_differential() or not (_is_simple(reader) or begins_name(reader.token)):
        raise reader.error(f"{head.text} needs its argument here", "", head)
    factors = [_part(reader, head)]
    while _is_number(factors[-1]) and _is_simple(reader) and not _is_apart(reader, factors[-1]):
        if reader.token.kind == "digit":
            break
        factors.append(_part(reader, head))
    while _goes_on(reader, factors[-1]):
        closes = reader.sees_sign(*_CLOSED)
        factors.append(_part(reader, head))
        if closes:
            break
    whole = factors[0] if len(factors) == 1 else reader.spanned(t.Mul(tuple(factors)), start)
    return _divided(reader, whole, start)


def _is_number(node: t.Node) -> bool:
    """Is it a number or π, of which one hardly takes a sine or cosine if more follows?"""
    return isinstance(node, t.Num) or node == t.Sym("pi")


def _is_simple(reader: Reader) -> bool:
    """Does a number, a symbol, a fraction or a root follow, which may be a factor of a bare argument?"""
    token = reader.token
    if token.kind == "digit" or token.text in _ROOTS:
        return True
    return begins_name(token) and not reader.sees_differential() and token.text not in _ENDING


def _part(reader: Reader, head: Token) -> t.Node:
    node = atom(reader)
    if reader.sees_sign("^"):
        raise reader.error("is the argument or the function raised to this power?",
                           f"Write {head.text}^2 x or {head.text}(x^2).")  # fmt: skip
    return node


def _goes_on(reader: Reader, before: t.Node) -> bool:
    """Does the next factor belong to the argument?"""
    if not (_is_simple(reader) or reader.sees_sign("(", "[", r"\{")) or not begins_factor(reader):
        return False
    if reader.token.kind == "digit":
        raise reader.error("a number can't follow here without a sign", r"Write \cdot.")
    question = r"Put the argument in parentheses: \sin(x) y, or \sin(x y)."
    return reader.decide("does this belong to the function's argument?", question, yes=int(_is_apart(reader, before)))


def _is_apart(reader: Reader, before: t.Node) -> bool:
    """Would one hardly take what follows for a part of the argument?"""
    gap = reader.source.text[reader.previous_end : reader.token.start]
    apart = isinstance(before, (t.Div, t.Sqrt)) or reader.token.text in _DOTTED
    return apart or reader.sees_sign(*_CLOSED) or bool(SPACING.search(gap))


def _divided(reader: Reader, whole: t.Node, start: int) -> t.Node:
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
def _absolute(reader: Reader) -> t.Node:
    start = reader.token
    double = start.text == reader.ahead().text == "|"
    reader.position += double
    node = between(reader, r"\rvert" if start.text == r"\lvert" else start.text)
    if double:
        reader.expect("|", start)
    return reader.spanned(t.Abs(node), start.start)


@begins(r"\sqrt")
def _root(reader: Reader) -> t.Node:
    start = reader.take().start
    order = _root_order(reader) if reader.sees_sign("[") else 2
    arg = argument(reader)
    whole = t.Sqrt(arg) if order == 2 else t.Pow(arg, t.Num(Rational(1, order)))
    return reader.spanned(whole, start)


def _root_order(reader: Reader) -> int:
    """n of \\sqrt[n]{x}, from 2 to 64."""
    opening = reader.take()
    node = number(reader) if reader.token.kind == "digit" else None
    if node is None or not isinstance(node.value, int) or not 2 <= node.value <= MAX_EXPONENT:
        raise reader.error(f"the order of a root is a number from 2 to {MAX_EXPONENT}", "", opening)
    reader.expect("]", opening)
    return node.value
