"""Friction: which way things slip at the start."""

from __future__ import annotations

from rbpsym.mechanics.contacts import meeting, slip_sense
from rbpsym.mechanics.geometry import Geometry, start_numbers
from rbpsym.mechanics.placing import locator
from rbpsym.mechanics.system import System


def geometry_of(system: System) -> Geometry:
    """The geometry of an assembled system, its states of motion included."""
    placed = {name: state.pose for name, state in system.bodies.items()}
    inertias = {name: state.inertia for name, state in system.bodies.items()}
    return Geometry(locator(system.problem, inertias, placed), placed, start_numbers(system.problem), system.bodies)


def slip_senses(system: System) -> dict[str, int]:
    """By constraint with kinetic friction: 1 if what touches slips forward at the start, else -1."""
    geometry = geometry_of(system)
    rough = [e for e in system.problem.constraints if e.values.get("coefficient") is not None]
    return {element.name: slip_sense(element, geometry, meeting(element, geometry)) for element in rough}
