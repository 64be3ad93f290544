"""What is kept from one edit to the next: the mechanics and the derivation of a statement whose physics is the same."""

from __future__ import annotations

from collections import deque
from dataclasses import replace
from functools import lru_cache

from rbpsym.derive import derive, physics_of
from rbpsym.mechanics.at_start import study_of
from rbpsym.mechanics.study import Study
from rbpsym.proof.step import Derivation
from rbpsym.statement.loader import load_text
from rbpsym.statement.model import Problem

FILE = "problem.toml"
MOST = 6  # statements of different physics


class Worked:
    """What was found out about a statement; the derivation when it is first asked for."""

    def __init__(self, physics: Problem, study: Study) -> None:
        self.physics, self.study = physics, study
        self.derivation: Derivation | None = None

    def told(self, problem: Problem) -> Study:
        """The mechanics with all that is known of it, under the words of this statement."""
        if self.study.problem != problem:
            self.study = self.study.under(problem)
        return self.study


_WORKED: deque[Worked] = deque(maxlen=MOST)


@lru_cache(maxsize=MOST)
def problem_of(text: str) -> Problem:
    """The statement read. Raises StatementError."""
    return load_text(text, FILE)


def study(text: str) -> Study:
    """The mechanics of a statement. Raises StatementError."""
    problem = problem_of(text)
    return _worked(problem).told(problem)


def derived(text: str) -> Derivation:
    """The derivation of a statement. Raises StatementError."""
    problem = problem_of(text)
    worked = _worked(problem)
    told = worked.told(problem)
    if worked.derivation is None:
        worked.derivation = derive(problem, simulation=False, study=told)
    return replace(worked.derivation, study=told)


def _worked(problem: Problem) -> Worked:
    physics = physics_of(problem)
    found = next((one for one in _WORKED if one.physics == physics), None)
    if found is None:
        found = Worked(physics, study_of(problem))
        _WORKED.append(found)
    return found
