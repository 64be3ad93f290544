"""The weight of each body at its centre of mass: m g downwards, with the potential energy m g h."""

from rbpsym.field import NOTHING
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.interactions import Element, Force, Law, LawSetting, Scalar, scalar


def _weights(element: Element, setting: LawSetting) -> tuple[Force, ...]:
    down, g, states = pair(element["direction"]), scalar(element["g"]), (setting.states[name] for name in element["bodies"])
    return tuple(
        Force(element.name, body.name, "earth", body.center, down * (body.mass * g), law=element.kind, where=f"{body.name}.cm")
        for body in states
        if body.mass  # what is light has no weight
    )


def _height_energy(element: Element, setting: LawSetting) -> Scalar:
    down, g = pair(element["direction"]), scalar(element["g"])
    states = [setting.states[name] for name in element["bodies"]]
    return sum((-(state.mass * g * down.dot(state.center)) for state in states), NOTHING)


LAW = Law(_weights, _height_energy)
