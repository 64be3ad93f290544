"""What changed against the semantic goldens, told line by line; on request it is recorded with its reason.

    python -m tests.golden.refresh                               # all kinds: what changed without a reason
    python -m tests.golden.refresh 'problems/ladder*'            # only these records
    python -m tests.golden.refresh --accept losses-first "only the loss that comes first is told" 'problems/*/conditions.*'

The last form writes changed/losses-first.json and a line in changes.md; patterns match whole keys. `--take` takes all anew
(at the end of an issue, when the changes have been read), and empties the list of changes.
"""

from __future__ import annotations

import sys
from fnmatch import fnmatchcase

from tests.golden.kept import CHANGED, TOLD, record_change, unexplained, write_taken
from tests.golden.semantic import KINDS

HEAD = "# What changed on purpose since the goldens were taken\n\nOne line for each reason; the values are in `changed/`.\n\n"


def found(patterns: list[str]) -> dict[str, tuple]:
    """(old, new) by whole key, of the records that the patterns reach."""
    changed = {}
    for kind, (names, _) in KINDS.items():
        for name in names():
            if _is_reached(f"{kind}/{name}", patterns):
                rows = unexplained(kind, name)
                changed |= {f"{kind}/{name}/{key}": pair for key, pair in rows.items()}
    return {key: pair for key, pair in changed.items() if _fits(key, patterns)}


def _is_reached(record: str, patterns: list[str]) -> bool:
    """Can a key of the record fit one of the patterns? (An example's name holds a slash.)"""
    parts = record.count("/") + 1
    return not patterns or any(
        fnmatchcase(record, "/".join(pattern.split("/")[:parts])) or "/" not in pattern for pattern in patterns
    )


def _fits(key: str, patterns: list[str]) -> bool:
    return not patterns or any(fnmatchcase(key, p) or fnmatchcase(key, f"{p}/*") for p in patterns)


def main(arguments: list[str]) -> int:
    if arguments[:1] == ["--take"]:
        for path in CHANGED.glob("*.json"):
            path.unlink()
        write_taken()
        TOLD.write_text(HEAD, encoding="utf-8")
        return 0
    if arguments[:1] == ["--accept"]:
        slug, why, *patterns = arguments[1:]
        changed = found(patterns)
        record_change(slug, why, {key: new for key, (_, new) in changed.items()})
        print(f"{len(changed)} changes recorded as {slug}")
        return 0
    changed = found(arguments)
    for key, (old, new) in changed.items():
        print(f"{key}\n  old: {old}\n  new: {new}")
    print(f"{len(changed)} changes without a reason")
    return int(bool(changed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
