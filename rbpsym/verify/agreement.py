"""Whether the methods give the same accelerations."""

from __future__ import annotations

from collections.abc import Mapping

from rbpsym.algebra.scalar import Scalar
from rbpsym.equality.decide import scalars_equal
from rbpsym.equality.verdict import PROVED, Verdict
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
        verdict = scalars_equal(value, known[name], study.assumptions)
        if verdict.kind is not PROVED:
            return verdict
    return verdict
