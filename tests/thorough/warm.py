"""Mutants in forks of one process that has loaded the package and collected the tests: a mutant costs what its tests cost.

In the fork the code of the functions that differ is put in place of theirs. What a module makes when it is loaded (tables,
defaults, decorators) cannot be changed so; `altered` says None there, and the mutant is run in a fresh process instead.
"""

from __future__ import annotations

import ast
import functools
import gc
import importlib
import os
import resource
import signal
import sys
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from inspect import CO_OPTIMIZED
from pathlib import Path
from types import CodeType, FunctionType

import pytest

from tests.thorough.sites import Site

NOT_PLACED = 4
PAIRS = list[tuple[CodeType, CodeType]]


def altered(home: Path, site: Site) -> PAIRS | None:
    """Each function that a mutant changes, its code before and after; None where more than functions is changed."""
    path = home / site.file
    text = path.read_text(encoding="utf-8")
    if site.function.split(".")[0] in _called_when_loaded(ast.parse(text)):
        return None
    old, new = (compile(source, str(path), "exec", dont_inherit=True) for source in (text, site.mutated(text)))
    found: PAIRS = []
    return found if _gathered(old, new, found) else None


def _called_when_loaded(node: ast.AST) -> set[str]:
    """The names that are called outside of functions: what comes of it is there before a mutant is."""
    found = {node.func.id} if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else set()
    inner = (c for c in ast.iter_child_nodes(node) if not isinstance(c, (ast.FunctionDef, ast.Lambda)))
    return found.union(*map(_called_when_loaded, inner))


def _gathered(old: CodeType, new: CodeType, found: PAIRS) -> bool:
    is_function = bool(old.co_flags & CO_OPTIMIZED)
    if is_function and old != new:
        found.append((old, new))
    if not is_function and _own(old) != _own(new):
        return False
    inner = [[c for c in code.co_consts if isinstance(c, CodeType)] for code in (old, new)]
    return len(inner[0]) == len(inner[1]) and all(_gathered(a, b, found) for a, b in zip(*inner, strict=True))


def _own(code: CodeType) -> tuple:
    return code.co_code, code.co_names, [repr(c) for c in code.co_consts if not isinstance(c, CodeType)]


@dataclass(frozen=True)
class Loaded:
    """What a process has loaded of the package: its functions by their place in the source, and what remembers values."""

    functions: Mapping[tuple, list[FunctionType]]
    caches: list

    def change(self, pairs: PAIRS) -> bool:
        """The changed code stands where functions had theirs, and nothing is remembered; False if none of them is loaded."""
        found = [(function, new) for old, new in pairs for function in self.functions.get(_place(old), ())]
        for function, new in found:
            function.__code__ = new
        for cached in self.caches:
            cached.cache_clear()
        return bool(found) or not pairs


def loaded(home: Path) -> Loaded:
    """To be called before the garbage collector is told to freeze what there is: it lists nothing of that."""
    functions: dict[tuple, list[FunctionType]] = {}
    for one in gc.get_objects():
        if type(one) is FunctionType and one.__code__.co_filename.startswith(str(home)):
            functions.setdefault(_place(one.__code__), []).append(one)
    caches = [one for one in gc.get_objects() if isinstance(one, functools._lru_cache_wrapper)]
    return Loaded(functions, [one for one in caches if str(one.__module__).startswith(("rbpsym", "tests"))])


def _place(code: CodeType) -> tuple:
    """What tells a piece of code from all others (they do not compare as equal once one has run)."""
    return code.co_filename, code.co_qualname, code.co_firstlineno, next(iter(code.co_positions()), None)


class Server:
    """A plugin of pytest that puts each mutant to its tests where pytest would run all of them."""

    def __init__(self, scratch: Path, ways: Iterable, limit: int, told: Callable) -> None:
        self.scratch, self.ways, self.limit, self.told = scratch, ways, limit, told
        self.in_child = False

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        items = {item.nodeid: item for item in session.items}
        sick: set[str] = set()
        session.config.pluginmanager.unregister(name="terminalreporter")
        for site, _ in self.ways:
            importlib.import_module("rbpsym." + site.file.removesuffix(".py").replace("/", "."))
        self.loaded = loaded(self.scratch)
        gc.collect()
        gc.freeze()
        for site, chosen in self.ways:
            begun = time.perf_counter()
            pairs = altered(self.scratch / "rbpsym", site) or []
            while True:
                tests = [test for test in chosen() if test in items and test not in sick]
                result, failed = self._in_a_fork([items[test] for test in tests], pairs) if tests else ("no tests", "")
                if result != "killed" or not failed or self._in_a_fork([items[failed]], [])[0] == "survived":
                    break
                sick.add(failed)
            self.told(site, result, failed, len(tests), time.perf_counter() - begun)
        return True

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if self.in_child and report.failed:
            (self.scratch / "failed.txt").write_text(report.nodeid, encoding="utf-8")
            os._exit(1)

    def _in_a_fork(self, items: list[pytest.Item], pairs: PAIRS) -> tuple[str, str]:
        (self.scratch / "failed.txt").write_text("", encoding="utf-8")
        child = os.fork()
        if not child:
            try:
                self._run(items, pairs)
            finally:
                os._exit(3)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        failed = (self.scratch / "failed.txt").read_text(encoding="utf-8")
        return {0: "survived", NOT_PLACED: "not placed", -signal.SIGXCPU: "time"}.get(code, "killed"), failed

    def _run(self, items: list[pytest.Item], pairs: PAIRS) -> None:
        self.in_child = True
        resource.setrlimit(resource.RLIMIT_CPU, (self.limit, self.limit + 10))
        with open(os.devnull, "w") as nothing:
            os.dup2(nothing.fileno(), 1)
            os.dup2(nothing.fileno(), 2)
        if not self.loaded.change(pairs):
            os._exit(NOT_PLACED)
        for item, following in zip(items, [*items[1:], None], strict=True):
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        os._exit(0)


def serve(scratch: Path, tests: Iterable[str], ways: Iterable, limit: int, told: Callable, quiet: Iterable[str]) -> None:
    """In a fork of this process: the tests are collected once, and each mutant is told with what came of it."""
    child = os.fork()
    if child:
        os.waitpid(child, 0)
        return
    code = 1
    try:
        os.chdir(scratch)
        sys.dont_write_bytecode = True
        sys.path[:] = [str(scratch), *(p for p in sys.path if p not in ("", str(Path(__file__).parents[2])))]
        for name in [n for n in sys.modules if n.split(".")[0] in ("tests", "rbpsym", "benchmarks")]:
            del sys.modules[name]
        files = sorted({test.partition("::")[0] for test in tests})
        code = int(pytest.main([*quiet, "--rootdir", str(scratch), *files], [Server(scratch, ways, limit, told)]))
    finally:
        os._exit(code)
