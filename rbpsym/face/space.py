"""The bodies of a problem as those of sympy.physics.mechanics."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from rbpsym.algebra import Scalar, Vector
from rbpsym.face.late import mechanics
from rbpsym.mechanics.study import Study
from rbpsym.mechanics.system import BodyState


class Space(NamedTuple):
    """An inertial frame, its fixed origin, and the bodies that move in it."""

    frame: Any
    origin: Any
    bodies: tuple[Any, ...]


def space(study: Study, written: Callable[[Scalar], Any]) -> Space:
    """The bodies with frames, points and velocities; `written` makes sympy of a value."""
    frame, origin = mechanics.ReferenceFrame("N"), mechanics.Point("O")
    origin.set_vel(frame, 0)

    def plane(vector: Vector) -> Any:
        return written(vector.x) * frame.x + written(vector.y) * frame.y

    def body(name: str, state: BodyState) -> Any:
        center = origin.locatenew(f"{name}_cm", plane(state.center))
        center.set_vel(frame, plane(state.velocity))
        if study.problem.body(name).shape.kind == "particle":
            return mechanics.Particle(name, center, written(state.mass))
        own = frame.orientnew(f"{name}_frame", "Axis", (written(state.pose.angle), frame.z))
        own.set_ang_vel(frame, written(state.omega) * frame.z)
        about_center = mechanics.inertia(own, 0, 0, written(state.moment))
        return mechanics.RigidBody(name, center, own, written(state.mass), (about_center, center))

    return Space(frame, origin, tuple(body(name, state) for name, state in study.system.bodies.items()))
