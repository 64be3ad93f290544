"""What makes a step and what checks it share the tree, the field's arithmetic, verdicts and the step itself."""

from __future__ import annotations

import pytest

from tests.architecture.source import MODULES

CHECKERS = ("rbpsym.proof.checks", "rbpsym.proof.mass", "rbpsym.proof.view", "rbpsym.proof.entailment",
            "rbpsym.proof.duties")  # fmt: skip
MAKERS = ("rbpsym.mechanics", "rbpsym.chapters", "rbpsym.field.integration")
THEORY = "rbpsym.chapters.theory"  # it has no problem behind it and certifies its own steps
DATA = {"rbpsym.mechanics.system", "rbpsym.mechanics.study"}  # what is stated, and the values that are checked
SHARED = {  # what a checker takes from the mechanics beside these, with the reason
    ("rbpsym.proof.mass", "rbpsym.field.integration"): "proposes antiderivatives, which are differentiated",
    ("rbpsym.proof.entailment", "rbpsym.mechanics.numbers"): "floating-point values, by which a pivot is passed over",
    ("rbpsym.proof.checks.constraints", "rbpsym.mechanics.conditions"): "what a constraint asks is the statement",
    ("rbpsym.proof.checks.constraints", "rbpsym.mechanics.constraints"): "how a string pulls is the statement",
    ("rbpsym.proof.checks.constraints", "rbpsym.mechanics.contacts"): "where bodies touch; their speeds are its own",
    ("rbpsym.proof.checks.constraints", "rbpsym.mechanics.friction"): "the poses as places of points",
    ("rbpsym.proof.checks.courses", "rbpsym.mechanics.contacts"): "where bodies touch is the statement",
    ("rbpsym.proof.checks.courses", "rbpsym.mechanics.friction"): "the poses as places of points",
    ("rbpsym.proof.checks.phases", "rbpsym.mechanics.friction"): "the poses as places of points",
    ("rbpsym.proof.checks.phases", "rbpsym.mechanics.geometry"): "the direction that the statement names",
    ("rbpsym.proof.checks.oscillations", "rbpsym.mechanics.demands"): "conditions of a place as assumptions",
    ("rbpsym.proof.checks.solutions", "rbpsym.mechanics.demands"): "conditions of a step as assumptions",
    ("rbpsym.proof.checks.places", "rbpsym.mechanics.demands"): "conditions of a place as assumptions",
    ("rbpsym.proof.checks.places", "rbpsym.mechanics.events"): "which forces are one-sided, and how strings run and springs lie",
}


def _is_checker(name: str) -> bool:
    return name.startswith(CHECKERS) or (name.startswith("rbpsym.elements.") and name.endswith(".check"))


@pytest.mark.parametrize("module", [m for m in MODULES if _is_checker(m.name)], ids=lambda m: m.name)
def test_checkers_take_nothing_from_makers(module) -> None:
    taken = {name for _, name in module.imports() if name.startswith(MAKERS) and name not in DATA}
    assert {(module.name, name) for name in taken} <= SHARED.keys()


@pytest.mark.parametrize("module", [m for m in MODULES if m.name.startswith(MAKERS) and m.name != THEORY], ids=lambda m: m.name)
def test_makers_take_nothing_from_checkers(module) -> None:
    assert not [name for _, name in module.imports() if _is_checker(name)]


KINDS = [m for m in MODULES if m.name.startswith("rbpsym.elements.")]
SEEN = {  # what virtual works and rows take from the mechanics: places, signs and numbers of what is stated
    "rbpsym.mechanics.assemble", "rbpsym.mechanics.friction", "rbpsym.mechanics.geometry", "rbpsym.mechanics.interactions",
    "rbpsym.mechanics.numbers", "rbpsym.mechanics.system",
}  # fmt: skip


def test_the_roads_of_a_kind_are_apart() -> None:
    """Its virtual work and its row in the simulation take nothing from laws, those of other kinds neither."""
    for module in (m for m in KINDS if m.parts[-1] in ("work", "row")):
        taken = {name for _, name in module.imports() if name.startswith(("rbpsym.mechanics", "rbpsym.elements"))}
        assert taken <= (SEEN if module.parts[-1] == "work" else {"rbpsym.mechanics.numbers"}), f"{module.name}: {taken}"


def test_what_is_shared_is_still_there() -> None:
    found = {(m.name, name) for m in MODULES for _, name in m.imports() if _is_checker(m.name)}
    assert SHARED.keys() <= found
