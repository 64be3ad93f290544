"""One phase of a motion as JavaScript: its start, its rates of change, all numbers that are shown, its end.

The state is (coordinates, independent speeds). Events watch a number that is positive while the
phase lasts: the normal force of a contact, the tension of a string, the slip of a contact with
kinetic friction, the friction that is left, the range of a coordinate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any

from rbpsym.errors import LimitError, NotApplicable, StatementError
from rbpsym.explorer.events import acting, events
from rbpsym.explorer.javascript import Program, function
from rbpsym.explorer.scenery import scenery
from rbpsym.field import NOTHING, Scalar, depends_on, derivative, is_zero, symbol, time_derivative
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import lift
from rbpsym.frozen import Frozen
from rbpsym.mechanics import energy
from rbpsym.mechanics.dynamics import newton_euler_rows
from rbpsym.mechanics.elimination import CONSTANT, linear_row
from rbpsym.mechanics.events import pushes
from rbpsym.mechanics.numbers import sample
from rbpsym.mechanics.placing import open_name
from rbpsym.mechanics.released import AXES, released
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element


class StagePhase(Frozen):
    """Code (function texts by name) and data of a phase."""

    code: dict[str, str]
    data: dict[str, Any]


class PhaseEnding(Frozen):
    """What ends a phase and begins the next: a time since its start (None: not known), events by (kind,
    name) that are no surprise then, and a value that a coordinate reaches."""

    time: Scalar | None = None
    events: tuple[tuple[str, str | None], ...] = ()
    goal: tuple[str, Scalar] | None = None


LAST = PhaseEnding()
Struck = Callable[[Callable[[Scalar], int]], dict[str, Any] | None]


class Began(Frozen):
    """What strikes when a phase begins, and the ground of the other phases, which stays in sight."""

    struck: Struck = lambda put: None
    ground: tuple[Element, ...] = ()


START = Began()


def phase(study: Study, names: tuple[str, ...], ending: PhaseEnding = LAST, began: Began = START) -> StagePhase:
    """A phase; `names` are those of the adjustable numbers in their order."""
    solved = is_lighter_solved_here(study, names)
    look = _program(study, names, solved=solved)
    data = seen(study, look, (c.name for c in study.problem.coordinates), ending, began.ground)
    data["endsWith"] = [list(event) for event in ending.events]
    starts = _program(study, names, moving=False)
    state = [starts.output_again(value) for value in _start(study)]
    data["strikes"] = began.struck(starts.output)
    data["endsAt"] = None if ending.time is None else starts.output(ending.time)
    data["start"] = state
    gaps, data["gaps"] = _gaps(study, names)
    data["nudge"] = _nudge(study)
    code = {"start": starts.text, "rates": _rates(study, names, solved), "look": look.text, "gaps": gaps}
    return StagePhase({name: function(ARGUMENTS, text) for name, text in code.items()}, data)


ARGUMENTS = "x,p,t"


def start_name(coordinate: str) -> str:
    """The adjustable number at which a coordinate without a declared start begins."""
    return f"{coordinate}(0)"


def _program(study: Study, names: tuple[str, ...], *, moving: bool = True, solved: bool = True) -> Program:
    """A program that knows parameters, the state and all that the dynamics says."""
    system, dynamics = study.system, study.dynamics
    inputs = {name: f"p[{k}]" for k, name in enumerate(names)} | {"t": "t"}
    if not moving:
        return Program(inputs, {})
    state = (*system.coordinates, *system.speeds)
    inputs |= {name: f"x[{k}]" for k, name in enumerate(state)}
    if not solved:
        return _eliminating(study, Program(inputs, system.defined))
    weights = dict.fromkeys(study.problem.unstated, NOTHING)  # of which nothing is shown
    program = Program(inputs, {**system.defined, **weights, **dict(dynamics.reactions), **dict(dynamics.accelerations or {})})
    if dynamics.accelerations is None:
        program.solve_for(system.accelerations, dynamics.mass_matrix, dynamics.forcing)
    return program


def _eliminating(study: Study, program: Program) -> Program:
    """Accelerations and unknown forces from the equations of the single bodies, solved in the browser."""
    wanted = (*study.system.accelerations, *study.system.unknowns)
    rows = [linear_row(value, wanted) for value in study.newton_euler_rows]
    rows = [row for row in rows if len(row) > 1]
    matrix = [[row.get(name, NOTHING) for name in wanted] for row in rows]
    program.solve_for(wanted, matrix, [-row[CONSTANT] for row in rows])
    return program


def is_lighter_solved_here(study: Study, names: tuple[str, ...]) -> bool:
    """Whether the closed formulas are short enough; else the browser solves the linear equations at every step."""
    if study.dynamics.accelerations is None:
        return False
    long = len(_rates(study, names, solved=True))
    return long < LONG or long < len(_rates(study, names, solved=False))


LONG = 12_000  # characters


def _start(study: Study) -> Iterator[Scalar]:
    """The start state: declared, an adjustable number, or a guess where a constraint will say."""
    system, guess = study.system, sample(study.problem)
    for name in system.coordinates:
        own = symbol(start_name(name)) if name in system.independent else lift(Fraction(guess[name]).limit_denominator(10**6))
        yield system.scope.start.get(name, own)
    for speed in system.speeds:
        yield system.scope.start.get(speed, NOTHING)


def _nudge(study: Study) -> dict[str, Any] | None:
    """The coordinate that is displaced if the system rests in equilibrium at the start, and the way into its range."""
    system = study.system
    if system.has_clock or not system.independent:
        return None
    coordinates = {c.name: c for c in study.problem.coordinates}
    name = min(system.independent, key=lambda n: coordinates[n].quantity.dimension.length != 0)
    upper, start = coordinates[name].upper, coordinates[name].start
    way = -1 if upper is not None and start is not None and is_zero(scalar(upper) - scalar(start)) else 1
    return {"place": system.coordinates.index(name), "name": name, "way": way}


def _rates(study: Study, names: tuple[str, ...], solved: bool) -> str:
    """d/dt of the state and of the two works of each force on each body."""
    program, system = _program(study, names, solved=solved), study.system
    values = [system.scope.rates[name] for name in system.coordinates]
    values += [symbol(name) for name in system.accelerations]
    for force in system.forces:
        state = system.bodies[force.on]
        arm = (force.point - state.center).cross(force.vector) if force.vector else NOTHING
        values += [force.vector.dot(state.velocity), (arm + force.couple) * state.omega]
    texts = [program.value(value) for value in values]
    return "\n".join([*program.lines, f"return [{','.join(texts)}];"])


def _gaps(study: Study, names: tuple[str, ...]) -> tuple[str, dict[str, Any]]:
    """Conditions that stay as equations, with their slopes along each coordinate; which coordinates are held."""
    program, system = _program(study, names), study.system
    put, gaps = program.output_again, [condition.value for condition in system.implicit]
    rows = [[put(gap), [put(derivative(gap, name)) for name in system.coordinates]] for gap in gaps]
    held = [k for k, name in enumerate(system.coordinates) if name in system.scope.start or name in system.independent]
    return program.text, {"rows": rows, "held": held}


def seen(
    study: Study, program: Program, shown: Iterable[str], ending: PhaseEnding = LAST, elsewhere: tuple[Element, ...] = ()
) -> dict[str, Any]:
    """Where all numbers that are shown stand in a program; `shown` are the coordinates."""
    system, put, shown = study.system, program.output, tuple(shown)
    data = {
        "size": len(system.coordinates) + len(system.speeds),
        "free": len(system.coordinates),
        "coordinates": {name: put(symbol(name)) for name in shown},
        "speeds": {name: put(system.scope.rates.get(name, symbol(f"{name}_dot"))) for name in shown},
        "accelerations": {name: put(symbol(f"{name}_ddot")) for name in shown if program.knows(f"{name}_ddot")},
        "unknowns": {name: put(symbol(name)) for name in system.unknowns},
        "couples": [name for name in system.unknowns if any(depends_on(f.couple, name) for f in system.forces)],
        "forces": [
            {"name": f.name, "on": f.on, "law": f.law, "unknown": bool(f.unknowns), **acting(put, f.point, f.vector, f.couple)}
            for f in system.forces
        ],
        "potential": _potential(study, put),
        "origins": {name: [put(place.x), put(place.y)] for name, place in study.origins.items()},
        "events": [{**event, "value": put(event["value"])} for event in events(study, ending.goal)],
    }
    return {**data, **scenery(study, put, elsewhere)}


def _potential(study: Study, put: Callable[[Scalar], int]) -> int | None:
    """The sum of the potential energies that there are; None if no interaction has one."""
    found = [value for value in energy.potentials(study.system).values() if value is not None]
    return put(sum(found, NOTHING)) if found else None


# --- the system of free bodies as JavaScript: what is needed to solve for accelerations and forces, whatever holds just now


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
    owners = {name: system.element(force.name) for force in system.forces for name in force.unknowns}
    forces = [{"name": n, "of": of.name, "turns": n in couples, "pushes": n in pushes(of)} for n, of in owners.items()]
    return {
        "places": [[bodies.index(body), AXES.index(axis)] for body, _, axis in (n.rpartition(".") for n in system.coordinates)],
        "rows": [row(value) for body, axis, value in newton_euler_rows(system) if axis != "rotation" or body in turning],
        "conditions": conditions,
        "forces": forces,
    }
