"""Phrases about vectors: components along and across bodies and paths, directions; points that move with a body."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.errors import StatementError
from rbpsym.expr.tree import names
from rbpsym.field import UNITY, Scalar, Vector, function, is_zero
from rbpsym.quantities import LENGTH
from rbpsym.quantity.bound import Bound, Phrase, number, plane
from rbpsym.statement.model import Element
from rbpsym.statement.paths import tensions

if TYPE_CHECKING:
    from rbpsym.quantity.problem import ProblemWorld

POINT = re.compile(r"\b(?:of|on) ([\w-]+(?:\.\w+)?(?:\([^()]*\))?)")


def _vector(world: ProblemWorld, phrase: str) -> Vector:
    found = world.vector(phrase)
    if not is_zero(found.z):
        what = f"“{phrase}” is no vector in the plane of motion"
        raise StatementError(what, instead="name a force, a velocity, an acceleration.")
    return found.plane


def of_body(world: ProblemWorld, part: str, phrase: str, name: str) -> Bound:
    """Component along a body, from its start to its end (its x' axis), or across it, counter-clockwise from that."""
    axis = Vector({world.body(name).pose.angle: UNITY})
    return number(_vector(world, phrase).dot(axis if part == "along" else axis.turned()))


def of_line(world: ProblemWorld, part: str, phrase: str, first: str, second: str) -> Bound:
    """Component along the line from one point to another, or across it, counter-clockwise from that."""
    way = world.place(second) - world.place(first)
    return number(_vector(world, phrase).dot(way if part == "along" else way.turned()) / _length(way))


def _length(way: Vector) -> Scalar:
    square = way.dot(way)
    if is_zero(square):
        raise StatementError("a point that stays where it is has no direction", instead="name another one.")
    return function("sqrt", square)


def _point_of(world: ProblemWorld, phrase: str) -> str:
    """The point that a phrase is about: “force P on rod” about the rod's centre of mass."""
    named = [name if "." in name or "(" in name else f"{name}.cm" for name in POINT.findall(phrase)]
    if not named:
        raise StatementError(f"“{phrase}” names no point", instead="write “acceleration of rod.end”, “force P on rod”.")
    return named[-1]


def polar(world: ProblemWorld, part: str, phrase: str, about: str | None) -> Bound:
    """Radial component, away from a point, or the tangential one, counter-clockwise about it."""
    way = world.place(_point_of(world, phrase)) - world.place(about)
    return number(_vector(world, phrase).dot(way if part == "radial" else way.turned()) / _length(way))


def of_path(world: ProblemWorld, part: str, phrase: str) -> Bound:
    """Component along the velocity of the point that a phrase is about, or to the left of it."""
    velocity = world.bound(f"velocity of {_point_of(world, phrase)}").arrow.plane
    return number(_vector(world, phrase).dot(velocity if part == "along" else velocity.turned()) / _length(velocity))


def relative(world: ProblemWorld, what: str, name: str, other: str) -> Bound:
    """How a point moves as seen from another one, without turning with that."""
    return plane(world.bound(f"{what} of {name}").arrow - world.bound(f"{what} of {other}").arrow)


def distance(world: ProblemWorld, first: str, second: str) -> Bound:
    """The distance between two points."""
    way = world.place(second) - world.place(first)
    return number(function("sqrt", way.dot(way)))


def instantaneous_centre(world: ProblemWorld, name: str) -> Bound:
    """The point of the plane of a body that is at rest: R + ω × V/ω², from O."""
    pole = world.body(name).pole
    if pole is None:
        raise StatementError(f"“{name}” does not turn, so that it has no instantaneous centre")
    return plane(pole)


_P = r"([\w.-]+(?:\([^()]*\))?)"
PHRASES: tuple[Phrase, ...] = (
    (rf"component of (.+) (along|across) line from {_P} to {_P}", lambda w, p, k, a, b: of_line(w, k, p, a, b),
     "component of force FORCE on BODY along the line from O to BODY.cm"),
    (r"component of (.+) (along|across) path", lambda w, p, k: of_path(w, k, p),
     "component of acceleration of BODY.cm along the path"),
    (r"component of (.+) (along|across) ([\w-]+)", lambda w, p, k, b: of_body(w, k, p, b),
     "component of force FORCE on BODY along BODY"),
    (rf"(radial|tangential) component of (.+?)(?: about {_P})?", polar, "radial component of acceleration of BODY.cm about O"),
    (rf"(velocity|acceleration|position|displacement) of {_P} relative to {_P}", relative,
     "velocity of BODY.cm relative to BODY.cm"),
    (rf"distance (?:from|between) {_P} (?:to|and) {_P}", distance, "distance from O to BODY.cm"),
    (rf"height of {_P}", lambda w, name: number(w.place(name).y), "height of BODY.cm"),
    (r"instantaneous cent(?:re|er) of ([\w-]+)", instantaneous_centre, "instantaneous centre of BODY"),
)  # fmt: skip


HELD = {"tension": "tension", "normal force": "contact"}  # as what the force of a constraint holds


def _holds(noun: str, world: ProblemWorld) -> Iterator[str]:
    for element in world.study.problem.constraints:
        if CONSTRAINTS[element.kind].holds == HELD[noun]:
            yield from (f"{noun} {name}" for name in (tensions(element) if noun == "tension" else (element.name,)))


def _rubs(world: ProblemWorld) -> Iterator[str]:
    named = (e.values.get("friction") for e in world.study.problem.constraints)
    yield from (f"friction {name}" for name in named if name in world.forces_known)


def swinging(world: ProblemWorld) -> Sequence[str]:
    """The coordinates that a place of rest tells, if there are some: of those that are free to go anywhere nothing swings."""
    names = world.study.system.independent
    return [name for name in names if any(name in item.at for item in world.study.equilibria)] or names


def _coordinates(noun: str, world: ProblemWorld) -> Iterator[str]:
    yield from (f"{noun} of {name}" for name in swinging(world))


def _moves(noun: str, world: ProblemWorld) -> Iterator[str]:
    """Of a coordinate that is a length; where there is none, of the bodies that have no size."""
    free = [world.study.problem.coordinate(name) for name in world.study.system.independent]
    found = [one.name for one in free if one.quantity.dimension == LENGTH]
    points = [f"{body.name}.cm" for body in world.study.problem.bodies if body.shape.kind == "particle"]
    yield from (f"{noun} of {name}" for name in found or points or [*(one.name for one in free), *world.study.system.bodies])


def _springs(noun: str, world: ProblemWorld) -> Iterator[str]:
    of = "force" if noun == "spring force" else f"{noun} of"
    yield from (f"{of} {element.name}" for element in world.study.problem.of_kind("spring"))


def _turns(noun: str, world: ProblemWorld) -> Iterator[str]:
    yield from (f"{noun} of {name}" for name, state in world.study.system.bodies.items() if not is_zero(state.omega))


NOUNS: Mapping[str, Callable[[ProblemWorld], Iterator[str]]] = {
    **{noun: partial(_holds, noun) for noun in HELD},
    "friction": _rubs,
    "friction force": _rubs,
    **{noun: partial(_moves, noun) for noun in ("speed", "velocity", "acceleration")},
    **{noun: partial(_turns, noun) for noun in ("angular velocity", "angular acceleration", "number of turns")},
    **{noun: partial(_springs, noun) for noun in ("elongation", "extension", "compression", "spring force")},
    **{noun: partial(_coordinates, noun) for noun in ("period", "frequency", "amplitude", "decay rate", "damped frequency")},
}


ROLES = {  # by the kinds of interactions, and the nouns of what holds
    "weight": ("gravity",), "gravity": ("gravity",), "drag": ("resistance",), "resistance": ("resistance", "resisting-couple"),
    "spring": ("spring", "torsion-spring"), "damper": ("damper", "rotary-damper"), "motor": ("couple",),
}  # fmt: skip


def _is_dry(element: Element) -> bool:
    """Whether it is a resistance that does not hang on the speed, as the friction of a bearing is."""
    return element.kind in ROLES["resistance"] and not {"v", "omega"} & names(element["size"])


def of_role(world: ProblemWorld, noun: str, known: Iterable[str]) -> list[str]:
    """Of the known forces those that a word means: friction, the weights, the springs, tensions."""
    noun = noun.removesuffix(" force" if noun.endswith(("n force", "g force")) else "s")
    kinds = ROLES.get(noun, ())
    acting = world.study.problem.interactions
    of_kind = [element.name for element in acting if element.kind in kinds or (noun == "friction" and _is_dry(element))]
    held = [phrase.rsplit(" ", 1)[1] for phrase in NOUNS[noun](world)] if noun in ("friction", *HELD) else []
    return [name for name in (*of_kind, *held) if name in {*known}]


def fitting(world: ProblemWorld, noun: str | None, name: str) -> str:
    """The name of the force that a noun means with a name: “friction at N” is that of the contact N. Raises StatementError for
    a force that is none of this kind."""
    by_name = {element.name: element for element in world.study.problem.constraints}
    rubbing = {name: element["friction"] for name, element in by_name.items() if element.values.get("friction")}
    if noun in ("friction", "friction force") and name in by_name:
        if rubbing.get(name) not in world.forces_known:
            raise StatementError(f"“{name}” has no friction", instead=f"ask for “normal force {name}” or “force {name}”.")
        return str(rubbing[name])
    pulls = {one for element in world.study.problem.of_kind("string") for one in (element.name, *tensions(element))}
    others = (*by_name.values(), *world.study.problem.interactions)
    pulls |= {one.name for one in others if one.kind in ("link", "pull", "spring")}
    unfit = noun == "tension" and name in world.forces_known - pulls
    unfit |= noun == "normal force" and name in {*rubbing.values(), *pulls}
    if unfit:
        raise StatementError(f"“{name}” is no {noun}", instead=f"ask for “force {name}”, or for “{name}” alone.")
    return name


def alone(world: ProblemWorld, noun: str) -> Bound:
    """The one quantity that the noun can mean. Raises StatementError with those that it could mean."""
    if noun in world.names:
        return world.expression(noun)
    found = list(NOUNS[noun](world))
    if found and (len(found) == 1 or len({world.motion.moved(world.bound(phrase).number) for phrase in found}) == 1):
        return world.bound(found[0])
    if not found:
        raise StatementError(f"the problem has no {noun}", instead="name a quantity of the problem.")
    raise StatementError(f"which {noun} is meant?", instead=f"write {' or '.join(f'“{phrase}”' for phrase in found)}.")
