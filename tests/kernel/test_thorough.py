"""Steps spoilt on purpose by the hundred: coqc refuses each. `make thorough`."""

from __future__ import annotations

import re

import pytest

from rbpsym.kernel.certify import written
from rbpsym.kernel.coqc import with_prelude
from rbpsym.kernel.rocq import REFUSED
from tests.kernel.spoiling import attempted, draws
from tests.kernel.test_certify import PAPER, needs_coqc
from tests.library.derived import unsimulated

SEED, COUNT = 500, 63
OTHERS = ("superball", "double-atwood", "rod-in-bowl", "half-disk-rocking")  # signs by gaps, least values, roots, π


@pytest.mark.thorough
@needs_coqc
@pytest.mark.parametrize("name", [*PAPER, *OTHERS])
def test_coqc_refuses_hundreds_that_are_spoilt(name: str) -> None:
    whole = written(unsimulated(name))
    lemmas = draws(whole, seed=SEED, count=COUNT)
    told = with_prelude([attempted(whole, lemmas)])[0].stdout
    assert len(lemmas) == COUNT
    assert set(re.findall(rf"^{REFUSED}(\S+)", told, re.MULTILINE)) == {lemma.name for lemma in lemmas}
