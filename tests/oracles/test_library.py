"""What is asserted of the motions of the library is what the simulation shows, at seeded parameter sets.

Forces, works and speeds along the motion, the first loss of contact or grip and its place, the end of each phase, rest at
equilibria. Two sets a problem here; the thorough tier takes twenty, and follows each motion to its end.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.library.derived import FOLLOWED, derived
from tests.oracles.compare import Findings, each, findings
from tests.oracles.conftest import DRAWS, MISSING, SETS

pytestmark = pytest.mark.heavy

KNOWN = json.loads((Path(__file__).parent / "not_compared.json").read_text(encoding="utf-8"))
FEW, SHORT = 2, 8.0
# What is known to be told and not so; each is somebody's to mend, and the table is to be empty.
OPEN: dict[str, set[str]] = {}


def put_to_the_test(name: str, sets: int, longest: float, record) -> Findings:
    """The findings on a problem, told in the report of the run."""
    found = findings(derived(name).study, sets, longest)
    record(SETS, found.sets)
    record(DRAWS, dict(found.redrawn))
    for what, reason in found.missing.items():
        record(MISSING, (f"{name}: {what}", reason))
    return found


def new_gaps(name: str, found: Findings) -> set[str]:
    """What could not be compared and is not known for that."""
    return {f"{what}: {reason}" for what, reason in found.missing.items()} - set(KNOWN.get(name, ()))


def wrong(name: str, found: Findings) -> list[str]:
    """What is told and not so, but for what is known."""
    return [line for what, line in zip(found.wrong(), each(found), strict=True) if what not in OPEN.get(name, ())]


@pytest.mark.parametrize("name", FOLLOWED)
def test_the_motion_is_that_of_the_simulation(name, record_property):
    found = put_to_the_test(name, FEW, SHORT, record_property)
    assert found.sets and found.compared
    assert not wrong(name, found)
    assert not new_gaps(name, found)
