"""The law of one-sided forces: the derivation says of each normal force, tension and limit of friction what becomes of it.

A one-sided force is proved not to change its sign (`holds`), is lost at a stated place (`loss`), or is printed as a
condition, with the reason where it is not decided (`asks`); static friction with a stated coefficient needs none, has
enough, or asks for a coefficient. What is asked for is carried into the answer. `python -m tests.proof.test_one_sided`
counts them.
"""

from collections import Counter
from pathlib import Path

import pytest

from rbpsym.derive import derive
from rbpsym.document.notes import DETAILS, shown_steps
from rbpsym.mechanics.events import pushes
from rbpsym.proof.step import Derivation, Step
from rbpsym.solve import results
from rbpsym.statement import load_text
from rbpsym.statement.library import problem_files
from tests.golden.semantic import examples
from tests.library.derived import derived_from

FILES = {**problem_files(), **examples()}
SAID = {"kept": "holds", "lost": "loss", "asked": "asks", "open": "asks"}


def stages(path: Path) -> tuple[Derivation, ...]:
    found = derived_from(path)
    return tuple(one for one in (found, *(phase.derivation for phase in found.phases)) if not one.study.at_start)


def lasts(found: Derivation) -> bool:
    """Is there a motion before the next phase begins?"""
    return not found.study.problem.phases or found.study.problem.phases[0].event != "at once"


def told_of(found: Derivation, force: str, *kinds: str) -> list[Step]:
    return [step for step in found.steps for kind in kinds if step.id == f"{kind}.{force}"]


def forces(found: Derivation) -> dict[str, Step | None]:
    """Each one-sided force, and each friction with a stated limit, with what is said of it."""
    said: dict[str, Step | None] = {}
    for element in found.study.problem.constraints:
        for name in pushes(element):
            [said[name]] = told_of(found, name, "holds", "loss", "asks")
        if element.values.get("limit") is not None:
            steps = told_of(found, element.name, "friction", "enough")
            said[element["friction"]] = steps[-1] if steps else None
            assert steps or not found.study.reactions_along_motion[element["friction"]]
    return said


@pytest.mark.parametrize("name", FILES)
def test_each_force_is_told_once(name: str) -> None:
    for found in stages(FILES[name]):
        for step in filter(None, forces(found).values()):
            assert step.certificate.verdict.is_proved, step.id
            levels = ["full"] if step.id.startswith(("holds", "enough")) else DETAILS
            assert not lasts(found) or all(step.id in shown_steps(found, detail) for detail in levels)


@pytest.mark.parametrize("name", FILES)
def test_the_answer_says_it_too(name: str) -> None:
    for found in stages(FILES[name]):
        answer, said = results(found.study), forces(found)
        for item in answer["one_sided"]:
            assert said[item["force"]].id == f"{SAID[item['state']]}.{item['force']}"
            if item["state"] in ("asked", "open"):
                assert item["valid_where"] and set(item["valid_where"]) <= set(answer["valid_where"])
        asked = [i for i in answer["static_friction"] if i["coefficient"] is not None and not i["enough"]]
        assert all(any(i["coefficient"] in row for row in answer["valid_where"]) for i in asked)


def test_a_sign_is_not_refuted_where_the_motion_never_comes():
    text = """
[parameters]
m = "mass"
M = "mass"
L = "length"
R = "length"
g = "acceleration"
kappa = "torsion stiffness"
[coordinates.y]
dimension = "length"
start = "0"
[coordinates.phi]
[bodies.w]
shape = "particle"
mass = "m"
center = ["R", "-L - y"]
[bodies.p]
shape = "disk"
mass = "M"
radius = "R"
center = "O"
angle = "-phi"
[interactions.W]
type = "gravity"
[interactions.K]
type = "torsion-spring"
between = ["ground", "p"]
stiffness = "kappa"
[constraints.A]
type = "pivot"
point = "p.center"
[constraints.T]
type = "string"
path = ["cw p", "w.center"]
"""
    found = derive(load_text(text), simulation=False)
    [side] = [step for step in found.steps if step.id == "holds.T"]
    assert side.certificate.verdict.is_proved


if __name__ == "__main__":
    print(Counter(step.phrase for path in FILES.values() for d in stages(path) for step in forces(d).values() if step))
