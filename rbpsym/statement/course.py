"""Course files: theory, problems and comparisons in the order in which they are taught.

The grammar, with examples, is docs/courses.md.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from os import PathLike
from pathlib import Path

from rbpsym.errors import Place, ReadError, StatementError
from rbpsym.frozen import Frozen, field
from rbpsym.statement.checks import check_marks
from rbpsym.statement.library import course_files
from rbpsym.statement.loader import load_table
from rbpsym.statement.own_text import OwnParagraph, Sentence, own_paragraphs, strings, worded
from rbpsym.statement.source import SourceTable, kind_of

DETAILS = ("brief", "standard", "full")
COMPARED = ("oscillation", "acceleration", "speed")


class CoursePart(Frozen):
    """One part of a course.

    kind: "theory" (name: which one), "problem" (name or file), "comparison" (first and second
    problem, what of them is compared, the coordinate, and the parameter that goes to zero in the
    limit; "" for what is not said) or "remark" (its text alone). title: the heading, by language,
    empty for that of the theory or problem; text: paragraphs of the author's words before it, by
    language, discussion: those behind it; detail: "" for that of the whole; plots: whether its motion is drawn.
    """

    kind: str
    name: str = ""
    first: str = ""
    second: str = ""
    of: str = ""
    coordinate: str = ""
    limit: str = ""
    detail: str = ""
    plots: bool = True
    title: Mapping[str, str] = field(default_factory=dict, hash=False)
    text: Mapping[str, tuple[OwnParagraph, ...]] = field(default_factory=dict, hash=False)
    discussion: Mapping[str, tuple[OwnParagraph, ...]] = field(default_factory=dict, hash=False)
    places: Mapping[str, Place] = field(default_factory=dict, compare=False, repr=False)

    @property
    def sentences(self) -> Iterator[tuple[str, Sentence]]:
        """All that the author says in it, each with its language."""
        for told in (self.text, self.discussion):
            yield from ((language, one) for language, found in told.items() for part in found for one in part)

    def error(self, key: str, what: str, instead: str) -> StatementError:
        """An error about what the part says under a key."""
        return StatementError(what, instead=instead, place=self.places.get(key))


class Course(Frozen):
    """A course: titles by language, source, notation, and parts in order; `claims`: what its own texts are bound to."""

    name: str
    title: Mapping[str, str]
    parts: tuple[CoursePart, ...]
    subtitle: Mapping[str, str] = field(default_factory=dict)
    source: str = ""
    notation: Mapping[str, str] = field(default_factory=dict)
    file: str = ""
    claims: SourceTable | None = field(default=None, compare=False, repr=False)


PART_KEYS = {
    "theory": ("theory",),
    "problem": ("problem", "detail", "plots"),
    "comparison": ("comparison", "of", "coordinate", "limit", "plots"),
    "remark": (),
}
COMMON = ("title", "text", "discussion")
CLAIMS = ("settings", "claim")  # as in a claims file
KEYS = ("title", "subtitle", "source", "notation", "part", *CLAIMS)


def load_course(file: Path) -> Course:
    """A course from a TOML file, or the one of that name that ships. Raises an error with the place of what is wrong."""
    if not isinstance(file, (str, PathLike)):
        raise ReadError(f"the name of a course is a text or a path, not {kind_of(file)}", instead="name its file.")
    table = load_table(course_files().get(str(file), Path(file)))
    _check_shape(table)
    notation = strings(table, "notation")
    check_marks(table.table("notation", "notation"), notation)
    parts = tuple(_part(row) for row in table.rows("part", "part"))
    return Course(
        Path(file).stem,
        worded(table, "title", Path(file).stem),
        parts,
        worded(table, "subtitle") if "subtitle" in table else {},
        table.string("source"),
        notation,
        str(file),
        table,
    )


def _check_shape(table: SourceTable) -> None:
    table.check_keys(KEYS, "a course")
    if not table.data.get("part"):
        raise table.error("the course has no parts", 'add [[part]] and, below it, problem = "..."')


def _part(row: SourceTable) -> CoursePart:
    kind = _kind(row)
    row.check_keys((*PART_KEYS[kind], *COMMON), f"a {kind}")
    first, second = _pair(row) if kind == "comparison" else ("", "")
    return CoursePart(
        kind,
        row.string(kind) if kind in ("theory", "problem") else "",
        first,
        second,
        row.choice("of", COMPARED),
        row.string("coordinate"),
        row.string("limit"),
        row.choice("detail", DETAILS),
        row.flag("plots", True),
        worded(row, "title") if "title" in row else {},
        _paragraphs(row, "text"),
        _paragraphs(row, "discussion"),
        {key: row.source.value((*row.path, key)) for key in row.names()},
    )


def _kind(row: SourceTable) -> str:
    """What the part is, by the key that only one kind has."""
    named = [kind for kind in ("theory", "problem", "comparison") if kind in row]
    if len(named) > 1:
        raise row.error(f"a part is a {named[0]} or a {named[1]}, not both", "write two parts.", named[1])
    if named:
        return named[0]
    if "text" in row:
        return "remark"
    raise row.error(
        "a part of a course is a theory, a problem, a comparison or a text",
        'write problem = "...", theory = "...", comparison = ["...", "..."] or text = "...".',
    )


def _pair(row: SourceTable) -> tuple[str, str]:
    pair = row.data["comparison"]
    if not isinstance(pair, list) or len(pair) != 2 or not all(isinstance(name, str) for name in pair):
        raise row.value_error("comparison", "a comparison takes two problems", 'write comparison = ["first", "second"]')
    return pair[0], pair[1]


def _paragraphs(row: SourceTable, key: str) -> Mapping[str, tuple[OwnParagraph, ...]]:
    """The author's words, cut at empty lines."""
    place = row.source.value((*row.path, key)) if key in row else None
    return {language: own_paragraphs(text, place) for language, text in (worded(row, key) if key in row else {}).items()}
