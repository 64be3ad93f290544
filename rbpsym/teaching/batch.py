"""The papers of a whole class, on all cores; what an interrupted run had written is not written again."""

from __future__ import annotations

import gc
import json
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache, partial
from hashlib import sha256
from pathlib import Path
from threading import Lock
from typing import Any

from rbpsym.document.files import write_whole
from rbpsym.errors import Place, RbpsymError
from rbpsym.frozen import Frozen, replace
from rbpsym.teaching.executor import Crew, Journal, run
from rbpsym.teaching.formats import Options, exporter
from rbpsym.teaching.model import Student, Worksheet
from rbpsym.teaching.plan import WorksheetPlan, plan_of

JOURNAL = ".worksheets.journal"
PART = 16  # papers that one process makes before it tells
TURN = Lock()  # a worker of a cluster may have several threads; the algebra keeps tables that they would share


class Handout(Frozen):
    """Papers of a worksheet: its source, the secret and the language of the papers.

    `fingerprint` is that of the worksheet here: a worker elsewhere that has another file of that name must do nothing.
    """

    source: str
    secret: str
    language: str
    fingerprint: str = ""

    def plan(self) -> WorksheetPlan:
        """The plan, made once in each process. Raises RbpsymError where the worksheet is another one."""
        plan = known_plan(self.source)
        if self.fingerprint:
            plan.require(self.fingerprint, self.source)
        return plan


class Order(Handout):
    """What is to be made of each student's worksheet, and where."""

    formats: tuple[str, ...] = ()
    folder: str = ""
    key: bool = False
    solution: bool = False
    engine: str = "typst"
    studio: str = ""

    def options(self, plan: WorksheetPlan) -> Options:
        """What exporters are told: with solutions go keys."""
        return Options(self.key or self.solution, self.engine, self.solution, plan.derivations, self.studio)

    def files(self, worksheet: Worksheet, plan: WorksheetPlan) -> dict[str, str | bytes]:
        """The files of one worksheet by name."""
        made = (exporter(name)((worksheet,), self.options(plan)).files for name in self.formats)
        return {name: content for files in made for name, content in files.items()}


class StudentPaper(Frozen):
    """A student of an order."""

    order: Order
    student: Student | None

    def files(self) -> dict[str, str | bytes]:
        """The files of the student's worksheet by name."""
        plan = self.order.plan()
        return self.order.files(plan.worksheet(self.student, self.order.secret, self.order.language), plan)


@lru_cache(maxsize=4)
def known_plan(source: str) -> WorksheetPlan:
    """The plan of a source, made once in each process; it is not searched for garbage again and again."""
    found = plan_of(source)
    gc.collect()
    gc.freeze()
    return found


def papers(order: Order, students: Sequence[Student | None], who: Crew, told: Callable[[int, int], None]) -> list[list[str]]:
    """Writes the papers of all students; the paths written, student by student.

    Processes of this machine write their papers themselves; a cluster sends them, and they are written here.
    """
    plan = known_plan(order.source)  # before the processes part, so that they share it
    path = Path(order.folder) / JOURNAL if len(students) > PART else None
    journal = Journal(path, sha256(repr((order, plan.fingerprint, students)).encode()).hexdigest())
    if who.address:
        order = replace(order, source=findable(order.source), fingerprint=plan.fingerprint)
    jobs = [StudentPaper(order, student) for student in students]
    work, received = (send_papers, partial(_taken, folder=order.folder)) if who.address else (write_papers, str)
    made: list[list[str]] = [json.loads(text) for text in run(work, jobs, who, journal, told, PART, received)]
    names = {Path(name) for those in made for name in those}
    for rest in (rest for folder in {name.parent for name in names} for rest in folder.glob(".?*.????????")):
        if rest.with_name(rest.name[1:-9]) in names:  # what a run that was killed was about to rename
            rest.unlink(missing_ok=True)
    journal.remove()
    return made


def findable(source: str) -> str:
    """How a process elsewhere finds a source."""
    path = Path(source)
    return str(path.resolve()) if path.is_file() else source


def write_papers(jobs: tuple[StudentPaper, ...]) -> list[str]:
    """The work of one process: each paper written whole; the paths as JSON."""
    return [json.dumps(written(job.files(), job.order.folder)) for job in jobs]


def send_papers(jobs: tuple[StudentPaper, ...]) -> list[str]:
    """The work of a worker elsewhere: the files of each paper, by name, as JSON."""
    with TURN:
        return [json.dumps({name: b64encode(data).decode() for name, data in encoded(job.files())}) for job in jobs]


def encoded(files: Mapping[str, str | bytes]) -> Iterator[tuple[str, bytes]]:
    """Files as bytes."""
    yield from ((name, data.encode() if isinstance(data, str) else data) for name, data in files.items())


def _taken(text: str, folder: str) -> str:
    """Writes what a worker sent; the paths as JSON."""
    return json.dumps(written({name: b64decode(data) for name, data in json.loads(text).items()}, folder))


def written(files: Mapping[str, str | bytes], folder: str) -> list[str]:
    """The paths of files that were all made before the first is written."""
    return [str(write_whole(Path(folder) / name, content)) for name, content in files.items()]


# --- what was handed out, kept beside the papers: `NAME.papers.json` stands for what each student's paper draws
# Grading makes the papers again; a forgotten --seed, another file or an engine that draws otherwise is noticed by it.


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
    raise RbpsymError("this is no record of papers", instead="delete it, and make the papers again.", place=Place(str(path)))


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
