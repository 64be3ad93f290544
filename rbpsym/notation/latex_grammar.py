"""LaTeX tokens -> tree: sums, vector products, products, powers, functions."""

from __future__ import annotations

from fractions import Fraction as Rational

from rbpsym.errors import LimitError, RbpsymError
from rbpsym.notation import tree as t
from rbpsym.notation.latex_names import begins_name, read_name
from rbpsym.notation.latex_table import COMMANDS, Reader, begins
from rbpsym.notation.latex_tokens import Token
from rbpsym.notation.limits import check_exponent, number_of

_FUNCTIONS = {
    **{rf"\{name}": name for name in ("sin", "cos", "tan", "cot", "sec", "csc", "exp", "ln")},
    r"\arcsin": "asin", r"\arccos": "acos", r"\arctan": "atan", r"\log": "ln",
}  # fmt: skip
_PLAIN_BARS = frozenset({"|", r"\Vert"})
_INVERSE_POWER = frozenset({"asin", "acos", "atan", "exp", "ln"})


def expression(reader: Reader) -> t.Node:
    """term + term - term"""
    start = reader.token.start
    with reader.deeper():
        terms = [_term(reader)]
        while reader.sees_sign("+", "-"):
            sign = reader.take()
            term = _term(reader)
            terms.append(reader.spanned(t.Neg(term), sign.start) if sign.text == "-" else term)
    return terms[0] if len(terms) == 1 else reader.spanned(t.Add(tuple(terms)), start)


def _term(reader: Reader) -> t.Node:
    start = reader.token.start
    if reader.pass_sign("-"):
        with reader.deeper():
            return reader.spanned(t.Neg(_term(reader)), start)
    reader.pass_sign("+")
    return multiplied(reader)


def multiplied(reader: Reader) -> t.Node:
    """Products joined by a dot or cross; between vectors these are Dot and Cross."""
    start = reader.token.start
    node = _product(reader)
    while reader.sees_sign(r"\cdot", r"\times", "*") and not _ends_integrand(reader):
        sign = reader.take()
        right = _signed_product(reader)
        node = reader.spanned(_joined(node, right, sign.text), start)
    return node


def _ends_integrand(reader: Reader) -> bool:
    """Does `\\cdot d\\vec R` follow, which belongs to the integral around?"""
    return bool(reader.integrals) and reader.sees_differential(1)


def _joined(left: t.Node, right: t.Node, sign: str) -> t.Node:
    if is_vector(left) and is_vector(right) and sign != "*":
        return (t.Cross if sign == r"\times" else t.Dot)(left, right)
    factors = [part for side in (left, right) for part in _factors(side)]
    return t.Mul(tuple(factors))


def _factors(node: t.Node) -> tuple[t.Node, ...]:
    return node.factors if isinstance(node, t.Mul) else (node,)


def is_vector(node: t.Node) -> bool:
    """Is the value of the node a vector?"""
    if isinstance(node, (t.Dot, t.Abs)):
        return False
    if isinstance(node, (t.Vec, t.Unit, t.Cross)):
        return True
    if isinstance(node, t.Div):
        return is_vector(node.num)
    return any(is_vector(part) for part in t.children(node))


def _signed_product(reader: Reader) -> t.Node:
    start = reader.token.start
    if reader.pass_sign("-"):
        return reader.spanned(t.Neg(_product(reader)), start)
    return _product(reader)


def _product(reader: Reader) -> t.Node:
    """Factors side by side, with perhaps a slash."""
    start = reader.token.start
    factors = [factor(reader)]
    while True:
        if reader.sees_sign("/"):
            factors = [_slash(reader, factors, start)]
        elif _begins_factor(reader):
            _refuse_ambiguity(reader, factors[-1])
            factors.append(factor(reader))
        else:
            return _one(reader, factors, start)


def _one(reader: Reader, factors: list[t.Node], start: int) -> t.Node:
    if len(factors) == 1:
        return factors[0]
    return reader.spanned(t.Mul(tuple(factors)), start)


def _slash(reader: Reader, factors: list[t.Node], start: int) -> t.Node:
    num = _one(reader, factors, start)
    if _is_bare(factors[-1], reader):
        raise reader.error("is the function's argument divided here, or its value?",
                           r"Write \frac{\sin x}{2} or \sin\frac{x}{2}.")  # fmt: skip
    reader.take()
    return reader.spanned(t.Div(num, factor(reader)), start)


def _begins_factor(reader: Reader) -> bool:
    token = reader.token
    if reader.sees_differential():
        return _sees_derivative(reader)
    if reader.bars and token.text in _PLAIN_BARS:
        return False
    known = token.kind in ("digit", "letter", "text") or begins_name(token)
    return known or token.text in COMMANDS or token.text in _FUNCTIONS


def _sees_derivative(reader: Reader) -> bool:
    """Does dω/dt in a line follow?"""
    position = reader.position
    try:
        return COMMANDS["d/"](reader) is not None
    except RbpsymError:
        return False
    finally:
        reader.position = position


def _refuse_ambiguity(reader: Reader, before: t.Node) -> None:
    """Raise ReadError for a/b c, sin x y and 2 3."""
    token = reader.token
    if isinstance(before, t.Div) and number_of(before) is None and _was_slashed(before, reader):
        raise reader.error("is this factor above or below the slash?", "Use parentheses.")
    stops = token.text in _FUNCTIONS or token.text in (r"\vec", r"\hat", r"\boldsymbol")
    if _is_bare(before, reader) and not stops:
        raise reader.error("does this belong to the function's argument?",
                           r"Put the argument in parentheses: \sin(x) y, or \sin(x y).")  # fmt: skip
    if token.kind == "digit":
        raise reader.error("a number can't follow here without a sign", r"Write \cdot.")


def _was_slashed(node: t.Node, reader: Reader) -> bool:
    text = reader.source.text[slice(*node.span)] if node.span else ""
    return "/" in text and not text.endswith((")", "}"))


def _is_bare(node: t.Node, reader: Reader) -> bool:
    """Is it a function whose argument has no parentheses or braces, just read?"""
    node = node.base if isinstance(node, t.Pow) else node
    text = reader.source.text[: reader.previous_end]
    return isinstance(node, t.Fn) and not text.endswith((")", "]", "}"))


def factor(reader: Reader) -> t.Node:
    """An atom with its powers."""
    start = reader.token.start
    base = _atom(reader)
    while reader.sees_sign("^"):
        reader.take()
        base = _power(reader, base, argument(reader), start)
    if reader.sees_sign("_", "'"):
        raise reader.error("only a symbol can have a subscript or prime")
    return base


def _power(reader: Reader, base: t.Node, exponent: t.Node, start: int) -> t.Node:
    try:
        check_exponent(exponent)
    except LimitError as error:
        raise error.at(reader.source.at(*(exponent.span or (start, start + 1)))) from None
    return reader.spanned(t.Pow(base, exponent), start)


def _atom(reader: Reader) -> t.Node:
    token = reader.token
    if token.kind == "digit":
        return _number(reader)
    with reader.deeper():
        if reader.sees_differential() and (derivative := COMMANDS["d/"](reader)):
            return derivative
        if token.text in COMMANDS and token.kind in ("sign", "command"):
            return COMMANDS[token.text](reader)
        if token.text in _FUNCTIONS:
            return _function(reader)
        if begins_name(token):
            return read_name(reader)
    raise _missing(reader)


def _missing(reader: Reader) -> RbpsymError:
    token = reader.token
    if token.kind == "end":
        return reader.error("the formula ends too early", "A number or symbol is missing here.")
    if token.kind == "command":
        return reader.error(f"the command “{token.text}” is not known here")
    return reader.error(f"“{token.text}” stands where a number or symbol is expected")


def _number(reader: Reader) -> t.Node:
    """A number of adjacent digits, with perhaps a decimal mark."""
    start, digits = reader.token.start, ""
    while reader.token.kind == "digit" or (reader.sees_sign(".", "{,}") and _in_number(reader)):
        token = reader.take()
        digits += token.text if token.kind == "digit" else "."
    if len(digits) > 30 or digits.count(".") > 1:
        what = "a number of more than 30 digits" if len(digits) > 30 else "two decimal marks"
        raise reader.source.limit(what, start, reader.previous_end)
    value = Rational(digits)
    return reader.spanned(t.Num(int(value) if value.denominator == 1 else value), start)


def _in_number(reader: Reader) -> bool:
    return reader.ahead().kind == "digit" and reader.ahead().start == reader.token.end


def argument(reader: Reader) -> t.Node:
    """What a command or `^` acts on: a group in braces, one digit, or one symbol."""
    if reader.sees_sign("{"):
        return braced(reader)
    if reader.token.kind == "digit":
        token = reader.take()
        return t.Num(int(token.text), span=(token.start, token.end))
    return _atom(reader)


@begins("{")
def braced(reader: Reader) -> t.Node:
    """{expression}"""
    return between(reader, "}")


@begins("(")
def _parenthesis(reader: Reader) -> t.Node:
    return between(reader, ")")


def between(reader: Reader, closing: str) -> t.Node:
    """An expression up to the closing sign; what waits outside waits meanwhile."""
    opening = reader.take()
    waiting = reader.integrals, reader.bars
    reader.integrals, reader.bars = 0, closing in _PLAIN_BARS
    node = expression(reader)
    reader.integrals, reader.bars = waiting
    reader.expect(closing, opening)
    return node


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
    if reader.sees_sign("["):
        raise reader.error("only square roots are read", "Write a power with a fraction.")
    return reader.spanned(t.Sqrt(argument(reader)), start)


def _function(reader: Reader) -> t.Node:
    token = reader.take()
    name = _FUNCTIONS[token.text]
    exponent = None
    if reader.pass_sign("^"):
        exponent = argument(reader)
        if name in _INVERSE_POWER or not isinstance(exponent, t.Num):
            raise reader.error(f"this power of {name} can be read in two ways",
                               rf"Write \arc{name}, or ({token.text} x)^n.", token)  # fmt: skip
    call = reader.spanned(t.Fn(name, _function_argument(reader, token)), token.start)
    return _power(reader, call, exponent, token.start) if exponent else call


def _function_argument(reader: Reader, head: Token) -> t.Node:
    """(expression), {expression}, a fraction, or a number and a symbol."""
    start = reader.token.start
    if reader.sees_sign("(", "[", "{", r"\frac"):
        return COMMANDS[reader.token.text](reader)
    if reader.sees_differential() or not (
        reader.token.kind == "digit" or begins_name(reader.token) or reader.token.text == r"\Delta"
    ):
        raise reader.error(f"{head.text} needs its argument here", "", head)
    arg = _atom(reader)
    if isinstance(arg, t.Num) and begins_name(reader.token) and not reader.sees_differential():
        arg = reader.spanned(t.Mul((arg, _atom(reader))), start)
    if reader.sees_sign("^"):
        raise reader.error("is the argument or the function raised to this power?",
                           f"Write {head.text}^2 x or {head.text}(x^2).")  # fmt: skip
    return arg
