"""Which curves a derivation has: each is a formula that one of its steps states, taken along its motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from rbpsym.algebra.evaluate import scalar
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.step import Derivation, Step
from rbpsym.document.plots.panel import Curve, Panel
from rbpsym.document.plots.scales import Scale, Scales, scales
from rbpsym.document.plots.trajectory import Trajectory, at, crossings, trajectory
from rbpsym.errors import NotApplicable, RbpsymError
from rbpsym.mechanics.phases import stages
from rbpsym.notation import tree as t
from rbpsym.quantities import ENERGY, FORCE, TIME, Dimension

MOST = 6  # curves in a panel


@dataclass(frozen=True)
class Motion:
    """A derivation with the numbers of its motion.

    `whole` are all moments, `way` those until it turns back for the first time.
    """

    derivation: Derivation
    scales: Scales
    whole: Trajectory

    @cached_property
    def way(self) -> Trajectory:
        """The moments over which forces, works and energies are shown."""
        return self.whole.until_turn()

    @property
    def is_single(self) -> bool:
        """Is there one coordinate, which the curves can be drawn over?"""
        return len(self.whole.coordinates) == 1

    @cached_property
    def loss(self) -> tuple[str, int] | None:
        """The first force that a contact loses on the way, and the moment behind it."""
        found = []
        along = self.derivation.study.reactions_along_motion or {}
        for loss in self.derivation.study.losses:
            places = list(crossings(self.way.values(along[loss.force]))) if loss.force in along else []
            found += [(places[0], loss.force)] if places else []
        return (min(found)[1], min(found)[0]) if found else None

    @cached_property
    def real(self) -> Trajectory:
        """The way as far as no contact is lost."""
        return self.way if self.loss is None else self.way.part(self.loss[1] + 1)


def motion(derivation: Derivation) -> Motion:
    """The motion of a derived problem in numbers, of its first phase. Raises NotApplicable where there is none."""
    found = scales(derivation.study.problem)
    return Motion(derivation, found, trajectory(derivation.study, found.numbers, phase_end(derivation, found)))


def phase_end(derivation: Derivation, found: Scales) -> float:
    """When the first phase ends; infinite if it is the only one. Raises NotApplicable if that has no closed form."""
    problem = derivation.study.problem
    if not problem.phases:
        return math.inf
    ending = stages(problem)[1].began.before.time
    if ending is None or not at(ending, found.numbers) > 0:
        raise NotApplicable("the end of the first phase is not known")
    return at(ending, found.numbers)


def across(moving: Motion, way: Trajectory) -> tuple[t.Node, list[float], Scale]:
    """What the curves are drawn over: the coordinate of a system whose speed it determines, else the time."""
    if not moving.is_single or not moving.derivation.study.squares:
        return over_time(moving, way)
    [name] = moving.whole.coordinates
    scale = moving.scales.of(dimension_of(moving, name))
    return t.Sym(name), [state[name] / scale.size for state in way.states], scale


def over_time(moving: Motion, way: Trajectory) -> tuple[t.Node, list[float], Scale]:
    """The time as what curves are drawn over."""
    scale = moving.scales.of(TIME)
    return t.Sym("t"), [time / scale.size for time in way.times], scale


def dimension_of(moving: Motion, name: str) -> Dimension:
    """The dimension of a coordinate."""
    return next(c.quantity.dimension for c in moving.derivation.study.problem.coordinates if c.name == name)


def stated(step: Step) -> tuple[t.Node, Scalar] | None:
    """The name and the value of a step that says “name = ... = value”."""
    if not isinstance(step.statement, t.Chain) or set(step.statement.ops) != {"="}:
        return None
    try:
        return step.statement.items[0], scalar(step.statement.items[-1])
    except RbpsymError:
        return None


def curves(steps: Iterable[Step], way: Trajectory, scale: Scale) -> Iterator[Curve]:
    """A curve for each step whose value has numbers all along the way."""
    for step in steps:
        found = stated(step)
        values = _values(found[1], way, scale) if found else []
        if values and sum(map(math.isfinite, values)) > len(values) / 2:
            yield Curve(found[0], values)


def _values(value: Scalar, way: Trajectory, scale: Scale) -> list[float]:
    try:
        return [number / scale.size for number in way.values(value)]
    except KeyError:
        return []


def works(moving: Motion) -> Iterator[Panel]:
    """Translational works with their sum, and rotational works with theirs."""
    scale = moving.scales.of(ENERGY)
    for half, letter in (("T", "T"), ("theta", "theta")):
        steps = [s for s in moving.derivation.steps if s.rule == "work_done" and s.id.startswith(f"done.{half}.")]
        found = [curve for curve in curves(steps, moving.real, scale) if any(abs(v) > 1e-12 for v in curve.values)]
        if not found:
            continue
        name = f"cal_W_{letter}"
        whole = [Curve(t.Sym(name), summed(found), "curve sum")] if 1 < len(found) < MOST else []
        yield panel(moving, moving.real, (*found[:MOST], *whole), scale)


def summed(found: Sequence[Curve]) -> list[float]:
    """The sum of curves place by place."""
    return [sum(values) for values in zip(*(curve.values for curve in found), strict=True)]


def panel(moving: Motion, way: Trajectory, found: tuple[Curve, ...], scale: Scale, marks=()) -> Panel:
    """A panel over what the motion is drawn over."""
    node, places, own = across(moving, way)
    return Panel(node, places, found, own, scale, marks=marks)


def energies(moving: Motion) -> Iterator[Panel]:
    """Kinetic and potential energies and their sum."""
    scale = moving.scales.of(ENERGY)
    steps = [s for s in moving.derivation.steps if s.rule in ("kinetic_energy", "potential", "conservation")]
    found = [
        Curve(curve.name, curve.values, "curve sum" if step.rule == "conservation" else "")
        for step in steps
        for curve in curves([step], moving.real, scale)
    ]
    if len(found) > 1:
        yield panel(moving, moving.real, tuple(found[: MOST + 1]), scale)


def speeds(moving: Motion) -> Iterator[Panel]:
    """The speed of each coordinate; those of one dimension in one panel."""
    kinds: dict[Dimension, list[str]] = {}
    for name in moving.whole.coordinates:
        kinds.setdefault(dimension_of(moving, name) / TIME, []).append(name)
    for dimension, names in kinds.items():
        scale = moving.scales.of(dimension)
        found = tuple(Curve(t.Sym(f"{n}_dot"), column(moving.real, f"{n}_dot", scale)) for n in names)
        yield panel(moving, moving.real, found, scale)


def column(way: Trajectory, name: str, scale: Scale) -> list[float]:
    """The numbers of a coordinate or speed."""
    return [state[name] / scale.size for state in way.states]


def forces(moving: Motion) -> Iterator[Panel]:
    """The unknown forces along the motion, marked where a contact is lost."""
    scale = moving.scales.of(FORCE)
    couples = couples_of(moving)
    steps = [s for s in moving.derivation.steps if s.phrase == "contact.along"]
    steps = [s for s in steps if getattr(s.statement.items[0], "name", "") not in couples]
    found = tuple(curves(steps, moving.way, scale))[:MOST]
    if found:
        yield panel(moving, moving.way, found, scale, marks=marks_of(moving))


def couples_of(moving: Motion) -> set[str]:
    """The unknowns that are couples and no forces."""
    system = moving.derivation.study.system
    forces = {name for force in system.forces for name in force.unknowns if force.vector.derivative(name)}
    return set(system.unknowns) - forces


def marks_of(moving: Motion) -> tuple[float, ...]:
    """Where the contact is lost, on the axis of the panel."""
    if moving.loss is None:
        return ()
    name, place = moving.loss
    _, places, _ = across(moving, moving.way)
    along = moving.derivation.study.reactions_along_motion[name]
    before, after = moving.way.values(along)[place - 1 : place + 1]
    share = before / (before - after) if before != after else 1.0
    return (places[place - 1] + share * (places[place] - places[place - 1]),)


def positions(moving: Motion, linear: str = "") -> Iterator[Panel]:
    """The motion in time; beside it, called `linear`, the small oscillation from the same start where there is one."""
    way = moving.real if moving.loss else moving.whole
    kinds: dict[Dimension, list[str]] = {}
    for name in moving.whole.coordinates:
        kinds.setdefault(dimension_of(moving, name), []).append(name)
    for dimension, names in kinds.items():
        scale = moving.scales.of(dimension)
        node, times, own = over_time(moving, way)
        found = [Curve(t.Sym(name), column(way, name, scale)) for name in names]
        small = small_oscillation(moving, way, scale) if moving.is_single else None
        found += [Curve(linear, small, "curve thin")] if small and differs(small, found[0].values) else []
        yield Panel(node, times, tuple(found), own, scale)


def differs(one: Sequence[float], other: Sequence[float]) -> bool:
    """Would two curves be told apart?"""
    size = max(map(abs, other)) or 1.0
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) > 0.01 * size


def small_oscillation(moving: Motion, way: Trajectory, scale: Scale) -> list[float] | None:
    """The motion of the linear equation about the stable equilibrium that the motion passes, from the same start."""
    [name] = moving.whole.coordinates
    if not way.turns:
        return None
    first, turn = way.states[0], way.states[way.turns[0]][name]
    for found in moving.derivation.study.equilibria:
        if not found.stable or len(found.frequencies_squared) != 1 or name not in found.at:
            continue
        rest, square = at(found.at[name], first), at(found.frequencies_squared[0], first)
        if min(first[name], turn) <= rest <= max(first[name], turn) and square > 0:
            pace, away, speed = math.sqrt(square), first[name] - rest, first[f"{name}_dot"]
            moments = [(math.cos(pace * time), math.sin(pace * time)) for time in way.times]
            return [(rest + away * c + speed / pace * s) / scale.size for c, s in moments]
    return None
