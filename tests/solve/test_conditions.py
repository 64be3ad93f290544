"""The conditions that stand under the formulas of the results on a page stand in the answer for machines too."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path

import pytest

from rbpsym.decide.equal import scalars_equal
from rbpsym.errors import RbpsymError, ReadError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, has_roots, substitute
from rbpsym.field.normal import is_zero
from rbpsym.field.scalar import Scalar, symbol
from rbpsym.mechanics.demands import Demand
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.numbers import floating
from rbpsym.mechanics.pushing import begins, begun_numbers
from rbpsym.solve import answer_of, solve
from rbpsym.statement import load_text
from rbpsym.typeset.machine import to_machine
from tests.library.derived import FOLLOWED, NAMES, problem, unsimulated

FALLING = """
[parameters]
m = "mass, nonnegative"
g = "acceleration"
[coordinates.y]
dimension = "length"
start = "0"
speed = "0"
[bodies.block]
shape = "particle"
mass = "m"
center = ["0", "-y"]
[interactions.W]
type = "gravity"
"""


def test_a_divisor_that_cancels_is_told():
    found = solve(load_text(FALLING), simulation=False)
    assert found["accelerations"] == {"y": "g"} and found["valid_where"] == ["m != 0"]


def under_results(derivation):
    """The values, with their relations, that are open under the equations of motion, the forces and the first integral."""
    for step in derivation.steps:
        if step.id.startswith("motion.from_") or not step.id.startswith(("motion.", "reaction.", "square.")):
            continue
        for duty in step.certificate.verdict.open_obligations:
            yield _asked(derivation, duty)


def _asked(derivation, duty) -> tuple[Scalar, str]:
    """What a duty asks for; where a root is not to vanish, its square is not."""
    value, op = derivation.letters.value(duty.relation.items[0]), duty.relation.ops[0]
    return (short(value * value) if op == "!=" and has_roots(value) else value), op


@pytest.mark.parametrize("name", NAMES)
def test_what_a_page_asks_for_the_answer_asks_for(name):
    found = unsimulated(name)
    told = answer_of(found)
    names = {*found.letters.scalars, *found.study.letters.quantities, *found.study.system.scope.rates, "t"}
    known = [Demand(found.letters.value(read_infix(text.rpartition(" ")[0].rpartition(" ")[0], names)), text.split()[-2])
             for text in (*told["valid_where"], *told["start_valid_where"])]  # fmt: skip
    for value, op in under_results(found):
        assert any(_follows(value, op, one) for one in known), (name, value, op)


# Open conditions of a step that no entry of the answer tells; to be empty.
NOT_TOLD = {
    "cylinder-in-rolling-pipe": {"kept.x"},  # the kept momentum is divided by 1 - cos theta
    "spring-coupled-pendulums": {"work.S.left", "work.S.right"},
    "rod-over-rim-of-bowl": {"equilibrium.1", "linear.1", "frequency.1"},  # radicands that are always positive, undecided
}


@pytest.mark.parametrize("name", FOLLOWED)
def test_every_open_condition_of_a_page_stands_in_the_answer(name):
    """Wherever it stands there; the speeds by which other roads to the equation of motion divide are no part of it, and of
    one-sided forces the answer has a list."""
    found = unsimulated(name)
    assert _missing(found, found.steps, answer_of(found)) == NOT_TOLD.get(name, set())


@pytest.mark.parametrize("name", [name for name in FOLLOWED if problem(name).phases])
def test_every_open_condition_of_a_later_phase_stands_in_its_part_of_the_answer(name):
    """Those of how it begins and of what follows."""
    found = unsimulated(name)
    for phase, told in zip(found.phases, answer_of(found)["phases"], strict=False):
        assert not _missing(phase.derivation, (*phase.begins, *phase.derivation.steps), told), told["name"]


def _missing(found, steps, told) -> set[str]:
    """The steps of which something is open that the answer does not tell."""
    names = {*found.letters.scalars, *found.study.letters.quantities, *found.study.system.scope.rates, "t"}
    known = _known(found, told, names)
    sided = [symbol(row["force"]) for row in told["one_sided"]]
    missing = set()
    for step in steps:
        for duty in () if step.id.startswith("motion.from_") else step.certificate.verdict.open_obligations:
            try:
                value, op = _asked(found, duty)
            except ReadError:  # of values at the start alone
                missing.add(step.id)
                continue
            if value not in sided and not any(_tells(one, value, op, found) for one in known):
                missing.add(step.id)
    return missing


def _tells(one: Demand, value: Scalar, op: str, found) -> bool:
    same = _follows(value, op, one) or scalars_equal(value, one.value, found.study.assumptions).is_proved
    return one.op in (op, ">") and same


def _known(found, told, names) -> list[Demand]:
    """All conditions that stand anywhere in the answer, as far as their letters are those of the first phase."""
    known = []
    for text in _conditions(told):
        left, op, _ = text.rsplit(" ", 2)
        with suppress(RbpsymError):
            known.append(Demand(found.letters.value(read_infix(left, names)), op))
    return known


def _conditions(told) -> Iterator[str]:
    if isinstance(told, Mapping):
        for key, value in told.items():
            yield from (value or ()) if key.endswith("valid_where") else _conditions(value) if key != "questions" else ()
    elif isinstance(told, list):
        for value in told:
            yield from _conditions(value)


WAYS = {"linear-molecule": {"x_2 - x_1 > 0", "x_3 - x_2 > 0"}, "block-on-table": {"d - x > 0", "h + x > 0"}}


@pytest.mark.parametrize(("name", "asked"), WAYS.items())
def test_the_ways_of_strings_and_springs_are_asked_for_on_the_whole_way(name, asked):
    """Springs on a line whose ends pass through each other, strings that are used up: there the formulas end."""
    found = unsimulated(name)
    assert asked <= {*answer_of(found)["valid_where"]}
    owed = [duty.relation for step in found.steps for duty in step.certificate.verdict.open_obligations]
    assert asked <= {to_machine(relation) for relation in owed}


def _follows(value: Scalar, op: str, one: Demand) -> bool:
    return any(is_zero(short(value - one.value * way)) for way in ((1, -1) if op == "!=" else (1,)))


LIMITED = [name for name in NAMES if any(element.values.get("limit") is not None for element in problem(name).constraints)]


@pytest.mark.parametrize("name", LIMITED)
def test_a_start_asks_for_no_more_friction_than_there_is(name):
    """With a little more than what is needed at the start it begins so, with a little less it does not."""
    study = unsimulated(name).study
    numbers, start = begun_numbers(study), {**dict.fromkeys(study.system.speeds, NOTHING), **study.system.scope.start}
    for need in study.friction_needs:
        needed = abs(floating(substitute(need.ratio, start), numbers))
        limit = next((q.name for q in study.problem.parameters if need.limit == symbol(q.name)), None)
        for factor in (0.99, 1.01) if needed and limit else ():
            asked = [floating(one.value, {**numbers, limit: factor * needed}) >= 0 for one in begins(study)]
            assert all(asked) is (factor > 1), (need.constraint, factor)


def test_a_start_that_static_friction_cannot_hold_is_refused():
    text = (Path(__file__).parents[2] / "derivations/friction/box-pushed-at-top.toml").read_text(encoding="utf-8")
    text = text.partition("[meanings.es]")[0].replace('["P", "0"]', '["m*g", "0"]').replace('P  = "force: push"', "")
    text = text.replace('mu = "number: coefficient of static friction"', "")
    held, slipping = (text.replace('limit    = "mu"', f'limit = "{limit}"') for limit in ("1", "1/2"))
    assert solve(load_text(held), simulation=False)["start_valid_where"] == ["b - 2*h >= 0"]
    with pytest.raises(StatementError, match="would slip at the start"):
        solve(load_text(slipping), simulation=False)
