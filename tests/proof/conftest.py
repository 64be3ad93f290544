"""Drafts of the shipped problems and of many other systems."""

from functools import cache
from pathlib import Path

import pytest

from rbpsym.chapters.impulses import hand_overs
from rbpsym.proof.draft import Draft
from rbpsym.statement.library import problem_files
from tests.library.derived import Drafted, derived_from, drafted_from, stated

ROOT = Path(__file__).parents[2]
MORE = (*(ROOT / "docs/examples").glob("[ci]*/*.toml"), *(ROOT / "tests/proof/systems").glob("*.toml"))
FILES = {**problem_files(), **{f"{path.parent.name}/{path.stem}": path for path in sorted(MORE)}}


def begins(path: Path) -> bool:
    """Whether a second phase begins by steps of its own (not where something is cut at once)."""
    text = path.read_text(encoding="utf-8")
    return "[[phases]]" in text and not ('"at once"' in text and "without" in text and "impulses" not in text)


PHASED = [name for name, path in FILES.items() if begins(path)]
BEGUN, LATER = " and what follows", " in its second phase"


@cache
def drafted(name: str) -> Drafted | Draft:
    """The whole draft of a problem; with `BEGUN`, that of the steps by which its second phase begins, with `LATER` that of its
    own steps."""
    if name.endswith(LATER):
        return Drafted(derived_from(FILES[name.removesuffix(LATER)]).phases[0].derivation)
    if name.endswith(BEGUN):
        return hand_overs(stated(FILES[name.removesuffix(BEGUN)]))[0][2]
    return drafted_from(FILES[name])


@pytest.fixture(params=sorted([*FILES, *(name + more for name in PHASED for more in (BEGUN, LATER))]))
def draft(request) -> Drafted | Draft:
    return drafted(request.param)


@pytest.fixture(params=sorted(FILES))
def whole_draft(request) -> Drafted:
    return drafted(request.param)
