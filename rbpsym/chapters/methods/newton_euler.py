"""Newton's and Euler's equations of each body, solved for all accelerations and unknown forces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rbpsym.chapters.forces import force_node, torque_node
from rbpsym.chapters.methods import statics
from rbpsym.expr import tree as t
from rbpsym.field import EX, EY, Scalar, Vector, is_zero, short, tidy
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.system import Force
from rbpsym.present.signs import positive_first
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD, BodyRef, Step, StepRef

NAME = "newton-euler"
EACH_BODY = ("newton_euler.body", "newton_euler.along")  # phrases of the equations of a body
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
    """F = M a in two directions and τ_cm = I α of one body."""
    state, rows = draft.study.system.bodies[name], []
    forces = draft.study.system.on(name)
    slanted = _slanted(forces)
    for way in (EX, EY) if slanted is None else (slanted[1], slanted[1].turned()):
        left = draft.show(tidy(state.mass * way.dot(state.acceleration)))
        if slanted and t.is_negative(left):
            way, left = -way, left.arg if isinstance(left, t.Neg) else draft.show(tidy(-state.mass * way.dot(state.acceleration)))
        parts = (tidy(way.dot(f.vector)) for f in forces)
        pushes = [draft.show(part) for part in parts if part]
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
        EACH_BODY[bool(slanted)],
        body=BodyRef(name),
        way=force_node(draft, slanted[0]) if slanted else t.Vec(name),
        level=level,
        forces=[force_node(draft, f) for f in forces],
        premises=[f"force.{f.name}.{f.on}" for f in forces],
    )


def _slanted(forces: Iterable[Force]) -> tuple[Force, Vector] | None:
    """The first unknown force with its direction, where that is neither level nor upright and all the others are along it or
    across it: then each equation holds unknown forces of one direction."""
    ways = [(f, f.vector.derivative(name)) for f in forces for name in f.unknowns]
    ways = [(f, way) for f, way in ways if way]
    if not ways or not (way := ways[0][1]).x or not way.y or not is_zero(way.dot(way) - 1):
        return None
    alike = all(is_zero(way.dot(other)) or is_zero(way.cross(other)) for _, other in ways)
    return ways[0] if alike else None


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
