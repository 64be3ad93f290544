"""sympy → display tree: the expression is walked with a table of the heads that have a meaning here; no text is run.

A function of the time is a coordinate by its name, its derivatives are the speed and the acceleration. Everything
else that sympy knows is refused with a sentence.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache
from typing import Any

from rbpsym.errors import LimitError, ReadError
from rbpsym.expr import tree as t
from rbpsym.expr.infix_names import FUNCTIONS, MAX_DIGITS
from rbpsym.expr.limits import check_degree, check_exponent, check_size
from rbpsym.face.late import sympy
from rbpsym.statement.source import kind_of, written

CLOCK = "t"
HEADS = ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "exp", "log", "elliptic_k", "elliptic_e")
RELATIONS = {"Eq": "=", "Ne": "!=", "Lt": "<", "Gt": ">", "Le": "<=", "Ge": ">="}
SIGNS = {  # of parameters, as sympy assumes them
    "positive": {"positive": True},
    "nonnegative": {"nonnegative": True},
    "nonzero": {"real": True, "nonzero": True},
    "real": {"real": True},
}


def is_sympy(value: object) -> bool:
    """Whether the value is an expression of sympy (which is not imported to find out)."""
    return "sympy" in sys.modules and isinstance(value, sympy.Basic)


def tree_of(value: object) -> t.Node:
    """The tree of an expression, a relation or a number. Raises ReadError, LimitError.

    >>> import sympy
    >>> from rbpsym.typeset.machine import to_machine
    >>> ell, theta = sympy.Symbol("ell", positive=True), sympy.Function("theta")(sympy.Symbol("t"))
    >>> to_machine(tree_of(2 * ell * sympy.cos(theta) / 3))
    '2*ell*cos(theta)/3'
    """
    if not is_sympy(value) and written(value) is None:
        raise ReadError(f"{kind_of(value)} is no expression of sympy", instead='write sympy.Symbol("ell"), say.')
    expression: Any = value if is_sympy(value) else sympy.Integer(0) + value
    check_size(expression, lambda part: getattr(part, "args", ()))
    found = _tree(expression)
    check_degree(found)
    return found


def name_of(symbol: object) -> str:
    """The name of a symbol or of a function of the time. Raises ReadError for anything else."""
    found = tree_of(symbol)
    if isinstance(found, t.Sym):
        return found.name
    raise _refused(symbol, "is no symbol", 'write sympy.Symbol("ell", positive=True) or dynamicsymbols("theta").')


def _refused(expression: object, why: str, instead: str) -> ReadError:
    text = str(expression)
    return ReadError(f"sympy's “{text if len(text) < 80 else f'{text[:77]}...'}” {why}", instead=instead)


def _tree(expression: Any) -> t.Node:
    for kind, rule in _rules():
        if isinstance(expression, kind):
            return rule(expression)
    known = f"known are + - * /, powers, pi, functions of the time and their derivatives, sqrt, Abs, {', '.join(HEADS)}."
    raise _refused(expression, f"({type(expression).__name__}) has no meaning here", known)


@cache
def _rules() -> tuple[tuple[type, Callable[[Any], t.Node]], ...]:
    """What each kind of expression is, the first that fits."""

    def function(name: str) -> Callable[[Any], t.Node]:
        return lambda expression: FUNCTIONS[name](_tree(expression.args[0]))

    def relation(op: str) -> Callable[[Any], t.Node]:
        return lambda expression: t.relation(_tree(expression.lhs), op, _tree(expression.rhs))

    return (
        (sympy.Rational, _rational),
        (sympy.Float, lambda number: _rational(sympy.Rational(str(number)))),  # as it is written: 0.1 is 1/10
        (type(sympy.pi), lambda _: t.Sym("pi")),
        (type(sympy.E), lambda _: t.Fn("exp", t.ONE)),
        (sympy.Symbol, _symbol),
        (sympy.core.function.AppliedUndef, _function_of_time),
        (sympy.Derivative, _derivative),
        (sympy.Add, lambda sum: t.add(*map(_tree, sum.as_ordered_terms()))),
        (sympy.Mul, _product),
        (sympy.Pow, _power),
        (sympy.Abs, function("abs")),
        *((getattr(sympy, name), function(name)) for name in HEADS),
        *((getattr(sympy, name), relation(op)) for name, op in RELATIONS.items()),
    )


def _rational(number: Any) -> t.Node:
    if max(abs(number.p), number.q) >= 10**MAX_DIGITS:
        raise LimitError(f"a number of more than {MAX_DIGITS} digits", instead="write a shorter one.")
    return t.Num(int(number.p)) if number.q == 1 else t.Div(t.Num(int(number.p)), t.Num(int(number.q)))


def _symbol(symbol: Any) -> t.Node:
    name, means_else = symbol.name, {CLOCK: sympy.Symbol(CLOCK), "pi": None}
    if isinstance(symbol, sympy.Dummy | sympy.Wild) or means_else.get(name, symbol) != symbol or not symbol.is_commutative:
        raise _refused(symbol, "is no plain symbol", "write sympy.Symbol; the time is dynamicsymbols._t, π is sympy.pi.")
    return _named(name)


def _named(name: str) -> t.Sym:
    if name.isascii() and name.isidentifier():
        return t.Sym(name)
    raise ReadError(f"“{name}” can't be a name", instead="a name is made of a-z, A-Z, 0-9 and “_”, a letter first: theta_0.")


def _function_of_time(applied: Any) -> t.Node:
    name = applied.func.__name__
    if applied != sympy.Function(name)(sympy.Symbol(CLOCK)):
        raise _refused(applied, "is no function of t alone", f'write dynamicsymbols("{name}"), without assumptions.')
    return _named(name)


def _derivative(derivative: Any) -> t.Node:
    of, (variable, order) = derivative.args[:2]
    if len(derivative.args) > 2 or variable != sympy.Symbol(CLOCK) or order not in (1, 2) or not of.is_Function:
        raise _refused(derivative, "is no speed or acceleration of a coordinate", "carry it out: .doit().")
    return t.Sym(f"{name_of(of)}_{'d' * int(order)}ot")


def _product(product: Any) -> t.Node:
    """Factors with a negative exponent stand below the bar."""
    parts = [(part.num, part.den) if isinstance(part, t.Div) else (part, t.ONE) for part in map(_tree, product.args)]
    return t.div(t.mul(*(top for top, _ in parts)), t.mul(*(low for _, low in parts)))


def _power(power: Any) -> t.Node:
    if power.exp.is_Rational and power.exp.is_negative:
        return t.div(t.ONE, _tree(1 / power))
    base, exponent = _tree(power.base), _tree(power.exp)
    check_exponent(exponent)
    return t.Sqrt(base) if exponent == t.Div(t.ONE, t.TWO) else t.Pow(base, exponent)
