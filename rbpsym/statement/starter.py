"""A commented problem file to start from (`rbpsym new`), its lists of kinds from the registries."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from decimal import Decimal, InvalidOperation

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, Field, ShapeKind
from rbpsym.elements.shapes import SHAPES
from rbpsym.errors import StatementError
from rbpsym.expr import tree as t
from rbpsym.expr.tree import Node
from rbpsym.quantities import DIMENSIONS, Dimension, Quantity
from rbpsym.statement.model import Coordinate, Problem, Shape
from rbpsym.statement.premises import OPS
from rbpsym.statement.references import fault_of_name
from rbpsym.statement.slots import ALL
from rbpsym.statement.source import SourceTable, unit_example
from rbpsym.statement.units import unit_named

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


MOST = 30  # no number is as large as 10^30 or as small as 10^-30 in SI units
NEAR = 1e-9  # how exactly an end of a range is told in degrees


def check_example(problem: Problem, section: SourceTable) -> None:
    """Refuse a number that contradicts what is declared."""
    dimensions = problem.dimensions
    numbers = {name: _number(name, dimensions[name], section) for name in section.names()}
    for quantity in problem.parameters:
        if quantity.name in numbers and not _has_sign(numbers[quantity.name], quantity.sign):
            raise _contradiction(section, quantity.name, f"declared to be {quantity.sign}")
    _check_ranges(problem, numbers, section)
    for what, node, sign in needed_signs(problem):
        value = number_at(node, numbers)
        if value is not None and not _has_sign(value, sign):
            raise section.error(
                f"with these numbers {what} is {value:.3g}, but must be {sign}",
                "change one of the numbers it is made of.",
            )


def _number(name: str, dimension: Dimension, section: SourceTable) -> float:
    """The number in SI units; a plain number is in SI units."""
    text = str(section.data[name]).strip()
    first, _, unit = text.partition(" ")
    try:
        value, found = Decimal(first), unit_named(unit) if unit else (dimension, 1.0)
    except InvalidOperation:
        value, found = Decimal("nan"), None
    if found is None or found[0] != dimension or not value.is_finite():
        raise section.error(f"“{text}” is no {dimension}", unit_example(dimension), name)
    if value and not -MOST < value.adjusted() < MOST:
        raise section.error(f"“{text}” is no size of a thing", f"write a number between 1e-{MOST} and 1e{MOST}.", name)
    return float(value) * found[1]


SIGNS: Mapping[str, Callable[[float], bool]] = {">": lambda value: value > 0, ">=": lambda value: value >= 0, "!=": bool}


def _has_sign(value: float, sign: str) -> bool:
    return SIGNS[OPS[sign]](value) if sign in OPS else True


def _check_ranges(problem: Problem, numbers: Mapping[str, float], section: SourceTable) -> None:
    """Parameters within their bounds, coordinates and their starts within the range."""
    ranged: tuple[Quantity | Coordinate, ...] = (*problem.parameters, *problem.coordinates)
    bounds = [(q.name, q.lower, q.upper) for q in ranged]
    bounds += [(c.start.name, c.lower, c.upper) for c in problem.coordinates if isinstance(c.start, t.Sym)]
    for name, lower, upper in bounds:
        if name in numbers:
            low, high = (number_at(bound, numbers) for bound in (lower, upper))
            slack = NEAR * max(1.0, abs(numbers[name]))
            if (low is not None and numbers[name] < low - slack) or (high is not None and numbers[name] > high + slack):
                raise _contradiction(section, name, "declared to lie in another range")


def _contradiction(section: SourceTable, name: str, why: str) -> StatementError:
    text = str(section.data[name])
    return section.value_error(name, f"“{name}” can't be {text}: it is {why}", "change the number or the declaration.")


def needed_signs(problem: Problem) -> Iterator[tuple[str, Node, str]]:
    """What a statement takes for granted: (what it is, expression, sign) of masses, sizes and coefficients."""
    for body in problem.bodies:
        if body.mass is not None:
            yield f"“mass” of the body “{body.name}”", body.mass, "nonnegative"
        yield from _sizes(body.shape, f"the body “{body.name}”")
    for element in problem.elements:
        for field in ALL[element.kind].fields:
            if field.sign and isinstance(element.values.get(field.name), Node):
                yield f"“{field.name}” of {element.kind} “{element.name}”", element[field.name], field.sign


def _sizes(shape: Shape, where: str) -> Iterator[tuple[str, Node, str]]:
    for field in SHAPES[shape.kind].fields:
        if field.sign and field.name in shape.sizes:
            yield f"“{field.name}” of {where}", shape.sizes[field.name], field.sign
    for part in shape.parts:
        yield from _sizes(part.shape, f"{part.name or 'a part'} of {where}")


def number_at(node: Node | None, numbers: Mapping[str, float]) -> float | None:
    """The value of an expression at some numbers; None where one is missing or it has none."""
    try:
        return None if node is None else _at(node, numbers)
    except (KeyError, ArithmeticError, ValueError):
        return None


def _at(node: Node, numbers: Mapping[str, float]) -> float:
    if isinstance(node, t.Sym):
        return math.pi if node.name == "pi" else numbers[node.name]
    if isinstance(node, t.Num):
        return float(node.value)
    name = node.name if isinstance(node, t.Fn) else type(node)
    return NUMBERS[name](*(_at(part, numbers) for part in t.children(node)))


NUMBERS: Mapping[object, Callable[..., float]] = {
    t.Neg: lambda a: -a,
    t.Group: lambda a: a,
    t.Add: lambda *terms: math.fsum(terms),
    t.Mul: lambda *factors: math.prod(factors),
    t.Div: lambda a, b: a / b,
    t.Pow: math.pow,
    t.Sqrt: math.sqrt,
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "asin", "acos", "atan", "exp")},
}
