"""The problems that ship, each loaded and derived once in a session."""

from functools import cache

from rbpsym.derivation.step import Derivation
from rbpsym.derive import derive
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem

NAMES = tuple(sorted(problem_files()))


@cache
def problem(name: str) -> Problem:
    """The statement of a problem that ships."""
    return load_problem(problem_files()[name])


@cache
def derived(name: str) -> Derivation:
    """Its whole derivation, with both oracles."""
    return derive(problem(name))
