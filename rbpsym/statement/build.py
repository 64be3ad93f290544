"""A problem from Python, without a file.

    from rbpsym.statement import build as rb

    ladder = rb.problem(
        "sliding-ladder",
        parameters={"M": "mass: mass of the ladder", "ell": "length: half its length", "g": "acceleration"},
        coordinates={"theta": rb.coordinate("angle with the floor", start="theta_0", range=("0", "pi/2"))},
        bodies={"ladder": rb.rod("2*ell", mass="M", center=("ell*cos(theta)", "ell*sin(theta)"), angle="pi - theta")},
        interactions={"W": rb.gravity()},
        constraints={"N_w": rb.contact("ladder.end", "x = 0"), "N_f": rb.contact("ladder.start", "y = 0")},
    )

There is a function for each kind of shape, interaction and constraint ("-" in its name is "_").
Each takes the fields of its kind in order or by name, and any other key that a file may have.
What they return are the tables that a file would hold: `problem` reads and checks them by the
same way as the loader.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from inspect import Parameter, Signature

from rbpsym.elements.constraints import CONSTRAINTS
from rbpsym.elements.interactions import INTERACTIONS
from rbpsym.elements.kinds import ElementKind, known_names
from rbpsym.elements.shapes import SHAPES
from rbpsym.errors import StatementError
from rbpsym.statement.loader import assemble
from rbpsym.statement.model import Problem
from rbpsym.statement.source import Source, SourceTable, check_characters, kind_of

Stated = dict[str, object]


def problem(name: str, **sections: object) -> Problem:
    """The problem called `name`; `sections` are those of a file (see `assemble.SECTIONS`)."""
    if not isinstance(name, str):
        raise StatementError(f"the name of a problem is a text, not {kind_of(name)}", instead='write problem("ladder", ...)')
    table = SourceTable(Source(name), (), {"name": name, **sections})
    check_characters(table)
    return assemble(table, name)


def parameter(dimension: str, meaning: str = "", sign: str = "positive", glyph: str = "") -> Stated:
    """A constant; the same as the text "dimension, sign: meaning"."""
    return {"dimension": dimension, "meaning": meaning, "sign": sign, "glyph": glyph}


def coordinate(meaning: str = "", **keys: object) -> Stated:
    """A coordinate; `keys` are start, speed, range, dimension, glyph."""
    return {"meaning": meaning, **keys}


def part(shape: Mapping[str, object], **keys: object) -> Stated:
    """A part of a composite: a shape with `at`, `angle`, `removed`, `name`."""
    return {**shape, **keys}


def _maker(kind: ElementKind, key: str, word: str) -> Callable[..., Stated]:
    """The function that states an element or a body of a kind."""
    fields = [field.name for field in kind.fields]

    def make(*values: object, **keys: object) -> Stated:
        if len(values) > len(fields):
            what = f"{word} takes {len(fields)} values, not {len(values)}"
            raise StatementError(what, instead=f"in order: {', '.join(fields) or 'none'}; the rest by name.")
        return {key: word, **dict(zip(fields, values, strict=False)), **keys}

    make.__name__ = make.__qualname__ = word.replace("-", "_")
    make.__doc__ = "\n".join(
        [f"{kind.meaning[0].upper()}{kind.meaning[1:]}.", "", *(f"{field.name}: {field.meaning}" for field in kind.fields)]
    )
    vars(make)["__signature__"] = _signature(kind)
    return make


def _signature(kind: ElementKind) -> Signature:
    own = [
        Parameter(
            field.name,
            Parameter.POSITIONAL_OR_KEYWORD,
            default=Parameter.empty if field.default is None else field.default,
        )
        for field in kind.fields
    ]
    return Signature([*own, Parameter("keys", Parameter.VAR_KEYWORD)])


def _makers(kinds: Mapping[str, ElementKind], key: str) -> dict[str, Callable[..., Stated]]:
    return {word.replace("-", "_"): _maker(kinds[name], key, word) for word, name in known_names(kinds).items()}


MAKERS: dict[str, Callable[..., Stated]] = {
    **_makers(SHAPES, "shape"),
    **_makers(INTERACTIONS, "type"),
    **_makers(CONSTRAINTS, "type"),
}
globals().update(MAKERS)

__all__ = ["coordinate", "parameter", "part", "problem", *MAKERS]
