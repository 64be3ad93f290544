"""Steps spoilt on purpose by the hundred: coqc refuses each. `make thorough`."""

from __future__ import annotations

import pytest

from rbpsym.kernel.certify import written
from tests.kernel.spoiling import come_through, draws
from tests.kernel.test_certify import PAPER, needs_coqc
from tests.library.derived import unsimulated

SEED, COUNT = 500, 63
OTHERS = ("superball", "double-atwood", "rod-in-bowl", "half-disk-rocking")  # signs by gaps, least values, roots, π


@pytest.mark.thorough
@needs_coqc
@pytest.mark.parametrize("name", [*PAPER, *OTHERS])
def test_coqc_refuses_hundreds_that_are_spoilt(name: str) -> None:
    whole = written(unsimulated(name))
    steps = draws(whole, seed=SEED, count=COUNT)
    assert len(steps) == COUNT and not come_through(whole, steps)
