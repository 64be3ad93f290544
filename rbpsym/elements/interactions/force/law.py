"""A force with given components; −F·r is its potential energy if it is constant in space."""

from rbpsym.field import Vector
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, Scalar
from rbpsym.mechanics.system import rotated


def _vector(element: Element, setting: LawSetting) -> Vector:
    vector = pair(element["force"])
    if element["frame"] == "space":
        return vector
    return rotated(vector.x, vector.y, setting.states[element["on"].body].pose.angle)


def _force(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    ref, vector = element["on"], _vector(element, setting)
    return (Force(element.name, ref.body, "agent", setting.where(ref), vector, law=element.kind, where=ref.label),)


def _energy(element: Element, setting: LawSetting) -> Scalar | None:
    vector = _vector(element, setting)
    if element["frame"] != "space" or not all(map(setting.is_constant, (vector.x, vector.y))):
        return None
    return -vector.dot(setting.where(element["on"]))


LAW = Law(_force, _energy)
