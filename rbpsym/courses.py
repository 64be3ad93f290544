"""A whole course: every problem derived, every lesson written, in the course's order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from rbpsym.derivation.step import Derivation, DerivedCourse, Lesson
from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.statement.course import Course, CoursePart
from rbpsym.statement.library import find_problem
from rbpsym.statement.loader import load_problem


def derive_course(
    course: Course,
    *,
    simulation: bool = True,
    progress: Callable[[str], None] = lambda name: None,
    derived: Callable[[Path], Derivation] | None = None,
) -> DerivedCourse:
    """Derives all that a course needs; `progress` is told what comes next.

    `derived` gives the derivation of a problem file, if not every one is to be made anew.
    """
    derivations: dict[str, Derivation] = {}
    made = derived or (lambda path: derive(load_problem(path), simulation=simulation))

    def problem(name: str) -> Derivation:
        if name not in derivations:
            progress(name)
            derivations[name] = made(_path(name, course))
        return derivations[name]

    for name in _problem_names(course):
        problem(name)
    lessons = {part: LESSONS[part.kind](part, problem) for part in course.parts if part.kind in LESSONS}
    return DerivedCourse(course, derivations, lessons)


def _problem_names(course: Course) -> Iterator[str]:
    """Names of the problems that a course needs, some of them more than once."""
    for part in course.parts:
        yield from filter(None, (part.name if part.kind == "problem" else "", part.first, part.second))


def sources(course: Course) -> list[Path]:
    """The files that a course is made of."""
    own = [Path(course.file)] if course.file else []
    return own + [_path(name, course) for name in dict.fromkeys(_problem_names(course))]


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
