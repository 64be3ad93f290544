"""Positions of rest, their stability, and small oscillations about them."""

from __future__ import annotations

from rbpsym.algebra.calculus import derivative, substitute
from rbpsym.algebra.poly import ONE
from rbpsym.algebra.present import present_ratio
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation.draft import MUCH_SHORTER, Draft, length
from rbpsym.derivation.step import FULL, STANDARD
from rbpsym.mechanics.oscillation import Equilibrium, resting_forces
from rbpsym.notation import tree as t


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "oscillations"
    for place, item in enumerate(draft.study.equilibria, 1):
        _equilibrium(draft, item, place)


def _equilibrium(draft: Draft, item: Equilibrium, place: int) -> None:
    rows = [t.equation(t.Sym(name), draft.show(value)) for name, value in item.at.items()]
    names = [t.Sym(name) for name in item.at]
    forces = [force for force in resting_forces(draft.study.system, draft.study.dynamics) if force]
    zero = (
        t.System(tuple(t.equation(draft.show(f, factor=True), t.ZERO) for f in forces))
        if len(forces) > 1
        else (t.equation(draft.show(forces[0], factor=True), t.ZERO))
    )
    verdict = {True: "stable", False: "unstable", None: "unclear"}[item.stable]
    linear = _is_linearized(draft, item)
    there = _at(draft, zero, item)
    draft.add(
        f"equilibrium.{place}",
        "equilibrium",
        there if isinstance(there, t.System) else t.System((there,)),
        f"oscillations.{verdict}",
        level=FULL if linear or item.stable is False else STANDARD,
        premises=[f"motion.{n}" for n in draft.study.system.independent],
        names=names,
        count=len(names),
        place=rows,
        told=linear,
        data={"at": item.at},
    )
    if linear:
        _linearized(draft, item, place, f"oscillations.linear.{verdict}", rows)
    elif item.stable:
        _modes(draft, item, place)


def _at(draft: Draft, zero: t.Node, item: Equilibrium) -> t.Node:
    """The equations of rest with the place put in: identities."""

    def put(node: t.Node) -> t.Node:
        if isinstance(node, t.Sym) and node.name in item.at:
            return draft.show(item.at[node.name])
        return node

    return _mapped(zero, put)


def _mapped(node: t.Node, change) -> t.Node:
    """The tree with every node changed from the leaves upwards."""
    from dataclasses import fields, replace

    values = {}
    for field in fields(node):
        value = getattr(node, field.name)
        if isinstance(value, t.Node):
            values[field.name] = _mapped(value, change)
        elif isinstance(value, tuple) and value and isinstance(value[0], t.Node):
            values[field.name] = tuple(_mapped(v, change) for v in value)
    return change(replace(node, **values) if values else node)


def _is_linearized(draft: Draft, item: Equilibrium) -> bool:
    """Whether one coordinate and one frequency tell the whole small motion."""
    single = len(draft.study.system.independent) == 1 or len(item.frequencies_squared) == 1
    known = draft.study.dynamics.accelerations is not None
    return single and known and bool(item.frequencies_squared) and len(item.at) == 1


def _linearized(draft: Draft, item: Equilibrium, place: int, phrase: str, there: list[t.Node]) -> None:
    """q̈ ≈ -ϑ² (q - q₀) and the frequency."""
    accelerations = draft.study.dynamics.accelerations
    [name] = item.at
    value = _at_rest(draft, accelerations[f"{name}_ddot"])
    slope = substitute(derivative(value, name), item.at)
    letter = t.Sym(draft.free(_letter(draft, item)))
    square = item.frequencies_squared[0]
    shown = _forms(draft, _frequency(draft, item, square), square)
    deviation = t.add(t.Sym(name), t.neg(draft.show(item.at[name]))) if item.at[name] else t.Sym(name)
    linear = _linear(draft, shown[-1], deviation)
    draft.add(
        f"linear.{place}",
        "linearization",
        t.relation(t.Sym(f"{name}_ddot"), "~", linear),
        phrase,
        place=there,
        premises=[f"equilibrium.{place}", f"motion.{name}"],
        coordinate=t.Sym(name),
        data={"value": value, "name": name, "at": item.at, "slope": slope, "scalar": -square},
    )
    if item.stable:
        draft.context.scalars[letter.name] = _root(square)
        draft.add(
            f"frequency.{place}",
            "identity",
            t.equation(t.Pow(letter, t.TWO), *shown),
            "oscillations.frequency",
            premises=[f"linear.{place}"],
            is_result=True,
            letter=letter,
        )


def _letter(draft: Draft, item: Equilibrium) -> str:
    """The angular frequency; numbered if there are several stable places."""
    stable = [other for other in draft.study.equilibria if other.stable]
    return f"vartheta_{stable.index(item) + 1}" if item in stable and len(stable) > 1 else "vartheta"


def _frequency(draft: Draft, item: Equilibrium, square: Scalar) -> t.Node:
    """Stiffness over inertia for one degree of freedom, else the root as it is."""
    if len(item.stiffness) == 1 and item.stiffness[0][0].den is ONE and item.inertia[0][0].den is ONE:
        return present_ratio(item.stiffness[0][0].num, item.inertia[0][0].num, draft.study.style)
    return draft.show(square, factor=True)


def _forms(draft: Draft, raw: t.Node, square: Scalar) -> list[t.Node]:
    """Stiffness over inertia, and what it comes to if that is much shorter."""
    shown = draft.show(square, factor=True)
    return [raw, shown] if length(shown) <= MUCH_SHORTER * length(raw) else [raw]


def _linear(draft: Draft, shown: t.Node, deviation: t.Node) -> t.Node:
    around = t.Group(deviation) if isinstance(deviation, t.Add) else deviation
    return t.neg(t.mul(shown, around))


def _root(square: Scalar) -> Scalar:
    from rbpsym.algebra.calculus import root

    return root(square)


def _at_rest(draft: Draft, value: Scalar) -> Scalar:
    return substitute(value, dict.fromkeys(draft.study.system.speeds, NOTHING))


def _modes(draft: Draft, item: Equilibrium, place: int) -> None:
    """Squares of the frequencies of the normal modes."""
    rows = []
    for k, square in enumerate(item.frequencies_squared, 1):
        letter = draft.free(f"vartheta_{k}" if place == 1 else f"vartheta_{place}{k}")
        draft.context.scalars[letter] = _root(square)
        rows.append(t.equation(t.Pow(t.Sym(letter), t.TWO), draft.show(square, factor=True)))
    if rows:
        statement = rows[0] if len(rows) == 1 else t.System(tuple(rows))
        draft.add(
            f"modes.{place}",
            "normal_modes",
            statement,
            "oscillations.modes",
            count=len(rows),
            is_result=True,
            premises=[f"equilibrium.{place}"],
            data={"item": item},
        )
