"""Which tests go to one worker of pytest-xdist: those of one statement, so that it is derived once and not once in each.

A test whose parameters name a problem, an example or a system belongs to it, in whatever module it stands. The tests of
teaching belong together, since they share the plans of worksheets; of the others, those of a module. Tests that take
long and share nothing are dealt out singly, and first.
"""

from __future__ import annotations

import re
from collections import OrderedDict
from pathlib import Path

from xdist.scheduler import LoadScopeScheduling

ROOT = Path(__file__).parents[1]
SINGLY = (
    "tests/oracles/test_random_systems.py",
    "tests/thorough/",
    "tests/teaching/test_scale",
    "tests/teaching/test_library_papers.py",
    "tests/cli/test_notes_whole.py",
    "tests/claims/test_along.py",
    "tests/mutants/",
)
TOGETHER = ("tests/teaching/", "tests/golden/test_semantic.py::test_it_says_what_it_said[worksheets-")
STATEMENTS = ("derivations/*/*.toml", "docs/examples/*/*.toml", "tests/proof/systems/*.toml")


def _names() -> re.Pattern[str]:
    """Names of the library, and of other statements with their folder ("systems/incline", "shapes-rod")."""
    found = []
    for path in (path for pattern in STATEMENTS for path in ROOT.glob(pattern)):
        ships = path.relative_to(ROOT).parts[0] == "derivations"
        found.append(re.escape(path.stem) if ships else f"{path.parent.name}[-/]{re.escape(path.stem)}")
    longest_first = "|".join(sorted(set(found), key=lambda name: (-len(name), name)))
    return re.compile(rf"(?<![^\[\-/])(?:{longest_first})(?![^\]\-/ ])")


NAMES = _names()


def group(test: str) -> str:
    """The group of a test by its id."""
    module, _, parameters = test.partition("[")
    if test.startswith(SINGLY):  # tests of one module with one parameter share what they are about
        return f"{module.partition('::')[0]}[{parameters}" if parameters else test
    if test.startswith(TOGETHER):
        return TOGETHER[0]
    named = NAMES.search(f"[{parameters}") if parameters else None
    return named[0].replace("/", "-") if named else module.partition("::")[0]


class ByStatement(LoadScopeScheduling):
    """Deals out the tests group by group."""

    def _split_scope(self, nodeid: str) -> str:
        return group(nodeid)

    def _assign_work_unit(self, node) -> None:
        if not any(self.assigned_work.values()):  # nothing is dealt out yet
            sizes = {name: len(tests) for name, tests in self.workqueue.items()}
            first = sorted(sizes, key=lambda name: (not name.startswith(SINGLY), name != TOGETHER[0], -sizes[name], name))
            self.workqueue = OrderedDict((name, self.workqueue[name]) for name in first)
        super()._assign_work_unit(node)
