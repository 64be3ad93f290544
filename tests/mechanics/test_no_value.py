"""Where a force vanishes and something else has no value, nothing is said to be all."""

from __future__ import annotations

from rbpsym.decide.assumptions import Assumptions
from rbpsym.field.scalar import NOTHING, UNITY, symbol
from rbpsym.mechanics.events import Way, _on_way

X = symbol("x")
GIVEN = Assumptions({"x": "real"}, {"x": (NOTHING, UNITY * 2)})


def test_a_zero_beside_a_pole_is_open() -> None:
    way = Way("x", NOTHING, 1, X)
    whole = _on_way(way, {"N": UNITY - X}, [UNITY - X], GIVEN)
    assert whole.complete is True and [loss.at for loss in whole.found] == [{"x": UNITY}]
    doubtful = _on_way(way, {"N": UNITY - X}, [UNITY - X, UNITY / (UNITY - X)], GIVEN)
    assert doubtful.complete is None and not doubtful.found and "no value" in doubtful.reason
