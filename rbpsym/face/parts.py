"""What a model answers in parts: energies, works and momenta of centre of mass and turning; linear equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rbpsym.face.late import sympy


@dataclass(frozen=True)
class Halves:
    """What belongs to the motion of the centre of mass, and what to the turning about it; `on` each body apart."""

    translational: sympy.Expr
    rotational: sympy.Expr
    on: Mapping[str, Halves] = field(default_factory=dict)

    @property
    def total(self) -> sympy.Expr:
        """Both together."""
        return self.translational + self.rotational


@dataclass(frozen=True)
class AngularMomentum:
    """The component along z of an angular momentum: R × P of the centre of mass, and I_cm ω."""

    orbital: sympy.Expr
    spin: sympy.Expr

    @property
    def total(self) -> sympy.Expr:
        """Both together."""
        return self.orbital + self.spin


@dataclass(frozen=True)
class Linearization:
    """M δq̈ + C δq̇ + K δq = 0 about a place of rest, up to second order. `at` holds the coordinates that are not arbitrary;
    stable is None if it is not decided."""

    at: Mapping[sympy.Expr, sympy.Expr]
    mass_matrix: sympy.Matrix
    damping: sympy.Matrix
    stiffness: sympy.Matrix
    stable: bool | None

    @property
    def A(self) -> sympy.Matrix:
        """The matrix of d/dt (δq, δq̇) = A (δq, δq̇)."""
        size = self.mass_matrix.rows
        accelerations = self.mass_matrix.LUsolve(-sympy.Matrix.hstack(self.stiffness, self.damping))
        return sympy.Matrix.vstack(sympy.Matrix.hstack(sympy.zeros(size), sympy.eye(size)), accelerations)


def together(on: Mapping[str, Halves]) -> Halves:
    """The halves of all bodies."""
    parts = on.values()
    return Halves(sympy.Add(*(each.translational for each in parts)), sympy.Add(*(each.rotational for each in parts)), on)
