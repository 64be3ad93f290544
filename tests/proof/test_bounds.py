"""A derivation comes to its end whatever is granted to it, keeps what it has proved, and tells what is missing."""

import importlib
import zlib
from pathlib import Path
from types import SimpleNamespace

import pytest

from rbpsym import load_problem
from rbpsym.errors import LimitError, NotApplicable, RbpsymError
from rbpsym.field.effort import apart, ask_for_more, at_most, in_all, kept, spend
from rbpsym.oracles import simulation_phases
from tests.proof.conftest import FILES, drafted

pytestmark = pytest.mark.heavy

derive = importlib.import_module("rbpsym.derive")
GRANTED = (300, 1000, 3000, 8000)
TOLD = {"too_long", "cut"}
LINKAGE = Path(__file__).parent / "four-bar.toml"


@pytest.mark.parametrize("name", sorted(FILES))
def test_what_is_cut_short_is_told(name, monkeypatch):
    """Each problem with a bound drawn by its name."""
    whole = {step.id for step in drafted(name).steps}
    monkeypatch.setattr(derive, "MOST_IN_ALL", GRANTED[zlib.crc32(name.encode()) % len(GRANTED)])
    found = derive.derive(load_problem(FILES[name]), simulation=False)
    reasons = {item.method: item.phrase.removeprefix("skipped.") for item in found.skipped}
    later = reasons.pop("phases", "")
    kept = {step.id for step in found.steps}
    assert all(step.certificate.verdict.is_proved for step in found.all_steps)
    assert kept < whole if TOLD & {*reasons.values()} else kept == whole
    assert bool(found.phases) is (bool(found.study.problem.phases) and not later)


def test_what_no_one_can_prove_at_length_does_not_go_on_without_end(monkeypatch):
    """Four-bar linkage of unlike rods: its places, momenta and forces are told, and that the rest is too long."""
    monkeypatch.setattr(derive, "MOST_IN_ALL", 200_000)
    found = derive.derive(load_problem(LINKAGE), simulation=False)
    assert {"kinematics", "inertia", "momentum", "forces"} <= {step.chapter for step in found.steps}
    assert {"what": "newton-euler", "why": "too_long"} in found.summary()["left_out"]


class Costly:
    """Has a value that costs 8 products, and another one that stands for it where these are too many."""

    @kept
    def value(self) -> str:
        try:
            spend(8)
        except LimitError:
            return "none"
        return "whole"


@pytest.mark.parametrize("carry_out", [derive._written, lambda draft, write: derive._carried_out(draft, "road", write)])
def test_what_was_cut_short_is_not_kept(carry_out, monkeypatch):
    """A chapter that ends because nothing is left of the whole work leaves nothing behind as if it were not there."""
    draft, costly = SimpleNamespace(chapter="motion", steps=[], forget=lambda kept: None, skip=lambda *_, **__: None), Costly()
    monkeypatch.setattr(derive, "MOST_IN_ALL", 4)
    with in_all(4):
        assert not carry_out(draft, lambda draft: costly.value)
    assert costly.value == "whole"


def test_a_simulation_that_gave_up_is_told(monkeypatch):
    def gives_up(study):
        raise NotApplicable("it did not get beyond the time 1")

    monkeypatch.setattr(simulation_phases, "simulate_problem", gives_up)
    found = derive.derive(load_problem(FILES["rod-pendulum"]))
    assert found.simulation is None and {"what": "simulation", "why": "simulation"} in found.summary()["left_out"]


def test_what_is_spent_apart_counts_for_the_whole():
    with in_all(10):
        with at_most(5), apart(), at_most(9):
            spend(8)
        ask_for_more()
        with pytest.raises(LimitError):
            spend(3)
        with pytest.raises(RbpsymError):
            ask_for_more()
    ask_for_more()
