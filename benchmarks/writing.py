"""How long writing takes: all formats of the paper's course as a multiple of its derivation, one page as one of sympy.

    python benchmarks/writing.py [rounds]

Exit code 1 if something is over its bound. Each round is a process of its own, as a user starts it: the course
is derived (with the numerical oracle, as `rbpsym notes` does it), then made a document and written in
every format. Beside it `python -c "import sympy"` and `rbpsym notes sliding-ladder --format html`. Times are those
of the processor, for a machine that others use too; the least of the rounds is taken, since what disturbs a
round only adds to it.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ALL_FORMATS = 2.0  # derivations of the course
ONE_PAGE = 4.0  # imports of sympy
# beamer is LaTeX here: what pdflatex takes for it is not ours
FORMATS = ("tex", "beamer", "pdf", "html", "ipynb", "md", "docx")


def timed(work: Callable[[], object]) -> tuple[float, object]:
    """Seconds of the processor in this process, and what came of it."""
    begun = time.process_time()
    found = work()
    return time.process_time() - begun, found


def one_round() -> dict[str, float]:
    """Seconds of the derivation and of each writer in this process, which has done nothing before."""
    from rbpsym.courses import derive_course
    from rbpsym.document.notes import course_notes
    from rbpsym.document.writers import writer
    from rbpsym.document.writers.markdown import markdown_files
    from rbpsym.statement.course import load_course
    from rbpsym.statement.library import course_files

    course, own = load_course(course_files()["paper"]), {}
    own["derivation"], derived = timed(lambda: derive_course(course))
    own["document"], document = timed(lambda: course_notes(derived, plots=True))
    for name in FORMATS:
        write = (lambda d: markdown_files(d, "x")) if name == "md" else writer(name)
        own[name], _ = timed(lambda: write(document))  # noqa: B023
    return own


def writing(rounds: int) -> dict[str, float]:
    """The least seconds of each part, each round in a process of its own."""
    found = [json.loads(process([__file__, "round"])[1]) for _ in range(rounds)]
    return {name: min(own[name] for own in found) for name in found[0]}


def process(arguments: list[str]) -> tuple[float, bytes]:
    """Processor time of one run and what it printed; SystemExit if it does not end well."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # as where it is installed: compiled once
    before = of_children()
    done = subprocess.run([sys.executable, *arguments], env=environment, capture_output=True, check=False)
    if done.returncode:
        raise SystemExit(f"{' '.join(arguments)}: exit code {done.returncode}\n{done.stderr.decode()}")
    return of_children() - before, done.stdout


def of_children() -> float:
    """Processor time of all processes that were started from here and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def page(rounds: int) -> tuple[float, float]:
    """Seconds of importing sympy, and of writing the page of one problem."""
    with tempfile.TemporaryDirectory(prefix="rbpsym-bench-") as folder:
        notes = ["-m", "rbpsym", "notes", "sliding-ladder", "--format", "html", "-o", folder]
        found = [(process(["-c", "import sympy"])[0], process(notes)[0]) for _ in range(rounds + 1)][1:]
    return min(sympy for sympy, _ in found), min(own for _, own in found)


def main(rounds: int) -> int:
    """Measure, print the tables; 1 if something is over its bound."""
    times = writing(rounds)
    whole = times.pop("derivation")
    print(f"{'derivation of the course':<26} {whole:7.3f} s")
    for name, seconds in times.items():
        print(f"{name:<26} {seconds:7.3f} s  ratio {seconds / whole:.2f}")
    total = sum(times.values()) / whole
    print(f"{'all formats':<26} {sum(times.values()):7.3f} s  ratio {total:.2f} (bound {ALL_FORMATS})")
    sympy, own = page(rounds + 2)
    print(f"{'import sympy':<26} {sympy:7.3f} s")
    print(f"{'one page of HTML':<26} {own:7.3f} s  ratio {own / sympy:.2f} (bound {ONE_PAGE})")
    over = ["all formats"] * (total > ALL_FORMATS) + ["one page"] * (own > ONE_PAGE * sympy)
    print("over the bound: " + ", ".join(over) if over else "all within their bounds")
    return 1 if over else 0


if __name__ == "__main__":
    if sys.argv[1:] == ["round"]:
        print(json.dumps(one_round()))
    else:
        sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 3))
