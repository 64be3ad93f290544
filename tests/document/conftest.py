"""These tests are of what comes after a derivation: in one worker a problem that ships is derived once for all of them."""

import sys

import pytest

import rbpsym
from tests.library.derived import derive_once

PUBLIC = rbpsym.derive  # asked for before it is replaced: the package keeps what it finds first


@pytest.fixture(autouse=True)
def _derived_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules["rbpsym.derive"], "derive", derive_once)
