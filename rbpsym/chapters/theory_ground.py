"""An arbitrary rigid body by its mass moments: names, values, rates, and the two ways to integrate over it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.decide.assumptions import Assumptions
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Meanings, Poly, Scalar, Space, Value, atoms, cartesian, rate, space_derivative, symbol, value
from rbpsym.field.calculus import substitute
from rbpsym.frozen import field, replace
from rbpsym.proof.context import BareGround

XI, ETA = symbol("xi"), symbol("eta")
OMEGA, ALPHA, MASS, MOMENT = symbol("omega"), symbol("alpha"), symbol("M"), symbol("I_cm")


def _moving(name: str, orders: int = 2) -> dict[str, Scalar]:
    """Rates of a coordinate and of its speed."""
    steps = [name, f"{name}_dot", f"{name}_ddot"][: orders + 1]
    return {a: symbol(b) for a, b in zip(steps, steps[1:], strict=False)}


def turning(x: str, y: str, speed: Scalar = OMEGA) -> dict[str, Scalar]:
    """Rates of the components of a vector that is fixed in the body: ω × r."""
    return {x: -(speed * symbol(y)), y: speed * symbol(x)}


RATES: Mapping[str, Scalar] = {
    **_moving("X"),
    **_moving("Y"),
    "omega": ALPHA,
    "varphi": OMEGA,
    **turning("xi", "eta"),
    **turning("s_x", "s_y"),
    **turning("p_x", "p_y", symbol("omega_p")),
    **turning("q_x", "q_y", symbol("omega_q")),
}


def plane_vector(x: str, y: str) -> Space:
    """The vector with the components of these names."""
    return Space(cartesian(symbol(x), symbol(y)))


def speed_of(vector: Space) -> Space:
    """d/dt of a vector."""
    return space_derivative(vector, Meanings(rates=RATES))


R, r, s = plane_vector("X", "Y"), plane_vector("xi", "eta"), plane_vector("s_x", "s_y")
V, v = speed_of(R), speed_of(r)
A = speed_of(V)
F = plane_vector("F_x", "F_y")
f = plane_vector("f_x", "f_y")  # force per mass on an element of the body, or one of the forces

VECTORS: Mapping[str, Space] = {
    "R_cm": R,
    "r": r,
    "r_prime": R + r,
    "V_cm": V,
    "v": v,
    "v_prime": V + v,
    "A_cm": A,
    "s": s,
    "varphi": Space(z=symbol("varphi")),
    "omega": Space(z=OMEGA),
    "alpha": Space(z=ALPHA),
    "P_cm": V * MASS,
    "F": F,
    "F_net": A * MASS,
    "F_ext_i": f,
    "r_i": R + r,
    "L": R.cross(V * MASS) + Space(z=MOMENT * OMEGA),
    "tau_cm": Space(z=MOMENT * ALPHA),
    "tau_net": R.cross(A * MASS) + Space(z=MOMENT * ALPHA),
    "r_p": plane_vector("p_x", "p_y"),
    "r_q": plane_vector("q_x", "q_y"),
    "omega_p": Space(z=symbol("omega_p")),
    "omega_q": Space(z=symbol("omega_q")),
}
DENSITIES: Mapping[str, Space] = {"p_prime": V + v, "F_ext": f}
SCALARS: Mapping[str, Scalar] = {
    "E_K": (MASS * V.dot(V) + MOMENT * OMEGA * OMEGA) / 2,
    "I_O": MOMENT + MASS * R.dot(R),
    "tau_cm": MOMENT * ALPHA,
    "varphi_B": symbol("varphi"),  # the change is taken from A, the start, to B, where the body is now
}
POWERS: Mapping[str, Scalar] = {
    "cal_W_T": (A * MASS).dot(V),
    "cal_W_theta": MOMENT * ALPHA * OMEGA,
    "cal_W": (A * MASS).dot(V) + MOMENT * ALPHA * OMEGA,
    "cal_w": F.dot(V + speed_of(s)),
    "cal_w_T": F.dot(V),
    "cal_w_theta": s.cross(F).z * OMEGA,
}
# ∫ ξ^a η^b f_x^c f_y^d dm by (a, b, c, d): the mass, and the forces, which add up to F_net and τ_cm.
MOMENTS: Mapping[tuple[int, ...], Scalar] = {
    (0, 0, 0, 0): MASS,
    (1, 0, 0, 0): NOTHING,
    (0, 1, 0, 0): NOTHING,
    (2, 0, 0, 0): symbol("m_xx"),
    (1, 1, 0, 0): symbol("m_xy"),
    (0, 2, 0, 0): MOMENT - symbol("m_xx"),
    (0, 0, 1, 0): (A * MASS).plane.x,
    (0, 0, 0, 1): (A * MASS).plane.y,
    (1, 0, 0, 1): symbol("f_xy"),
    (0, 1, 1, 0): symbol("f_xy") - MOMENT * ALPHA,
}


def by_moments(integrand: Scalar, body: str = "") -> Scalar:
    """∫ f dm of a polynomial f in r, from the moments of the mass and of the forces."""
    return _over(integrand.num, ("xi", "eta", "f_x", "f_y"), ())


def by_particles(integrand: Scalar, body: str = "") -> Scalar:
    """Σ mᵢ f(rᵢ) over three particles whose centre of mass is at r = 0."""
    total = NOTHING
    for (mass, x, y), force in zip(PARTICLES, FORCES, strict=True):
        per_mass = {"f_x": force.plane.x / mass, "f_y": force.plane.y / mass}
        total = total + mass * substitute(integrand, {"xi": x, "eta": y, **per_mass})
    return total


def _over(poly: Poly, names: tuple[str, ...], powers: tuple[int, ...]) -> Scalar:
    if not names:
        return Scalar(poly) * MOMENTS[powers]
    parts = poly.by_power(atoms.intern("symbol", names[0]))
    return sum((_over(part, names[1:], (*powers, power)) for power, part in parts.items()), NOTHING)


def _particles() -> tuple[tuple[Scalar, Scalar, Scalar], ...]:
    m = [symbol(f"m_{k}") for k in (1, 2, 3)]
    x, y = ([symbol(f"{axis}_{k}") for k in (1, 2)] for axis in "xy")
    last_x, last_y = (-(m[0] * p[0] + m[1] * p[1]) / m[2] for p in (x, y))
    return ((m[0], x[0], y[0]), (m[1], x[1], y[1]), (m[2], last_x, last_y))


def _forces() -> tuple[Space, ...]:
    """Any forces on the three particles that add up to M A and have the torque I α about r = 0."""
    (m1, x1, y1), (m2, x2, y2), (m3, x3, y3) = PARTICLES
    net = A * (m1 + m2 + m3)
    moment = m1 * (x1 * x1 + y1 * y1) + m2 * (x2 * x2 + y2 * y2) + m3 * (x3 * x3 + y3 * y3)
    first, push = plane_vector("f_1x", "f_1y"), symbol("f_2x")
    arms = [Space(cartesian(x - x3, y - y3)) for x, y in ((x1, y1), (x2, y2))]
    left = moment * ALPHA - Space(cartesian(x3, y3)).cross(net).z - arms[0].cross(first).z + arms[1].plane.y * push
    second = Space(cartesian(push, left / arms[1].plane.x))
    return first, second, net - first - second


PARTICLES = _particles()
FORCES = _forces()


class TheoryContext(BareGround):
    """The same questions as `Context`, asked of an arbitrary body."""

    body: Callable[..., Scalar] = by_moments
    images: Mapping[str, Scalar] = field(default_factory=dict)
    assumptions: Assumptions = field(default_factory=lambda: Assumptions({"M": "positive", "I_cm": "positive"}))
    scalars: Mapping[str, Scalar] = field(default_factory=lambda: dict(SCALARS))
    works: Mapping[str, Scalar] = field(default_factory=lambda: dict(POWERS))
    vectors: Mapping[str, Space] = field(default_factory=lambda: dict(VECTORS))
    rates: Mapping[str, Scalar] = field(default_factory=lambda: dict(RATES))

    @property
    def scope(self) -> Meanings:
        """The scope of the theory."""
        return Meanings(
            self.scalars,
            self.vectors,
            self.rates,
            {},
            self.body,
            self.works,
            DENSITIES,
            lambda rate: self.body(rate, ""),
        )

    def value(self, node: t.Node) -> Value:
        """The value of a tree."""
        found = value(node, self.scope)
        if isinstance(found, Space):
            return Space(found.plane.substitute(self.images), substitute(found.z, self.images))
        return substitute(found, self.images)

    def rate(self, node: t.Node) -> Scalar:
        """d/dt of a tree with integrals along the motion."""
        return substitute(rate(node, self.scope), self.images)

    def start(self, found: Scalar) -> Scalar:
        """All changes are counted from the start."""
        return NOTHING


def particle_context(context: TheoryContext) -> TheoryContext:
    """Mass and moment of inertia are those of the three particles."""
    mass = sum((m for m, _, _ in PARTICLES), NOTHING)
    moment = sum((m * (x * x + y * y) for m, x, y in PARTICLES), NOTHING)
    return replace(context, body=by_particles, images={"M": mass, "I_cm": moment})


AT_START = t.equation(t.Sym("t"), t.ZERO)


def forces() -> t.Relations:
    """The net force and the torques, added up over the particles."""
    push = t.Deriv(t.Vec("F_ext"), "m")
    of = (("F_net", push), ("tau_cm", t.Cross(t.Vec("r"), push)), ("tau_net", t.Cross(t.Vec("r_prime"), push)))
    return t.Relations(tuple(t.equation(t.Vec(name), t.BodyIntegral(integrand)) for name, integrand in of))
