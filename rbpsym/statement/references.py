"""Names that a statement may give, and what it refers to: bodies, points (“rod.end”, “O”, a place in space), lines.

A straight line is read from its equation: “y = x*tan(beta)” is tan(beta) x - y = 0."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from math import prod

from rbpsym.errors import StatementError
from rbpsym.expr import tree
from rbpsym.expr.tree import ONE, ZERO, Node, Sym, add, div, mul, neg, walk
from rbpsym.quantities import LENGTH
from rbpsym.statement.model import Body, Curve, Line, PointRef, Problem
from rbpsym.statement.scope import Scope, read_pair, read_text, text_of
from rbpsym.statement.source import SourceItem, SourceTable, did_you_mean, kind_of

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_FUNCTIONS = ("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "arcsin", "arccos", "arctan",
              "exp", "ln", "log", "sqrt", "abs", "sen", "tg", "ctg", "cotg", "cosec", "arcsen", "arctg")  # fmt: skip

RESERVED = {
    "t": "the time",
    "pi": "the number π",
    "O": "the origin",
    "cm": "the centre of mass of each body",
    "ground": "what does not move",
    "all": "all bodies",
    **dict.fromkeys(_FUNCTIONS, "a function"),
}
AXES = {"x": "an axis of space", "y": "an axis of space"}


def fault_of_name(name: str, reserved: dict[str, str] = RESERVED) -> tuple[str, str]:
    """What is wrong with a name and what to do, two empty texts if nothing is."""
    if not _NAME.fullmatch(name):
        return f"“{name}” can't be a name", "a name is made of a-z, A-Z, 0-9 and “_”, a letter first: theta_0, N_w."
    if name in reserved:
        return f"“{name}” is reserved: it means {reserved[name]}", "choose another name."
    if re.search(r"_d+ot$", name):
        return f"“{name}” can't be declared: names ending in _dot are time derivatives", "choose another name."
    return "", ""


def check_name(name: str, table: SourceTable, reserved: dict[str, str] = RESERVED, key: str | None = None) -> None:
    """Refuse a name that can't be; `table` is what bears the name, or holds it as `key`."""
    what, instead = fault_of_name(name, reserved)
    if what:
        raise table.error(what, instead, key)


def check_name_item(item: SourceItem, what: str) -> str:
    """The name that a value holds."""
    if not isinstance(item.value, str):
        raise item.error(f"{what} must be a name in quotes, not {kind_of(item.value)}")
    fault, instead = fault_of_name(item.value)
    if fault:
        raise item.error(fault, instead)
    return item.value


def twice(name: str, first: str, second: str, table: SourceTable, key: str | None = None) -> StatementError:
    """The error of a name that two things bear."""
    return table.error(f"“{name}” is the name of {first} and of {second}", "give one of them another name.", key)


_AXES = ("x", "y")
_Form = tuple[Node, Node, Node]  # coefficients of x, y and 1
_EXAMPLE = "write an equation of first degree in x and y, such as “x = 0” or “y = x*tan(beta)”."


class _NotLinear(Exception):
    """The expression is not of first degree in x and y."""


_CURVE_EXAMPLE = 'write curve = "y = x**2/(2*p)", or curve = ["R*(q - sin(q))", "R*cos(q)"] with a coordinate q.'


def read_line(item: SourceItem, scope: Scope, what: str) -> Line:
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


def read_curve(item: SourceItem, scope: Scope, what: str) -> Curve:
    """The curve of “y = f(x)”, of “x = f(y)”, or of a pair of functions of one coordinate."""
    if isinstance(item.value, (list, tuple)):
        x, y = read_pair(item, scope, what, LENGTH, "coordinates")
        found = sorted((tree.names(x) | tree.names(y)) & set(scope.coordinates))
        if len(found) != 1:
            raise item.error(f"{what} must be functions of one coordinate, not of {len(found)}", _CURVE_EXAMPLE)
        return Curve("", x, y, found[0])
    text = text_of(item, what)
    left, sign, right = text.partition("=")
    axis = {"y": "x", "x": "y"}.get(left.strip())
    if axis is None or not sign or "=" in right:
        raise item.error(f"{what} must be “y = ...” or “x = ...”, not “{text}”", _CURVE_EXAMPLE)
    height = _read(item, right, scope.with_variables({axis: LENGTH}), what, len(left) + 1)
    x, y = (Sym("x"), height) if axis == "x" else (height, Sym("y"))
    return Curve(text.strip(), x, y, axis, axis)


def _read(item: SourceItem, text: str, scope: Scope, what: str, shift: int) -> Node:
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
    numbers = [factor.value for factor in factors if isinstance(factor, tree.Num)]
    return tree.Num(prod(numbers)) if len(numbers) == len(factors) else mul(*factors)


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
    tree.Sym: lambda node: (ONE, ZERO, ZERO) if node.name == "x" else (ZERO, ONE, ZERO),
    tree.Add: lambda node: _sum([_form(term) for term in node.terms]),
    tree.Neg: lambda node: _scaled(_form(node.arg), neg(ONE)),
    tree.Group: lambda node: _form(node.arg),
    tree.Mul: _mul,
    tree.Div: _div,
}


CM = "cm"
GROUND = "ground"


def read_point(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> PointRef:
    """A point of a body, a fixed point by name, or a place as a pair."""
    if isinstance(item.value, (list, tuple)):
        place = read_pair(item, scope, what, LENGTH)
        return PointRef(f"({', '.join(str(part) for part in item.value)})", at=place)
    if not isinstance(item.value, str):
        raise item.error(f"{what} must be a point, not {kind_of(item.value)}", 'write it as "rod.end" or "O"')
    if item.value in scope.points:
        return PointRef(item.value, at=scope.points[item.value])
    return _point_of_body(item, scope, bodies, what)


def _point_of_body(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> PointRef:
    label = item.value
    body, dot, point = label.partition(".")
    if not dot:
        raise _no_point(item, scope, bodies, what)
    if body not in bodies:
        raise item.error_inside(f"{what}: there is no body “{body}”", did_you_mean(body, bodies, "bodies"), 1, len(body))
    known = points_of(bodies[body])
    if point not in known:
        raise item.error_inside(
            f"{what}: “{body}” has no point “{point}”",
            did_you_mean(point, known, "its points"),
            len(body) + 2,
            len(point),
        )
    return PointRef(label, body, point)


def _no_point(item: SourceItem, scope: Scope, bodies: Mapping[str, Body], what: str) -> Exception:
    name = item.value
    if name in bodies:
        choices = ", ".join(f"{name}.{point}" for point in points_of(bodies[name]))
        return item.error(f"{what}: “{name}” is a body, not a point", f"its points: {choices}.")
    known = [*scope.points, *(f"{body.name}.{point}" for body in bodies.values() for point in points_of(body))]
    return item.error(f"{what}: there is no point “{name}”", did_you_mean(name, known, "points"))


def points_of(body: Body) -> list[str]:
    """Names of the points of a body, its centre of mass among them."""
    return [*body.points, CM]


def read_body(item: SourceItem, bodies: Mapping[str, Body], what: str, others: tuple[str, ...] = ()) -> str:
    """The name of a body (or one of `others`)."""
    known = [*bodies, *others]
    if item.value not in known:
        found = f"“{item.value}”" if isinstance(item.value, str) else kind_of(item.value)
        raise item.error(f"{what}: {found} is not a body", did_you_mean(str(item.value), known, "bodies"))
    return str(item.value)


SAID = ("meanings", "names", "notation", "example", "text", "file")  # what is told of a name does not use it


def unused(problem: Problem) -> list[str]:
    """The parameters that no formula, question or claim of the statement holds, in the order of their declaration.

    >>> from rbpsym.statement.loader import load_problem
    >>> unused(load_problem("sliding-ladder"))
    []
    """
    used = set(_names([getattr(problem, part.name) for part in fields(problem) if part.name not in SAID]))
    return [quantity.name for quantity in problem.parameters if quantity.name not in used]


def _names(part: object) -> Iterator[str]:
    if isinstance(part, Node):
        yield from (node.name for node in walk(part) if isinstance(node, Sym))
    elif isinstance(part, str):
        yield from re.findall(r"\w+", part)
    elif isinstance(part, Mapping):
        yield from (name for pair in part.items() for item in pair for name in _names(item))
    elif isinstance(part, list | tuple):
        yield from (name for item in part for name in _names(item))
    elif is_dataclass(part):
        kept = (one.name for one in fields(part) if one.name not in ("name", "meaning"))
        yield from (name for key in kept for name in _names(getattr(part, key)))
