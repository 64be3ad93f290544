"""What must hold of a problem as a whole; what needs mechanics is checked there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.errors import StatementError
from rbpsym.expr.glyphs import MARKS
from rbpsym.expr.tree import Node, Num, names
from rbpsym.quantities import FORCE, Dimension
from rbpsym.statement.model import Body, Coordinate, Element, Problem
from rbpsym.statement.paths import tensions
from rbpsym.statement.premises import Declared, declared, surely_above
from rbpsym.statement.references import fault_of_name, twice
from rbpsym.statement.source import SourceTable, did_you_mean, in_radians
from rbpsym.statement.starter import check_example

MAX_BODIES = 64


def check_problem(problem: Problem, table: SourceTable) -> None:
    """Refuse a problem that can't be meant."""
    for check in _CHECKS:
        check(problem, table)


def check_unknowns(problem: Problem, table: SourceTable) -> None:
    """Refuse names of unknown forces that can't be; also for the problem of a later phase."""
    _unknowns_differ(problem, table)
    _unknown_names(problem)
    _beside(problem)


def unknowns_of(element: Element) -> dict[str, Dimension]:
    """Names and dimensions of the unknown forces and couples that a constraint brings in."""
    if element.kind == "string":
        return dict.fromkeys(tensions(element), FORCE)
    values = {**element.values, "name": element.name}
    return {text.format(**values): dimension for text, dimension in CONSTRAINTS[element.kind].unknowns}


def dimensions_with_unknowns(problem: Problem) -> dict[str, Dimension]:
    """The dimension of every name: constants, coordinates with their rates, unknown forces and couples."""
    unknowns = (unknowns_of(element) for element in problem.constraints)
    return problem.dimensions | {name: found for each in unknowns for name, found in each.items()}


def _something(problem: Problem, table: SourceTable) -> None:
    if not problem.bodies:
        raise table.error("the problem has no bodies", "add [bodies.rod] with its shape, mass and place.")
    if problem.interactions and not problem.coordinates and not problem.constraints:  # with these it is one of statics
        raise table.error("the problem has no coordinates", "add [coordinates.theta] and use theta in a pose.")
    if len(problem.bodies) > MAX_BODIES:
        raise table.error(f"the problem has {len(problem.bodies)} bodies, {MAX_BODIES} are allowed", key="bodies")


# Sections whose names must differ from each other, and what a name of each is.
_SYMBOLS = {"parameters": "a parameter", "coordinates": "a coordinate"}
_PLACES = {"points": "a point", "bodies": "a body"}
_THINGS = {"bodies": "a body", "interactions": "an interaction", "constraints": "a constraint"}  # may be called as a point is


def check_names_differ(table: SourceTable) -> None:
    """Refuse a name that two sections give: before anything is read, for it confuses the rest."""
    for sections in (_SYMBOLS, _PLACES, _THINGS):
        seen: dict[str, str] = {}
        for section, what in sections.items():
            part = table.table(section, section)
            for name in part.names():
                if name in seen:
                    raise twice(name, seen[name], what, part, name)
                seen[name] = what


def _unknowns_differ(problem: Problem, table: SourceTable) -> None:
    """An unknown force has a name that no other quantity has."""
    seen = {quantity.name: "a parameter" for quantity in problem.parameters}
    seen |= {coordinate.name: "a coordinate" for coordinate in problem.coordinates}
    for element in problem.constraints:
        for name in unknowns_of(element):
            what = f"an unknown of the {element.kind} “{element.name}”"
            if name in seen:
                raise twice(name, seen[name], what, table.table("constraints", "constraints"), element.name)
            seen[name] = what
        for field in CONSTRAINTS[element.kind].fields:
            own: str = element.values.get(field.name, "") if field.kind == "name" else ""
            if own in _elements(problem):
                raise twice(own, "an interaction or constraint", f"the {field.name} of “{element.name}”",
                            table.table("constraints", "constraints"), element.name)  # fmt: skip


def _unknown_names(problem: Problem) -> None:
    """A couple's name is the author's own; the others derive from a name that was checked."""
    for element in problem.constraints:
        for name in unknowns_of(element):
            what, instead = fault_of_name(name)
            if what:
                raise StatementError(what, instead=instead, place=element.place)


def _beside(problem: Problem) -> None:
    """What a contact has beside it is a smooth contact of the same body with the same surface."""
    known = {element.name: element for element in problem.constraints}
    surface = ("line", "of", "circle", "radius", "curve")
    for element in problem.constraints:
        name = element.values.get("beside")
        other = known.get(name or "")
        if name is None:
            continue
        if other is None:
            raise element.error(f"has “{name}” beside it, which does not exist", did_you_mean(name, known, "constraints"))
        is_other = other.kind != "contact" or other["coefficient"] is not None or other["point"].body != element["point"].body
        if is_other or any(element.values.get(key) != other.values.get(key) for key in surface):
            raise element.error(
                f"has “{name}” beside it, which is no smooth contact of the same body with the same surface",
                instead='that one is a type = "contact" without a coefficient, with the same line and another point.',
            )


def _ranges(problem: Problem, table: SourceTable) -> None:
    given = declared(problem.parameters)
    for coordinate in problem.coordinates:
        section = table.table("coordinates", "coordinates").table(coordinate.name, coordinate.name)
        _check_range(coordinate, section, given)
        if getattr(coordinate.start, "name", None) not in problem.implicit:  # a constant of its own lies in the range
            _check_start(coordinate, section, given)


def _check_range(coordinate: Coordinate, section: SourceTable, given: Declared) -> None:
    if surely_above(coordinate.lower, coordinate.upper, given, or_equal=True):
        raise section.value_error("range", f"the range of “{coordinate.name}” is empty", "write the smaller bound first.")


def _check_start(coordinate: Coordinate, section: SourceTable, given: Declared) -> None:
    below = surely_above(coordinate.lower, coordinate.start, given)
    above = surely_above(coordinate.start, coordinate.upper, given)
    if below or above:
        bounds = section.data["range"]
        raise section.value_error(
            "start",
            f"the start of “{coordinate.name}” is outside its range",
            f"it must lie between {bounds[0]} and {bounds[1]}." + _radians(coordinate),
        )


def _radians(coordinate: Coordinate) -> str:
    start = coordinate.start
    return in_radians(float(start.value), coordinate.quantity.dimension) if isinstance(start, Num) else ""


def _coordinates_used(problem: Problem, table: SourceTable) -> None:
    used = {name for node in _expressions(problem) for name in names(node)}
    for coordinate in problem.coordinates:
        if coordinate.name not in used:
            raise table.table("coordinates", "coordinates").error(
                f"no body's pose uses the coordinate “{coordinate.name}”",
                "use it in a place or an angle of a body, or remove it.",
                coordinate.name,
            )


def _expressions(problem: Problem) -> Iterator[Node]:
    """The expressions that tell the poses."""
    for body in problem.bodies:
        yield from _pose(body)


def _pose(body: Body) -> Iterator[Node]:
    if body.placed:
        yield from body.placed[1]
    if body.angle is not None:
        yield body.angle


def _known_names(problem: Problem, table: SourceTable) -> None:
    """[notation], [example] and [meanings] speak of names that exist."""
    quantities = _quantity_names(problem)
    own = [quantity.name for quantity in problem.parameters]
    starts = [coordinate.name for coordinate in problem.coordinates]
    _check_names(table.table("notation", "notation"), [*quantities, *MARKS])
    check_marks(table.table("notation", "notation"), problem.notation)
    _check_names(table.table("example", "example"), [*own, *starts, *_rates(problem, "_dot")])
    check_example(problem, table.table("example", "example"))
    meanings = table.table("meanings", "meanings")
    for language in meanings.names():
        _check_names(meanings.table(language, language), [*quantities, *problem.body_names, *_elements(problem)])


def _check_names(section: SourceTable, known: list[str]) -> None:
    for name in section.names():
        if name not in known:
            raise section.error(
                f"[{'.'.join(map(str, section.path))}] speaks of “{name}”, which does not exist",
                did_you_mean(name, known, "names"),
                name,
            )


def check_marks(section: SourceTable, notation: Mapping[str, str]) -> None:
    """How vectors and decimals are printed is one of the ways that exist."""
    for key, allowed in MARKS.items():
        if notation.get(key, allowed[0]) not in allowed:
            ways = " or ".join(f'"{way}"' for way in allowed)
            raise section.error(f"{key} cannot be “{notation[key]}”", f"write {key} = {ways}.", key)


def _quantity_names(problem: Problem) -> list[str]:
    own = [quantity.name for quantity in problem.parameters]
    coordinates = [coordinate.name for coordinate in problem.coordinates]
    unknowns = [name for element in problem.constraints for name in unknowns_of(element)]
    return [*own, *coordinates, *_rates(problem, "_dot"), *_rates(problem, "_ddot"), *unknowns]


def _rates(problem: Problem, suffix: str) -> list[str]:
    return [coordinate.name + suffix for coordinate in problem.coordinates]


def _elements(problem: Problem) -> list[str]:
    return [element.name for element in problem.elements]


def _same_contact(problem: Problem, table: SourceTable) -> None:
    """One point or body against one curve once."""
    seen: dict[tuple[str, ...], str] = {}
    for element in problem.constraints:
        key = _contact(element)
        if key in seen:
            raise element.error(f"says again what “{seen[key]}” says", "remove one of them.")
        if key:
            seen[key] = element.name


def _contact(element: Element) -> tuple[str, ...]:
    """What touches, and what it touches; () if the element is no contact."""
    values = element.values
    touching = values["body"] if "body" in values else getattr(values.get("point"), "label", "")
    line: Any = values.get("line")
    circle: Any = values.get("circle")
    if line is None and circle is None:
        return ()
    curve = f"circle {circle.label} {values.get('radius')}" if line is None else f"line {line.label}"
    return touching, curve, str(values.get("of"))


def _gravity_once(problem: Problem, table: SourceTable) -> None:
    """One field of gravity in one direction for each body."""
    seen: dict[tuple[object, str], str] = {}
    for element in (e for e in problem.interactions if e.kind == "gravity"):
        for body in element["bodies"] or problem.body_names:
            key = element["direction"], body
            if key in seen:
                what = f"acts on “{body}”, on which “{seen[key]}” acts already"
                raise element.error(what, "remove one of them, or say on which bodies each acts.")
            seen[key] = element.name


_CHECKS = (_something, check_unknowns, _ranges, _coordinates_used, _known_names, _same_contact, _gravity_once)
