"""The section [bodies]: shapes with their sizes and masses, points, poses, composites."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rbpsym.elements.kinds import ShapeKind
from rbpsym.elements.shapes import DENSITY_DIMENSIONS, SHAPES
from rbpsym.expr.tree import ONE, ZERO, Fn, Node, Num, add, mul, neg
from rbpsym.frozen import Frozen, replace
from rbpsym.quantities import LENGTH, MASS, NUMBER, Dimension
from rbpsym.statement.elements import kind_of_element
from rbpsym.statement.model import Body, Pair, PlacedShape, Shape
from rbpsym.statement.premises import LEFT_OPEN, contradicts
from rbpsym.statement.references import CM, check_name
from rbpsym.statement.scope import Scope, read_expression, read_pair
from rbpsym.statement.solids import Material, compose, shape_of, shares, size_of, total_mass, weight
from rbpsym.statement.source import SourceItem, SourceTable

_BODY_KEYS = ("shape", "mass", "angle", "points", "meaning")
_PART_KEYS = ("shape", "mass", "at", "angle", "removed", "name", "repeat")
VARIABLE_DIMENSIONS = {"s": LENGTH, "x": LENGTH, "y": LENGTH, "r": LENGTH, "phi": NUMBER}


def read_bodies(table: SourceTable, scope: Scope) -> dict[str, Body]:
    """The bodies by name; each may be placed by a point of one that stands before it."""
    found: dict[str, Body] = {}
    for name, part in table.tables("bodies", "bodies"):
        found[name] = read_body(part, name, scope, found)
    return found


def read_body(table: SourceTable, name: str, scope: Scope, before: Mapping[str, Body]) -> Body:
    """One body; it may be placed by a point of one `before` it."""
    check_name(name, table)
    where = f"the body “{name}”"
    kind = kind_of_element(table, SHAPES, "shape")
    own = _own_points(table, kind, scope, where)
    points = (*kind.point_names, *own, CM)
    table.check_keys([*_BODY_KEYS, *keys_of(kind), *points], where)
    shape, mass = _shape(table, kind, scope, where)
    shape = replace(shape, points={**shape.points, **own}, called=str(table.data["shape"]))
    angle = _angle(table, kind, scope, where)
    placed = _placed(table, points, scope, before, where)
    return Body(name, shape, mass, placed, angle, table.string("meaning"), table.source.key(table.path))


def keys_of(kind: ShapeKind) -> tuple[str, ...]:
    """The keys of a shape, beside those that all bodies have."""
    extra = ("density",) if kind.density else ()
    return (*(field.name for field in kind.fields), *extra)


# --- pose and points


def _own_points(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> dict[str, Pair]:
    section = table.table("points", f"points of {where}")
    taken = {*_BODY_KEYS, *keys_of(kind)}
    points = {}
    for name in section.names():
        check_name(name, section, key=name)
        if name in kind.point_names or name in taken:
            raise section.error(f"{where} has “{name}” already", "give the point another name.", name)
        points[name] = read_pair(section.item(name), replace(scope, points={}), f"point “{name}” of {where}")
    return points


def _angle(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> Node | None:
    if "angle" not in table:
        return None
    if not kind.has_angle:
        raise table.error(f"{where} is a {kind.name}: it has no angle", "remove this line.", "angle")
    return read_expression(table.item("angle"), scope, f"“angle” of {where}", NUMBER, "coordinates")


def _placed(
    table: SourceTable, points: tuple[str, ...], scope: Scope, before: Mapping[str, Body], where: str
) -> tuple[str, Pair] | None:
    given = [key for key in table.names() if key in points]
    if len(given) > 1:
        raise table.error(
            f"{where} is placed twice: by “{given[0]}” and by “{given[1]}”",
            "place one of its points; its angle and the constraints do the rest.",
            given[1],
        )
    if not given:
        return None
    what, item = f"“{given[0]}” of {where}", table.item(given[0])
    if isinstance(item.value, str) and "." in item.value:
        return given[0], _place_of(item, before, what)
    return given[0], read_pair(item, scope, what, LENGTH, "coordinates")


def _place_of(item: SourceItem, before: Mapping[str, Body], what: str) -> Pair:
    """Where a point of another body is, from the place and the angle of that body."""
    from rbpsym.field.evaluate import scalar
    from rbpsym.present.forms import present

    name, _, point = item.value.partition(".")
    told, (x, y) = (before[name].placed if name in before else None) or ("", (ZERO, ZERO))
    if told and point == told:
        return x, y
    body = before.get(name)
    if not told or body is None or body.angle is None or not {point, told} <= body.points.keys():
        raise item.error(
            f"{what}: “{item.value}” is no point of a body that is placed before it",
            "place the other body first, by a point and an angle; or write a pair of expressions.",
        )
    right, up = (add(here, neg(there)) for here, there in zip(body.points[point], body.points[told], strict=True))
    c, s = Fn("cos", body.angle), Fn("sin", body.angle)
    place = add(x, mul(c, right), neg(mul(s, up))), add(y, mul(s, right), mul(c, up))
    return present(scalar(place[0])), present(scalar(place[1]))


# --- shape and mass


def _shape(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> tuple[Shape, Node | None]:
    if kind.name == "composite":
        return _composite(table, scope, where)
    return _simple(table, kind, scope, where, _own_mass(table, kind, scope, where))


def _simple(table: SourceTable, kind: ShapeKind, scope: Scope, where: str, mass: Node | None) -> tuple[Shape, Node | None]:
    sizes = _sizes(table, kind, scope, where)
    _check_extent(size_of(kind, sizes) if kind.size else ONE, table, scope, where, mass)
    density = _density(table, kind, scope, where) if mass is None or ("density" in table and kind.density) else None
    try:
        return shape_of(kind, sizes, Material(mass, density, frozenset(scope.all))), mass
    except ZeroDivisionError:
        raise table.error(f"the density of {where} is zero in all", "write how it varies: 1 + s/ell.", "density") from None


def _check_extent(size: Node, table: SourceTable, scope: Scope, where: str, mass: Node | None = None) -> None:
    """A size of either sign does no harm to one shape of known mass: its moments hold squares of its sizes."""
    found = contradicts(size, "positive", scope.given)
    if found and (found != LEFT_OPEN or mass is None):
        bound = 'change one of its sizes, or bound it, as in "length > r: outer radius".'
        cure = "go round its corners counter-clockwise." if "vertices" in table else bound
        raise table.error(f"{where} has no extent: its size is {found}", cure, "shape")


def _sizes(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> dict[str, Node]:
    for field in kind.fields:
        if field.default is None:
            table.require(field.name, where, f"a {kind.name} needs {field.name}: its {field.meaning}.")
    found: dict[str, Node] = {}
    for field in kind.fields:
        if field.default == "" and field.name not in table:
            continue
        item, what = table.item(field.name, field.default), f"“{field.name}” of {where}"
        if field.kind == "vertices":
            found |= _vertices(item, scope, what)
        else:
            found[field.name] = read_expression(item, scope, what, field.dimension, sign=field.sign)
    return found


def _vertices(item: SourceItem, scope: Scope, what: str) -> dict[str, Node]:
    """Corners as sizes x_1, y_1, x_2, ..."""
    if not isinstance(item.value, (list, tuple)) or len(item.value) < 3:
        raise item.error(f"{what} must be three corners or more", 'write vertices = [["0", "0"], ["a", "0"], ["0", "b"]]')
    corners = [read_pair(part, replace(scope, points={}), what) for part in item.items()]
    return {f"{axis}_{k}": place for k, pair in enumerate(corners, 1) for axis, place in zip("xy", pair, strict=True)}


def _own_mass(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> Node | None:
    """The mass that the table states, also that of all of a density's proportions; None if it states a density instead."""
    if "density" in table and kind.density and "mass" not in table:
        return None
    table.require("mass", where, 'add mass = "M"' + (', or a density = "..."' if kind.density else ""))
    return _mass(table, scope, where)


def _mass(table: SourceTable, scope: Scope, where: str) -> Node:
    return read_expression(table.item("mass"), scope, f"“mass” of {where}", MASS, sign="nonnegative")


def _density(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> Node:
    inner = scope.with_variables({name: VARIABLE_DIMENSIONS[name] for name, _ in kind.density})
    dimension: Dimension | None = None if "mass" in table else DENSITY_DIMENSIONS[kind.element.kind if kind.element else ""]
    return read_expression(table.item("density"), inner, f"“density” of {where}", dimension, sign="nonnegative")


# --- composites


class _Part(Frozen):
    """A part of a composite, before the mass of the whole is shared out."""

    table: SourceTable
    kind: ShapeKind
    where: str
    removed: bool
    count: Node | None

    @property
    def has_mass(self) -> bool:
        return "mass" in self.table or "density" in self.table or self.kind.name == "composite"


def _composite(table: SourceTable, scope: Scope, where: str) -> tuple[Shape, Node | None]:
    parts = [_part(row, i, scope, where) for i, row in enumerate(table.rows("parts", f"“parts” of {where}"), 1)]
    if not parts:
        raise table.error(f"{where} is a composite without parts", 'add parts = [{ shape = "rod", ... }, ...]')
    if all(part.removed for part in parts):
        raise table.error(f"{where} has no part that is left", "not all parts can be removed.", "parts")
    masses = _masses(table, parts, scope, where)
    placed = tuple(_placed_part(part, mass, scope) for part, mass in zip(parts, masses, strict=True))
    mass = _mass(table, scope, where) if "mass" in table else total_mass(placed)
    if mass is not None and (found := contradicts(mass, "nonnegative", scope.given)):
        raise table.error(f"the mass of {where} is {found}", "bound what is cut out: it can't have more mass than the rest.")
    return compose(placed), mass


def _part(table: SourceTable, number: int, scope: Scope, where: str) -> _Part:
    kind = kind_of_element(table, SHAPES, "shape")
    part = table.string("name") or f"part {number}"
    label = f"{part} of {where}"
    table.check_keys([*_PART_KEYS, *keys_of(kind)], label)
    return _Part(table, kind, label, table.flag("removed"), _count(table, kind, scope, label))


def _count(table: SourceTable, kind: ShapeKind, scope: Scope, where: str) -> Node | None:
    """How often a part is there, turned by equal angles about the origin of the composite."""
    if "repeat" not in table:
        return None
    count = read_expression(table.item("repeat"), scope, f"“repeat” of {where}", NUMBER, sign="positive")
    if isinstance(count, Num) and count.value < 2:
        raise table.error(f"{where} is repeated less than twice", "leave “repeat” out.", "repeat")
    if kind.name == "composite":
        raise table.error(f"{where} is a composite, and is repeated", "repeat its parts instead.", "repeat")
    return count


def _masses(table: SourceTable, parts: list[_Part], scope: Scope, where: str) -> Sequence[Node | None]:
    """The mass of each part: its own, or its share of the mass of the whole."""
    own = [part for part in parts if part.has_mass]
    if not own:
        table.require("mass", where, 'add mass = "M" for the whole, or one for each part.')
        return _shared(table, parts, scope, where)
    bare = [part for part in parts if not part.has_mass]
    if bare:
        raise bare[0].table.error(
            f"{bare[0].where} has no mass, but another part has one", "give each part a mass, or the whole body one."
        )
    if "mass" in table:
        raise table.error(f"{where} and its parts both have a mass", "remove one of them.", "mass")
    return [_part_mass(part, scope) for part in parts]


def _part_mass(part: _Part, scope: Scope) -> Node | None:
    return None if part.kind.name == "composite" else _own_mass(part.table, part.kind, scope, part.where)


def _shared(table: SourceTable, parts: list[_Part], scope: Scope, where: str) -> Sequence[Node | None]:
    first = parts[0].kind.element
    for part in parts:
        if part.kind.element is None or first is None or part.kind.element.kind != first.kind:
            raise part.table.error(
                f"{where}: a {parts[0].kind.name} and a {part.kind.name} have no common density",
                "give each part a mass of its own.",
            )
    sizes = [(size_of(part.kind, _sizes(part.table, part.kind, scope, part.where)), weight(part.removed, part.count))
             for part in parts]  # fmt: skip
    _check_extent(add(*(mul(times, size) for size, times in sizes)), table, scope, where)
    return shares(_mass(table, scope, where), sizes)


def _placed_part(part: _Part, mass: Node | None, scope: Scope) -> PlacedShape:
    if part.kind.name == "composite":
        shape, mass = _composite(part.table, scope, part.where)
    else:
        shape, mass = _simple(part.table, part.kind, scope, part.where, mass)
    at = read_pair(part.table.item("at", ["0", "0"]), replace(scope, points={}), f"“at” of {part.where}")
    angle = read_expression(part.table.item("angle", "0"), scope, f"“angle” of {part.where}", NUMBER)
    return PlacedShape(shape, mass, at, angle, part.removed, part.table.string("name"), part.count)
