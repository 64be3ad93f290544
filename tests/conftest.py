"""For all tests: where RBPSYM_REQUIRE_TOOLS is set, what would be skipped fails; what comes after a derivation derives once."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Generator
from itertools import count
from zlib import crc32

import pytest
from hypothesis import settings

import rbpsym
from rbpsym.ask import asking
from rbpsym.document import notes
from tests.library.derived import answers_to, derive_once

# The suite draws the same examples each time; --hypothesis-profile=random draws others (by its seed, in `make thorough`).
for name, is_steady in (("random", False), ("steady", True)):
    settings.register_profile(name, derandomize=is_steady, database=None, deadline=None, print_blob=True)
settings.load_profile("steady")
gc.disable()  # trees and polynomials are many and in no circles: after each tenth module is often enough

PUBLIC = rbpsym.derive  # asked for before it is replaced: the package keeps what it finds first
MODULES = count()  # that this worker went through
AFTER_DERIVING = {"cli", "document", "teaching"}  # rooms whose tests are of what comes after a derivation


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """A test that is skipped (for want of TeX, a browser, ...) proves nothing: .ci/run wants all of them."""
    report = yield
    if os.environ.get("RBPSYM_REQUIRE_TOOLS") and report.skipped and not hasattr(report, "wasxfail"):
        report.outcome = "failed"
        report.longrepr = f"{item.nodeid} was skipped, but RBPSYM_REQUIRE_TOOLS is set: {report.longrepr}"
    return report


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--one-of-each", action="store_true", help="of a test with parameters only the first")
    parser.addoption("--whole", action="store_true", help="heavy laws for all their parameters, as in `make thorough`")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """With --one-of-each the first of each test; else of heavy laws a part, the whole with --whole and where tests are named."""
    if config.getoption("--one-of-each"):
        first = {_law(item): item.nodeid for item in reversed(items)}
        kept = [item for item in items if item.nodeid in first.values()]
    elif config.getoption("--whole") or config.option.keyword or any("::" in argument for argument in config.args):
        return
    else:
        least = {_law(item): _draw(item) for item in sorted(items, key=_draw, reverse=True)}  # none goes without any
        kept = [item for item in items if (heavy := item.get_closest_marker("heavy")) is None
                or _draw(item) % heavy.kwargs.get("of", 3) == 0 or _draw(item) == least[_law(item)]]  # fmt: skip
    left = {*items} - {*kept}
    config.hook.pytest_deselected(items=[item for item in items if item in left])
    items[:] = kept


def _law(item: pytest.Item) -> str:
    return item.nodeid.partition("[")[0]


def _draw(item: pytest.Item) -> int:
    """A number by module and parameters: the heavy laws of a module look at the same problems, those of another at others."""
    module, _, parameters = item.nodeid.partition("::")
    return crc32(f"{module}[{parameters.partition('[')[2]}".encode())


@pytest.fixture(autouse=True)
def _once(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """In one worker a problem that ships is derived once for all tests of what comes after, its questions answered once."""
    for module in (asking, notes):
        monkeypatch.setattr(module, "own_answers", answers_to)
    if request.path.parent.name in AFTER_DERIVING:
        monkeypatch.setattr(sys.modules["rbpsym.derive"], "derive", derive_once)


@pytest.fixture(autouse=True, scope="module")
def _quiet_collector() -> None:
    """What earlier modules keep (derivations of the whole library) is no more looked through by the garbage collector.

    Otherwise a collection of seconds may fall into any test, also into one with a bound of time. To look for what to freeze
    takes long as well, so that it is done after each tenth module.
    """
    if next(MODULES) % 10 == 0:
        gc.collect()
        gc.freeze()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log):
    """What is of one statement goes to one worker (see tests.sharing)."""
    from tests.sharing import ByStatement

    return ByStatement(config, log) if config.getvalue("dist") == "load" else None
