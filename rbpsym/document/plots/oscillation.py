"""The small oscillation about the stable equilibrium that a motion passes, from the same start."""

from __future__ import annotations

from itertools import pairwise

from rbpsym.document.plots.integrator import Rate, State, advance, solved
from rbpsym.document.plots.motion import Journey, Motion
from rbpsym.document.plots.trajectory import Numbers, Trajectory, at
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.mechanics.study import Study


def small_oscillations(moving: Motion, way: Journey) -> dict[str, list[float]]:
    """By coordinate its motion after the linear equations; empty where the motion is not one about an equilibrium."""
    study, moments = moving.derivation.study, way.legs[0].moments
    if len(way.legs) > 1 or moments.coordinates != study.system.independent:
        return {}
    near = (found for found in study.equilibria if found.stable and passes(moments, found))
    return next((followed(study, moments, found) for found in near), {})


def passes(moments: Trajectory, found: Equilibrium) -> bool:
    """Does the motion turn back, and does each coordinate pass its place of rest?"""
    if not moments.turns:
        return False
    for name, value in found.at.items():
        places, rest = [state[name] for state in moments.states], at(value, moments.states[0])
        if not min(places) - 1e-9 <= rest <= max(places) + 1e-9:
            return False
    return True


def followed(study: Study, moments: Trajectory, found: Equilibrium) -> dict[str, list[float]]:
    """M q̈ = -K δq - C q̇ with the derived matrices, at the moments of the motion."""
    names, first = moments.coordinates, moments.states[0]
    rest = {name: at(found.at[name], first) if name in found.at else first[name] for name in names}
    still = {**first, **rest, **{f"{name}_dot": 0.0 for name in names}}
    rate = linear_rate(found, still)
    state = (*(first[n] - rest[n] for n in names), *(first[f"{n}_dot"] for n in names))
    states = [state]
    for before, after in pairwise(moments.times):
        state = advance(rate, before, state, after - before) or state
        states.append(state)
    return {name: [rest[name] + state[k] for state in states] for k, name in enumerate(names)}


def linear_rate(found: Equilibrium, still: Numbers) -> Rate:
    """How fast δq and q̇ change; all matrices in numbers, at rest."""
    matrices = (found.inertia, found.linear.damping, found.stiffness)
    inertia, damping, stiffness = ([[at(v, still) for v in row] for row in m] for m in matrices)
    count = len(inertia)

    def rate(_: float, state: State) -> State:
        pairs = zip(stiffness, damping, strict=True)
        pulls = [-sum(a * b for a, b in zip((*k, *c), state, strict=True)) for k, c in pairs]
        return (*state[count:], *solved(inertia, pulls))

    return rate
