"""What is claimed along a motion is decided along it, and no witness lies off the motion.

The law of roots: in each problem of the library in which the square of a speed is known as a function of
the place, its magnitude is the root of that, and it has the sense in which the motion sets out.
The law of witnesses: each refutation of a mutant names a place on the way from the start, inside the
declared ranges, at which the square of the speed is not negative.
"""

from __future__ import annotations

import math
from functools import cache

import pytest

from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.present import present
from rbpsym.mechanics.numbers import number
from rbpsym.notation import tree as t
from rbpsym.quantity.path import first_push, sense
from rbpsym.statement.library import library_folder, problem_files
from rbpsym.statement.loader import load_problem
from rbpsym.verify import claims_check
from rbpsym.verify.claims_check import decide
from rbpsym.verify.claims_ground import Ground, glossary, with_own_symbols
from rbpsym.verify.claims_model import Outcome, Setting
from rbpsym.verify.claims_run import Worlds
from tests.mutants.changed import is_different, mutants
from tests.mutants.run import trials

WORLDS = Worlds()
CLOSE = 1e-9


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


def on_the_motion(witness, motion):
    """What is wrong with a witness as a state of the motion, in words."""
    numbers = {name: float(value) for name, value in witness.numbers}
    for angle, c, s in witness.points:
        name, _, parts = angle.partition("/")
        numbers[name] = int(parts or 1) * math.atan2(float(s), float(c))
    for name, value in numbers.items():
        if motion.assumptions.sign_of(name) == "positive" and value <= 0:
            return f"{name} is not positive"
        lower, upper = motion.assumptions.range_of(name)
        below = lower is not None and value <= number(lower, numbers)
        if below or (upper is not None and value >= number(upper, numbers)):
            return f"{name} is outside its range"
    for name, square in motion.squares.items():
        if f"{name}_dot" in numbers:
            return f"the speed of {name} is taken at will"
        if name in numbers and name in motion.scope.start:
            try:
                begin = number(motion.scope.start[name], numbers)
                way = [begin + (numbers[name] - begin) * k / 50 for k in range(51)]
                least = min(number(square, {**numbers, name: here}) for here in way)
            except KeyError as error:
                return f"it does not say what {error} is"
            if least < -CLOSE:
                return f"the square of the speed of {name} is negative on the way"
    return ""


@pytest.fixture
def seen(monkeypatch):
    found, link = [], claims_check._link

    def watched(relation, verdict):
        if verdict.witness is not None and verdict.is_refuted:
            found.append(verdict.witness)
        return link(relation, verdict)

    monkeypatch.setattr(claims_check, "_link", watched)
    return found


CLAIMS = sorted((library_folder() / "claims").glob("*.toml"))


@pytest.mark.parametrize("path", CLAIMS, ids=lambda path: path.stem)
def test_no_witness_lies_off_the_motion(path, seen, monkeypatch):
    worlds, decided = [], claims_check._decided

    def watched(relation, ground, question):
        before = len(seen)
        link = decided(relation, ground, question)
        loose = any(claims_check._kind(side, ground) == "up to a constant" for side in relation.items)
        loose = loose or "start" not in question.depths  # what is demanded of all motions may fail on any
        if not loose and not ground.motion.is_free:  # "up to a constant" is an identity of all motions
            worlds.extend((witness, ground.motion, relation) for witness in seen[before:])
        return link

    monkeypatch.setattr(claims_check, "_decided", watched)
    list(trials(path, 4))
    assert not [(str(w), why, r) for w, motion, r in worlds if (why := on_the_motion(w, motion))]


@pytest.mark.parametrize("problem", sorted(problem_files()))
def test_no_witness_against_a_root_lies_off_the_motion(problem, seen):
    for name, square, _ in speeds(problem):
        relation = equation(t.Abs(t.Sym(f"{name}_dot")), t.Sqrt(present(square)))
        own = ground(problem)
        for other in list(mutants(relation, own))[:6]:
            if is_different(other, own, ""):
                assert decide(other, own).outcome is not Outcome.PROVED, other  # a root may have no value anywhere
        assert not [why for witness in seen if (why := on_the_motion(witness, own.motion))]
