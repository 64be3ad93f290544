"""The tension of each run of a string."""

from rbpsym.mechanics.constraints import Element, Geometry, Joint, Scalar
from rbpsym.mechanics.strings import gap, pulls, spans, speeds_along


def _gaps(element: Element, geometry: Geometry) -> tuple[tuple[Scalar, str], ...]:
    found = gap(element, geometry)
    return () if found is None else ((found, "length"),)


JOINT = Joint(pulls, gaps=_gaps, rates=speeds_along, taken=spans, is_one_sided=True)
