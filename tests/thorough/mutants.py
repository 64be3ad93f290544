"""Mutants of the source, each put to the quickest tests that come through what was changed.

    python -m tests.thorough.mutants COVERING.json [--count 400] [--seed 1] [--log FILE] [--again]

Needs the table of `tests.thorough.covering`. Works in a copy of the tree; a mutant that outlasts its time of the
processor counts as killed. `EQUIVALENT` names those that change nothing that can be seen, with the reason; they are not
drawn. A log is gone on with: what is in it and still stands in the source is drawn first, and not run once more (with
`--again` what survived is).
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Collection, Mapping
from functools import partial
from itertools import islice
from pathlib import Path

from tests.thorough.choosing import NOT_ASKED, Table, newcomers, table
from tests.thorough.equivalent import EQUIVALENT
from tests.thorough.sites import Site, is_sound, sites
from tests.thorough.warm import altered, serve

ROOT = Path(__file__).parents[2]
# area: (share of the draw, patterns of its files)
AREAS: Mapping[str, tuple[int, tuple[str, ...]]] = {
    "field": (60, ("field/*.py", "present/*.py")),
    "verdicts": (60, ("decide/*.py",)),
    "mechanics": (90, ("mechanics/*.py",)),
    "steps and checkers": (80, ("proof/**/*.py", "chapters/**/*.py", "oracles/lagrange.py")),
    "readers": (50, ("expr/infix*.py", "expr/latex/*.py")),
    "printers": (
        60,
        (
            "typeset/*.py", "expr/glyphs.py",
            "pictures/figures/svg.py", "pictures/figures/tikz.py", "document/writers/word*.py",
            "teaching/exports/canvas.py",
        ),
    ),
    "ask": (60, ("ask/*.py",)),
}  # fmt: skip
LIMIT = 100  # seconds of the processor until a mutant counts as killed by time
QUIET = ("-p", "no:xdist", "-p", "no:cacheprovider", "-x", "--hypothesis-seed=0", "--no-header", "-W", "ignore")
PLAIN = ("-o", "addopts=--import-mode=importlib")
KILLED = ("killed", "time")


def drawn(count: int, seed: int, known: Collection[str] = (), home: Path = ROOT / "rbpsym") -> list[Site]:
    """Seeded mutants of all areas in turn, equivalents left out, those that are known already first; a key counts once.

    A mutant's place in the draw depends on its key only, so that a draw stays much the same while the source changes.
    """
    total, found = sum(share for share, _ in AREAS.values()), []
    for share, patterns in AREAS.values():
        files = sorted({path for pattern in patterns for path in home.glob(pattern)})
        every = {key(site): site for path in files for site in sites(home, str(path.relative_to(home)))}
        names = sorted(every.keys() - EQUIVALENT.keys(), key=lambda name: (name not in known, _place(seed, name)))
        sound = (every[name] for name in names if name in known or is_sound(home, every[name]))
        found += islice(sound, -(-count * share // total))
    return sorted(found, key=lambda site: _place(seed, key(site)))[:count]


def _place(seed: int, name: str) -> bytes:
    return hashlib.sha256(f"{seed} {name}".encode()).digest()


def key(site: Site) -> str:
    """What names a mutant even after lines have moved."""
    old, new = (" ".join(part.split()) for part in (site.old, site.new))
    return f"{site.file} {site.function}: {old} -> {new}"


# --- running


def copied() -> Path:
    """A copy of the tree, compiled."""
    import compileall

    scratch = Path(tempfile.mkdtemp(prefix="mutants-"))
    for name in ("rbpsym", "tests", "derivations", "docs", "templates", "benchmarks", "pyproject.toml"):
        source = ROOT / name
        skipped = shutil.ignore_patterns("__pycache__", ".hypothesis")
        shutil.copytree(source, scratch / name, ignore=skipped) if source.is_dir() else shutil.copy(source, scratch)
    compileall.compile_dir(scratch / "rbpsym", quiet=2)
    compileall.compile_dir(scratch / "tests", quiet=2)
    return scratch


def outcome(scratch: Path, site: Site, tests: list[str]) -> tuple[str, str]:
    """"killed", "survived", "time" (killed by it) or "no tests", and the test that failed; it passes without the mutant."""
    while tests:
        found, failed = _mutated(scratch, site, tests)
        if found != "killed" or not failed or _in_a_child(scratch, [failed])[0] == "survived":
            return found, failed
        tests = [test for test in tests if test != failed]
    return "no tests", ""


def _mutated(scratch: Path, site: Site, tests: list[str]) -> tuple[str, str]:
    target = scratch / "rbpsym" / site.file
    text = target.read_text(encoding="utf-8")
    compiled = list(target.parent.glob(f"__pycache__/{target.stem}.*.pyc"))
    kept = [(path, path.read_bytes()) for path in compiled]
    stat = target.stat()
    target.write_text(site.mutated(text), encoding="utf-8")
    for path in compiled:
        path.unlink()
    try:
        return _in_a_child(scratch, tests)
    finally:
        target.write_text(text, encoding="utf-8")
        os.utime(target, ns=(stat.st_atime_ns, stat.st_mtime_ns))
        for path, content in kept:
            path.write_bytes(content)


def _in_a_child(scratch: Path, tests: list[str]) -> tuple[str, str]:
    """(outcome, the test that failed), in a process forked from here, where the packages of others are loaded already."""
    (scratch / "asked.txt").write_text("\n".join(tests), encoding="utf-8")
    (scratch / "failed.txt").write_text("", encoding="utf-8")
    child = os.fork()
    if not child:
        _child(scratch)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    failed = (scratch / "failed.txt").read_text(encoding="utf-8")
    return {0: "survived", -signal.SIGXCPU: "time"}.get(code, "killed"), failed


class _Noting:
    """Writes down which test failed."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def pytest_runtest_logreport(self, report) -> None:
        if report.failed:
            self.path.write_text(report.nodeid, encoding="utf-8")


def _child(scratch: Path) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 10))
    os.chdir(scratch)
    sys.dont_write_bytecode = True
    sys.path[:] = [str(scratch), *(p for p in sys.path if p not in ("", str(ROOT)))]
    for name in [n for n in sys.modules if n.split(".")[0] in ("tests", "rbpsym", "benchmarks")]:
        del sys.modules[name]
    with open(os.devnull, "w") as nothing:
        os.dup2(nothing.fileno(), 1)
        os.dup2(nothing.fileno(), 2)
        import pytest

        code = 1
        try:
            noting = [_Noting(scratch / "failed.txt")]
            code = int(pytest.main([*QUIET, "--rootdir", str(scratch), f"@{scratch / 'asked.txt'}"], noting))
        finally:
            os._exit(code)


def collected(scratch: Path) -> set[str]:
    """The tests that there are."""
    import subprocess

    asked = [sys.executable, "-m", "pytest", "-p", "no:xdist", "-p", "no:cacheprovider", "--co", "-q", "tests", *PLAIN]
    told = subprocess.run(asked, cwd=scratch, capture_output=True, text=True, check=False).stdout
    return {line.strip() for line in told.splitlines() if "::" in line}


def run(found: list[Site], known: Table, log: Path, seed: int) -> None:
    """The outcome of each mutant is written down as it comes (a line of JSON each)."""
    import hypothesis  # noqa: F401  (loaded once for all children)
    import numpy  # noqa: F401
    import scipy.integrate  # noqa: F401
    import sympy  # noqa: F401

    scratch = copied()
    there = collected(scratch)
    print(f"{len(found)} mutants, {len(there)} tests, {len(there & {*known.tests})} of them in the table", flush=True)

    news = newcomers(scratch, {test for test in there - {*known.tests} if not test.startswith(NOT_ASKED)})

    def chosen(site: Site) -> list[str]:
        likely = Counter(row["by"] for row in rows(log) if row.get("by") and row["key"].startswith(f"{site.file} "))
        source = random.Random(f"{seed} {key(site)}")
        return [*news.get(site.file, ()), *(test for test in known.chosen(site, source, likely) if test in there)]

    def told(site: Site, result: str, failed: str, count: int, seconds: float) -> None:
        row = {"mutant": str(site), "key": key(site), "outcome": result, "by": failed, "tests": count}
        with log.open("a", encoding="utf-8") as file:
            file.write(json.dumps({**row, "seconds": round(seconds, 1)}) + "\n")
        if result not in KILLED:
            print(f"{result}: {site}", flush=True)

    try:
        cold = [site for site in found if altered(scratch / "rbpsym", site) is None]
        warm = [site for site in found if site not in cold]
        asked = {test for site in warm for test in (*chosen(site), *known.chosen(site, random.Random(0), {}))} & there
        serve(scratch, asked, [(site, partial(chosen, site)) for site in warm], LIMIT, told, QUIET)
        for site in cold:
            begun, tests = time.perf_counter(), chosen(site)
            told(site, *outcome(scratch, site, tests), len(tests), time.perf_counter() - begun)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)


def rows(log: Path) -> list[dict]:
    """What is written down, a mutant once: the last that was told of it."""
    lines = log.read_text(encoding="utf-8").splitlines() if log.exists() else []
    return list({row["key"]: row for row in map(json.loads, lines)}.values())


def main(arguments: list[str]) -> int:
    reader = argparse.ArgumentParser(description=__doc__)
    reader.add_argument("covering", nargs="+", type=Path)
    reader.add_argument("--count", type=int, default=400)
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--log", type=Path, default=ROOT / "build" / "mutants.jsonl")
    reader.add_argument("--again", action="store_true", help="what survived is run once more")
    asked = reader.parse_args(arguments)
    asked.log.parent.mkdir(exist_ok=True)
    known = {row["key"]: row["outcome"] for row in rows(asked.log)}
    found = drawn(asked.count, asked.seed, known)
    done = {name for name, result in known.items() if result in KILLED or not asked.again}
    run([site for site in found if key(site) not in done], table(asked.covering), asked.log, asked.seed)
    names = {key(site) for site in found}
    counts = Counter(row["outcome"] for row in rows(asked.log) if row["key"] in names)
    killed = sum(counts[result] for result in KILLED)
    print(f"{killed}/{len(found)} mutants killed ({100 * killed / max(1, len(found)):.1f} %), {dict(counts)}")
    return int(killed < 0.9 * len(found))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
