"""Display tree → sympy: quantities that move are functions of the time, constants are symbols with their signs.

Vectors are non-commutative, so that they are never taken for scalars; `Dot`, `Cross` and `BodyIntegral` (∫ f dm over a
body) are undefined functions, for sympy has none that fit. An integral over a coordinate runs over a symbol, of which
all that moves is then a function.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from rbpsym.expr import tree as t
from rbpsym.face.late import sympy
from rbpsym.face.reading import CLOCK, RELATIONS, SIGNS
from rbpsym.field import Scalar, names_in
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.study import Study
from rbpsym.proof.context import Context

CLASSES = {op: name for name, op in RELATIONS.items()}


class Alphabet(Frozen):
    """What the names in a formula are in sympy.

    constants: symbols by name. coordinates, moving: names of what depends on the time (the second without derivatives
    of their own). clock: what it depends on, the time or the variable of an integral.
    """

    constants: Mapping[str, sympy.Symbol]
    coordinates: frozenset[str]
    moving: frozenset[str]
    clock: str = CLOCK

    def scalar(self, name: str) -> sympy.Expr:
        """A scalar quantity."""
        base, _, rate = name.rpartition("_")
        if name in self.constants:
            return self.constants[name]
        if self.clock == CLOCK and base in self.coordinates and rate in ("dot", "ddot"):
            return sympy.Derivative(self.scalar(base), (self.scalar(CLOCK), rate.count("d")))
        if {name, base} & self.coordinates or name in self.moving:
            return sympy.Function(name)(self.scalar(self.clock))
        return sympy.Symbol(name, real=True)

    def vector(self, name: str) -> sympy.Expr:
        """A vector quantity."""
        if name in self.moving:
            return sympy.Function(name, commutative=False)(self.scalar(self.clock))
        return sympy.Symbol(name, commutative=False)

    def over(self, variable: str) -> Alphabet:
        """The same where an integral runs over a variable."""
        bound = {variable: sympy.Symbol(variable, real=True), **self.constants}  # the time stays what it is
        return replace(self, constants=bound, clock=variable if variable in self.coordinates else self.clock)

    def write(self, node: t.Node) -> sympy.Expr:
        """The formula."""
        return TABLE[type(node)](node, self)

    def relations(self, statement: t.Node) -> tuple[sympy.Basic, ...]:
        """What a statement asserts, relation by relation."""
        return tuple(_relation(op, self.write(left), self.write(right)) for left, op, right in t.relations(statement))


def _relation(op: str, left: sympy.Expr, right: sympy.Expr) -> sympy.Basic:
    """For ≈ sympy has none: it is a predicate."""
    if op in CLASSES:
        return getattr(sympy, CLASSES[op])(left, right, evaluate=False)
    return sympy.assumptions.AppliedPredicate(sympy.Predicate("approximates"), left, right)


def alphabet(study: Study, context: Context | None = None) -> Alphabet:
    """The quantities of a problem, and the letters that its derivation defines."""
    system = study.system
    constants = {each.name: sympy.Symbol(each.name, **SIGNS[each.sign]) for each in study.problem.parameters}
    moving = set(system.unknowns)
    if context is not None:
        rates = {*system.scope.rates, *system.unknowns, *system.accelerations, CLOCK}
        letters: dict[str, tuple[Scalar, ...]] = {name: (value,) for name, value in context.scalars.items()}
        letters |= {name: value.components() for name, value in context.vectors.items()}
        moving |= {name for name, parts in letters.items() if any(names_in(part) & rates for part in parts)}
        moving |= context.works.keys()
    known = {CLOCK: sympy.Symbol(CLOCK), "pi": sympy.pi}
    return Alphabet(constants | known, frozenset(c.name for c in study.problem.coordinates), frozenset(moving))


def _power(node: t.Pow, names: Alphabet) -> sympy.Expr:
    base = names.write(node.base)
    return base ** names.write(node.exponent) if base.is_commutative else _dot(base, base)


def _dot(left: sympy.Expr, right: sympy.Expr) -> sympy.Expr:
    return sympy.Function("Dot")(left, right)


def _integral(node: t.Integral, names: Alphabet) -> sympy.Expr:
    inner, ends = names.over(node.var), (names.write(node.lower), names.write(node.upper))
    return sympy.Integral(inner.write(node.integrand), (inner.scalar(node.var), *ends))


def _along(node: t.PathIntegral, names: Alphabet) -> sympy.Expr:
    clock, force = names.scalar(CLOCK), names.write(node.integrand)
    rate = sympy.Derivative(names.write(node.path), clock)
    return sympy.Integral(_dot(force, rate) if node.product == "dot" else force * rate, (clock, 0, clock))


def _change(node: t.Delta, names: Alphabet) -> sympy.Expr:
    now = names.write(node.arg)
    return now - sympy.Subs(now, names.scalar(CLOCK), 0)


def _product(node: t.Node, names: Alphabet) -> sympy.Expr:
    return sympy.Mul(*_factors(node, names, 1))


def _factors(node: t.Node, names: Alphabet, sign: int) -> list[Any]:
    """The factors of a product, those below the bar with the exponent -1."""
    if isinstance(node, t.Neg):
        return [-1, *_factors(node.arg, names, sign)]
    if isinstance(node, t.Mul):
        return [part for factor in node.factors for part in _factors(factor, names, sign)]
    if isinstance(node, t.Div):
        return [*_factors(node.num, names, sign), *_factors(node.den, names, -sign)]
    return [names.write(node) ** sign]


# how each kind of node is written, that stands in steps of problems
TABLE: dict[type[t.Node], Callable[[Any, Alphabet], Any]] = {
    t.Num: lambda node, names: sympy.Rational(node.value.numerator, node.value.denominator),
    t.Sym: lambda node, names: names.scalar(node.name),
    t.Vec: lambda node, names: names.vector(node.name),
    t.Unit: lambda node, names: sympy.Symbol(f"unit_{node.axis}", commutative=False),
    t.Add: lambda node, names: sympy.Add(*map(names.write, node.terms)),
    t.Neg: _product,
    t.Mul: _product,
    t.Div: _product,
    t.Pow: _power,
    t.Sqrt: lambda node, names: sympy.sqrt(names.write(node.arg)),
    t.Fn: lambda node, names: getattr(sympy, node.name)(names.write(node.arg)),
    t.Abs: lambda node, names: sympy.Abs(names.write(node.arg)),
    t.Group: lambda node, names: names.write(node.arg),
    t.Cross: lambda node, names: sympy.Function("Cross", commutative=False)(names.write(node.left), names.write(node.right)),
    t.Dot: lambda node, names: _dot(names.write(node.left), names.write(node.right)),
    t.Deriv: lambda node, names: sympy.Derivative(names.write(node.of), (names.scalar(node.wrt), node.order)),
    t.Integral: _integral,
    t.BodyIntegral: lambda node, names: sympy.Function("BodyIntegral")(names.write(node.integrand), sympy.Symbol(node.body)),
    t.PathIntegral: _along,
    t.Delta: _change,
    t.At: lambda node, names: sympy.Subs(names.write(node.arg), names.scalar(CLOCK), 0),
}
