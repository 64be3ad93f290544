"""−c φ̇ ∂φ/∂q with the angle φ between the bodies."""

from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar, derivative, scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """φ is the angle of the second, seen from the first."""
    first, second = element["between"]
    twist = motion.angle(second) - motion.angle(first)
    return -(scalar(element["coefficient"]) * motion.rate(twist) * derivative(twist, name))
