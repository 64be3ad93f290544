"""The goldens on disk: `semantic/*.json` as they were when they were taken, `changed/*.json` what changed since, and why.

A file of `changed` has the reason ("why") and for each key ("problems/yo-yo/accelerations.y") the value that it now has.
So that two people do not meet in one file, each reason has a file of its own.
"""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from tests.golden.semantic import GONE, KINDS, assumptions_of, changes, same
from tests.library.derived import FILES

HERE = Path(__file__).parent
TAKEN, CHANGED, TOLD = HERE / "semantic", HERE / "changed", HERE / "changes.md"
STEPS = "steps."


def file_of(kind: str, name: str) -> str:
    """The file in which a record is kept: problems by their topic, all else by kind."""
    return f"problems-{FILES[name].parent.name}" if kind == "problems" else kind


@cache
def taken(kind: str, name: str) -> dict[str, Any]:
    """The record as it was taken; empty for what is newer."""
    return _unpacked(_file(TAKEN / f"{file_of(kind, name)}.json").get(name, {}))


@cache
def _file(path: Path) -> Mapping[str, Any]:
    return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}


@cache
def recorded() -> dict[str, list[tuple[str, Any]]]:
    """(name of the reason, new value) of each key that was changed on purpose."""
    found: dict[str, list[tuple[str, Any]]] = {}
    for path in sorted(CHANGED.glob("*.json")):
        for key, value in _file(path)["new"].items():
            found.setdefault(key, []).append((path.stem, value))
    return found


def unexplained(kind: str, name: str) -> dict[str, tuple[Any, Any]]:
    """(taken, now) of each key whose value is neither that which was taken nor one that was recorded with a reason."""
    given = assumptions_of(kind, name)
    now = KINDS[kind][1](name)
    found = {}
    for key, (old, new) in changes(taken(kind, name), now, given).items():
        if not any(same(value, new, given) for _, value in recorded().get(f"{kind}/{name}/{key}", ())):
            found[key] = (old, new)
    return found


def out_of_use(kind: str, name: str) -> list[str]:
    """Recorded changes of a record that no longer are what is found (nor does the old value hold)."""
    given, now, start = assumptions_of(kind, name), KINDS[kind][1](name), f"{kind}/{name}/"
    found = []
    for key, values in recorded().items():
        if key.startswith(start):
            new = now.get(key.removeprefix(start), GONE)
            found += [f"{key} ({why})" for why, value in values if not same(value, new, given)]
    return found


# --- writing


def write_taken(kinds: Collection[str] = tuple(KINDS)) -> None:
    """All records of some kinds as they are now."""
    files: dict[str, dict[str, Any]] = {}
    for kind, (names, record) in ((kind, KINDS[kind]) for kind in kinds):
        for name in names():
            files.setdefault(file_of(kind, name), {})[name] = _packed(record(name))
    TAKEN.mkdir(exist_ok=True)
    for stem, content in files.items():
        (TAKEN / f"{stem}.json").write_text(_written(content), encoding="utf-8")


def record_change(slug: str, why: str, keys: Mapping[str, Any]) -> None:
    """Put the new values of keys down under a reason, and away from older reasons."""
    CHANGED.mkdir(exist_ok=True)
    for path in CHANGED.glob("*.json"):
        content = json.loads(path.read_text(encoding="utf-8"))
        kept = {key: value for key, value in content["new"].items() if key not in keys}
        if len(kept) < len(content["new"]):
            _write_change(path, content["why"], kept)
    path = CHANGED / f"{slug}.json"
    before = json.loads(path.read_text(encoding="utf-8"))["new"] if path.is_file() else {}
    _write_change(path, why, {**before, **keys})
    lines = TOLD.read_text(encoding="utf-8").splitlines()
    lines = [line for line in lines if not line.startswith(f"- `{slug}`")] + [f"- `{slug}`: {why}"]
    TOLD.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _write_change(path: Path, why: str, new: Mapping[str, Any]) -> None:
    text = json.dumps({"why": why, "new": dict(sorted(new.items()))}, ensure_ascii=False, indent=0)
    path.write_text(text + "\n", encoding="utf-8")


def _written(content: Mapping[str, Any]) -> str:
    """JSON with a line for each key of each record."""
    records = []
    for name, record in content.items():
        rows = (
            f"  {json.dumps(k, ensure_ascii=False)}: {json.dumps(v, ensure_ascii=False)}" for k, v in record.items()
        )
        records.append(f"{json.dumps(name)}: {{\n" + ",\n".join(rows) + "\n}")
    return "{\n" + ",\n".join(records) + "\n}\n"


def _packed(record: Mapping[str, Any]) -> dict[str, Any]:
    """The steps as lists of ids by verdict."""
    found = {key: value for key, value in record.items() if not key.startswith(STEPS)}
    for key, value in record.items():
        if key.startswith(STEPS):
            found.setdefault(f"{STEPS}{value}", []).append(key.removeprefix(STEPS))
    return found


def _unpacked(record: Mapping[str, Any]) -> dict[str, Any]:
    return dict(_items(record))


def _items(record: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    for key, value in record.items():
        if key.startswith(STEPS):
            yield from ((STEPS + id, key.removeprefix(STEPS)) for id in value)
        else:
            yield key, value
