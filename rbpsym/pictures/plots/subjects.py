"""Which curves a derivation has: each is a formula that one of its steps states, taken along its motion.

Works without a closed form, and those of later phases, are the power of the force added up along the motion.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import cycle
from typing import cast

import numpy as np

from rbpsym.claims.comparison import indexed
from rbpsym.errors import NotApplicable, RbpsymError
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study
from rbpsym.numeric.integration import followed
from rbpsym.pictures.plots.following import Journey, Leg, PlottedMotion, leg, legs
from rbpsym.pictures.plots.panel import Panel, PlotCurve, PlotMark
from rbpsym.pictures.plots.scales import Scale, Scales, scales
from rbpsym.pictures.pose import at, require_motion
from rbpsym.proof.forms import lettered
from rbpsym.proof.step import Derivation, Step
from rbpsym.quantities import DIMENSIONS, ENERGY, FORCE, LENGTH, NUMBER, TIME, Dimension

# --- the work of a force on a body as its power added up along the motion


def work_done(way: Journey, force: str, body: str, half: str) -> np.ndarray:
    """∫F·V_cm dt ("T") or ∫τ_cm ω dt ("theta") from the very start; a phase goes on where the last one ended."""
    from scipy.integrate import cumulative_simpson

    done = 0.0

    def of(leg: Leg) -> np.ndarray:
        nonlocal done
        rates = leg.values(power(leg.study, force, body, half))
        found = done + (cumulative_simpson(rates, x=leg.moments, initial=0.0) if len(rates) > 1 else np.zeros(1))
        done = found[-1]
        return found

    return way.joined(of)


def power(study: Study, force: str, body: str, half: str) -> Scalar:
    """F·V_cm or τ_cm ω of all parts of a force on a body."""
    state = study.system.bodies[body]
    parts = [one for one in study.system.forces if (one.name, one.on) == (force, body)]
    if half == "T":
        return sum((one.vector.dot(state.velocity) for one in parts if one.vector), NOTHING)
    return sum((torque_about_center(one, state) for one in parts), NOTHING) * state.omega


# --- the small oscillation about the stable equilibrium that a motion passes, from the same start


def small_oscillations(moving: PlottedMotion, way: Journey) -> dict[str, np.ndarray]:
    """By coordinate its motion after the linear equations; empty where the motion is not one about an equilibrium."""
    study, leg = moving.derivation.study, way.legs[0]
    if len(way.legs) > 1 or leg.flow.shown != study.system.independent:
        return {}
    near = (found for found in study.equilibria if found.stable and passes(leg, found))
    return next((linear(leg, found) for found in near), {})


def passes(leg: Leg, found: Equilibrium) -> bool:
    """Does the motion turn back, and does each coordinate pass its place of rest?"""
    rests = {name: at(value, leg.at(0)) for name, value in found.at.items()}
    ends = {name: (leg.numbers[name].min() - 1e-9, leg.numbers[name].max() + 1e-9) for name in rests}
    return bool(leg.turns) and all(ends[name][0] <= rest <= ends[name][1] for name, rest in rests.items())


def linear(leg: Leg, found: Equilibrium) -> dict[str, np.ndarray]:
    """M q̈ = -K δq - C q̇ with the derived matrices at rest, at the moments of the motion."""
    names, first = leg.flow.shown, leg.at(0)
    rest = {name: at(found.at[name], first) if name in found.at else first[name] for name in names}
    still = {**first, **rest, **{f"{name}_dot": 0.0 for name in names}}
    matrices = (found.inertia, found.stiffness, found.linear.damping)
    inertia, stiffness, damping = (np.array([[at(v, still) for v in row] for row in rows]) for rows in matrices)
    gains = -np.linalg.solve(inertia, np.hstack([stiffness, damping]))
    start = [*(first[n] - rest[n] for n in names), *(first[f"{n}_dot"] for n in names)]
    path = followed(lambda _, state: np.concatenate([state[len(names) :], gains @ state]), start, leg.moments[-1])
    moved = path.at(leg.moments)[: len(names)]
    return {name: rest[name] + row for name, row in zip(names, moved, strict=True)}


# ---


MOST = 6  # curves in a panel

Chosen = Callable[[Leg], Iterable[Step]]


def across(moving: PlottedMotion, way: Journey) -> tuple[t.Node, np.ndarray, Scale]:
    """What the curves are drawn over: the coordinate of a system whose speed it determines, else the time."""
    if not moving.is_over_place:
        return over_time(moving, way)
    [name] = moving.coordinates
    scale = moving.scales.of(dimension_of(moving, name))
    return t.Sym(name), column(way, name, scale), scale


def over_time(moving: PlottedMotion, way: Journey) -> tuple[t.Node, np.ndarray, Scale]:
    """The time as what curves are drawn over."""
    scale = moving.scales.of(TIME)
    return t.Sym("t"), way.times / scale.size, scale


def dimension_of(moving: PlottedMotion, name: str) -> Dimension:
    """The dimension of a coordinate."""
    return next(c.quantity.dimension for c in moving.derivation.study.problem.coordinates if c.name == name)


def column(way: Journey, name: str, scale: Scale) -> np.ndarray:
    """The numbers of a coordinate or speed."""
    return way.values(symbol(name)) / scale.size


def stated(step: Step, roots: Mapping[str, t.Node] = {}) -> tuple[t.Node, Scalar] | None:
    """The name and the value of a step that says “name = ... = value”; `roots`: those that have a letter."""
    if not isinstance(step.statement, t.Chain) or set(step.statement.ops) != {"="}:
        return None
    try:
        return step.statement.items[0], scalar(t.renamed(step.statement.items[-1], roots))
    except RbpsymError:
        return None


def curves(chosen: Chosen, way: Journey, scale: Scale) -> Iterator[PlotCurve]:
    """A curve for each name that steps state, where it has numbers along most of the way."""
    roots = lettered(step for leg in way.legs for step in leg.derivation.steps)
    tables = {id(leg): dict(filter(None, (stated(step, roots) for step in chosen(leg)))) for leg in way.legs}
    for name in dict.fromkeys(name for table in tables.values() for name in table):
        values = _along(way, tables, name) / scale.size
        count = sum(len(leg.moments) for leg in way.legs if name in tables[id(leg)])
        if np.isfinite(values).sum() > count / 2:
            yield PlotCurve(name, values)


def _along(way: Journey, tables: Mapping[int, Mapping[t.Node, Scalar]], name: t.Node) -> np.ndarray:
    return way.joined(lambda leg: leg.values(tables[id(leg)].get(name, NOWHERE)))


NOWHERE = symbol("[nowhere]")  # a quantity without a number


# --- works


def works(moving: PlottedMotion, named: Collection[t.Node] = ()) -> Iterator[Panel]:
    """A panel for each force that works in several ways, with both works and their sum; then all other works, or those that
    are `named`. A force has one colour, and all panels have one scale."""
    scale, several, single = moving.scales.of(ENERGY), list[tuple[PlotCurve, ...]](), list[PlotCurve]()
    for look, (force, found) in zip(cycle(range(1, MOST + 1)), by_force(moving, scale, named).items(), strict=False):
        styled = tuple(replace(one, style=f"{style} {look}") for one, style in found)
        if len(styled) > 1:
            both = np.sum([one.values for one in styled], axis=0)
            several.append((*styled, PlotCurve(t.Sym(f"cal_W_{force}"), both, "curve sum")))
        else:
            single += styled
    shown = sorted(several, key=lambda group: max(map(largest_value, group)), reverse=True)[: MOST - 1]
    groups = [*(group for group in several if group in shown), *([tuple(largest(single))] if single else ())]
    every = np.concatenate([[0.0], *(curve.values for group in groups for curve in group)])
    reach = (float(np.nanmin(every)), float(np.nanmax(every)))
    left_out = sum(map(len, several)) + len(single) - sum(map(len, groups))
    for number, group in enumerate(groups):
        yield replace(panel(moving, moving.real, group, scale), kind="works", reach=reach, omitted=left_out if number == 0 else 0)


Styled = tuple[PlotCurve, str]


def by_force(moving: PlottedMotion, scale: Scale, named: Collection[t.Node]) -> Mapping[str, list[Styled]]:
    """For each force its works that are not zero, and whether each is one along the path or about the centre of mass."""
    found: dict[str, list[Styled]] = {}
    for half, style in (("T", "along"), ("theta", "about")):
        for force, curve in halves(moving, half, scale):
            if largest_value(curve) > 1e-9 and (not named or curve.name in named):
                found.setdefault(force, []).append((curve, style))
    return found


def largest(found: Sequence[PlotCurve]) -> list[PlotCurve]:
    """As many curves as a panel can hold, the largest ones, in their order."""
    shown = sorted(found, key=largest_value, reverse=True)[:MOST]
    return [curve for curve in found if curve in shown]


def largest_value(curve: PlotCurve) -> float:
    """The largest size of a value."""
    return float(np.nanmax(np.abs(curve.values), initial=0.0))


def halves(moving: PlottedMotion, half: str, scale: Scale) -> Iterator[tuple[str, PlotCurve]]:
    """The translational (T) or rotational (theta) work of each force on each body, with the name of the force."""
    closed = {t.rows(s.statement)[0].items[0]: s for s in moving.derivation.steps if s.rule == "work_done"}
    for name, (force, body) in work_names(moving.derivation.steps, half).items():
        if moving.is_over_place and name in closed:
            yield from ((force, one) for one in curves(only(closed[name]), moving.real, scale))
        else:
            yield force, PlotCurve(name, work_done(moving.real, force, body, half) / scale.size)


def work_names(steps: Iterable[Step], half: str) -> dict[t.Node, tuple[str, str]]:
    """How the works of one half are called, with the force and the body of each."""
    found = dict[t.Node, tuple[str, str]]()
    for step in steps:
        if step.rule == "work" and step.id.count(".") == 2:  # those of the ledger: work.FORCE.BODY
            _, force, body = step.id.split(".")
            for row in t.rows(step.statement):
                if row.items[0].name.startswith(f"cal_W_{half}"):
                    found[row.items[0]] = force, body
    return found


def panel(
    moving: PlottedMotion, way: Journey, found: tuple[PlotCurve, ...], scale: Scale, marks: tuple[PlotMark, ...] = ()
) -> Panel:
    """A panel over what the motion is drawn over."""
    node, places, own = across(moving, way)
    return Panel(node, places, found, own, scale, marks=(*changes(moving), *marks))


def changes(moving: PlottedMotion) -> tuple[PlotMark, ...]:
    """Where one phase ends and the next begins, on the axis of the time."""
    size = moving.scales.of(TIME).size
    return tuple(PlotMark(leg.began / size, leg.name) for leg in moving.whole.legs if leg.began)


# --- energies and speeds


def energies(moving: PlottedMotion) -> Iterator[Panel]:
    """Kinetic and potential energies and their sum."""
    scale = moving.scales.of(ENERGY)
    kinetic = list(curves(of_rule("kinetic_energy"), moving.real, scale))
    potential = list(curves(of_rule("potential"), moving.real, scale))
    changing = [one for one in potential if spread([since_start(one)]) > 1e-9 * spread([one])]
    parts, total = [*kinetic, *changing][: MOST - 1], cast(t.Node, t.Sym("E"))
    if changing != potential or (potential and spread(kinetic) < HARDLY * spread(parts)):
        parts, total = list(map(since_start, parts)), t.Delta(total)
    if parts:
        whole = [PlotCurve(total, np.sum([one.values for one in parts], axis=0), "curve sum")] if len(parts) > 1 else []
        yield replace(panel(moving, moving.real, (*parts, *whole), scale), kind="energies")


HARDLY = 0.12  # of the height: where the kinetic energy is less, or one stays, all energies are counted from the start


def spread(found: Sequence[PlotCurve]) -> float:
    """How far apart the values of some curves (and zero) are."""
    values = np.array([curve.values for curve in found])
    return float(np.nanmax(values, initial=0.0) - np.nanmin(values, initial=0.0))


def since_start(curve: PlotCurve) -> PlotCurve:
    """The change of a quantity since the start."""
    first = curve.values[np.isfinite(curve.values)][0]
    return PlotCurve(curve.name if isinstance(curve.name, str) else t.Delta(curve.name), curve.values - first, curve.style)


def only(step: Step) -> Chosen:
    """One step."""
    return lambda leg: [step]


def of_rule(rule: str) -> Chosen:
    """The steps of a rule."""
    return lambda leg: [step for step in leg.derivation.steps if step.rule == rule]


def speeds(moving: PlottedMotion) -> Iterator[Panel]:
    """The speed of each coordinate; those of one dimension in one panel."""
    for dimension, names in by_dimension(moving).items():
        scale = moving.scales.of(dimension / TIME)
        found = tuple(PlotCurve(t.Sym(f"{n}_dot"), column(moving.real, f"{n}_dot", scale)) for n in names)
        yield replace(panel(moving, moving.real, found[:MOST], scale), kind="turning" if dimension == NUMBER else "speeds")


def by_dimension(moving: PlottedMotion) -> Mapping[Dimension, list[str]]:
    """The coordinates that move (all, if none does) by what they measure."""
    found: dict[Dimension, list[str]] = {}
    moved = [n for n in moving.coordinates if np.nan_to_num(moving.whole.values(symbol(f"{n}_dot"))).any()]
    for name in moved or moving.coordinates:
        found.setdefault(dimension_of(moving, name), []).append(name)
    return found


# --- forces


def forces(moving: PlottedMotion, named: Collection[t.Node] = ()) -> Iterator[Panel]:
    """The unknown forces (or the `named` ones) along the motion, marked where a contact is lost; then the unknown couples."""
    couples = couples_of(moving)
    for wanted, scale in ((False, moving.scales.of(FORCE)), (True, moving.scales.of(DIMENSIONS["torque"], "torque"))):
        found = curves(partial(reactions, couples=couples, wanted=wanted), moving.real, scale)
        if every := [curve for curve in found if not named or curve.name in named]:
            shown = tuple(largest(every))
            made = panel(moving, moving.real, shown, scale, marks=marks_of(moving))
            yield replace(made, kind="couples" if wanted else "forces", omitted=len(every) - len(shown))


def reactions(leg: Leg, couples: set[str], wanted: bool) -> Iterator[Step]:
    """The steps that state the unknown forces (or couples): along the motion where there are such, else for any state."""
    steps = {step.id: step for step in leg.derivation.steps}
    for name in leg.study.system.unknowns:
        step = steps.get(f"along.{name}") or steps.get(f"reaction.{name}")
        if step is not None and (name in couples) == wanted:
            yield step


def couples_of(moving: PlottedMotion) -> set[str]:
    """The unknowns that are couples and no forces."""
    systems = [leg.study.system for leg in moving.whole.legs]
    pushing = {n for s in systems for f in s.forces for n in f.unknowns if f.vector.derivative(n)}
    return {name for system in systems for name in system.unknowns} - pushing


def marks_of(moving: PlottedMotion) -> tuple[PlotMark, ...]:
    """Where the contact is lost, on the axis of the panel, or where it slips."""
    if moving.loss is None:
        return ()
    moment, name = moving.loss
    _, places, _ = across(moving, Journey(moving.way.legs[-1:]))
    for element in moving.way.legs[-1].study.problem.constraints:
        if element.values.get("friction") == name:
            most = t.mul(element["limit"], t.add(*map(t.Sym, element.normals)))
            return (PlotMark(places[moment], t.equation(t.Abs(t.Sym(name)), most)),)
    return (PlotMark(places[moment], t.equation(t.Sym(name), t.ZERO), has_dot=True),)


# --- motion in time


def positions(moving: PlottedMotion, linear: str = "") -> Iterator[Panel]:
    """The motion in time; beside it, called `linear`, the small oscillation from the same start where there is one."""
    way = moving.real if moving.loss else moving.whole
    small = small_oscillations(moving, way)
    for dimension, names in by_dimension(moving).items():
        scale = moving.scales.of(dimension)
        node, times, own = over_time(moving, way)
        found = [PlotCurve(t.Sym(name), column(way, name, scale)) for name in names[:MOST]]
        for curve, name in zip(tuple(found), names, strict=False):
            if name in small and differs(small[name] / scale.size, curve.values):
                label = linear if len(names) == 1 else t.Mul((t.Sym(name), t.Word(f"({linear})")))
                found.append(PlotCurve(label, small[name] / scale.size, "curve thin"))
        yield Panel(node, times, tuple(found), own, scale, marks=changes(moving), kind="places" if dimension == LENGTH else "")


def differs(one: np.ndarray, other: np.ndarray) -> bool:
    """Would two curves be told apart?"""
    return bool(np.nanmax(np.abs(one - other)) > 0.02 * np.nanmax(np.abs(other)))


# --- two motions in one plot: a coordinate that both problems have, and its rate, from the same start with the same numbers


def motions(first: Derivation, second: Derivation) -> tuple[PlottedMotion, PlottedMotion]:
    """Both with the numbers of the first, as far as it has them, and for the same time. Raises NotApplicable."""
    for one in (first, second):
        require_motion(one.study)
    if first.phases or second.phases:
        raise NotApplicable("a motion in phases is not put beside another")
    found, own = (scales(one.study) for one in (first, second))
    numbers = (found, Scales({**own.numbers, **found.numbers}, found.base))
    pairs = list(zip((first, second), numbers, strict=True))
    end = max(next(legs(one, scale)).moments[-1] for one, scale in pairs)
    made = [PlottedMotion(one, scale, Journey((leg(one, scale.numbers, end),))) for one, scale in pairs]
    return made[0], made[1]


def beside(pair: tuple[PlottedMotion, PlottedMotion], name: str) -> Iterator[Panel]:
    """The coordinate over the time, and its rate, each with the number of the problem."""
    first = pair[0]
    length = dimension_of(first, name)
    ways = [one.real if one.loss else one.whole for one in pair]
    node, times, own = over_time(first, max(ways, key=lambda way: np.nanmax(way.times)))
    for suffix, dimension in (("", length), ("_dot", length / TIME)):
        scale = first.scales.of(dimension)
        letters = (t.Sym(indexed(name + suffix, first.derivation.study, k)) for k in (1, 2))
        columns = (column(way, name + suffix, scale) for way in ways)
        known = [np.interp(times, way.times / own.size, values, right=np.nan) for way, values in zip(ways, columns, strict=True)]
        yield Panel(node, times, tuple(map(PlotCurve, letters, known)), own, scale)
