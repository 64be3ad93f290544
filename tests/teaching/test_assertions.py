"""Questions that assert something of a system are asked where it is proved; each phrase asserts, or does not."""

from __future__ import annotations

import pytest

from rbpsym.teaching.targets import targets
from rbpsym.teaching.wording import ASSERTIONS, teaching_phrases
from tests.library.derived import unsimulated

NARRATION = """ask.choose ask.number ask.formula ask.compare ask.place ask.fill-in ask.order ask.find-the-slip ask.signs
ask.explain hint compare.doubled compare.shape compare.welded compare.free compare.first compare.second compare.same
compare.one compare.other shape signs principle rubric solution paper remark feedback exports reader"""


def _kind(key: str) -> str:
    parts = key.split(".")
    stems = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next((stem for stem in stems if stem in ASSERTIONS or stem in NARRATION.split()), "")


def test_there_is_no_third_kind() -> None:
    assert not set(ASSERTIONS) & set(NARRATION.split())
    for language in ("en", "es"):
        assert not [key for key in teaching_phrases(language) if not _kind(key)]
    for told in (*ASSERTIONS, *NARRATION.split()):
        assert any(f"{key}.".startswith(f"{told}.") for key in teaching_phrases("es")), told


@pytest.mark.parametrize(("name", "asked"), [("rod-pendulum", True), ("rod-with-damper", False)])
def test_a_period_is_asked_for_where_there_is_one(name: str, asked: bool) -> None:
    """With a damper the displacement does not come back: no period, no “it swings about its stable position”."""
    found = unsimulated(name)
    assert any(target.kind == "frequency" for target in targets(found)) is asked


def test_a_place_of_loss_is_asked_for_where_it_comes_first() -> None:
    found = unsimulated("ball-off-sphere")
    lost = [target.step for target in targets(found) if target.kind == "loss"]
    assert all(found.step(step).phrase.startswith("contact.lost") for step in lost)
