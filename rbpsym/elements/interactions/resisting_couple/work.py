"""−size(ω) σ ∂φ/∂q with the angle φ between the bodies, and the sense σ of its rate."""

from rbpsym.field import substitute
from rbpsym.mechanics.friction import resistances
from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar, derivative, scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """φ is the angle of the second, seen from the first."""
    first, second = element["between"]
    twist, sense = motion.angle(second) - motion.angle(first), resistances(motion.system)[element.name].sense or 1
    size = substitute(scalar(element["size"]), {"omega": motion.rate(twist) * sense})
    return -(motion.own(size) * derivative(twist, name) * sense)
