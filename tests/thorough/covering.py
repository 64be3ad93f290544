"""A plugin of pytest: which test comes into which function of the package, and how long each test takes.

    python -m pytest -p tests.thorough.covering tests      # writes build/covering.json

The mutants of the source are then put to the quickest tests that come through what was changed. What is derived once
for many tests counts for each of them, with its time: alone, each would derive it.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import pytest

from tests.library import derived

ROOT = Path(__file__).parents[2]
HOME = str(ROOT / "rbpsym") + "/"
INSTANCES = 8
ROOMS = ("tests/expr", "tests/decide", "tests/field", "tests/mechanics")
GOLDEN = "tests/golden/test_semantic.py::test_it_says"  # what every problem says: they come to most places
WHOLE = (*ROOMS, GOLDEN)
ONCE = ("derived", "derived_from", "checked_claims")  # of tests.library.derived: kept for all tests of a worker
OUT = Path(os.environ.get("RBPSYM_COVERING", ROOT / "build" / "covering.json"))


class Covering:
    """What is met, by test."""

    def __init__(self) -> None:
        self.met: dict[str, list[str]] = {}
        self.seconds: dict[str, float] = {}
        self.names: dict[object, str | None] = {}
        self.seen: set[object] = set()
        self.lent = 0.0  # seconds that another test has spent for this one
        for name in ONCE:
            setattr(derived, name, self._remembered(getattr(derived, name)))

    def _remembered(self, function):
        """The cached function, for whose first call each later one counts as well."""
        first: dict[object, tuple[set[object], float]] = {}

        def call(key):
            if key in first:
                seen, seconds = first[key]
                self.lent += seconds
            else:
                outer, self.seen, begun, lent = self.seen, set(), time.perf_counter(), self.lent
                try:
                    function(key)
                finally:
                    seen, self.seen = self.seen, outer
                first[key] = seen, time.perf_counter() - begun + self.lent - lent
            self.seen |= seen
            return function(key)

        return call

    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        """Of a test with many instances only some are timed, spread over all (but where they are all quick)."""
        kinds: dict[str, list[pytest.Item]] = {}
        for item in items:
            kinds.setdefault(item.nodeid.partition("[")[0], []).append(item)
        kept = {
            id(item)
            for kind, found in kinds.items()
            for item in (found if kind.startswith(WHOLE) else found[:: -(-len(found) // INSTANCES)])
        }
        config.hook.pytest_deselected(items=[item for item in items if id(item) not in kept])
        items[:] = [item for item in items if id(item) in kept]

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item):
        self.seen, self.lent = set(), 0.0

        def called(frame, event, arg):
            self.seen.add(frame.f_code)

        begun = time.perf_counter()
        sys.settrace(called)
        try:
            return (yield)
        finally:
            sys.settrace(None)
            self.seconds[item.nodeid] = round(time.perf_counter() - begun + self.lent, 4)
            for code in self.seen:
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
