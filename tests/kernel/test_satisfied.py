"""No lemma holds for want of a case: what it is proved from is true together, in numbers along a motion."""

from __future__ import annotations

import pytest

from rbpsym.expr import tree as t
from rbpsym.kernel.certify import written
from tests.kernel.motion import Motion
from tests.library.derived import FOLLOWED, problem, unsimulated


@pytest.mark.heavy(of=24)
@pytest.mark.parametrize("name", [name for name in FOLLOWED if problem(name).coordinates])
def test_the_premises_of_lemmas_are_true_of_a_motion(name: str) -> None:
    """A proof from premises that nothing satisfies would be worth nothing."""
    whole = written(unsimulated(name))
    motion = Motion(whole.source)
    premises = {claim: key for lemmas in whole.lemmas.values() for one in lemmas for key, claim in one.premises.items()}
    plain = {claim: key for claim, key in premises.items() if not claim.given and not claim.var}
    told = {claim: key for claim, key in plain.items() if not motion.open & (t.names(claim.left) | t.names(claim.right))}
    assert [key for claim, key in told.items() if not motion.holds(claim)] == []
