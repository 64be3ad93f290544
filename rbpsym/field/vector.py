"""Plane vectors as sums of multiples of unit vectors, and space vectors for statements.

A plane vector is {direction: length}, a direction being an angle from +x. Keeping ℓ u(θ)
in one piece makes a product of two of them ℓ² cos(θ₁ - θ₂), as a textbook prints it, and
never a sum of four terms. Counter-clockwise is positive.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import lru_cache

from rbpsym.field import atoms
from rbpsym.field.calculus import rate_along, substitute
from rbpsym.field.poly import ONE, Coefficient, Monomial, Poly
from rbpsym.field.scalar import NOTHING, PI, UNITY, Scalar, lift, total
from rbpsym.field.trig import PI_TERM, cosine, sine
from rbpsym.frozen import Frozen

QUARTER = PI * Fraction(1, 2)


class Vector:
    """A vector in the plane of motion. `x` and `y` are its Cartesian components."""

    __slots__ = ("parts",)

    def __init__(self, parts: Mapping[Scalar, Scalar]) -> None:
        self.parts = parts

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Vector) and self.parts == other.parts

    def __hash__(self) -> int:
        return hash(frozenset(self.parts.items()))

    def __bool__(self) -> bool:
        return bool(self.parts)

    def __repr__(self) -> str:
        return f"Vector({self.x!r}, {self.y!r})"

    def __add__(self, other: Vector) -> Vector:
        parts = dict(self.parts)
        for angle, length in other.parts.items():
            parts[angle] = parts[angle] + length if angle in parts else length
        return Vector({angle: length for angle, length in parts.items() if length})

    def __neg__(self) -> Vector:
        return Vector({angle: -length for angle, length in self.parts.items()})

    def __sub__(self, other: Vector) -> Vector:
        return self + (-other)

    def __mul__(self, factor: Scalar | int | Fraction) -> Vector:
        factor = lift(factor)
        return Vector({a: factor * n for a, n in self.parts.items()} if factor else {})

    __rmul__ = __mul__

    @property
    def x(self) -> Scalar:
        """Component along +x."""
        return total(n * cosine(a) for a, n in self.parts.items())

    @property
    def y(self) -> Scalar:
        """Component along +y."""
        return total(n * sine(a) for a, n in self.parts.items())

    def dot(self, other: Vector) -> Scalar:
        """Scalar product."""
        return _pairs(self, other, cosine)

    def cross(self, other: Vector) -> Scalar:
        """The z component of the vector product self × other."""
        return _pairs(self, other, sine)

    def turned(self) -> Vector:
        """The vector turned by a quarter counter-clockwise: k × self."""
        return vector_sum((n, a + QUARTER) for a, n in self.parts.items())

    def settled(self) -> Vector:
        """In Cartesian form if that has only one component or fewer parts."""
        from rbpsym.field.normal import is_zero, shorten

        if len(self.parts) < 2:
            return self
        x, y = (Scalar(shorten(c.num), c.den) for c in (self.x, self.y))
        plain = polar(NOTHING if is_zero(x) else x, NOTHING) + polar(NOTHING if is_zero(y) else y, QUARTER)
        return plain if len(plain.parts) < len(self.parts) else self

    def vanishes(self) -> bool:
        """Whether both components are zero."""
        from rbpsym.field.normal import is_zero

        return is_zero(self.x) and is_zero(self.y)

    def derivative(self, name: str) -> Vector:
        """∂/∂(symbol), directions included."""
        return self.rate({name: UNITY})

    def rate(self, rates: Mapping[str, Scalar]) -> Vector:
        """Σ ∂/∂(symbol) × rate of the symbol, directions included."""
        parts = []
        for angle, length in self.parts.items():
            parts.append((rate_along(length, rates), angle))
            turning = rate_along(angle, rates)
            if turning:
                parts.append((length * turning, angle + QUARTER))
        return vector_sum(parts)

    def substitute(self, images: Mapping[str, Scalar]) -> Vector:
        """Symbols replaced in lengths and directions."""
        return vector_sum((substitute(n, images), substitute(a, images)) for a, n in self.parts.items())


def _pairs(a: Vector, b: Vector, of: Callable[[Scalar], Scalar]) -> Scalar:
    return total(
        length_a * length_b * turn
        for angle_a, length_a in a.parts.items()
        for angle_b, length_b in b.parts.items()
        if (turn := _between(angle_a, angle_b, of))
    )


@lru_cache(maxsize=16384)
def _between(angle_a: Scalar, angle_b: Scalar, of: Callable[[Scalar], Scalar]) -> Scalar:
    return of(angle_b - angle_a)


def polar(length: Scalar, angle: Scalar) -> Vector:
    """length × u(angle), the direction reduced to a half turn without a leading minus."""
    if not length:
        return Vector({})
    if angle.den is not ONE:
        return _polar_over_sum(length, angle)
    terms = dict(angle.num.terms)
    turns = Fraction(terms.pop(PI_TERM, 0))
    whole, rest = divmod(turns, 1)
    if rest:
        terms[PI_TERM] = rest
    return Vector({Scalar(Poly(terms)): -length if whole % 2 else length})


def _polar_over_sum(length: Scalar, angle: Scalar) -> Vector:
    """The same for an angle over a sum, (A + q π D)/D: whole half turns q are taken out."""
    first, size = next(iter(angle.den.terms.items()))
    [with_pi] = (Scalar(Poly({first: 1})) * PI).num.terms
    whole = Fraction(angle.num.terms.get(with_pi, 0)) / size // 1
    return Vector({angle - PI * whole: -length if whole % 2 else length})


def vector_sum(parts: Iterable[tuple[Scalar, Scalar]]) -> Vector:
    """Σ length × u(angle) over (length, angle) pairs."""
    found: dict[Scalar, Scalar] = {}
    for length, angle in parts:
        for direction, value in polar(length, angle).parts.items():
            found[direction] = found[direction] + value if direction in found else value
    return Vector({angle: length for angle, length in found.items() if length})


def cartesian(x: Scalar, y: Scalar) -> Vector:
    """The vector with these components; pairs a cos A, a sin A are kept as a u(A)."""
    matched, rest_y = Vector({}), dict(y.num.terms) if y.den is ONE else None
    if rest_y is None or x.den is not ONE:
        return _plain(x, y)
    rest_x = {}
    for m, c in x.num.terms.items():
        found = _match(m, c, rest_y)
        if found is None:
            rest_x[m] = c
        else:
            matched = matched + found
    return matched + _plain(Scalar(Poly(rest_x)), Scalar(Poly(rest_y)))


def _plain(x: Scalar, y: Scalar) -> Vector:
    return vector_sum(((x, NOTHING), (y, QUARTER)))


def _match(m: Monomial, c: Coefficient, rest_y: dict[Monomial, Coefficient]) -> Vector | None:
    """Takes the partner of an x term out of `rest_y` and returns both as one direction."""
    for place, (index, exponent) in enumerate(m):
        found = atoms.atom(index)
        if exponent != 1 or found.kind not in ("cos", "sin"):
            continue
        other = atoms.intern("sin" if found.kind == "cos" else "cos", found.arg)
        rest = m[:place] + m[place + 1 :]
        partner = tuple(sorted((*rest, (other, 1))))
        value = rest_y.get(partner)
        if value in (c, -c):
            del rest_y[partner]
            return _direction(Scalar(Poly({rest: c})), Scalar(found.arg), found.kind, value == c)
    return None


def _direction(length: Scalar, angle: Scalar, kind: str, same: bool) -> Vector:
    """(cos A, ±sin A) = u(±A);  (sin A, ±cos A) = u(π/2 - A) or u(A - π/2)."""
    if kind == "cos":
        return polar(length, angle if same else -angle)
    return polar(length, QUARTER - angle if same else angle - QUARTER)


ORIGIN = Vector({})
EX, EY = polar(UNITY, NOTHING), polar(UNITY, QUARTER)


class Space(Frozen):
    """A vector of space: its part in the plane of motion and its component along k."""

    plane: Vector = ORIGIN
    z: Scalar = NOTHING

    def __add__(self, other: Space) -> Space:
        return Space(self.plane + other.plane, self.z + other.z)

    def __neg__(self) -> Space:
        return Space(-self.plane, -self.z)

    def __sub__(self, other: Space) -> Space:
        return self + (-other)

    def __mul__(self, factor: Scalar) -> Space:
        return Space(self.plane * factor, self.z * factor)

    def dot(self, other: Space) -> Scalar:
        """Scalar product."""
        return self.plane.dot(other.plane) + self.z * other.z

    def cross(self, other: Space) -> Space:
        """Vector product."""
        in_plane = other.plane.turned() * self.z - self.plane.turned() * other.z
        return Space(in_plane, self.plane.cross(other.plane))

    def components(self) -> tuple[Scalar, Scalar, Scalar]:
        """(x, y, z)."""
        return self.plane.x, self.plane.y, self.z
