"""The problems that ship, each loaded and derived once in a session."""

from functools import cache
from pathlib import Path

from rbpsym.derivation.step import Derivation
from rbpsym.derive import derive
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.statement.model import Problem
from rbpsym.verify.claims_cache import Certificates
from rbpsym.verify.claims_loader import load_claims
from rbpsym.verify.claims_model import Result
from rbpsym.verify.claims_run import check_claims

NAMES = tuple(sorted(problem_files()))


@cache
def problem(name: str) -> Problem:
    """The statement of a problem that ships."""
    return load_problem(problem_files()[name])


@cache
def derived(name: str) -> Derivation:
    """Its whole derivation, with both oracles."""
    return derive(problem(name))


@cache
def checked_claims(file: Path) -> tuple[Result, ...]:
    """The results of all claims of a file."""
    return tuple(check_claims(load_claims(file), Certificates(None)))
