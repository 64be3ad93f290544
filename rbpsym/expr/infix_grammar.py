"""Typed tokens -> tree: sums, products, powers, calls, by binding power."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from types import MappingProxyType

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.infix_names import (
    InfixReader,
    InfixToken,
    function_named,
    in_last_argument,
    is_bare_call,
    is_call,
    is_settled,
    stands_apart,
    symbol_named,
    unknown,
)
from rbpsym.expr.limits import number_of

_ROOTS = frozenset(("sqrt", "cbrt", "root"))
_POWERED = frozenset({
    "sin", "cos", "tan", "cot", "sec", "csc", "sen", "tg", "ctg", "cotg", "cosec", "sinh", "cosh", "tanh", "senh", "tgh",
})  # fmt: skip


def expression(reader: InfixReader) -> t.Node:
    """term + term - term"""
    start = reader.token.start
    with reader.deeper():
        terms = [_term(reader)]
        while reader.sees("+", "-"):
            sign = reader.take()
            term = _term(reader)
            if sign.text == "-":
                term = t.Neg(term, span=(sign.start, reader.previous_end))
            terms.append(term)
    return terms[0] if len(terms) == 1 else reader.spanned(t.Add(tuple(terms)), start)


def _term(reader: InfixReader) -> t.Node:
    """A product with perhaps signs before it."""
    start = reader.token.start
    if reader.accept("-"):
        with reader.deeper():
            return reader.spanned(t.Neg(_term(reader)), start)
    if reader.accept("+"):
        with reader.deeper():
            return _term(reader)
    return _product(reader)


def _product(reader: InfixReader) -> t.Node:
    """factor * factor / factor factor"""
    start = reader.token.start
    factors = [_factor(reader)]
    while True:
        if reader.accept("*"):
            factors.append(_signed_factor(reader))
        elif reader.sees("/"):
            factors = [_division(reader, _one(factors, start, reader), start)]
        elif _begins_factor(reader):
            factors = [*factors[:-1], *_with_implied(reader, factors[-1])]
        else:
            return _one(factors, start, reader)


def _one(factors: list[t.Node], start: int, reader: InfixReader) -> t.Node:
    if len(factors) == 1:
        return factors[0]
    return reader.spanned(t.Mul(tuple(factors)), start)


def _division(reader: InfixReader, num: t.Node, start: int) -> t.Node:
    what = "this can be read in two ways: is the function's argument divided, or its value?"
    inside = is_bare_call(num, reader) and reader.decide(what, "Write sin(x)/2 or sin(x/2).")
    reader.take()
    den = _signed_factor(reader)
    if inside:
        return reader.spanned(in_last_argument(num, lambda arg: t.Div(arg, den)), start)
    return reader.spanned(t.Div(num, den), start)


def _signed_factor(reader: InfixReader) -> t.Node:
    start = reader.token.start
    if reader.accept("-"):
        with reader.deeper():
            return reader.spanned(t.Neg(_signed_factor(reader)), start)
    return _factor(reader)


def _begins_factor(reader: InfixReader) -> bool:
    return reader.token.kind in ("name", "number") or reader.sees("(", "√") or (reader.sees("|") and not reader.bars)


_BELOW = "this can be read in two ways: is this factor above or below the fraction bar?"
_HINT = "Write a/(b*c), or (a/b)*c."


def _with_implied(reader: InfixReader, before: t.Node) -> tuple[t.Node, ...]:
    """A factor and the one that follows without a sign. Raises ReadError where this can be read in two ways."""
    below = inside = False
    if isinstance(before, t.Div) and not is_settled(before, reader):
        parts, half = not stands_apart(reader), number_of(before) is not None
        below = reader.decide(_BELOW, _HINT, changes_value=parts, usual=half)
    if is_bare_call(before, reader) and not is_call(reader):
        what = "this can be read in two ways: does it belong to the function's argument?"
        inside = reader.decide(what, "Put the argument in parentheses: sin(x)*y, or sin(x*y).")
    if reader.token.kind == "number":
        raise reader.error("a number can't follow here without a sign", "Write * between them.")
    factor = _factor(reader)
    if inside:
        return (in_last_argument(before, lambda arg: t.Mul((arg, factor))),)
    if below and isinstance(before, t.Div):
        start = before.span[0] if before.span else 0
        return (replace(before, den=t.Mul((before.den, factor)), span=(start, reader.previous_end)),)
    return before, factor


def _factor(reader: InfixReader) -> t.Node:
    """An atom with its powers."""
    start = reader.token.start
    base = _atom(reader)
    if reader.token.kind == "raised":
        exponent = _exponent_number(reader.take())
        base = reader.power(base, exponent, start)
    elif reader.accept("^"):
        base = reader.power(base, _fraction(reader, _exponent(reader)), start)
    if reader.token.kind == "raised" or reader.sees("^"):
        raise reader.error("an exponent follows an exponent", "Use parentheses.")
    return base


def _exponent(reader: InfixReader) -> t.Node:
    with reader.deeper():
        return _signed_factor(reader)


def _fraction(reader: InfixReader, exponent: t.Node) -> t.Node:
    """The exponent, or the fraction that it begins: in x^1/2 it may be one half."""
    below = reader.ahead()
    if not isinstance(exponent, t.Num) or not reader.sees("/") or below.kind != "number" or not below.value:
        return exponent
    if (exponent.value / below.value).denominator == 1:
        return exponent
    what = "this can be read in two ways: is the exponent a fraction, or is the power divided?"
    if not reader.decide(what, "Write x^(1/2), or (x^1)/2.", changes_value=True, usual=True):
        return exponent
    reader.take()
    return reader.spanned(t.Div(exponent, _atom(reader)), exponent.span[0] if exponent.span else 0)


def _exponent_number(token: InfixToken) -> t.Node:
    found = _whole(token)
    size = found if found >= 0 else -found
    value = t.Num(size, span=(token.start, token.end))
    return t.Neg(value, span=value.span) if found < 0 else value


def _atom(reader: InfixReader) -> t.Node:
    """A number, a symbol, a call, or a parenthesis."""
    token = reader.token
    if token.kind == "number":
        reader.take()
        return t.Num(_whole(token), span=(token.start, token.end))
    if token.kind == "name":
        return _named(reader)
    opening = _OPENINGS.get(token.text) if token.kind == "operator" else None
    if opening:
        with reader.deeper():
            return opening(reader)
    raise _missing(reader)


def _whole(token: InfixToken) -> Fraction | int:
    value = token.value or Fraction(0)
    return int(value) if value.denominator == 1 else value


def _missing(reader: InfixReader) -> RbpsymError:
    token = reader.token
    if token.kind == "end":
        return reader.error("the expression ends too early", "A number or symbol is missing here.")
    what = f"a number or symbol is expected before “{token.text}”"
    return reader.error(what, "Remove the sign, or write what is missing.")


def _parenthesis(reader: InfixReader) -> t.Node:
    opening = reader.take()
    inner = _within(reader, bars=False)
    _close(reader, opening)
    return inner


def _within(reader: InfixReader, *, bars: bool) -> t.Node:
    """An expression in which a | closes, or opens."""
    waiting, reader.bars = reader.bars, bars
    inner = expression(reader)
    reader.bars = waiting
    return inner


_CLOSINGS = MappingProxyType({"(": ")", "[": "]"})


def _close(reader: InfixReader, opening: InfixToken, sign: str = ")") -> None:
    text = reader.source.text
    if sign == ")" and reader.sees(sign) and _CLOSINGS.get(text[opening.start], ")") != text[reader.token.start]:
        raise reader.error(f"“{text[reader.token.start]}” closes what “{text[opening.start]}” opened", "Use one kind.")
    if not reader.accept(sign):
        if reader.token.kind == "end":
            raise reader.error("this parenthesis is never closed", f"Add a “{sign}”.", opening)
        raise reader.error(f"“{reader.token.text}” stands where “{sign}” is expected")


def _root(reader: InfixReader) -> t.Node:
    sign = reader.take()
    return reader.spanned(t.Sqrt(_radicand(reader)), sign.start)


def _radicand(reader: InfixReader, head: InfixToken | None = None) -> t.Node:
    """What stands under a root without parentheses: a factor, perhaps those behind it, and what these are divided by."""
    what, hint = "this can be read in two ways: does it stand under the root?", "Write sqrt(x)*y, or sqrt(x*y)."
    decided = partial(reader.decide, what, hint, changes_value=True, usual=True)
    start, closed = reader.token.start, reader.sees("(")
    under = _beside(reader, None if closed else decided)
    if closed or not reader.sees("/") or not t.names(under) or not decided():
        return under
    reader.take()
    below = partial(reader.decide, _BELOW, _HINT, changes_value=True, usual=True)
    quotient = reader.spanned(t.Div(under, _beside(reader, below)), start)
    return _beside(reader, decided, quotient)


def _beside(reader: InfixReader, decided: Callable[[], bool] | None, *before: t.Node) -> t.Node:
    """A factor, and those behind it without a sign as long as it is decided so."""
    start = before[0].span[0] if before and before[0].span else reader.token.start
    factors = [*before] or [_factor(reader)]
    while decided and _begins_factor(reader) and decided():
        factors.append(_factor(reader))
    return _one(factors, start, reader)


def _bars(reader: InfixReader) -> t.Node:
    opening = reader.take()
    inner = _within(reader, bars=True)
    _close(reader, opening, "|")
    return reader.spanned(t.Abs(inner), opening.start)


_OPENINGS = MappingProxyType({"(": _parenthesis, "√": _root, "|": _bars})


def _named(reader: InfixReader) -> t.Node:
    token = reader.take()
    name = symbol_named(token, reader)
    if name:
        return t.Sym(name, span=(token.start, token.end))
    if function_named(token, reader):
        with reader.deeper():
            return _call(token, reader)
    raise unknown(token, reader)


def _call(token: InfixToken, reader: InfixReader) -> t.Node:
    """A function with an optional power before its argument: sin^2(x), sin x."""
    exponent = _function_power(token, reader)
    bare = _radicand if token.text in _ROOTS else _bare_argument
    arg = _parenthesis(reader) if reader.sees("(") else bare(reader, token)
    made = reader.functions[token.text](arg)  # cosh(x) is a quotient, but is none as it is typed
    call = reader.spanned(t.Group(made) if isinstance(made, t.Div) else made, token.start)
    return reader.power(call, exponent, token.start) if exponent else call


def _function_power(token: InfixToken, reader: InfixReader) -> t.Node | None:
    if reader.token.kind == "raised":
        exponent = _exponent_number(reader.take())
    elif reader.accept("^"):
        exponent = _exponent(reader)
    else:
        return None
    if token.text not in _POWERED or not isinstance(exponent, t.Num):
        hint = f"Write a{token.text}(x) for the inverse, 1/{token.text}(x) for the reciprocal."
        what = f"this power of {token.text} can be read in two ways"
        raise reader.error(what, hint if token.text in _POWERED else "", token)
    return exponent


def _bare_argument(reader: InfixReader, token: InfixToken) -> t.Node:
    """An argument without parentheses: a number, a symbol, or a number and a symbol."""
    start = reader.token.start
    first = reader.token
    if reader.sees("√", "|"):
        return _atom(reader)
    if first.kind not in ("number", "name") or function_named(first, reader):
        raise reader.error(f"{token.text} needs its argument", f"Write {token.text}(...).", token)
    arg = _atom(reader)
    if isinstance(arg, t.Num) and reader.token.kind == "name" and not is_call(reader):
        arg = reader.spanned(t.Mul((arg, _atom(reader))), start)
    if reader.sees("^") or reader.token.kind == "raised":
        raise reader.error("is the argument or the function raised to this power?",
                           f"Write {token.text}(x^2) or {token.text}(x)^2.")  # fmt: skip
    return arg
