"""τ ∂φ/∂q."""

from rbpsym.field import Scalar, derivative
from rbpsym.field.evaluate import scalar
from rbpsym.oracles.lagrange import Motion
from rbpsym.statement.model import Element


def work(element: Element, motion: Motion, name: str) -> Scalar:
    """φ is the angle against the body that exerts it."""
    turn = motion.angle(element["on"]) - motion.angle(element["reaction_on"])
    return motion.own(scalar(element["couple"])) * derivative(turn, name)
