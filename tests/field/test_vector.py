"""Vectors of the plane and of space, against their components."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from rbpsym.field.calculus import derivative, substitute
from rbpsym.field.normal import is_zero, same
from rbpsym.field.scalar import NOTHING, PI, Scalar, lift
from rbpsym.field.trig import cosine, sine
from rbpsym.field.vector import EX, EY, ORIGIN, Space, Vector, cartesian, polar
from tests.field.strategies import A, B, X, Y, angles, polynomials, scalars, steady, unit_vectors, vectors

spaces = st.builds(Space, vectors, st.sampled_from([NOTHING, X, lift(2)]))


def same_vector(p: Vector, q: Vector) -> bool:
    return same(p.x, q.x) and same(p.y, q.y)


def same_space(p: Space, q: Space) -> bool:
    return all(map(same, p.components(), q.components()))


@steady
@given(vectors, vectors)
def test_products_by_components(p: Vector, q: Vector) -> None:
    assert same(p.dot(q), p.x * q.x + p.y * q.y)
    assert same(p.cross(q), p.x * q.y - p.y * q.x)


@steady
@given(vectors, vectors, vectors)
def test_linear_space(p: Vector, q: Vector, r: Vector) -> None:
    assert same_vector(p + q, q + p)
    assert same_vector((p + q) + r, p + (q + r))
    assert same_vector(p - p, ORIGIN)
    assert same((p + q).x, p.x + q.x)
    assert same_vector((p + q) * X, p * X + q * X)


@steady
@given(vectors, vectors)
def test_lagrange_identity(p: Vector, q: Vector) -> None:
    assert same(p.dot(q) ** 2 + p.cross(q) ** 2, p.dot(p) * q.dot(q))


@steady
@given(vectors, vectors)
def test_turning(p: Vector, q: Vector) -> None:
    assert same(p.turned().x, -p.y) and same(p.turned().y, p.x)
    assert is_zero(p.dot(p.turned()))
    assert same(p.turned().dot(q), p.cross(q))


@steady
@given(unit_vectors)
def test_unit_vectors(p: Vector) -> None:
    assert p.dot(p) == 1
    assert p.cross(p) == 0


@steady
@given(vectors)
def test_other_forms_of_the_same_vector(p: Vector) -> None:
    assert same_vector(p.settled(), p)
    assert same_vector(cartesian(p.x, p.y), p)


@steady
@given(scalars, scalars)
def test_components_are_those_given(x: Scalar, y: Scalar) -> None:
    found = cartesian(x, y)
    assert same(found.x, x) and same(found.y, y)


@steady
@given(vectors, vectors, st.sampled_from(["a", "b", "x"]))
def test_derivatives(p: Vector, q: Vector, name: str) -> None:
    rate = p.derivative(name)
    assert same(rate.x, derivative(p.x, name)) and same(rate.y, derivative(p.y, name))
    assert same(derivative(p.cross(q), name), rate.cross(q) + p.cross(q.derivative(name)))


@steady
@given(vectors)
def test_substitution(p: Vector) -> None:
    images = {"a": B + PI * Fraction(1, 2), "x": Y * 2}
    assert same(p.substitute(images).x, substitute(p.x, images))


@steady
@given(polynomials, angles)
def test_direction_is_kept_in_one_piece(length: Scalar, angle: Scalar) -> None:
    found = polar(length, angle)
    assert len(found.parts) <= 1
    assert same(found.x, length * cosine(angle)) and same(found.y, length * sine(angle))
    assert same_vector(polar(length, angle + PI), -found)


def test_a_pair_of_components_becomes_one_direction() -> None:
    assert cartesian(X * cosine(A), X * sine(A)).parts == {A: X}
    assert len(cartesian(X * sine(A), -X * cosine(A)).parts) == 1
    assert cartesian(lift(0), lift(0)) == ORIGIN
    assert (EX + EY).dot(EX - EY) == 0


@steady
@given(spaces, spaces, spaces)
def test_vector_product_of_space(p: Space, q: Space, r: Space) -> None:
    a, b = p.components(), q.components()
    expected = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    assert all(map(same, p.cross(q).components(), expected))
    assert same(p.dot(q), sum((x * y for x, y in zip(a, b, strict=True)), NOTHING))
    assert same_space(p.cross(q), -(q.cross(p)))
    assert same(p.dot(q.cross(r)), q.dot(r.cross(p)))


@steady
@given(spaces, spaces, spaces)
def test_triple_product(p: Space, q: Space, r: Space) -> None:
    assert same_space(p.cross(q.cross(r)), q * p.dot(r) - r * p.dot(q))
