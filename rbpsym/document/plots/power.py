"""The work of a force on a body as its power added up along the motion."""

from __future__ import annotations

import numpy as np

from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.document.plots.following import Leg
from rbpsym.document.plots.motion import Journey
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.study import Study


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
