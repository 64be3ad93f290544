"""−F ∂d/∂q with the distance d."""

from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.interactions import Element, Scalar, scalar, stretch
from rbpsym.oracles.lagrange import FreeMotion, derivative


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """F may depend on the motion."""
    distance = stretch(element, setting_of(motion.system, motion.where))[1]
    return -(motion.own(scalar(element["size"])) * derivative(distance, name))
