"""No letter of the program meets one of the user's: all names of a problem are exchanged for letters and words that
rules, phrases and printers use; the physics stays the same up to the names, and what is printed is what was proved."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache

import pytest

from rbpsym.decide.assumptions import Assumptions
from rbpsym.decide.equal import scalars_equal
from rbpsym.derive import derive
from rbpsym.document.phrases import problem_notation
from rbpsym.errors import RbpsymError
from rbpsym.expr import tree as t
from rbpsym.expr.glyphs import ACCENTS, DOTS
from rbpsym.expr.infix import read_infix
from rbpsym.expr.latex.reader import read_latex
from rbpsym.field.calculus import substitute
from rbpsym.field.evaluate import scalar
from rbpsym.field.scalar import symbol
from rbpsym.proof.rules import certify
from rbpsym.proof.step import Derivation
from rbpsym.solve import results
from rbpsym.statement.references import RESERVED
from rbpsym.typeset.latex import to_latex
from tests.letters.renaming import Names, dictionary, original, renamed, symbols_of, things_of
from tests.library.derived import answered

PROBLEMS = (
    "rod-pendulum", "rod-and-disk-free", "rod-and-disk-fixed", "sliding-ladder", "sliding-ladder-with-spring",
    "disk-on-incline", "ball-slipping-to-rolling", "rod-caught-at-end", "double-compound-pendulum", "cart-and-rod",
    "half-disk-rocking", "linear-molecule", "atwood-with-massive-pulley", "disk-on-viscous-bearing",
    "race-of-shapes", "brake-drum", "two-gears", "ball-and-hinged-rod", "ladder-with-person", "disk-with-spring",
    "slider-crank", "cylinder-on-wedge", "torsion-pendulum", "breaking-chimney",
)  # fmt: skip
QUICK = (
    "rod-pendulum", "rod-and-disk-free", "sliding-ladder", "ball-slipping-to-rolling", "two-gears",
    "double-compound-pendulum", "half-disk-rocking",
)  # fmt: skip
# letters that derivations bring in, and words from which names are made and drawn
LETTERS = (
    "r", "s", "C", "K", "E", "L", "I", "U", "R", "P", "V", "A", "W", "F", "T", "N", "S", "e", "d", "f", "tau", "rho", "xi",
    "phi", "varphi", "vartheta", "omega", "gamma", "lamda", "mu", "theta", "eta", "zeta", "u", "v", "q", "x_cm", "y_cm",
    "I_cm", "K_prime", "l_0", "mu_min", "vartheta_1", "tau_O", "tau_C", "cal_W_T", "cal_w_c", "theta_dot0", "E_tot", "t_1",
    "K_1", "r_O", "R_cm", "omega_cm", "z", "I_O", "L_O", "tot", "d_x", "A_C_1", "theta_e", "a_end", "b_A", "cal",
    "Delta_x", "Delta", "O1", "P_hat", "J_hat", "nu", "Omega", "x_hat", "kappa",
)  # fmt: skip
WORDS = (
    "bar", "hat", "dot", "ddot", "tilde", "check", "prime", "cal", "T", "tot", "c", "nc", "C", "f", "x", "y",
    "end", "min", "A", "B", "P", "b", "e", "K", "E", "two", "r", "I", "N", "W", "rod", "disk", "one", "left", "L",
    "d", "O1", "Delta", "Delta_x", "theta", "omega", "tau", "alpha", "mu",
)  # fmt: skip
SEEDS = range(1)
ALWAYS = {"O", "t"}


def names_for(name: str, seed: int) -> Names:
    """Other names for all that the problem names."""
    chance, problem = random.Random(f"{name} {seed}"), original(name)
    letters = [letter for letter in LETTERS if letter not in RESERVED]
    symbols, things = symbols_of(problem), things_of(problem)
    new = chance.sample(letters, len(symbols))
    words = [word for word in WORDS if word not in RESERVED and word not in new]
    return Names(
        dict(zip(symbols, new, strict=True)),
        dict(zip(things, chance.sample(words, len(things)), strict=True)),
    )


@cache
def answer(name: str) -> dict:
    return answered(name)


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("name", [name for name in PROBLEMS if name not in QUICK])
def test_more_renamed(name: str, seed: int) -> None:
    test_renamed(name, seed)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", QUICK)
def test_renamed(name: str, seed: int) -> None:
    names = names_for(name, seed)
    try:
        problem = renamed(name, names)
        derivation = derive(problem, simulation=False)
    except RbpsymError as error:
        assert is_refusal_of_a_name(error), error
        return
    found = {**results(derivation.study), "verdicts": derivation.summary()}
    assert not [*unproved(derivation), *compared(name, names, found, derivation)]


def compared(name: str, names: Names, found: dict, derivation: Derivation) -> Iterator[str]:
    """Where the answer differs from that to the problem with its own names."""
    words = dictionary(original(name), derivation.study.problem)
    given = derivation.study.assumptions
    yield from differences(
        answer(name), found, lambda old, new: is_same(old, new, words, given), Tables(words, names.things)
    )


def is_refusal_of_a_name(error: RbpsymError) -> bool:
    if error.what.startswith("unknown symbol") and "Did you mean" in error.instead:
        return True  # a start that is nearly the name of a parameter is taken for a slip
    return "is reserved" in error.what or "are printed alike" in error.what or "is the name of" in error.what


def unproved(derivation: Derivation) -> Iterator[str]:
    """Steps that are not proved, and those whose print does not read back as what was proved."""
    for part in (derivation, *(phase.derivation for phase in derivation.phases)):
        notation = problem_notation(part.study.problem)
        context = part.letters
        for step in part.steps:
            if not step.certificate.verdict.is_proved:
                yield f"{step.id}: {step.certificate.verdict}"
            text = to_latex(step.statement, notation)
            held = {node.var for node in t.walk(step.statement) if isinstance(node, t.Integral)}
            try:
                back = read_latex(text, t.names(step.statement) | held | ALWAYS | {context.radius}, notation=notation)
            except RbpsymError as error:
                yield f"{step.id}: {text} can't be read: {error.what}"
                continue
            if not certify(context, replace(step, statement=back)).verdict.is_proved:
                yield f"{step.id}: {text} is read as something else"


def differences(
    old: object, new: object, same_: Callable[[str, str], bool], tables: Tables, path: tuple[str, ...] = ()
) -> Iterator[str]:
    """Where two answers are not the same up to the names."""
    told = f"{'/'.join(path)}: {old} is {new}"
    if isinstance(old, dict) and isinstance(new, dict):
        table = tables.of(path)
        renamed_ = {table.get(key, key): part for key, part in old.items()}
        if set(renamed_) != set(new):
            yield f"{'/'.join(path)}: {sorted(renamed_)} is {sorted(new)}"
        for key in set(renamed_) & set(new) - {"problem", "symbols", "reason"}:
            yield from differences(renamed_[key], new[key], same_, tables, (*path, key))
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for k, (a, b) in enumerate(zip(old, new, strict=True)):
            yield from differences(a, b, same_, tables, (*path, str(k)))
    elif isinstance(old, str) and isinstance(new, str):
        if not (tables.of(path).get(old, old) == new or tables.symbols.get(old, old) == new or same_(old, new)):
            yield told
    elif old != new:
        yield told


@dataclass(frozen=True)
class Tables:
    """What the keys below a path are called now."""

    symbols: Mapping[str, str]
    things: Mapping[str, str]

    def of(self, path: tuple[str, ...]) -> Mapping[str, str]:
        depth = len(path)
        if path[:1] in (("works",), ("forces",), ("angular_momentum",)):
            inner = {f"P_{old}": letters(f"P_{new}") for old, new in self.things.items()} if path[0][0] == "a" else {}
            force = {f: self.symbols[f] for f in self.symbols} if path[0] in ("works", "forces") else {}
            return {**force, **self.things, **inner} if depth <= 2 else {}
        if path[:1] in (("moments_of_inertia",), ("masses",)):
            return self.things if depth == 1 else {}
        if path[:1] in (("conditions",), ("static_friction",)) and depth == 2:
            return {}
        return self.symbols if depth and path[-1] not in FIXED else {}


FIXED = ("kinetic_energy", "equations_of_motion", "verdicts", "balance")


def letters(name: str) -> str:
    return re.sub(rf"_(?=({'|'.join((*ACCENTS, *DOTS, 'prime'))})$)", "__", name)


def is_same(old: str, new: str, words: Mapping[str, str], given: Assumptions) -> bool:
    """Whether two expressions are equal up to the names."""
    try:
        left = scalar(read_infix(old, {*words, "t", "d_t"}))
        right = scalar(read_infix(new, {*words.values(), "t", "d_t"}))
    except RbpsymError:
        return False
    return scalars_equal(substitute(left, {a: symbol(b) for a, b in words.items()}), right, given).is_proved
