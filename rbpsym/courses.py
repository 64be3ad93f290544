"""A whole course: every problem derived, every lesson written, in the course's order."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from rbpsym.ask.asking import meant_by
from rbpsym.claims.check import Checker
from rbpsym.claims.loader import claims_within
from rbpsym.claims.model import EXPECTATIONS, Claim, Printed
from rbpsym.claims.run import Worlds
from rbpsym.derive import derive
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.proof.step import Derivation, DerivedCourse, Lesson
from rbpsym.quantity.problem import ProblemWorld
from rbpsym.statement.course import Course, CoursePart
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.own_text import OwnFormula, Sentence
from rbpsym.statement.source import did_you_mean

# --- what a course says in its author's words: each sentence's claims and formulas are decided before anything is written


Formulas = Mapping[tuple[str, str], t.Node]
RELATIONS = (t.Chain, t.Relations)


def decided(course: Course, derivations: Mapping[str, Derivation]) -> Formulas:
    """The formulas of a course's own texts as trees, by the id of their claim and their LaTeX text.

    All of the claims and of the formulas that assert something are proved; else StatementError tells which is not, and where.
    """
    sentences = [sentence for part in course.parts for _, sentence in part.sentences]
    claims = _claims(course)
    used = {id: sentence for sentence in reversed(sentences) for id in sentence.claims}
    for id, sentence in used.items():
        if id not in claims:
            raise sentence.error(f"there is no claim “{id}”", did_you_mean(id, claims, "claims"))
    checker, found = _checker(course, derivations), {}
    for claim in claims.values():
        if claim.id not in used:
            what = f"no text of the course is bound to the claim “{claim.id}”"
            raise StatementError(what, instead=f"write {{claim:{claim.id}}} in a sentence, or drop the claim.", place=claim.place)
        printed = claim.printed or Printed("")
        found[claim.id, ""] = node = _proved(checker, claim, printed, used[claim.id])
        if not isinstance(node, RELATIONS):
            what = f"the claim “{claim.id}” asserts nothing: {printed.latex.strip()} is no relation"
            raise StatementError(what, instead="write a relation.", place=claim.place)
    for sentence, claim, formula in _formulas(sentences, claims):
        if (claim.id, formula.latex) not in found:
            found[claim.id, formula.latex] = _proved(checker, claim, Printed(formula.latex, sentence.place), sentence)
    return found


def _claims(course: Course) -> dict[str, Claim]:
    file = claims_within(course.claims, course.file, course.name) if course.claims else None
    claims = {claim.id: claim for claim in file.claims} if file else {}
    for claim in claims.values():
        if claim.expect != "proved" or claim.printed is None:
            what = f"the claim “{claim.id}” of a course is not one that is to be proved"
            raise StatementError(what, instead=r"say what is true: of what is wrong, that a \neq b.", place=claim.place)
    return claims


def _checker(course: Course, derivations: Mapping[str, Derivation]) -> Checker:
    """One that takes the studies of what is derived already."""
    worlds = Worlds(Path(course.file).parent)
    for name, derivation in derivations.items():
        worlds.problems[name] = ProblemWorld(derivation.study, worlds.problem, meant_by)
    return Checker(worlds)


def _formulas(sentences: list[Sentence], claims: Mapping[str, Claim]) -> Iterator[tuple[Sentence, Claim, OwnFormula]]:
    for sentence in sentences:
        yield from ((sentence, claims[sentence.claims[0]], p) for p in sentence.pieces if isinstance(p, OwnFormula))


def _proved(checker: Checker, claim: Claim, printed: Printed, sentence: Sentence) -> t.Node:
    """The tree of a formula; of one that asserts something, once it is proved."""
    node = checker.tree(claim, printed)
    if isinstance(node, RELATIONS):
        result = checker.check(replace(claim, printed=printed))
        if result.outcome not in EXPECTATIONS["proved"]:
            why = "; ".join(filter(None, (result.detail, *(link.detail for link in result.links))))
            told = f"“{sentence.told}” stands by the claim “{claim.id}”, and {printed.latex.strip()} is {result.outcome}"
            instead = "say what is true, or leave the sentence out."
            raise StatementError(f"{told}{': ' if why else ''}{why}", instead=instead, place=claim.place or sentence.place)
    return node


# ---


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
    from rbpsym.chapters.theory import THEORIES

    if part.name not in THEORIES:
        raise part.error("theory", f"unknown theory “{part.name}”", "known: " + ", ".join(THEORIES) + ".")
    return THEORIES[part.name]()


def _comparison(part: CoursePart, problem: Callable[[str], Derivation]) -> Lesson:
    from rbpsym.claims.comparison import compare_problems

    return compare_problems(problem(part.first).study, problem(part.second).study, part)


LESSONS: Mapping[str, Callable[[CoursePart, Callable[[str], Derivation]], Lesson]] = {
    "theory": _theory,
    "comparison": _comparison,
}
