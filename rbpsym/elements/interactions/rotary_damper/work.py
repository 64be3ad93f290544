"""−c φ̇ ∂φ/∂q with the angle φ between the bodies."""

from rbpsym.field import Scalar, derivative
from rbpsym.field.evaluate import scalar
from rbpsym.oracles.lagrange import Motion
from rbpsym.statement.model import Element


def work(element: Element, motion: Motion, name: str) -> Scalar:
    """φ is the angle of the second, seen from the first."""
    first, second = element["between"]
    twist = motion.angle(second) - motion.angle(first)
    return -(scalar(element["coefficient"]) * motion.rate(twist) * derivative(twist, name))
