"""Drafts of the shipped problems, derived once a session without the oracles."""

import pytest

from rbpsym.derivation.draft import Draft
from rbpsym.derive import AFTER, BEFORE
from rbpsym.mechanics.study import Study
from rbpsym.methods.registry import METHODS
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

_DRAFTS = {}


def drafted(name: str) -> Draft:
    """The whole draft of a shipped problem."""
    if name not in _DRAFTS:
        draft = Draft(Study(load_problem(problem_files()[name])))
        for write in (*BEFORE, *METHODS.values(), *AFTER):
            write(draft)
        _DRAFTS[name] = draft
    return _DRAFTS[name]


@pytest.fixture(params=sorted(problem_files()))
def draft(request) -> Draft:
    return drafted(request.param)
