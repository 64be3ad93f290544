"""What was handed out, kept beside the papers: `NAME.papers.json` stands for what each student's paper draws.

Grading makes the papers again; a forgotten --seed, another file or an engine that draws otherwise is noticed by it.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path
from typing import Any

from rbpsym.document.files import write_whole
from rbpsym.errors import Place, RbpsymError
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.plan import WorksheetPlan

SUFFIX = ".papers.json"
FRAME = {"worksheet": str, "version": str, "fingerprint": str, "papers": dict}


def drawn(sheet: Worksheet, secret: str) -> str:
    """Stands for the numbers, tasks, options and orders of one paper; nobody tells them from it without the secret."""
    told: list[object] = [secret, sheet.language]
    for part in sheet.parts:
        numbers = {**part.given, **part.place}
        told.append((part.problem, sorted((name, str(m.value), m.unit) for name, m in numbers.items())))
    told += [(item.id, item.kind, item.asked.quantity, str(item.points), _order(item.key)) for item in sheet.items]
    return sha256(repr(told).encode("utf-8", "surrogatepass")).hexdigest()[:16]


def _order(key: object) -> list[object]:
    """Which options, pieces or lines a key has, in their order, and where the right or wrong one is."""
    pieces = [piece.id for name in ("pieces", "lines") for piece in getattr(key, name, ())]
    options = [option.slip.name if option.slip else "" for option in getattr(key, "options", ())]
    return [*pieces, *options, getattr(key, "right", None), getattr(key, "wrong", None)]


def remember(folder: Path, plan: WorksheetPlan, secret: str, language: str, people: Iterable[Student | None]) -> None:
    """Write down what papers were made in a folder, beside those that were made there before."""
    from rbpsym import __version__

    path = folder / f"{plan.sheet.name}{SUFFIX}"
    papers = {one.id: drawn(plan.worksheet(one, secret, language), secret) for one in people if one is not None}
    if papers:
        known = _read(path)["papers"] if path.is_file() else {}
        kept = (plan.sheet.name, __version__, plan.fingerprint, {**known, **papers})
        write_whole(path, json.dumps(dict(zip(FRAME, kept, strict=True)), ensure_ascii=False, indent=1) + "\n")


def _read(path: Path) -> dict[str, Any]:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        found = None
    if isinstance(found, dict) and all(isinstance(found.get(key), kind) for key, kind in FRAME.items()):
        return found
    raise RbpsymError(
        "this is no record of papers", instead="delete it, and make the papers again.", place=Place(str(path))
    )


def record_of(name: str, folders: Iterable[Path]) -> Path | None:
    """The record of a worksheet's papers in one of the folders, or in a folder inside one of them."""
    for folder in dict.fromkeys(folders):
        near = folder / f"{name}{SUFFIX}"
        if found := ([near] if near.is_file() else sorted(folder.glob(f"*/{name}{SUFFIX}"))):
            return found[0]
    return None


def check(path: Path, plan: WorksheetPlan, secret: str, language: str, students: Iterable[str]) -> str:
    """A sentence if there is something to say. Raises RbpsymError if the papers that are made now are others."""
    from rbpsym import __version__

    record = _read(path)
    changed, known = record["fingerprint"] != plan.fingerprint, record["papers"]
    found = [student for student in students if student in known]
    for student in found:
        if known[student] == drawn(plan.worksheet(Student(student), secret, language), secret):
            continue
        if changed:
            what, cure = "the worksheet's file is another one now", "grade with the file from which the papers were made."
        elif record["version"] != __version__:
            what, cure = f"they were made with rbpsym {record['version']}", "grade with that version, or with the --seed."
        else:
            what = "the --seed or the language is another one" if secret else "they were made with a --seed"
            cure = "give the --seed (and --lang) with which the papers were made."
        raise RbpsymError(f"the papers are not those that were given out: {what}", instead=cure, place=Place(str(path)))
    if not found:
        return f"{path.name} knows none of these students: nothing shows that the --seed is that of the papers."
    return f"the file of the worksheet was changed after its papers were made ({path.name})." if changed else ""
