"""What kinematics alone tells of a motion that is given: accelerations, angular accelerations, instantaneous centres."""

from __future__ import annotations

from rbpsym.expr import tree as t
from rbpsym.field import Vector, is_zero, tidy
from rbpsym.mechanics.system import BodyState
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import BodyRef

LONGEST = 100  # nodes of a formula that is read as a result


def write(draft: Draft) -> None:
    """The results for each body, as far as they are short enough to be read."""
    for name, state in draft.study.system.bodies.items():
        if not draft.study.system.independent:  # else an acceleration hangs on what is not stated
            _acceleration(draft, name, state)
            _spin_up(draft, name, state)
        _centre(draft, name, state)


def _acceleration(draft: Draft, name: str, state: BodyState) -> None:
    """The rate of the velocity."""
    vector, shown = t.Vec(draft.of_body("A", name)), draft.show_vector(state.acceleration, factor=True)
    if state.velocity and length(shown) <= LONGEST:
        pairs = [(tidy(getattr(state.velocity, axis)), tidy(getattr(state.acceleration, axis))) for axis in "xy"]
        statement = t.equation(vector, t.Deriv(t.Vec(draft.of_body("V", name))), shown)
        draft.add(f"acceleration.{name}", "differentiation", statement, "kinematics.acceleration",
                  premises=[f"velocity.{name}"], data={"pairs": pairs}, body=BodyRef(name), is_result=True)  # fmt: skip


def _spin_up(draft: Draft, name: str, state: BodyState) -> None:
    """The rate of the angular velocity."""
    alpha, shown = draft.define(draft.of_body("alpha", name), state.alpha), draft.show(state.alpha, factor=True)
    if state.omega and length(shown) <= LONGEST:
        statement = t.equation(alpha, t.Deriv(t.Sym(draft.of_body("omega", name))), shown)
        draft.add(f"angular_acceleration.{name}", "differentiation", statement, "kinematics.spin_up",
                  premises=[f"turning.{name}"], data={"pairs": [(state.omega, state.alpha)]}, body=BodyRef(name),
                  is_result=True)  # fmt: skip


def _centre(draft: Draft, name: str, state: BodyState) -> None:
    """The point of the plane of a body that has no velocity, where that moves: of a body on a pivot it is the pivot."""
    if state.pole is None:
        return
    vector, shown = draft.define_vector(draft.of_body("C", name), state.pole), draft.show_vector(state.pole)
    if not _rests(draft, state.pole) and length(shown) <= LONGEST:
        draft.add(f"centre.{name}", "identity", t.equation(vector, shown), "kinematics.centre",
                  premises=[f"position.{name}", f"velocity.{name}", f"turning.{name}"], body=BodyRef(name),
                  is_result=True)  # fmt: skip


def _rests(draft: Draft, place: Vector) -> bool:
    rate = place.rate(draft.study.system.scope.rates)
    return is_zero(rate.x) and is_zero(rate.y)
