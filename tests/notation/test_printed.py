"""No format prints a sample formula in another way than it did when it was last looked at (see `printed`)."""

import json

import pytest

from tests.notation.printed import FORMATS, KEPT, printed

NOW, WAS = printed(), json.loads(KEPT.read_text(encoding="utf-8"))


@pytest.mark.parametrize("kind", FORMATS)
def test_it_is_printed_as_it_was(kind):
    changed = {name: (WAS[kind].get(name), now) for name, now in NOW[kind].items() if WAS[kind].get(name) != now}
    assert not changed, "look at these, then: python -m tests.notation.printed"
    assert WAS[kind].keys() <= NOW[kind].keys()
