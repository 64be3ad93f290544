"""−F ∂d/∂q with the distance d."""

from rbpsym.field import Scalar, derivative
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.assemble import setting_of
from rbpsym.mechanics.interactions import stretch
from rbpsym.oracles.lagrange import Motion
from rbpsym.statement.model import Element


def work(element: Element, motion: Motion, name: str) -> Scalar:
    """F may depend on the motion."""
    distance = stretch(element, setting_of(motion.system, motion.where))[1]
    return -(motion.own(scalar(element["size"])) * derivative(distance, name))
