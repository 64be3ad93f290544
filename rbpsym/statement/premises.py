"""What is declared of quantities — signs and ranges — and which expressions contradict it.

Signs are decided by `decide.signs`: what is not so for any values that are declared is refused where it stands, and so
is a size (a mass, a length, a stiffness) that is negative for some of them. What else holds for some and fails for others
is left to the obligations of the steps that need it. The algebra is imported only where the form does not tell.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import prod
from typing import TYPE_CHECKING

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.frozen import Frozen, field
from rbpsym.quantities import Quantity
from rbpsym.statement.model import Coordinate

if TYPE_CHECKING:
    from rbpsym.decide.assumptions import Assumptions
    from rbpsym.field.scalar import Scalar

BROKEN = {"!=": ("zero",), ">=": ("negative",), ">": ("negative", "zero", "nonpositive")}
OPS = {"positive": ">", "nonnegative": ">=", "nonzero": "!="}
NEVER = {"nonpositive": "never positive"}
SIZES = ("positive", "nonnegative", "zero")
LEFT_OPEN = "of a sign that the declared signs and ranges leave open"
BY_FORM = {1: "positive", 0: "zero", -1: "negative"}


class Declared(Frozen):
    """Signs by name, and the bounds of open ranges."""

    signs: Mapping[str, str] = field(default_factory=dict)
    bounds: Mapping[str, tuple[Node | None, Node | None]] = field(default_factory=dict)

    def without(self, names: Iterable[str]) -> Declared:
        """The same with nothing known of these names."""
        names = set(names)
        signs = {name: sign for name, sign in self.signs.items() if name not in names}
        return Declared(signs, {name: both for name, both in self.bounds.items() if name not in names})

    def positive(self, *names: str) -> Declared:
        """The same where these are positive."""
        return Declared({**self.signs, **dict.fromkeys(names, "positive")}, self.bounds)

    @property
    def assumptions(self) -> Assumptions:
        """The same for the algebra; a bound without a value is none."""
        from rbpsym.decide.assumptions import Assumptions

        ranges = {name: (_bound(low), _bound(high)) for name, (low, high) in self.bounds.items()}
        return Assumptions(self.signs, ranges)


NOTHING_DECLARED = Declared()


def declared(parameters: Iterable[Quantity], coordinates: Iterable[Coordinate] = ()) -> Declared:
    """What is declared of parameters and coordinates."""
    parameters = tuple(parameters)
    ranged: tuple[Quantity | Coordinate, ...] = (*parameters, *coordinates)
    bounds = {q.name: (q.lower, q.upper) for q in ranged if (q.lower, q.upper) != (None, None)}
    return Declared({q.name: q.sign for q in parameters}, bounds)


def _bound(node: Node | None) -> Scalar | None:
    return None if node is None else _value(node)


def _value(node: Node) -> Scalar | None:
    from rbpsym.field.evaluate import scalar

    try:
        return scalar(node)
    except (RbpsymError, ZeroDivisionError):
        return None


def sign_of(node: Node, given: Declared = NOTHING_DECLARED) -> str | None:
    """What is surely the sign of an expression (see `decide.signs.SignResult`), or None."""
    plain = _by_form(node, given.signs)
    return BY_FORM[plain] if plain is not None else _by_value(node, given, factoring=False)


def _by_value(node: Node, given: Declared, *, factoring: bool) -> str | None:
    from rbpsym.decide.signs import sign

    value = _value(node)
    return None if value is None else sign(value, given.assumptions, factoring=factoring).kind


def _by_form(node: Node, signs: Mapping[str, str]) -> int | None:
    """The sign of a number, or of a product or sum of what is declared to be positive."""
    if isinstance(node, t.Num):
        return (node.value > 0) - (node.value < 0)
    if isinstance(node, t.Sym):
        return 1 if node.name == "pi" or signs.get(node.name) == "positive" else None
    rule = FORMS.get(type(node))
    found = [] if rule is None else [_by_form(part, signs) for part in t.children(node)]
    known = [sign for sign in found if sign is not None]
    return None if rule is None or len(known) < len(found) else rule(known)


FORMS: Mapping[type[Node], Callable[[list[int]], int | None]] = {
    t.Neg: lambda signs: -signs[0],
    t.Group: lambda signs: signs[0],
    t.Mul: prod,
    t.Div: lambda signs: prod(signs) if signs[1] else None,
    t.Add: lambda signs: signs[0] if len(set(signs)) == 1 else None,
}


def contradicts(node: Node, wanted: str, given: Declared) -> str:
    """What an expression is instead of `wanted` ("positive", ...), or may be; "" if it is so, or zero at the worst."""
    if wanted not in OPS:
        return ""
    found = sign_of(node, given)
    if found in BROKEN[OPS[wanted]]:
        return NEVER.get(found, found)
    found = found or _by_value(node, given, factoring=True)
    return "" if found in SIZES else LEFT_OPEN


def surely_above(left: Node | None, right: Node | None, given: Declared, *, or_equal: bool = False) -> bool:
    """Whether left > right (or left >= right) for all declared values."""
    if left is None or right is None:
        return False
    found = sign_of(t.add(left, t.neg(right)), given)
    return found == "positive" or (or_equal and found in ("zero", "nonnegative"))


def without_value(node: Node, given: Declared) -> tuple[Node, str] | None:
    """The first part of an expression that has no value for any declared numbers, and what it does."""
    return next(((part, _fault(part)) for part in t.walk(node) if _has_no_value(part, given)), None)


def _has_no_value(part: Node, given: Declared) -> bool:
    if not isinstance(part, LIMITED) or (isinstance(part, t.Fn) and part.name in EVERYWHERE):
        return False
    if isinstance(part, t.Div) and _by_form(part.den, given.signs):
        return False
    from rbpsym.decide import domain
    from rbpsym.decide.signs import sign
    from rbpsym.field.evaluate import BARE

    try:
        found = list(domain.RULES[type(part)](part, BARE))
    except (RbpsymError, ZeroDivisionError):
        return False  # a part of it has none
    return any(sign(c.value, given.assumptions, factoring=False).kind in BROKEN[c.op] for c in found)


LIMITED, EVERYWHERE = (t.Div, t.Pow, t.Sqrt, t.Fn), ("sin", "cos")  # what may have no value; what has one everywhere


def _fault(part: Node) -> str:
    if isinstance(part, t.Fn):
        return f"takes {part.name} of what is outside its domain"
    return "divides by zero" if isinstance(part, t.Div) else "takes a power or root that has no value"
