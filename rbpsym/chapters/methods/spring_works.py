"""The works of a spring before its natural length is put in: the law of the spring times the way of its end.

Told where the natural length is not a quantity of its own but chosen for this motion (slack at the start,
say): the law is seen for any natural length first.
"""

from __future__ import annotations

from typing import Any

from rbpsym.chapters.forces import force_node
from rbpsym.chapters.methods.known_works import start_of
from rbpsym.chapters.methods.net_work import HALVES
from rbpsym.expr import tree as t
from rbpsym.field import Scalar, atoms, short
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen
from rbpsym.mechanics.energy import stretched
from rbpsym.mechanics.motion import ForceWork, Work
from rbpsym.proof.draft import Draft, length
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Element

LONGEST = 40  # nodes of an integrand that a reader takes in


class Spring(Frozen):
    """A spring that acts on one body: its stiffness, how far its ends are apart, its natural length."""

    element: Element
    item: ForceWork
    stiffness: Scalar
    distance: Scalar
    natural: Scalar


def write(draft: Draft) -> None:
    """Two steps for each such spring: its works for any natural length, and for the one that it has."""
    if len(draft.study.system.independent) != 1 or draft.study.system.has_clock:
        return
    for item in draft.study.works:
        spring = _spring(draft, item)
        if spring is not None:
            _write(draft, spring)


def _spring(draft: Draft, item: ForceWork) -> Spring | None:
    """The spring whose force this is; None if its natural length is a quantity, or its length a root."""
    element, system = draft.study.system.element(item.force), draft.study.system
    if element.kind != "spring" or isinstance(element["natural_length"], (t.Sym, t.Num)):
        return None
    if len(draft.study.system.named(item.force)) != 1 or not item.translational.value or not item.rotational.value:
        return None
    distance = stretched(system, element)
    rooted = any(atoms.atom(index).kind == "root" for index in distance.atoms())
    values = (scalar(element["stiffness"]), distance, scalar(element["natural_length"]))
    return None if rooted else Spring(element, item, *values)


def _write(draft: Draft, spring: Spring) -> None:
    from rbpsym.chapters.methods.work_energy import name_of

    several = sum(e.kind == "spring" for e in draft.study.problem.interactions) > 1
    letter = draft.free(f"l_{spring.item.force}" if several else "l_0")
    natural = draft.define(letter, spring.natural)
    halves = [(t.Sym(name_of(draft, spring.item, half)), getattr(spring.item, word)) for half, word in HALVES]
    shown = [_general(draft, spring, natural, work) for _, work in halves]
    if any(length(node) > LONGEST for node in shown):
        return
    slots: dict[str, Any] = {
        "force": force_node(draft, draft.study.system.named(spring.item.force)[0]),
        "body": BodyRef(spring.item.on),
        "natural": natural,
        "value": t.equation(natural, draft.show(spring.natural)),
        "premises": [f"work.{spring.item.force}.{spring.item.on}"],
    }
    general = _both(halves, shown)
    draft.add(f"spring.{spring.item.force}", "work_integral", general, "work.spring.general", **slots)
    done = _both(halves, [draft.show(work.value, factor=True) for _, work in halves])
    draft.add(f"spring.done.{spring.item.force}", "work_together", done, "work.spring.done", **slots)


def _general(draft: Draft, spring: Spring, natural: t.Sym, work: Work) -> t.Node:
    """∫ k (d - l₀) × (what the end moves against the pull) dq."""
    [(name, part)] = work.parts.items()
    way = short(part / (spring.stiffness * (spring.distance - spring.natural)))
    pull = t.mul(draft.show(spring.stiffness), t.Group(t.add(draft.show(spring.distance), t.neg(natural))))
    shown = draft.show(way)
    integrand = t.mul(pull, shown.arg if isinstance(shown, t.Neg) else shown)
    found = t.Integral(integrand, name, start_of(draft, name), t.Sym(name))
    return t.neg(found) if isinstance(shown, t.Neg) else found


def _both(halves: list[tuple[t.Sym, Work]], shown: list[t.Node]) -> t.Node:
    """Both works: one chain where they are equal."""
    (first, _), (second, _) = halves
    if shown[0] == shown[1]:
        return t.equation(first, second, shown[0])
    return t.Relations((t.equation(first, shown[0]), t.equation(second, shown[1])))
