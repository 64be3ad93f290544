"""The library: what it takes to derive each problem, and what is proved of it.

    python benchmarks/library.py [NAME ...]

For each problem its degrees of freedom, steps, proved and undecided ones, and the seconds to load and derive it
with and without the numerical oracle. Exit code 1 if a step is refuted, a method or an oracle disagrees,
or a bound is missed.
"""

from __future__ import annotations

import gc
import sys
import time
from dataclasses import dataclass
from statistics import median

from rbpsym.cli import SELDOM
from rbpsym.derive import derive
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

SLOWEST, TYPICAL = 10.0, 1.5  # seconds: of any problem, of the one in the middle
UNDECIDED = 0.02  # of all steps
CLOSE = 1e-8  # relative error of the simulation


@dataclass(frozen=True, slots=True)
class Row:
    """One problem: `seconds` to derive it without the simulation, `whole` with it."""

    name: str
    freedom: int
    steps: int
    proved: int
    undecided: int
    seconds: float
    whole: float
    error: float | None
    agrees: bool

    @property
    def is_fine(self) -> bool:
        """Does everything that should agree do so, and soon enough?"""
        right = self.agrees and self.proved + self.undecided == self.steps
        return right and self.error is not None and self.error <= CLOSE and self.whole <= SLOWEST


def row(name: str) -> Row:
    """Derive a problem twice: without and with the numerical oracle."""
    begun = time.perf_counter()
    derive(load_problem(problem_files()[name]), simulation=False)
    half = time.perf_counter()
    made = derive(load_problem(problem_files()[name]))
    end, found = time.perf_counter(), made.summary()
    error = found["simulation"] and found["simulation"]["max_relative_error"]
    agrees = found["methods_agree"] and found["lagrange"] == "PROVED"
    counts = (found["steps"], found["proved"], found["undecided"])
    return Row(name, len(made.study.system.independent), *counts, half - begun, end - half, error, agrees)


def line(it: Row) -> str:
    """A row of the table."""
    error = "none" if it.error is None else f"{it.error:.0e}"
    told = "" if it.is_fine else "  NOT FINE"
    return (
        f"{it.name:<36} {it.freedom:>7} {it.steps:>6} {it.proved:>7} {it.undecided:>10} "
        f"{it.seconds:>8.2f} {it.whole:>8.2f} {error:>8}{told}"
    )


def figures(rows: list[Row]) -> tuple[str, bool]:
    """The last line, and whether all bounds are kept."""
    steps, undecided = sum(it.steps for it in rows), sum(it.undecided for it in rows)
    middle, slowest = median(it.whole for it in rows), max(rows, key=lambda it: it.whole)
    fine = all(it.is_fine for it in rows) and undecided <= UNDECIDED * steps and middle <= TYPICAL
    text = (
        f"{len(rows)} problems, {steps} steps, {sum(it.proved for it in rows)} proved, {undecided} undecided "
        f"({100 * undecided / steps:.2g} %); median {middle:.2f} s, slowest {slowest.whole:.2f} s ({slowest.name})"
    )
    return text, fine


def main(names: list[str]) -> int:
    """Print the table; 1 if something is not as it should be."""
    gc.set_threshold(SELDOM)  # as the command does
    print(f"{'':<36} {'degrees':>7}{'':>27} {'seconds':>8} {'with':>8} {'error of':>8}")
    print(
        f"{'problem':<36} {'freedom':>7} {'steps':>6} {'proved':>7} {'undecided':>10} "
        f"{'':>8} {'simul.':>8} {'simul.':>8}"
    )
    row(names[0])  # warms the imports
    rows = []
    for name in names:
        rows.append(row(name))
        print(line(rows[-1]), flush=True)
    text, fine = figures(rows)
    print(text)
    return int(not fine)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:] or list(problem_files())))
