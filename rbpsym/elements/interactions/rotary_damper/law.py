"""The couple c times the rate of the angle, against it."""

from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.interactions import Law, Setting, couples, spin
from rbpsym.mechanics.system import Force
from rbpsym.statement.model import Element


def _forces(element: Element, setting: Setting) -> tuple[Force, ...]:
    first, second = element["between"]
    rate = spin(second, setting) - spin(first, setting)
    return couples(element, first, second, -(scalar(element["coefficient"]) * rate), setting)


LAW = Law(_forces)
