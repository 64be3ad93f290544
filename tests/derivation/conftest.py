"""Drafts of the shipped problems and of many other systems, derived once a session without the oracles."""

from pathlib import Path

import pytest

from rbpsym.derivation.draft import Draft
from rbpsym.derivation.phases import hand_overs
from rbpsym.derive import AFTER, BEFORE
from rbpsym.mechanics.study import Study
from rbpsym.methods.registry import METHODS
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem

ROOT = Path(__file__).parents[2]
MORE = (*(ROOT / "docs/examples").glob("[ci]*/*.toml"), *(ROOT / "tests/derivation/systems").glob("*.toml"))
FILES = {**problem_files(), **{f"{path.parent.name}/{path.stem}": path for path in sorted(MORE)}}
_DRAFTS = {}


PHASED = [name for name, path in FILES.items() if "[[phases]]" in path.read_text(encoding="utf-8")]
BEGUN = " and what follows"


def drafted(name: str) -> Draft:
    """The whole draft of a problem; with `BEGUN`, that of the steps by which its second phase begins."""
    if name not in _DRAFTS:
        _DRAFTS[name] = _begun(name.removesuffix(BEGUN)) if name.endswith(BEGUN) else _whole(name)
    return _DRAFTS[name]


def _whole(name: str) -> Draft:
    draft = Draft(Study(load_problem(FILES[name])))
    for write in (*BEFORE, *METHODS.values(), *AFTER):
        write(draft)
    return draft


def _begun(name: str) -> Draft:
    return hand_overs(load_problem(FILES[name]))[0][2]


@pytest.fixture(params=sorted([*FILES, *(name + BEGUN for name in PHASED)]))
def draft(request) -> Draft:
    return drafted(request.param)


@pytest.fixture(params=sorted(FILES))
def whole_draft(request) -> Draft:
    return drafted(request.param)
