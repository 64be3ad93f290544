"""What is said of a motion in phases says of which phase, and from when the time is counted."""

import re

import pytest

from rbpsym.derive import derive
from rbpsym.document.needless import is_struck
from rbpsym.expr import tree as t
from rbpsym.statement.loader import load_text
from tests.ask.test_unseen import HERE
from tests.library.derived import FOLLOWED, derived, problem
from tests.proof.test_assertions import said_in

IN_PHASES = [name for name in FOLLOWED if problem(name).phases]
COUNTED = "In this phase t is counted from its beginning."


@pytest.mark.parametrize("name", IN_PHASES)
def test_why_a_method_was_left_out_is_said_of_the_first_phase(name):
    for reason in re.findall(r"[^.]*(?:does not apply|cannot determine)", said_in(derived(name))):
        assert reason.strip().startswith("In the first phase:"), reason


@pytest.mark.parametrize("name", IN_PHASES)
def test_only_a_later_phase_with_a_time_in_it_says_from_when_it_is_counted(name):
    told = said_in(derived(name))
    later = (step for phase in derived(name).phases for step in phase.derivation.steps)
    assert (COUNTED not in told) or any("t" in t.names(step.statement) for step in later)


def test_the_belt_runs_on_with_a_time_of_its_own():
    assert COUNTED in said_in(derived("cylinder-on-belt"))


def test_what_is_constant_is_said_to_be_constant_also_where_something_is_driven():
    assert "Along the motion B, D and N are constant" in said_in(derived("cylinder-on-belt"))


def test_phases_are_told_up_to_the_first_that_is_not_known():
    found = derive(load_text((HERE / "rod-strikes-puck.toml").read_text(encoding="utf-8")), simulation=False)
    assert [phase.name for phase in found.phases] == ["struck"]
    told = said_in(found, "standard")
    assert "kinetic energy that is lost" in told and "The later phases of the motion are left out" in told


def test_a_place_of_rest_is_told_beside_the_others():
    found = derive(load_text((HERE / "ring-and-spring.toml").read_text(encoding="utf-8")), simulation=False)
    told = said_in(found, "standard")
    assert "At θ = 0 the forces balance; whether" in told and told.index("At θ = 0") < told.index("also balance wherever else")


@pytest.mark.parametrize("name", IN_PHASES)
def test_what_is_struck_at_once_has_no_phase_before(name):
    told = said_in(derived(name), "standard")
    assert is_struck(derived(name).study) != bool(re.search("It has (a second phase|further phases)", told))
