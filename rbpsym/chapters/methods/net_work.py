"""What each force does in the sum over all bodies: nothing, or it dissipates, or it brings the work of what drives.

A force of a constraint whose works cancel whatever its value is (ideal) is told apart from the rest by
proof; so is a force that dissipates: the rate of its work is never positive.
"""

from __future__ import annotations

from collections.abc import Iterator

from rbpsym.chapters.forces import force_node, name_node
from rbpsym.chapters.methods.known_works import over_coordinates
from rbpsym.decide.signs import sign
from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import LETTERS
from rbpsym.expr import tree as t
from rbpsym.field import NOTHING, Scalar, short, symbol
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics import motion
from rbpsym.mechanics.motion import ForceWork
from rbpsym.mechanics.pushing import kept_sense
from rbpsym.proof.draft import Draft
from rbpsym.proof.step import BodyRef
from rbpsym.statement.model import Element

HALVES = (("T", "translational"), ("theta", "rotational"))


def write(draft: Draft, works: tuple[ForceWork, ...]) -> None:
    """A step for each force that acts on the sum in one of these ways."""
    for name in dict.fromkeys(item.force for item in works):
        items = [item for item in works if item.force == name]
        terms = list(work_symbols(draft, items))
        if not terms:
            continue
        if draft.study.dynamics.workless.get(name):
            _cancelling(draft, name, items, terms)
        elif is_dissipative(draft, name):
            _dissipated(draft, name, items, terms)
        elif len(terms) > 1 and any(force.unknowns for force in draft.study.system.named(name)):
            _handed_on(draft, name, items, terms)


def work_symbols(draft: Draft, items: list[ForceWork]) -> Iterator[t.Sym]:
    """The symbols of those halves of the works that are not identically zero."""
    from rbpsym.chapters.methods.work_energy import name_of

    for item in items:
        for half, word in HALVES:
            if getattr(item, word).parts:
                yield t.Sym(name_of(draft, item, half))


def is_dissipative(draft: Draft, name: str) -> bool:
    """Dampers, resistances and kinetic friction (whether they do dissipate is for the step to prove)."""
    element = draft.study.system.element(name)
    return element.kind in ("damper", "rotary-damper", *LETTERS) or is_kinetic(element, name)


def is_kinetic(element: Element, name: str) -> bool:
    """Is the force the kinetic friction of a contact?"""
    return element.values.get("coefficient") is not None and element.values.get("friction") == name


def net_power(draft: Draft, name: str) -> Scalar:
    """The rate of all works of a force together."""
    return short(motion.net_power(draft.study.system, draft.study.system.named(name)))


# --- ideal forces


def _cancelling(draft: Draft, name: str, items: list[ForceWork], terms: list[t.Sym]) -> None:
    """The sum of all works vanishes although the single ones don't."""
    bodies = list(dict.fromkeys(item.on for item in items if any(getattr(item, word).parts for _, word in HALVES)))
    force = draft.study.system.named(name)[0]
    manner = _manner(draft.study.system.element(name), name) if force.vector else "couple"
    opposite = manner == "grip" and len(terms) == 2 and len(bodies) == 1
    statement = t.equation(terms[0], t.neg(terms[1])) if opposite else t.equation(t.add(*terms), t.ZERO)
    draft.add(
        f"workless.{name}",
        "workless",
        statement,
        f"work.cancels.{manner}",
        premises=[f"work.{i.force}.{i.on}" for i in items],
        force=name_node(draft, name),
        works=terms,
        bodies=[BodyRef(body) for body in bodies],
        variant="one" if len(bodies) == 1 else "many",
    )


def _manner(element: Element, name: str) -> str:
    """Why the works of a force cancel."""
    if element.values.get("friction") == name:
        return "grip"
    return "link" if element.values.get("rigid") else CONSTRAINTS[element.kind].holds or "contact"


# --- forces that dissipate


def _dissipated(draft: Draft, name: str, items: list[ForceWork], terms: list[t.Sym]) -> None:
    """The rate at which a damper or kinetic friction takes energy out."""
    element, value = draft.study.system.element(name), net_power(draft, name)
    rough, against = is_kinetic(element, name), element.kind in LETTERS
    manner = "friction" if rough else "resistance" if against else "damper"
    rate = t.Deriv(t.Group(t.add(*terms)) if len(terms) > 1 else terms[0])
    chain = t.equation(rate, _against_slip(draft, element, value) if rough else draft.show(value, factor=True))
    if sign(value, draft.study.assumptions).kind in ("nonpositive", "negative"):
        chain = t.Chain((*chain.items, t.ZERO), (*chain.ops, "<="))
    draft.add(
        f"dissipation.{name}",
        "power",
        chain,
        f"work.dissipated.{manner}",
        premises=[f"work.{i.force}.{i.on}" for i in items],
        force=force_node(draft, draft.study.system.named(name)[0]),
        normal=t.Sym(element.name),
        variant="one" if len(terms) == 1 else "many",
        obligations=(t.relation(t.Sym(element.name), ">=", t.ZERO),) if rough else draft.asked(kept_sense(draft.study, element)),
    )


def _against_slip(draft: Draft, element: Element, value: Scalar) -> t.Node:
    """-(μ N) (speed of the slip)."""
    push = scalar(element["coefficient"]) * symbol(element.name)
    slip = draft.show(short(-(value / push)))
    return t.neg(t.mul(draft.show(push), t.Group(slip) if isinstance(slip, t.Add) else slip))


# --- forces of supports that are driven


def _handed_on(draft: Draft, name: str, items: list[ForceWork], terms: list[t.Sym]) -> None:
    """The net work of a constraint force whose support is driven."""
    total: dict[str, Scalar] = {}
    for item in items:
        for _, word in HALVES:
            for coordinate, part in getattr(item, word).parts.items():
                total[coordinate] = total.get(coordinate, NOTHING) + part
    parts = {coordinate: short(part) for coordinate, part in total.items() if short(part)}
    draft.add(
        f"net.{name}",
        "work",
        t.equation(t.add(*terms), over_coordinates(draft, parts)),
        "work.handed_on",
        premises=[f"work.{i.force}.{i.on}" for i in items],
        force=t.Vec(name),
    )
