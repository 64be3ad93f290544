"""A plugin of pytest: which test comes into which function of the package, and how long each test takes.

    python -m pytest -p tests.thorough.covering tests      # writes build/covering.json

The mutants of the source are then put to the quickest tests that come through what was changed.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
HOME = str(ROOT / "rbpsym") + "/"
INSTANCES = 8
QUICK = ("tests/notation", "tests/equality", "tests/algebra", "tests/mechanics")
OUT = Path(os.environ.get("RBPSYM_COVERING", ROOT / "build" / "covering.json"))


class Covering:
    """What is met, by test."""

    def __init__(self) -> None:
        self.met: dict[str, list[str]] = {}
        self.seconds: dict[str, float] = {}
        self.names: dict[object, str | None] = {}

    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        """Of a test with many instances only some are timed, spread over all (but where they are all quick)."""
        kinds: dict[str, list[pytest.Item]] = {}
        for item in items:
            kinds.setdefault(item.nodeid.partition("[")[0], []).append(item)
        kept = {
            id(item)
            for kind, found in kinds.items()
            for item in (found if kind.startswith(QUICK) else found[:: -(-len(found) // INSTANCES)])
        }
        config.hook.pytest_deselected(items=[item for item in items if id(item) not in kept])
        items[:] = [item for item in items if id(item) in kept]

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        seen: set[object] = set()

        def called(frame, event, arg):
            seen.add(frame.f_code)

        begun = time.perf_counter()
        sys.settrace(called)
        try:
            return (yield)
        finally:
            sys.settrace(None)
            self.seconds[item.nodeid] = round(time.perf_counter() - begun, 4)
            for code in seen:
                name = self._name(code)
                if name is not None:
                    self.met.setdefault(name, []).append(item.nodeid)

    def _name(self, code) -> str | None:
        if code not in self.names:
            own = code.co_filename.startswith(HOME)
            self.names[code] = f"{code.co_filename[len(HOME):]}::{code.co_qualname}" if own else None
        return self.names[code]

    def pytest_sessionfinish(self) -> None:
        """Tests are written as numbers."""
        OUT.parent.mkdir(exist_ok=True, parents=True)
        tests = list(self.seconds)
        number = {test: place for place, test in enumerate(tests)}
        met = {name: [number[test] for test in found] for name, found in sorted(self.met.items())}
        content = {"tests": tests, "seconds": list(self.seconds.values()), "met": met}
        OUT.write_text(json.dumps(content), encoding="utf-8")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(Covering(), "covering")
