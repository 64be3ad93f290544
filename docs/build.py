"""Writes the reference pages of docs/ from the code itself; `make docs` runs it, a test runs it too.

`*.intro.md` are written by hand; what follows them comes from the registries, from the files in
`examples/`, and from what rbpsym says when it is run.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from rbpsym import errors
from rbpsym.ask.question import CLAUSES
from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.events import STATED
from rbpsym.elements.impulses import IMPULSES
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, Field, ShapeKind
from rbpsym.errors import RbpsymError
from rbpsym.quantities import DIMENSIONS
from rbpsym.quantity.phrases import PHRASES
from rbpsym.statement import SHAPES, load_problem, load_text
from rbpsym.statement.phases import PHASE_KEYS

HERE = Path(__file__).parent
EXAMPLES = HERE / "examples"
REGISTRIES: Mapping[str, tuple[str, Mapping[str, ElementKind]]] = {
    "shapes": ("shape", SHAPES), "interactions": ("type", INTERACTIONS), "constraints": ("type", CONSTRAINTS),
}  # fmt: skip


def intro(name: str) -> str:
    """The part of a page that is written by hand."""
    return (HERE / f"{name}.intro.md").read_text(encoding="utf-8").rstrip()


# --- statement.md


def statement_page() -> str:
    """Every kind with its keys, its points or unknowns, and an example."""
    parts = [intro("statement")]
    for section, (key, kinds) in REGISTRIES.items():
        parts += [f"\n## {section.capitalize()}\n", f"Chosen by the key `{key}`.\n"]
        for kind in kinds.values():
            parts += kind_part(section, key, kind)
    parts += phases_part()
    parts += ["## Dimensions\n", ", ".join(f"`{name}`" for name in DIMENSIONS) + "."]
    return "\n".join(parts) + "\n"


def phases_part() -> Iterator[str]:
    """Phases with their keys, the events that begin them, the impulses."""
    yield "## Phases\n"
    yield intro("phases") + "\n"
    yield "| key | what it is |\n|---|---|"
    yield from (f"| `{key}` | {meaning} |" for key, meaning in PHASE_KEYS.items())
    yield "\n## Events\n\nChosen by the key `event` of a phase.\n"
    for name, kind in STATED.items():
        yield f"### `{name}`\n"
        yield kind.meaning[0].upper() + kind.meaning[1:] + ".\n"
        yield from excerpt(EXAMPLES / "events" / f"{name.replace(' ', '-')}.toml", "event", name)
    yield "\n## Impulses\n\nThey strike when a phase begins: `[phases.impulses.NAME]`, chosen by the key `type`.\n"
    for kind in IMPULSES.values():
        yield from kind_part("impulses", "type", kind)


def kind_part(section: str, key: str, kind: ElementKind) -> Iterator[str]:
    """One kind."""
    yield "### " + ", ".join(f"`{name}`" for name in (kind.name, *kind.aliases)) + "\n"
    yield kind.meaning[0].upper() + kind.meaning[1:] + ".\n"
    if kind.fields:
        yield "| key | what it is | dimension | if absent |\n|---|---|---|---|"
        yield from map(key_row, kind.fields)
        yield ""
    if isinstance(kind, ShapeKind):
        yield from shape_part(kind)
    if kind.unknowns:
        yield "Unknown: " + ", ".join(f"`{named(text)}` ({dimension})" for text, dimension in kind.unknowns) + ".\n"
    yield from example_part(section, key, kind)


def named(text: str) -> str:
    """A template over the name of an element, for people."""
    return text.replace("{name}", "NAME").replace("{", "").replace("}", "")


def key_row(field: Field) -> str:
    """One key of a kind."""
    choices = f" ({', '.join(field.choices)})" if field.choices else ""
    absent = {None: "must be given", "": "may be left out"}
    default = absent[field.default] if field.default in (None, "") else f"`{named(str(field.default))}`"
    dimension = "" if field.dimension is None else str(field.dimension)
    return f"| `{field.name}` | {field.meaning}{choices} | {dimension} | {default} |"


def shape_part(kind: ShapeKind) -> Iterator[str]:
    """Points with their places in the frame of the body, and the moment of inertia that is derived."""
    places = [f"`{name}` ({x}, {y})" for name, x, y in kind.points]
    yield "Points: " + ", ".join([*places, "`cm`"]) + ".\n"
    if kind.element and kind.name != "particle":
        yield f"Moment of inertia about `cm`, as derived for the example: {moment(kind.name)}.\n"


def moment(name: str) -> str:
    """The moment of inertia of the body of a shape's example."""
    from rbpsym.mechanics.study import Study
    from rbpsym.present.forms import present
    from rbpsym.typeset.text import to_text

    study = Study(load_problem(EXAMPLES / "shapes" / f"{name}.toml"))
    return to_text(present(study.system.bodies["body"].moment, study.style))


def example_part(section: str, key: str, kind: ElementKind) -> Iterator[str]:
    """The table of a kind in its example, and where the whole of it is."""
    yield from excerpt(EXAMPLES / section / f"{kind.name}.toml", key, kind.name)


def excerpt(path: Path, key: str, name: str) -> Iterator[str]:
    """The table of a file in which a key has a value, and where the whole of it is."""
    tables = re.split(r"\n\n(?=\[)", path.read_text(encoding="utf-8").rstrip())
    own = next(table for table in tables if re.search(rf'^{key} *= *"{re.escape(name)}"', table, re.M))
    yield f"```toml\n{own}\n```\n"
    yield f"All of it: [{path.relative_to(HERE)}]({path.relative_to(HERE)}).\n"


# --- errors.md

SPOILT: tuple[tuple[str, str, str], ...] = (
    ("A key that does not exist", 'length = "ell"', 'lenght = "ell"'),
    ("A name that nobody declared", 'length = "ell"', 'length = "2*el"'),
    ("A formula that does not end", '"ell*cos(phi)"', '"ell*cos(phi"'),
    ("A wrong dimension", 'length = "ell"', 'length = "M + ell"'),
    ("A length where an angle belongs", '"pi - phi"', '"pi - ell"'),
    ("A point that the shape does not have", '"rod.start"', '"rod.tip"'),
    ("A line that is none", '"x = 0"', '"x*y = 0"'),
    ("A constraint that contradicts the pose", '"x = 0"', '"x = ell"'),
    ("Two constraints that cannot be told apart", "[constraints.N_w]",
     '[constraints.N_s]\ntype  = "contact"\npoint = "rod.start"\nline  = "y = 0"\n\n[constraints.N_w]'),
    ("A start outside the range", 'start = "phi_0"', 'start = "2"'),
    ("No value in quotes", 'mass   = "M"', "mass   = M"),
)  # fmt: skip


def errors_page() -> str:
    """What a user meets when something is wrong, as it is really told."""
    text = (EXAMPLES / "constraints" / "contact.toml").read_text(encoding="utf-8")
    parts = [intro("errors"), "\n## Examples\n"]
    for title, old, new in SPOILT:
        if text.count(old) == 0:
            raise ValueError(f"errors.md: {old!r} does not stand in the example")
        parts += [f"**{title}**\n", f"```text\n{sentence(text.replace(old, new, 1))}\n```\n"]
    parts += [
        "## Classes\n",
        "In Python, each is an `rbpsym.RbpsymError` with `what`, `instead` and `place`.\n",
        "| class | what it means | exit code |",
        "|---|---|---|",
        *class_rows(),
    ]
    return "\n".join(parts) + "\n"


def sentence(text: str) -> str:
    """What rbpsym says of a text."""
    from rbpsym.mechanics.study import Study

    try:
        Study(load_text(text, "leaning-rod.toml")).dynamics  # noqa: B018  # worked out when asked for
    except RbpsymError as error:
        return str(error)
    raise ValueError(f"errors.md: nothing is wrong with\n{text}")


def class_rows() -> Iterator[str]:
    """The classes of errors by their docstrings."""
    for name, found in vars(errors).items():
        if isinstance(found, type) and issubclass(found, RbpsymError) and found is not RbpsymError:
            yield f"| `{name}` | {found.__doc__} | {found.exit_code} |"


# --- solve.md


def solve_page() -> str:
    """The JSON of `rbpsym solve`, with a real answer."""
    import json

    from rbpsym.solve import solve

    answer = solve(load_problem(EXAMPLES / "constraints" / "contact.toml"), simulation=False)
    return f"{intro('solve')}\n\n```json\n{json.dumps(answer, indent=2, ensure_ascii=False)}\n```\n"


# --- cli.md, api.md


def commands_page() -> str:
    """Each command as its --help tells it."""
    import click

    from rbpsym.cli import COMMANDS, main

    parts = ["# The command line\n", "Every command tells the same with `--help`.\n"]
    group = click.Context(main, info_name="rbpsym", **main.context_settings)
    for name in COMMANDS:
        command = main.get_command(group, name)
        context = click.Context(command, info_name=name, parent=group, terminal_width=100)
        parts += [f"## `rbpsym {name}`\n", f"```text\n{command.get_help(context)}\n```\n"]
    return "\n".join(parts)


def api_page() -> str:
    """The public names with their signatures and docstrings; those that make parts of a problem by what they make."""
    import rbpsym
    from rbpsym.statement import build as makers

    parts = ["# The public names\n", "All of them are names of the package `rbpsym`.\n", "## Functions and classes\n"]
    parts += [api_part(name, getattr(rbpsym, name)) for name in rbpsym.__all__ if name != "__version__"]
    parts += ["## Parts of a problem\n", "A function for each kind; the keys are those of [the statement](statement.md).\n"]
    parts += [api_part(name, getattr(makers, name)) for name in makers.__all__]
    return "\n".join(parts)


def api_part(name: str, found: Callable) -> str:
    """One public name: its signature, what its docstring says, its members."""
    signature = f"class rbpsym.{name}" if isinstance(found, type) else f"rbpsym.{name}{shape(found)}"
    code = re.sub(r"((?:^>>> .*\n?(?:^(?!>>> |$).*\n?)*)+)", r"```python\n\1\n```\n", inspect.getdoc(found) or "", flags=re.M)
    text = f"### `{name}`\n\n```text\n{signature}\n```\n\n{code}\n"
    return text + "".join(["\n", *map(api_member, members(found))]) if isinstance(found, type) else text


def shape(function: Callable) -> str:
    """The parameters of a function with their types, as one would write them."""
    found = inspect.signature(function)
    parts = [re.sub(r": '([^']*)'", r": \1", re.sub(r"<function .*>", "...", str(each))) for each in found.parameters.values()]
    named = [each.kind is each.KEYWORD_ONLY for each in found.parameters.values()]
    if any(named):
        parts.insert(named.index(True), "*")
    inside = ", ".join(parts) if sum(map(len, parts)) < 70 else "\n    " + ",\n    ".join(parts) + ",\n"
    result = "" if found.return_annotation is found.empty else f" -> {found.return_annotation}"
    return f"({inside}){result}"


def members(found: type) -> Iterator[tuple[str, object]]:
    """The public methods and properties of a class that say what they are, from the package alone."""
    for name in dir(found):
        member = inspect.getattr_static(found, name)
        function = getattr(member, "fget", None) or getattr(member, "func", None) or getattr(member, "__func__", member)
        if not name.startswith("_") and inspect.isfunction(function) and function.__module__.startswith("rbpsym."):
            yield name, function


def api_member(entry: tuple[str, Callable]) -> str:
    """One line for a member of a class."""
    name, function = entry
    return f"- `.{name}`: {' '.join((inspect.getdoc(function) or '').split(chr(10) * 2)[0].split())}\n"


# --- ask.md


def ask_page() -> str:
    """The quantities and the ways to say when, by their examples."""
    parts = [intro("ask"), "\n## Quantities\n"]
    parts += ["BODY, FORCE, COORDINATE, PHASE, CONTACT and VALUE stand for names and values of the problem.\n"]
    parts += ["| write | what it is |", "|---|---|"]
    for _, find, example in PHRASES:
        parts += [f"| `{example}` | {told(find)} |"] if example else []
    parts += ["\n## When and where\n", "| write | such as |", "|---|---|"]
    parts += [f"| {WHENS[kind]} | `{example}` |" for kind, _, example in CLAUSES]
    return "\n".join(parts) + "\n"


WHENS = {
    "of": "as a function of something", "start": "the start", "begins": "the beginning of a phase, after its blows",
    "before": "the end of the phase before, before the blows", "end": "the end of a phase", "over": "what is done in a phase",
    "until": "up to a phase", "vanishes": "where a force vanishes", "rests": "where the motion turns round",
    "grips": "where a contact stops slipping", "slips": "where static friction gives way", "reaches": "a place, or a time t",
    "rest": "at rest in the stable equilibrium", "unstable": "at rest in the unstable one",
}  # fmt: skip


def told(find: Callable[..., object]) -> str:
    """The first sentence of what finds a quantity; nothing where its name says all."""
    text = " ".join((inspect.getdoc(find) or "").split())
    return re.split(r"(?<=[.;]) ", text)[0].rstrip(".;") if text and "<lambda>" not in find.__qualname__ else ""


PAGES: Mapping[str, Callable[[], str]] = {
    "statement.md": statement_page, "errors.md": errors_page, "solve.md": solve_page, "cli.md": commands_page,
    "api.md": api_page, "ask.md": ask_page,
}  # fmt: skip

if __name__ == "__main__":
    for name, page in PAGES.items():
        (HERE / name).write_text(page(), encoding="utf-8")
        print(f"docs/{name}")
