"""Arguments and options that several commands share, each with completion in the shell."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.shell_completion import CompletionItem

from rbpsym.errors import ReadError
from rbpsym.frozen import Frozen, replace
from rbpsym.languages import title_in
from rbpsym.statement.library import course_files, not_found, problem_files, worksheet_files

if TYPE_CHECKING:
    from rbpsym.statement.model import Problem


Command = TypeVar("Command", bound=Callable[..., Any] | click.Command)
DETAILS = ("brief", "standard", "full")


class NamedPath(click.Path):
    """A path; “-”, which elsewhere means the standard output, is none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """As click reads it."""
        if str(value) == "-":
            self.fail("“-” is no name: what is written are files. One of that name is “./-”.", param, ctx)
        return super().convert(value, param, ctx)


FILE, FOLDER = NamedPath(dir_okay=False, path_type=Path), NamedPath(file_okay=False, path_type=Path)


class ShelfName(click.ParamType):  # type: ignore[type-arg]  # generic in late versions of click
    """The name of something that ships, or the path of a file; `kinds` are completed."""

    name = "name"

    def __init__(self, *kinds: str) -> None:
        self.kinds = kinds or ("course", "problem")

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """The names that begin so; files if there are none."""
        near = [e for e in shelf() if e.kind in self.kinds and e.name.startswith(incomplete)]
        return [CompletionItem(entry.name, help=entry.title()) for entry in near] or [
            CompletionItem(incomplete, type="file")
        ]


class Listed(click.ParamType):  # type: ignore[type-arg]
    """A list of choices, separated by commas."""

    name = "list"

    def __init__(self, choices: tuple[str, ...]) -> None:
        self.choices = choices

    def convert(self, value: object, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        """The choices, each once, in the order given."""
        if isinstance(value, tuple):
            return value
        words = [word.strip() for word in str(value).split(",") if word.strip()]
        for word in words or [str(value)]:
            if word not in self.choices:
                self.fail(f"“{word}” is not one of {', '.join(self.choices)}.", param, ctx)
        return tuple(dict.fromkeys(words))

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """What may follow the last comma."""
        before, comma, word = incomplete.rpartition(",")
        return [CompletionItem(before + comma + choice) for choice in self.choices if choice.startswith(word)]


name_argument = click.argument("name", metavar="NAME|FILE", type=ShelfName())

detail_option = click.option(
    "--detail", type=click.Choice(DETAILS), default="standard", show_default=True, help="How many steps are shown."
)


def formats_option(choices: tuple[str, ...], default: str) -> Callable[[Command], Command]:
    """The option --format: some of the choices."""
    told = f"Formats, separated by commas: {', '.join(choices)}."
    return click.option("--format", "formats", type=Listed(choices), default=default, show_default=True, help=told)


def output_option(default: str, meaning: str) -> Callable[[Command], Command]:
    """The option -o, a folder that is made if it is not there."""
    return click.option("-o", "--output", metavar="FOLDER", type=FOLDER, default=default, show_default=True, help=meaning)


# --- what ships with rbpsym, by the heads of its files alone: nothing is assembled or derived


class Entry(Frozen):
    """A problem, a course or a worksheet: how it is called and where its file is."""

    kind: str
    name: str
    path: Path
    titles: Mapping[str, str]
    topics: Mapping[str, str]
    levels: Mapping[str, str]
    source: str = ""

    def title(self, language: str = "en") -> str:
        """Its title in a language, or in English if it has none in that."""
        return title_in(self.titles, language) or self.name

    def topic(self, language: str = "en") -> str:
        """What it teaches; empty if no one said."""
        return title_in(self.topics, language)

    def level(self, language: str = "en") -> str:
        """For whom it is; empty if no one said."""
        return title_in(self.levels, language)


def shelf() -> Iterator[Entry]:
    """All that ships: courses first, then worksheets and problems, each by name."""
    for kind, files in (("course", course_files()), ("worksheet", worksheet_files()), ("problem", problem_files())):
        for name, path in files.items():
            yield entry(kind, name, path)


def entry(kind: str, name: str, path: Path) -> Entry:
    """The entry of a file, from its head."""
    head = tomllib.loads(path.read_text(encoding="utf-8"))
    titles, topics, levels = (worded(head, key) for key in ("title", "topic", "level"))
    return Entry(kind, name, path, titles, topics, levels, str(head.get("source", "")))


def worded(head: Mapping[str, object], key: str) -> Mapping[str, str]:
    """A text by language; one that is not told apart is taken for English."""
    value = head.get(key, "")
    return value if isinstance(value, Mapping) else {"en": str(value)}


def found(name_or_file: str, kinds: tuple[str, ...] = ("course", "problem")) -> tuple[str, Path]:
    """The kind and the file of a name on the shelf, or of a path to a file of one's own."""
    shelves = {"course": course_files(), "problem": problem_files(), "worksheet": worksheet_files()}
    for kind in kinds:
        if name_or_file in shelves[kind]:
            return kind, shelves[kind][name_or_file]
    path = Path(name_or_file)
    if path.is_file():
        return kind_of_file(path, kinds), path
    raise missing(name_or_file, shelves, kinds)


def stated(path: Path, asked: tuple[str, ...] = ()) -> Problem:
    """The problem of a file; of one's own it is said which parameters nothing uses, also not what is `asked` beside it."""
    from rbpsym.statement.loader import load_problem
    from rbpsym.statement.references import unused

    problem = load_problem(path)
    whole = replace(problem, questions={**problem.questions, **{text: {} for text in asked}})
    for name in unused(whole) if path not in problem_files().values() else ():
        click.echo(f"{path}: the parameter “{name}” is used nowhere in the statement", err=True)
    return problem


def kind_of_file(path: Path, kinds: tuple[str, ...]) -> str:
    """What a file of one's own holds: a problem has bodies, a course has parts (also one that calls them otherwise)."""
    if "course" not in kinds:
        return kinds[-1]
    try:
        head = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, OSError):
        return kinds[-1]  # the loader of problems says what is wrong
    return "course" if "bodies" not in head and {"part", "parts", "problem", "problems"} & set(head) else kinds[-1]


def missing(name: str, shelves: Mapping[str, Mapping[str, Path]], kinds: tuple[str, ...]) -> ReadError:
    """The error for a name that nothing has."""
    known = [other for kind in kinds for other in shelves[kind]]
    other = next((kind for kind in shelves if kind not in kinds and name in shelves[kind]), None)
    if other:
        what, hint = f"“{name}” is a {other}, not a {kinds[0]}", OTHERS[other].format(name=name)
        return ReadError(what, instead=hint)
    return not_found(name, known, " or ".join(kinds))


# what to do with the name of another kind
OTHERS: Mapping[str, str] = {
    "course": "rbpsym notes {name} writes its notes.",
    "worksheet": "rbpsym worksheet {name} prints it.",
    "problem": "rbpsym derive {name} derives it.",
}
