"""No lemma holds for want of a case: what it is proved from is true together, in numbers along a motion."""

from __future__ import annotations

import pytest

from rbpsym.errors import NotApplicable
from rbpsym.kernel.certify import written
from tests.kernel.motion import Motion
from tests.library.derived import NAMES, unsimulated


@pytest.mark.heavy(of=8)
@pytest.mark.parametrize("name", NAMES)
def test_the_premises_of_lemmas_are_true_of_a_motion(name: str) -> None:
    """A proof from premises that nothing satisfies would be worth nothing."""
    whole = written(unsimulated(name))
    try:
        motion = Motion(whole.source)
    except NotApplicable as why:
        pytest.skip(str(why))
    premises = {claim: key for lemmas in whole.lemmas.values() for one in lemmas for key, claim in one.premises.items()}
    plain = {claim: key for claim, key in premises.items() if not claim.given and not claim.var}
    assert [key for claim, key in plain.items() if not motion.holds(claim)] == []
