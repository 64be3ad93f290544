"""A whole course: every problem derived, every lesson written, in the course's order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from rbpsym.derivation.step import Derivation, DerivedCourse, Lesson
from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.statement.course import Course, CoursePart
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem


def derive_course(
    course: Course, *, simulation: bool = True, progress: Callable[[str], None] = lambda name: None
) -> DerivedCourse:
    """Derives all that a course needs; `progress` is told what comes next."""
    derivations: dict[str, Derivation] = {}

    def problem(name: str) -> Derivation:
        if name not in derivations:
            progress(name)
            derivations[name] = derive(load_problem(_path(name, course)), simulation=simulation)
        return derivations[name]

    for part in course.parts:
        for name in filter(None, (part.name if part.kind == "problem" else "", part.first, part.second)):
            problem(name)
    lessons = {part: LESSONS[part.kind](part, problem) for part in course.parts if part.kind in LESSONS}
    return DerivedCourse(course, derivations, lessons)


def _path(name: str, course: Course) -> Path:
    """A problem of the library, or a file beside the course."""
    beside = Path(course.file).parent / name
    return beside if course.file and beside.is_file() else find_problem(name)


def _theory(part: CoursePart, problem: Callable[[str], Derivation]) -> Lesson:
    from rbpsym.derivation.theory import THEORIES

    if part.name not in THEORIES:
        raise StatementError(f"unknown theory “{part.name}”", instead="known: " + ", ".join(THEORIES) + ".")
    return THEORIES[part.name]()


def _comparison(part: CoursePart, problem: Callable[[str], Derivation]) -> Lesson:
    from rbpsym.verify.comparison import compare_problems

    return compare_problems(problem(part.first).study, problem(part.second).study, part)


LESSONS: Mapping[str, Callable[[CoursePart, Callable[[str], Derivation]], Lesson]] = {
    "theory": _theory,
    "comparison": _comparison,
}
