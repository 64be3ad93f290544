"""Equations of motion against KanesMethod and LagrangesMethod of sympy.physics.mechanics, and `rigid_bodies` in them."""

from __future__ import annotations

from functools import cache

import pytest
from sympy import Expr, Matrix, Rational, sympify
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

import rbpsym
from rbpsym.face.model import SymbolicModel
from tests.face.systems import SYSTEMS, Twin, g

POSITIVE = dict.fromkeys(("M", "m", "m_1", "m_2", "ell", "a", "R", "r", "g", "k", "beta"), "positive")
NAMES = sorted(SYSTEMS)


@cache
def model(name: str) -> SymbolicModel:
    return rbpsym.model(rbpsym.problem("twin", **SYSTEMS[name].sections))


def same(left: Matrix, right: Matrix) -> bool:
    """By our own exact decision, entry by entry, after conversion back."""
    pairs = zip(left, right, strict=True)
    return left.shape == right.shape and all(rbpsym.equal(a, b, POSITIVE).is_proved for a, b in pairs)


def bodies(twin: Twin, frame: ReferenceFrame, rates: dict[Expr, Expr]) -> tuple[Point, list[RigidBody]]:
    """The bodies by hand, their velocities in the given speeds."""
    origin, found = Point("O"), []
    origin.set_vel(frame, 0)
    t = dynamicsymbols._t
    for number, body in enumerate(twin.bodies):
        center = origin.locatenew(f"C{number}", body.x * frame.x + body.y * frame.y)
        center.set_vel(frame, (body.x.diff(t) * frame.x + body.y.diff(t) * frame.y).subs(rates))
        own = frame.orientnew(f"B{number}", "Axis", (body.angle, frame.z))
        own.set_ang_vel(frame, sympify(body.angle).diff(t).subs(rates) * frame.z)
        found.append(RigidBody(f"b{number}", center, own, body.mass, (inertia(own, 0, 0, body.moment), center)))
    return origin, found


@pytest.mark.parametrize("name", NAMES)
def test_lagrange(name: str) -> None:
    twin, frame = SYSTEMS[name], ReferenceFrame("N")
    _, found = bodies(twin, frame, {})
    for each, body in zip(found, twin.bodies, strict=True):
        each.potential_energy = body.mass * g * body.y
    method = LagrangesMethod(Lagrangian(frame, *found) - twin.potential, twin.q)
    method.form_lagranges_equations()
    assert same(model(name).mass_matrix, method.mass_matrix)
    assert same(model(name).forcing, method.forcing)


@pytest.mark.parametrize("name", NAMES)
def test_kane(name: str) -> None:
    twin, frame, t = SYSTEMS[name], ReferenceFrame("N"), dynamicsymbols._t
    speeds = dynamicsymbols([f"u_{i}" for i in range(len(twin.q))])
    rates = {q.diff(t): u for q, u in zip(twin.q, speeds, strict=True)}
    origin, found = bodies(twin, frame, rates)
    loads = [(each.masscenter, -each.mass * g * frame.y) for each in found]
    for x, y, fx, fy in twin.forces:
        point = origin.locatenew("P", x * frame.x + y * frame.y)
        point.set_vel(frame, (x.diff(t) * frame.x + y.diff(t) * frame.y).subs(rates))
        loads.append((point, fx * frame.x + fy * frame.y))
    method = KanesMethod(frame, q_ind=twin.q, u_ind=speeds, kd_eqs=[u - q.diff(t) for q, u in zip(twin.q, speeds, strict=True)])
    method.kanes_equations(found, loads)
    back = {u: rate for rate, u in rates.items()}
    assert same(model(name).mass_matrix, method.mass_matrix.subs(back))
    assert same(model(name).forcing, method.forcing.subs(back))


@pytest.mark.parametrize("name", NAMES)
def test_our_rigid_bodies_in_their_methods(name: str) -> None:
    """sympy's kinetic energy of our bodies is ours; Lagrange's equations of them are ours."""
    ours = model(name)
    frame, _, found = ours.rigid_bodies()
    kinetic = sum(each.kinetic_energy(frame) for each in found)
    assert rbpsym.equal(kinetic, ours.kinetic_energy, POSITIVE).is_proved
    method = LagrangesMethod(ours.kinetic_energy - ours.potential_energy, SYSTEMS[name].q)
    method.form_lagranges_equations()
    assert same(ours.mass_matrix, method.mass_matrix) and same(ours.forcing, method.forcing)


@pytest.mark.parametrize("name", NAMES)
def test_accelerations_and_momenta(name: str) -> None:
    """The accelerations solve the equations; the rate of the angular momentum about O in sympy is that of the parts."""
    ours = model(name)
    if ours.accelerations is not None:
        found = Matrix(list(ours.accelerations.values()))
        assert same(ours.mass_matrix * found, ours.forcing)
    frame, origin, made = ours.rigid_bodies()
    for each in made:
        momentum = ours.angular_momentum("O", str(each.name))
        assert rbpsym.equal(each.angular_momentum(origin, frame).dot(frame.z), momentum.total, POSITIVE).is_proved
    assert Rational(0) == ours.angular_momentum().total - ours.angular_momentum().orbital - ours.angular_momentum().spin
