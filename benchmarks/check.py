"""How long `rbpsym check` takes on the claims that ship, as multiples of `python -c "import sympy"`.

    python benchmarks/check.py [rounds]

Measured in turn: the import, a first run, a run with certificates, and a run with 200 further formulas.
Exit code 1 if something is over its bound.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parents[1]
CLAIMS = ROOT / "derivations" / "claims" / "paper.toml"
FURTHER = 200
SLOWEST = 0.2  # seconds a verdict
FURTHER_BOUND = 4.0  # imports of sympy: 1 s where that takes 0.25 s
BOUNDS = {"check": 4.0, "check again": 2.0}


def seconds(arguments: list[str]) -> float:
    """Wall time of one run; SystemExit if it does not end well."""
    begun = time.perf_counter()
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, *arguments], env=environment, capture_output=True, check=False)
    if done.returncode:
        told = done.stdout.decode()[-800:] + done.stderr.decode()
        raise SystemExit(f"{' '.join(arguments)}: exit code {done.returncode}\n{told}")
    return time.perf_counter() - begun


def further(folder: Path) -> Path:
    """The claims file with 200 more formulas: those that ship once more, under other names, with other numbers."""
    text = CLAIMS.read_text(encoding="utf-8").replace('"problems/', f'"{CLAIMS.parent}/problems/')
    blocks = [b for b in text.split("[[claim]]")[1:] if "defined here" not in b and 'id      = "s' not in b]
    more = [re.sub(r'id( +)= "', rf'id\1= "again-{k}-', block) for k in range(4) for block in blocks][:FURTHER]
    path = folder / "more.toml"
    path.write_text(text + "".join(f"[[claim]]{block}" for block in more), encoding="utf-8")
    return path


def runs(folder: Path) -> dict[str, list[str]]:
    """The commands by name."""
    check, cache = ["-m", "rbpsym", "check"], ["--cache", str(folder / "cache")]
    return {
        "import sympy": ["-c", "import sympy"],
        "check": [*check, str(CLAIMS), "--no-cache"],
        "check again": [*check, str(CLAIMS), *cache],
        "200 more": [*check, str(further(folder)), "--no-cache"],
    }


def slowest() -> float:
    """The longest verdict, from one run in this process."""
    sys.path.insert(0, str(ROOT))
    from rbpsym.verify.claims_cache import Certificates
    from rbpsym.verify.claims_loader import load_claims
    from rbpsym.verify.claims_run import check_claims

    file = load_claims(CLAIMS)
    list(check_claims(file, Certificates(None)))  # what is imported and assembled once is not counted
    return max(result.seconds for result in check_claims(file, Certificates(None)))


def main(rounds: int) -> int:
    """Measure, print the table; 1 if something is over its bound."""
    times: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory(prefix="rbpsym-bench-") as folder:
        commands = runs(Path(folder))
        for turn in range(rounds + 1):
            for name, arguments in commands.items():
                found = seconds(arguments)
                if turn:  # the first round warms the caches
                    times.setdefault(name, []).append(found)
    found = {name: median(values) for name, values in times.items()}
    measure, extra, longest = found["import sympy"], found["200 more"] - found["check"], slowest()
    over = [name for name, bound in BOUNDS.items() if found[name] > bound * measure]
    over += ["200 more"] * (extra > FURTHER_BOUND * measure) + ["a verdict"] * (longest > SLOWEST)
    for name, value in found.items():
        print(f"{name:<14} {value:7.3f} s  ratio {value / measure:.2f}")
    print(f"{FURTHER} more formulas: {extra:.2f} s, ratio {extra / measure:.2f} (bound {FURTHER_BOUND})")
    print(f"slowest verdict: {longest:.3f} s (bound {SLOWEST} s)")
    print("over the bound: " + ", ".join(over) if over else "all within their bounds")
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 5))
