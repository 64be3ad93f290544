"""Unknown forces as functions of position alone, and where a contact is lost."""

from __future__ import annotations

from rbpsym.algebra.calculus import depends_on, substitute
from rbpsym.algebra.poly import generator
from rbpsym.algebra.present import atom_node
from rbpsym.algebra.scalar import Scalar
from rbpsym.derivation.draft import Draft
from rbpsym.derivation.step import FULL, STANDARD, StepRef
from rbpsym.mechanics.elimination import short
from rbpsym.mechanics.events import Loss
from rbpsym.notation import tree as t

LONGEST = 60  # nodes of a formula that is worth showing in standard detail


def write(draft: Draft) -> None:
    """The chapter."""
    draft.chapter = "contact"
    along = draft.study.reactions_along_motion
    if not along or not draft.study.squares:
        return
    for name, value in along.items():
        shown = draft.show(value, factor=True)
        level = STANDARD if _is_contact(draft, name) or len(list(t.walk(shown))) <= LONGEST else FULL
        draft.add(
            f"along.{name}",
            "substitution",
            t.equation(t.Sym(name), shown),
            level=level,
            phrase="contact.along",
            premises=[f"reaction.{name}", *(f"square.{n}" for n in draft.study.squares)],
            force=t.Sym(name),
            sources=[StepRef(f"square.{n}") for n in draft.study.squares if draft.has(f"square.{n}")],
            reaction=StepRef(f"reaction.{name}"),
            is_result=_is_contact(draft, name),
        )
    for loss in draft.study.losses:
        _loss(draft, loss, along)


def _is_contact(draft: Draft, name: str) -> bool:
    return any(e.name == name and e.kind == "contact" for e in draft.study.problem.constraints)


def _loss(draft: Draft, loss: Loss, along) -> None:
    """Where the force vanishes, and what the other forces are there."""
    place = loss.at.get(loss.coordinate)
    equation = _solved(draft, loss)
    draft.add(
        f"loss.{loss.force}",
        "vanishing",
        equation,
        "contact.lost" if place is not None else "contact.lost_implicitly",
        premises=[f"along.{loss.force}"],
        force=t.Sym(loss.force),
        is_result=True,
        coordinate=t.Sym(loss.coordinate),
        data={"value": along[loss.force], "at": dict(loss.at), "factor": loss.factor},
    )
    if place is None:
        return
    for name, value in along.items():
        if name == loss.force:
            continue
        there = short(substitute(value, loss.at))
        letter = draft.define(draft.free(f"{name}_end"), there)
        draft.add(
            f"at_loss.{loss.force}.{name}",
            "identity",
            t.equation(letter, draft.show(there, factor=True)),
            "contact.other_force",
            premises=[f"along.{name}", f"loss.{loss.force}"],
            force=t.Sym(name),
            lost=t.Sym(loss.force),
        )


def _solved(draft: Draft, loss: Loss) -> t.Node:
    """sin q = ... (or cos q, or q itself) from the factor that vanishes, else factor = 0."""
    for index in sorted(loss.factor.num.atoms()):
        if not depends_on(_generator(index), loss.coordinate):
            continue
        parts = loss.factor.num.by_power(index)
        if set(parts) == {0, 1} and not any(depends_on(Scalar(p), loss.coordinate) for p in parts.values()):
            return t.equation(atom_node(index, draft.study.style), draft.show(-(Scalar(parts[0]) / Scalar(parts[1]))))
    return t.equation(draft.show(loss.factor, factor=True), t.ZERO)


def _generator(index: int) -> Scalar:
    return Scalar(generator(index))
