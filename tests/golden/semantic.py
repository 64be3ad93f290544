"""What the program says, without how it prints it: values, verdicts, keys and numbers, as plain data.

A record is a mapping from keys ("accelerations.theta", "conditions.N_w.at.theta") to texts of expressions,
numbers, words or None. Expressions are compared by our equality; keys that come new are welcome.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from rbpsym.decide.assumptions import NONE, Assumptions
from rbpsym.decide.equal import equal
from rbpsym.errors import RbpsymError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import Node
from rbpsym.proof.step import Derivation, Lesson
from rbpsym.solve import results
from rbpsym.statement.library import course_files, library_folder, problem_files, worksheet_files
from rbpsym.teaching.model import Item, Measure, Student, Worksheet
from rbpsym.typeset.machine import to_machine
from tests.library.derived import checked_claims, derived, derived_from

ROOT = Path(__file__).parents[2]
Record = Mapping[str, Any]
STUDENTS, SECRET = (Student("ana"), Student("ben")), "golden"
PRINTED = ("question", "latex", "steps", "symbols", "reason")  # of an answer: its key, its form, what is told apart
BY = ("force", "contact", "name")  # what tells the entries of a list apart, where they have it
STANDARD = ("sliding-ladder", "ball-off-sphere", "yo-yo", "cylinder-against-step")  # a sheet made for the problem


# --- what is recorded, by kind: names, and the record of a name


@cache
def examples() -> dict[str, Path]:
    """The examples of the documentation."""
    return {f"{path.parent.name}/{path.stem}": path for path in sorted((ROOT / "docs/examples").glob("*/*.toml"))}


@cache
def example(name: str) -> Derivation:
    return replace(derived_from(examples()[name]), simulation=None)


def problem_record(name: str) -> Record:
    return of_derivation(derived(name))


def answers_record(name: str) -> Record:
    """What a problem asks itself, as `rbpsym ask --json` tells it."""
    from rbpsym.ask.asking import own_answers
    from rbpsym.ask.found import Answer
    from rbpsym.ask.telling import record

    found = {}
    for one in own_answers(derived(name).study):
        told = record(one) if isinstance(one, Answer) else {"question": one.text, "refused": True}
        found[told["question"]] = {key: value for key, value in told.items() if key not in PRINTED and value not in (None, [])}
    return dict(_flat(found))


def example_record(name: str) -> Record:
    return of_derivation(example(name))


def claims_record(name: str) -> Record:
    """Each claim's outcome with those of its links, and that of the right form of an erratum."""
    found = {}
    for result in checked_claims(library_folder() / "claims" / f"{name}.toml"):
        links = " ".join(str(link.outcome) for link in result.links)
        found[result.id] = f"{result.outcome}: {links}" + (f"; right form {result.right}" if result.right else "")
    return found


def course_record(name: str) -> Record:
    from rbpsym.courses import derive_course
    from rbpsym.statement.course import load_course

    course = derive_course(load_course(course_files()[name]), derived=lambda path: derived(path.stem))
    return dict(_flat({lesson.name: of_steps(lesson) for lesson in course.lessons.values()}))


def worksheet_record(name: str) -> Record:
    from rbpsym.teaching.plan import plan_of

    plan = plan_of(name)
    return dict(_flat({who.id: _sheet(plan.worksheet(who, SECRET)) for who in STUDENTS}))


def plan_record(name: str) -> Record:
    """The balances that the torque method takes, in their order."""
    from rbpsym.chapters.methods.balances import plan

    found = plan(derived(name).study)
    taken = found.balances if found else ()
    return {str(k): f"{b.kind} of {', '.join(b.bodies)}: {b.label}" for k, b in enumerate(taken)}


KINDS = {
    "problems": (lambda: sorted(problem_files()), problem_record),
    "answers": (lambda: sorted(n for n, path in problem_files().items() if "[[ask]]" in path.read_text("utf-8")), answers_record),
    "examples": (lambda: sorted(examples()), example_record),
    "plans": (lambda: sorted(problem_files()), plan_record),
    "claims": (lambda: sorted(p.stem for p in (library_folder() / "claims").glob("*.toml")), claims_record),
    "courses": (lambda: sorted(course_files()), course_record),
    "worksheets": (lambda: [*sorted(worksheet_files()), *STANDARD], worksheet_record),
}


def assumptions_of(kind: str, name: str) -> Assumptions:
    """What may be assumed where two values of a record are compared."""
    made = {"problems": derived, "answers": derived, "examples": example}.get(kind)
    return made(name).study.assumptions if made else NONE


# --- the records


def of_derivation(derivation: Derivation) -> Record:
    """All results of `rbpsym solve`, the verdicts of the steps and of the independent roads."""
    found = dict(_flat(results(derivation.study)))
    found |= {f"steps.{key}": verdict for key, verdict in of_steps(derivation).items()}
    summary = derivation.summary()
    agreed = {key: summary[key] for key in ("methods", "methods_agree", "lagrange")}
    return found | dict(_flat({"roads": agreed}))


def of_steps(derivation: Derivation | Lesson) -> Record:
    """The verdict of each step by its id; those of later phases under the phase."""
    found = {step.id: str(step.certificate.verdict.kind) for step in derivation.steps}
    for phase in getattr(derivation, "phases", ()):
        later = (*phase.begins, *phase.derivation.steps)
        found |= {f"{phase.name}: {step.id}": str(step.certificate.verdict.kind) for step in later}
    return found


def _sheet(sheet: Worksheet) -> Record:
    given = {part.problem: {name: _number(m) for name, m in part.given.items()} for part in sheet.parts}
    return {"given": given, "items": {item.id: _item(item) for item in sheet.items}}


def _item(item: Item) -> Record:
    asked = f"{item.kind} {item.asked.problem} {item.asked.quantity}"
    return {"asked": asked, "points": str(item.points), "key": dict(_key(item.key))}


def _key(key: Any) -> Iterator[tuple[str, Any]]:
    """The parts of a key that decide what is right."""
    for name in ("value", "formula", "corrected"):
        if isinstance(found := getattr(key, name, None), Node):
            yield name, to_machine(found)
    if isinstance(getattr(key, "measure", None), Measure):
        yield "measure", _number(key.measure)
    for place, option in enumerate(getattr(key, "options", ())):
        shown = to_machine(option.formula) if option.formula is not None else _number(option.number)
        yield f"option.{place}", shown
    for name in ("right", "wrong"):
        if hasattr(key, name):
            yield name, getattr(key, name)
    for found in getattr(key, "blanks", ()):
        yield f"blank.{found.number}", to_machine(found.value)
    for place, row in enumerate(getattr(key, "rows", ())):
        yield f"row.{place}", f"{to_machine(row.force)} {row.body} {row.translational} {row.rotational} {row.cancels}"
    for place, piece in enumerate(getattr(key, "pieces", ())):
        yield f"piece.{place}", piece.id


def _number(measure: Measure | None) -> str | None:
    return None if measure is None else f"{measure.value} {measure.unit}".strip()


def _flat(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """(key, leaf) of nested mappings and lists."""
    dot = f"{path}." if path else ""
    if isinstance(value, Mapping) and value:
        for key, part in value.items():
            yield from _flat(part, f"{dot}{key}")
    elif isinstance(value, list) and value:
        met: dict[str, int] = {}
        for place, part in enumerate(value):
            label = next((str(part[key]) for key in BY if isinstance(part, Mapping) and key in part), "")
            met[label] = met.get(label, -1) + 1
            yield from _flat(
                part, f"{dot}{label}{f'#{met[label]}' if label and met[label] else ''}" if label else f"{dot}{place}"
            )
    else:
        yield path, value if value not in ({}, []) else None


# --- whether two leaves say the same

NAMES = re.compile(r"[^\W\d]\w*(?!\w*\s*\()")
RESERVED = frozenset({"pi"})


def same(old: Any, new: Any, assumptions: Assumptions = NONE) -> bool:
    """Are two leaves equal: the same word or number, or expressions that are proved equal?"""
    if old == new or not (isinstance(old, str) and isinstance(new, str)):
        return old == new
    names = {name for text in (old, new) for name in NAMES.findall(text)} - RESERVED
    try:
        return equal(read_infix(old, names), read_infix(new, names), assumptions).is_proved
    except RbpsymError:
        return False


def changes(old: Record, new: Record, assumptions: Assumptions = NONE) -> dict[str, tuple[Any, Any]]:
    """(old, new) of each key that changed or went (new is then `GONE`), and of new steps that are not proved."""
    found = {}
    for key, value in old.items():
        now = new.get(key, GONE)
        if now == GONE or not same(value, now, assumptions):
            found[key] = (value, now)
    for key, value in new.items():
        if key not in old and value in ("REFUTED", "UNDECIDED"):
            found[key] = (GONE, value)
    return found


GONE = "(not there)"
