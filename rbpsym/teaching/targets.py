"""What a worksheet can ask about a problem: quantities with their values, as functions of a `Study`.

A target says how its value is found in *any* study, so that a study in which the physics was
changed as a student changes it (`misconceptions`) gives the wrong value by the same way.
A new kind of quantity is a new entry of `KINDS`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from rbpsym.ask.asking import found_in, letters
from rbpsym.chapters.inertia import turns_about
from rbpsym.chapters.methods.net_work import HALVES
from rbpsym.decide.dimensions import dimension_of
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, depends_on, is_zero, names_in, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import replace
from rbpsym.mechanics import energy
from rbpsym.mechanics.motion import along_motion
from rbpsym.mechanics.study import Study
from rbpsym.present.forms import present
from rbpsym.proof.step import BodyRef, Derivation, QuestionRef
from rbpsym.quantities import DIMENSIONS, NUMBER, TIME, Dimension
from rbpsym.teaching.target import RootReading, Target

# questions that assert something: the sentence by which the derivation says so (`proof.assertions`)
ASSERTED = {"frequency": "oscillations.frequency.", "loss": "contact.lost"}


def targets(derivation: Derivation) -> tuple[Target, ...]:
    """All that can be asked, in the order of the notes; what vanishes identically is left out."""
    made = (_with_step(target, derivation) for make in KINDS.values() for target in make(derivation))
    told = {step.id: f"{step.phrase}." for step in derivation.steps}
    found = (target for target in made if told.get(target.step, "").startswith(ASSERTED.get(target.kind, "")))
    return tuple(target for target in found if _is_worth_asking(target, derivation.study))


def _is_worth_asking(target: Target, study: Study) -> bool:
    value = target.value(study)
    return value is not None and not is_zero(value)


def _with_step(target: Target, derivation: Derivation) -> Target:
    """The first of the steps named (by "|") that the derivation has."""
    known = {step.id for step in derivation.steps}
    return replace(target, step=next((id for id in (target.step or target.id).split("|") if id in known), ""))


# --- kinds


def _moment(name: str, square: Scalar, study: Study) -> Scalar:
    """About the axis at the distance whose square is given."""
    body = study.system.bodies[name]
    return body.moment + body.mass * square


def _accelerations(derivation: Derivation) -> Iterator[Target]:
    for coordinate in derivation.study.problem.coordinates:
        name = coordinate.name
        if name in derivation.study.system.independent:
            yield Target(
                f"acceleration.{name}",
                t.Sym(f"{name}_ddot"),
                _by(lambda name, study: (study.dynamics.accelerations or {}).get(f"{name}_ddot"), name),
                coordinate.quantity.dimension / TIME**2,
                f"motion.{name}|motion.from_work|motion.from_energy",
                {"coordinate": t.Sym(name)},
            )


def _speeds(derivation: Derivation) -> Iterator[Target]:
    known = derivation.study.squares
    for coordinate in derivation.study.problem.coordinates:
        name = coordinate.name
        if name not in known or not any(depends_on(known[name], c) for c in derivation.study.system.coordinates):
            continue
        speed = t.Sym(f"{name}_dot")
        rate = coordinate.quantity.dimension / TIME
        yield Target(
            f"speed.{name}",
            t.Pow(speed, t.TWO),
            _by(lambda name, study: study.squares.get(name), name),
            rate**2,
            f"square.{name}",
            {"coordinate": t.Sym(name), "speed": speed},
            reading=RootReading(t.Abs(speed), t.Sqrt, math.sqrt, rate),
        )


def _reactions(derivation: Derivation) -> Iterator[Target]:
    for name in derivation.study.dynamics.reactions:
        couple = any(e.values.get("couple") == name for e in derivation.study.problem.constraints)
        yield Target(
            f"reaction.{name}",
            t.Sym(name),
            partial(_reaction, name=name),
            DIMENSIONS["torque" if couple else "force"],
            f"along.{name}|reaction.{name}",
            {"force": t.Sym(name)},
            "torque" if couple else "",
        )


def _reaction(study: Study, name: str) -> Scalar | None:
    """As a function of the position where that is known, else of the state; by name in the right system only."""
    value = study.dynamics.reactions.get(name)
    if value is None:
        return None
    along = along_motion(value, study.squares) if study.squares else None
    return value if along is None else along


def axes(study: Study) -> Mapping[str, tuple[str, Scalar]]:
    """Bodies that turn rigidly about a fixed point that is not their centre of mass: (its name, distance²)."""
    places = {name: turns_about(study, state).items() for name, state in study.system.bodies.items()}
    first = {name: next((place for place in found if place[1]), None) for name, found in places.items()}
    return {name: place for name, place in first.items() if place is not None}


def _moments(derivation: Derivation) -> Iterator[Target]:
    study, single = derivation.study, len(derivation.study.system.bodies) == 1
    for name, state in study.system.bodies.items():
        if state.moment and study.problem.body(name).shape.given_moment is None:
            yield Target(
                f"moment.{name}",
                t.Sym("I_cm" if single else f"I_{name}"),
                partial(_moment, name, NOTHING),
                DIMENSIONS["moment of inertia"],
                slots={"body": BodyRef(name)},
            )
    for name, (label, square) in axes(study).items():
        yield Target(
            f"axis-moment.{name}",
            t.Sym(f"I_{label}" if single else f"I_{name}_{label}"),
            partial(_moment, name, square),
            DIMENSIONS["moment of inertia"],
            f"moment.{name}.{label}",
            {"body": BodyRef(name), "point": t.Sym(label)},
        )


def _momenta(derivation: Derivation) -> Iterator[Target]:
    study = derivation.study
    bodies = list(study.system.bodies)
    for body in bodies:
        yield _momentum((body,), "L_z" if len(bodies) == 1 else f"L_{body}", f"momentum.{body}.O", body)
    if len(bodies) > 1:
        yield _momentum(tuple(bodies), "L_z", "momentum.total.O", "")


def _momentum(bodies: tuple[str, ...], letter: str, step: str, body: str) -> Target:
    return Target(
        f"momentum.{body or 'total'}",
        t.Sym(letter),
        lambda study: momentum(study, bodies),
        DIMENSIONS["angular momentum"],
        step,
        {"variant": "one", "body": BodyRef(body)} if body else {"variant": "all"},
    )


def momentum(study: Study, bodies: tuple[str, ...]) -> Scalar:
    """The angular momentum of bodies about O, counter-clockwise positive."""
    origin = study.origins["O"]
    states = [study.system.bodies[name] for name in bodies]
    return sum((energy.orbital_momentum(s, origin) + energy.spin_momentum(s) for s in states), NOTHING)


def _kinetic(derivation: Derivation) -> Iterator[Target]:
    yield Target("kinetic", t.Sym("K"), lambda study: sum(study.kinetic, NOTHING), DIMENSIONS["energy"])


def _works(derivation: Derivation) -> Iterator[Target]:
    several = len(derivation.study.system.bodies) > 1
    for item in derivation.study.works:
        for letter, half in HALVES:
            yield Target(
                f"work.{letter}.{item.force}.{item.on}",
                t.Sym(work_symbol(derivation, letter, item.force, item.on)),
                partial(_work, half=half, force=item.force, on=item.on),
                DIMENSIONS["energy"],
                f"done.{letter}.{item.force}.{item.on}|work.{item.force}.{item.on}",
                {"force": force_symbol(derivation, item.force, item.on), "body": BodyRef(item.on), "half": letter}
                | {"variant": half, "several": several},
            )


def _work(study: Study, half: str, force: str, on: str) -> Scalar | None:
    item = next(item for item in study.works if (item.force, item.on) == (force, on))
    return (item.translational if half == "translational" else item.rotational).value


def force_symbol(derivation: Derivation, force: str, on: str) -> t.Node:
    """The force as the derivation's ledger writes it (W_rod, -N)."""
    found = next((s for s in derivation.steps if s.id == f"force.{force}.{on}"), None)
    return found.slots["force"] if found is not None and "force" in found.slots else t.Vec(force)


def work_symbol(derivation: Derivation, letter: str, force: str, on: str) -> str:
    """The name of a work as the derivation writes it."""
    told = (step.statement for step in derivation.steps if step.id == f"work.{force}.{on}")
    names: list[str] = [row.items[0].name for statement in told for row in t.rows(statement)]
    return next((name for name in names if name.startswith(f"cal_W_{letter}_")), f"cal_W_{letter}_{force}")


_TURN = t.Mul((t.TWO, t.Sym("pi")))
_PERIOD = RootReading(t.Sym("T"), lambda node: t.Div(_TURN, t.Sqrt(node)), lambda square: math.tau / math.sqrt(square), TIME)


def _frequencies(derivation: Derivation) -> Iterator[Target]:
    for place, item in enumerate(derivation.study.equilibria, 1):
        if item.stable and len(item.frequencies_squared) == 1:
            yield Target(
                f"frequency.{place}",
                t.Pow(t.Sym("vartheta"), t.TWO),
                _by(lambda k, study: next((f for p in study.equilibria[k - 1 : k] for f in p.frequencies_squared), None), place),
                TIME**-2,
                slots={"speed": t.Sym("vartheta")},
                reading=_PERIOD,
            )


def _frictions(derivation: Derivation) -> Iterator[Target]:
    for name in (need.constraint for need in derivation.study.friction_needs if need.needed is not None):
        of = _by(lambda name, study: next((n.needed for n in study.friction_needs if n.constraint == name), None), name)
        yield Target(f"friction.{name}", t.Sym("mu_min"), of, NUMBER, slots={"contact": t.Sym(name)})


def _losses(derivation: Derivation) -> Iterator[Target]:
    for force, name in ((loss.force, loss.coordinate) for loss in derivation.study.losses if loss.at):
        of = _by(lambda at, study: next((x.at.get(at[1]) for x in study.losses if x.force == at[0]), None), (force, name))
        slots, dimension = {"force": t.Sym(force), "coordinate": t.Sym(name)}, derivation.study.problem.dimensions[name]
        yield Target(f"loss.{force}", t.Sym(name), of, dimension, slots=slots, unit_name="angle")


def _by(find: Callable[[Any, Study], Scalar | None], key: object) -> Callable[[Study], Scalar | None]:
    """How what has a key (a name, a place) is found in any study."""
    return partial(find, key)


def _questions(derivation: Derivation) -> Iterator[Target]:
    """What the problem itself asks, where the answer is one value."""
    study = derivation.study
    is_later = any(step.chapter == "phase" for step in derivation.steps)  # the whole motion is asked about
    for number, text in enumerate(() if is_later else study.problem.questions, 1):
        target = Target(f"question.{number}", t.Sym(letters(study)[text]), partial(_answer, text=text), NUMBER,
                        slots={"question": QuestionRef(text)})  # fmt: skip
        value = target.value(study)
        dimension = _dimension(study, value) if value else None
        if dimension is not None:
            name = _own_name(study, text)
            left, unit = t.Sym(name) if name else target.left, "angle" if name in study.system.coordinates else ""
            yield replace(target, left=left, dimension=dimension, unit_name="" if dimension != NUMBER else unit)


def _dimension(study: Study, value: Scalar) -> Dimension | None:
    """The dimension of a value; None where it holds the time, which no answer may hold."""
    formula = present(value, study.style)
    return dimension_of(formula, study.problem.dimensions) if t.names(formula) <= {*study.problem.dimensions, "pi"} else None


def _answer(study: Study, text: str) -> Scalar | None:
    values = found_in(study, text).values
    return values[0] if len(values) == 1 else None


def _own_name(study: Study, text: str) -> str:
    """The name of what is asked for, if it has one: a force, a coordinate, its rates."""
    found = found_in(study, text)
    named = getattr(found, "named", ())
    system = study.system
    later = (element.name for phase in study.problem.phases for element in phase.problem.constraints)
    names = (*system.unknowns, *system.accelerations, *(f"{c}{r}" for c in system.coordinates for r in ("", "_dot")), *later)
    given = (q.name for q in study.problem.parameters if q.name == getattr(found, "symbol", ""))
    return next((name for name in names if named == (symbol(name),)), next(given, ""))


# what is asked of each body of a motion that is given: its letter, and of what
GIVEN: Mapping[str, tuple[str, str, str, str]] = {
    "turning": ("omega", "angular velocity", "{}", "angular speed"),
    "spin_up": ("alpha", "angular acceleration", "{}", "angular acceleration"),
    "speed": ("v", "speed", "{}.cm", "speed"),
    "acceleration": ("a", "magnitude of acceleration", "{}.cm", "acceleration"),
}


def _given(derivation: Derivation) -> Iterator[Target]:
    """How each body moves at the start, where masses are not stated."""
    study = derivation.study
    for body in study.system.bodies if study.problem.unstated else ():
        for variant, (letter, what, of, dimension) in GIVEN.items():
            find = partial(_answer, text=f"{what} of {of.format(body)} at the start")
            name = study.letters.free(f"{letter}_{body}")
            slots = {"variant": variant, "body": BodyRef(body)}
            target = Target(f"given.{variant}.{body}", t.Sym(name), find, DIMENSIONS[dimension], slots=slots)
            value = target.value(study)
            if value is not None and all(value not in (symbol(name), -symbol(name)) for name in names_in(value)):  # else stated
                yield target


# steps by which a later phase begins: how what they tell is asked for
STARTS: Mapping[str, str] = {"after.speeds": "speed", "state.speed": "speed", "moment": "time", "energy.lost": "blow",
                             "energy.taken": "friction"}  # fmt: skip


def _starts(derivation: Derivation) -> Iterator[Target]:
    """How a later phase begins: each speed, by the name that the derivation gives it, the time, the energy that was lost."""
    study, known = derivation.study, {step.id: step for step in derivation.steps}
    speeds = [f"{name}_dot" for name in study.system.independent]
    for id, variant in ((id, variant) for id, variant in STARTS.items() if id in known):
        for row in t.rows(known[id].statement):
            value = scalar(row.items[-1], study.system.scope) if t.names(row.items[-1]) <= set(study.problem.dimensions) else None
            name = next((s for s in speeds if value == study.system.scope.start.get(s)), "") if variant == "speed" else variant
            if value is None or not name:
                continue
            variant = "gain" if known[id].phrase == "phases.lost.gained" else variant
            speeds = [speed for speed in speeds if speed != name]
            of = (lambda study, s=name: study.system.scope.start.get(s)) if variant == "speed" else lambda _, v=value: v
            dimension = dimension_of(row.items[-1], study.problem.dimensions)
            yield Target(f"start.{name}", row.items[0], of, dimension, id, {"variant": variant})


KINDS: Mapping[str, Callable[[Derivation], Iterator[Target]]] = {
    "start": _starts,
    "given": _given,
    "moment": _moments,
    "momentum": _momenta,
    "acceleration": _accelerations,
    "reaction": _reactions,
    "work": _works,
    "kinetic": _kinetic,
    "speed": _speeds,
    "frequency": _frequencies,
    "friction": _frictions,
    "loss": _losses,
    "question": _questions,
}
