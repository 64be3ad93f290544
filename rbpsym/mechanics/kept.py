"""Momenta that the forces leave as they are all along a motion.

The angular momentum of a set of bodies about a fixed point (O, a pivot, a point of a fixed line that is touched) is kept where
the torques of the outer forces about it vanish on the motion. Kleppner & Kolenkow 7.2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rbpsym.algebra import NOTHING, Scalar, Vector, cartesian, depends_on, is_zero, short, substitute
from rbpsym.mechanics.constraints import JOINTS
from rbpsym.mechanics.elimination import solve_linear
from rbpsym.mechanics.energy import orbital_momentum, spin_momentum
from rbpsym.mechanics.geometry import components
from rbpsym.mechanics.sets import connected_sets
from rbpsym.mechanics.state import State, at_start
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import Force


@dataclass(frozen=True)
class Kept:
    """L of a set of bodies about a fixed point, `label` "" where that has no name: of the outer forces `silent` ones have no
    torque about it, those that `cancel` have torques whose sum vanishes on the motion."""

    bodies: tuple[str, ...]
    label: str
    where: Vector
    value: Scalar
    silent: tuple[Force, ...]
    cancel: tuple[Force, ...]


def angular_momenta(study: Study) -> Iterator[Kept]:
    """Those that are kept, change with some speed and hold no coordinate; of small sets first."""
    system = study.system
    for bodies in connected_sets(tuple(system.bodies), {(force.on, force.by) for force in system.forces}):
        outer = [force for force in system.forces if force.on in bodies and force.by not in bodies]
        for label, where in _places(study):
            states = [system.bodies[name] for name in bodies]
            value = short(sum((orbital_momentum(s, where) + spin_momentum(s) for s in states), NOTHING))
            is_uniform = not any(depends_on(value, name) for name in (*system.coordinates, "t"))
            if not is_uniform or not any(depends_on(value, speed) for speed in system.speeds):
                continue
            turns = [(force, short(force.torque(where))) for force in outer]
            if is_zero(study.on_motion(sum((turn for _, turn in turns), NOTHING))):
                silent, cancel = (tuple(f for f, turn in turns if bool(turn) is told) for told in (False, True))
                yield Kept(bodies, label, where, value, silent, cancel)


def _places(study: Study) -> Iterator[tuple[str, Vector]]:
    """Fixed points with names, and of each fixed line that is touched the point next to O."""
    yield from study.origins.items()
    for element in study.problem.constraints:
        for _, line in JOINTS[element.kind].fixed_lines(element):
            a, b, c = components(line)
            yield "", cartesian(a * c, b * c)


def until_no_slip(study: Study, slip: Scalar, end: State) -> tuple[Kept, ...]:
    """The angular momenta that, with a slip that has gone, give all speeds at the end of a phase; () if they do not."""
    wanted, start = study.system.speeds, at_start(study)
    begun = {f"{name}_dot": speed for name, speed in start.speeds.items()}
    rows, chosen = [substitute(slip, end.places)], []
    known = solve_linear(rows, wanted, keep_free=True)
    for kept in angular_momenta(study):
        row = kept.value - substitute(kept.value, begun)
        if any(depends_on(substitute(row, known.values), name) for name in known.free):
            rows, chosen = [*rows, row], [*chosen, kept]
            known = solve_linear(rows, wanted, keep_free=True)
    return () if known.free else tuple(chosen)
