"""Every answer that a test of questions is given keeps the law of answers (see tests.ask.law)."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

import pytest

from rbpsym.ask import asking, concluded, parameters
from rbpsym.ask.found import Answer
from tests.ask import law, told


@pytest.fixture(autouse=True)
def _lawful(monkeypatch: pytest.MonkeyPatch) -> None:
    for module, name in ((parameters, "concluded"), (concluded, "concluded"), (asking, "answer")):
        monkeypatch.setattr(module, name, _kept(getattr(module, name)))


def _kept(make: Callable[..., Answer]) -> Callable[..., Answer]:
    @wraps(make)
    def lawful(*args, **words):
        found = make(*args, **words)
        law.keep(found)
        told.keep(found)
        return found

    return lawful
