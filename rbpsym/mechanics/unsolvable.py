"""Sentences for systems whose equations have no solution, or more than one: what is missing or too much.

Newton's and Euler's equations of all bodies must determine every acceleration and every unknown force.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import islice

from rbpsym.errors import Indistinct, LimitError, NoNumber, StatementError
from rbpsym.field import Scalar, is_rooted, is_zero
from rbpsym.mechanics.elimination import is_surely_nonzero_on, linear_row
from rbpsym.mechanics.numbers import number, samples
from rbpsym.mechanics.system import System
from rbpsym.statement.model import Element

SEEN = 1e-6  # of the largest term: what is clearly not zero in numbers

HOLDS = {"": "force or couple", "x": "force along x", "y": "force along y", "rotation": "couple"}


def untold(system: System, name: str = "") -> StatementError:
    """An acceleration, that of the first free coordinate if none is named, of which nothing is known without masses."""
    coordinate = name.removesuffix("_ddot") or system.independent[0]
    return StatementError(
        f"the acceleration of {coordinate} is not stated, nor are masses from which it would follow",
        instead=f'write in [coordinates.{coordinate}] acceleration = "0" where its speed stays, else what it is.',
    )


def indistinct(system: System, free: tuple[str, ...]) -> StatementError:
    """Unknown forces (or accelerations) that the equations leave open."""
    names = " and ".join(free) if len(free) < 3 else ", ".join(free[:-1]) + f" and {free[-1]}"
    first = next((f.name for f in system.forces if set(f.unknowns) & set(free)), None)
    if first is None:  # accelerations that nothing determines
        return massless(system, tuple(system.accelerations.index(name) for name in free))
    pressed = next((e for e in system.problem.constraints if e.name in free and _meshes(e)), None)
    if pressed is not None:
        return StatementError(
            f"nothing tells how hard “{pressed['body']}” is pressed on “{pressed['circle'].body}”: both are held, so the "
            f"normal force {pressed.name} can't be found",
            instead='wheels on fixed bearings mesh: write type = "gear"; or let one of the bearings give way.',
            place=pressed.place,
        )
    error = Indistinct(
        f"too many constraints: the unknown forces {names} can't be told apart by the equations of motion",
        instead="drop one of the constraints that hold the same point or the same body, or replace it by a roller "
        "(a contact), so that each force has an equation.",
        place=system.element(first).place,
    )
    error.free = free
    return error


def _meshes(element: Element) -> bool:
    """Do two round bodies roll or rub on each other there?"""
    circle = element.values.get("circle")
    return element.kind in ("rolling", "touch") and circle is not None and circle.body is not None


def massless(system: System, block: tuple[int, ...]) -> StatementError:
    """Accelerations that nothing resists."""
    names = ", ".join(system.independent[i] for i in block)
    return StatementError(
        f"too few equations: nothing with mass resists a change of {names}",
        instead="let each coordinate move a body with mass, or leave the coordinate out.",
    )


def contradictory(system: System, held: Sequence[str] = (), alone: Sequence[str] = ()) -> StatementError:
    """Named are the bodies that no forces on them can keep on their way, `alone`; the body without which there is a solution, if
    it is the only one of `held`; the constraints that the poses do not keep by themselves; the bodies of which the pose alone
    holds one, `held`; or else all constraints."""
    if beside := _beside(system):
        return beside
    if alone:
        return _not_held(system, alone)
    if len(held) == 1 or (held and not asking(system)):
        return _not_held(system, held)
    names = asking(system) or tuple(element.name for element in system.problem.constraints)
    fixed = "" if system.independent else " (they leave nothing free to move, and the forces do not balance there)"
    return StatementError(
        f"the constraints contradict the motion of the bodies: their equations have no solution with "
        f"{', '.join(f'“{name}”' for name in names)}{fixed}",
        instead="check that each constraint agrees with the poses, and that no two ask for different motions.",
        place=system.element(names[0]).place if names else None,
    )


def _beside(system: System) -> StatementError | None:
    """A force on a particle that does not go through it."""
    for force in system.forces:
        body = system.problem.body(force.on)
        arm = force.point - system.bodies[force.on].center
        if body.shape.kind == "particle" and not is_zero(arm.cross(force.vector)):
            return StatementError(
                f"the force “{force.name}” acts on “{force.on}” beside its place, and a particle bears no torque",
                instead=f'give “{force.on}” a shape with an angle (a rectangle), and hold that by type = "slider".',
                place=body.place,
            )
    return None


def too_long(system: System) -> LimitError:
    """Named are the constraints whose conditions tie coordinates without a solution for one of them."""
    names = tuple(dict.fromkeys(condition.constraint for condition in system.implicit))
    if not names:
        return LimitError(
            "the equations of motion grow too long to be worked out exactly",
            instead="take coordinates in which the places are shorter, fewer bodies, or fewer different sizes.",
            place=system.problem.bodies[-1].place,
        )
    tied = " and ".join(f"“{name}”" for name in names)
    return LimitError(
        f"the equations of motion grow too long to be worked out exactly: {tied} tie{'s' * (len(names) == 1)} coordinates "
        "by equations that have no solution for one of them",
        instead="take coordinates in which the constraint holds by itself (the angle of a string or of a link, with the "
        "place of the body in terms of it), give a coordinate that is held its start alone, or take sizes that are "
        'multiples of each other (ell = "2*a").',
        place=system.element(names[0]).place,
    )


def asking(system: System) -> tuple[str, ...]:
    """Constraints whose conditions the poses do not keep by themselves."""
    return tuple(dict.fromkeys(c.constraint for c in system.conditions if not is_zero(c.value)))


def unheld(system: System, rows: Iterable[tuple[str, str, Scalar]], images: Mapping[str, Scalar]) -> StatementError:
    """A pose that ties a body to coordinates without a force that does it; `rows`: its equations without unknowns."""
    if beside := _beside(system):
        return beside
    last = (system.problem.bodies[-1].name, "")
    name, way = next(((body, way) for body, way, value in rows if is_nonzero(system, value, images)), last)
    return _not_held(system, [name], way)


def _not_held(system: System, bodies: Sequence[str], way: str = "") -> StatementError:
    names = " or ".join(f"“{name}”" for name in bodies)
    return StatementError(
        f"the pose of the body {names} says more than its constraints hold: nothing exerts the {HOLDS[way]} that "
        f"keeps it on its way",
        instead="add the constraint that does it (slider, contact, rolling, guide, pin, weld ...), or give the body "
        "coordinates of its own.",
        place=system.problem.body(bodies[0]).place,
    )


def is_nonzero(system: System, value: Scalar, images: Mapping[str, Scalar]) -> bool:
    """Proved modulo a prime; where there are roots, which have no image there, seen in numbers.

    It only chooses between a sentence and a derivation in which the same equation would be refuted."""
    if is_surely_nonzero_on(value, images):
        return True
    if not any(is_rooted(part.num) for part in (value, *images.values())):
        return False
    seen = (_is_seen(value, images, numbers) for numbers in samples(system.problem))
    decided = [*islice((one for one in seen if one is not None), 3)]
    return bool(decided) and all(decided)


def _is_seen(value: Scalar, images: Mapping[str, Scalar], numbers: Mapping[str, float]) -> bool | None:
    """Whether the value is clearly not zero there, against the largest of its terms; None where it has no value."""
    known = dict(numbers)
    try:
        known |= {name: number(image, numbers) for name, image in images.items()}
        sizes = [abs(number(part, known)) for part in linear_row(value, tuple(images)).values()]
        return abs(number(value, known)) > SEEN * max(1.0, *sizes)
    except NoNumber:
        return None
