"""`rbpsym list`: what ships, grouped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

import click

from rbpsym.commands.arguments import Entry, shelf
from rbpsym.expr.letters import without_accents

LEVELS = ("introductory", "intermediate", "advanced")  # from easy to hard


@click.command("list")
@click.argument("words", metavar="[WORD]...", nargs=-1)
@click.option("--json", "as_json", is_flag=True, help="Print JSON, for programs.")
@click.option("--lang", metavar="LANGUAGE", default="en", show_default=True, help="Language of the titles.")
def command(words: tuple[str, ...], as_json: bool, lang: str) -> None:
    """List the problems, courses and worksheets that ship with rbpsym: all, or those that have every WORD.

    \b
    Examples:
      rbpsym list
      rbpsym list rolling introductory
      rbpsym list --lang es
      rbpsym list --json | jq -r '.problems[].name'

    A WORD may stand in the name, title, topic, level or source. Any name in the list can stand
    where a command wants NAME|FILE.
    """
    entries = [entry for entry in shelf() if all(is_about(entry, word, lang) for word in words)]
    if not entries:
        raise click.UsageError(f"nothing here is about {' and '.join(f'“{word}”' for word in words)}; try rbpsym list")
    click.echo(as_machine_text(entries, lang) if as_json else "\n".join(lines(entries, lang)))


def is_about(entry: Entry, word: str, language: str) -> bool:
    """Does the word stand in what is said of the entry? (Neither capitals nor accents matter.)"""
    said = (entry.name, entry.title(language), entry.topic(language), entry.level(language), entry.source)
    return without_accents(word.casefold()) in without_accents(" ".join(said).casefold())


def lines(entries: Iterable[Entry], language: str) -> Iterator[str]:
    """The list for people: courses and worksheets, then problems by topic."""
    entries = list(entries)
    width = max((len(entry.name) for entry in entries), default=0)
    for kind, group in groupby(entries, key=lambda entry: entry.kind):
        yield from section(f"{kind}s".capitalize(), list(group), width, language)
    yield "rbpsym derive NAME shows a derivation; rbpsym notes NAME writes lecture notes; rbpsym worksheet NAME makes a"
    yield "worksheet, of any problem too."


def section(title: str, entries: list[Entry], width: int, language: str) -> Iterator[str]:
    """The entries of one kind under their title: by topic, and from easy to hard."""
    yield click.style(title, bold=True)
    for topic, group in groupby(sorted(entries, key=place), key=lambda entry: entry.topic(language)):
        if topic:
            yield click.style(f"  {topic}", dim=True)
        for entry in group:
            level = entry.level(language)
            said = click.style(f"  ({level})", dim=True) if level else ""
            yield f"    {entry.name:<{width}}  {entry.title(language)}{said}"
    yield ""


def place(entry: Entry) -> tuple[str, int, str]:
    """Where an entry stands among those of its kind: topic, level (one that is not ours comes last), name."""
    level = entry.level()
    return entry.topic(), LEVELS.index(level) if level in LEVELS else len(LEVELS), entry.name


def as_machine_text(entries: Iterable[Entry], language: str) -> str:
    """The list for programs."""
    import json

    found: dict[str, list[dict[str, str]]] = {"courses": [], "worksheets": [], "problems": []}
    for entry in entries:
        said = {"title": entry.title(language), "topic": entry.topic(language), "level": entry.level(language)}
        found[f"{entry.kind}s"].append({"name": entry.name, **said, "source": entry.source, "file": str(entry.path)})
    return json.dumps(found, indent=2, ensure_ascii=False)
