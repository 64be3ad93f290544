"""How fast equality decides the table of tests/decide, and how sympy.simplify does on some of it.

Run: python benchmarks/equality.py [--sympy]. Times are of `equal` alone, trees already read; the
import of sympy is paid before. Exit 1 if a verdict is wrong or a target is missed.
"""

from __future__ import annotations

import signal
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from rbpsym.decide.equal import equal
from rbpsym.decide.verdict import PROVED
from tests.decide.rows import Row, table

MEDIAN, SLOWEST = 2.0, 200.0  # milliseconds
LIMIT = 20  # seconds for sympy
HARD = (
    "double pendulum: two textbook forms", "double pendulum: second equation", "a contest problem",
    "heptagon", "Jacobi coordinates", "a triple product of tangents", "denested", "speed by half angles",
    "Lagrange's interpolation", "half angle", "secant plus tangent", "cosine at the loss of contact",
    "speed of a pendulum by half angles", "released at theta_0", "two antiderivatives of the secant",
    "difference of roots", "heptadecagon", "one wave for two", "a pendulum below its start",
)  # fmt: skip


def decided(row: Row) -> tuple[bool, float]:
    """Whether the verdict is the expected one, and the time in milliseconds."""
    left, right = row.sides
    assumptions = row.assumptions
    start = time.perf_counter()
    verdict = equal(left, right, assumptions)
    return verdict.kind is row.verdict, 1e3 * (time.perf_counter() - start)


def run() -> bool:
    """Print rows, wrong verdicts, median and slowest; whether all targets are met."""
    import rbpsym.field.sympy_bridge as bridge

    bridge._ring(2)  # the import of sympy is paid once, not by a row
    results = [(row, *decided(row)) for row in table()]
    times = sorted(ms for _, _, ms in results)
    wrong = [row for row, right, _ in results if not right]
    median = statistics.median(times)
    print(f"rows {len(results)}, wrong {len(wrong)}, median {median:.2f} ms, max {times[-1]:.1f} ms")
    for row in wrong:
        print("WRONG", row.left, "=", row.right, f"[{row.assuming}]", row.verdict)
    for row, _, ms in sorted(results, key=lambda item: -item[2])[:8]:
        print(f"  {ms:7.1f} ms  {row.note}: {row.left} = {row.right}"[:150])
    return not wrong and median <= MEDIAN and times[-1] <= SLOWEST


class TooLong(Exception):
    """sympy took longer than LIMIT."""


def _stop(*_: object) -> None:
    raise TooLong


def _positive(row: Row) -> set[str]:
    """The names that sympy may take for positive."""
    found: set[str] = set()
    for part in row.assuming.split(";"):
        words = part.split()
        if words[:1] == ["positive"]:
            found |= set(words[1:] or row.names)
        elif words[:2] == ["0", "<"]:
            found.add(words[2])
    return found


def simplified(row: Row) -> tuple[str, float]:
    """What sympy.simplify makes of left - right, and the time in milliseconds."""
    import sympy

    positive = _positive(row)
    names = {n: sympy.Symbol(n, **({"positive": True} if n in positive else {"real": True})) for n in row.names}
    known = {"ln": sympy.log, "abs": sympy.Abs, **names}
    difference = sympy.sympify(row.left, locals=known) - sympy.sympify(row.right, locals=known)
    signal.signal(signal.SIGALRM, _stop)
    signal.alarm(LIMIT)
    start = time.perf_counter()
    try:
        found = "0" if sympy.simplify(difference) == 0 else "not 0"
    except TooLong:
        found = "no answer"
    finally:
        signal.alarm(0)
    return found, 1e3 * (time.perf_counter() - start)


def compare() -> None:
    """sympy.simplify on rows that are true: what it finds, and how many times slower it is."""
    failures = count = 0
    for row in table():
        if row.note in HARD and row.verdict is PROVED:
            ours, (found, theirs) = decided(row)[1], simplified(row)
            print(f"  {theirs / ours:8.0f} x  ours {ours:6.1f} ms   simplify {theirs:8.0f} ms: {found:9s}  {row.note}")
            count, failures = count + 1, failures + (found != "0")
    print(f"simplify does not find {failures} of {count}")


if __name__ == "__main__":
    good = run()
    if "--sympy" in sys.argv:
        compare()
    sys.exit(0 if good else 1)
