"""The small oscillation about the stable equilibrium that a motion passes, from the same start."""

from __future__ import annotations

import numpy as np

from rbpsym.document.plots.following import Leg, at
from rbpsym.document.plots.motion import Journey, Motion
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.numeric.integration import followed


def small_oscillations(moving: Motion, way: Journey) -> dict[str, np.ndarray]:
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
