"""A straight line from its equation in x and y: “y = x*tan(beta)” is tan(beta) x - y = 0."""

from __future__ import annotations

from rbpsym.notation import tree
from rbpsym.notation.tree import ONE, ZERO, Node, add, div, mul, neg
from rbpsym.quantities import LENGTH
from rbpsym.statement.model import Line
from rbpsym.statement.scope import Scope, read_text, text_of
from rbpsym.statement.source import Item

_AXES = ("x", "y")
_Form = tuple[Node, Node, Node]  # coefficients of x, y and 1
_EXAMPLE = "write an equation of first degree in x and y, such as “x = 0” or “y = x*tan(beta)”."


class _NotLinear(Exception):
    """The expression is not of first degree in x and y."""


def read_line(item: Item, scope: Scope, what: str) -> Line:
    """The line a x + b y = c of an equation “left = right”; its normal is that of left - right."""
    text = text_of(item, what)
    if text.count("=") != 1 or any(sign in text for sign in ("==", "<", ">", "!")):
        raise item.error(f"{what} must be an equation with one “=”, not “{text}”", _EXAMPLE)
    left, right = text.split("=")
    inner = scope.with_variables(dict.fromkeys(_AXES, LENGTH))
    sides = _read(item, left, inner, what, 0), _read(item, right, inner, what, len(left) + 1)
    try:
        return _line(text.strip(), *sides)
    except _NotLinear:
        raise item.error(f"{what}: “{text}” is not a straight line", _EXAMPLE) from None


def _read(item: Item, text: str, scope: Scope, what: str, shift: int) -> Node:
    if not text.strip():
        raise item.error(f"{what}: a side of the equation is empty", _EXAMPLE)
    stripped = text.lstrip()
    return read_text(item, stripped, scope, what, LENGTH, shift=shift + len(text) - len(stripped))


def _line(label: str, left: Node, right: Node) -> Line:
    a, b, c = _sum([_form(left), _scaled(_form(right), neg(ONE))])
    if a == ZERO and b == ZERO:
        raise _NotLinear
    return Line(label, a, b, neg(c))


def _form(node: Node) -> _Form:
    """The coefficients of an expression."""
    if not tree.names(node) & set(_AXES):
        return ZERO, ZERO, node
    rule = _RULES.get(type(node))
    if rule is None:
        raise _NotLinear
    return rule(node)


def _symbol(node: tree.Sym) -> _Form:
    return (ONE, ZERO, ZERO) if node.name == "x" else (ZERO, ONE, ZERO)


def _sum(forms: list[_Form]) -> _Form:
    a, b, c = (_collected([form[i] for form in forms]) for i in range(3))
    return a, b, c


def _collected(terms: list[Node]) -> Node:
    """A sum in which opposite terms and plain numbers are joined."""
    kept: list[Node] = []
    number = sum(term.value for term in terms if isinstance(term, tree.Num))
    for term in (term for term in terms if not isinstance(term, tree.Num)):
        kept.remove(neg(term)) if neg(term) in kept else kept.append(term)
    return add(*kept, tree.Num(number))


def _scaled(form: _Form, factor: Node) -> _Form:
    a, b, c = (_product(factor, part) for part in form)
    return a, b, c


def _product(*factors: Node) -> Node:
    if all(isinstance(factor, tree.Num) for factor in factors):
        value = 1
        for factor in factors:
            value *= factor.value
        return tree.Num(value)
    return mul(*factors)


def _mul(node: tree.Mul) -> _Form:
    inside = [factor for factor in node.factors if tree.names(factor) & set(_AXES)]
    if len(inside) != 1:
        raise _NotLinear
    return _scaled(_form(inside[0]), _product(*(factor for factor in node.factors if factor is not inside[0])))


def _div(node: tree.Div) -> _Form:
    if tree.names(node.den) & set(_AXES):
        raise _NotLinear
    a, b, c = (div(part, node.den) for part in _form(node.num))
    return a, b, c


_RULES = {
    tree.Sym: _symbol,
    tree.Add: lambda node: _sum([_form(term) for term in node.terms]),
    tree.Neg: lambda node: _scaled(_form(node.arg), neg(ONE)),
    tree.Group: lambda node: _form(node.arg),
    tree.Mul: _mul,
    tree.Div: _div,
}
