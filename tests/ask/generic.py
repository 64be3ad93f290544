"""Questions that can be asked of any problem, made from its registry: forces, accelerations, speeds, energies, works."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from rbpsym.ask.asked import Asked
from rbpsym.errors import RbpsymError


def generic(asked: Asked) -> Iterator[str]:
    """The questions, in the order of the statement."""
    system, problem = asked.first.system, asked.problem
    for when in moments(asked):
        yield from (f"{name} {when}" for name in system.unknowns)
        for name in system.independent:
            yield from (f"{what} of {name} {when}" for what in ("speed", "acceleration"))
        for body in problem.body_names:
            yield f"velocity of {body}.cm {when}"
            yield f"acceleration of {body}.cm {when}"
            yield f"angular velocity of {body} {when}"
            yield f"angular momentum of {body} about O {when}"
        yield f"kinetic energy {when}"
    for name in system.unknowns:
        yield name
    for name in system.independent:
        yield f"speed of {name}"
        yield f"period of {name}"
    for force in dict.fromkeys(force.name for force in system.forces):
        yield f"work of {force}"
    for name in (phase.name for phase in problem.phases):
        yield f"time until {name}"
        yield f"energy lost when {name} begins"


def moments(asked: Asked) -> Iterator[str]:
    """The start, the places where contacts are lost, turning points, the beginnings of phases."""
    yield "at the start"
    with suppress(RbpsymError):
        yield from (f"where {loss.force} vanishes" for loss in asked.first.losses if loss.at)
    if len(asked.first.system.independent) == 1:
        yield "at the turning point"
    for name in (phase.name for phase in asked.problem.phases):
        yield f"just before {name}"
        yield f"when {name} begins"
