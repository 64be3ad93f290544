"""Ten systems, each stated with sympy for rbpsym, and by hand as sympy.physics.mechanics wants them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Eq, Expr, Integer, Rational, Symbol, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rbpsym as rb

M, m, m_1, m_2, ell, a, R, r, g, k = symbols("M m m_1 m_2 ell a R r g k", positive=True)
beta = Symbol("beta", positive=True)
x_axis, y_axis = symbols("x y")
theta, phi, psi, s = dynamicsymbols("theta phi psi s")
HALF, THIRD, TWELFTH = Rational(1, 2), Rational(1, 3), Rational(1, 12)


@dataclass(frozen=True)
class Body:
    """Mass, moment of inertia about the centre of mass, its place, the angle that turns it."""

    mass: Expr
    moment: Expr
    x: Expr
    y: Expr
    angle: Expr


@dataclass(frozen=True)
class Twin:
    """A system: its sections for rbpsym; coordinates, bodies, and forces other than the weights (x, y, F_x, F_y), with
    their potential energy, for sympy."""

    sections: Mapping[str, Any]
    q: tuple[Expr, ...]
    bodies: tuple[Body, ...]
    forces: tuple[tuple[Expr, Expr, Expr, Expr], ...] = ()
    potential: Expr | int = 0


WEIGHT = {"W": rb.gravity(g)}
HANGS = theta - pi / 2  # of a rod's axis, theta from the downward vertical
LADDER = {"ladder": rb.rod(2 * ell, mass=M, center=(ell * cos(theta), ell * sin(theta)), angle=pi - theta)}
SMOOTH = {"N_w": rb.contact("ladder.end", Eq(x_axis, 0)), "N_f": rb.contact("ladder.start", Eq(y_axis, 0))}
ROD = {"rod": rb.rod(ell, mass=m, start="O", angle=HANGS)}
ON_ROD = Body(m, TWELFTH * m * ell**2, ell / 2 * sin(theta), -ell / 2 * cos(theta), theta)
LEANING = Body(M, THIRD * M * ell**2, ell * cos(theta), ell * sin(theta), -theta)
TIP = (ell * sin(theta), -ell * cos(theta))


def chain(*angles: Expr) -> tuple[dict[str, Any], dict[str, Any], tuple[Body, ...]]:
    """Rods of one length that hang from each other: bodies, constraints, and the same by hand."""
    rods, joints, bodies = {}, {"P_1": rb.pivot("rod_1.start", at=(0, 0))}, []
    x, y = Integer(0), Integer(0)
    for number, angle in enumerate(angles, 1):
        rods[f"rod_{number}"] = rb.rod(ell, mass=m, angle=angle - pi / 2)
        if number > 1:
            joints[f"P_{number}"] = rb.pin((f"rod_{number - 1}.end", f"rod_{number}.start"))
        half = (ell / 2 * sin(angle), -ell / 2 * cos(angle))
        bodies.append(Body(m, TWELFTH * m * ell**2, x + half[0], y + half[1], angle))
        x, y = x + 2 * half[0], y + 2 * half[1]
    return rods, joints, tuple(bodies)


DOUBLE, DOUBLE_JOINTS, DOUBLE_BODIES = chain(theta, phi)
TRIPLE, TRIPLE_JOINTS, TRIPLE_BODIES = chain(theta, phi, psi)

SYSTEMS: Mapping[str, Twin] = {
    "rod with fixed disk": Twin(
        {"coordinates": [theta], "interactions": WEIGHT,
         "bodies": {**ROD, "disk": rb.disk(R, mass=M, center=TIP, angle=theta)},
         "constraints": {"F": rb.pivot("rod.start"), "N": rb.weld(("rod.end", "disk.center"))}},
        (theta,), (ON_ROD, Body(M, HALF * M * R**2, *TIP, theta)),
    ),
    "rod with free disk": Twin(
        {"coordinates": [theta, phi], "interactions": WEIGHT,
         "bodies": {**ROD, "disk": rb.disk(R, mass=M, center=TIP, angle=phi)},
         "constraints": {"F": rb.pivot("rod.start"), "N": rb.pin(("rod.end", "disk.center"))}},
        (theta, phi), (ON_ROD, Body(M, HALF * M * R**2, *TIP, phi)),
    ),
    "ladder": Twin({"coordinates": [theta], "interactions": WEIGHT, "bodies": LADDER, "constraints": SMOOTH},
                   (theta,), (LEANING,)),
    "ladder with spring": Twin(
        {"coordinates": [theta], "bodies": LADDER, "constraints": SMOOTH,
         "interactions": {**WEIGHT, "S": rb.spring(("ladder.start", "O"), k)}},
        (theta,), (LEANING,), ((2 * ell * cos(theta), Integer(0), -2 * k * ell * cos(theta), Integer(0)),),
        HALF * k * (2 * ell * cos(theta)) ** 2,
    ),
    "double pendulum": Twin({"coordinates": [theta, phi], "interactions": WEIGHT, "bodies": DOUBLE,
                             "constraints": DOUBLE_JOINTS}, (theta, phi), DOUBLE_BODIES),
    "disk rolling on an incline": Twin(
        {"coordinates": [s], "interactions": WEIGHT, "assumptions": [beta < pi / 2],
         "bodies": {"disk": rb.disk(R, mass=M, angle=-s / R,
                                    center=(s * cos(beta) + R * sin(beta), -s * sin(beta) + R * cos(beta)))},
         "constraints": {"N": rb.rolling("disk", Eq(y_axis * cos(beta), -x_axis * sin(beta)))}},
        (s,), (Body(M, HALF * M * R**2, s * cos(beta), -s * sin(beta), -s / R),),
    ),
    "cart and rod": Twin(
        {"coordinates": [s, theta], "interactions": WEIGHT,
         "bodies": {"cart": rb.rectangle(a, r, mass=M, center=(s, 0), angle=0), "rod": rb.rod(ell, mass=m, angle=HANGS)},
         "constraints": {"N": rb.slider("cart.center", Eq(y_axis, 0)), "P": rb.pin(("cart.center", "rod.start"))}},
        (s, theta),
        (Body(M, M * (a**2 + r**2) / 12, s, Integer(0), Integer(0)), Body(m, ON_ROD.moment, s + ON_ROD.x, ON_ROD.y, theta)),
    ),
    "Atwood's machine": Twin(
        {"coordinates": [s], "interactions": WEIGHT,
         "bodies": {"left": rb.particle(mass=m_1, center=(-R, -s)), "right": rb.particle(mass=m_2, center=(R, -a + s)),
                    "pulley": rb.disk(R, mass=M, center=(0, 0), angle=s / R)},
         "constraints": {"F": rb.pivot("pulley.center"),
                         "T": rb.string(("left.center", "cw pulley", "right.center"))}},
        (s,), (Body(m_1, Integer(0), -R, -s, Integer(0)), Body(m_2, Integer(0), R, s - a, Integer(0)),
               Body(M, HALF * M * R**2, Integer(0), Integer(0), s / R)),
    ),
    "bead on a rod": Twin(
        {"coordinates": [theta, s], "interactions": WEIGHT,
         "bodies": {**ROD, "bead": rb.particle(mass=M, center=(s * sin(theta), -s * cos(theta)))},
         "constraints": {"F": rb.pivot("rod.start"), "N": rb.guide("bead.center", line=Eq(y_axis, 0), of="rod")}},
        (theta, s), (ON_ROD, Body(M, Integer(0), s * sin(theta), -s * cos(theta), Integer(0))),
    ),
    "chain of three rods": Twin({"coordinates": [theta, phi, psi], "interactions": WEIGHT, "bodies": TRIPLE,
                                 "constraints": TRIPLE_JOINTS}, (theta, phi, psi), TRIPLE_BODIES),
}  # fmt: skip
