"""Whether the methods give the same accelerations."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.ideal import vanishes_on
from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.decide import scalars_equal
from rbpsym.equality.verdict import PROVED, Verdict, proved, undecided
from rbpsym.mechanics.study import Study


def agreement(study: Study, found: Mapping[str, Mapping[str, Scalar] | None]) -> dict[str, Verdict]:
    """For each method that applies: its accelerations against those of Newton's and Euler's equations."""
    known = study.dynamics.accelerations
    if known is None:
        return {}
    return {name: _same(study, values, known) for name, values in found.items() if values}


def _same(study: Study, values: Mapping[str, Scalar], known: Mapping[str, Scalar]) -> Verdict:
    verdict = Verdict(PROVED)
    for name, value in values.items():
        verdict = _equal(study, value, known[name])
        if verdict.kind is not PROVED:
            return verdict
    return verdict


def _equal(study: Study, value: Scalar, known: Scalar) -> Verdict:
    """Equality; where conditions tie the coordinates, only the states that satisfy them count."""
    found = scalars_equal(value, known, study.assumptions)
    ties = [tie.value for tie in study.ties]
    if found.kind is PROVED or not ties:
        return found
    if vanishes_on(value - known, ties):
        return proved("in the ideal of the conditions that tie the coordinates")
    return undecided("the coordinates are tied by conditions that were not solved in closed form")
