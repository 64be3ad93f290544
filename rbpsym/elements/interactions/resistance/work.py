"""−size(v) ∂s/∂q: the force is against the path s of the point through the medium."""

from rbpsym.field import root, substitute, tidy
from rbpsym.mechanics.friction import resistances
from rbpsym.mechanics.geometry import pair
from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar, scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """Along one direction in its sense, else with v = √(V·V)."""
    place = motion.where(element["on"])
    relative = (motion.velocity(place) - pair(element["medium"])).settled()
    if len(relative.parts) == 1:
        speed = next(iter(relative.parts.values())) * (resistances(motion.system)[element.name].sense or 1)
    else:
        speed = root(tidy(relative.dot(relative)))
    return -(motion.own(substitute(scalar(element["size"]), {"v": speed})) * relative.dot(place.derivative(name)) / speed)
