"""The infix of files and JSON: `-3*g/(4*ell)*cos(theta)`. One function a node type.

Expressions can be read by Python, sympy and `read_infix`; what is no expression is written as
a call (`Integral(f, theta, theta_0, theta)`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction as Rational
from keyword import iskeyword

from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import DEFAULT, Notation

_RELATION, _SUM, _PRODUCT, _UNARY, _POWER, _ATOM = range(6)
_FUNCTIONS = {"ln": "log"}
_NUMBERS = ("Integer", "Float", "Rational", "Symbol", "Function")  # what sympy writes round what it reads


def to_machine(node: t.Node, notation: Notation = DEFAULT) -> str:
    """The machine infix of a formula; names are those of the problem, whatever the notation."""
    return _written(node)[0]


def _written(node: t.Node) -> tuple[str, int]:
    """(text, how tightly it binds); what has no sign of its own is a call with all its parts."""
    kind: type = type(node)
    write = TABLE.get(kind)
    return write(node) if write else _call(kind.__name__, *(getattr(node, name) for name in t.parts(kind)))


def _wrap(node: t.Node, least: int) -> str:
    text, level = _written(node)
    return text if level >= least else f"({text})"


def _num(node: t.Num) -> tuple[str, int]:
    value = Rational(node.value)
    level = _SUM if value < 0 else _ATOM if value.denominator == 1 else _PRODUCT
    return str(value), level


def _name(node: t.Sym | t.Vec) -> tuple[str, int]:
    return machine_name(node.name), _ATOM


def machine_name(name: str) -> str:
    """The name as it is written: with an underscore where Python has a word of its own (lambda)."""
    return f"{name}_" if iskeyword(name) or name in _NUMBERS else name


def written_otherwise(names: Collection[str]) -> dict[str, str]:
    """The names of which `machine_name` makes others, by these."""
    written = {machine_name(name): name for name in names}
    return {other: name for other, name in written.items() if other != name and other not in names}


def _add(node: t.Add) -> tuple[str, int]:
    if not node.terms:
        return "0", _ATOM
    text = _wrap(node.terms[0], _SUM)
    for term in node.terms[1:]:
        written = _wrap(term, _SUM + (isinstance(term, t.Add)))
        text += f" - {written[1:]}" if written.startswith("-") else f" + {written}"
    return text, _SUM


def _neg(node: t.Neg) -> tuple[str, int]:
    return f"-{_wrap(node.arg, _PRODUCT)}", _SUM


def _mul(node: t.Mul) -> tuple[str, int]:
    if not node.factors:
        return "1", _ATOM
    first, *rest = node.factors
    return "*".join([_wrap(first, _PRODUCT), *(_wrap(f, _UNARY) for f in rest)]), _PRODUCT


def _div(node: t.Div) -> tuple[str, int]:
    return f"{_wrap(node.num, _PRODUCT)}/{_wrap(node.den, _UNARY)}", _PRODUCT


def _pow(node: t.Pow) -> tuple[str, int]:
    return f"{_wrap(node.base, _ATOM)}**{_wrap(node.exponent, _ATOM)}", _POWER


def _group(node: t.Group) -> tuple[str, int]:
    return f"({to_machine(node.arg)})", _ATOM


def _call(name: str, *parts: t.Node | str | int) -> tuple[str, int]:
    written = (to_machine(part) if isinstance(part, t.Node) else str(part) for part in parts)
    return f"{name}({', '.join(written)})", _ATOM


def _deriv(node: t.Deriv) -> tuple[str, int]:
    name = "PartialDerivative" if node.partial else "Derivative"
    return _call(name, node.of, *([node.wrt] * node.order))


def _path(node: t.PathIntegral) -> tuple[str, int]:
    return _call("PathIntegral", node.integrand, node.path, f'"{node.product}"')


def _word(node: t.Word) -> tuple[str, int]:
    escaped = node.text.replace("\\", r"\\").replace('"', r"\"")
    return f'"{escaped}"', _ATOM


def _chain(node: t.Chain) -> tuple[str, int]:
    text = _wrap(node.items[0], _SUM)
    for op, item in zip(node.ops, node.items[1:], strict=True):
        text += f" {op} {_wrap(item, _SUM)}"
    return text, _RELATION


def _system(node: t.Relations) -> tuple[str, int]:
    return "; ".join(to_machine(row) for row in node.rows), _RELATION


TABLE: dict[type, Callable[..., tuple[str, int]]] = {
    t.Num: _num, t.Sym: _name, t.Vec: _name, t.Add: _add, t.Neg: _neg, t.Mul: _mul, t.Div: _div, t.Pow: _pow,
    t.Unit: lambda node: (f"unit_{node.axis}", _ATOM), t.Sqrt: lambda node: _call("sqrt", node.arg),
    t.Fn: lambda node: _call(_FUNCTIONS.get(node.name, node.name), node.arg), t.Abs: lambda node: _call("abs", node.arg),
    t.Group: _group, t.Deriv: _deriv, t.PathIntegral: _path, t.Word: _word, t.Chain: _chain, t.Relations: _system,
}  # fmt: skip
