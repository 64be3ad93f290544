"""Many random systems by seed, and the table of what was found.

    python -m tests.oracles.random_run FIRST LAST FILE

FILE gets a line of JSON for each; what it holds already is not run again. Two may write to one file.
"""

from __future__ import annotations

import json
import random
import re
import sys
from collections import Counter
from pathlib import Path
from typing import Any

from tests.oracles.judged import OUTCOMES, judged
from tests.oracles.systems import FAMILIES, system

# parts that systems of several families have: what is found in their statement
PARTS = {
    "contacts": r'"(contact|touch|slider)"', "rolling": r'"rolling"', "springs": r'"(torsion-)?spring"',
    "dampers": r'"(rotary-)?damper"', "strings": r'"string"', "phases": r"\[\[phases",
}  # fmt: skip

Row = dict[str, Any]


def row(seed: int) -> Row:
    """What is found of the system of a seed."""
    family, text = system(random.Random(seed).choice)
    found = judged(text)
    kinds = [family, *(name for name, sign in PARTS.items() if re.search(sign, text))]
    told = {"wrong": found.wrong, "refused": found.refused, "open": found.open_}
    return {"seed": seed, "kinds": kinds, "outcome": found.outcome, **told, "sets": found.sets, "compared": found.compared}


def rows(first: int, last: int, log: Path) -> list[Row]:
    """The rows of these seeds; what the log does not hold is run and written down."""
    known = {found["seed"]: found for line in _lines(log) if (found := json.loads(line))}
    log.parent.mkdir(parents=True, exist_ok=True)
    for seed in range(first, last):
        if seed not in known:
            known[seed] = row(seed)
            with log.open("a", encoding="utf-8") as file:
                file.write(json.dumps(known[seed], ensure_ascii=False) + "\n")
    return [known[seed] for seed in range(first, last)]


def _lines(log: Path) -> list[str]:
    return log.read_text(encoding="utf-8").splitlines() if log.exists() else []


def table(found: list[Row]) -> str:
    """How many of each kind had which outcome; a system is of its family, and of the kinds of its parts."""
    lines = [f"{'':10} {'number':>9} " + " ".join(f"{outcome:>9}" for outcome in OUTCOMES)]
    for kind in (*FAMILIES, *PARTS, "all"):
        counts = Counter(one["outcome"] for one in found if kind in (*one["kinds"], "all"))
        lines.append(f"{kind:10} {counts.total():9} " + " ".join(f"{counts[outcome]:9}" for outcome in OUTCOMES))
    sets, compared = (sum(one[name] for one in found) for name in ("sets", "compared"))
    return "\n".join([*lines, f"{sets} sets of numbers, {compared} names compared with the simulation"])


def main(first: str, last: str, log: str) -> int:
    found = rows(int(first), int(last), Path(log))
    wrong = [one for one in found if one["wrong"]]
    for one in wrong:
        print(one["seed"], "; ".join(one["wrong"])[:300])
    print(table(found))
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
