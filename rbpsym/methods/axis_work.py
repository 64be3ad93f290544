"""The work–energy theorem for rotation about a fixed axis: W_O = ∫ τ_O dφ = Δ(½ I_O ω²).

The torque about the axis does the whole work: it is W_T + W_θ and neither of them.
Kleppner & Kolenkow 7.4.
"""

from __future__ import annotations

from rbpsym.algebra import NOTHING, Scalar, at_start, derivative, is_zero, names_in, short
from rbpsym.derivation.chapters.inertia import moment_about, turning_together
from rbpsym.derivation.draft import Draft, length
from rbpsym.derivation.step import BodyRef, PhraseRef
from rbpsym.methods.balances import outer_forces
from rbpsym.methods.known_works import integral, started
from rbpsym.notation import tree as t

LONGEST = 60  # nodes of an integral that is simpler than two works


def write(draft: Draft) -> None:
    """A step for the first fixed axis about which the whole system turns, if its torque is known there.

    None where the centres of mass stay on the axis: then W_θ about them is the same.
    """
    names, states = draft.study.system.independent, draft.study.system.bodies.values()
    if len(names) != 1 or draft.study.system.has_clock or not any(state.velocity for state in states):
        return
    for label in draft.study.origins:
        if turning_together(draft, label) and _about(draft, label, names[0]):
            return


def _about(draft: Draft, label: str, name: str) -> bool:
    """Whether the torque about the axis depends on the place alone, so that the step was made."""
    bodies = tuple(draft.study.system.bodies)
    omega = draft.study.system.bodies[bodies[0]].omega
    origin = draft.study.origins[label]
    forces = outer_forces(draft.study.system, bodies)
    torque = short(sum((f.torque(origin) for f in forces), NOTHING))
    along = short(torque * derivative(omega, f"{name}_dot"))
    if not torque or names_in(along) & {*draft.study.system.unknowns, f"{name}_dot", "t"}:
        return False
    shown = integral(draft, name, along)
    if length(shown) > LONGEST:
        return False
    _add(draft, label, torque * omega, shown)
    return True


def _add(draft: Draft, label: str, power: Scalar, shown: t.Node) -> None:
    letter = t.Sym(draft.free(f"cal_W_theta_{label}"))
    draft.context.works[letter.name] = power
    bodies = tuple(draft.study.system.bodies)
    draft.add(
        f"axis.{label}",
        "work_energy",
        t.equation(letter, shown, _growth(draft, label)),
        "work.axis",
        premises=draft.those(*(f"moment.{b}.{label}" for b in bodies), f"moment.together.{label}", "theorem.whole"),
        point=t.Sym(label),
        bodies=PhraseRef("bodies", {"bodies": [BodyRef(b) for b in bodies], "count": len(bodies)}),
        count=len(bodies),
    )


def _growth(draft: Draft, label: str) -> t.Node:
    """½ I_O (ω² - ω₀²), from rest ½ I_O ω²; Δ(½ I_O ω²) where no start is said."""
    half, moment = t.Div(t.ONE, t.TWO), moment_about(draft, label)
    square = next(iter(draft.study.system.bodies.values())).omega ** 2
    if not started(draft):
        return t.Delta(t.Group(t.mul(half, moment, draft.show(square))))
    begun = at_start(square, draft.study.system.scope)
    grown = t.add(draft.show(square), t.neg(draft.show(begun))) if not is_zero(begun) else draft.show(square)
    return t.mul(half, moment, grown)
