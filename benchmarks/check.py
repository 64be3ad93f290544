"""How long `rbpsym check` takes on the claims of the paper, as multiples of `python -c "import sympy"`.

    python benchmarks/check.py [rounds]

Measured in turn, in processor time, the least of all rounds: the import, a first run on the claims and on the paper
itself, a run with certificates, and a run with 200 further formulas. Then the longest verdict, of the claims and of
their mutants and rewrites. Exit code 1 if something is over its bound.
"""

from __future__ import annotations

import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CLAIMS = ROOT / "derivations" / "claims" / "paper.toml"
FURTHER = 200
SLOWEST = 0.2  # seconds a verdict
FURTHER_BOUND = 4.0  # imports of sympy: 1 s where that takes 0.25 s
BOUNDS = {"check": 4.0, "paper": 4.0, "check again": 2.0}
PAPER = r"\begin{equation}%s\end{equation}"


def seconds(arguments: list[str]) -> float:
    """Processor time of one run; SystemExit if it does not end well."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, *arguments], env=environment, capture_output=True, check=False)
    if done.returncode:
        told = done.stdout.decode()[-800:] + done.stderr.decode()
        raise SystemExit(f"{' '.join(arguments)}: exit code {done.returncode}\n{told}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def paper(folder: Path) -> Path:
    """A text that holds every formula of the claims file once, displayed with its label or in a sentence."""
    sys.path.insert(0, str(ROOT))
    from rbpsym.claims.loader import load_claims

    lines = []
    for claim in load_claims(CLAIMS).claims:
        latex = claim.printed.latex.strip() if claim.printed and not claim.says else ""
        name = "eqnarray" if r"\\" in latex else "equation"
        label = rf"\label{{{claim.label}}}" if claim.label else ""
        shown = rf"\begin{{{name}}}{label}{latex}\end{{{name}}}" if claim.number else f"${latex}$" if latex else ""
        lines.append(shown)
    path = folder / "paper.tex"
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


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
        "paper": [*check, str(paper(folder)), "--problems", str(CLAIMS), "--no-cache"],
        "check again": [*check, str(CLAIMS), *cache],
        "200 more": [*check, str(further(folder)), "--no-cache"],
    }


def slowest() -> dict[str, float]:
    """The longest verdicts, from one run in this process (the best of three, for each)."""
    from rbpsym.claims.loader import load_claims
    from rbpsym.claims.run import Certificates, check_claims
    from tests.mutants.run import trials

    file, claims, others = load_claims(CLAIMS), {}, {}
    for _ in range(3):
        for result in check_claims(file, Certificates(None)):
            claims[result.id] = min(result.seconds, claims.get(result.id, 9.0))
        for trial in trials(CLAIMS):
            key = (trial.claim, trial.relation)
            others[key] = min(trial.seconds, others.get(key, 9.0))
    return {"a claim": max(claims.values()), "a mutant or rewrite": max(others.values())}


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
    found = {name: min(values) for name, values in times.items()}
    measure, extra, longest = found["import sympy"], found["200 more"] - found["check"], slowest()
    over = [name for name, bound in BOUNDS.items() if found[name] > bound * measure]
    over += ["200 more"] * (extra > FURTHER_BOUND * measure)
    over += [name for name, value in longest.items() if value > SLOWEST]
    for name, value in found.items():
        print(f"{name:<14} {value:7.3f} s  ratio {value / measure:.2f}")
    print(f"{FURTHER} more formulas: {extra:.2f} s, ratio {extra / measure:.2f} (bound {FURTHER_BOUND})")
    for name, value in longest.items():
        print(f"longest verdict on {name}: {value:.3f} s (bound {SLOWEST} s)")
    print("over the bound: " + ", ".join(over) if over else "all within their bounds")
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 5))
