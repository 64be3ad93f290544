"""The vocabulary of a statement: what a kind of shape, interaction, constraint, impulse or event is made of.

The loader, the Python functions, the error messages, the reference pages and `rbpsym new` read what a kind says here. What
else it has (its law, its virtual work, its row in the simulation) are modules of its folder, loaded when they are asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from itertools import starmap
from pkgutil import iter_modules
from typing import Any, TypeVar

from rbpsym.frozen import Frozen, replace
from rbpsym.quantities import DIMENSIONS, Dimension


class Field(Frozen):
    """One key of a kind.

    `kind` is "expression", "pair", "point", "points" (two), "line", "body", "bodies" (any
    number), "two bodies", "choice", "name" (of its own), "constraint" (the name of another one),
    "path" or (of a composite) "parts". `dimension` is that of the expression(s), None if free;
    `default` is what an absent key means, written as in the file (None: the key is required; "":
    absent, or left to the mechanics). `may_use` says of what the expression may be made:
    "parameters", "time" (and parameters), "coordinates" (and those), "speeds" (and all) or "forces" (and the unknown
    ones); `variables` are names that only it knows, with their dimensions. `sign`
    is "positive" or "nonnegative" where a value that is not known to be so is refused.
    """

    name: str
    kind: str
    meaning: str
    dimension: Dimension | None = None
    default: object = None
    choices: tuple[str, ...] = ()
    may_use: str = "parameters"
    sign: str = ""
    variables: tuple[tuple[str, Dimension], ...] = ()


class ElementKind(Frozen):
    """A kind of shape, interaction or constraint: name, meaning, keys, other names for it.

    `unknowns` are the forces and couples that a constraint brings in: templates over the
    element's `name` and its fields ("{name}_x", "{couple}") with their dimensions. `rules` refuse fields that contradict
    each other, or complete an element by what follows from the poses. `drawn` is the mark with which it stands in figures;
    `told` of an element and its problem is the tail of the phrase that tells it, "_rough" for `statement.contact_rough`;
    `holds` says as what its force holds: “joint”, “teeth”, “tension” or (of what pushes) “contact”.
    `folder` is the package that holds the rest of it.
    """

    name: str
    meaning: str
    fields: tuple[Field, ...] = ()
    aliases: tuple[str, ...] = ()
    unknowns: tuple[tuple[str, Dimension], ...] = ()
    rules: tuple[Callable[..., Any], ...] = ()
    drawn: str = ""
    holds: str = ""
    told: Callable[..., str] = lambda element, problem: ""
    folder: str = ""


class EventKind(Frozen):
    """A kind of event that ends a phase, with what its keys are: `of` names something ("" nothing: a "constraint", a
    "coordinate", what the phase brings), `at` gives a "value" or a "time".

    `fails` says that it does not come, `moment` and `place` are tails of the phrases that tell when and where it does;
    `shown` are the events of the explorer that end a phase so. What ends `gives_way` (it holds before), or it ends
    `by_friction` that slips. Questions may know more events than statements, of which it `is_stated`.
    """

    name: str
    meaning: str
    folder: str
    of: str = ""
    at: str = ""
    fails: str = ""
    moment: str = ""
    place: str = ""
    shown: tuple[str, ...] = ()
    gives_way: bool = False
    by_friction: bool = False
    is_stated: bool = True


def event(folder: str, meaning: str, **more: Any) -> EventKind:
    """The kind of event that a folder holds."""
    return EventKind(folder.rpartition(".")[2].replace("_", " "), meaning, folder, **more)


class ElementText(Frozen):
    """A mass element as infix text in the sizes of the shape (see `model.MassElement`)."""

    ranges: tuple[tuple[str, str, str], ...]
    x: str
    y: str
    measure: str = "1"
    kind: str = "surface"


class ShapeKind(ElementKind):
    """A shape as data: how its mass is spread, its size and its points, all as infix text.

    `size` is the total length, area or volume. `points` are places in the body frame.
    `density` maps each variable that the author's own density may use to its meaning in
    the variables of the element; empty if the shape takes a mass only.
    """

    element: ElementText | None = None
    size: str = ""
    points: tuple[tuple[str, str, str], ...] = ()
    density: tuple[tuple[str, str], ...] = ()
    has_angle: bool = True

    @property
    def point_names(self) -> tuple[str, ...]:
        """Names of the shape's points."""
        return tuple(name for name, _, _ in self.points)


K = TypeVar("K", bound=ElementKind)


def field(name: str, text: str) -> Field:
    """The field that a text describes: what it is, its sign, of what it may be made, its default: what it means.

    >>> field("radius", "length, positive, of time = r: its radius") == Field(
    ...     "radius", "expression", "its radius", DIMENSIONS["length"], "r", may_use="time", sign="positive")
    True
    """
    head, meaning = text.split(": ", 1)
    head, has_default, default = head.partition(" = ")
    what, *marks = head.split(", ")
    what, _, variable = what.partition(" in ")
    kind, _, of = ("expression", "", what) if what in DIMENSIONS else what.partition(" of ")
    told = {mark.partition(" ")[0]: mark.partition(" ")[2] for mark in marks}
    return Field(
        name,
        "choice" if kind == "one" else kind,
        meaning,
        DIMENSIONS.get(of),
        ("" if "optional" in told else None) if not has_default else default.split(" | ") if kind == "pair" else default,
        tuple(of.split(" | ")) if kind == "one" else (),
        told.get("of", "parameters"),
        next((sign for sign in SIGNS if sign in told), ""),
        tuple((own, DIMENSIONS[of_own.rstrip(")")]) for own, _, of_own in [variable.partition(" (")] if own),
    )


SIGNS = ("positive", "nonnegative")


def element(folder: str, meaning: str, *aliases: str, unknowns: Any = (), **more: Any) -> ElementKind:
    """The kind of interaction, constraint or impulse that a folder holds: `rules`, `drawn`, `holds` and `told` as they are, the
    dimensions of `unknowns` and all other keys, the fields, as texts."""
    own = {name: more.pop(name) for name in ("rules", "drawn", "holds", "told") if name in more}
    unknown = tuple((name, DIMENSIONS[dimension]) for name, dimension in dict(unknowns).items())
    name = folder.rpartition(".")[2].replace("_", "-")
    return ElementKind(name, meaning, tuple(starmap(field, more.items())), aliases, unknown, folder=folder, **own)


def shape(
    meaning: str,
    *aliases: str,
    points: str,
    spread: ElementText | None = None,
    size: str = "",
    density: Any = (),
    has_angle: Any = True,
    **fields: str,
) -> ShapeKind:
    """A kind of shape; `points` as a text: “center 0 0, end length/2 0”, `spread` its mass element."""
    places = tuple((name, x, y) for name, x, y in map(str.split, points.split(", ")))
    own = tuple(starmap(field, fields.items()))
    return ShapeKind("", meaning, own, aliases, element=spread, size=size, points=places, density=density, has_angle=has_angle)


def registry(**kinds: K) -> dict[str, K]:
    """The kinds by name, in order; "_" stands for the "-" of a name."""
    names = {name: name.replace("_", "-") for name in kinds}
    return {names[name]: replace(kind, name=names[name]) for name, kind in kinds.items()}


def in_folders(package: str, path: Iterable[str]) -> dict[str, Any]:
    """The kinds of a package by name: each folder in it holds one, its `KIND`."""
    found = [import_module(f"{package}.{folder.name}").KIND for folder in iter_modules(path) if folder.ispkg]
    return {kind.name: kind for kind in found}


T = TypeVar("T")


class KindParts(dict[str, T]):
    """What the folders of some kinds hold under one name of one module, by kind: loaded where it is asked for."""

    def __init__(self, kinds: Mapping[str, Any], module: str, name: str) -> None:
        super().__init__()
        self.told = kinds, module, name

    def __missing__(self, kind: str) -> T:
        kinds, module, name = self.told
        found: T = getattr(import_module(f"{kinds[kind].folder}.{module}"), name)
        return self.setdefault(kind, found)


def known_names(kinds: Mapping[str, K]) -> dict[str, str]:
    """Every name by which a kind may be called, with the kind's own name."""
    own = {name: name for name in kinds}
    return own | {alias: kind.name for kind in kinds.values() for alias in kind.aliases}
