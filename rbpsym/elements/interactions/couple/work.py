"""τ ∂φ/∂q."""

from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar, derivative, scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """φ is the angle against the body that exerts it."""
    turn = motion.angle(element["on"]) - motion.angle(element["reaction_on"])
    return motion.own(scalar(element["couple"])) * derivative(turn, name)
