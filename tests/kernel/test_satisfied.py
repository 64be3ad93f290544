"""No lemma holds for want of a case: what it is proved from is true together, in numbers along a motion."""

from __future__ import annotations

import pytest

from rbpsym.expr import tree as t
from rbpsym.frozen import replace
from rbpsym.kernel.certify import written
from rbpsym.proof.step import Derivation
from tests.kernel.motion import Motion
from tests.library.derived import FOLLOWED, problem, unsimulated


def untrue(part: Derivation) -> list[str]:
    """The names of premises that are not true of a motion of this phase."""
    whole = written(part)
    motion = Motion(whole.source)
    premises = {claim: key for lemmas in whole.lemmas.values() for one in lemmas for key, claim in one.premises.items()}
    plain = {claim: key for claim, key in premises.items() if not claim.given and not claim.var}
    told = {claim: key for claim, key in plain.items() if not motion.open & (t.names(claim.left) | t.names(claim.right))}
    assert len(told) > 20
    return [key for claim, key in told.items() if not motion.holds(claim)]


@pytest.mark.heavy(of=24)
@pytest.mark.parametrize("name", [name for name in FOLLOWED if problem(name).coordinates])
def test_the_premises_of_lemmas_are_true_of_a_motion(name: str) -> None:
    """A proof from premises that nothing satisfies would be worth nothing."""
    whole = unsimulated(name)
    for part in (whole, *(phase.derivation for phase in whole.phases)):
        assert untrue(part) == []


def test_a_changed_premise_is_not_true() -> None:
    """The other sign on a side that does not vanish is seen."""
    whole = written(unsimulated("sliding-ladder"))
    motion = Motion(whole.source)
    premises = {claim for lemmas in whole.lemmas.values() for one in lemmas for claim in one.premises.values()}
    equal = [claim for claim in premises if claim.kind in ("equal", "rate") and abs(motion.side(claim.right)).max() > 0.1]
    assert len(equal) > 20
    assert not [claim for claim in equal if motion.holds(replace(claim, right=t.neg(claim.right)))]
