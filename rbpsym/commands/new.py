"""`rbpsym new`: a commented problem or course file to start from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

import click

from rbpsym.commands.arguments import ShelfName, output_option
from rbpsym.errors import ReadError, StatementError
from rbpsym.quantities import DIMENSIONS
from rbpsym.statement.constraints import CONSTRAINTS
from rbpsym.statement.interactions import INTERACTIONS
from rbpsym.statement.kinds import ElementKind, Field, ShapeKind
from rbpsym.statement.references import fault_of_name
from rbpsym.statement.shapes import SHAPES

# --- A commented problem file to start from (`rbpsym new`), its lists of kinds from the registries


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


# ---


@click.command("new")
@click.argument("name")
@click.option(
    "--template", metavar="PROBLEM", type=ShelfName(), help="Begin from a problem that ships; without: a pendulum."
)
@click.option("--course", "is_course", is_flag=True, help="A course: theory, problems and comparisons in their order.")
@output_option(".", "Folder of the new file.")
def command(name: str, template: str | None, is_course: bool, output: Path) -> None:
    """Write NAME.toml, a commented problem file to start from.

    The file is a complete problem that works at once; its comments list every shape,
    interaction and constraint. Change it, and look at what rbpsym makes of it. A file that is
    there already is never overwritten.

    \b
    Examples:
      rbpsym new my-problem
      rbpsym new my-ladder --template sliding-ladder -o problems
      rbpsym derive my-problem.toml
      rbpsym new week-5 --course
    """
    if is_course and template:
        raise click.UsageError("--template gives a problem to begin from; a course has none.")
    name = name.removesuffix(".toml")
    text = course_text(name) if is_course else problem_text(name, template)
    path = written(output / f"{name}.toml", text)
    click.echo(f"{path} is written. Now: rbpsym {'notes' if is_course else 'derive'} {path}")


def course_text(name: str) -> str:
    """The text of a new course file; what it names is taught in the first course that ships."""
    from rbpsym.document.files import data_folder
    from rbpsym.statement.course import load_course
    from rbpsym.statement.library import course_files
    parts = load_course(next(iter(course_files().values()))).parts
    first = {part.kind: part for part in reversed(parts)}
    text = (data_folder("templates") / "course.toml").read_text(encoding="utf-8")
    problem, pair = first["problem"], first["comparison"]
    return text.format(
        name=name, title=title_of(name), problem=problem.name, first=pair.first, second=pair.second, limit=pair.limit
    )


def problem_text(name: str, template: str | None) -> str:
    """The text of the new file, from the starter or from a problem that ships."""
    from rbpsym.commands.shelf import found
    text = starter_text(name)  # also refuses a name that can't be
    if template is None:
        return text
    _, path = found(template, ("problem",))
    return f"# {name}: begun from {path.stem}.\n" + path.read_text(encoding="utf-8")


def written(path: Path, text: str) -> Path:
    """Write a file that must not be there yet."""
    from rbpsym.document.files import write_whole

    if path.exists() or path.is_symlink():
        raise ReadError(f"{path} is there already", instead="choose another name, or remove the file first.")
    return write_whole(path, text)
