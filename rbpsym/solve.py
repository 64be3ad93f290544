"""The answer for machines: a problem's results as infix strings in one dictionary."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rbpsym.decide.domain import divisors
from rbpsym.decide.rooted import neat
from rbpsym.decide.signs import sign
from rbpsym.expr.tree import Node, relations
from rbpsym.field import NOTHING, ORIGIN, Scalar, depends_on, has_roots, names_in, short, substitute, symbol, tidy
from rbpsym.field.sympy_bridge import plain_names
from rbpsym.mechanics import energy
from rbpsym.mechanics.at_start import ONLY_THERE
from rbpsym.mechanics.demands import Demand, existence, settle
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.events import Loss, Losses
from rbpsym.mechanics.friction import FrictionNeed
from rbpsym.mechanics.motion import Work
from rbpsym.mechanics.oscillation import Equilibrium, conditions, decaying, eigenvalues
from rbpsym.mechanics.phases import Stage
from rbpsym.mechanics.pushing import begins, kept_sense, ways_kept
from rbpsym.mechanics.rest import AtRest, Rest
from rbpsym.mechanics.sides import grips, lasting
from rbpsym.mechanics.solutions import InTime, courses, given
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState
from rbpsym.present.forms import present
from rbpsym.present.style import PLAIN
from rbpsym.proof.step import Derivation
from rbpsym.statement.model import Problem
from rbpsym.typeset.machine import machine_name, to_machine


def solve(problem: Problem, *, simulation: bool = True) -> dict[str, Any]:
    """The contract of `rbpsym solve --json`; expressions as text that Python and sympy read.

    A speed is `theta_dot`; a value that is not known in closed form is None. Raises
    StatementError for a statement that does not determine the motion.
    """
    from rbpsym.derive import derive

    return answer_of(derive(problem, simulation=simulation))


def answer_of(derivation: Derivation) -> dict[str, Any]:
    """The same of what is derived already."""
    answer = results(derivation.study)
    answer["valid_where"] += _opened(answer, derivation)
    answer["valid_where"] += _owed(answer["valid_where"], derivation)
    for told, phase in zip(answer["phases"], derivation.phases, strict=False):
        _opened(told, phase.derivation)
        told["valid_where"] += _owed(told["valid_where"], phase.derivation)
    return {**answer, "questions": list(_questions(derivation.study)), "verdicts": derivation.summary()}


def _opened(told: dict[str, Any], derivation: Derivation) -> list[str]:
    """The conditions of forces that would be told to be kept, though no step proves it: they are told to be open."""
    found = []
    proved = {step.id: step.certificate.verdict.is_proved for step in derivation.steps}
    for row, side in zip(told["one_sided"], derivation.study.sides, strict=True):
        if not proved.get(f"holds.{side.force}", True):
            asked = _demands((Demand(side.value, ">="),), derivation.study)
            row.update(state="open", until=None, valid_where=asked)
            found += asked
    return found


def _questions(study: Study) -> Iterator[dict[str, Any]]:
    """What the problem itself asks, each as `rbpsym ask --json` tells it."""
    from rbpsym.ask.asking import Refused, own_answers
    from rbpsym.ask.telling import record, unanswered

    for found in own_answers(study):
        yield unanswered(found.text, found.reason) if isinstance(found, Refused) else record(found)


RESULTS = ("motion", "reactions")  # chapters whose steps tell what stands in the answer; other roads to it ask for more


def _owed(told: list[str], derivation: Derivation) -> list[str]:
    """What the steps of the results ask for beside what is `told`: divisors that have cancelled in the values."""
    found = list[str]()
    chapters = (*RESULTS, "kinematics") if derivation.study.problem.unstated else RESULTS
    for step in derivation.steps:
        if step.rule == "first_integral" or (step.chapter in chapters and not step.id.startswith("motion.from_")):
            for duty in step.certificate.verdict.open_obligations:
                left, op, _ = next(relations(duty.relation))
                value = derivation.letters.value(left)
                value = tidy(value * value) if op == "!=" and has_roots(value) else value  # a root is 0 where its square is
                asked = _demands([Demand(value, op), *([Demand(-value, op)] if op == "!=" else [])], derivation.study)
                found += [] if {*told, *found} & {*asked} else asked[:1]
    return found


def text(value: Scalar | None, study: Study | None = None) -> Any:
    """The infix text of a value; None for None, and for what hangs on masses that are not stated."""
    hidden = study.problem.unstated if study else ()
    return None if value is None or not names_in(value).isdisjoint(hidden) else to_machine(shown(value, study))


def shown(value: Scalar, study: Study | None = None) -> Node:
    """The value in the form of a textbook, in sines and cosines, its roots by the declared signs."""
    value = neat(value, study.assumptions) if study and has_roots(value) else value
    return present(value, replace(study.style if study else PLAIN, tangents=False))


def _table(values: Mapping[str, Scalar] | None, study: Study) -> dict[str, Any] | None:
    return None if values is None else {name: text(value, study) for name, value in values.items()}


def results(study: Study) -> dict[str, Any]:
    """All results without the verdicts."""
    system = study.system
    return {
        "problem": study.problem.name,
        "degrees_of_freedom": study.instant.freedom if study.instant else len(system.independent),
        "coordinates": [c.name for c in study.problem.coordinates],
        "symbols": symbols(study),
        "moments_of_inertia": {name: text(state.moment, study) for name, state in system.bodies.items()},
        "masses": {name: text(state.mass, study) for name, state in system.bodies.items()},
        "at_start": _start(study),
        "accelerations": _accelerations(study),
        "equations_of_motion": None if study.at_start else _equations_of_motion(study),
        "dependent_coordinates": _table(system.dependent, study),
        "reactions": _table(study.solved.reactions, study),
        "kinetic_energy": _kinetic(study),
        "potential_energy": None if study.problem.unstated else text(study.potential, study),
        "first_integral": text(study.first_integral, study),
        "speed_squared": _table(study.squares, study) or None,
        "reactions_along_motion": _table(study.reactions_along_motion, study) if study.squares else None,
        "angular_momentum": _momenta(study),
        "forces": _forces(study),
        "works": _works(study),
        "valid_where": _valid_where(study),
        "equilibria": _equilibria(study),
        "equilibria_complete": _complete(study.rest),
        "balance": _balance(study),
        "start_valid_where": _demands(begins(study), study),
        "conditions": [_condition(loss, study) for loss in study.losses],
        "conditions_complete": _complete(study.ended)
        | {"open": [_condition(loss, study) for loss in study.ended.open_]},
        "one_sided": _sides(study),
        "static_friction": [_need(item, study) for item in study.friction_needs],
        "solutions": _solutions(study),
        "phases": _phases(study),
        **({"kinematics": {n: _moves(state, study) for n, state in system.bodies.items()}} if study.problem.unstated else {}),
    }


def _moves(state: BodyState, study: Study) -> dict[str, Any]:
    """How a body moves: velocity and acceleration of its centre as [x, y], how it turns, and about which point just then."""
    vectors = {"velocity": state.velocity, "acceleration": state.acceleration, "instantaneous_centre": state.pole}
    turns = {"angular_velocity": text(state.omega, study), "angular_acceleration": text(state.alpha, study)}
    return {name: None if at is None else _row((tidy(at.x), tidy(at.y)), study) for name, at in vectors.items()} | turns


def _start(study: Study) -> dict[str, Any] | None:
    """The speeds at the start, and why only this is told; None where formulas for every position are."""
    return {"reason": ONLY_THERE, "speeds": _table(study.instant.speeds, study)} if study.instant else None


def _equations_of_motion(study: Study) -> dict[str, Any]:
    dynamics = study.dynamics
    return {
        "speeds": list(study.system.speeds),
        "mass_matrix": [[text(entry, study) for entry in row] for row in dynamics.mass_matrix],
        "forcing": [text(value, study) for value in dynamics.forcing],
    }


def _solutions(study: Study) -> dict[str, list[dict[str, Any]]]:
    """Coordinates as functions of the time, each in the cases that the declared signs leave open."""
    known = ((name, given(study, name)) for name in study.system.independent)
    return {name: [told for one in courses(item) for told in _course(one, study)] for name, item in known if item is not None}


def _course(one: InTime, study: Study) -> Iterator[dict[str, Any]]:
    """What is told of a course, if its conditions do not exclude each other."""
    exists = (item for item in existence(one.whole) if not sign(item.value, study.assumptions).is_nonnegative)
    asked = (*one.valid, *lasting(study.sides, study.friction_needs, study.assumptions), *exists)
    left = settle((demand for demand in asked if not depends_on(demand.value, "t")), study.assumptions)  # times stay
    if left is not None:
        valid = (*left, *(demand for demand in asked if depends_on(demand.value, "t")))
        told = {"place": text(one.whole, study), "speed": text(one.speed, study), "case": one.case or None}
        yield {**told, "where": one.where and {one.where[0]: text(one.where[1], study)}, "valid_where": _demands(valid, study)}


def symbols(study: Study) -> dict[str, dict[str, str]]:
    """All names that an expression may hold, as they are written there, each with one that sympy reads as a symbol."""
    problem, balance = study.problem, study.open_balance
    moving = ["t", *(c.name for c in problem.coordinates)]
    names = [*sorted(study.letters.quantities), "t", *(study.letters.free(f"d_{name}") for name in moving)]
    names += [balance.name] if balance is not None else []
    return {name: {"sympy": plain} for name, plain in plain_names(machine_name(n) for n in names).items()}


def _accelerations(study: Study) -> dict[str, str] | None:
    """Accelerations of all coordinates, also of those that the constraints tie to others."""
    from rbpsym.field.evaluate import time_derivative

    if study.instant is not None:
        return _table({n.removesuffix("_ddot"): v for n, v in study.instant.accelerations.items()}, study)
    found, scope = study.dynamics.accelerations, study.system.scope
    if found is None:
        return None
    values: dict[str, Scalar] = {}
    for coordinate in study.problem.coordinates:
        own = scope.rates.get(coordinate.name)
        speed = time_derivative(study.system.dependent[coordinate.name], scope) if own is None else own
        values[coordinate.name] = substitute(time_derivative(speed, scope), found)
    return _table(values, study)


def _kinetic(study: Study) -> dict[str, Any] | None:
    translational, rotational = study.kinetic
    return _table({"translational": translational, "rotational": rotational, "total": translational + rotational}, study)


def _momenta(study: Study) -> dict[str, Any]:
    def parts(state: BodyState, origin: Any) -> dict[str, Any]:
        return {"orbital": text(energy.orbital_momentum(state, origin), study), "spin": text(energy.spin_momentum(state), study)}

    bodies = study.system.bodies.items()
    return {label: {name: parts(state, place) for name, state in bodies} for label, place in study.origins.items()}


def _forces(study: Study) -> dict[str, dict[str, Any]]:
    """The ledger: the torque of a force about the centre of mass, and the couples, which are entries of their own."""
    found: dict[str, dict[str, Any]] = {}
    for name, body in dict.fromkeys((force.name, force.on) for force in study.system.forces):
        state = study.system.bodies[body]
        forces = [f for f in study.system.on(body) if f.name == name]
        push = sum((f.vector for f in forces), ORIGIN)
        values = {
            "x": push.x,
            "y": push.y,
            "couple": sum((f.couple for f in forces), NOTHING),
            "torque_about_center": sum((torque_about_center(f, state) for f in forces), NOTHING),
        }
        found.setdefault(name, {})[body] = {key: text(short(v), study) for key, v in values.items()}
    return found


def _works(study: Study) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for item in study.works:
        found.setdefault(item.force, {})[item.on] = {
            "translational": _half(item.translational, study),
            "rotational": _half(item.rotational, study),
        }
    return found


def _half(half: Work, study: Study) -> dict[str, str | None]:
    """One coordinate: the integrand over it; several: the sum with d_<coordinate> as factors."""
    if len(half.parts) > 1:
        integrand = sum((part * symbol(study.letters.free(f"d_{name}")) for name, part in half.parts.items()), NOTHING)
    else:
        integrand = next(iter(half.parts.values()), NOTHING)
    return {"integrand": text(integrand, study), "value": text(half.value, study)}


def _equilibria(study: Study) -> list[dict[str, Any]]:
    return [
        {
            "at": _table(item.at, study),
            "stable": item.stable,
            "stability": item.nature.proved,
            "stable_where_positive": text(item.where, study),
            "valid_where": _demands(item.valid, study),
            "frequencies_squared": _row(item.frequencies_squared, study),
            **_damped(item, study),
        }
        for item in study.equilibria
    ]


POSITIVE: Mapping[str | None, bool] = {"positive": True, "zero": False, "negative": False, "nonpositive": False}


def _row(values: Iterable[Scalar], study: Study) -> list[str]:
    return [text(value, study) for value in values]


def _damped(item: Equilibrium, study: Study) -> dict[str, Any]:
    """What is said of small motions in which speeds occur; None where none do."""
    if not item.linear.is_damped:
        return dict.fromkeys(("damping", "characteristic_polynomial", "eigenvalues", "routh_hurwitz"))
    factors = item.linear.factors
    needed = [value for powers in factors for value in conditions(powers)]
    roots = [eigenvalues(powers) for powers in factors]
    return {
        "damping": [
            {"decay_rate": text(decay, study), "frequency_squared": text(square - decay * decay, study)}
            for decay, square in map(decaying, factors)
            if decay and POSITIVE.get(sign(square, study.assumptions).kind) is not False
        ],
        "characteristic_polynomial": {"zeros": item.linear.zeros, "factors": [_row(p, study) for p in factors]},
        "eigenvalues": None if None in roots else [text(v, study) for found in roots for v in found or ()],
        "routh_hurwitz": [{"value": text(v, study), "positive": POSITIVE.get(sign(v, study.assumptions).kind)} for v in needed],
    }


def _valid_where(study: Study) -> list[str]:
    """What must not vanish for accelerations, forces and squares of speeds to be as they are told; what the ways of strings
    and springs, resistances, one-sided forces and static friction ask for."""
    tables = (study.solved.accelerations or {}, study.solved.reactions, study.squares)
    below = dict.fromkeys(one for table in tables for value in table.values() for one in divisors(value))
    open_ = [one for one in below if not sign(one, study.assumptions).is_nonzero]
    asked = [Demand(value) for _, value in ways_kept(study)]
    asked += [demand for element in study.problem.elements for demand in kept_sense(study, element)]
    asked += [demand for side in study.sides if side.state in ("asked", "open") for demand in side.valid]
    return [*(f"{text(one, study)} != 0" for one in open_), *_demands([*asked, *grips(study.friction_needs)], study)]


def _sides(study: Study) -> list[dict[str, Any]]:
    """What becomes of each one-sided force."""
    return [
        {"force": s.force, "state": s.state, "until": s.until or None, "valid_where": _demands(s.valid, study)}
        for s in study.sides
    ]


def _demands(found: Iterable[Demand], study: Study) -> list[str]:
    return list(dict.fromkeys(f"{text(demand.value, study)} {demand.op} 0" for demand in found))


def _complete(found: Rest | Losses) -> dict[str, Any]:
    """Whether a list is all that there is, and why not."""
    return {"complete": "undecided" if found.complete is None else found.complete, "reason": found.reason or None}


def _balance(study: Study) -> dict[str, Any] | None:
    """The position of rest that no formula gives: the force that vanishes there."""
    item = study.open_balance
    if item is None:
        return None
    square = text(_there(item), study)
    return {"coordinate": item.name, "vanishes": text(item.force, study), "stable": item.stable, "frequency_squared": square}


def _there(item: AtRest) -> Scalar | None:
    """The square of the frequency, in the coordinate of the place."""
    square = item.frequency_squared
    return None if square is None else substitute(square, {item.place: symbol(item.name)})


def _condition(loss: Loss, study: Study) -> dict[str, Any]:
    at, valid = _table(loss.at, study) or None, _demands(loss.valid, study)
    return {"force": loss.force, "vanishes": text(loss.factor, study), "at": at, "valid_where": valid}


def _need(item: FrictionNeed, study: Study) -> dict[str, Any]:
    """f/N of a contact that static friction holds, the coefficient that it needs, and whether the declared one will do."""
    return {
        "contact": item.constraint,
        "friction": item.friction,
        "ratio": text(item.ratio, study),
        "needed": text(item.needed, study),
        "coefficient": text(item.limit, study),
        "enough": item.holds,
    }


def _phases(study: Study) -> list[dict[str, Any]]:
    """How each phase after the first begins, and the accelerations in it; a phase whose
    beginning has no closed form has a reason instead, and is the last one."""
    if not study.problem.phases:
        return []
    from rbpsym.mechanics.phases import known_stages

    known, reason = known_stages(study.problem)
    found = [_phase(stage) for stage in known[1:]]
    return found if reason is None else [*found, {"name": study.problem.phases[len(found)].name, "reason": reason.what}]


def _phase(stage: Stage) -> dict[str, Any]:
    began, study = stage.began, stage.study
    assert began is not None, stage.name
    return {
        "name": stage.name,
        "time": text(began.before.time, study),
        "at": _table(began.before.places, study),
        "valid_where": _demands(began.before.valid, study),
        "speeds_before": _table(began.before.speeds, study),
        "speeds": _table(began.speeds, study),
        "impulses": _table(began.impulses, study),
        "energy_lost": text(began.energy_lost, study) if began.is_blow else None,
        "energy_taken": text(began.energy_taken, study),
        "start_valid_where": _demands(stage.starts, study),
        "motion_valid_where": _valid_where(study),
        "at_start": _start(study),
        "static_friction": [_need(item, study) for item in study.friction_needs],
        "accelerations": _accelerations(study),
        "reactions": _table(study.solved.reactions, study),
        "one_sided": _sides(study),
    }
