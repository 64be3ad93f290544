"""The force law of each kind of interaction, and its potential energy where it has one.

A new kind is a new entry of `LAWS`. Laws get the element, the positions of points and the
states of the bodies; they return the forces on each body.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from rbpsym.errors import StatementError
from rbpsym.expr.tree import ONE
from rbpsym.field import NOTHING, ORIGIN, UNITY, Scalar, Vector, derivative, names_in, root, tidy
from rbpsym.field.evaluate import scalar
from rbpsym.frozen import Frozen, replace
from rbpsym.mechanics.geometry import no_direction, pair
from rbpsym.mechanics.resistance import Resisted, resisted
from rbpsym.mechanics.system import BodyState, Force, opposed, rotated
from rbpsym.statement.model import Element, PointRef

HALF = Fraction(1, 2)


class Setting(Frozen):
    """What a law may look at: positions and velocities of points, states of bodies, signs (`sign`: at the start), the names
    of unknown forces."""

    where: Callable[[PointRef], Vector]
    velocity: Callable[[PointRef], Vector]
    states: Mapping[str, BodyState]
    is_positive: Callable[[Scalar], bool | None]
    sign: Callable[[Scalar], int]
    unknowns: frozenset[str]
    is_constant: Callable[[Scalar], bool]


class Law(Frozen):
    """forces(element, setting); potential(element, setting) is None where there is none; `taken`: what is positive
    where the formula of the force holds."""

    forces: Callable[[Element, Setting], tuple[Force, ...]]
    potential: Callable[[Element, Setting], Scalar | None]
    taken: Callable[[Element, Setting], tuple[Scalar, ...]] = lambda element, setting: ()


def _weights(element: Element, setting: Setting) -> tuple[Force, ...]:
    down, g = pair(element["direction"]), scalar(element["g"])
    return tuple(
        Force(
            element.name,
            name,
            "earth",
            setting.states[name].center,
            down * (setting.states[name].mass * g),
            law=element.kind,
            where=f"{name}.cm",
        )
        for name in element["bodies"]
    )


def _height_energy(element: Element, setting: Setting) -> Scalar:
    down, g = pair(element["direction"]), scalar(element["g"])
    states = [setting.states[name] for name in element["bodies"]]
    return sum((-(state.mass * g * down.dot(state.center)) for state in states), NOTHING)


def stretch(element: Element, setting: Setting) -> tuple[Vector, Scalar]:
    """(unit vector from the first end to the second, their distance). Raises StatementError where they are one place."""
    first, second = element["between"]
    apart = (setting.where(second) - setting.where(first)).settled()
    if not apart.parts:
        raise no_direction(element, first.label, second.label)
    if len(apart.parts) == 1:
        [(angle, length)] = apart.parts.items()
        sign = -1 if setting.is_positive(length) is False else 1
        return Vector({angle: UNITY * sign}), length * sign
    distance = root(tidy(apart.dot(apart)))
    return apart * distance.inverse(), distance


def _ends(element: Element, setting: Setting, pull: Vector) -> tuple[Force, ...]:
    """The pull on the first end (towards the second) and its opposite on the second."""
    ends = ((ref.body, setting.where(ref), ref.label) for ref in element["between"])
    return opposed(element.name, ends, pull, law=element.kind)


def _spring(element: Element, setting: Setting) -> tuple[Force, ...]:
    k, natural = scalar(element["stiffness"]), scalar(element["natural_length"])
    if not natural:
        first, second = element["between"]
        return _ends(element, setting, (setting.where(second) - setting.where(first)) * k)
    unit, distance = stretch(element, setting)
    return _ends(element, setting, unit * (k * (distance - natural)))


def _apart(element: Element, setting: Setting) -> tuple[Scalar, ...]:
    """The distance of the ends, if it is no root and the force hangs on its sign."""
    first, second = element["between"]
    is_line = len((setting.where(second) - setting.where(first)).settled().parts) == 1
    return (stretch(element, setting)[1],) if is_line and scalar(element.values.get("natural_length", ONE)) else ()


def _spring_energy(element: Element, setting: Setting) -> Scalar:
    k, natural = scalar(element["stiffness"]), scalar(element["natural_length"])
    if not natural:
        first, second = element["between"]
        apart = setting.where(second) - setting.where(first)
        return k * apart.dot(apart) * HALF
    _, distance = stretch(element, setting)
    return k * (distance - natural) ** 2 * HALF


def _pull(element: Element, setting: Setting) -> tuple[Force, ...]:
    return _ends(element, setting, stretch(element, setting)[0] * scalar(element["size"]))


def _pull_energy(element: Element, setting: Setting) -> Scalar | None:
    """F d for a constant force."""
    size = scalar(element["size"])
    return size * stretch(element, setting)[1] if setting.is_constant(size) else None


def _couples(element: Element, first: str, second: str, on_second: Scalar, setting: Setting) -> tuple[Force, ...]:
    pairs = ((second, first, on_second), (first, second, -on_second))
    return tuple(
        Force(element.name, name, other, setting.states[name].center, ORIGIN, couple, law=element.kind, where=f"{name}.cm")
        for name, other, couple in pairs
        if name in setting.states
    )


def _angle(name: str, setting: Setting) -> Scalar:
    return setting.states[name].pose.angle if name in setting.states else NOTHING


def _twist(element: Element, setting: Setting) -> Scalar:
    first, second = element["between"]
    return _angle(second, setting) - _angle(first, setting) - scalar(element["rest_angle"])


def _torsion(element: Element, setting: Setting) -> tuple[Force, ...]:
    first, second = element["between"]
    return _couples(element, first, second, -(scalar(element["stiffness"]) * _twist(element, setting)), setting)


def _damper(element: Element, setting: Setting) -> tuple[Force, ...]:
    unit, _ = stretch(element, setting)
    first, second = element["between"]
    rate = unit.dot(setting.velocity(second) - setting.velocity(first))
    return _ends(element, setting, unit * (scalar(element["coefficient"]) * rate))


def _rotary_damper(element: Element, setting: Setting) -> tuple[Force, ...]:
    first, second = element["between"]
    spin = _spin(second, setting) - _spin(first, setting)
    return _couples(element, first, second, -(scalar(element["coefficient"]) * spin), setting)


def _spin(name: str, setting: Setting) -> Scalar:
    return setting.states[name].omega if name in setting.states else NOTHING


def _applied(element: Element, setting: Setting) -> Vector:
    vector = pair(element["force"])
    if element["frame"] == "space":
        return vector
    return rotated(vector.x, vector.y, setting.states[element["on"].body].pose.angle)


def _applied_force(element: Element, setting: Setting) -> tuple[Force, ...]:
    ref = element["on"]
    return (
        Force(element.name, ref.body, "agent", setting.where(ref), _applied(element, setting), law=element.kind, where=ref.label),
    )


def _applied_energy(element: Element, setting: Setting) -> Scalar | None:
    """-F·r for a force that is constant in space."""
    vector = _applied(element, setting)
    if element["frame"] != "space" or not all(map(setting.is_constant, (vector.x, vector.y))):
        return None
    return -vector.dot(setting.where(element["on"]))


def _applied_couple(element: Element, setting: Setting) -> tuple[Force, ...]:
    return _couples(element, element["reaction_on"] or "agent", element["on"], scalar(element["couple"]), setting)


def _couple_energy(element: Element, setting: Setting) -> Scalar | None:
    """-τ φ for a constant couple."""
    couple = scalar(element["couple"])
    if not setting.is_constant(couple):
        return None
    other = element["reaction_on"]
    return -(couple * (_angle(element["on"], setting) - (_angle(other, setting) if other else NOTHING)))


def resisted_by(element: Element, setting: Setting) -> Resisted:
    """What a resistance is against. Raises StatementError as `resisted`."""
    return resisted(element, setting.velocity, lambda name: _spin(name, setting), setting.sign)


def _resistance(element: Element, setting: Setting) -> tuple[Force, ...]:
    found, ref = resisted_by(element, setting), element["on"]
    where, vector = setting.where(ref), found.way * found.push
    unknowns = _unknown(element, found.push, setting)
    return (Force(element.name, ref.body, "medium", where, vector, unknowns=unknowns, law=element.kind, where=ref.label),)


def _resisting_couple(element: Element, setting: Setting) -> tuple[Force, ...]:
    push = resisted_by(element, setting).push
    pairs = _couples(element, *element["between"], push, setting)
    return tuple(replace(force, unknowns=_unknown(element, push, setting)) for force in pairs)


def _unknown(element: Element, push: Scalar, setting: Setting) -> tuple[str, ...]:
    """The unknown forces in a size. Raises StatementError where it is not linear in them."""
    found = tuple(sorted(names_in(push) & setting.unknowns))
    if any(names_in(derivative(push, name)) & setting.unknowns for name in found):
        raise StatementError(
            f"the size of “{element.name}” is not linear in the unknown forces {', '.join(found)}",
            instead="where the direction of the force is known, write its one component, or a multiple of a tension.",
            place=element.place,
        )
    return found


def _no_potential(element: Element, setting: Setting) -> None:
    return None


LAWS: Mapping[str, Law] = {
    "gravity": Law(_weights, _height_energy),
    "spring": Law(_spring, _spring_energy, _apart),
    "torsion-spring": Law(_torsion, lambda e, s: scalar(e["stiffness"]) * _twist(e, s) ** 2 * HALF),
    "pull": Law(_pull, _pull_energy, _apart),
    "damper": Law(_damper, _no_potential),
    "rotary-damper": Law(_rotary_damper, _no_potential),
    "force": Law(_applied_force, _applied_energy),
    "couple": Law(_applied_couple, _couple_energy),
    "resistance": Law(_resistance, _no_potential),
    "resisting-couple": Law(_resisting_couple, _no_potential),
}
