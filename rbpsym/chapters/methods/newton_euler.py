"""Newton's and Euler's equations of each body, solved for all accelerations and unknown forces."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.chapters.forces import force_node, torque_node
from rbpsym.chapters.methods import statics
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, short, tidy
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.present.signs import positive_first
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD, BodyRef, Step, StepRef

NAME = "newton-euler"
LONGEST = 150  # nodes of a force that is worth showing in standard detail
LARGEST = 8  # bodies times degrees of freedom: beyond this the elimination grows too large


def write(draft: Draft) -> Mapping[str, Scalar] | None:
    """The steps; returns the accelerations found by eliminating all forces from all bodies' equations."""
    draft.chapter = "reactions"
    chosen = statics.write(draft)
    steps = [_equations(draft, name, FULL if chosen else STANDARD) for name in draft.study.system.bodies]
    _reactions(draft, chosen, [step for step in steps if step is not None])
    return _accelerations(draft)


def _equations(draft: Draft, name: str, level: int) -> Step | None:
    """F_x = M a_x, F_y = M a_y, τ_cm = I α of one body."""
    state, rows = draft.study.system.bodies[name], []
    forces = draft.study.system.on(name)
    for axis in ("x", "y"):
        pushes = [draft.show(tidy(getattr(f.vector, axis))) for f in forces if getattr(f.vector, axis)]
        left = draft.show(tidy(state.mass * getattr(state.acceleration, axis)))
        if pushes or left != t.ZERO:
            push = t.add(*positive_first(pushes))
            rows.append(t.equation(left, push) if left != t.ZERO else t.equation(push, t.ZERO))
    turns = [short(torque_about_center(f, state)) for f in forces]
    if any(turns) or state.moment * state.alpha:
        shown = [torque_node(draft, f, state.center) for f, v in zip(forces, turns, strict=True) if v]
        spin = draft.show(state.moment * state.alpha)
        turn = t.add(*positive_first(shown))
        rows.append(t.equation(spin, turn) if spin != t.ZERO else t.equation(turn, t.ZERO))
    if not rows:
        return None
    return draft.add(
        f"free_body.{name}",
        "balance",
        t.system(rows),
        "newton_euler.body",
        body=BodyRef(name),
        level=level,
        forces=[force_node(draft, f) for f in forces],
        premises=[f"force.{f.name}.{f.on}" for f in forces],
    )


def _reactions(draft: Draft, chosen: list[Step], bodies: list[Step]) -> None:
    """Each unknown force as a function of position and speed; at rest from the balances that were chosen, if any were."""
    steps = chosen or bodies
    values = draft.study.dynamics.reactions
    if not values:
        return
    motion = draft.those(*(f"motion.{name}" for name in draft.study.system.independent))
    premises = [*(step.id for step in steps), *motion]
    for name, value in values.items():
        shown = draft.show(value)
        draft.add(
            f"reaction.{name}",
            "solution",
            t.equation(t.Sym(name), shown),
            "newton_euler.settled" if chosen else "newton_euler.reaction",
            premises=premises,
            force=t.Sym(name),
            is_result=not draft.study.system.independent,  # where nothing is free, the forces are what was asked for
            level=FULL if draft.study.squares or length(shown) > LONGEST else STANDARD,
            sources=[StepRef(s.id) for s in steps],
        )


def _accelerations(draft: Draft) -> Mapping[str, Scalar] | None:
    """Forces and accelerations eliminated together, without the projection."""
    system = draft.study.system
    if len(system.bodies) * len(system.independent) > LARGEST:
        draft.skip(NAME, "skipped.newton_euler", count=len(system.bodies))
        return None
    unknowns = (*system.unknowns, *system.accelerations)
    solution = solve_linear(draft.study.newton_euler_rows, unknowns)
    if any(name not in solution.values for name in system.accelerations):
        draft.skip(NAME, "skipped.newton_euler", count=len(system.bodies))
        return None
    found = {name: solution.values[name] for name in system.accelerations}
    for name, value in found.items():
        draft.add(
            f"motion.from_newton.{name.removesuffix('_ddot')}",
            "solution",
            t.equation(t.Sym(name), draft.show(value, factor=True)),
            "newton_euler.motion",
            premises=[f"free_body.{body}" for body in system.bodies],
            level=FULL,
            acceleration=t.Sym(name),
            count=len(found),
        )
    return found
