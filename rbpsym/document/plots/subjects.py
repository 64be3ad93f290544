"""Which curves a derivation has: each is a formula that one of its steps states, taken along its motion.

Works without a closed form, and those of later phases, are the power of the force added up along the motion.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.step import Step
from rbpsym.document.plots.motion import Journey, Leg, Motion
from rbpsym.document.plots.oscillation import small_oscillations
from rbpsym.document.plots.panel import Curve, Mark, Panel
from rbpsym.document.plots.power import work_done
from rbpsym.document.plots.scales import Scale
from rbpsym.errors import RbpsymError
from rbpsym.notation import tree as t
from rbpsym.quantities import DIMENSIONS, ENERGY, FORCE, TIME, Dimension

MOST = 6  # curves in a panel

Chosen = Callable[[Leg], Iterable[Step]]


def across(moving: Motion, way: Journey) -> tuple[t.Node, list[float], Scale]:
    """What the curves are drawn over: the coordinate of a system whose speed it determines, else the time."""
    if not moving.is_over_place:
        return over_time(moving, way)
    [name] = moving.coordinates
    scale = moving.scales.of(dimension_of(moving, name))
    return t.Sym(name), column(way, name, scale), scale


def over_time(moving: Motion, way: Journey) -> tuple[t.Node, list[float], Scale]:
    """The time as what curves are drawn over."""
    scale = moving.scales.of(TIME)
    return t.Sym("t"), [time / scale.size for time in way.times], scale


def dimension_of(moving: Motion, name: str) -> Dimension:
    """The dimension of a coordinate."""
    return next(c.quantity.dimension for c in moving.derivation.study.problem.coordinates if c.name == name)


def column(way: Journey, name: str, scale: Scale) -> list[float]:
    """The numbers of a coordinate or speed."""
    return way.joined(lambda leg: [state[name] / scale.size for state in leg.moments.states])


def stated(step: Step) -> tuple[t.Node, Scalar] | None:
    """The name and the value of a step that says “name = ... = value”."""
    if not isinstance(step.statement, t.Chain) or set(step.statement.ops) != {"="}:
        return None
    try:
        return step.statement.items[0], scalar(step.statement.items[-1])
    except RbpsymError:
        return None


def curves(chosen: Chosen, way: Journey, scale: Scale) -> Iterator[Curve]:
    """A curve for each name that steps state, where it has numbers along most of the way."""
    tables = {id(leg): dict(filter(None, map(stated, chosen(leg)))) for leg in way.legs}
    for name in dict.fromkeys(name for table in tables.values() for name in table):
        values = way.joined(lambda leg, name=name: numbers_of(leg, tables[id(leg)].get(name), scale))
        count = sum(len(leg.moments.times) for leg in way.legs if name in tables[id(leg)])
        if sum(map(math.isfinite, values)) > count / 2:
            yield Curve(name, values)


def numbers_of(leg: Leg, value: Scalar | None, scale: Scale) -> list[float]:
    """A quantity along a leg; not numbers where it has none there."""
    try:
        return [number / scale.size for number in leg.moments.values(value)]
    except (KeyError, AttributeError):
        return [math.nan] * len(leg.moments.times)


# --- works


def works(moving: Motion) -> Iterator[Panel]:
    """Translational works with their sum, and rotational works with theirs."""
    scale = moving.scales.of(ENERGY)
    for half in ("T", "theta"):
        found = [curve for curve in halves(moving, half, scale) if any(abs(v) > 1e-9 for v in curve.values)]
        if not found:
            continue
        whole = [Curve(t.Sym(f"cal_W_{half}"), summed(found), "curve sum")] if len(found) > 1 else []
        shown = largest(found)
        yield replace(panel(moving, moving.real, (*shown, *whole), scale), omitted=len(found) - len(shown))


def largest(found: Sequence[Curve]) -> list[Curve]:
    """As many curves as a panel can hold, the largest ones, in their order."""
    by_size = sorted(found, key=lambda curve: -max((abs(v) for v in curve.values if math.isfinite(v)), default=0.0))
    return [curve for curve in found if curve in by_size[:MOST]]


def halves(moving: Motion, half: str, scale: Scale) -> Iterator[Curve]:
    """The translational (T) or rotational (theta) work of each force on each body."""
    closed = {s.statement.items[0]: s for s in moving.derivation.steps if s.rule == "work_done"}
    for name, (force, body) in work_names(moving.derivation.steps, half).items():
        if moving.is_over_place and name in closed:
            yield from curves(lambda _, step=closed[name]: [step], moving.real, scale)
        else:
            yield Curve(name, [value / scale.size for value in work_done(moving.real, force, body, half)])


def work_names(steps: Iterable[Step], half: str) -> dict[t.Node, tuple[str, str]]:
    """How the works of one half are called, with the force and the body of each."""
    found = {}
    for step in steps:
        if step.rule == "work" and step.id.count(".") == 2:  # those of the ledger: work.FORCE.BODY
            _, force, body = step.id.split(".")
            for row in getattr(step.statement, "rows", (step.statement,)):
                if row.items[0].name.startswith(f"cal_W_{half}"):
                    found[row.items[0]] = force, body
    return found


def summed(found: Sequence[Curve]) -> list[float]:
    """The sum of curves place by place."""
    return [sum(values) for values in zip(*(curve.values for curve in found), strict=True)]


def panel(moving: Motion, way: Journey, found: tuple[Curve, ...], scale: Scale, marks: tuple[Mark, ...] = ()) -> Panel:
    """A panel over what the motion is drawn over."""
    node, places, own = across(moving, way)
    return Panel(node, places, found, own, scale, marks=(*changes(moving), *marks))


def changes(moving: Motion) -> tuple[Mark, ...]:
    """Where one phase ends and the next begins, on the axis of the time."""
    size = moving.scales.of(TIME).size
    return tuple(Mark(leg.began / size, leg.name) for leg in moving.whole.legs[1:])


# --- energies and speeds


def energies(moving: Motion) -> Iterator[Panel]:
    """Kinetic and potential energies and their sum."""
    scale = moving.scales.of(ENERGY)
    kinetic = list(curves(lambda leg: of_rule(leg, "kinetic_energy"), moving.real, scale))
    potential = list(curves(lambda leg: of_rule(leg, "potential"), moving.real, scale))
    parts, total = [*kinetic, *potential][: MOST - 1], t.Sym("E")
    if potential and spread(kinetic) < HARDLY * spread(parts):
        parts, total = list(map(since_start, parts)), t.Delta(total)
    if parts:
        whole = [Curve(total, summed(parts), "curve sum")] if len(parts) > 1 else []
        yield panel(moving, moving.real, (*parts, *whole), scale)


HARDLY = 0.12  # of the height: where the kinetic energy is less, all energies are counted from the start


def spread(found: Sequence[Curve]) -> float:
    """How far apart the values of some curves (and zero) are."""
    known = [value for curve in found for value in curve.values if math.isfinite(value)]
    return max([0.0, *known]) - min([0.0, *known])


def since_start(curve: Curve) -> Curve:
    """The change of a quantity since the start."""
    first = next(value for value in curve.values if math.isfinite(value))
    return Curve(t.Delta(curve.name), [value - first for value in curve.values], curve.style)


def of_rule(leg: Leg, *rules: str) -> list[Step]:
    """The steps of some rules."""
    return [step for step in leg.derivation.steps if step.rule in rules]


def speeds(moving: Motion) -> Iterator[Panel]:
    """The speed of each coordinate; those of one dimension in one panel."""
    for dimension, names in by_dimension(moving).items():
        scale = moving.scales.of(dimension / TIME)
        found = tuple(Curve(t.Sym(f"{n}_dot"), column(moving.real, f"{n}_dot", scale)) for n in names)
        yield panel(moving, moving.real, found[:MOST], scale)


def by_dimension(moving: Motion) -> Mapping[Dimension, list[str]]:
    """The coordinates that move (all, if none does) by what they measure."""
    found: dict[Dimension, list[str]] = {}
    moved = [n for n in moving.coordinates if any(state[f"{n}_dot"] for state in moving.whole.states)]
    for name in moved or moving.coordinates:
        found.setdefault(dimension_of(moving, name), []).append(name)
    return found


# --- forces


def forces(moving: Motion) -> Iterator[Panel]:
    """The unknown forces along the motion, marked where a contact is lost; then the unknown couples."""
    couples = couples_of(moving)
    for wanted, scale in ((False, moving.scales.of(FORCE)), (True, moving.scales.of(DIMENSIONS["torque"], "torque"))):
        found = curves(lambda leg, w=wanted: reactions(leg, couples, w), moving.way, scale)
        if every := list(found):
            shown = tuple(largest(every))
            made = panel(moving, moving.way, shown, scale, marks=marks_of(moving))
            yield replace(made, omitted=len(every) - len(shown))


def reactions(leg: Leg, couples: set[str], wanted: bool) -> Iterator[Step]:
    """The steps that state the unknown forces (or couples): along the motion where there are such, else for any state."""
    steps = {step.id: step for step in leg.derivation.steps}
    for name in leg.study.system.unknowns:
        step = steps.get(f"along.{name}") or steps.get(f"reaction.{name}")
        if step is not None and (name in couples) == wanted:
            yield step


def couples_of(moving: Motion) -> set[str]:
    """The unknowns that are couples and no forces."""
    systems = [leg.study.system for leg in moving.whole.legs]
    pushing = {n for s in systems for f in s.forces for n in f.unknowns if f.vector.derivative(n)}
    return {name for system in systems for name in system.unknowns} - pushing


def marks_of(moving: Motion) -> tuple[Mark, ...]:
    """Where the contact is lost, on the axis of the panel."""
    if moving.loss is None:
        return ()
    name, place = moving.loss
    leg = moving.way.legs[-1]
    _, places, _ = across(moving, Journey((leg,)))
    before, after = leg.moments.values(leg.reactions[name])[place - 1 : place + 1]
    share = before / (before - after) if before != after else 1.0
    there = places[place - 1] + share * (places[place] - places[place - 1])
    return (Mark(there, t.equation(t.Sym(name), t.ZERO), has_dot=True),)


# --- motion in time


def positions(moving: Motion, linear: str = "") -> Iterator[Panel]:
    """The motion in time; beside it, called `linear`, the small oscillation from the same start where there is one."""
    way = moving.real if moving.loss else moving.whole
    small = small_oscillations(moving, way)
    for dimension, names in by_dimension(moving).items():
        scale = moving.scales.of(dimension)
        node, times, own = over_time(moving, way)
        found = [Curve(t.Sym(name), column(way, name, scale)) for name in names[:MOST]]
        for curve, name in zip(tuple(found), names, strict=False):
            near = [value / scale.size for value in small.get(name, ())]
            if near and differs(near, curve.values):
                found.append(Curve(linear_name(name, linear, len(names)), near, "curve thin"))
        yield Panel(node, times, tuple(found), own, scale, marks=changes(moving))


def linear_name(name: str, linear: str, count: int) -> t.Node | str:
    """How the small oscillation of a coordinate is called."""
    return linear if count == 1 else t.Mul((t.Sym(name), t.Word(f"({linear})")))


def differs(one: Sequence[float], other: Sequence[float]) -> bool:
    """Would two curves be told apart?"""
    pairs = [(a, b) for a, b in zip(one, other, strict=True) if math.isfinite(a) and math.isfinite(b)]
    size = max((abs(b) for _, b in pairs), default=0.0) or 1.0
    return max((abs(a - b) for a, b in pairs), default=0.0) > 0.02 * size
