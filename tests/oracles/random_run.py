"""Many random systems by seed: python -m tests.oracles.random_run FIRST LAST [FILE], a line of JSON for each."""

from __future__ import annotations

import json
import random
import sys
import time
from collections import Counter
from pathlib import Path

from tests.oracles.judged import judged
from tests.oracles.systems import statement


def main(first: int, last: int, log: Path | None) -> int:
    counts: Counter[str] = Counter()
    for seed in range(first, last):
        begun = time.perf_counter()
        found = judged(statement(random.Random(seed).choice))
        kind = "wrong" if found.wrong else "refused" if found.refused else "fine"
        counts[kind] += 1
        row = {"seed": seed, "kind": kind, "wrong": found.wrong, "refused": found.refused, "open": found.open_}
        row["sets"] = found.sets
        if log:
            with log.open("a", encoding="utf-8") as file:
                file.write(json.dumps({**row, "seconds": round(time.perf_counter() - begun, 1)}, ensure_ascii=False) + "\n")
        if found.wrong:
            print(seed, "; ".join(found.wrong)[:300], flush=True)
    print(f"{last - first} systems: {dict(counts)}")
    return int(bool(counts["wrong"]))


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]) if len(sys.argv) > 3 else None))
