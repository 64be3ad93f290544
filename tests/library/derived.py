"""Statements of the repository, each loaded and derived once in a worker (`tests.sharing` keeps what is of one together)."""

from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

from rbpsym.ask.asking import Refused, own_answers
from rbpsym.ask.found import Answer
from rbpsym.claims.loader import load_claims
from rbpsym.claims.model import Result
from rbpsym.claims.run import Certificates, check_claims
from rbpsym.derive import derive
from rbpsym.mechanics.study import Study
from rbpsym.proof.context import Context
from rbpsym.proof.step import Derivation, Step
from rbpsym.solve import results
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem

FILES = problem_files()
NAMES = tuple(sorted(FILES))
AT_START = ("bar-on-slanting-strings", "four-bar-linkage")  # of these, only the start is told
FOLLOWED = tuple(name for name in NAMES if name not in AT_START)


@cache
def problem(name: str) -> Problem:
    """The statement of a problem that ships."""
    return stated(FILES[name])


@cache
def derived(name: str) -> Derivation:
    """Its whole derivation, with both oracles."""
    return derived_from(FILES[name])


@cache
def unsimulated(name: str) -> Derivation:
    """The same as it is without the simulation."""
    return replace(derived(name), simulation=None)


@cache
def stated(path: Path) -> Problem:
    """The statement of a file."""
    return load_problem(path)


@cache
def derived_from(path: Path) -> Derivation:
    """The whole derivation of a file, with both oracles."""
    return derive(stated(path))


@cache
def answered(name: str) -> dict[str, Any]:
    """What `rbpsym solve` says of it, without the simulation."""
    found = unsimulated(name)
    return {**results(found.study), "verdicts": found.summary()}


_ANSWERS: dict[int, tuple[Study, tuple[Answer | Refused, ...]]] = {}  # by the study itself, which is kept beside


def answers_to(study: Study) -> tuple[Answer | Refused, ...]:
    """What the problem of a study asks itself, answered once for all documents that are made of it."""
    if id(study) not in _ANSWERS:
        _ANSWERS[id(study)] = (study, tuple(own_answers(study)))
    return _ANSWERS[id(study)][1]


@dataclass(frozen=True)
class Drafted:
    """Steps with what they were made from: enough to certify them anew."""

    derivation: Derivation

    @property
    def study(self) -> Study:
        return self.derivation.study

    @property
    def context(self) -> Context:
        return self.derivation.letters

    @property
    def steps(self) -> tuple[Step, ...]:
        return self.derivation.steps


def drafted_from(path: Path) -> Drafted:
    """The steps of the first phase of a file."""
    return Drafted(derived_from(path))


@cache
def checked_claims(file: Path) -> tuple[Result, ...]:
    """The results of all claims of a file."""
    return tuple(check_claims(load_claims(file), Certificates(None)))


def derive_once(problem: Problem, *, simulation: bool = True) -> Derivation:
    """As `rbpsym.derive.derive`, for tests of what comes after it: what ships is derived once."""
    file = FILES.get(problem.name)
    if file is None or problem != stated(file):
        return derive(problem, simulation=simulation)
    return derived(problem.name) if simulation else unsimulated(problem.name)
