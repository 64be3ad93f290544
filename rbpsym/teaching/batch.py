"""The papers of a whole class, on all cores; what an interrupted run had written is not written again."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from rbpsym.document.files import write_whole
from rbpsym.teaching.executor import Crew, run
from rbpsym.teaching.formats import Options, exporter
from rbpsym.teaching.journal import Journal
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.plan import Plan, plan_of

JOURNAL = ".worksheets.journal"
PART = 16  # papers that one process makes before it tells


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be made of each student's worksheet, and where."""

    source: str
    secret: str
    language: str
    formats: tuple[str, ...]
    folder: str
    key: bool = False
    solution: bool = False
    engine: str = "typst"


@dataclass(frozen=True, slots=True)
class Paper:
    """A student of an order."""

    order: Order
    student: Student | None


@lru_cache(maxsize=4)
def known_plan(source: str) -> Plan:
    """The plan of a source, made once in each process."""
    return plan_of(source)


def papers(
    order: Order, students: Sequence[Student | None], who: Crew, told: Callable[[int, int], None]
) -> list[list[str]]:
    """Writes the papers of all students; the paths written, student by student."""
    plan = known_plan(order.source)  # before the processes part, so that they share it
    journal = Journal(Path(order.folder) / JOURNAL if len(students) > PART else None, _about(order, plan, students))
    jobs = [Paper(order, student) for student in students]
    found = run(write_papers, jobs, who, journal, told, PART)
    journal.remove()
    return [json.loads(text) for text in found]


def _about(order: Order, plan: Plan, students: Sequence[Student | None]) -> str:
    """What a journal belongs to: the same order of the same text for the same students."""
    return sha256(repr((order, plan.fingerprint, students)).encode()).hexdigest()


def write_papers(jobs: tuple[Paper, ...]) -> list[str]:
    """The work of one process: each paper written whole; the paths as JSON."""
    return [json.dumps(_written(job)) for job in jobs]


def _written(job: Paper) -> list[str]:
    plan = known_plan(job.order.source)
    worksheet = plan.worksheet(job.student, job.order.secret, job.order.language)
    return written(worksheet, plan, job.order)


def written(worksheet: Worksheet, plan: Plan, order: Order) -> list[str]:
    """One worksheet in the formats of an order; the paths of its files. All are made before the first is written."""
    options = Options(order.key, True, order.engine, order.solution, plan.derivations)
    files: dict[str, str | bytes] = {}
    for name in order.formats:
        files |= exporter(name)((worksheet,), options).files
    return [str(write_whole(Path(order.folder) / name, content)) for name, content in files.items()]
