"""The general theory of plane motion, for any rigid body known by its mass moments alone.

∫dm = M, ∫dm r = 0, ∫dm r² = I_cm; r is counted from the centre of mass and turns with the body.
Every step is decided twice: by expanding the integrand in those moments, and for a rigid set of
three particles of arbitrary masses and places. Kleppner & Kolenkow 7.1-7.4; the paper, sec. II.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from rbpsym.chapters import theory_ground as ground
from rbpsym.chapters.theory_works import ideal_forces, potential_energy, works
from rbpsym.decide.verdict import Verdict
from rbpsym.expr import tree as t
from rbpsym.field import Space
from rbpsym.proof.assertions import told
from rbpsym.proof.checks import of_steps as c
from rbpsym.proof.step import Certificate, Lesson, Step, StepRef


def _identity(context: Any, step: Step) -> Verdict:
    particles: Any = ground.particle_context(context)
    return c.weakest([c.identity(context, step), c.identity(particles, step)])


def _rates(context: Any, step: Step) -> Verdict:
    particles: Any = ground.particle_context(context)
    return c.weakest([c.rates(context, step), c.rates(particles, step)])


RULES = {"theory_identity": _identity, "theory_rates": _rates}


class TheoryWriter:
    """Collects the steps of the theory."""

    def __init__(self) -> None:
        self.steps: list[Step] = []
        self.context = ground.TheoryContext()

    def add(
        self,
        id: str,
        statement: t.Node,
        rule: str = "theory_identity",
        premises: Iterable[str] = (),
        fixed: bool = False,
        is_result: bool = False,
        context: ground.TheoryContext | None = None,
        where: t.Node | None = None,
    ) -> None:
        """Adds a checked step; `fixed`: the body turns about a fixed point, V = ω × R.

        `context`: what the names mean, if it is not what they mean for any body; `where`: what the text takes for granted here.
        """
        context = context or (replace(self.context, **_about_fixed_axis()) if fixed else self.context)
        step = Step(
            id,
            rule,
            statement,
            "theory",
            f"theory.{id}",
            {"sources": [StepRef(p) for p in premises]},
            tuple(premises),
            is_result=is_result,
            data={} if where is None else {"where": where},
        )
        verdict = c.guarded(lambda: RULES[rule](context, step))
        self.steps.append(told(replace(step, certificate=Certificate((rule, "by_particles"), verdict))))


def _about_fixed_axis() -> dict[str, Any]:
    """The meanings that change when the origin is a fixed point of the body: V = ω × R, A = dV/dt."""
    velocity = Space(z=ground.OMEGA).cross(ground.R)
    acceleration = Space(z=ground.ALPHA).cross(ground.R) + Space(z=ground.OMEGA).cross(velocity)
    momentum, push = velocity * ground.MASS, acceleration * ground.MASS
    vectors = {
        **ground.VECTORS,
        "V_cm": velocity,
        "A_cm": acceleration,
        "P_cm": momentum,
        "F_net": push,
        "L": ground.R.cross(momentum) + Space(z=ground.MOMENT * ground.OMEGA),
        "tau_net": ground.R.cross(push) + Space(z=ground.MOMENT * ground.ALPHA),
    }
    whole = push.dot(velocity) + ground.MOMENT * ground.ALPHA * ground.OMEGA
    works = {**ground.POWERS, "cal_W_T": push.dot(velocity), "cal_W": whole, "cal_W_theta_O": vectors["tau_net"].z * ground.OMEGA}
    energy = (ground.MASS * velocity.dot(velocity) + ground.MOMENT * ground.OMEGA * ground.OMEGA) / 2
    rates = {**ground.RATES, **ground.turning("X", "Y")}
    return {"vectors": vectors, "works": works, "scalars": {**ground.SCALARS, "E_K": energy}, "rates": rates}


def _half(*factors: t.Node) -> t.Node:
    return t.mul(t.Div(t.ONE, t.TWO), *factors)


def _square(node: t.Node) -> t.Node:
    return t.Pow(node, t.TWO)


def plane_motion() -> Lesson:
    """The lesson: rigidity, momentum, torque, energy, fixed axis, works, ideal constraints."""
    w = TheoryWriter()
    for chapter in (_rigidity, _momentum, _torque, _energy, _fixed_axis, works, potential_energy, ideal_forces):
        chapter(w)
    return Lesson("theory", "plane-motion", tuple(w.steps))


def _rigidity(w: TheoryWriter) -> None:
    arm, omega = t.Vec("r"), t.Vec("omega")
    turn = t.Cross(omega, arm)
    p, q, op, oq = t.Vec("r_p"), t.Vec("r_q"), t.Vec("omega_p"), t.Vec("omega_q")
    together = replace(w.context, rates={**ground.RATES, **ground.turning("p_x", "p_y"), **ground.turning("q_x", "q_y")})
    distance = t.Abs(t.Add((p, t.Neg(q))))
    begun = t.equation(t.Sym("C_p_q"), t.At(distance, ground.AT_START))
    w.add("distance", t.equation(distance, t.Sym("C_p_q")), "theory_rates", context=together, where=begun)
    w.add(
        "rigid",
        t.equation(t.Deriv(t.Group(_square(arm))), t.mul(t.TWO, t.Dot(arm, t.Deriv(arm))), t.ZERO),
        premises=["distance"],
    )
    w.add("turning", t.equation(t.Deriv(arm), turn), premises=["rigid"], is_result=True)
    apart = t.Group(t.Add((p, t.Neg(q))))
    both = t.Group(t.Add((t.Cross(op, p), t.Neg(t.Cross(oq, q)))))
    w.add(
        "one_omega",
        t.equation(t.Dot(apart, both), t.Dot(t.Group(t.Add((oq, t.Neg(op)))), t.Cross(p, q))),
        premises=["distance", "turning"],
    )
    w.add(
        "velocity",
        t.equation(t.Vec("v_prime"), t.Deriv(t.Group(t.Add((arm, t.Vec("R_cm"))))), t.Add((t.Vec("V_cm"), turn))),
        premises=["turning"],
        where=t.Relations(tuple(t.equation(t.Vec(name), t.Add((t.Vec("R_cm"), arm))) for name in ("r_prime", "r_i"))),
    )


def _momentum(w: TheoryWriter) -> None:
    arm, omega = t.Vec("r"), t.Vec("omega")
    of = ((t.ONE, t.Sym("M")), (arm, t.ZERO), (_square(arm), t.Sym("I_cm")))
    moments = t.Relations(tuple(t.equation(t.BodyIntegral(integrand), moment) for integrand, moment in of))
    w.add("moments", moments, where=moments)
    w.add(
        "linear",
        t.equation(t.BodyIntegral(t.Vec("v_prime")), t.mul(t.Sym("M"), t.Vec("V_cm")), t.Vec("P_cm")),
        premises=["velocity", "moments"],
        where=t.equation(t.Vec("P_cm"), t.mul(t.Sym("M"), t.Vec("V_cm"))),
    )
    place = t.Group(t.Add((arm, t.Vec("R_cm"))))
    split = t.Add((t.Cross(t.Vec("R_cm"), t.Vec("P_cm")), t.mul(t.Sym("I_cm"), omega)))
    w.add(
        "angular_momentum",
        t.equation(
            t.Vec("L"),
            t.BodyIntegral(t.Cross(t.Vec("r_prime"), t.Deriv(t.Vec("p_prime"), "m"))),
            t.BodyIntegral(t.Cross(place, t.Deriv(place))),
            split,
        ),
        premises=["velocity", "moments", "linear"],
        is_result=True,
    )


def _torque(w: TheoryWriter) -> None:
    w.add("newton", t.equation(t.Vec("F_net"), t.Deriv(t.Vec("P_cm")), t.mul(t.Sym("M"), t.Vec("A_cm"))), premises=["linear"])
    arm = t.Vec("R_cm")
    w.add(
        "torque",
        t.equation(
            t.Vec("tau_net"),
            t.Deriv(t.Vec("L")),
            t.Add((t.Cross(arm, t.Vec("F_net")), t.mul(t.Sym("I_cm"), t.Vec("alpha")))),
        ),
        premises=["linear", "angular_momentum", "newton"],
        is_result=True,
    )
    place = t.Group(t.Add((arm, t.Vec("s"))))
    w.add(
        "torque_split",
        t.equation(t.Cross(place, t.Vec("F")), t.Add((t.Cross(arm, t.Vec("F")), t.Cross(t.Vec("s"), t.Vec("F"))))),
    )
    w.add(
        "torque_sum",
        t.equation(
            t.Vec("tau_net"),
            t.BodyIntegral(t.Cross(t.Vec("r_prime"), t.Deriv(t.Vec("F_ext"), "m"))),
            t.Add((t.Vec("tau_cm"), t.Cross(arm, t.Vec("F_net")))),
        ),
        premises=["velocity", "torque_split"],
        where=ground.forces(),
    )
    w.add(
        "euler",
        t.equation(
            t.Vec("tau_cm"),
            t.Add((t.Vec("tau_net"), t.Neg(t.Cross(arm, t.Vec("F_net"))))),
            t.mul(t.Sym("I_cm"), t.Vec("alpha")),
        ),
        premises=["torque", "torque_sum"],
        is_result=True,
    )


def _energy(w: TheoryWriter) -> None:
    speed = t.Add((t.Vec("V_cm"), t.Cross(t.Vec("omega"), t.Vec("r"))))
    parts = t.Add((_half(t.Sym("M"), _square(t.Vec("V_cm"))), _half(t.Sym("I_cm"), _square(t.Vec("omega")))))
    w.add(
        "energy",
        t.equation(
            t.Sym("E_K"),
            _half(t.BodyIntegral(_square(t.Vec("v_prime")))),
            _half(t.BodyIntegral(_square(t.Group(speed)))),
            parts,
        ),
        premises=["velocity", "moments"],
        is_result=True,
    )


def _fixed_axis(w: TheoryWriter) -> None:
    arm, omega = t.Vec("R_cm"), t.Vec("omega")
    fixed = t.equation(t.Deriv(arm), t.Cross(omega, arm))
    w.add("fixed_velocity", t.equation(t.Vec("V_cm"), t.Cross(omega, arm)), fixed=True, premises=["turning"], where=fixed)
    about = t.Add((t.Sym("I_cm"), t.mul(t.Sym("M"), _square(arm))))
    w.add(
        "steiner",
        t.equation(t.Sym("I_O"), t.BodyIntegral(_square(t.Vec("r_prime"))), about),
        premises=["velocity", "moments"],
        is_result=True,
    )
    w.add(
        "fixed_momentum",
        t.equation(
            t.Vec("L"),
            t.Add((t.Cross(arm, t.Group(t.mul(t.Sym("M"), t.Cross(omega, arm)))), t.mul(t.Sym("I_cm"), omega))),
            t.mul(t.Sym("I_O"), omega),
        ),
        fixed=True,
        premises=["linear", "angular_momentum", "fixed_velocity", "steiner"],
    )
    w.add(
        "fixed_torque",
        t.equation(t.Vec("tau_net"), t.mul(t.Sym("I_O"), t.Vec("alpha"))),
        fixed=True,
        premises=["torque", "fixed_momentum", "fixed_velocity", "steiner", "linear"],
        is_result=True,
    )


THEORIES = {"plane-motion": plane_motion}
