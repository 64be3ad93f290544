"""Which tests a mutant is put to: those that come through what was changed, as `covering` saw them, and newer ones."""

from __future__ import annotations

import json
import random
import re
from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

from tests.thorough.sites import Site

ENOUGH = 25.0  # seconds of tests for a mutant, as they were timed with tracing
ALIKE = 3  # instances of one test
MOST = 160
NOT_ASKED = ("tests/architecture", "tests/thorough")  # they see that the text changed, not what it does


@dataclass(frozen=True)
class Table:
    """What `covering` wrote."""

    tests: list[str]
    seconds: list[float]
    met: Mapping[str, list[int]]

    def of(self, site: Site) -> list[int]:
        """The tests that come through the function; for what stands in no function, through the module."""
        name = site.function
        while name:
            found = self.met.get(f"{site.file}::{name}")
            if found:
                return found
            name = name.rpartition(".")[0].removesuffix(".<locals>")
        return sorted({k for key, found in self.met.items() if key.startswith(f"{site.file}::") for k in found})

    def chosen(self, site: Site, source: random.Random, likely: Mapping[str, int]) -> list[str]:
        """Those that killed others of the file, some of each kind of test, the quickest first, then others at random."""
        every = [k for k in self.of(site) if not self.tests[k].startswith(NOT_ASKED)]
        every.sort(key=lambda k: (-likely.get(self.tests[k], 0), self.seconds[k]))
        kinds: Counter[str] = Counter()
        first, rest = [], []
        for k in every:
            kind = self.tests[k].partition("[")[0]
            kinds[kind] += 1
            (first if kinds[kind] <= ALIKE else rest).append(k)
        source.shuffle(rest)
        found, spent = [], 0.0
        for k in (*first, *rest):
            if spent + self.seconds[k] <= ENOUGH or not found:
                found.append(k)
                spent += self.seconds[k]
            if len(found) == MOST:
                break
        return [self.tests[k] for k in found]


def table(paths: list[Path]) -> Table:
    """The tables of several runs as one; of a test that was met twice the last run counts."""
    tests: dict[str, float] = {}
    met: dict[str, set[str]] = {}
    for path in paths:
        content = json.loads(path.read_text(encoding="utf-8"))
        tests |= dict(zip(content["tests"], content["seconds"], strict=True))
        for name, found in content["met"].items():
            met.setdefault(name, set()).update(content["tests"][k] for k in found)
    number = {test: k for k, test in enumerate(tests)}
    return Table(list(tests), list(tests.values()), {n: sorted(number[t] for t in found) for n, found in met.items()})


def newcomers(scratch: Path, tests: Collection[str]) -> Mapping[str, list[str]]:
    """By changed file, tests that the table does not know in files that import it: some of each kind."""
    found: dict[str, list[str]] = {}
    for path, group in groupby(sorted(tests), key=lambda test: test.partition("::")[0]):
        kinds = [list(same) for _, same in groupby(group, key=lambda test: test.partition("[")[0])]
        text = (scratch / path).read_text(encoding="utf-8")
        for module, names in re.findall(r"^ *from rbpsym\.?([\w.]*) import ([\w, ]+)", text, re.M):
            for name in (module, *(f"{module}.{name.split()[0]}" for name in names.split(",") if name.strip())):
                chosen = (test for same in kinds for test in same[:ALIKE])
                found.setdefault(name.replace(".", "/") + ".py", []).extend(chosen)
    return {name: list(dict.fromkeys(group))[:MOST] for name, group in found.items()}
