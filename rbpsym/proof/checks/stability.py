"""Checks of what is said of the stability of a position of rest, from the equations expanded anew."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from rbpsym.decide.equal import compare
from rbpsym.decide.signs import sign
from rbpsym.decide.verdict import Verdict, proved, undecided
from rbpsym.field import NOTHING, UNITY, Scalar, derivative, symbol, total
from rbpsym.proof.checks.of_steps import same, weakest
from rbpsym.proof.checks.oscillations import (
    RATE,
    Matrix,
    coefficients,
    divides,
    given,
    held,
    minors,
    near_place,
    positive,
    routh_conditions,
    singular,
    still,
)
from rbpsym.proof.checks.places import under
from rbpsym.proof.context import Context
from rbpsym.proof.expansion import Nearby
from rbpsym.proof.step import Step


def stability_said(context: Context, step: Step) -> Verdict:
    """What is said of the stability of a place (`data`: "at", "proved", "factors", "tied")."""
    context = under(context, step)
    return SAID[step.data["proved"]](context, step, near_place(context, step))


def _symmetric(context: Context, *matrices: Matrix) -> list[Verdict]:
    pairs = ((m[i][j], m[j][i]) for m in matrices for i in range(len(m)) for j in range(i))
    return [same(context, a, b) for a, b in pairs]


def _minimum(context: Context, step: Step, near: Nearby) -> Verdict:
    """The stiffness is positive; the forces at rest have a potential; nothing but loss is added to it (Lagrange-Dirichlet)."""
    signs = [positive(context, step, minor) for minor in minors(held(context, step, near.pull))]
    study = context.study
    names, rates = study.system.independent, study.system.scope.rates
    forces = [-still(context, row, dict.fromkeys(study.system.accelerations, NOTHING)) for row in study.motion_rows]
    slopes = [[_along(context, force, speed) for speed in study.system.speeds] for force in forces]
    pairs = zip(names, study.dynamics.mass_matrix, strict=True)
    kinetic = total(rates[a] * rates[b] * m / 2 for a, row in pairs for b, m in zip(names, row, strict=True))
    gained = context.rate_of(kinetic) - study.power_balance
    gained = gained - total(rates[name] * force for name, force in zip(names, forces, strict=True))
    loss = compare(gained, NOTHING, context.assumptions, strict=False)
    return weakest([*signs, *_symmetric(context, near.pull, slopes), loss])


def _along(context: Context, force: Scalar, speed: str) -> Scalar:
    """The slope of a force as one coordinate moves, those that are tied to it included."""
    rates = context.study.system.scope.rates
    ways = ((name, derivative(rates[name], speed)) for name in context.study.system.coordinates)
    return total(derivative(force, name) * part for name, part in ways if part)


def _asymptotic(context: Context, step: Step, near: Nearby) -> Verdict:
    """All factors but λ have roots with negative real parts; λ comes once for each arbitrary coordinate."""
    letter, product = symbol(RATE), UNITY
    for powers in step.data["factors"]:
        product = product * total(part * letter**k for k, part in enumerate(reversed(powers)))
    arbitrary = sum(name not in step.data["at"] for name in context.study.system.independent)
    whole, own = coefficients(singular(near, letter)), coefficients(product * letter**arbitrary)
    pairs = zip(whole, own, strict=True)
    found = [same(context, a * own[0], b * whole[0]) for a, b in pairs]
    needed = [value for powers in step.data["factors"] for value in (powers[0], *routh_conditions(powers))]
    return weakest([*found, *(positive(context, step, value) for value in needed)])


def _unstable(context: Context, step: Step, near: Nearby) -> Verdict:
    """A factor (or the whole) has a negative condition of Hurwitz; or the stiffness, which is symmetric as is the
    damping, is negative in some direction: then M λ² + C λ + K is singular for some real λ > 0."""
    known = [coefficients(singular(near, symbol(RATE))), *step.data["factors"]]
    for powers in known:
        tests = powers[1:] if not all(powers) else routh_conditions(powers)
        if any(sign(value * powers[0], given(context, step)).kind == "negative" for value in tests):
            return divides(context, near, powers)
    stiffness = held(context, step, near.pull)
    lowest = [*(row[k] for k, row in enumerate(stiffness)), *minors(stiffness)]
    if any(sign(value, given(context, step)).kind == "negative" for value in lowest):
        return weakest([*_symmetric(context, near.pull, near.drag), proved("negative stiffness")])
    return undecided("no direction in which the displacement grows was found")


SAID: Mapping[str, Callable[[Context, Step, Nearby], Verdict]] = {
    "minimum": _minimum,
    "asymptotic": _asymptotic,
    "unstable": _unstable,
    "open": lambda context, step, near: proved("nothing is said of the stability"),
}
