"""A whole course: every problem derived, every lesson written, in the course's order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from rbpsym.derivation.step import Derivation, DerivedCourse, Lesson
from rbpsym.derive import derive
from rbpsym.statement.course import Course, CoursePart
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.source import did_you_mean


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
    from rbpsym.document.own_texts import check_unbound
    from rbpsym.verify.course_claims import decided

    derivations: dict[str, Derivation] = {}
    check_unbound(course)
    paths = _paths(course)
    made = derived or (lambda path: derive(load_problem(path), simulation=simulation))

    def problem(name: str) -> Derivation:
        if name not in derivations:
            progress(name)
            derivations[name] = made(paths[name])
        return derivations[name]

    for name in paths:
        problem(name)
    lessons = {part: LESSONS[part.kind](part, problem) for part in course.parts if part.kind in LESSONS}
    return DerivedCourse(course, derivations, lessons, decided(course, derivations))


def sources(course: Course) -> list[Path]:
    """The files that a course is made of."""
    own = [Path(course.file)] if course.file else []
    return own + list(_paths(course).values())


def _paths(course: Course) -> dict[str, Path]:
    """The files of the problems that a course needs, by the names that it has for them."""
    return {name: _path(name, part, course) for part in course.parts for name in _needed(part)}


def _needed(part: CoursePart) -> Iterator[str]:
    yield from filter(None, (part.name if part.kind == "problem" else "", part.first, part.second))


def _path(name: str, part: CoursePart, course: Course) -> Path:
    """A file beside the course, with or without its ending, or a problem of the library."""
    beside = [Path(course.file).parent / found for found in (name, f"{name}.toml")] if course.file else []
    own = next((path for path in beside if path.is_file()), None)
    if own is None and name not in problem_files():
        hint = did_you_mean(name, problem_files(), "problems in the library")
        raise part.error(part.kind, f"there is no problem “{name}” in the library and no file beside the course", hint)
    return own or problem_files()[name]


def _theory(part: CoursePart, problem: Callable[[str], Derivation]) -> Lesson:
    from rbpsym.derivation.theory import THEORIES

    if part.name not in THEORIES:
        raise part.error("theory", f"unknown theory “{part.name}”", "known: " + ", ".join(THEORIES) + ".")
    return THEORIES[part.name]()


def _comparison(part: CoursePart, problem: Callable[[str], Derivation]) -> Lesson:
    from rbpsym.verify.comparison import compare_problems

    return compare_problems(problem(part.first).study, problem(part.second).study, part)


LESSONS: Mapping[str, Callable[[CoursePart, Callable[[str], Derivation]], Lesson]] = {
    "theory": _theory,
    "comparison": _comparison,
}
