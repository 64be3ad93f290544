"""What is claimed along a motion is decided along it, and no witness lies off the motion.

The law of roots: in each problem of the library in which the square of a speed is known as a function of
the place, its magnitude is the root of that, and it has the sense in which the motion sets out.
The law of witnesses (of the shipped claims too, see `tests.mutants`): each refutation of a mutant names a place on
the way from the start, inside the declared ranges, at which the square of the speed is not negative.
"""

from __future__ import annotations

from functools import cache

import pytest

from rbpsym.claims.check import decide
from rbpsym.claims.ground import Ground, glossary, with_own_symbols
from rbpsym.claims.model import Outcome, Setting
from rbpsym.claims.run import Worlds
from rbpsym.expr import tree as t
from rbpsym.field.normal import is_zero
from rbpsym.present.forms import present
from rbpsym.quantity.path import first_push, sense
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.claims.witnesses import off_the_motion, refutations
from tests.mutants.changed import is_different, mutants

pytestmark = pytest.mark.heavy

WORLDS = Worlds()


@cache
def ground(problem: str) -> Ground:
    setting = Setting(problem, problem)
    world = WORLDS(setting)
    words = glossary(with_own_symbols(setting, world).symbols)
    return Ground(world, words)


def speeds(problem):
    """(name, square, its sense) of the coordinates that move on a path that is known and not too long."""
    try:
        motion = ground(problem).motion
    except Exception:
        return []
    found = [(name, square) for name, square in motion.squares.items() if square and len(square.num.terms) < 30]
    return [(name, square, sense(motion, name)) for name, square in found if name in motion.scope.start]


def equation(left, right):
    return t.Chain((left, right), ("=",))


@pytest.mark.parametrize("problem", sorted(problem_files()))
def test_a_speed_is_the_root_of_its_square(problem):
    for name, square, way in speeds(problem):
        speed, root = t.Sym(f"{name}_dot"), t.Sqrt(present(square))
        assert decide(equation(t.Abs(speed), root), ground(problem)).outcome is Outcome.PROVED, (name, square)
        wrong = decide(equation(t.Abs(speed), t.Mul((t.TWO, root))), ground(problem))
        rests = not way and is_zero(first_push(ground(problem).motion, name))  # then 0 = 2·0 is true of it
        allowed = {Outcome.UNDECIDED} if rests else {Outcome.REFUTED}
        if _ends_at_once(problem):  # there is no way along which it could be seen
            allowed.add(Outcome.UNDECIDED)
        assert wrong.outcome in allowed, (name, wrong)
        if way:
            right, other = (root, t.Neg(root)) if way > 0 else (t.Neg(root), root)
            assert decide(equation(speed, right), ground(problem)).outcome is Outcome.PROVED, name
            assert decide(equation(speed, other), ground(problem)).outcome in allowed, name


def _ends_at_once(problem):
    phases = load_problem(problem_files()[problem]).phases
    return bool(phases) and phases[0].event == "at once"


@pytest.mark.parametrize("problem", sorted(problem_files()))
def test_no_witness_against_a_root_lies_off_the_motion(problem):
    for name, square, _ in speeds(problem):
        relation = equation(t.Abs(t.Sym(f"{name}_dot")), t.Sqrt(present(square)))
        own = ground(problem)
        with refutations() as seen:
            for other in list(mutants(relation, own))[:6]:
                if is_different(other, own, ""):
                    assert decide(other, own).outcome is not Outcome.PROVED, other  # a root may have no value anywhere
        assert not [why for witness in seen if (why := off_the_motion(witness, own.motion))]
