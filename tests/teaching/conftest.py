"""These tests are of what comes after a derivation: in one worker a problem that ships is derived once for all of them."""

import sys

import pytest

import rbpsym.derive  # noqa: F401  (the module; the name in the package is the function)
from tests.library.derived import derive_once


@pytest.fixture(autouse=True)
def _derived_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules["rbpsym.derive"], "derive", derive_once)
