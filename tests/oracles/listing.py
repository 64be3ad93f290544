"""Writes anew what is known not to be compared: python -m tests.oracles.listing"""

from __future__ import annotations

import json
from pathlib import Path

from rbpsym.mechanics.study import Study
from tests.library.derived import NAMES, problem
from tests.oracles.compare import each, findings

if __name__ == "__main__":
    known = {}
    for name in NAMES:
        found = findings(Study(problem(name)), 2, 8.0)
        if found.missing:
            known[name] = sorted(f"{what}: {reason}" for what, reason in found.missing.items())
        for line in each(found):
            print(name, line, flush=True)
    text = json.dumps(known, ensure_ascii=False, indent=1)
    (Path(__file__).parent / "not_compared.json").write_text(text + "\n", encoding="utf-8")
