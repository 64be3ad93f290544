"""Whatever a problem file says: it is derived, or refused with a sentence (exit codes 0, 1, 2; never 70)."""

from __future__ import annotations

import pytest

from tests.thorough.mutated import fault, mutant

FEW, MANY, A_BATCH = 75, 5075, 100
SIMULATED = 10  # of so many mutants one is simulated as well


def faults(seeds: range) -> dict[int, str]:
    return {seed: found for seed in seeds if (found := fault(mutant(seed), simulation=seed % SIMULATED == 0))}


@pytest.mark.parametrize("first", range(0, FEW, A_BATCH // 4))
def test_some(first: int) -> None:
    assert not faults(range(first, first + A_BATCH // 4))


@pytest.mark.thorough
@pytest.mark.parametrize("first", range(FEW, MANY, A_BATCH))
def test_many(first: int) -> None:
    assert not faults(range(first, first + A_BATCH))
