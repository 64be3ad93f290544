"""Fixed points about which bodies turn, and moments of inertia about them that add."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on
from rbpsym.algebra.normal import is_zero
from rbpsym.algebra.scalar import NOTHING, Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.mechanics import energy
from rbpsym.mechanics.inertia import tidy
from rbpsym.mechanics.system import BodyState
from rbpsym.notation import tree as t


def turns_about(draft: Draft, name: str, state: BodyState) -> dict[str, Scalar]:
    """Origins about which the body turns rigidly → square of the distance of its centre of mass."""
    found = {}
    for label, origin in draft.study.origins.items():
        arm = state.center - origin
        square = tidy(arm.dot(arm))
        moving = [*draft.study.system.coordinates, "t"]
        if any(depends_on(square, q) for q in moving) or not state.omega:
            continue
        if is_zero(energy.orbital_momentum(state, origin) - state.mass * square * state.omega):
            found[label] = square
    return found


def turning_together(draft: Draft, label: str) -> bool:
    """Whether all bodies turn about the fixed point with one angular velocity."""
    states = draft.study.system.bodies
    omega = next(iter(states.values())).omega
    alike = bool(omega) and all(is_zero(state.omega - omega) for state in states.values())
    return alike and all(label in turns_about(draft, name, state) for name, state in states.items())


def moment_about(draft: Draft, label: str) -> t.Sym:
    """The moment of inertia of the whole system about the fixed point about which it turns."""
    letter = t.Sym(draft.free(f"I_{label}"))
    [only] = list(draft.study.system.bodies)[:1]
    return letter if letter.name in draft.context.scalars else t.Sym(draft.of_body("I", only))


def moment_of(draft: Draft, name: str, label: str) -> t.Sym:
    """The moment of inertia of one of several bodies about the fixed point about which it turns."""
    about = t.Sym(draft.free(f"I_{name}_{label}"))
    return about if about.name in draft.context.scalars else t.Sym(draft.of_body("I", name))


def together(draft: Draft, label: str) -> None:
    """The moments of inertia about a common axis add."""
    names = list(draft.study.system.bodies)
    letters = [moment_of(draft, name, label) for name in names]
    total = sum((draft.context.scalars[letter.name] for letter in letters), NOTHING)
    whole = draft.define(draft.free(f"I_{label}"), total)
    draft.add(
        f"moment.together.{label}",
        "identity",
        t.equation(whole, t.add(*letters), draft.show(total)),
        "inertia.together",
        premises=[f"moment.{name}.{label}" for name in names] + [f"moment.{name}" for name in names],
        point=t.Sym(label),
    )
