"""Dimensions of formulas, and the sentences for those that have none."""

from __future__ import annotations

import pytest

from rbpsym.decide.dimensions import dimension_of, require_dimension
from rbpsym.errors import DimensionError
from rbpsym.expr import tree
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Num, Sym
from rbpsym.quantities import DIMENSIONS, ENERGY, FORCE, LENGTH, MASS, NUMBER, TIME

KNOWN = {
    "m": MASS,
    "ell": LENGTH,
    "theta": NUMBER,
    "omega": TIME**-1,
    "g": DIMENSIONS["acceleration"],
    "k": DIMENSIONS["stiffness"],
}
x = Sym("ell")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("m*g*ell", "torque"),
        ("m*ell**2*omega**2/2", "energy"),
        ("sqrt(g/ell)", "angular speed"),
        ("ell + 0", "length"),
        ("0 + ell", "length"),
        ("0*m + ell", "length"),
        ("ell - ell*cos(theta)", "length"),
        ("(g*ell)**(1/2)", "speed"),
        ("pi - theta", "angle"),
        ("k*ell", "force"),
        ("0", "number"),
        ("-m*g", "force"),
        ("m**(-1)*m**2", "mass"),
    ],
)
def test_dimension(text: str, name: str) -> None:
    assert dimension_of(read_infix(text, KNOWN), KNOWN) == DIMENSIONS[name]


@pytest.mark.parametrize(
    ("text", "part", "says"),
    [
        ("m + ell", "ell", "a length is added to a mass"),
        ("ell - m*g", "m*g", "a force is added to a length"),
        ("sin(ell)", "ell", "the argument of sin must be an angle"),
        ("2**ell", "ell", "an exponent must be an angle or a number"),
        ("ell**theta", "theta", "the exponent of a length must be a plain number"),
        ("1 + ell", "ell", "a length is added to an angle or a number"),
        ("m*(ell + theta)", "theta", "an angle or a number is added to a length"),
    ],
)
def test_sentence(text: str, part: str, says: str) -> None:
    with pytest.raises(DimensionError) as found:
        dimension_of(read_infix(text, KNOWN), KNOWN)
    assert says in found.value.what
    place = found.value.place
    assert part in text[place.column - 1 :]
    assert text[place.column - 1 : place.column - 1 + place.width].strip("-() ") == part


@pytest.mark.parametrize(
    ("node", "dimension"),
    [
        (tree.Deriv(x), LENGTH / TIME),
        (tree.Deriv(x, "t", 2), LENGTH / TIME**2),
        (tree.Deriv(x, "theta"), LENGTH),
        (tree.Integral(Sym("g"), "ell", Num(0), x), DIMENSIONS["acceleration"] * LENGTH),
        (tree.Integral(Sym("s"), "s", Num(0), x), LENGTH**2),
        (tree.BodyIntegral(tree.Pow(x, Num(2))), DIMENSIONS["moment of inertia"]),
        (tree.PathIntegral(tree.Mul((Sym("k"), x)), x), ENERGY),
        (tree.Bracket(x, "theta", Num(0), Num(1)), LENGTH),
        (tree.Delta(x), LENGTH),
        (tree.Limit(x, "theta", Num(0)), LENGTH),
        (tree.Abs(tree.Neg(x)), LENGTH),
        (tree.Mul((tree.Mul((Sym("k"), x)), tree.Unit("x"))), FORCE),
        (tree.Cross(tree.Vec("ell"), tree.Vec("ell")), LENGTH**2),
        (tree.equation(x, Num(0), x), LENGTH),
        (tree.Relations((tree.equation(x, x), tree.equation(Sym("m"), Sym("m")))), NUMBER),
    ],
)
def test_every_node(node: tree.Node, dimension) -> None:
    assert dimension_of(node, KNOWN) == dimension


def test_there_is_a_rule_for_every_node() -> None:
    from rbpsym.decide.dimensions import _RULES

    nodes = {kind for kind in vars(tree).values() if isinstance(kind, type) and issubclass(kind, tree.Node)}
    assert set(_RULES) == nodes - {tree.Node}


def test_zero_is_of_any_dimension() -> None:
    require_dimension(Num(0), {}, FORCE, "the pull")
    with pytest.raises(DimensionError, match="the pull must be a force, but this is an angle or a number"):
        require_dimension(Num(1), {}, FORCE, "the pull")


def test_unequal_sides() -> None:
    with pytest.raises(DimensionError, match="a mass is compared with a length"):
        dimension_of(tree.equation(x, Sym("m")), KNOWN)
