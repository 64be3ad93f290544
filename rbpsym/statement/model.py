"""The values that a problem statement consists of.

All expressions are display trees (`expr.tree`). Counter-clockwise is positive; x points
to the right, y upwards. A body frame has its origin at the shape's reference point and its
x' axis at the body's `angle`, counter-clockwise from +x.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from rbpsym.errors import Place, StatementError
from rbpsym.expr.tree import ZERO, Node
from rbpsym.frozen import Frozen, field, replace
from rbpsym.languages import worded
from rbpsym.quantities import TIME, Dimension, Quantity
from rbpsym.showing import Shown

Pair = tuple[Node, Node]


class Coordinate(Frozen):
    """A generalized coordinate: its quantity, start value, start speed, range, and the acceleration that it keeps (or None)."""

    quantity: Quantity
    start: Node | None = None
    speed: Node | None = None
    lower: Node | None = None
    upper: Node | None = None
    place: Place | None = field(default=None, compare=False, repr=False)
    acceleration: Node | None = None

    @property
    def name(self) -> str:
        """Name of the coordinate; its speed is `<name>_dot`, its acceleration `<name>_ddot`."""
        return self.quantity.name


class PointRef(Frozen):
    """A point of a body (`body`, `point`), a point (`local`) in a body's frame, or a fixed one.

    For a fixed point `body` is None and `at` holds its place in space; `label` is how the
    author wrote it ("rod.end", "O").
    """

    label: str
    body: str | None = None
    point: str | None = None
    at: Pair | None = None


class Line(Frozen):
    """The straight line a x + b y = c, fixed in space (`label` as written)."""

    label: str
    a: Node
    b: Node
    c: Node


class Curve(Frozen):
    """The smooth fixed curve of the points (x, y), functions of `name`: of a coordinate, or of the `axis` "x" or "y"."""

    label: str
    x: Node
    y: Node
    name: str
    axis: str = ""


class Turn(Frozen):
    """A place on the path of a string: a point (radius 0), or a circle that it runs round.

    `sense` is 1 if it runs counter-clockwise round the circle, -1 if clockwise, 0 for a point.
    Where it `grips`, the string moves with the rim (or the point); else it slides freely.
    """

    center: PointRef
    radius: Node
    sense: int = 0
    grips: bool = True

    @property
    def body(self) -> str | None:
        """The body to which the place belongs; None if it is fixed."""
        return self.center.body


class Range(Frozen):
    """One variable of a mass element with its bounds (the inner ones may depend on outer ones)."""

    variable: str
    lower: Node
    upper: Node


class MassElement(Frozen):
    """How a shape's mass is spread: dm = density × measure × d(variables).

    `x`, `y` (body frame) and `measure` are trees in the variables; `distance_squared` is the
    square of the distance from the axis through the frame's origin perpendicular to the
    plane (x² + y², which for solids counts the two directions in the plane of motion only).
    `kind` is "line", "surface", "volume" or "point"; a removed part has `sign` -1. `outline`
    names the variables' usual reading for the notes ("s", "r phi", ...).
    """

    ranges: tuple[Range, ...]
    x: Node
    y: Node
    measure: Node
    density: Node
    kind: str = "surface"
    sign: int = 1


class Shape(Frozen):
    """A shape in its own frame: its mass elements, named points and outline for drawing.

    The elements of a composite are those of its parts, put into its frame (a part of kind
    "given" has none). `given_moment` (about the centre of mass) replaces the integral where the author gives it.
    `sizes` are the author's dimensions by key ("length", "radius", ...). `parts` of a composite
    are the placed shapes it consists of. `called` is the author's other word for the kind: a cylinder is a disk.
    """

    kind: str
    sizes: Mapping[str, Node]
    elements: tuple[MassElement, ...]
    points: Mapping[str, Pair]
    given_moment: Node | None = None
    parts: tuple[PlacedShape, ...] = ()
    called: str = field(default="", compare=False)


class PlacedShape(Frozen):
    """A part of a composite: a shape with its mass, origin and angle in the composite's frame.

    With a `count` it is there so many times, two or more, turned about `hub` by equal angles; its mass is that of one.
    """

    shape: Shape
    mass: Node | None
    at: Pair
    angle: Node
    removed: bool = False
    name: str = ""
    count: Node | None = None
    hub: Pair = (ZERO, ZERO)


class Body(Frozen):
    """A rigid body; `placed` = (name of a point, its position in space), None if constraints say.

    `mass` is the total mass, None if it is the integral of the author's own density (for the
    mechanics to carry out); `angle` None means that a weld determines it (or that the body is
    a particle, which has none).
    """

    name: str
    shape: Shape
    mass: Node | None
    placed: tuple[str, Pair] | None = None
    angle: Node | None = None
    meaning: str = ""
    place: Place | None = field(default=None, compare=False, repr=False)

    @property
    def points(self) -> Mapping[str, Pair]:
        """Named points in the body frame (the shape's and the author's own)."""
        return self.shape.points


class Element(Frozen):
    """An interaction or a constraint: `kind` is a key of its registry, `values` its fields.

    Values by field kind: "expression" Node; "pair" (Node, Node); "point" PointRef; "points"
    (PointRef, PointRef); "line" Line; "body" name; "bodies" tuple of names; "two bodies"
    two names, one may be "ground"; "path" a tuple of Turn; "choice"/"name" str; what was left out, None. Defaults are
    filled in. `place` is where it stands in the file.
    """

    name: str
    kind: str
    values: Mapping[str, Any]  # of many kinds: formulas, names, numbers, as the entry of the table of kinds has them
    place: Place | None = field(default=None, compare=False, repr=False)

    def with_values(self, **values: object) -> Element:
        """The element with some of its values changed."""
        return replace(self, values={**self.values, **values})

    @property
    def nodes(self) -> Iterator[Node]:
        """The formulas in its values: sizes, components, what a line is made of."""
        for value in self.values.values():
            parts = (value.a, value.b, value.c) if isinstance(value, Line) else value if isinstance(value, tuple) else (value,)
            yield from (part for part in parts if isinstance(part, Node))

    @property
    def normals(self) -> tuple[str, ...]:
        """The normal forces on whose sum its static friction rests: its own, and that of the contact beside it."""
        beside = self.values.get("beside")
        return (self.name,) if beside is None else (self.name, beside)

    def error(self, what: str, instead: str) -> StatementError:
        """What is wrong with it, at its place: “pivot “P” holds nothing”."""
        return StatementError(f"{self.kind} “{self.name}” {what}", instead=instead, place=self.place)

    def __getitem__(self, key: str) -> Any:
        return self.values[key]


class Phase(Frozen):
    """A part of the motion after the first: what begins it, what strikes then, the problem that then holds.

    `event` is a key of `elements.events.EVENTS`, `subject` the constraint or impulse that it is about, or the coordinate
    that reaches `value` ("" of what asks for none); `impulses` are elements of the kinds of `phases.IMPULSES`. The starts in
    `problem` are those of the first phase.
    """

    name: str
    event: str
    subject: str
    impulses: tuple[Element, ...]
    problem: Problem
    value: Node | None = None

    @property
    def gap(self) -> Element | None:
        """What begins where the phase begins, if something closes there: a contact, a string that has a length."""
        named = (e for e in (*self.impulses, *self.problem.constraints) if e.name == self.subject)
        closes = (e for e in named if e.values.get("length") is not None or "line" in e.values)
        return next(closes, None) if self.event == "begins" else None


class Problem(Shown):
    """A whole statement. `notation` maps names to the glyph names that print them.

    `points` are the author's fixed points with O, `origins` those about which momenta are
    wanted. `meanings` and `names` hold translations, by language and name; `example` values with units,
    by parameter; `claims` what a source says, as data; `questions` what is asked, with its words by
    language. `implicit` names the constants that no
    one declared: a coordinate starts at them, `unstated` the masses that no one stated, `led` where coordinates
    are at each time that then are given, or taken to be `kept`. `text` is the source that it was read from, if it was.
    """

    name: str
    title: Mapping[str, str]
    parameters: tuple[Quantity, ...]
    coordinates: tuple[Coordinate, ...]
    bodies: tuple[Body, ...]
    interactions: tuple[Element, ...] = ()
    constraints: tuple[Element, ...] = ()
    source: str = ""
    notation: Mapping[str, str] = field(default_factory=dict)
    origins: Mapping[str, PointRef] = field(default_factory=dict)
    claims: tuple[Mapping[str, object], ...] = ()
    questions: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    points: Mapping[str, Pair] = field(default_factory=dict)
    meanings: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    names: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    example: Mapping[str, str] = field(default_factory=dict)
    level: str = ""
    topic: str = ""
    implicit: tuple[str, ...] = ()
    unstated: tuple[str, ...] = ()
    led: Mapping[str, Node] = field(default_factory=dict)
    phases: tuple[Phase, ...] = ()
    file: str = field(default="", compare=False)
    text: str = field(default="", compare=False, repr=False)

    @property
    def elements(self) -> tuple[Element, ...]:
        """What acts on the bodies, then what holds them."""
        return (*self.interactions, *self.constraints)

    @property
    def kept(self) -> list[Coordinate]:
        """The coordinates of which no acceleration is stated, and the speed is taken to be kept."""
        return [c for c in self.coordinates if c.name in self.led and c.acceleration is None]

    @property
    def is_at_rest(self) -> bool:
        """Whether there are bodies and nothing else: what is asked is how their mass is spread."""
        return not (self.coordinates or self.elements)

    def of_kind(self, *kinds: str) -> list[Element]:
        """Constraints, then interactions, of these kinds."""
        return [element for element in (*self.constraints, *self.interactions) if element.kind in kinds]

    def body(self, name: str) -> Body:
        """The body called `name` (KeyError if there is none)."""
        return {body.name: body for body in self.bodies}[name]

    def coordinate(self, name: str) -> Coordinate:
        """The coordinate of that name."""
        return next(coordinate for coordinate in self.coordinates if coordinate.name == name)

    def names_in(self, language: str) -> Mapping[str, str]:
        """What names are called in a language where that differs: its [names], else meanings of bodies that are one word."""
        meant = self.meanings.get(language, {})
        own = {body.name: body.meaning for body in self.bodies}
        named = (*own, *(element.name for element in self.elements), *(phase.name for phase in self.phases))
        said = {name: worded(name, language) for name in named}
        for name, meaning in own.items():
            word = meant.get(name) or worded(meaning, language)
            said |= {name: word} if word.isalpha() and word != meaning else {}
        said = {name: word for name, word in said.items() if word != name}
        words = {name: word for name, word in said.items() if [*said.values()].count(word) == 1}
        return words | dict(self.names.get(language, {}))

    @property
    def body_names(self) -> tuple[str, ...]:
        """Names of the bodies in the author's order."""
        return tuple(body.name for body in self.bodies)

    @property
    def dimensions(self) -> dict[str, Dimension]:
        """The dimension of every constant, and of every coordinate with its rates."""
        found = {quantity.name: quantity.dimension for quantity in self.parameters}
        for coordinate in self.coordinates:
            for order, tail in enumerate(("", "_dot", "_ddot")):
                found[f"{coordinate.name}{tail}"] = coordinate.quantity.dimension / TIME**order
        return found
