"""Small motions in which speeds damp each other: the polynomial of e^{λt}, its modes, and Hurwitz's conditions.

det(M λ² + C λ + K) = 0. A linear factor is a motion that dies out at a rate; a quadratic one, λ² + 2γλ + ϑ², swings
with √(ϑ² - γ²) while it dies out like e^{-γt}, or creeps back where γ > ϑ; of longer ones it is said under which
conditions all roots have negative real parts. Meriam & Kraige, Dynamics, 8.2; Gantmacher, Theory of Matrices, XV.
"""

from __future__ import annotations

from typing import Any

from rbpsym.decide.rooted import root_of
from rbpsym.decide.signs import sign
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, depends_on, is_zero, root, short, symbol
from rbpsym.mechanics.oscillation import Equilibrium, Powers, conditions, decaying
from rbpsym.mechanics.stability import essential
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import FULL, STANDARD

LONGEST = 120
SWINGS = {"positive": "surely", "negative": "never"}


def write(draft: Draft, item: Equilibrium, place: int) -> None:
    """The polynomial and what follows from each of its factors, for a place that is not unstable."""
    if not item.linear.factors:
        return
    _polynomial(draft, item, place)
    for k, powers in enumerate(item.linear.factors, 1):
        signs = {sign(value, draft.study.assumptions).kind for value in powers}
        way = FACTORS.get(len(powers), _conditions) if signs <= {"positive", "zero"} else _conditions
        way(draft, item, powers, f"{place}.{k}", f"_{k}" if len(item.linear.factors) > 1 else "")


def _add(draft: Draft, item: Equilibrium, id: str, rule: str, statement: t.Node, phrase: str, **more: Any) -> None:
    """A step that follows from the polynomial, but for other `premises`; `data` beside where the place is."""
    told = {"premises": [f"characteristic.{id.split('.')[1]}"], "is_result": True, **more}
    draft.add(id, rule, statement, f"oscillations.{phrase}", **{**told, "data": {**item.facts, **more.get("data", {})}})


def _polynomial(draft: Draft, item: Equilibrium, place: int) -> None:
    letter, linear = t.Sym(draft.free("lamda")), item.linear
    factors = [_in_powers(draft, powers, letter) for powers in linear.factors]
    if linear.zeros:
        factors.insert(0, _power(letter, linear.zeros))
    shown = t.mul(*(t.Group(f) if isinstance(f, t.Add) and len(factors) > 1 else f for f in factors))
    told = {"level": STANDARD if length(shown) <= LONGEST else FULL, "premises": [f"linear.{place}"], "is_result": False}
    growth, id = t.Fn("exp", t.mul(letter, t.Sym("t"))), f"characteristic.{place}"
    _add(draft, item, id, "polynomial", t.equation(shown, t.ZERO), "polynomial", letter=letter, growth=growth, **told)


def _power(letter: t.Sym, exponent: int) -> t.Node:
    return letter if exponent == 1 else t.Pow(letter, t.Num(exponent))


def _in_powers(draft: Draft, powers: Powers, letter: t.Sym) -> t.Node:
    """a₀ λⁿ + a₁ λⁿ⁻¹ + …."""
    terms, degree = [], len(powers) - 1
    for k, value in enumerate(powers):
        shown = draft.show(value, factor=True)
        around = t.Group(shown) if isinstance(shown, t.Add) and k < degree else shown
        if not is_zero(value):
            terms.append(t.mul(around, _power(letter, degree - k)) if k < degree else shown)
    return t.add(*terms)


def _rate(draft: Draft, item: Equilibrium, powers: Powers, id: str, mark: str) -> None:
    """One motion that dies out without swinging."""
    value = short(powers[1] / powers[0])
    letter = draft.define(draft.free(f"gamma{mark}"), value)
    said = t.equation(letter, draft.show(value, factor=True))
    _add(draft, item, f"rate.{id}", "rate_of_mode", said, "rate", letter=letter)


def _pair(draft: Draft, item: Equilibrium, powers: Powers, id: str, mark: str) -> None:
    """A mode that swings, or would without its damping."""
    decay, square = decaying(powers)
    if decay:
        return swinging(draft, item, decay, square, id, mark, "mode")
    letter = draft.define(draft.free(f"vartheta{mark}"), root(square))
    said, data = t.equation(t.Pow(letter, t.TWO), draft.show(square, factor=True)), {"decay": decay, "square": square}
    return _add(draft, item, f"frequency.{id}", "motion_of_mode", said, "undamped_mode", letter=letter, data=data)


def swinging(draft: Draft, item: Equilibrium, decay: Scalar, square: Scalar, id: str, mark: str, of: str) -> None:
    """λ² + 2γλ + ϑ²: the rate of decay, the damped frequency, and the critical damping."""
    rate, damped = draft.define(draft.free(f"gamma{mark}"), decay), short(square - decay * decay)
    letter = draft.define(draft.free(f"vartheta{mark}_d"), root(damped))
    said = SWINGS.get(sign(damped, draft.study.assumptions).kind or "", "perhaps")
    near = [f"{'linear' if of == 'alone' else 'characteristic'}.{id.split('.')[0]}"]
    told = {"premises": near, "data": {"decay": decay, "square": square, "swings": said}}
    dies = t.equation(rate, draft.show(decay, factor=True))
    _add(draft, item, f"decay.{id}", "motion_of_mode", dies, f"decay.{of}", letter=rate, **told)
    swings = t.equation(t.Pow(letter, t.TWO), draft.show(damped, factor=True))
    _add(draft, item, f"damped.{id}", "motion_of_mode", swings, f"damped.{said}", letter=letter, **told)
    if said == "perhaps":
        _critical(draft, item, decay * 2, square, id)


def _critical(draft: Draft, item: Equilibrium, damping: Scalar, square: Scalar, id: str) -> None:
    """The value of the one parameter to which the damping is proportional at which the mode ceases to swing."""
    for name in (q.name for q in draft.study.problem.parameters):
        each = short(damping / symbol(name))
        if depends_on(damping, name) and not any(depends_on(value, name) for value in (each, square)):
            positive = root_of(square, draft.study.assumptions)
            value = short(positive * 2 / each)
            letter = draft.define(draft.free(f"{name}_crit"), value)
            said, data = t.equation(letter, draft.show(value, factor=True)), {"damping": damping, "square": square}
            told = {"premises": [f"damped.{id}"], "name": t.Sym(name), "letter": letter, "data": {**data, "name": name}}
            return _add(draft, item, f"critical.{id}", "critical", said, "critical", **told)
    return None


def _conditions(draft: Draft, item: Equilibrium, powers: Powers, id: str, mark: str) -> None:
    """What has to be positive so that all motions of a factor die out; by name where it is not certain."""
    rows: list[t.Node] = []
    left: dict[Scalar, t.Node] = {}
    for value in conditions(powers):
        shown = draft.show(value, factor=True)
        if sign(value, draft.study.assumptions).kind == "positive":
            rows.append(t.relation(shown, ">", t.ZERO))
        else:
            rows.append(t.equation(draft.define(draft.free(f"H_{len(rows) + 1}"), value), shown))
            needed = essential(value, draft.study.assumptions)
            left[needed] = t.relation(draft.show(needed, factor=True), ">", t.ZERO)
    told = {"level": STANDARD if all(length(row) <= LONGEST for row in rows) else FULL, "is_result": False}
    data = {"powers": powers, "conditions": tuple(left)}
    alone = len(item.linear.factors) == 1 and not item.linear.zeros
    alone = alone and (item.nature.proved == "asymptotic" or bool(item.nature.conditions))
    of = "whole" if alone else "part"
    phrase = f"hurwitz.{'open' if left else 'met'}.{of}"
    _add(draft, item, f"hurwitz.{id}", "hurwitz", t.system(rows), phrase, conditions=[*left.values()], data=data, **told)


FACTORS = {2: _rate, 3: _pair}
