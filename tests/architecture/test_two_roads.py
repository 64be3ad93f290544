"""What makes a step and what checks it share the tree, the field's arithmetic, verdicts and the step itself."""

from __future__ import annotations

import pytest

from tests.architecture.source import MODULES

CHECKERS = ("rbpsym.derivation.checks", "rbpsym.derivation.mass", "rbpsym.derivation.view", "rbpsym.derivation.entailment",
            "rbpsym.derivation.duties")  # fmt: skip
MAKERS = ("rbpsym.mechanics", "rbpsym.methods", "rbpsym.derivation.chapters", "rbpsym.algebra.integration")
DATA = {"rbpsym.mechanics.system", "rbpsym.mechanics.study"}  # what is stated, and the values that are checked
SHARED = {  # what a checker takes from the mechanics beside these, with the reason
    ("rbpsym.derivation.mass", "rbpsym.algebra.integration"): "proposes antiderivatives, which are differentiated",
    ("rbpsym.derivation.entailment", "rbpsym.mechanics.numbers"): "floating-point values, by which a pivot is passed over",
    ("rbpsym.derivation.checks_constraints", "rbpsym.mechanics.conditions"): "what a constraint asks is the statement",
    ("rbpsym.derivation.checks_constraints", "rbpsym.mechanics.contacts"): "where bodies touch; their speeds are its own",
    ("rbpsym.derivation.checks_constraints", "rbpsym.mechanics.friction"): "the poses as places of points",
    ("rbpsym.derivation.checks_phases", "rbpsym.mechanics.contacts"): "where bodies touch is the statement",
    ("rbpsym.derivation.checks_phases", "rbpsym.mechanics.friction"): "the poses as places of points",
    ("rbpsym.derivation.checks_phases", "rbpsym.mechanics.geometry"): "the direction that the statement names",
    ("rbpsym.derivation.checks_oscillations", "rbpsym.mechanics.demands"): "conditions of a place as assumptions",
    ("rbpsym.derivation.checks_solutions", "rbpsym.mechanics.demands"): "conditions of a step as assumptions",
    ("rbpsym.derivation.checks_places", "rbpsym.mechanics.demands"): "conditions of a place as assumptions",
    ("rbpsym.derivation.checks_places", "rbpsym.mechanics.events"): "which forces are one-sided is the statement",
    ("rbpsym.derivation.checks_places", "rbpsym.mechanics.ways"): "how strings run and springs lie is the statement",
}


def _is_checker(name: str) -> bool:
    return name.startswith(CHECKERS)


@pytest.mark.parametrize("module", [m for m in MODULES if _is_checker(m.name)], ids=lambda m: m.name)
def test_checkers_take_nothing_from_makers(module) -> None:
    taken = {name for _, name in module.imports() if name.startswith(MAKERS) and name not in DATA}
    assert {(module.name, name) for name in taken} <= SHARED.keys()


@pytest.mark.parametrize("module", [m for m in MODULES if m.name.startswith(MAKERS)], ids=lambda m: m.name)
def test_makers_take_nothing_from_checkers(module) -> None:
    assert not [name for _, name in module.imports() if _is_checker(name)]


def test_what_is_shared_is_still_there() -> None:
    found = {(m.name, name) for m in MODULES for _, name in m.imports() if _is_checker(m.name)}
    assert SHARED.keys() <= found
