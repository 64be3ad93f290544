"""Drafts of the shipped problems and of many other systems, derived once a session without the oracles."""

from pathlib import Path

import pytest

from rbpsym.derivation.draft import Draft
from rbpsym.derive import AFTER, BEFORE
from rbpsym.mechanics.study import Study
from rbpsym.methods.registry import METHODS
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

ROOT = Path(__file__).parents[2]
MORE = (*(ROOT / "docs/examples").glob("[ci]*/*.toml"), *(ROOT / "tests/derivation/systems").glob("*.toml"))
FILES = {**problem_files(), **{f"{path.parent.name}/{path.stem}": path for path in sorted(MORE)}}
_DRAFTS = {}


def drafted(name: str) -> Draft:
    """The whole draft of a problem."""
    if name not in _DRAFTS:
        draft = Draft(Study(load_problem(FILES[name])))
        for write in (*BEFORE, *METHODS.values(), *AFTER):
            write(draft)
        _DRAFTS[name] = draft
    return _DRAFTS[name]


@pytest.fixture(params=sorted(FILES))
def draft(request) -> Draft:
    return drafted(request.param)
