"""How fast equality decides the table of tests/equality, and how sympy.simplify does on some of it.

Run: python benchmarks/equality.py [--sympy]. Times are of `equal` alone, trees already read.
"""

from __future__ import annotations

import signal
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from rbpsym.equality.decide import equal
from rbpsym.equality.verdict import PROVED
from tests.equality.rows import Row, table

LIMIT = 20  # seconds for sympy
HARD = (
    "double pendulum: two textbook forms", "double pendulum: second equation", "a contest problem",
    "heptagon", "Jacobi coordinates", "a triple product of tangents", "denested", "speed by half angles",
    "Lagrange's interpolation", "half angle", "secant plus tangent", "cosine at the loss of contact",
)  # fmt: skip


def decided(row: Row) -> tuple[bool, float]:
    """Whether the verdict is the expected one, and the time in milliseconds."""
    left, right = row.sides
    assumptions = row.assumptions
    start = time.perf_counter()
    verdict = equal(left, right, assumptions)
    return verdict.kind is row.verdict, 1e3 * (time.perf_counter() - start)


def run() -> None:
    """Print rows, wrong verdicts, median and slowest."""
    import rbpsym.algebra.sympy_bridge as bridge

    bridge._ring(2)  # the import of sympy is paid once, not by a row
    results = [(row, *decided(row)) for row in table()]
    times = sorted(ms for _, _, ms in results)
    wrong = [row for row, right, _ in results if not right]
    print(f"rows {len(results)}, wrong {len(wrong)}, median {statistics.median(times):.2f} ms, max {times[-1]:.1f} ms")
    for row in wrong:
        print("WRONG", row.left, "=", row.right, f"[{row.assuming}]", row.verdict)
    for row, _, ms in sorted(results, key=lambda item: -item[2])[:8]:
        print(f"  {ms:7.1f} ms  {row.note}: {row.left} = {row.right}"[:150])


class TooLong(Exception):
    """sympy took longer than LIMIT."""


def _stop(*_: object) -> None:
    raise TooLong


def simplified(row: Row) -> str:
    """What sympy.simplify makes of left - right."""
    import sympy

    from rbpsym.equality.points import names_of  # noqa: F401  (the same names)

    positive = set(row.names) if row.assuming.strip() == "positive" else set()
    for part in row.assuming.split(";"):
        words = part.split()
        positive |= set(words[1:]) if words[:1] == ["positive"] else set()
        positive |= {words[2]} if words[:1] == ["0"] else set()
    names = {n: sympy.Symbol(n, **({"positive": True} if n in positive else {"real": True})) for n in row.names}
    known = {"ln": sympy.log, "abs": sympy.Abs, **names}
    difference = sympy.sympify(row.left.replace("^", "**"), locals=known) - sympy.sympify(row.right, locals=known)
    signal.signal(signal.SIGALRM, _stop)
    signal.alarm(LIMIT)
    start = time.perf_counter()
    try:
        found = "0" if sympy.simplify(difference) == 0 else "not 0"
    except TooLong:
        found = "no answer"
    finally:
        signal.alarm(0)
    return f"{found} in {time.perf_counter() - start:.2f} s"


def compare() -> None:
    """sympy.simplify on rows that are true."""
    for row in table():
        if row.note in HARD and row.verdict is PROVED:
            print(f"  ours {decided(row)[1]:6.1f} ms   simplify: {simplified(row):22s} {row.note}")


if __name__ == "__main__":
    run()
    if "--sympy" in sys.argv:
        compare()
