"""What a statement of kinematics leaves unsaid: masses that no answer needs, and what drives a coordinate of given acceleration.

Both are put into the tables, so that all that reads a statement finds them as if its author had written them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import suppress
from itertools import permutations, product
from typing import Any

from rbpsym.decide.dimensions import Dimensions, require_dimension
from rbpsym.errors import DimensionError, RbpsymError, StatementError
from rbpsym.expr.infix import read_infix
from rbpsym.expr.tree import ONE, ZERO, Div, Fn, Node, Num, Pow, Sym, add, mul, names, renamed, walk
from rbpsym.frozen import replace
from rbpsym.quantities import LENGTH, NUMBER, TIME, Dimension
from rbpsym.statement.model import Body, Coordinate, Element, Pair, PointRef, Problem
from rbpsym.statement.scope import CLOCK
from rbpsym.statement.source import SourceTable

WEIGHTS, T = ("mass", "density"), Sym(CLOCK)


def with_masses(table: SourceTable) -> tuple[SourceTable, tuple[str, ...]]:
    """The table with a letter for each mass (and given moment of inertia) that is left out, the joints that its poses tell, and
    these letters: where nothing acts on bodies that are held or driven, the motion may be given."""
    moves = any(table.data.get(section) for section in ("coordinates", "constraints"))
    if table.data.get("interactions") or not moves or not isinstance(table.data.get("bodies"), Mapping):
        return table, ()
    letters: dict[str, str] = {}
    taken = words_of(table)
    bodies = {name: _weighed(name, body, letters, taken) for name, body in table.data["bodies"].items()}
    more: dict[str, Any] = {"bodies": bodies, "parameters": {**(table.data.get("parameters") or {}), **letters}}
    told = table.data.get("constraints") or {}
    if letters and isinstance(told, Mapping) and (joints := dict(_joints(table, bodies, taken))):
        more["constraints"] = {**joints, **told}
    return replace(table, data={**table.data, **more}), tuple(letters)


def _joints(table: SourceTable, bodies: Mapping[str, Any], taken: Set[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """The pivot of a body that turns about a fixed point, and the pin of one that turns about a point of another, where its pose
    says so and no constraint does."""
    fixed = {"O", *(table.data.get("points") or {})}
    for name, body in bodies.items():
        for key, at in body.items() if isinstance(body, Mapping) and "angle" in body else ():
            point, other = f"{name}.{key}", str(at).partition(".")[0]
            if not isinstance(at, str) or point in str(table.data.get("constraints")):
                continue
            if at in fixed:
                yield _unused(f"joint_{name}", taken), {"type": "pivot", "point": point}
            elif other in bodies and at != other:
                yield _unused(f"joint_{name}", taken), {"type": "pin", "points": [at, point]}


def words_of(table: SourceTable) -> Set[str]:
    """All words in a table, which no letter of ours may be."""
    return {*re.findall(r"\w+", str(table.data))}


def _unused(wanted: str, taken: Set[str]) -> str:
    return next(name for name in (wanted, *(f"{wanted}_{k}" for k in range(1, len(taken) + 2))) if name not in taken)


def _weighed(name: str, body: Any, letters: dict[str, str], taken: Set[str]) -> Any:
    """The table of a body with its mass; parts of a composite have one each, unless something is cut out."""
    if not isinstance(body, Mapping) or any(key in body for key in WEIGHTS):
        return body
    parts = body.get("parts")
    if isinstance(parts, list) and all(isinstance(part, Mapping) for part in parts):
        if any(key in part for part in parts for key in WEIGHTS):
            return body
        if not any(part.get("removed") for part in parts):
            return {**body, "parts": [_weighed(f"{name}_{k}", part, letters, taken) for k, part in enumerate(parts, 1)]}
    mass, moment = (_unused(f"{stem}_{name}", taken) for stem in "mI")
    letters[mass] = f"mass: mass of the {name}, which is not stated"
    own = {**body, "mass": mass}
    if body.get("shape") == "given" and "moment" not in body:
        letters[moment] = f"moment of inertia: moment of inertia of the {name}, which is not stated"
        own["moment"] = moment
    return own


def has_plain_speed(coordinate: Coordinate, problem: Problem) -> bool:
    """Whether it begins with a speed that may be kept: one that hangs on no place where the motion begins."""
    speed, places = coordinate.speed, {name for c in problem.coordinates if c.start is not None for name in names(c.start)}
    if speed in (None, ZERO) or coordinate.start is None or coordinate.acceleration is not None:
        return False
    return not places & {*names(speed)} and not any(isinstance(part, Fn) for part in walk(speed))


def course(coordinate: Coordinate) -> Node:
    """Where it is at each time, with the acceleration that is given (none: with its speed)."""
    gain = mul(coordinate.acceleration or ZERO, Div(Pow(T, Num(2)), Num(2)))
    parts = (coordinate.start, mul(coordinate.speed or ZERO, T), gain)
    return add(*(part for part in parts if part is not None and part != ZERO))


def courses(coordinates: Iterable[Coordinate]) -> dict[str, Node]:
    """Where the coordinates are of which an acceleration is given."""
    return {c.name: course(c) for c in coordinates if c.acceleration is not None}


def drives(coordinates: Iterable[Coordinate], bodies: Mapping[str, Body], taken: Set[str]) -> tuple[Element, ...]:
    """What leads the coordinates of which an acceleration is given; `taken` are words that its unknown may not be."""
    known = tuple(coordinates)
    led = [c for c in known if c.acceleration is not None]
    return tuple(_drive(c, bodies, {c.name for c in known}, _unused(f"D_{c.name}", taken)) for c in led)


def _drive(coordinate: Coordinate, bodies: Mapping[str, Body], moving: Set[str], letter: str) -> Element:
    """A given angle of a body, or a given place of one of its points, in space or against another body, that follows the
    coordinate alone. Raises StatementError where there is none."""
    name, then, place = coordinate.name, {coordinate.name: course(coordinate)}, coordinate.place
    for turned, against, angle in _angles(bodies):
        if {*names(angle)} & moving == {name}:
            values = {"body": turned, "angle": renamed(angle, then), "of": against}
            return Element(letter, "prescribed-angle", values, place)
    for point, other, pair in _places(bodies):
        along, moves = _way(pair, name), {*names(pair[0]), *names(pair[1])} & moving
        distance = add(*(mul(part, axis) for part, axis in zip(along, pair, strict=True)))
        if not {*names(along[0]), *names(along[1])} & moving and (moves == {name} or {*names(distance)} & moving == {name}):
            values = {"point": point, "distance": renamed(distance, then), "along": along, "of": other}
            return Element(letter, "prescribed", values, place)
    raise StatementError(
        f"no body has an angle, and no point a straight way, that tells “{name}” alone, so that it could be led as it is stated",
        instead='say what leads it under [constraints], type = "prescribed" or "prescribed-angle"; a light rod (mass = "0") '
        "with such an angle may lead a point along a circle.",
        place=place,
    )


def _way(place: Pair, name: str) -> Pair:
    """The unit vector along which a place goes as a coordinate changes, to the right or up where that is along an axis."""
    from rbpsym.field import derivative, root, tidy
    from rbpsym.field.evaluate import scalar
    from rbpsym.present.forms import present

    dx, dy = (derivative(scalar(part), name) for part in place)
    if not (dx and dy):
        return (ONE if dx else ZERO), (ONE if dy else ZERO)
    size = root(tidy(dx * dx + dy * dy))
    return present(dx / size), present(dy / size)


def _angles(bodies: Mapping[str, Body]) -> Iterator[tuple[str, str | None, Node]]:
    """By how much each body is turned: in space, then against each other one."""
    from rbpsym.field.evaluate import scalar
    from rbpsym.present.forms import present

    turned = [(body.name, body.angle) for body in bodies.values() if body.angle is not None]
    yield from ((name, None, angle) for name, angle in turned)
    pairs = permutations(turned, 2)
    yield from ((name, other, present(scalar(angle) - scalar(base))) for (other, base), (name, angle) in pairs)


def _places(bodies: Mapping[str, Body]) -> Iterator[tuple[PointRef, str | None, Pair]]:
    """Where the placed point of each body is: in space, then in the frame of each other one."""
    from rbpsym.field import cosine, sine
    from rbpsym.field.evaluate import scalar
    from rbpsym.field.normal import in_one_angle
    from rbpsym.present.forms import present

    placed = [(body, *body.placed, PointRef(f"{body.name}.{body.placed[0]}", body.name, body.placed[0]))
              for body in bodies.values() if body.placed]  # fmt: skip
    yield from ((ref, None, place) for _, _, place, ref in placed)
    for body, _, place, ref in placed:
        for other, its, origin, _ in placed:
            if other is not body and other.angle is not None:
                (dx, dy), turn = (scalar(a) - scalar(b) for a, b in zip(place, origin, strict=True)), scalar(other.angle)
                c, s, (x, y) = cosine(turn), sine(turn), map(scalar, other.points[its])
                yield ref, other.name, (present(in_one_angle(c * dx + s * dy + x)), present(in_one_angle(c * dy - s * dx + y)))


MOST = 6  # coordinates that say none
TIMES = {"start": NUMBER, "speed": TIME, "acceleration": TIME**2}  # by which a value of the coordinate is multiplied


def fitting(data: Mapping[str, Any], known: Dimensions, unsaid: list[str]) -> dict[str, Dimension]:
    """The first choice of angles and lengths in which places are lengths, angles are numbers, and starts fit; angles, if none."""
    angles = dict.fromkeys(unsaid, NUMBER)
    known = {"t": TIME, **known}
    stated = [*_stated(data, {**known, **angles})] if 0 < len(unsaid) <= MOST else []
    for choice in product((NUMBER, LENGTH), repeat=len(unsaid)) if stated else ():
        chosen = dict(zip(unsaid, choice, strict=True))
        if all(_fits(node, {**known, **chosen}, wanted, times) for node, wanted, times in stated):
            return chosen
    return angles


def _fits(node: Node, dimensions: Dimensions, wanted: Dimension | str, times: Dimension) -> bool:
    try:
        require_dimension(node, dimensions, dimensions[wanted] / times if isinstance(wanted, str) else wanted, "it")
    except DimensionError:
        return False
    return True


def _stated(data: Mapping[str, Any], known: Dimensions) -> Iterator[tuple[Node, Dimension | str, Dimension]]:
    """Formulas with the dimension that they must have: one of its own, or that of a coordinate over what it is taken times."""
    texts = [(text, LENGTH, NUMBER) for body in _tables(data, "bodies") for place in _fit(body) for text in place]
    texts += [(body.get("angle"), NUMBER, NUMBER) for body in _tables(data, "bodies")]
    for name, table in (data.get("coordinates") or {}).items():
        if isinstance(table, Mapping) and name in known:
            texts += [(table.get(key), name, times) for key, times in TIMES.items()]
            texts += [(text, name, NUMBER) for text in _listed(table.get("range"))]
    for text, wanted, times in texts:
        with suppress(RbpsymError):  # what can't be read is told where it is read
            if isinstance(text, str) and text:
                yield read_infix(text, known), wanted, times


def _tables(data: Mapping[str, Any], section: str) -> list[Mapping[str, Any]]:
    found = data.get(section)
    return [table for table in found.values() if isinstance(table, Mapping)] if isinstance(found, Mapping) else []


def _fit(body: Mapping[str, Any]) -> Iterator[list[Any]]:
    """All pairs of a body's table: its centre, or its start, or a point of it."""
    for value in body.values():
        if isinstance(value, Mapping):
            yield from _fit(value)
        elif len(pair := _listed(value)) == 2:
            yield pair


def _listed(value: Any) -> list[Any]:
    return list(value) if isinstance(value, (list, tuple)) else []
