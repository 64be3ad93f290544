"""The exact value of a display tree.

A `Meanings` says what names mean; a name without meaning is a generator of the field. The
value is a `Scalar`, or a `Space` vector. `rate` is the time derivative of a formula in which
integrals along the motion may stand with forces that are not known yet: d/dt ∫f dq = f q̇.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add
from typing import Any

from rbpsym.errors import ReadError, Undecided
from rbpsym.expr import tree as t
from rbpsym.field.calculus import derivative, function, rate_along, substitute
from rbpsym.field.integration import definite
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, lift, symbol
from rbpsym.field.vector import EX, EY, Space
from rbpsym.frozen import Frozen, field, replace

Value = Scalar | Space


class Meanings(Frozen):
    """Meanings of names.

    scalars, vectors: values of defined quantities. rates: time derivative of each generator
    that varies (θ: θ̇, θ̇: θ̈). start: what each generator is at the start. body: value of ∫ f dm
    for an integrand f. powers: rate of each quantity that is known by its rate (a work).
    densities: da/dm of a vector a that is spread over a body; total: a sum over all forces on it.
    """

    scalars: Mapping[str, Scalar] = field(default_factory=dict)
    vectors: Mapping[str, Space] = field(default_factory=dict)
    rates: Mapping[str, Scalar] = field(default_factory=dict)
    start: Mapping[str, Scalar] = field(default_factory=dict)
    body: Callable[[Scalar, str], Scalar] | None = None
    powers: Mapping[str, Scalar] = field(default_factory=dict)
    densities: Mapping[str, Space] = field(default_factory=dict)
    total: Callable[[Scalar], Scalar] | None = None

    def with_scalars(self, more: Mapping[str, Scalar]) -> Meanings:
        """The same scope with further (or other) scalar meanings."""
        return replace(self, scalars={**self.scalars, **more})


BARE = Meanings()


def value(node: t.Node, scope: Meanings = BARE) -> Value:
    """The value of a formula (of the first item for a chain).

    Raises ReadError for a node that has no value (a word), Undecided for an integral outside
    the decidable class, ZeroDivisionError for a division by the form 0.
    """
    return VALUES[type(node)](node, scope)


def scalar(node: t.Node, scope: Meanings = BARE) -> Scalar:
    """The value, which must be a scalar."""
    found = value(node, scope)
    if isinstance(found, Space):
        raise ReadError("a vector stands where a scalar belongs")
    return found


def vector(node: t.Node, scope: Meanings = BARE) -> Space:
    """The value, which must be a vector (a scalar 0 counts as the zero vector)."""
    found = value(node, scope)
    if isinstance(found, Space):
        return found
    if not found:
        return Space()
    raise ReadError("a scalar stands where a vector belongs")


def time_derivative(found: Scalar, scope: Meanings) -> Scalar:
    """d/dt of a scalar by the chain rule over the scope's rates."""
    return rate_along(found, scope.rates)


def space_derivative(found: Space, scope: Meanings) -> Space:
    """d/dt of a vector."""
    return Space(found.plane.rate(scope.rates), time_derivative(found.z, scope))


def at_start(found: Scalar, scope: Meanings) -> Scalar:
    """The value at the start state."""
    return substitute(found, scope.start)


def _symbol(node: t.Sym, scope: Meanings) -> Scalar:
    if node.name == "pi":
        return PI
    found = scope.scalars.get(node.name)
    return symbol(node.name) if found is None else found


def _vector(node: t.Vec, scope: Meanings) -> Space:
    try:
        return scope.vectors[node.name]
    except KeyError:
        raise ReadError(f"the vector “{node.name}” has no meaning here") from None


UNITS = {"x": Space(EX), "y": Space(EY), "z": Space(z=UNITY)}


def _sum(node: t.Add, scope: Meanings) -> Value:
    found = [value(term, scope) for term in node.terms]
    if any(isinstance(part, Space) for part in found):
        return reduce(add, [part if isinstance(part, Space) else _no_scalar(part) for part in found])
    return reduce(add, [part for part in found if not isinstance(part, Space)])


def _no_scalar(part: Scalar) -> Space:
    if part:
        raise ReadError("a scalar and a vector are added")
    return Space()


def _product(node: t.Mul, scope: Meanings) -> Value:
    result: Value = UNITY
    for factor in node.factors:
        found = value(factor, scope)
        if not isinstance(found, Space):
            result = result * found
        elif isinstance(result, Space):
            raise ReadError("two vectors are multiplied without a dot or a cross")
        else:
            result = found * result
    return result


def _fraction(node: t.Div, scope: Meanings) -> Value:
    den = scalar(node.den, scope)
    return value(node.num, scope) * den.inverse()


def _power(node: t.Pow, scope: Meanings) -> Value:
    base = _squared_magnitude(node, scope) or value(node.base, scope)
    if isinstance(base, Space):
        if node.exponent != t.TWO:
            raise ReadError("a vector can only be squared")
        return base.dot(base)
    exponent = scalar(node.exponent, scope).number()
    if exponent is None:
        raise Undecided("an exponent that is not a number is outside the decidable class")
    if exponent.denominator == 1:
        return base ** int(exponent)
    if exponent.denominator == 2:
        return function("sqrt", base) ** exponent.numerator
    raise Undecided(f"the exponent {exponent} is outside the decidable class")


def _squared_magnitude(node: t.Pow, scope: Meanings) -> Space | None:
    """The vector whose name is squared without its arrow: V² is V · V where V names no scalar."""
    name = node.base.name if isinstance(node.base, t.Sym) and node.exponent == t.TWO else ""
    return None if name in scope.scalars else scope.vectors.get(name)


def _absolute(node: t.Abs, scope: Meanings) -> Scalar:
    found = value(node.arg, scope)
    return function("sqrt", found.dot(found) if isinstance(found, Space) else found * found)


def _derivative(node: t.Deriv, scope: Meanings) -> Value:
    if node.wrt == "m" and isinstance(node.of, t.Vec) and node.of.name in scope.densities:
        return scope.densities[node.of.name]
    found = value(node.of, scope)
    for _ in range(node.order):
        if node.wrt == "t":
            found = space_derivative(found, scope) if isinstance(found, Space) else time_derivative(found, scope)
        elif isinstance(found, Space):
            raise ReadError("a vector is differentiated by the time alone")
        else:
            found = derivative(found, node.wrt)
    return found


def _integral(node: t.Integral, scope: Meanings) -> Scalar:
    found = definite(scalar(node.integrand, scope), node.var, scalar(node.lower, scope), scalar(node.upper, scope))
    if found is None:
        raise Undecided("this integral is outside the class that is integrated in closed form")
    return found


def _body_integral(node: t.BodyIntegral, scope: Meanings) -> Value:
    if scope.body is None:
        raise ReadError("an integral over a body stands where no body is known")
    found, integrate = value(node.integrand, scope), scope.body
    if not isinstance(found, Space):
        return integrate(found, node.body)
    x, y, z = (integrate(part, node.body) for part in found.components())
    return Space(EX * x + EY * y, z)


def _between(node: t.Bracket, scope: Meanings) -> Scalar:
    inner = scalar(node.arg, scope)
    upper = substitute(inner, {node.var: scalar(node.upper, scope)})
    return upper - substitute(inner, {node.var: scalar(node.lower, scope)})


def _change(node: t.Delta, scope: Meanings) -> Scalar:
    found = scalar(node.arg, scope)
    return found - at_start(found, scope)


def _there(node: t.At, scope: Meanings) -> Scalar:
    if node.condition != t.equation(t.Sym("t"), t.ZERO):
        raise ReadError("a quantity has a value at the start (t = 0) alone")
    return at_start(scalar(node.arg, scope), scope)


def _limit(node: t.Limit, scope: Meanings) -> Scalar:
    found, to = scalar(node.arg, scope), scalar(node.to, scope)
    return substitute(found, {node.var: to})


def _no_value(node: t.Node, scope: Meanings) -> Value:
    raise ReadError(f"{type(node).__name__.lower()} has no value")


VALUES: dict[type, Callable[[Any, Meanings], Value]] = {
    t.Num: lambda node, scope: lift(node.value),
    t.Sym: _symbol,
    t.Vec: _vector,
    t.Unit: lambda node, scope: UNITS[node.axis],
    t.Add: _sum,
    t.Neg: lambda node, scope: -value(node.arg, scope),
    t.Mul: _product,
    t.Div: _fraction,
    t.Pow: _power,
    t.Sqrt: lambda node, scope: function("sqrt", scalar(node.arg, scope)),
    t.Fn: lambda node, scope: function(node.name, scalar(node.arg, scope)),
    t.Abs: _absolute,
    t.Group: lambda node, scope: value(node.arg, scope),
    t.Cross: lambda node, scope: vector(node.left, scope).cross(vector(node.right, scope)),
    t.Dot: lambda node, scope: vector(node.left, scope).dot(vector(node.right, scope)),
    t.Deriv: _derivative,
    t.Integral: _integral,
    t.BodyIntegral: _body_integral,
    t.PathIntegral: _no_value,
    t.Sum: _no_value,
    t.Bracket: _between,
    t.Delta: _change,
    t.At: _there,
    t.Limit: _limit,
    t.Word: _no_value,
    t.Chain: lambda node, scope: value(node.items[0], scope),
    t.Relations: _no_value,
}


def rate(node: t.Node, scope: Meanings) -> Scalar:
    """d/dt of a scalar formula that may hold integrals along the motion from the start to now."""
    if not _holds_integral(node, scope):
        return _plain_rate(node, scope)
    return RATES.get(type(node), _plain_rate)(node, scope)


def _holds_integral(node: t.Node, scope: Meanings) -> bool:
    """Whether a part is known by its rate only (changes, which have one, are counted in)."""
    return any(
        isinstance(part, (t.Integral, t.PathIntegral, t.Delta))
        or (isinstance(part, t.Sym) and part.name in scope.powers)
        for part in t.walk(node)
    )


def _plain_rate(node: t.Node, scope: Meanings) -> Scalar:
    return time_derivative(scalar(node, scope), scope)


def _product_rate(node: t.Mul, scope: Meanings) -> Scalar:
    """The product rule (a factor that holds an integral needs constant others to have a value)."""
    total = NOTHING
    for place, factor in enumerate(node.factors):
        others = node.factors[:place] + node.factors[place + 1 :]
        part = rate(factor, scope)
        if part:
            total = total + part * reduce(lambda a, b: a * scalar(b, scope), others, UNITY)
    return total


def _path_rate(node: t.PathIntegral, scope: Meanings) -> Scalar:
    if node.product == "dot":
        return vector(node.integrand, scope).dot(space_derivative(vector(node.path, scope), scope))
    return scalar(node.integrand, scope) * rate(node.path, scope)


def _integral_rate(node: t.Integral, scope: Meanings) -> Scalar:
    """∫f dq from the start to now grows at f q̇, from now to the start at -f q̇."""
    ends = scalar(node.lower, scope), scalar(node.upper, scope)
    start, now = scope.start.get(node.var, ends[0]), symbol(node.var)
    speed = scope.rates.get(node.var, NOTHING)
    for sign, limits in ((1, (start, now)), (-1, (now, start))):
        if all(not end - limit for end, limit in zip(ends, limits, strict=True)):
            return scalar(node.integrand, scope) * speed * sign
    return _plain_rate(node, scope)


def _total_rate(node: t.Sum, scope: Meanings) -> Scalar:
    if scope.total is None:
        raise ReadError("a sum stands where its terms are not known")
    return scope.total(rate(node.term, scope))


def _symbol_rate(node: t.Sym, scope: Meanings) -> Scalar:
    found = scope.powers.get(node.name)
    return _plain_rate(node, scope) if found is None else found


RATES: dict[type, Callable[[Any, Meanings], Scalar]] = {
    t.Sym: _symbol_rate,
    t.Add: lambda node, scope: sum((rate(term, scope) for term in node.terms), NOTHING),
    t.Neg: lambda node, scope: -rate(node.arg, scope),
    t.Group: lambda node, scope: rate(node.arg, scope),
    t.Delta: lambda node, scope: rate(node.arg, scope),
    t.Mul: _product_rate,
    t.Div: lambda node, scope: rate(node.num, scope) * scalar(node.den, scope).inverse(),
    t.Integral: _integral_rate,
    t.PathIntegral: _path_rate,
    t.Sum: _total_rate,
}
