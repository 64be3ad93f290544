"""Values, verdicts, keys and numbers are those that were taken, or changed with a reason that is written down.

`python -m tests.golden.refresh` tells what changed, and records it.
"""

import pytest

from tests.golden import kept
from tests.golden.semantic import GONE, KINDS, changes, same

RECORDS = [(kind, name) for kind, (names, _) in KINDS.items() for name in names()]


@pytest.mark.parametrize(("kind", "name"), RECORDS, ids=lambda part: part)
def test_it_says_what_it_said(kind, name):
    changed = kept.unexplained(kind, name)
    told = "\n".join(f"{kind}/{name}/{key}\n  old: {old}\n  new: {new}" for key, (old, new) in changed.items())
    assert not changed, f"{len(changed)} changes without a reason (see tests/golden/refresh.py):\n{told}"


def test_what_was_taken_is_still_there():
    taken = {(p.stem.split("-")[0], name) for p in kept.TAKEN.glob("*.json") for name in kept._file(p)}
    assert taken <= set(RECORDS)


def test_each_reason_is_told():
    told = kept.TOLD.read_text(encoding="utf-8")
    for path in kept.CHANGED.glob("*.json"):
        why = kept._file(path)["why"]
        assert why.strip() and f"- `{path.stem}`: {why}" in told, path.stem


def test_a_form_does_not_count_and_a_value_does():
    assert same("a*(b + c)/b", "a + a*c/b") and same(True, True) and same(None, None)
    assert same("cos(theta)**2", "1 - sin(theta)**2")
    assert not same("a", "-a") and not same(True, None) and not same("I", "J") and not same("", "a = b")
    old, new = {"x": "a + b", "steps.one": "PROVED"}, {"x": "b + a", "steps.two": "UNDECIDED", "y": "c"}
    assert changes(old, new) == {"steps.one": ("PROVED", GONE), "steps.two": (GONE, "UNDECIDED")}
