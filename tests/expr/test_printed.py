"""No format prints a sample formula in another way than it did when it was last looked at (see `printed`)."""

import json

import pytest

from tests.expr.printed import FORMATS, KEPT, printed

WAS = json.loads(KEPT.read_text(encoding="utf-8"))


@pytest.mark.parametrize("kind", FORMATS)
def test_it_is_printed_as_it_was(kind):
    now = printed(kind)
    changed = {name: (WAS[kind].get(name), text) for name, text in now.items() if WAS[kind].get(name) != text}
    assert not changed, "look at these, then: python -m tests.expr.printed"
    assert WAS[kind].keys() <= now.keys()
