"""How a later answer follows from earlier ones, for errors carried forward.

The quantities that were asked before are left as symbols in the mechanics (a moment of inertia, an acceleration, a
speed), and the same engine makes the later quantity of them: nothing is said by hand. Where several earlier
answers matter, there is a way for each alone and for each of their combinations.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from rbpsym.algebra import atoms
from rbpsym.algebra.calculus import substitute
from rbpsym.algebra.scalar import NOTHING, Scalar, symbol
from rbpsym.algebra.squares import with_squares
from rbpsym.errors import RbpsymError
from rbpsym.mechanics.dynamics import reactions_by_acceleration
from rbpsym.mechanics.study import Study
from rbpsym.notation import tree as t
from rbpsym.teaching.bench import Bench, formula_of
from rbpsym.teaching.distractors import shown
from rbpsym.teaching.misconceptions.change import with_inertia
from rbpsym.teaching.model import FollowOn, Item
from rbpsym.teaching.situations import names_in
from rbpsym.teaching.solving import number_names
from rbpsym.teaching.targets import REFUSALS, Target, axes

SOURCES = ("moment", "axis-moment", "acceleration", "speed")
TAILS = {"acceleration": "_ddot", "speed": "_dot"}
MOST_SOURCES = 3
Source = tuple[str, str]  # (id of the item, id of the quantity that it asks for)


def follow_ons(bench: Bench, target: Target, before: Sequence[Item], kind: str) -> Iterator[FollowOn]:
    """The ways from earlier items of the same problem to a target; `kind` is “formula” or “number”."""
    sources = _sources(bench, target, before, kind)
    for chosen in (some for size in range(1, len(sources) + 1) for some in combinations(sources, size)):
        quantities = tuple(quantity for _, quantity in chosen)
        node = bench.once(("follow", target.id, kind, quantities), lambda q=quantities: _node(bench, target, q, kind))
        if node is not None:
            (first, quantity), *others = chosen
            beside = tuple((item, name_of(other)) for item, other in others)
            yield FollowOn(first, name_of(quantity), node, beside=beside)


def _sources(bench: Bench, target: Target, before: Sequence[Item], kind: str) -> list[Source]:
    """The last item for each quantity that may matter."""
    kinds = ("formula",) if kind == "formula" else ("formula", "number")
    found: dict[str, str] = {}
    for item in before:
        quantity = item.asked.quantity
        fits = item.kind in kinds and item.asked.problem == bench.name and quantity.partition(".")[0] in SOURCES
        if fits and quantity != target.id:
            found[quantity] = item.id
    return [(item, quantity) for quantity, item in list(found.items())[-MOST_SOURCES:]]


def name_of(quantity: str) -> str:
    """The symbol that stands for an earlier answer: theta_ddot for acceleration.theta, a name of its own for a moment."""
    kind, _, name = quantity.partition(".")
    return f"{name}{TAILS[kind]}" if kind in TAILS else f"own.{quantity}"


def _node(bench: Bench, target: Target, quantities: tuple[str, ...], kind: str) -> t.Node | None:
    """The target as a formula in the symbols of earlier answers; None if one of them does not matter."""
    supplied = {name_of(quantity) for quantity in quantities}
    asked = t.names(formula_of(bench, target)) if kind == "formula" else number_names(bench, target)
    try:
        study = _with_moments(bench.study, quantities)
        value = _value(study, target, supplied)
        if value is None:
            return None
        hidden = {n: square for n, square in study.squares.items() if f"{n}_dot" not in supplied | set(asked)}
        value = with_squares(value, hidden)
    except (*REFUSALS, RbpsymError):
        return None
    speeds = [name for name in supplied if name.endswith("_dot")]
    extra = {name for name in names_in(value) - supplied - set(asked) if name.endswith(("_dot", "_ddot"))}
    if extra or not supplied <= names_in(value) or not all(is_even(value, name) for name in speeds):
        return None
    node = shown(value, bench.study)
    return target.reading.node(node) if kind == "number" and target.reading else node


def _with_moments(study: Study, quantities: tuple[str, ...]) -> Study:
    """The mechanics in which the moments of inertia that were asked for are symbols."""
    for quantity in quantities:
        kind, _, body = quantity.partition(".")
        if kind in TAILS:
            continue
        own, state = symbol(name_of(quantity)), study.system.bodies[body]
        away = state.mass * axes(study)[body][1] if kind == "axis-moment" else None
        study = with_inertia(study, body, moment=own if away is None else own - away)
    return study


def _value(study: Study, target: Target, supplied: set[str]) -> Scalar | None:
    """The target in the state; an unknown force, or the square of a speed, by the accelerations that are supplied."""
    if target.kind == "speed":
        return _square(study, target.id.removeprefix("speed."), supplied)
    if target.kind != "reaction":
        return target.value(study)
    name, given = target.id.removeprefix("reaction."), study.dynamics.accelerations or {}
    if not any(acceleration in supplied for acceleration in given):
        return study.dynamics.reactions.get(name)
    value = reactions_by_acceleration(study.system).get(name)
    others = {key: found for key, found in given.items() if key not in supplied}
    return None if value is None else substitute(value, others)


def _square(study: Study, name: str, supplied: set[str]) -> Scalar | None:
    """q̇², gained in the measure in which the own acceleration is greater or smaller than the right one."""
    square, key = study.squares.get(name), f"{name}_ddot"
    actual = (study.dynamics.accelerations or {}).get(key)
    if square is None or key not in supplied or not actual:
        return square
    first = study.system.scope.start.get(f"{name}_dot", NOTHING)
    return first * first + (square - first * first) * (symbol(key) / actual)


def is_even(value: Scalar, name: str) -> bool:
    """Whether a value holds even powers of a name only (then the sense of a speed does not matter)."""
    index = atoms.intern("symbol", name)
    return all(not power % 2 for poly in (value.num, value.den) for power in poly.by_power(index))
