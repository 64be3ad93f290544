"""What the conditions of the constraints determine: angular velocities, coordinates, or only speeds."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.given import Given
from rbpsym.derivation.step import BodyRef
from rbpsym.notation import tree as t


def found_spins(draft: Draft, given: Given) -> None:
    """The angular velocity of bodies whose angle was left to rolling or to a string."""
    for name in draft.study.problem.body_names:
        state = draft.study.system.bodies[name]
        premises = [s.id for s in draft.steps if s.rule in ("no_slip", "taut")]
        if name in given.unturned and state.omega and premises:
            omega = draft.define(draft.of_body("omega", name), state.omega)
            draft.add(
                f"turning.{name}",
                "tied",
                t.equation(omega, draft.show(state.omega)),
                "kinematics.turning.found",
                premises=premises,
                body=BodyRef(name),
                data={"pairs": [(state.pose.angle, state.omega)]},
            )


def tied(draft: Draft) -> None:
    """Coordinates, or only speeds, in terms of the free ones."""
    system = draft.study.system
    shown = {name for step in draft.steps if step.rule == "constraint" for name in _solved_already(step.statement)}
    premises = [s.id for s in draft.steps if s.rule in ("constraint", "no_slip", "taut")]
    for name, value in system.dependent.items():
        statement = t.equation(t.Sym(name), draft.show(value))
        if name not in shown:
            draft.add(
                f"dependent.{name}",
                "tied",
                statement,
                "kinematics.dependent",
                premises=premises,
                coordinate=t.Sym(name),
                variant="rate" if _from_rate(draft, name) else "place",
            )
    for name in system.coordinates:
        if name not in system.independent:
            draft.add(
                f"tied_speed.{name}",
                "tied",
                t.equation(t.Sym(f"{name}_dot"), draft.show(system.scope.rates[name], factor=True)),
                "kinematics.tied_speed",
                premises=premises,
                coordinate=t.Sym(name),
            )


def _solved_already(statement: t.Node) -> list[str]:
    """Names that stand alone on the left of a condition, and not on the right of it."""
    rows = statement.rows if isinstance(statement, t.System) else (statement,)
    pairs = [(row.items[0], row.items[-1]) for row in rows]
    return [left.name for left, right in pairs if isinstance(left, t.Sym) and left.name not in t.names(right)]


def _from_rate(draft: Draft, name: str) -> bool:
    """Was it found by integrating a condition on the speeds?"""
    kinds = {"rolling", "gear", "sticking", "string"}
    named = {c.constraint for c in draft.study.system.conditions if depends_on(c.value, name) and c.what in kinds}
    return bool(named)
