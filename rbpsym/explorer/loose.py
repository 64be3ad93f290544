"""The system of free bodies as JavaScript: what is needed to solve for accelerations and forces, whatever holds just now."""

from __future__ import annotations

from typing import Any

from rbpsym.errors import LimitError, NotApplicable, StatementError
from rbpsym.explorer.javascript import Program, function
from rbpsym.explorer.stage import ARGUMENTS, StagePhase, seen
from rbpsym.field import Scalar, time_derivative
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.elimination import CONSTANT, linear_row
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.placing import open_name
from rbpsym.mechanics.released import AXES, released
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element


def loose(study: Study, names: tuple[str, ...], ground: tuple[Element, ...] = ()) -> StagePhase | None:
    """The free system; None where it cannot be told without the coordinates of the statement.

    `look` takes places, speeds, accelerations and unknown forces as its state. `balance` gives, in places and speeds, the
    coefficients of `rows` and `conditions`: columns with places, and the place of the rest, linear in accelerations and forces.
    """
    try:
        system = released(study.system)
        state = (*system.coordinates, *system.speeds)
        inputs = {name: f"p[{k}]" for k, name in enumerate(names)} | {"t": "t"}
        balance = Program(inputs | {name: f"x[{k}]" for k, name in enumerate(state)}, system.tied())
        told = enumerate((*state, *system.accelerations, *system.unknowns))
        look = Program(inputs | {name: f"x[{k}]" for k, name in told}, system.tied())
        data = seen(study.of(system), look, system.dependent, elsewhere=ground) | {"loose": _balance(system, balance)}
    except (LimitError, NotApplicable, StatementError):
        return None
    data |= {"endsWith": [], "endsAt": None, "strikes": None, "nudge": None}
    return StagePhase({"look": function(ARGUMENTS, look.text), "balance": function(ARGUMENTS, balance.text)}, data)


def _balance(system: System, program: Program) -> dict[str, Any]:
    """Where what stands: `places` [body, axis] of the coordinates; `forces` the unknown ones, in the order of their columns."""
    wanted, bodies = (*system.accelerations, *system.unknowns), list(system.bodies)
    couples = {name for force in system.forces if force.couple for name in force.unknowns}
    turning = {body for body in bodies if open_name(body, "angle") in system.coordinates}

    def row(value: Scalar) -> dict[str, Any]:
        found = linear_row(value, wanted)
        cells = [[k, program.output_again(found[name])] for k, name in enumerate(wanted) if name in found]
        return {"cells": cells, "rest": program.output_again(found[CONSTANT])}

    conditions = []
    for condition, is_place in [*((c, True) for c in system.implicit), *((c, False) for c in system.speed_ties)]:
        rate = time_derivative(condition.value, system.scope) if is_place else condition.value
        gap = program.output_again(condition.value) if is_place else None
        second = row(time_derivative(rate, system.scope))
        told = {"of": condition.constraint, "turns": condition.what == "angle", "gap": gap, "rate": program.output_again(rate)}
        conditions.append(told | second)
    forces = []
    for name, owner in {n: system.element(force.name) for force in system.forces for n in force.unknowns}.items():
        forces.append({"name": name, "of": owner.name, "turns": name in couples, "pushes": name in pushes(owner)})
    return {
        "places": [[bodies.index(body), AXES.index(axis)] for body, _, axis in (n.rpartition(".") for n in system.coordinates)],
        "rows": [row(value) for body, axis, value in newton_euler_rows(system) if axis != "rotation" or body in turning],
        "conditions": conditions,
        "forces": forces,
    }
