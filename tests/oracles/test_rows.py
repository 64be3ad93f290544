"""Variations of what was once told wrongly: nothing false is told of them, and what is told elsewhere says the same.

Each file of `rows` is a case of its own kind, which nobody solved; the laws are those of the library: no step refuted,
the simulation agrees, and the answer for machines says of a one-sided force what a step proves.
"""

from pathlib import Path

import pytest

from rbpsym.derive import derive
from rbpsym.errors import RbpsymError
from rbpsym.solve import solve
from rbpsym.statement.loader import load_problem

FOLDER = Path(__file__).parent
FILES = sorted((*FOLDER.glob("cases/*.toml"), *FOLDER.glob("rows/*.toml")))
REFUSED = {
    "block-against-slip": "slips the other way",
    "string-released-above": "would have to push at the start",
    "spin-against-slip": "slips the other way",
    "block-driven-up": "friction would drive it",
}
KEPT = "kept"


@pytest.mark.heavy
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_nothing_false_is_told(path: Path) -> None:
    if path.stem in REFUSED:
        with pytest.raises(RbpsymError, match=REFUSED[path.stem]):
            derive(load_problem(path), simulation=False)
        return
    problem = load_problem(path)
    found, answer = derive(problem), solve(problem, simulation=False)
    refuted = [step.id for step in found.all_steps if step.certificate.verdict.is_refuted]
    assert not refuted and found.simulation.max_relative_error < 1e-6
    for told, one in zip((answer, *answer["phases"]), (found, *(p.derivation for p in found.phases)), strict=False):
        proved = {step.id for step in one.steps if step.certificate.verdict.is_proved}
        for side in told.get("one_sided", ()):
            assert (side["state"] == KEPT) == (f"holds.{side['force']}" in proved), side
    asked = {row for side in answer["one_sided"] if side["state"] in ("asked", "open") for row in side["valid_where"]}
    assert asked <= set(answer["valid_where"])
