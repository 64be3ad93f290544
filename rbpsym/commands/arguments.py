"""Arguments and options that several commands share, each with completion in the shell."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click
from click.shell_completion import CompletionItem

Command = TypeVar("Command", bound=Callable[..., Any] | click.Command)
DETAILS = ("brief", "standard", "full")
FILE, FOLDER = click.Path(dir_okay=False, path_type=Path), click.Path(file_okay=False, path_type=Path)


class ShelfName(click.ParamType):  # type: ignore[type-arg]  # generic in late versions of click
    """The name of something that ships, or the path of a file; `kinds` are completed."""

    name = "name"

    def __init__(self, *kinds: str) -> None:
        self.kinds = kinds or ("course", "problem")

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """The names that begin so; files if there are none."""
        from rbpsym.commands.shelf import shelf

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
