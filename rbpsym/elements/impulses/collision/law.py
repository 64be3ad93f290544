"""The unknown impulse along the direction on the second body, and its opposite on the first."""

from rbpsym.field import NOTHING, Scalar, symbol, total
from rbpsym.field.evaluate import scalar
from rbpsym.mechanics.friction import geometry_of
from rbpsym.mechanics.geometry import Geometry, pair
from rbpsym.mechanics.impulse import Element, Force, PointRef, Strike, System, at_points
from rbpsym.mechanics.phase_checks import CLOSE, ArrivalState, Study, numbers_then, value_then, wrong
from rbpsym.statement.paths import round_size


def _forces(element: Element, geometry: Geometry) -> tuple[Force, ...]:
    first, second = element["points"]
    push = pair(element["along"]) * symbol(element.name)
    return at_points(element, geometry, (first, -push), (second, push))


def _check(study: Study, element: Element, state: ArrivalState, after: System) -> None:
    """Two points that collide are in one place, and come nearer along a unit vector."""
    known, along = numbers_then(study, state), pair(element["along"])
    if abs(value_then(study, along.dot(along), known) - 1) > CLOSE:
        raise wrong(element, "goes along a direction that is no unit vector", 'write along = ["1", "0"].')
    geometry, refs = geometry_of(study.system), element["points"]
    places = [geometry.where(ref) for ref in refs]
    gap, reach = places[1] - places[0], total(_radius(study.system, ref) for ref in refs)
    if min(value_then(study, apart.dot(apart), known) for apart in (gap, gap - along * reach)) > CLOSE**2:
        raise wrong(element, "is between points that do not meet at that moment", "check the points, the start, or the event.")
    first, second = (geometry.velocity(ref.body, place) for ref, place in zip(refs, places, strict=True))
    if value_then(study, along.dot(second - first), known) > -CLOSE:
        raise wrong(
            element,
            "is between points that do not approach each other",
            "along points from the first to the second body: check it, the order of the points, and the speeds before.",
        )


def _radius(system: System, ref: PointRef) -> Scalar:
    """How far its rim is from the point that is named: its radius for the centre of a round body."""
    if ref.body is None or ref.point not in ("center", "cm"):
        return NOTHING
    size = round_size(system.problem.body(ref.body))
    return NOTHING if size is None else scalar(size)


STRIKE = Strike(_forces, _check)
