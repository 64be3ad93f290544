"""How long the commands take, as multiples of `python -c "import sympy"` in the same run.

    python benchmarks/commands.py [rounds]

The rounds go through all commands in turn, so that what else the machine does hits all alike. Exit
code 1 if a command is over its bound.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parents[1]
RBPSYM = ("-m", "rbpsym")
MEASURE = "import sympy"

# command -> at most this many times the measure
COMMANDS: dict[str, tuple[tuple[str, ...], float]] = {
    MEASURE: (("-c", "import sympy"), 1.0),
    "--help": ((*RBPSYM, "--help"), 0.7),
    "list": ((*RBPSYM, "list"), 0.7),
    "solve --json --no-simulation": ((*RBPSYM, "solve", "sliding-ladder", "--json", "--no-simulation"), 3.0),
    "solve --json": ((*RBPSYM, "solve", "sliding-ladder", "--json"), 6.0),
    "derive": ((*RBPSYM, "derive", "sliding-ladder"), 4.0),
    "notes of the paper, LaTeX": ((*RBPSYM, "notes", "paper", "--format", "tex"), 8.0),
    "notes of the paper, PDF": ((*RBPSYM, "notes", "paper", "--format", "pdf"), 10.0),
    "notes of the paper, all": ((*RBPSYM, "notes", "paper"), 12.0),
}


def seconds(arguments: tuple[str, ...], folder: str) -> float:
    """Wall time of one run; SystemExit if it does not end well."""
    begun = time.perf_counter()
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, *arguments], cwd=folder, env=environment, capture_output=True, check=False)
    if done.returncode:
        raise SystemExit(f"{' '.join(arguments)}: exit code {done.returncode}\n{done.stderr.decode()}")
    return time.perf_counter() - begun


def main(rounds: int) -> int:
    """Measure, print the table; 1 if something is over its bound."""
    times: dict[str, list[float]] = {name: [] for name in COMMANDS}
    with tempfile.TemporaryDirectory(prefix="rbpsym-bench-") as folder:
        for turn in range(rounds + 1):
            for name, (arguments, _) in COMMANDS.items():
                found = seconds(arguments, folder)
                if turn:  # the first round warms the caches
                    times[name].append(found)
    measure = median(times[MEASURE])
    print(f"{'':<30} {'seconds':>8} {'ratio':>7} {'bound':>6}")
    over = 0
    for name, (_, bound) in COMMANDS.items():
        ratio = median(times[name]) / measure
        over += ratio > bound
        told = "OVER" if ratio > bound else ""
        print(f"{name:<30} {median(times[name]):8.3f} {ratio:6.1f}× {bound:5.1f}× {told}".rstrip())
    return int(over > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 5))
