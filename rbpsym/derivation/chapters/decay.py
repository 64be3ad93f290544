"""Small motions in which speeds damp each other: the polynomial of e^{λt}, its modes, and Hurwitz's conditions.

det(M λ² + C λ + K) = 0. A linear factor is a motion that dies out at a rate; a quadratic one, λ² + 2γλ + ϑ², swings
with √(ϑ² - γ²) while it dies out like e^{-γt}, or creeps back where γ > ϑ; of longer ones it is said under which
conditions all roots have negative real parts. Meriam & Kraige, Dynamics, 8.2; Gantmacher, Theory of Matrices, XV.
"""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on, root
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.roots import simplified_root
from rbpsym.algebra.scalar import Scalar, symbol
from rbpsym.derivation.draft import Draft, length
from rbpsym.derivation.step import FULL, STANDARD
from rbpsym.equality.signs import sign
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.linear import Powers, conditions
from rbpsym.mechanics.oscillation import Equilibrium
from rbpsym.notation import tree as t

LONGEST = 120
SWINGS = {"positive": "surely", "negative": "never"}


def write(draft: Draft, item: Equilibrium, place: int) -> None:
    """The polynomial and what follows from each of its factors, for a place that is not unstable."""
    if not item.linear.factors:
        return
    _polynomial(draft, item, place)
    for k, powers in enumerate(item.linear.factors, 1):
        way = FACTORS.get(len(powers), _conditions) if item.stable else _conditions
        way(draft, item, powers, f"{place}.{k}", f"_{k}" if len(item.linear.factors) > 1 else "")


def _polynomial(draft: Draft, item: Equilibrium, place: int) -> None:
    letter, linear = t.Sym(draft.free("lamda")), item.linear
    factors = [_in_powers(draft, powers, letter) for powers in linear.factors]
    if linear.zeros:
        factors.insert(0, _power(letter, linear.zeros))
    shown = t.mul(*(t.Group(f) if isinstance(f, t.Add) and len(factors) > 1 else f for f in factors))
    draft.add(
        f"characteristic.{place}",
        "polynomial",
        t.equation(shown, t.ZERO),
        "oscillations.polynomial",
        level=STANDARD if length(shown) <= LONGEST else FULL,
        premises=[f"linear.{place}"],
        letter=letter,
        growth=t.Fn("exp", t.mul(letter, t.Sym("t"))),
        data=item.facts,
    )


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
    draft.add(
        f"rate.{id}",
        "rate_of_mode",
        t.equation(letter, draft.show(value, factor=True)),
        "oscillations.rate",
        premises=[f"characteristic.{id.split('.')[0]}"],
        is_result=True,
        letter=letter,
        data=item.facts,
    )


def _pair(draft: Draft, item: Equilibrium, powers: Powers, id: str, mark: str) -> None:
    """A mode that swings, or would without its damping."""
    square = short(powers[2] / powers[0])
    if not is_zero(powers[1]):
        return swinging(draft, item, short(powers[1] / powers[0]), square, id, mark, "mode")
    letter = t.Sym(draft.free(f"vartheta{mark}"))
    draft.context.scalars[letter.name] = root(square)
    draft.add(
        f"frequency.{id}",
        "motion_of_mode",
        t.equation(t.Pow(letter, t.TWO), draft.show(square, factor=True)),
        "oscillations.undamped_mode",
        premises=[f"characteristic.{id.split('.')[0]}"],
        is_result=True,
        letter=letter,
        data={**item.facts, "decay": square * 0, "square": square},
    )
    return None


def swinging(draft: Draft, item: Equilibrium, damping: Scalar, square: Scalar, id: str, mark: str, of: str) -> None:
    """λ² + (damping) λ + (square): the rate of decay, the damped frequency, and the critical damping."""
    decay = draft.define(draft.free(f"gamma{mark}"), damping / 2)
    letter = t.Sym(draft.free(f"vartheta{mark}_d"))
    damped = short(square - damping * damping / 4)
    draft.context.scalars[letter.name] = root(damped)
    said = SWINGS.get(sign(damped, draft.study.assumptions).kind, "perhaps")
    data = {**item.facts, "decay": damping / 2, "square": square}
    near = f"{'linear' if of == 'alone' else 'characteristic'}.{id.split('.')[0]}"
    draft.add(
        f"decay.{id}",
        "motion_of_mode",
        t.equation(decay, draft.show(damping / 2, factor=True)),
        f"oscillations.decay.{of}",
        premises=[near],
        is_result=True,
        letter=decay,
        data=data,
    )
    draft.add(
        f"damped.{id}",
        "motion_of_mode",
        t.equation(t.Pow(letter, t.TWO), draft.show(damped, factor=True)),
        f"oscillations.damped.{said}",
        premises=[near, f"decay.{id}"],
        is_result=said != "never",
        letter=letter,
        decay=decay,
        data=data,
    )
    if said == "perhaps":
        _critical(draft, item, damping, square, id)


def _critical(draft: Draft, item: Equilibrium, damping: Scalar, square: Scalar, id: str) -> None:
    """The value of the one parameter to which the damping is proportional at which the mode ceases to swing."""
    for quantity in draft.study.problem.parameters:
        each = short(damping / symbol(quantity.name))
        if depends_on(damping, quantity.name) and not any(depends_on(v, quantity.name) for v in (each, square)):
            positive = simplified_root(square, lambda name: draft.study.assumptions.sign_of(name) == "positive")
            value = short(positive * 2 / each)
            letter = draft.define(draft.free(f"{quantity.name}_crit"), value)
            draft.add(
                f"critical.{id}",
                "critical",
                t.equation(letter, draft.show(value, factor=True)),
                "oscillations.critical",
                premises=[f"damped.{id}"],
                is_result=True,
                name=t.Sym(quantity.name),
                letter=letter,
                data={"name": quantity.name, "damping": damping, "square": square},
            )
            return


def _conditions(draft: Draft, item: Equilibrium, powers: Powers, id: str, mark: str) -> None:
    """What has to be positive so that all motions of a factor die out; by name where it is not certain."""
    rows, assumptions = [], draft.study.assumptions
    for value in conditions(powers):
        shown = draft.show(value, factor=True)
        if sign(value, assumptions).kind == "positive":
            rows.append(t.relation(shown, ">", t.ZERO))
        else:
            rows.append(t.equation(draft.define(draft.free(f"H_{len(rows) + 1}"), value), shown))
    left = [t.relation(draft.show(value, factor=True), ">", t.ZERO) for value in item.nature.conditions]
    draft.add(
        f"hurwitz.{id}",
        "hurwitz",
        rows[0] if len(rows) == 1 else t.System(tuple(rows)),
        "oscillations.hurwitz_open" if left else "oscillations.hurwitz",
        level=STANDARD if all(length(row) <= LONGEST for row in rows) else FULL,
        premises=[f"characteristic.{id.split('.')[0]}"],
        conditions=left,
        data={**item.facts, "powers": powers, "conditions": item.nature.conditions},
    )


FACTORS = {2: _rate, 3: _pair}
