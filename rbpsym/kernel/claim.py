"""A claim about functions of time, neutral of any prover, and values as its formulas."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import Monomial, Poly, Scalar, atoms, factors
from rbpsym.frozen import Frozen
from rbpsym.typeset.machine import to_machine

FUNCTIONS = ("sin", "cos", "asin", "acos", "atan", "exp", "ln")  # by their names in the prover, too


class Proposition(Frozen):
    """What is said of all times of the motion, if the claims in `given` hold at that time.

    kind: "equal"; "rate" (right is the rate of left); "start" (equal at the start); "more" (left > right; with a `var`, for
    each value of that); "least" (left ≥ right); "differ"; "slope" (right is the derivative of left by `var` at `place`).
    """

    left: t.Node
    right: t.Node
    kind: str = "equal"
    given: tuple[Proposition, ...] = ()
    var: str = ""
    place: t.Node = t.ZERO


TIME = "t"
AHEAD = Proposition(t.Sym(TIME), t.ZERO, "more")


class SaidByStep(Frozen):
    """What a step or a fact says: the definitions of the letters that it introduces, and what it asserts."""

    definitions: tuple[Proposition, ...] = ()
    assertions: tuple[Proposition, ...] = ()


def letter(node: t.Node) -> str:
    """The name of what must be a letter, of a number or a vector."""
    assert isinstance(node, t.Sym | t.Vec)
    return node.name


def is_along_time(node: t.Integral, moving: Callable[[str], bool]) -> bool:
    """Whether other functions of time than the variable stand in an integral."""
    return any(moving(name) for name in t.names(node.integrand) - {node.var})


def tree_of(value: Scalar | Poly) -> t.Node:
    """A value as a tree, term by term."""
    if isinstance(value, Scalar):
        num = tree_of(value.num)
        return num if value.den.constant_value() == 1 else t.Div(num, _product(value.den))
    return t.add(*(_term(m, c) for m, c in value.terms.items()))


def _product(poly: Poly) -> t.Node:
    """A polynomial by its factors: each of them is shown not to vanish."""
    number, parts = factors(poly)
    return t.mul(tree_of(Poly({(): number})), *(t.power(tree_of(part), exponent) for part, exponent in parts))


def _term(monomial: Monomial, coefficient: int | Fraction) -> t.Node:
    number = Fraction(coefficient)
    factors = [t.power(_atom(index), exponent) for index, exponent in monomial]
    return t.div(t.mul(t.Num(number.numerator), *factors), t.Num(number.denominator))


def _atom(index: int) -> t.Node:
    found = atoms.atom(index)
    if found.kind == "symbol":
        return t.Sym(found.arg)
    if found.kind == "root":
        return t.Sqrt(tree_of(found.arg))
    if found.kind not in FUNCTIONS:
        raise RbpsymError(f"the function {found.kind} has no term in Rocq")
    return t.Fn(found.kind, tree_of(found.arg))


def sides(claim: Proposition) -> Iterator[t.Node]:
    """The sides of a claim and of what it rests on."""
    yield from (claim.left, claim.right)
    for item in claim.given:
        yield from sides(item)


def brief(rest: t.Node) -> str:
    """A formula as text, cut to a line."""
    told = to_machine(rest)
    return told if len(told) < 80 else f"{told[:77]}…"
