"""−c ḋ ∂d/∂q with the distance d."""

from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar, scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """With d = √(Δ·Δ)."""
    first, second = element["between"]
    apart = motion.where(second) - motion.where(first)
    rates = apart.dot(motion.velocity(apart)) * apart.dot(apart.derivative(name))
    return -(scalar(element["coefficient"]) * rates / apart.dot(apart))
