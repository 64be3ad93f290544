"""F·∂r/∂q."""

from rbpsym.field import NOTHING
from rbpsym.mechanics.geometry import pair
from rbpsym.mechanics.system import rotated
from rbpsym.oracles.lagrange import Element, FreeMotion, Scalar


def work(element: Element, motion: FreeMotion, name: str) -> Scalar:
    """F may turn with the body."""
    ref, vector = element["on"], pair(element["force"])
    x, y = motion.own(vector.x), motion.own(vector.y)
    turned = rotated(x, y, motion.angle(ref.body) if element["frame"] == "body" else NOTHING)
    return turned.dot(motion.where(ref).derivative(name))
