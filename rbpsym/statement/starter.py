"""A commented problem file to start from (`rbpsym new`), its lists of kinds from the registries."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, Field, ShapeKind
from rbpsym.elements.shapes import SHAPES
from rbpsym.errors import StatementError
from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.references import fault_of_name

_TEXT = """\
# {name}: a uniform rod that swings about its upper end. Change it into your own problem.
#
# State what is true of the system, no result: rbpsym derives the equations and proves them.
# Expressions are in quotes; x points to the right, y upwards, counter-clockwise is positive.

title  = {{ en = "{title}" }}
source = "own"

[parameters]                       # name = "dimension: meaning"; positive unless said otherwise:
m   = "mass: mass of the rod"      # "mass, nonnegative: ...", also nonzero, real
ell = "length: length of the rod"
g   = "acceleration: acceleration of gravity"
{dimensions}

[coordinates.theta]                # its speed is theta_dot, its acceleration theta_ddot
meaning = "angle of the rod from the downward vertical"
start   = "theta_0"                # a name that is not declared is a new constant
speed   = "0"
range   = ["-pi", "pi"]

[bodies.rod]
shape  = "rod"
mass   = "m"
length = "ell"
start  = ["0", "0"]                # the place of one of its points (or “cm”), or left to the constraints
angle  = "theta - pi/2"            # of its axis, counter-clockwise from +x
{shapes}

[interactions.W]
type = "gravity"
{interactions}

[constraints.F]                    # its unknown force is F_x, F_y
type  = "pivot"
point = "rod.start"
{constraints}

[notation]                         # how names are printed
theta_dot  = "omega"
theta_ddot = "alpha"

[example]                          # values for numbers and plots
m       = "1 kg"
ell     = "1 m"
g       = "9.81 m/s^2"
theta_0 = "60 deg"
"""


def starter_text(name: str) -> str:
    """The text of a new problem file."""
    return _TEXT.format(
        name=name,
        title=title_of(name),
        dimensions=_wrapped("dimensions", DIMENSIONS),
        shapes="\n".join(_shape_lines(SHAPES)),
        interactions=_kind_lines("interactions", INTERACTIONS),
        constraints=_kind_lines("constraints", CONSTRAINTS),
    )


def title_of(name: str) -> str:
    """A title from the name of a file. Raises StatementError for a name that can't be one."""
    fault, instead = fault_of_name(name.replace("-", "_"))
    if fault:
        raise StatementError(fault, instead=instead)
    return name.replace("-", " ").capitalize()


def _wrapped(head: str, words: Iterable[str]) -> str:
    """A comment that lists words."""
    from textwrap import fill

    return fill(f"{head}: {', '.join(words)}", 98, initial_indent="# ", subsequent_indent="#   ")


def _shape_lines(kinds: Mapping[str, ShapeKind]) -> Iterable[str]:
    yield "# shapes (keys; points):"
    for kind in kinds.values():
        mass = "mass or density" if kind.density else "mass"
        text = _wrapped(f"  {kind.name}", [mass, *map(_key, kind.fields)])
        yield f"{text}; {', '.join(kind.point_names)}"


def _kind_lines(head: str, kinds: Mapping[str, ElementKind]) -> str:
    rows = [_wrapped(f"  {kind.name}", map(_key, kind.fields)) for kind in kinds.values()]
    return "\n".join([f"# {head} (keys):", *rows])


def _key(field: Field) -> str:
    return field.name if field.default is None else f"[{field.name}]"
