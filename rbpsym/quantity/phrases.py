"""The phrases that name quantities of a problem, each with what it means.

“velocity of ladder.cm”, “angular momentum of disk about O, spin”, “work of N_w on ladder,
translational”. A new phrase is a new row of PHRASES.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from rbpsym.decide.rooted import root_of
from rbpsym.errors import StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.field import NOTHING, ORIGIN, PI, Scalar, Space, cartesian, function, is_zero, names_in, short, substitute, symbol
from rbpsym.field.evaluate import scalar, space_derivative, time_derivative
from rbpsym.mechanics.dynamics import torque_about_center
from rbpsym.mechanics.energy import potentials, rotational_energy, stretched, translational_energy
from rbpsym.mechanics.system import BodyState
from rbpsym.quantities import NUMBER
from rbpsym.quantity.bound import Bound, Phrase, axial, number, parts, plane
from rbpsym.quantity.moments import PHRASES as MOMENTS
from rbpsym.quantity.vectors import NOUNS, alone, fitting
from rbpsym.quantity.vectors import PHRASES as VECTORS
from rbpsym.statement.source import did_you_mean

if TYPE_CHECKING:
    from rbpsym.quantity.problem import ProblemWorld


def _minus(world: ProblemWorld, phrase: str) -> Bound:
    found = world.bound(phrase)
    vector = None if found.vector is None else -found.vector
    return replace(found, scalar=None if found.scalar is None else -found.scalar, vector=vector)


def _magnitude(world: ProblemWorld, phrase: str) -> Bound:
    found = world.bound(phrase)
    square = found.number * found.number if found.vector is None else found.vector.dot(found.vector)
    return number(function("sqrt", square))


def _unit(world: ProblemWorld, way: str, phrase: str) -> Bound:
    """A vector over its magnitude; across it, a quarter turn counter-clockwise further."""
    found = plane(world.vector(phrase))
    x, y = (part / found.number for part in parts(found))
    return plane(cartesian(x, y) if way == "along" else cartesian(-y, x))


def _rate(world: ProblemWorld, phrase: str) -> Bound:
    found, scope = world.bound(phrase), world.motion.scope
    if found.vector is not None:
        size = None if found.scalar is None else time_derivative(found.scalar, scope)
        return Bound(size, space_derivative(found.vector, scope))
    return number(time_derivative(found.number, scope))


def _rate_of(world: ProblemWorld, letter: str, name: str | None, about: str | None) -> Bound:
    """dL/dt about a point, or dP/dt."""
    what = f"angular momentum of {name or 'system'}" + (f" about {about}" if about else "")
    return _rate(world, what if letter == "L" else f"linear momentum of {name or 'system'}")


def _gathered(world: ProblemWorld, phrase: str) -> Bound:
    """∫ of a quantity over the time from the start; of a vector, component by component, as of a force that is known."""
    is_known = phrase in world.forces_known - {*world.study.system.unknowns}
    found = tuple(map(world.motion.work, parts(plane(world.vector(phrase)) if is_known else world.bound(phrase))))
    return number(found[0]) if len(found) == 1 else plane(cartesian(*found))


def _of_coordinate(order: int) -> Callable[[ProblemWorld, str], Bound]:
    def find(world: ProblemWorld, name: str) -> Bound:
        if name in {*world.study.system.bodies, *world.study.system.unknowns} - {*world.coordinates}:  # a contact is at its point
            return _of_point(order)(world, name)
        if name in {quantity.name for quantity in world.study.problem.parameters}:
            hint = did_you_mean(name, [*world.coordinates, *world.study.system.bodies], "coordinates and bodies")
            raise StatementError(f"“{name}” is a constant, and does not move", instead=hint)
        value, scope = scalar(read_infix(name, world.names)), world.motion.scope
        value = world.study.system.dependent.get(name, value)
        for _ in range(order):
            value = time_derivative(value, scope)
        return number(value)

    return find


def _speed_of(world: ProblemWorld, noun: str, name: str) -> Bound:
    """The rate of a coordinate, with its sign; of a body the velocity of its centre of mass, or the magnitude of that."""
    found = _of_coordinate(1)(world, name)
    return _magnitude(world, f"velocity of {name}") if noun == "speed" and found.vector is not None else found


def _of_point(order: int) -> Callable[..., Bound]:
    def find(world: ProblemWorld, name: str, origin: str | None = None) -> Bound:
        value = Space(world.held(name) - world.held(origin))
        for _ in range(order):
            value = space_derivative(value, world.motion.scope)
        return plane(Space(value.plane.substitute(world.turned), value.z))

    return find


def _gone(world: ProblemWorld, value: Scalar) -> Scalar:
    """How much a place or an angle differs from what it was at the start. Raises StatementError where that is not known."""
    value = substitute(value, world.dependent)
    begun = substitute(value, world.motion.scope.start)
    if open_ := sorted(names_in(begun) & {*world.coordinates}):
        raise StatementError(f"it is not said where “{open_[0]}” starts", instead='give its coordinate a start = "...".')
    return value - begun


def _displacement(world: ProblemWorld, name: str) -> Bound:
    """How far a point, or a coordinate, is from where it was at the start."""
    if name in world.coordinates:
        return number(_gone(world, symbol(name)))
    place = world.place(name)
    return plane(cartesian(*(_gone(world, part) for part in (place.x, place.y))))


def _turned(world: ProblemWorld, name: str) -> Scalar:
    """By which angle a body (counter-clockwise), or a coordinate that is one, has turned since the start."""
    return _gone(world, symbol(name) if name in world.coordinates else _turning(world, name).pose.angle)


def _turns(world: ProblemWorld, name: str, sense: str | None) -> Bound:
    """How often a body, or a coordinate that is an angle, has turned round since the start."""
    turned = _turned(world, name)
    return number((turned if sense else function("sqrt", turned * turned)) / PI / 2)


def _turning(world: ProblemWorld, name: str) -> BodyState:
    """A body that may turn. Raises StatementError for a particle, to which nothing gives an angle."""
    state = world.body(name)
    if is_zero(state.pose.angle) and world.study.problem.body(name).shape.kind == "particle":
        angles = " or ".join(f"“{angle}”" for angle in _angles(world))
        raise StatementError(f"“{name}” is a particle, which does not turn", instead=f"ask for that of {angles or 'a body'}.")
    return state


def _angles(world: ProblemWorld) -> list[str]:
    coordinates = world.study.problem.coordinates
    return [c.name for c in coordinates if c.quantity.dimension == NUMBER and c.name not in world.study.system.bodies]


def _moment(world: ProblemWorld, name: str, about: str | None) -> Bound:
    total = NOTHING
    place = None if about is None else world.place(about, name)
    for state in world.bodies(name):
        lever = ORIGIN if place is None else state.center - place
        total = total + state.moment + state.mass * lever.dot(lever)
    return Bound(total, about=(name, about))


def _momentum(world: ProblemWorld, name: str) -> Bound:
    return plane(sum((state.velocity * state.mass for state in world.bodies(name)), ORIGIN))


def _angular_momentum(world: ProblemWorld, name: str, about: str | None, part: str | None) -> Bound:
    origin, total = world.place(about), NOTHING
    for state in world.bodies(name):
        orbital = state.mass * (state.center - origin).cross(state.velocity)
        spin = state.moment * state.omega
        total = total + {"orbital": orbital, "spin": spin}.get(part or "", orbital + spin)
    return axial(total)


def _force(world: ProblemWorld, names: str, on: str) -> Bound:
    return plane(sum((force.vector for force in world.forces(names, on)), ORIGIN))


def _torque(world: ProblemWorld, names: str, on: str, about: str | None) -> Bound:
    origin, total = world.place(about), NOTHING
    for force in world.forces(names, on):
        total = total + (force.point - origin).cross(force.vector) + force.couple
    return axial(total)


def _couple(world: ProblemWorld, names: str, on: str) -> Bound:
    element = world.study.system.element
    joints = {element(force.name).name for force in world.forces(names, on)}  # the couple of a weld N has its own name
    found = (f.couple for f in world.forces("net", on) if element(f.name).name in joints)
    return axial(sum(found, NOTHING))


def _power(world: ProblemWorld, names: str, on: str | None, part: str | None) -> Bound:
    total = NOTHING
    for force in world.forces(names, on or "system"):
        state = world.study.system.bodies[force.on]
        push, turn = force.vector.dot(state.velocity), torque_about_center(force, state) * state.omega
        total = total + {"translational": push, "rotational": turn}.get(part or "", push + turn)
    return number(total)


def _work(world: ProblemWorld, names: str, on: str | None, part: str | None) -> Bound:
    return number(world.motion.work(_power(world, names, on, part).number))


def _axis_work(world: ProblemWorld, names: str, on: str | None, about: str) -> Bound:
    """∫ τ dφ with the torque about a point: the work on a body that turns about that point."""
    on = on or "system"
    power = _torque(world, names, on, about).number * world.bodies(on)[0].omega
    return number(world.motion.work(power))


def _kinetic(world: ProblemWorld, name: str | None, part: str | None) -> Bound:
    total = NOTHING
    for state in world.bodies(name or "system"):
        push, turn = translational_energy(state), rotational_energy(state)
        total = total + {"translational": push, "rotational": turn}.get(part or "", push + turn)
    return number(total)


def _relative(world: ProblemWorld) -> Bound:
    """Kinetic energy without that of the centre of mass of all bodies."""
    states = world.bodies("system")
    mass = sum((state.mass for state in states), NOTHING)
    push = sum((state.velocity * state.mass for state in states), ORIGIN)
    return number(_kinetic(world, None, None).number - push.dot(push) / mass / 2)


def _stored(world: ProblemWorld, names: Iterable[str] | None = None) -> Scalar:
    """The potential energies of these interactions, by default of all that have one. Raises StatementError if there is none."""
    found, total = {name: one for name, one in potentials(world.study.system).items() if one is not None}, NOTHING
    for name in (found or ("",)) if names is None else names:
        if name not in found:
            raise StatementError("there is no such potential energy", instead=did_you_mean(name, found, "interactions"))
        total = total + found[name]
    return total


def _potential(world: ProblemWorld, names: str | None) -> Bound:
    return number(_stored(world, names and names.split(" and ")))


def _elongation(world: ProblemWorld, sign: int, name: str) -> Bound:
    """By how much a spring is longer than its natural length (or shorter: `sign` -1)."""
    springs = {element.name: element for element in world.study.problem.interactions if element.kind == "spring"}
    if name not in springs:
        raise StatementError(f"there is no spring “{name}”", instead=did_you_mean(name, list(springs), "springs"))
    length = stretched(world.study.system, springs[name])
    return number((length - scalar(springs[name]["natural_length"])) * sign)


def _energy(world: ProblemWorld) -> Bound:
    if world.study.first_integral is None:
        raise StatementError(f"“{world.study.problem.name}” has no energy integral")
    return Bound(world.study.first_integral)


def _with_stored(sense: int) -> Callable[..., Bound]:
    """Kinetic energy and the potential energies that there are, or some of them; -1: less these."""
    return lambda world, names=None: number(_kinetic(world, None, None).number + _potential(world, names).number * sense)


OWN = ("gravity", "spring", "torsion-spring")


def _own_energy(world: ProblemWorld) -> Bound:
    """Kinetic energy and that of weights and springs: what is lost by friction, drag, brakes, and what other forces give."""
    kinds = {element.name: element.kind for element in world.study.problem.interactions}
    held = (name for name in potentials(world.study.system) if kinds[name] in OWN)
    return number(_kinetic(world, None, None).number + _stored(world, held))


def _size(world: ProblemWorld, noun: str | None, name: str) -> Bound:
    """A force by its name alone: an unknown one as it is stated, with its sign; else (a known one, a pivot) the magnitude."""
    name = fitting(world, noun, name)
    if name in world.study.system.unknowns or (noun is None and name not in world.forces_known):
        return world.expression(name)
    found = world.forces(name, "system")
    if len({force.on for force in found if force.vector}) > 1 and len(found) > 2:
        raise StatementError(f"“{name}” acts on several bodies", instead=f"write “force {name} on {found[0].on}”.")
    return _magnitude(world, f"force {name} on {found[0].on}") if found[0].vector else number(found[0].couple)


def _on_body(world: ProblemWorld, noun: str, name: str) -> Bound:
    """The one force of that role on a body: an unknown one as it is stated, else the magnitude."""
    force, *more = dict.fromkeys(force.name for force in world.forces(noun, name))
    if more:
        known = " or ".join(f"“force {one} on {name}”" for one in (force, *more))
        raise StatementError(f"which {noun} is meant?", instead=f"write {known}.")
    is_unknown = force in world.study.system.unknowns
    return world.expression(force) if is_unknown else _magnitude(world, f"force {force} on {name}")


def _gyration(world: ProblemWorld, name: str, about: str | None) -> Bound:
    mass = sum((state.mass for state in world.bodies(name)), NOTHING)
    square, signs = short(_moment(world, name, about).number / mass), world.study.assumptions
    return Bound(root_of(square, signs), about=(name, about))


def _rate_of_centre(world: ProblemWorld, what: str, name: str | None) -> Bound:
    """Where the centre of mass of a body, of several or of all is, how it moves: P/M, and its rate."""
    value = Space(world.centre(name or "system"))
    for _ in range(("position", "velocity", "acceleration").index(what)):
        value = space_derivative(value, world.motion.scope)
    return plane(value)


def _spin(order: int) -> Callable[[ProblemWorld, str], Bound]:
    def find(world: ProblemWorld, name: str) -> Bound:
        """Of a body that turns, or of a coordinate that is an angle."""
        if name in _angles(world):
            return _of_coordinate(order)(world, name)
        state = _turning(world, name)
        return axial(state.alpha if order > 1 else state.omega)

    return find


_B, _P, _F = r"([\w-]+(?: and [\w-]+)*)", r"([\w.-]+(?:\([^()]*\))?)", r"([\w, ]+?)"
_ON, _ABOUT = rf"(?: on {_B})", rf"(?: about {_P})?"
_HALF, _PART = r"(?:, (translational|rotational))?", r"(?:, (orbital|spin))?"

PHRASES: tuple[Phrase, ...] = (
    (rf"({'|'.join(NOUNS)})", alone, ""),
    *MOMENTS,
    *VECTORS,
    (r"kinetic energy of system relative to its centre of mass", _relative,
     "kinetic energy of the system relative to its centre of mass"),
    (r"(.+?),? up to a constant", lambda world, phrase: Bound(world.bound(phrase).number, kind="up to a constant"), ""),
    (r"minus (.+)", _minus, "minus work of FORCE"),
    (r"magnitude of (.+)", _magnitude, "magnitude of velocity of BODY.cm"),
    (r"unit vector (along|across) (.+)", _unit, "unit vector along position of BODY.cm"),
    (r"([xyz]) component of (.+)", lambda world, axis, phrase: number(world.vector(phrase).components()["xyz".index(axis)]),
     "x component of velocity of BODY.cm"),
    (r"rate of (.+)", _rate, "rate of kinetic energy"),
    (r"time integral of (.+)", _gathered, "time integral of force FORCE on BODY"),
    (r"(speed|velocity) of ([\w]+)", _speed_of, "speed of COORDINATE"),
    (r"acceleration of ([\w]+)", _of_coordinate(2), "acceleration of COORDINATE"),
    (rf"position of {_P}(?: from {_P})?", _of_point(0), "position of BODY.cm"),
    (rf"displacement of {_P}", _displacement, "displacement of BODY.cm"),
    (r"angle turned by ([\w-]+)", lambda world, name: number(_turned(world, name)), "angle turned by BODY"),
    (r"number of (?:turns|revolutions|rotations) (?:of|made by) ([\w-]+)(, counter-clockwise)?", _turns,
     "number of turns of BODY"),
    (rf"velocity of {_P}", _of_point(1), "velocity of BODY.cm"),
    (rf"speed of {_P}", lambda world, name: _magnitude(world, f"velocity of {name}"), "speed of BODY.cm"),
    (rf"acceleration of {_P}", _of_point(2), "acceleration of BODY.cm"),
    (rf"angular velocity of {_B}", _spin(1), "angular velocity of BODY"),
    (rf"angular acceleration of {_B}", _spin(2), "angular acceleration of BODY"),
    (rf"mass of {_B}", lambda world, name: number(sum((s.mass for s in world.bodies(name)), NOTHING)), "mass of BODY"),
    (rf"moment of inertia of {_B}{_ABOUT}", _moment, "moment of inertia of BODY about O"),
    (rf"angular momentum of {_B}{_ABOUT}{_PART}", _angular_momentum, "angular momentum of BODY about O"),
    (rf"(net|external) force{_ON}", _force, "net force on BODY"),
    (rf"forces? {_F}{_ON}", _force, "force FORCE on BODY"),
    (rf"(net|external) torque{_ON}{_ABOUT}", _torque, "net torque on BODY about O"),
    (rf"torque of {_F}{_ON}{_ABOUT}", _torque, "torque of FORCE on BODY about O"),
    (rf"couple of {_F}{_ON}", _couple, "couple of FORCE on BODY"),
    (rf"(net|external) work{_ON}{_HALF}", _work, "net work on BODY"),
    (rf"(net|external) work{_ON} about {_P}", _axis_work, "net work on BODY about O"),
    (rf"work of {_F}{_ON}? about {_P}", _axis_work, "work of FORCE on BODY about O"),
    (rf"work of {_F}{_ON}?{_HALF}", _work, "work of FORCE on BODY, translational"),
    (rf"(?:total )?kinetic energy(?: of {_B})?{_HALF}", _kinetic, "kinetic energy of BODY"),
    (rf"(?:total )?potential energy(?: of {_B})?", _potential, "potential energy"),
    (r"(?:elongation|stretch|extension) of (\w+)", lambda world, name: _elongation(world, 1, name), "elongation of FORCE"),
    (r"compression of (\w+)", lambda world, name: _elongation(world, -1, name), "compression of FORCE"),
    (r"energy", _energy, "energy"),
    (rf"Lagrangian(?: of {_B})?", _with_stored(-1), "Lagrangian"),
    (r"(?:total )?mechanical energy", _with_stored(1), "mechanical energy"),
    (r"energy of motion, weights and springs", _own_energy, "energy of motion, weights and springs"),
    (r"dE/dt", lambda world: _rate(world, "mechanical energy"), "dE/dt"),
    (rf"d([LP])/dt(?: of {_B})?{_ABOUT}", lambda world, letter, name, about: _rate_of(world, letter, name, about), "dL/dt"),
    (r"(?:total )?(?:linear )?momentum(?: of (.+))?", lambda world, name: _momentum(world, name or "system"),
     "linear momentum of BODY"),
    (rf"total angular momentum{_ABOUT}", lambda world, about: _angular_momentum(world, "system", about, None),
     "total angular momentum about O"),
    (rf"cent(?:re|er) of mass(?: of {_B})?",
     lambda w, name: replace(plane(w.centre(name or "system")), about=(name or "system", None)), "centre of mass of BODY"),
    (rf"(position|velocity|acceleration) of cent(?:re|er) of mass(?: of {_B})?", _rate_of_centre,
     "velocity of the centre of mass"),
    (rf"speed of (cent(?:re|er) of mass(?: of {_B})?)", lambda world, of, *_: _magnitude(world, f"velocity of {of}"),
     "speed of the centre of mass"),
    (r"(tension|normal force|friction|friction force|drag|spring force|weight) (?:on|of) ([\w-]+)", _on_body, ""),
    (r"(?:(tension|normal force|friction force|friction|reaction|weight|couple|force|thrust) )?(\w+)", _size, "tension FORCE"),
    (rf"radius of gyration of {_B}{_ABOUT}", _gyration, "radius of gyration of BODY about O"),
    (rf"power of {_F}{_ON}?{_HALF}", _power, "power of FORCE on BODY"),
)
EXAMPLES = (*(example for *_, example in PHRASES if example), "a constant", "unknown", "defined here")
